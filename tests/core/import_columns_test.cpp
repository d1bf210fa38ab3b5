#include "import_truth.hpp"

/// What columns are taken for, by names, units and values, and how the column map settles the rest.
namespace swayaw {
namespace {

using test::deg;
using test::Dialect;
using test::imported;
using test::RawColumn;
using test::text_of;

const RawColumn heading{"Heading [deg]", Channel::psi, deg, 2}, rudder{"Rudder [deg]", Channel::delta, deg, 1};

const ImportedColumn& column_of(const Import& import, const std::string& source) {
  const auto found = std::ranges::find(import.columns, source, &ImportedColumn::source);
  REQUIRE(found != import.columns.end());
  return *found;
}

/// What a column of that name and channel is taken for beside heading and rudder.
std::string taken_for(const std::string& name, Channel channel, double unit) {
  std::vector<RawColumn> columns{{name, channel, unit, 5}};
  if (channel != Channel::psi) columns.push_back(heading);
  if (channel != Channel::delta) columns.push_back(rudder);
  return column_of(imported({text_of({.columns = columns, .separator = ";"})}), name).taken_for;
}

struct NameCase {
  const char* name;
  Channel channel;
  double unit;
  const char* column;
};

constexpr double kn = test::kn, rpm = 1.0 / 60.0, deg_min = deg / 60.0;

const NameCase names[] = {
    {"HDG [°]", Channel::psi, deg, "psi_deg"},
    {"Hdg True (deg)", Channel::psi, deg, "psi_deg"},
    {"Gyro Heading, deg", Channel::psi, deg, "psi_deg"},
    {"heading_deg", Channel::psi, deg, "psi_deg"},
    {"Heading°", Channel::psi, deg, "psi_deg"},
    {"YawAngle [rad]", Channel::psi, 1.0, "psi_rad"},
    {"ψ [°]", Channel::psi, deg, "psi_deg"},
    {"Steuerkurs in Grad", Channel::psi, deg, "psi_deg"},
    {"Kreiselkurs [Grad]", Channel::psi, deg, "psi_deg"},
    {"Rettvisende kurs [°]", Channel::psi, deg, "psi_deg"},
    {"Gyro 1 [deg]", Channel::psi, deg, "psi_deg"},
    {"GPS2 SOG [kn]", Channel::speed_over_ground, kn, "sog_kn"},
    {"ROT °/min", Channel::r, deg_min, "r_deg_min"},
    {"rot_deg_min", Channel::r, deg_min, "r_deg_min"},
    {"Yaw rate [deg/s]", Channel::r, deg, "r_deg_s"},
    {"Yaw [°/s]", Channel::r, deg, "r_deg_s"},
    {"RateOfTurn [°·min⁻¹]", Channel::r, deg_min, "r_deg_min"},
    {"Wendegeschw. [°/min]", Channel::r, deg_min, "r_deg_min"},
    {"Drehrate (rad/s)", Channel::r, 1.0, "r_rad_s"},
    {"Rudder Angle Actual [deg]", Channel::delta, deg, "delta_deg"},
    {"RudderAngle_deg", Channel::delta, deg, "delta_deg"},
    {"RSA starboard [deg]", Channel::delta, deg, "delta_deg"},
    {"δ [rad]", Channel::delta, 1.0, "delta_rad"},
    {"Ruderwinkel Istwert [°]", Channel::delta, deg, "delta_deg"},
    {"Rorvinkel (grader)", Channel::delta, deg, "delta_deg"},
    {"Rudder Order [deg]", Channel::delta_order, deg, "delta_order_deg"},
    {"rudder cmd [deg]", Channel::delta_order, deg, "delta_order_deg"},
    {"Ruder Soll [°]", Channel::delta_order, deg, "delta_order_deg"},
    {"SOG (kn)", Channel::speed_over_ground, kn, "sog_kn"},
    {"Speed over ground [m/s]", Channel::speed_over_ground, 1.0, "sog_m_s"},
    {"Fahrt über Grund [kn]", Channel::speed_over_ground, kn, "sog_kn"},
    {"GPS Speed knots", Channel::speed_over_ground, kn, "sog_kn"},
    {"Log speed [kts]", Channel::speed_through_water, kn, "stw_kn"},
    {"Fahrt durchs Wasser [kn]", Channel::speed_through_water, kn, "stw_kn"},
    {"Speed through water [m s-1]", Channel::speed_through_water, 1.0, "stw_m_s"},
    {"Course over ground (true) [°]", Channel::course_over_ground, deg, "cog_deg"},
    {"Kurs ü. Grund [°]", Channel::course_over_ground, deg, "cog_deg"},
    {"KüG [°]", Channel::course_over_ground, deg, "cog_deg"},
    {"Northing [m]", Channel::x, 1.0, "x_m"},
    {"Rechtswert [m]", Channel::y, 1.0, "y_m"},
    {"Surge velocity [m/s]", Channel::u, 1.0, "u_m_s"},
    {"v [m/s]", Channel::v, 1.0, "v_m_s"},
    {"Propeller RPM", Channel::rev, rpm, "rev_rpm"},
    {"Drehzahl [U/min]", Channel::rev, rpm, "rev_rpm"},
    {"Shaft speed [Hz]", Channel::rev, 1.0, "rev_s"},
    {"Krängung [°]", Channel::phi, deg, "phi_deg"},
    {"Roll angle [rad]", Channel::phi, 1.0, "phi_rad"},
    {"Schub [kN]", Channel::thrust, 1000.0, "thrust_kN"},
    {"Shaft torque [kNm]", Channel::torque, 1000.0, "torque_kN_m"},
    {"TWS [kn]", Channel::wind_speed, kn, "wind_speed_kn"},
    {"Wahre Windrichtung [°]", Channel::wind_from, deg, "wind_from_deg"},
    {"Wassertiefe [m]", Channel::depth, 1.0, "depth_m"},
    {"Roll [%]", Channel::phi, deg, ""},
    {"Speed [kn]", Channel::speed_over_ground, kn, "sog_kn"},
    {"Course [deg]", Channel::course_over_ground, deg, ""},
    {"Wind speed [m/s]", Channel::wind_speed, 1.0, ""},
    {"Relative wind speed [m/s]", Channel::wind_speed, 1.0, ""},
    {"Engine load [%]", Channel::rev, 1.0, ""},
};

TEST_CASE("columns are known by their names in several habits", "[core][import]") {
  for (const auto& c : names) {
    INFO(c.name);
    CHECK(taken_for(c.name, c.channel, c.unit) == c.column);
  }
}

TEST_CASE("what is no channel is kept as it is, and read without a warning", "[core][import]") {
  const RawColumn wind{"AWA [deg]", Channel::wind_from, deg, 1};
  const auto import = imported({text_of({.columns = {heading, rudder, wind}, .separator = ";", .mark = ','})});
  CHECK_THAT(column_of(import, "AWA [deg]").why, ContainsSubstring("relative wind"));
  const auto [run, warnings] = test::recording_of(import);
  CHECK(warnings.empty());
  REQUIRE(run.extra.size() == 1);
  CHECK(run.extra.front().name == "AWA [deg]");
  CHECK(run.extra.front().cells.front() == test::cell_of(wind, 0.0, '.'));
}

TEST_CASE("everything that was decided stands in the recording and survives writing it anew",
          "[core][import][round-trip]") {
  const auto import = imported(
      {text_of({.columns = {heading, rudder, {"Note, \"raw\" = 1", Channel::phi, deg, 1}}, .separator = ";"})});
  CHECK_THAT(import.text, ContainsSubstring("# imported.psi_deg = \"Heading [deg]: heading, steps of 0.01 deg\""));
  const auto read = test::recording_of(import);
  CHECK(read.warnings.empty());
  const auto again = parse_recording(recording_text(read.recording), "again.csv");
  CHECK(again.warnings.empty());
  CHECK_THAT(recording_text(again.recording), ContainsSubstring("# imported.psi_deg = \"Heading [deg]: heading"));
  CHECK(recording_text(again.recording) == recording_text(read.recording));
}

TEST_CASE("the side of positive rudder angles is taken where it is written, and said to be open where not",
          "[core][import]") {
  const auto side_of = [&](const std::string& name, const std::string& preamble = "", const std::string& map = "") {
    const auto text =
        imported(
            {text_of({.columns = {heading, {name, Channel::delta, deg, 1}}, .separator = ";", .preamble = preamble})},
            map)
            .text;
    const auto at = text.find("rudder_positive = \"");
    return at == std::string::npos ? std::string{} : text.substr(at + 19, text.find('"', at + 19) - at - 19);
  };
  CHECK(side_of("Rudder [deg, stbd +]") == "starboard");
  CHECK(side_of("Rudder [deg] (+ port / - stbd)") == "port");
  CHECK(side_of("Ruderlage [°] StB positiv") == "starboard");
  CHECK(side_of("Ruderlage (Bb positiv) [°]") == "port");
  CHECK(side_of("Rudder [deg]", "Rudder: positive to starboard\n") == "starboard");
  CHECK(side_of("Rudder [deg]", "Roll: positive to starboard\n").empty());
  CHECK(side_of("Rudder [deg]", "", "[run]\nrudder_positive = \"starboard\"") == "starboard");
  CHECK(side_of("Rudder [deg, stbd +]", "", "[run]\nrudder_positive = \"port\"") == "port");
  CHECK(side_of("Rudder [deg]").empty());
  const auto open = imported({text_of({.columns = {heading, rudder}})});
  CHECK_THAT(open.notes.back(), ContainsSubstring("swayaw check"));
}

TEST_CASE("the column map names columns, leaves out, marks missing values and adds run keys", "[core][import]") {
  const auto missing_at_first = [](double t, char mark) {
    return t < 1.0 ? std::string("-999.0") : test::cell_of(rudder, t, mark);
  };
  const auto import =
      imported({text_of({.columns = {{"A", Channel::psi, deg, 2},
                                     {"B", Channel::delta, deg, 1, "", missing_at_first},
                                     {"C", Channel::phi, deg, 1}}})},
               "missing = [-999]\nignore = [\"C\"]\n[columns]\nA = \"psi_deg\"\nB = \"delta_order_deg\"\n"
               "[run]\nreference_x_m = -3.5\nmanoeuvre = \"zigzag 20/20\"\ngroup = \"first day\"\n");
  const auto run = test::recording_of(import).recording;
  CHECK(run.extra.empty());
  CHECK(run.facts.manoeuvre == "zigzag 20/20");
  CHECK(std::isnan(run[Channel::delta_order][0]));
  CHECK(std::abs(run[Channel::delta_order][10] - test::truth(Channel::delta, 5.0)) < 0.06 * deg);
  CHECK_THAT(import.text,
             ContainsSubstring("# reference_x_m = -3.5\n") && ContainsSubstring("# group = \"first day\"\n"));
}

TEST_CASE("files with the same columns are joined in the order of time", "[core][import]") {
  const auto part = [](double begin) {
    std::string text = "Zeit;Kurs [°];Ruder [°]\n";
    for (double t = begin; t < begin + 60.0; t += test::step) {
      char clock[32];
      std::snprintf(clock, sizeof clock, "2024-05-01 10:%02d:%04.1f;", static_cast<int>(t / 60.0), std::fmod(t, 60.0));
      text += clock + test::cell_of(heading, t, ',') + ";" + test::cell_of(rudder, t, ',') + "\n";
    }
    return text;
  };
  const auto run = test::recording_of(imported({part(60.0), part(0.0)})).recording;
  REQUIRE(run.samples() == 240);
  CHECK(run.time.front() == 0.0);
  CHECK(run.time.back() == 119.5);
  test::check_channel(run, heading, 0);
  CHECK_THAT(test::import_refusal({part(60.0), part(30.0)}),
             ContainsSubstring("the file begins before the one before it ends"));
  CHECK_THAT(test::import_refusal({part(0.0), "Zeit;Kurs;Ruder [°]\n2024-05-01 11:00:00;1,0;2,0\n"}),
             ContainsSubstring("log2.csv:1:6:") && ContainsSubstring("not those of log.csv"));
}

TEST_CASE("rows of one second are spread over it, or dropped, where the column map says so", "[core][import]") {
  const auto whole_seconds = [](double t, char) {
    char clock[16];
    std::snprintf(clock, sizeof clock, "10:%02d:%02d", static_cast<int>(t / 60.0), static_cast<int>(t) % 60);
    return std::string(clock);
  };
  const Dialect dialect{
      .name = "whole seconds", .columns = {heading, rudder}, .time_name = "Time", .time = whole_seconds};
  CHECK_THAT(test::import_refusal({text_of(dialect)}),
             ContainsSubstring("log.csv:3:1: the time is that of the row before"));
  auto spread = dialect;
  spread.map = "[time]\nrepeats = \"spread\"";
  test::check_dialect(spread);
  const auto dropped = test::recording_of(imported({text_of(dialect)}, "[time]\nrepeats = \"drop\"")).recording;
  CHECK(dropped.samples() == test::samples / 2);
}

void check_same(const Recording& after, const Recording& before) {
  CHECK(after.time == before.time);
  for (std::size_t i = 0; i < channel_count; ++i) {
    INFO(column_name(static_cast<Channel>(i)));
    REQUIRE(after.channels[i].size() == before.channels[i].size());
    const auto same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
    CHECK(std::ranges::equal(after.channels[i], before.channels[i], same));
  }
  CHECK(after.facts.execute == before.facts.execute);
  CHECK(after.facts.manoeuvre == before.facts.manoeuvre);
}

TEST_CASE("a recording comes back from import as it is", "[core][import][round-trip]") {
  const std::string text =
      "# rudder_positive = \"starboard\"\n# execute_s = 12.5\n# group = \"a\"\n# reference_x_m = -2\n"
      "time_s,x_m,y_m,psi_rad,u_m_s,r_rad_s,delta_rad,rev_s,note\n"
      "10,0,0.5,6.2,1.25,0.0123456789012345,0.1,9.5,calm\n11.5,1e-3,,6.4,1.5,-0.01,-0.2,9.5,\n12,3,1,6.5,1.5,0,0.2,9.5,"
      "gust\n";
  const auto before = parse_recording(text, "run.csv").recording;
  const auto after = test::recording_of(imported({text})).recording;
  check_same(after, before);
  CHECK(after.extra.front().cells == before.extra.front().cells);
}

TEST_CASE("the recordings of the project come back from import as they are", "[core][import][round-trip]") {
  for (const auto& entry : std::filesystem::directory_iterator(test::example_recordings)) {
    if (entry.path().extension() != ".csv") continue;
    INFO(entry.path().string());
    check_same(test::recording_of(import_table({entry.path()}, {})).recording, read_recording(entry.path()).recording);
  }
}

}  // namespace
}  // namespace swayaw
