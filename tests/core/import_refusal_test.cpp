#include "import_truth.hpp"

/// What cannot be read is refused in one line that names the place, and the line of the column map that settles it.
namespace swayaw {
namespace {

using Catch::Matchers::StartsWith;
using test::import_refusal;

struct RefusalCase {
  const char* text;
  const char* map;
  const char* place;
  const char* words;
};

const RefusalCase cases[] = {
    {"", "", "log.csv:1:1:", "empty"},
    {"just some words\nand more\n", "", "log.csv:1:1:", "no table"},
    {"PK\x03\x04rest", "", "log.csv:1:1:", "save the sheet as CSV"},
    {"0,1,2\n1,2,3\n", "", "log.csv:1:1:", "no row of column names"},
    {"t [s],Heading [deg],Rudder [deg]\n", "", "log.csv:1:1:", "no table"},
    {"t [s],Heading [deg],Rudder [deg]\n0,350,1\n1,abc,2\n2,351,3\n", "",
     "log.csv:3:3:", "\"abc\" in column Heading [deg] is not a number"},
    {"t [s];Heading [deg];Rudder [deg]\n0;350;1\n1;351\n2;352;3\n", "",
     "log.csv:3:3:", "2 cells, but the row of names has 3"},
    {"t [s],Heading [deg],Rudder [deg]\n0,0,350,1,1,5\n0,5,350,2,1,0\n", "", "log.csv:2:9:", "decimal commas"},
    {"t [s],Heading [deg],Rudder [deg]\n0,350,1\n1,351,95\n", "",
     "log.csv:3:7:", "more than rudder angle can be, 90 deg"},
    {"t [s],Heading [deg],Rudder [deg]\n0,350,1\n1,-999,2\n2,351,3\n", "", "log.csv:3:3:", "missing = [-999]"},
    {"t [s],Heading [deg],Rudder [deg],SOG [kn]\n0,350,1,12\n1,351,1,512\n", "", "log.csv:3:9:", "60 kn"},
    {"t [s],Course,Rudder [deg]\n0,350,1\n1,351,2\n", "", "log.csv:1:1:", "\"psi_deg\""},
    {"t [s],Heading [deg],Flap [deg]\n0,350,1\n1,351,2\n", "", "log.csv:1:1:", "not understood: \"Flap [deg]\""},
    {"Heading [deg],Rudder [deg]\n350,1\n351,2\n", "", "log.csv:1:1:", "[time] column"},
    {"t [s],Heading [deg],Rudder\n0,350,0.5\n1,351,0.4\n", "",
     "log.csv:1:21:", "[columns] \"Rudder\" = \"delta_deg\" or \"delta_rad\""},
    {"t [s],Heading [deg],Rudder [deg],ROT\n0,350,5,1\n1,351,4,1\n", "",
     "log.csv:1:34:", "\"r_deg_min\" or \"r_deg_s\""},
    {"t [s],Heading [deg],Rudder [deg],SOG\n0,350,5,7\n1,351,4,7\n", "", "log.csv:1:34:", "\"sog_kn\" or \"sog_m_s\""},
    {"t [s],Heading [deg],Rudder [deg],Drehzahl\n0,350,5,12\n1,351,4,12\n", "",
     "log.csv:1:34:", "\"rev_rpm\" or \"rev_s\""},
    {"t [s],Heading [deg],Rudder [deg]\n0,350,1\n1,351,2\n1,352,3\n", "",
     "log.csv:4:1:", "repeats = \"drop\" or \"spread\""},
    {"t [s],Heading [deg],Rudder [deg]\n0,350,1\n1,351,2\n0.5,352,3\n", "", "log.csv:4:1:", "steps back"},
    {"Time,Heading [deg],Rudder [deg]\n10:00:00,350,1\n10:00:61,351,2\n", "",
     "log.csv:3:1:", "\"10:00:61\" is not a time"},
    {"Time,Heading [deg],Rudder [deg]\n10:00:00,350,1\n,351,2\n", "", "log.csv:3:1:", "missing"},
    {"Time,Heading [deg],Rudder [deg]\n3/4/2024 10:00:00,350,1\n3/4/2024 10:00:01,351,2\n", "",
     "log.csv:2:1:", "date_order = \"dmy\" or \"mdy\""},
    {"Time,Heading [deg],Rudder [deg]\n30/2/2024 10:00:00,350,1\n30/2/2024 10:00:01,351,2\n", "",
     "log.csv:2:1:", "no such date"},
    {"Time,Heading [deg],Rudder [deg]\n0,350,1\n100,351,2\n200,352,2\n", "",
     "log.csv:2:1:", "format = \"milliseconds\""},
    {"t [s];Heading [deg];Rudder [deg]\n0;350,5;1.5\n1;351,5;1,5\n", "",
     "log.csv:3:9:", "has a comma and other cells of the column a decimal point"},
    {"t [s];Heading [deg];Rudder [deg];Load\n0;350,5;1,5;1.234\n1;351,5;1,5;2.234\n", "",
     "log.csv:2:13:", "a thousand or a decimal"},
    {"t [s],Heading [deg],Heading,psi_deg,Rudder [deg]\n0,1,1,1,1\n1,1,1,1,2\n",
     "[columns]\n\"Heading [deg]\" = \"psi_deg\"", "log.csv:1:29:", "both give the heading"},
    {"t [s],Heading [deg],Rudder [deg]\n0,350,1\n1,351,2\n", "[columns]\nRuder = \"delta_deg\"",
     "map.toml:2:1:", "no column \"Ruder\""},
    {"t [s],Heading [deg],Rudder [deg]\n0,350,1\n1,351,2\n", "[columns]\n\"Rudder [deg]\" = \"rudder\"",
     "map.toml:2:18:", "not a column of recordings"},
    {"t [s],Heading [deg],Rudder [deg]\n0,350,1\n1,351,2\n", "colums = 3",
     "map.toml:1:1:", "not a key of a column map"},
    {"t [s],Heading [deg],Rudder [deg]\n0,350,1\n1,351,2\n", "[time]\nformat = \"fortnights\"",
     "map.toml:2:10:", "must be one of"},
    {"t [s],Heading [deg],Rudder [deg]\n0,350,1\n1,351,2\n", "[run]\nrudder_positive = \"left\"",
     "map.toml:2:", "port"},
    {"t [s],Heading [deg],Rudder [deg]\n0,350,1\n1,351,2\n", "[run", "map.toml:1:", ""},
    {"t [s],Heading [deg],Rudder [deg]\n0,350,1\n1e13,351,2\n", "", "log.csv:3:1:", "\"1e13\" is not a time"},
};

TEST_CASE("what cannot be read is refused in one line with its place", "[core][import][refusal]") {
  for (const auto& c : cases) {
    const auto refusal = import_refusal({c.text}, c.map);
    INFO(c.text << "\n" << c.map << "\n" << refusal);
    CHECK_THAT(refusal, StartsWith(c.place) && ContainsSubstring(c.words));
    CHECK(refusal.find('\n') == std::string::npos);
  }
}

TEST_CASE("what a refusal advises settles it", "[core][import][refusal]") {
  const std::pair<std::size_t, const char*> advice[] = {
      {9, "missing = [-999]"},
      {12, "[columns]\n\"Flap [deg]\" = \"delta_deg\""},
      {14, "[columns]\nRudder = \"delta_deg\""},
      {15, "[columns]\nROT = \"r_deg_min\""},
      {16, "[columns]\nSOG = \"sog_kn\""},
      {17, "[columns]\nDrehzahl = \"rev_rpm\""},
      {18, "[time]\nrepeats = \"drop\""},
      {18, "[time]\nrepeats = \"spread\""},
      {19, "[time]\nrepeats = \"drop\""},
      {22, "[time]\ndate_order = \"dmy\""},
      {24, "[time]\nformat = \"milliseconds\""},
      {26, "decimal = \",\"\nthousands = \".\""},
  };
  for (const auto& [i, map] : advice) {
    INFO(cases[i].text << "\n" << map);
    CHECK_THAT(import_refusal({cases[i].text}, ""), StartsWith(cases[i].place));
    CHECK(import_refusal({cases[i].text}, map).empty());
  }
}

TEST_CASE("groups of thousands are understood where nothing else can be meant", "[core][import]") {
  const auto thrust_of = [](const std::string& cell) {
    const auto import =
        test::imported({"t [s];Heading [deg];Rudder [deg];Thrust [N]\n0;350;1;" + cell + "\n1;351;2;" + cell + "\n"});
    return test::recording_of(import).recording[Channel::thrust].front();
  };
  CHECK(thrust_of("1,234,567.5") == 1234567.5);
  CHECK(thrust_of("1.234.567,5") == 1234567.5);
  CHECK(thrust_of("1 234 567,5") == 1234567.5);
  CHECK(thrust_of("1'234'567.5") == 1234567.5);
  CHECK(thrust_of("1,234.5") == 1234.5);
  CHECK(thrust_of("\xE2\x88\x92"
                  "12,5") == -12.5);
  CHECK(thrust_of("1.5e6") == 1.5e6);
}

}  // namespace
}  // namespace swayaw
