#include <catch.hpp>

#include "files.hpp"
#include "recording_text.hpp"

/// A bad recording is refused in one line: where, and what is wrong.
namespace swayaw {
namespace {

using test::refusal_of;

struct BadText {
  std::string text;
  std::string refusal;
};

void check_refusals(const std::vector<BadText>& bad_texts) {
  for (const auto& [text, refusal] : bad_texts) {
    INFO(text);
    CHECK(refusal_of(text) == refusal);
  }
}

const std::string header = "time_s,psi_rad,delta_rad\n";

TEST_CASE("a recording without header or samples is refused", "[core][refusal]") {
  check_refusals({
      {"", "run.csv:1:1: no header row"},
      {"\n \n", "run.csv:2:1: no header row"},
      {"# execute_s = 1\n# nothing else\n", "run.csv:2:1: no header row"},
      {"0,0.1,0.2\n1,0.1,0.2\n", "run.csv:1:1: no header row above the numbers; a line that starts with # is not one"},
      {"# time_s,psi_rad,delta_rad\n0,0.1,0.2\n",
       "run.csv:2:1: no header row above the numbers; a line that starts with # is not one"},
      {header, "run.csv:2:1: no samples below the header row"},
      {"# execute_s = 1\n" + header + "\n\n", "run.csv:3:1: no samples below the header row"},
  });
}

TEST_CASE("a header without time, heading or rudder is refused", "[core][refusal]") {
  const std::string rudders = "(delta_rad, delta_deg, delta_order_rad or delta_order_deg)";
  check_refusals({
      {"psi_rad,delta_rad\n0,0\n", "run.csv:1:1: no column time_s"},
      {"# x = 1\ntime_s,u_m_s,delta_rad\n0,0,0\n", "run.csv:2:1: no heading column (psi_rad or psi_deg)"},
      {"\n\ntime_s,psi_deg,u_m_s\n0,0,0\n", "run.csv:3:1: no rudder column " + rudders},
      {"Time_s,psi_rad,delta_rad\n0,0,0\n", "run.csv:1:1: no column time_s; is time_s meant by Time_s?"},
      {"time_s,PSI_DEG,delta_rad\n0,0,0\n",
       "run.csv:1:8: no heading column (psi_rad or psi_deg); is psi_deg meant by PSI_DEG?"},
      {"time_s,psi_rad,U_KN, Delta_deg\n0,0,0,0\n",
       "run.csv:1:22: no rudder column " + rudders + "; is delta_deg meant by Delta_deg?"},
      {"time_s;psi_rad;delta_rad\n0;0,1;0\n",
       "run.csv:1:1: no column time_s; is the file separated by semicolons? Commas are needed, and decimal points"},
      {"time_s\tpsi_rad\tdelta_rad\n0\t0\t0\n",
       "run.csv:1:1: no column time_s; is the file separated by tabs? Commas are needed"},
  });
}

TEST_CASE("a header that gives a quantity twice is refused", "[core][refusal]") {
  check_refusals({
      {"time_s,psi_rad,delta_rad,psi_rad\n0,0,0,0\n", "run.csv:1:26: column psi_rad appears twice"},
      {"time_s,psi_rad,delta_rad,a,\"a\"\n0,0,0,0,0\n", "run.csv:1:28: column a appears twice"},
      {"time_s,psi_rad, psi_deg,delta_rad\n0,0,0,0\n", "run.csv:1:17: psi_rad and psi_deg both give the same quantity"},
      {"time_s,psi_rad,delta_rad,rev_rpm,rev_s\n0,0,0,0,0\n",
       "run.csv:1:34: rev_rpm and rev_s both give the same quantity"},
      {"time_s,psi_rad,,delta_rad\n0,0,0,0\n", "run.csv:1:16: a column has no name"},
      {"time_s,psi_rad,delta_rad,\n0,0,0,\n", "run.csv:1:26: a column has no name"},
  });
}

TEST_CASE("half a position, or two, is refused", "[core][refusal]") {
  check_refusals({
      {"time_s,lat_deg,psi_rad,delta_rad\n0,0,0,0\n", "run.csv:1:1: lat_deg and lon_deg must come together"},
      {"time_s,lon_deg,psi_rad,delta_rad\n0,0,0,0\n", "run.csv:1:1: lat_deg and lon_deg must come together"},
      {"time_s,x_m,y_m,lat_deg,lon_deg,psi_rad,delta_rad\n0,0,0,0,0,0,0\n",
       "run.csv:1:1: x_m, y_m and lat_deg, lon_deg both give the position"},
      {"time_s,lat_deg,lon_deg,psi_rad,delta_rad\n0,0,0,0,0\n1, 91,0,0,0\n",
       "run.csv:3:4: lat_deg must lie between -90 and 90, got 91"},
      {"time_s,lat_deg,lon_deg,psi_rad,delta_rad\n0,0,999,0,0\n",
       "run.csv:2:5: lon_deg must lie between -360 and 360, got 999"},
  });
}

TEST_CASE("a cell that holds no number is refused", "[core][refusal]") {
  const std::string row = header + "0,0,0\n";
  check_refusals({
      {row + "1,0,abc\n", "run.csv:3:5: \"abc\" in column delta_rad is not a number"},
      {row + "1,  1.2.3,0\n", "run.csv:3:5: \"1.2.3\" in column psi_rad is not a number"},
      {row + "1s,0,0\n", "run.csv:3:1: \"1s\" in column time_s is not a number"},
      {row + "1,0,+-5\n", "run.csv:3:5: \"+-5\" in column delta_rad is not a number"},
      {row + "1,inf,0\n", "run.csv:3:3: \"inf\" in column psi_rad is not a number"},
      {row + "1,1e999,0\n", "run.csv:3:3: \"1e999\" in column psi_rad is not a number"},
      {row + "1,0x10,0\n", "run.csv:3:3: \"0x10\" in column psi_rad is not a number"},
      {row + "1,1 000,0\n", "run.csv:3:3: \"1 000\" in column psi_rad is not a number"},
      {row + "1,\"0,5\",0\n", "run.csv:3:4: \"0,5\" in column psi_rad is not a number; a decimal point is needed"},
      {header + "s,rad,rad\n0,0,0\n",
       "run.csv:2:1: \"s\" in column time_s is not a number; units belong in the column names, not in a row of their "
       "own"},
      {"time_s,psi_rad,delta_rad,thrust_kN\n0,0,0,0\n1,0,0,1e307\n",
       "run.csv:3:7: \"1e307\" in column thrust_kN is not a number"},
      {row + "1," + std::string(50, 'x') + "\t\x1b,0\n",
       "run.csv:3:3: \"" + std::string(40, 'x') + "...\" in column psi_rad is not a number"},
  });
}

TEST_CASE("places are counted in characters", "[core][refusal]") {
  check_refusals({
      {"Größe,time_s,psi_rad,delta_rad\nüber,0,?,0\n",
       "run.csv:2:8: \"?\" in column psi_rad is not a number; units belong in the column names, not in a row of their "
       "own"},
      {"\xEF\xBB\xBFtime_s,psi_rad,psi_rad\n", "run.csv:1:16: column psi_rad appears twice"},
  });
}

TEST_CASE("a row with too few or too many cells is refused", "[core][refusal]") {
  check_refusals({
      {header + "0,0,0\n1,0\n", "run.csv:3:3: 2 cells, but the header row has 3"},
      {header + "0\n", "run.csv:2:1: 1 cell, but the header row has 3"},
      {header + "0,0,0,0\n",
       "run.csv:2:7: 4 cells, but the header row has 3; are there decimal commas? Decimal points are needed"},
      {header + "0,0,0,\n",
       "run.csv:2:7: 4 cells, but the header row has 3; are there decimal commas? Decimal points are needed"},
      {header + "0;0;0\n",
       "run.csv:2:1: 1 cell, but the header row has 3; is the file separated by semicolons? Commas are needed, and "
       "decimal points"},
      {header + "0,0,0\n# end\n", "run.csv:3:1: 1 cell, but the header row has 3"},
  });
}

TEST_CASE("time that is missing or does not increase is refused", "[core][refusal]") {
  check_refusals({
      {header + "0,0,0\n0,0,0\n", "run.csv:3:1: time_s must increase, got 0 after 0"},
      {header + "0,0,0\n2,0,0\n1.5,0,0\n", "run.csv:4:1: time_s must increase, got 1.5 after 2"},
      {header + ",0,0\n", "run.csv:2:1: time_s is missing"},
      {header + "0,0,0\n nan,0,0\n", "run.csv:3:2: time_s is missing"},
      {"psi_rad,delta_rad,time_s\n0,0,0\n0,0,\n", "run.csv:3:5: time_s is missing"},
  });
}

TEST_CASE("a recording whose heading or rudder is always missing is refused", "[core][refusal]") {
  check_refusals({
      {header + "0,,0\n1,nan,0\n", "run.csv:1:8: every heading sample is missing"},
      {header + "0,0,\n1,0,\n", "run.csv:1:16: every rudder sample is missing"},
      {"# reference_x_m = 2\n" + header + "0,,0\n", "run.csv:2:8: every heading sample is missing"},
  });
}

TEST_CASE("a run key of the wrong type or value is refused", "[core][refusal]") {
  const std::string samples = "\n" + header + "0,0,0\n";
  check_refusals({
      {"# rudder_positive = \"left\"" + samples,
       "run.csv:1:21: rudder_positive must be \"port\" or \"starboard\", got \"left\""},
      {"# rudder_positive = 1" + samples, "run.csv:1:21: rudder_positive must be a text in quotes"},
      {"#reference_x_m = \"3\"" + samples, "run.csv:1:18: reference_x_m must be a number"},
      {"#reference_x_m = true" + samples, "run.csv:1:18: reference_x_m must be a number"},
      {"# execute_s = nan" + samples, "run.csv:1:15: execute_s must be a number"},
      {"# execute_s = 9223372036854775807" + samples, "run.csv:1:15: execute_s must be a number"},
      {"# order_recorded = \"yes\"" + samples, "run.csv:1:20: order_recorded must be true or false"},
      {"# group = 3" + samples, "run.csv:1:11: group must be a text in quotes"},
      {"# group = \"a\"\n# group = \"b\"" + samples, "run.csv:2:2: group appears twice"},
      {"# start_utc = \"in the morning\"" + samples,
       "run.csv:1:15: start_utc must be a date and a time, like \"2026-03-04T09:30:00Z\""},
      {"# start_utc = 3" + samples, "run.csv:1:15: start_utc must be a date and a time, like \"2026-03-04T09:30:00Z\""},
      {"# start_utc = \"2026-13-04T09:30:00Z\"" + samples,
       "run.csv:1:15: start_utc must be a date and a time, like \"2026-03-04T09:30:00Z\""},
      {"# ordered_rev_s = true" + samples, "run.csv:1:19: ordered_rev_s must be a number"},
      {"# order_recorded = true\ntime_s,psi_rad,delta_rad,delta_order_deg\n0,0,0,0\n",
       "run.csv:2:26: delta_rad and delta_order_deg both give the same quantity"},
      {"# water_depth_m = 0" + samples, "run.csv:1:19: water_depth_m must be positive, got 0"},
      {"# manoeuvre = 35" + samples, "run.csv:1:15: manoeuvre must be a text in quotes"},
      {"# execute_s = 1\n# execute_s = 2" + samples, "run.csv:2:2: execute_s appears twice"},
  });
}

TEST_CASE("a run key that is not TOML is refused where it breaks", "[core][refusal]") {
  const std::string samples = "\n" + header + "0,0,0\n";
  const std::pair<const char*, const char*> broken[] = {
      {"\n# manoeuvre = zigzag", "run.csv:2:15: "},
      {"# execute_s = 1 s", "run.csv:1:17: "},
      {"  # manoeuvre = \"turn", "run.csv:1:22: "},
  };
  for (const auto& [line, place] : broken) {
    INFO(line);
    const auto refusal = refusal_of(line + samples);
    CHECK(refusal.starts_with(place));
    CHECK_THAT(refusal, ContainsSubstring("rror"));
  }
}

TEST_CASE("a file that is not text is refused", "[core][refusal]") {
  const std::string utf16("\xFF\xFEt\0i\0m\0e\0_\0s\0", 14);
  CHECK(refusal_of(utf16) == "run.csv:1:4: a zero byte; a recording is plain text in UTF-8");
  CHECK(refusal_of(header + std::string("0,0\0,0\n", 7)) ==
        "run.csv:2:4: a zero byte; a recording is plain text in UTF-8");
  CHECK(refusal_of("\x7F"
                   "ELF\x02\x01\x01") == "run.csv:1:1: no column time_s");
}

std::string refusal_of_file(const std::filesystem::path& file) {
  try {
    read_recording(file);
    return {};
  } catch (const FileError& error) {
    return error.what();
  }
}

TEST_CASE("a file that is not there, or a folder, is refused", "[core][refusal]") {
  const test::Scratch scratch;
  const auto absent = scratch / "absent.csv", folder = scratch / "folder.csv";
  std::filesystem::create_directory(folder);
  CHECK(refusal_of_file(absent) == absent.string() + ":1:1: cannot be read (No such file or directory)");
  CHECK(refusal_of_file(folder) == folder.string() + ":1:1: is a folder, not a file");
  CHECK(refusal_of_file(absent / "below.csv") ==
        (absent / "below.csv").string() + ":1:1: cannot be read (No such file or directory)");
}

}  // namespace
}  // namespace swayaw
