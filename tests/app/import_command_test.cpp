#include <algorithm>
#include <catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "files.hpp"
#include "json.hpp"
#include "program.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/recording_csv.hpp"

/// `swayaw import` from the outside.
namespace swayaw {
namespace {

using test::run;
using test::Scratch;

const std::string table_of_log =
    "Messfahrt;;;\r\nUhrzeit;Kurs [°];Ruderlage [°], StB +;Fahrt ü. Grund [kn]\r\n"
    "10:00:00;359,5;0,0;12,1\r\n10:00:01;0,5;-10,0;12,0\r\n10:00:02;2,5;-10,5;11,9\r\n";

/// Files of a log and where the recording goes.
struct Desk {
  Scratch folder;
  std::string raw = (folder / "log.csv").string(), out = (folder / "run.csv").string(),
              map = (folder / "map.toml").string();

  explicit Desk(const std::string& text = table_of_log) { write_text(raw, text); }
};

TEST_CASE("import writes a recording and says what it took for what", "[app][import]") {
  const Desk desk;
  const auto outcome = run(desk.folder, "import " + desk.raw + " --out " + desk.out);
  INFO(outcome.err);
  CHECK(outcome.code == 0);
  CHECK_THAT(outcome.out, ContainsSubstring("Kurs [°] -> psi_deg: heading, steps of 0.1 deg, 3 samples\n"));
  CHECK_THAT(outcome.out, ContainsSubstring("Fahrt ü. Grund [kn] -> sog_kn: speed over ground"));
  CHECK_THAT(outcome.out, ContainsSubstring("positive to starboard"));
  const auto [recording, warnings] = read_recording(desk.out);
  CHECK(warnings.empty());
  CHECK(recording.time == std::vector<double>{0.0, 1.0, 2.0});
  CHECK(recording[Channel::delta].back() > 0.18);
}

TEST_CASE("import prints one JSON document", "[app][import]") {
  const Desk desk;
  const auto document = test::document("import " + desk.raw + " --out " + desk.out);
  CHECK(document["schema"] == "swayaw.import/1");
  REQUIRE(document["columns"].size() == 4);
  CHECK(document["columns"][1]["source"] == "Kurs [°]");
  CHECK(document["columns"][1]["taken_for"] == "psi_deg");
  CHECK(document["columns"][1]["samples"] == 3);
  CHECK(document["notes"].size() >= 3);
}

TEST_CASE("a bad log is refused in one line and nothing is written", "[app][import][refusal]") {
  const Desk desk("t [s],Heading [deg],Rudder\n0,350,0.5\n1,351,0.4\n");
  CHECK_THAT(test::refusal("import " + desk.raw + " --out " + desk.out),
             ContainsSubstring("log.csv:1:21: ") && ContainsSubstring("[columns] \"Rudder\" = \"delta_deg\""));
  CHECK_FALSE(std::filesystem::exists(desk.out));
  write_text(desk.map, "[columns]\nRudder = \"delta_deg\"\n");
  CHECK(run(desk.folder, "import " + desk.raw + " --out " + desk.out + " --columns " + desk.map).code == 0);
}

TEST_CASE("import overwrites none of what it reads", "[app][import][refusal]") {
  const Desk desk;
  CHECK_THAT(test::refusal("import " + desk.raw + " --out " + desk.raw), ContainsSubstring("would be overwritten"));
  CHECK(read_text(desk.raw) == table_of_log);
  write_text(desk.map, "missing = [-999]\n");
  CHECK_THAT(test::refusal("import " + desk.raw + " --out " + desk.map + " --columns " + desk.map),
             ContainsSubstring("would be overwritten"));
}

// ---------------------------------------------------------------- real recordings in another dialect

/// Names and units that a logger may write in place of a recording's columns.
const std::vector<std::pair<std::string, std::string>> other_names{{"time_s", "Zeit [s]"},
                                                                   {"x_m", "Northing [m]"},
                                                                   {"y_m", "Easting [m]"},
                                                                   {"psi_rad", "Steuerkurs [rad]"},
                                                                   {"u_m_s", "Surge [m/s]"},
                                                                   {"v_m_s", "Sway [m/s]"},
                                                                   {"ug_m_s", "Ug [m/s]"},
                                                                   {"vg_m_s", "Vg [m/s]"},
                                                                   {"r_rad_s", "Drehrate [rad/s]"},
                                                                   {"delta_rad", "Ruder [rad]"},
                                                                   {"delta_order_rad", "Ruder Soll [rad]"},
                                                                   {"rev_s", "Drehzahl [1/s]"},
                                                                   {"rev_rpm", "Drehzahl [1/min]"},
                                                                   {"phi_rad", "Krängung [rad]"},
                                                                   {"thrust_N", "Schub [N]"},
                                                                   {"torque_N_m", "Drehmoment [Nm]"},
                                                                   {"wind_speed_m_s", "TWS [m/s]"},
                                                                   {"wind_from_rad", "TWD [rad]"}};

/// The recording with other names, semicolons and decimal commas; run keys stay.
std::string in_other_dialect(const std::string& text) {
  std::string result;
  bool header = true;
  for (std::size_t begin = 0; begin < text.size();) {
    const auto end = std::min(text.find('\n', begin), text.size());
    auto line = text.substr(begin, end - begin);
    begin = end + 1;
    if (!line.starts_with('#')) {
      std::ranges::replace(line, ',', ';');
      if (!header) std::ranges::replace(line, '.', ',');
      for (const auto& [column, name] : other_names)
        if (const auto at = (';' + line + ';').find(';' + column + ';'); header && at != std::string::npos)
          line.replace(at, column.size(), name);
      header = false;
    }
    result += line + "\r\n";
  }
  return result;
}

double largest_difference(const Recording& a, const Recording& b) {
  double largest = 0.0;
  for (std::size_t c = 0; c < channel_count; ++c) {
    const auto &one = a.channels[c], &other = b.channels[c];
    INFO(column_name(static_cast<Channel>(c)));
    REQUIRE(one.size() == other.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
      REQUIRE(std::isnan(one[i]) == std::isnan(other[i]));
      if (!std::isnan(one[i])) largest = std::max(largest, std::abs(one[i] - other[i]));
    }
  }
  return largest;
}

TEST_CASE("real recordings come back from another dialect", "[app][import][round-trip]") {
  for (const char* folder : {"esso_osaka", "gunnerus", "kcs", "kvlcc2"}) {
    const auto recordings = test::benchmark_recordings(folder);
    if (!recordings) continue;
    for (const auto& entry : std::filesystem::directory_iterator(*recordings)) {
      if (entry.path().extension() != ".csv") continue;
      INFO(entry.path().string());
      const Desk desk(in_other_dialect(read_text(entry.path())));
      const auto outcome = run(desk.folder, "import " + desk.raw + " --out " + desk.out);
      INFO(outcome.out << outcome.err);
      REQUIRE(outcome.code == 0);
      const auto before = read_recording(entry.path()).recording;
      const auto [after, warnings] = read_recording(desk.out);
      CHECK(warnings.empty());
      REQUIRE(after.samples() == before.samples());
      CHECK(largest_difference(before, after) == 0.0);
    }
  }
}

}  // namespace
}  // namespace swayaw
