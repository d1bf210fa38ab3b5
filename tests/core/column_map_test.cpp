#include "import_truth.hpp"

/// The column map settles what a file leaves open; what it cannot mean is refused where it stands.
namespace swayaw {
namespace {

using test::import_refusal;

const std::string log_text = "t [s],Heading [deg],Rudder [deg]\n0,350,1\n1,351,2\n2,352,3\n";

/// What is wrong with a map, with its place, of a file that is right.
std::string map_refusal(const std::string& map) { return import_refusal({log_text}, map); }

TEST_CASE("every key of a column map must be of its kind", "[core][refusal]") {
  CHECK_THAT(map_refusal("columns = 3"), ContainsSubstring("map.toml:1:11: columns must be a table, [columns]"));
  CHECK_THAT(map_refusal("time = \"t\""), ContainsSubstring("time must be a table, [time]"));
  CHECK_THAT(map_refusal("run = 1"), ContainsSubstring("run must be a table, [run]"));
  CHECK_THAT(map_refusal("[columns]\n\"t [s]\" = 5"),
             ContainsSubstring("map.toml:2:11: t [s] must be a text in quotes"));
  CHECK_THAT(map_refusal("ignore = 7"), ContainsSubstring("map.toml:1:10: ignore must be a text in quotes"));
  CHECK_THAT(map_refusal("missing = [true]"), ContainsSubstring("missing must be a text in quotes"));
  CHECK_THAT(map_refusal("decimal = \"dot\""), ContainsSubstring("decimal must be one of"));
}

TEST_CASE("zone, origin and keys of the time in a column map are refused in words", "[core][refusal]") {
  CHECK_THAT(map_refusal("[time]\nzone = \"Europe/Oslo\""),
             ContainsSubstring("map.toml:2:8: a zone is \"Z\" or an offset such as \"+02:00\""));
  CHECK_THAT(map_refusal("time_zone = \"noon\""), ContainsSubstring("a zone is \"Z\" or an offset"));
  CHECK_THAT(map_refusal("[time]\norigin = \"yesterday\""),
             ContainsSubstring("map.toml:2:10: origin must be a date and time like \"2024-03-12T10:00:00Z\""));
  CHECK_THAT(map_refusal("[time]\norigin = \"12.03.2024\""), ContainsSubstring("origin must be a date and time"));
  CHECK_THAT(map_refusal("[time]\nfomat = \"seconds\""),
             ContainsSubstring("map.toml:2:1: fomat is not a key of [time]; those are column, format"));
  CHECK_THAT(map_refusal("[time]\ncolumn = [\"a\", \"b\", \"c\"]"),
             ContainsSubstring("column of [time] is one name, or those of date and time"));
  CHECK_THAT(map_refusal("[time]\ncolumn = \"clock\""),
             ContainsSubstring("there is no column \"clock\", which [time] of the column map names"));
}

TEST_CASE("keys of the run in a column map are those of recordings, one value each", "[core][refusal]") {
  CHECK_THAT(map_refusal("[run]\nrudder_positiv = \"port\""),
             ContainsSubstring("map.toml:2:1: rudder_positiv is not a run key; is rudder_positive meant?"));
  CHECK_THAT(map_refusal("[run.group]\nname = \"a\""), ContainsSubstring("a run key holds one value on one line"));
  CHECK(map_refusal("[run]\nrudder_positive = \"port\"").empty());
}

/// Heading of the first samples [deg].
std::vector<double> headings(const std::string& text, const std::string& map) {
  const auto run = test::recording_of(test::imported({text}, map)).recording;
  std::vector<double> result;
  for (const double psi : run[Channel::psi]) result.push_back(std::round(psi / test::deg * 1e6) / 1e6);
  return result;
}

TEST_CASE("the map tells which columns are the time: one, or date and clock", "[core][second-route]") {
  const std::string text =
      "Day,Clock,Spare [s],Heading [deg],Rudder [deg]\n"
      "2024-03-12,10:00:00,5,10,1\n2024-03-12,10:00:02,6,11,1\n2024-03-12,10:00:04,7,12,2\n";
  const auto times = [&](const std::string& map) {
    const auto run = test::recording_of(test::imported({text}, map)).recording;
    return std::vector<double>(run.time.begin(), run.time.end());
  };
  CHECK(times("ignore = [\"Day\", \"Clock\"]\n[time]\ncolumn = \"Spare [s]\"") == std::vector<double>{0.0, 1.0, 2.0});
  CHECK(times("ignore = \"Spare [s]\"\n[time]\ncolumn = [\"Day\", \"Clock\"]") == std::vector<double>{0.0, 2.0, 4.0});
}

TEST_CASE("words and numbers for what is missing are those of the map, one or a list", "[core][limit]") {
  const std::string text = "t [s],Heading [deg],Rudder [deg]\n0,10,1\n1,-99,1\n2,off,1\n3,13,1\n";
  CHECK_FALSE(import_refusal({text}, "").empty());
  CHECK_FALSE(import_refusal({text}, "missing = -99").empty());
  const auto psi = headings(text, "missing = [-99, \"off\"]");
  REQUIRE(psi.size() == 4);
  CHECK(psi[0] == 10.0);
  CHECK(std::isnan(psi[1]));
  CHECK(std::isnan(psi[2]));
  CHECK(psi[3] == 13.0);
}

// ---------------------------------------------------------------- points and commas

TEST_CASE("a mark that may be of thousands or of decimals is refused, and the map settles it", "[core][refusal]") {
  const auto table = [](const std::string& first, const std::string& second) {
    return "t [s];Heading [deg];Rudder [deg];Load [kN]\n0;10;1;" + first + "\n1;11;1;" + second + "\n2;12;2;" + second +
           "\n";
  };
  CHECK_THAT(import_refusal({table("1,25", "1.250")}, ""),
             ContainsSubstring("has a point and other cells of the column a decimal comma"));
  CHECK_THAT(import_refusal({table("1.250", "1,250")}, ""),
             ContainsSubstring("points and commas both stand before three digits, as in \"1,250\""));
  CHECK_THAT(import_refusal({table("1,250", "2,250")}, ""), ContainsSubstring("is \"1,250\" a thousand or a decimal?"));
  CHECK(import_refusal({table("1,250", "2,250")}, "decimal = \",\"").empty());
  CHECK(import_refusal({table("1,250", "2,250")}, "thousands = \",\"\ndecimal = \".\"").empty());
}

}  // namespace
}  // namespace swayaw
