#include <GeographicLib/Geodesic.hpp>
#include <catch.hpp>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <vector>

#include "recording_text.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/run_remark.hpp"

/// Everything becomes SI, radians, rudder positive to port, midship.
namespace swayaw {
namespace {

using test::file_of;
using test::recording_of;

/// A row of cells with enough digits to read the same numbers back.
std::string row(const std::vector<double>& cells) {
  std::ostringstream text;
  text << std::setprecision(17);
  for (const double& cell : cells) text << cell << (&cell == &cells.back() ? '\n' : ',');
  return text.str();
}

std::vector<double> samples(const Recording& run, Channel channel) {
  return {run[channel].begin(), run[channel].end()};
}

// ---------------------------------------------------------------- units

/// A column, its channel, and what the number 3 in it means in SI.
struct UnitCase {
  const char* column;
  Channel channel;
  double three;
};

constexpr double knots_3 = 3.0 * 0.514444444444444444;
constexpr double degrees_3 = 0.052359877559829887;

const UnitCase units[] = {
    {"x_m", Channel::x, 3.0},
    {"y_m", Channel::y, 3.0},
    {"psi_rad", Channel::psi, 3.0},
    {"psi_deg", Channel::psi, degrees_3},
    {"u_m_s", Channel::u, 3.0},
    {"u_kn", Channel::u, knots_3},
    {"v_m_s", Channel::v, 3.0},
    {"v_kn", Channel::v, knots_3},
    {"ug_m_s", Channel::u_ground, 3.0},
    {"ug_kn", Channel::u_ground, knots_3},
    {"vg_m_s", Channel::v_ground, 3.0},
    {"vg_kn", Channel::v_ground, knots_3},
    {"stw_m_s", Channel::speed_through_water, 3.0},
    {"stw_kn", Channel::speed_through_water, knots_3},
    {"sog_m_s", Channel::speed_over_ground, 3.0},
    {"sog_kn", Channel::speed_over_ground, knots_3},
    {"cog_rad", Channel::course_over_ground, 3.0},
    {"cog_deg", Channel::course_over_ground, degrees_3},
    {"r_rad_s", Channel::r, 3.0},
    {"r_deg_s", Channel::r, degrees_3},
    {"r_deg_min", Channel::r, degrees_3 / 60.0},
    {"delta_rad", Channel::delta, 3.0},
    {"delta_deg", Channel::delta, degrees_3},
    {"delta_order_rad", Channel::delta_order, 3.0},
    {"delta_order_deg", Channel::delta_order, degrees_3},
    {"rev_s", Channel::rev, 3.0},
    {"rev_rpm", Channel::rev, 0.05},
    {"thrust_N", Channel::thrust, 3.0},
    {"thrust_kN", Channel::thrust, 3000.0},
    {"torque_N_m", Channel::torque, 3.0},
    {"torque_kN_m", Channel::torque, 3000.0},
    {"phi_rad", Channel::phi, 3.0},
    {"phi_deg", Channel::phi, degrees_3},
    {"wind_speed_m_s", Channel::wind_speed, 3.0},
    {"wind_speed_kn", Channel::wind_speed, knots_3},
    {"wind_from_rad", Channel::wind_from, 3.0},
    {"wind_from_deg", Channel::wind_from, degrees_3},
    {"depth_m", Channel::depth, 3.0},
};

/// A recording of one sample with the column, and a heading and a rudder in any case.
std::string text_with(const UnitCase& unit) {
  std::ostringstream names, cells;
  names << "time_s," << unit.column;
  cells << "0,3";
  for (const auto& [channel, name] : {std::pair{Channel::psi, "psi_rad"}, {Channel::delta, "delta_rad"}}) {
    if (channel == unit.channel) continue;
    names << ',' << name;
    cells << ",0";
  }
  return names.str() + "\n" + cells.str() + "\n";
}

TEST_CASE("every column reads to SI", "[core][limit]") {
  for (const auto& unit : units) {
    INFO(unit.column);
    const auto file = file_of(text_with(unit));
    REQUIRE(file.recording[unit.channel].size() == 1);
    CHECK_THAT(file.recording[unit.channel][0], WithinRel(unit.three, 1e-14));
    CHECK(file.warnings.empty());
  }
}

TEST_CASE("no column is understood that the format does not name", "[core][limit]") {
  CHECK(known_columns().size() == std::size(units));
  for (const auto& unit : units) CHECK(column_named(unit.column)->channel == unit.channel);
}

// ---------------------------------------------------------------- run keys

TEST_CASE("run keys tell the facts of the run", "[core]") {
  const auto run = recording_of(
      "# manoeuvre = \"zigzag 10/10\"\n"
      "# execute_s = 12.5\n"
      "#water_depth_m=30\n"
      "time_s,psi_rad,delta_rad\n0,0,0\n");
  CHECK(run.facts.manoeuvre == "zigzag 10/10");
  CHECK(run.facts.execute == 12.5);
  CHECK(run.facts.water_depth == 30.0);
  CHECK(run.facts.remarks.empty());
}

TEST_CASE("a rudder column that holds the order is read as the order", "[core]") {
  const std::string rows = "time_s,psi_rad,delta_deg\n0,0,10\n1,0,-10\n";
  const auto order = recording_of("# order_recorded = true\n# rudder_positive = \"starboard\"\n" + rows);
  CHECK_FALSE(order.has(Channel::delta));
  CHECK_THAT(order[Channel::delta_order][0], WithinRel(radians(-10.0), 1e-15));
  CHECK(recording_text(order).find("order_recorded") == std::string::npos);  // the name of the column tells it
  CHECK(recording_of(recording_text(order))[Channel::delta_order][1] == order[Channel::delta_order][1]);
  CHECK(recording_of("# order_recorded = false\n" + rows).has(Channel::delta));
}

TEST_CASE("an ordered shaft speed stands where no column has the shaft speed", "[core]") {
  const auto run = recording_of("# ordered_rev_s = 1.5\ntime_s,psi_rad,delta_rad\n0,0,0\n1,0,0\n");
  CHECK(std::ranges::equal(run[Channel::rev], std::array{1.5, 1.5}));
  const auto empty = recording_of("# ordered_rev_s = 1.5\ntime_s,psi_rad,delta_rad,rev_rpm\n0,0,0,\n1,0,0,\n");
  CHECK(std::ranges::equal(empty[Channel::rev], std::array{1.5, 1.5}));
  const std::string both = "# ordered_rev_s = 1.5\ntime_s,psi_rad,delta_rad,rev_s\n0,0,0,1.25\n1,0,0,\n";
  const auto recorded = recording_of(both);
  CHECK(recorded[Channel::rev][0] == 1.25);
  CHECK(std::isnan(recorded[Channel::rev][1]));
  CHECK(recording_text(recorded) == "# rudder_positive = \"port\"\n" + both);
}

TEST_CASE("a run without keys has unknown facts and the rudder positive to port", "[core]") {
  const auto run = recording_of("time_s,psi_rad,delta_rad\n0,0,0.1\n");
  CHECK(run.facts.manoeuvre.empty());
  CHECK_FALSE(run.facts.execute.has_value());
  CHECK_FALSE(run.facts.water_depth.has_value());
  CHECK(run[Channel::delta][0] == 0.1);
}

TEST_CASE("a run key that is not understood is kept as written", "[core]") {
  const auto file = file_of("# facility = \"tank \\\"B\\\" = deep\"  # no. 3\ntime_s,psi_rad,delta_rad\n0,0,0\n");
  REQUIRE(file.recording.facts.remarks.size() == 1);
  CHECK(file.recording.facts.remarks[0].key == "facility");
  CHECK(file.recording.facts.remarks[0].value == "\"tank \\\"B\\\" = deep\"  # no. 3");
  CHECK(file.warnings.empty());
}

TEST_CASE("group and start_utc are values, without the comment behind them", "[core]") {
  const auto run = recording_of(
      "# group = \"trial of \\\"May\\\"\"  # second day\n# start_utc = 2026-03-04T09:30:00Z # by the receiver\n"
      "time_s,psi_rad,delta_rad\n0,0,0\n");
  CHECK(remark_of(run, "group") == "trial of \\\"May\\\"");
  CHECK(start_utc(run) == 1772616600.0);
  CHECK(start_utc(recording_of(recording_text(run))) == 1772616600.0);
  CHECK(remark_of(recording_of(recording_text(run)), "group") == remark_of(run, "group"));
}

TEST_CASE("a line for human readers is not a run key", "[core]") {
  const auto file = file_of(
      "# Trial of 31 July, wind slight\n#\n\n# rudder_positive = \"starboard\"\ntime_s,psi_rad,delta_rad\n0,0,0.1\n");
  CHECK(file.recording[Channel::delta][0] == -0.1);
  CHECK(file.warnings.empty());
}

TEST_CASE("a misspelt run key is named in a warning", "[core]") {
  const std::string rows = "\ntime_s,psi_rad,delta_rad\n0,0,0.1\n";
  for (const std::string line :
       {"# rudder_positve = \"starboard\"", "# Rudder_Positive = \"starboard\"", "# rudder_positive \"starboard\""}) {
    INFO(line);
    const auto file = file_of(line + rows);
    REQUIRE(file.warnings.size() == 1);
    CHECK_THAT(file.warnings[0], ContainsSubstring("rudder_positive"));
    CHECK_THAT(file.warnings[0], ContainsSubstring("run.csv: "));
  }
}

// ---------------------------------------------------------------- signs

TEST_CASE("a rudder recorded positive to starboard changes sign, actual and ordered", "[core][symmetry]") {
  const std::string rows = "time_s,psi_rad,delta_deg,delta_order_rad\n0,0.2,10,0.3\n1,0.2,-10,\n";
  const auto port = recording_of("# rudder_positive = \"port\"\n" + rows);
  const auto starboard = recording_of("# rudder_positive = \"starboard\"\n" + rows);
  CHECK(port[Channel::delta][0] == radians(10.0));
  CHECK(starboard[Channel::delta][0] == -radians(10.0));
  CHECK(starboard[Channel::delta][1] == radians(10.0));
  CHECK(port[Channel::delta_order][0] == 0.3);
  CHECK(starboard[Channel::delta_order][0] == -0.3);
  CHECK(std::isnan(starboard[Channel::delta_order][1]));
  CHECK(starboard[Channel::psi][0] == 0.2);
}

// ---------------------------------------------------------------- samples

TEST_CASE("a missing sample is an empty cell or nan", "[core]") {
  const auto run =
      recording_of("time_s,psi_rad,delta_rad,u_m_s\n0,0,0,\n1,nan,0,1\n2,0,NaN,1\n3,0,-nan, \n4,0,\"\",1\n");
  const auto is_missing = [&](Channel channel) {
    std::vector<bool> result;
    for (const double x : run[channel]) result.push_back(std::isnan(x));
    return result;
  };
  CHECK(is_missing(Channel::u) == std::vector{true, false, false, true, false});
  CHECK(is_missing(Channel::psi) == std::vector{false, true, false, false, false});
  CHECK(is_missing(Channel::delta) == std::vector{false, false, true, true, true});
}

TEST_CASE("sampling may be irregular", "[core]") {
  const auto run = recording_of("time_s,psi_rad,delta_rad\n-1,0,0\n0.1,0,0\n0.15,0,0\n60,0,0\n");
  CHECK(run.time == std::vector{-1.0, 0.1, 0.15, 60.0});
}

TEST_CASE("numbers may have a sign, blanks around them, quotes or an exponent", "[core]") {
  const auto run = recording_of("time_s,psi_rad,delta_rad\n +0 , -1e-3,\"2.5E2\"\n1.,\t.5 ,+7\n");
  CHECK(run.time == std::vector{0.0, 1.0});
  CHECK(samples(run, Channel::psi) == std::vector{-1e-3, 0.5});
  CHECK(samples(run, Channel::delta) == std::vector{250.0, 7.0});
}

TEST_CASE("a channel whose samples are all missing is not there", "[core]") {
  const auto run = recording_of("time_s,psi_rad,delta_rad,u_m_s\n0,0,0,\n1,0,0,\n");
  CHECK_FALSE(run.has(Channel::u));
  CHECK_FALSE(run.has(Channel::x));
  CHECK(run.has(Channel::psi));
}

TEST_CASE("one coordinate without the other is a channel like any other", "[core]") {
  CHECK(recording_of("time_s,x_m,psi_rad,delta_rad\n0,5,0,0\n").has(Channel::x));
}

// ---------------------------------------------------------------- forms of the text

TEST_CASE("the same recording reads the same in every form of text", "[core][second-route]") {
  const std::string plain = "# execute_s = 1\ntime_s,psi_rad,delta_rad,u_kn\n0,0.1,0.2,\n1,0.3,,4\n";
  const auto expected = recording_text(recording_of(plain));
  const std::pair<const char*, std::string> forms[] = {
      {"CRLF", "# execute_s = 1\r\ntime_s,psi_rad,delta_rad,u_kn\r\n0,0.1,0.2,\r\n1,0.3,,4\r\n"},
      {"byte order mark", "\xEF\xBB\xBF" + plain},
      {"byte order mark before the header", "\xEF\xBB\xBFtime_s,psi_rad,delta_rad,u_kn\n0,0.1,0.2,\n1,0.3,,4\n"},
      {"trailing blank lines", plain + "\n  \n\t\r\n"},
      {"blank lines between", "\n# execute_s = 1\n\ntime_s,psi_rad,delta_rad,u_kn\n\n0,0.1,0.2,\n\n1,0.3,,4\n"},
      {"blanks round cells",
       "  # execute_s = 1 \n time_s , psi_rad\t,delta_rad , u_kn \n 0 ,0.1 , 0.2,  \n1 , 0.3, , 4 \n"},
      {"quoted header", "# execute_s = 1\n\"time_s\",\"psi_rad\", \"delta_rad\" ,\"u_kn\"\n0,0.1,0.2,\n1,0.3,,4\n"},
      {"no newline at the end", plain.substr(0, plain.size() - 1)},
      {"CRLF without the last", "# execute_s = 1\r\ntime_s,psi_rad,delta_rad,u_kn\r\n0,0.1,0.2,\r\n1,0.3,,4"},
      {"time not first", "# execute_s = 1\nu_kn,delta_rad,psi_rad,time_s\n,0.2,0.1,0\n4,,0.3,1\n"},
  };
  for (const auto& [form, text] : forms) {
    INFO(form);
    const bool has_key = text.find("execute_s") != std::string::npos;
    const auto read =
        recording_text(recording_of(has_key ? text : "# execute_s = 1\n" + recording_text(recording_of(text))));
    CHECK(read == expected);
  }
}

TEST_CASE("a column that is not understood is kept and named in a warning", "[core]") {
  const auto file =
      file_of("time_s,psi_rad,delta_rad,utc,\"mast, top\"\n0,0,0,2020-07-31T13:04:24Z, 1.50\n1,0,0,,\"a, b\"\n");
  const auto& extra = file.recording.extra;
  REQUIRE(extra.size() == 2);
  CHECK(extra[0].name == "utc");
  CHECK(extra[0].cells == std::vector<std::string>{"2020-07-31T13:04:24Z", ""});
  CHECK(extra[1].name == "mast, top");
  CHECK(extra[1].cells == std::vector<std::string>{"1.50", "\"a, b\""});
  REQUIRE(file.warnings.size() == 2);
  CHECK_THAT(file.warnings[0], ContainsSubstring("column utc is not understood"));
  CHECK_THAT(file.warnings[1], ContainsSubstring("column mast, top is not understood"));
}

TEST_CASE("an upper-case name is kept with a warning that tells the name that was perhaps meant", "[core]") {
  const auto file = file_of("time_s,psi_rad,delta_rad,U_M_S,thrust_n\n0,0,0,1,2\n");
  CHECK_FALSE(file.recording.has(Channel::u));
  REQUIRE(file.warnings.size() == 2);
  CHECK_THAT(file.warnings[0], ContainsSubstring("is u_m_s meant?"));
  CHECK_THAT(file.warnings[1], ContainsSubstring("is thrust_N meant?"));
}

// ---------------------------------------------------------------- heading

TEST_CASE("a wrapped heading is unwrapped", "[core]") {
  const auto degrees_run = recording_of("time_s,psi_deg,delta_rad\n0,350,0\n1,358,0\n2,6,0\n3,,0\n4,14,0\n5,355,0\n");
  const double expected_deg[] = {350.0, 358.0, 366.0, 0.0, 374.0, 355.0};
  const auto radians_run = recording_of("time_s,psi_rad,delta_rad\n0,3.0,0\n1,-3.1,0\n2,-2.9,0\n3,3.1,0\n");
  const double expected_rad[] = {3.0, 2.0 * pi - 3.1, 2.0 * pi - 2.9, 3.1};
  for (std::size_t i : {0u, 1u, 2u, 4u, 5u})
    CHECK_THAT(degrees(degrees_run[Channel::psi][i]), WithinAbs(expected_deg[i], 1e-12));
  for (std::size_t i = 0; i < 4; ++i) CHECK_THAT(radians_run[Channel::psi][i], WithinAbs(expected_rad[i], 1e-14));
}

TEST_CASE("a heading that turns full circles to port unwraps to negative angles", "[core][symmetry]") {
  std::string text = "time_s,psi_deg,delta_rad\n";
  for (int i = 0; i <= 30; ++i) text += row({1.0 * i, 1.0 * (((10 - 30 * i) % 360 + 360) % 360), 0.0});
  CHECK_THAT(degrees(recording_of(text)[Channel::psi].back()), WithinAbs(10.0 - 900.0, 1e-9));
}

TEST_CASE("an unwrapped heading stays as it is, to the last bit", "[core]") {
  const auto run = recording_of(
      "time_s,psi_rad,delta_rad\n0,9.3,0\n1,12.4,0\n2,13.1,0\n3,10.7,0\n4,8,0\n5,5,0\n6,2.1,0\n7,1.234567890123e-5,"
      "0\n");
  CHECK(samples(run, Channel::psi) == std::vector{9.3, 12.4, 13.1, 10.7, 8.0, 5.0, 2.1, 1.234567890123e-5});
}

// ---------------------------------------------------------------- position

/// North and east of the first fix along the geodesic between them.
std::pair<double, double> north_east(double lat_0, double lon_0, double lat, double lon) {
  double distance = 0.0, azimuth = 0.0, ignored = 0.0;
  GeographicLib::Geodesic::WGS84().Inverse(lat_0, lon_0, lat, lon, distance, azimuth, ignored);
  return {distance * std::cos(radians(azimuth)), distance * std::sin(radians(azimuth))};
}

TEST_CASE("latitude and longitude become metres north and east of the first fix", "[core][second-route]") {
  for (const auto& [lat_0, lon_0] : {std::pair{63.4, 10.4}, {-33.9, 151.2}, {0.0, 179.999}, {54.2, -0.001}}) {
    INFO(lat_0 << ", " << lon_0);
    const double lat[] = {lat_0, lat_0 + 0.012, lat_0 - 0.015, lat_0 + 0.001};
    const double lon[] = {lon_0, lon_0 + 0.013, lon_0 + 0.002, lon_0 - 0.016};
    std::string text = "time_s,lat_deg,lon_deg,psi_rad,delta_rad\n-1,,,0,0\n";
    for (int i = 0; i < 4; ++i) text += row({1.0 * i, lat[i], std::remainder(lon[i], 360.0), 0.0, 0.0});
    const auto run = recording_of(text);
    CHECK(std::isnan(run[Channel::x][0]));
    for (std::size_t i = 0; i < 4; ++i) {
      const auto [north, east] = north_east(lat_0, lon_0, lat[i], lon[i]);
      CHECK_THAT(run[Channel::x][i + 1], WithinAbs(north, 1e-3));
      CHECK_THAT(run[Channel::y][i + 1], WithinAbs(east, 1e-3));
    }
  }
}

TEST_CASE("a fix without latitude or longitude is a missing position", "[core]") {
  const auto run =
      recording_of("time_s,lat_deg,lon_deg,psi_rad,delta_rad\n0,54,10,0,0\n1,,10,0,0\n2,54,nan,0,0\n3,54,10,0,0\n");
  CHECK(run[Channel::x][0] == 0.0);
  CHECK(std::isnan(run[Channel::x][1]));
  CHECK(std::isnan(run[Channel::y][2]));
  CHECK_THAT(run[Channel::y][3], WithinAbs(0.0, 1e-9));
}

// ---------------------------------------------------------------- to midship

/// A circle of midship: radius R, yaw rate r, drift angle beta; reported from a point l forward.
struct Circle {
  double R = 50.0, r = 0.02, beta = 0.1, l = 4.0;

  double U() const { return R * r; }
  double psi(double t) const { return 0.3 + r * t; }
  double u() const { return U() * std::cos(beta); }
  double v() const { return -U() * std::sin(beta); }
  double course(double t) const { return psi(t) - beta; }
  double x(double t) const { return R * std::sin(course(t)); }
  double y(double t) const { return -R * std::cos(course(t)); }
  double reported_x(double t) const { return x(t) + l * std::cos(psi(t)); }
  double reported_y(double t) const { return y(t) + l * std::sin(psi(t)); }
  double reported_v() const { return v() + l * r; }
};

void check_at_midship(const Recording& run, const Circle& c) {
  for (std::size_t i = 0; i < run.samples(); ++i) {
    const double t = run.time[i];
    CHECK_THAT(run[Channel::x][i], WithinAbs(c.x(t), 1e-9));
    CHECK_THAT(run[Channel::y][i], WithinAbs(c.y(t), 1e-9));
    CHECK_THAT(run[Channel::u][i], WithinAbs(c.u(), 1e-12));
    CHECK_THAT(run[Channel::v][i], WithinAbs(c.v(), 1e-9));
    CHECK_THAT(run[Channel::v_ground][i], WithinAbs(c.v(), 1e-9));
    CHECK_THAT(run[Channel::speed_over_ground][i], WithinAbs(c.U(), 1e-9));
    CHECK_THAT(wrapped(run[Channel::course_over_ground][i] - c.course(t)), WithinAbs(0.0, 1e-9));
  }
}

/// What the reported point sends.
std::string reported(const Circle& c, double t) {
  const double course = c.psi(t) + std::atan2(c.reported_v(), c.u());
  return row({t, c.reported_x(t), c.reported_y(t), c.u(), c.reported_v(), c.reported_v(),
              std::hypot(c.u(), c.reported_v()), wrapped(course), wrapped(c.psi(t)), 0.1, t == 5.0 ? missing : c.r});
}

std::string circle_text(const Circle& c) {
  std::ostringstream text;
  text << "# reference_x_m = " << c.l
       << "\ntime_s,x_m,y_m,u_m_s,v_m_s,vg_m_s,sog_m_s,cog_rad,psi_rad,delta_rad,r_rad_s\n";
  for (const double t : {0.0, 3.0, 5.0, 40.0, 41.0}) text << reported(c, t);
  return text.str();
}

TEST_CASE("position and velocity move from the reported point to midship", "[core][second-route]") {
  check_at_midship(recording_of(circle_text({})), {});
  check_at_midship(recording_of(circle_text({.l = -7.5})), {.l = -7.5});
}

TEST_CASE("without a yaw rate the heading tells how the reported point turns", "[core][second-route]") {
  std::string text = circle_text({});
  text.replace(text.find("r_rad_s"), 7, "unknown");
  check_at_midship(recording_of(text), {});
}

TEST_CASE("a reported point at midship leaves the numbers as they are", "[core][limit]") {
  const std::string rows = "time_s,x_m,y_m,psi_rad,r_rad_s,v_m_s,delta_rad\n0,1.1,2.2,0.3,0.04,0.5,0\n";
  CHECK(recording_text(recording_of("# reference_x_m = 0\n" + rows)) == recording_text(recording_of(rows)));
}

}  // namespace
}  // namespace swayaw
