#include <iconv.h>

#include "import_truth.hpp"

/// Raw files in the dialects of loggers and spreadsheets come back within half a step of their last digit.
namespace swayaw {
namespace {

using test::deg;
using test::Dialect;
using test::kn;
using test::number;
using test::RawColumn;

std::string encoded(const std::string& text, const char* encoding) {
  const iconv_t converter = iconv_open(encoding, "UTF-8");
  std::string result(text.size() * 2 + 4, '\0');
  auto* from = const_cast<char*>(text.data());
  auto* to = result.data();
  std::size_t left = text.size(), space = result.size();
  REQUIRE(iconv(converter, &from, &left, &to, &space) != static_cast<std::size_t>(-1));
  iconv_close(converter);
  result.resize(result.size() - space);
  return result;
}

auto in_encoding(const char* encoding, const std::string& mark = "") {
  return [=](const std::string& text) { return mark + encoded(text, encoding); };
}

// ---------------------------------------------------------------- columns in several habits

const std::vector<RawColumn> plain{{"Heading [deg]", Channel::psi, deg, 2},
                                   {"Rudder angle [deg]", Channel::delta, deg, 1},
                                   {"SOG [kn]", Channel::speed_over_ground, kn, 2}};

const std::vector<RawColumn> english{{"HDG (deg)", Channel::psi, deg, 1},
                                     {"ROT (deg/min)", Channel::r, deg / 60.0, 1},
                                     {"RSA (deg)", Channel::delta, deg, 1},
                                     {"Rudder order (deg)", Channel::delta_order, deg, 1},
                                     {"SOG (kts)", Channel::speed_over_ground, kn, 2},
                                     {"COG (deg)", Channel::course_over_ground, deg, 1},
                                     {"STW (kn)", Channel::speed_through_water, kn, 1},
                                     {"Shaft RPM", Channel::rev, 1.0 / 60.0, 1},
                                     {"Roll [deg]", Channel::phi, deg, 2},
                                     {"True wind speed [m/s]", Channel::wind_speed, 1.0, 1},
                                     {"True wind direction [deg]", Channel::wind_from, deg, 0},
                                     {"Water depth [m]", Channel::depth, 1.0, 1}};

const std::vector<RawColumn> german{{"Kurs [°]", Channel::psi, deg, 1},
                                    {"Wendegeschwindigkeit [°/min]", Channel::r, deg / 60.0, 1},
                                    {"Ruderlage [°]", Channel::delta, deg, 1},
                                    {"Ruderlage Soll [°]", Channel::delta_order, deg, 1},
                                    {"Kurs ü. Grund [°]", Channel::course_over_ground, deg, 1},
                                    {"Fahrt ü. Grund [kn]", Channel::speed_over_ground, kn, 2},
                                    {"Fahrt [kn]", Channel::speed_through_water, kn, 2},
                                    {"Wellendrehzahl [1/min]", Channel::rev, 1.0 / 60.0, 1},
                                    {"Krängung [°]", Channel::phi, deg, 1}};

const std::vector<RawColumn> norwegian{{"Gyrokurs [grader]", Channel::psi, deg, 1},
                                       {"Svinghastighet [°/s]", Channel::r, deg, 3},
                                       {"Rorvinkel [grader]", Channel::delta, deg, 1},
                                       {"Fart over grunn [knop]", Channel::speed_over_ground, kn, 2},
                                       {"Turtall [o/min]", Channel::rev, 1.0 / 60.0, 1}};

const std::vector<RawColumn> dutch{{"Voorligging [graden]", Channel::psi, deg, 1},
                                   {"Draaisnelheid [°/min]", Channel::r, deg / 60.0, 1},
                                   {"Roerhoek [graden]", Channel::delta, deg, 1},
                                   {"Snelheid door het water [knopen]", Channel::speed_through_water, kn, 2},
                                   {"Toerental [rpm]", Channel::rev, 1.0 / 60.0, 1}};

const std::vector<RawColumn> spanish{{"Rumbo verdadero [grados]", Channel::psi, deg, 1},
                                     {"Ángulo de timón [grados]", Channel::delta, deg, 1},
                                     {"Velocidad sobre el fondo [nudos]", Channel::speed_over_ground, kn, 2},
                                     {"Escora [grados]", Channel::phi, deg, 1},
                                     {"Velocidad de giro [°/min]", Channel::r, deg / 60.0, 1}};

const std::vector<RawColumn> japanese{{"senshu hoi (deg)", Channel::psi, deg, 1},
                                      {"dakaku (deg)", Channel::delta, deg, 1},
                                      {"shirei dakaku (deg)", Channel::delta_order, deg, 1},
                                      {"taisui sokuryoku (kn)", Channel::speed_through_water, kn, 2},
                                      {"kaitensu (rpm)", Channel::rev, 1.0 / 60.0, 1}};

const std::vector<RawColumn> unitless{{"Gyro", Channel::psi, deg, 2},
                                      {"Rate of turn", Channel::r, deg / 60.0, 1},
                                      {"Rudder", Channel::delta, deg, 1},
                                      {"North", Channel::x, 1.0, 1},
                                      {"East", Channel::y, 1.0, 1},
                                      {"SOG", Channel::speed_over_ground, kn, 2},
                                      {"STW", Channel::speed_through_water, kn, 2},
                                      {"Heel", Channel::phi, deg, 1},
                                      {"RPM", Channel::rev, 1.0 / 60.0, 2}};

const std::vector<RawColumn> research{{"psi [rad]", Channel::psi, 1.0, 4}, {"r", Channel::r, 1.0, 5},
                                      {"delta", Channel::delta, 1.0, 4},   {"u [m/s]", Channel::u, 1.0, 3},
                                      {"v", Channel::v, 1.0, 3},           {"x [m]", Channel::x, 1.0, 2},
                                      {"y [m]", Channel::y, 1.0, 2},       {"n [1/s]", Channel::rev, 1.0, 3}};

std::vector<RawColumn> with(std::vector<RawColumn> columns, std::vector<RawColumn> more) {
  columns.insert(columns.end(), more.begin(), more.end());
  return columns;
}

// ---------------------------------------------------------------- times

/// Seconds since a midnight at which the run begins.
auto clock_from(double begin, int decimals = 1, bool twelve = false) {
  return [=](double t, char mark) {
    const double s = std::fmod(begin + t, 86400.0);
    const int hours = static_cast<int>(s / 3600.0), minutes = static_cast<int>(s / 60.0) % 60;
    char front[16];
    std::snprintf(front, sizeof front, "%02d:%02d:", twelve ? (hours + 11) % 12 + 1 : hours, minutes);
    const auto seconds = std::fmod(s, 60.0);
    return front + std::string(seconds < 10.0 ? "0" : "") + number(seconds, decimals, mark) +
           (twelve ? (hours < 12 ? " AM" : " PM") : "");
  };
}

constexpr double morning = 8 * 3600.0 + 1794.0, before_midnight = 86400.0 - 61.0;

auto after(const std::string& date, double begin, const std::string& end = "") {
  return [=](double t, char mark) { return date + clock_from(begin)(t, mark) + end; };
}

/// Date and clock across midnight.
auto two_days(const std::string& first, const std::string& second) {
  return [=](double t, char mark) {
    return (before_midnight + t < 86400.0 ? first : second) + clock_from(before_midnight)(t, mark);
  };
}

std::string degrees_and_minutes(double value, const char* sides, int decimals) {
  const int whole = static_cast<int>(std::abs(value));
  return std::to_string(whole) + "°" + number((std::abs(value) - whole) * 60.0, decimals) + "'" +
         sides[value < 0.0 ? 1 : 0];
}

RawColumn north_as(const std::string& name, std::function<std::string(double, char)> cell) {
  return {name, Channel::x, 1.0, 1, "", std::move(cell)};
}
RawColumn east_as(const std::string& name, std::function<std::string(double, char)> cell) {
  return {name, Channel::y, 1.0, 1, "", std::move(cell)};
}

const std::vector<RawColumn> decimal_position =
    with(plain, {north_as("Latitude", [](double t, char mark) { return number(test::latitude(t), 7, mark); }),
                 east_as("Longitude", [](double t, char mark) { return number(test::longitude(t), 7, mark); })});

const std::vector<RawColumn> written_position =
    with(plain, {north_as("Lat", [](double t, char) { return degrees_and_minutes(test::latitude(t), "NS", 5); }),
                 east_as("Lon", [](double t, char) { return degrees_and_minutes(test::longitude(t), "EW", 5); })});

std::string nmea_degrees(double value) {
  return number(100.0 * std::floor(value) + 60.0 * (value - std::floor(value)), 5);
}

const std::vector<RawColumn> nmea_position =
    with(plain, {north_as("Lat", [](double t, char) { return nmea_degrees(test::latitude(t)) + "N"; }),
                 east_as("Lon", [](double t, char) { return "00" + nmea_degrees(test::longitude(t)) + "E"; })});

const std::vector<RawColumn> minutes_in_numbers =
    with(plain, {north_as("Lat", [](double t, char) { return nmea_degrees(test::latitude(t)); }),
                 east_as("Lon", [](double t, char) { return nmea_degrees(test::longitude(t)); })});

RawColumn side_of(const std::string& name, Channel channel, double unit, int decimals, double more) {
  return {name, channel,
          unit, decimals,
          "",   [=](double t, char mark) { return number(test::truth(channel, t) / unit + more, decimals, mark); }};
}

const std::vector<RawColumn> twins{{"Heading [deg]", Channel::psi, deg, 2},
                                   side_of("Rudder port [deg]", Channel::delta, deg, 1, 0.5),
                                   side_of("Rudder stbd [deg]", Channel::delta, deg, 1, -0.5),
                                   side_of("RPM 1", Channel::rev, 1.0 / 60.0, 1, 2.0),
                                   side_of("RPM 2", Channel::rev, 1.0 / 60.0, 1, -2.0)};

/// Port is positive inside.
std::string with_letter(double t, char mark) {
  const double port = test::truth(Channel::delta, t) / deg;
  return (port > 0.0 ? "P " : "S ") + number(std::abs(port), 1, mark);
}

const std::vector<RawColumn> letters{{"Heading [deg]", Channel::psi, deg, 2},
                                     {"Rudder [deg]", Channel::delta, deg, 1, "", with_letter}};

RawColumn letter_of_side(const char* letter) {
  return {"Side", Channel::delta, deg, 1, "", [=](double, char) { return letter; }};
}

const std::vector<RawColumn> sides_beside =
    with(plain, {minutes_in_numbers[3], letter_of_side("N"), minutes_in_numbers[4], letter_of_side("E")});

std::vector<RawColumn> with_units_below(std::vector<RawColumn> columns) {
  const char* units[] = {"[deg]", "[deg]", "kn"};
  for (std::size_t i = 0; i < columns.size(); ++i) {
    columns[i].name = columns[i].name.substr(0, columns[i].name.find(" ["));
    columns[i].units_cell = units[i];
  }
  return columns;
}

RawColumn missing_at(const char* mark) {
  return {"Remark", Channel::delta, deg, 1, "", [=](double, char) { return mark; }};
}

const std::vector<Dialect> dialects{
    {.name = "commas", .columns = plain},
    {.name = "semicolons and decimal commas", .columns = plain, .separator = ";", .mark = ','},
    {.name = "tabs", .columns = plain, .separator = "\t"},
    {.name = "tabs and decimal commas", .columns = plain, .separator = "\t", .mark = ','},
    {.name = "bars", .columns = plain, .separator = " | "},
    {.name = "runs of blanks", .columns = plain, .separator = "   "},
    {.name = "blanks and decimal commas", .columns = plain, .separator = "  ", .mark = ','},
    {.name = "quoted cells", .columns = plain, .quotes = true},
    {.name = "quoted cells with decimal commas between commas", .columns = plain, .mark = ',', .quotes = true},
    {.name = "Windows line ends", .columns = plain, .line_end = "\r\n"},
    {.name = "byte order mark", .columns = german, .preamble = "\xEF\xBB\xBF"},
    {.name = "UTF-16, small end first",
     .columns = german,
     .separator = "\t",
     .line_end = "\r\n",
     .encode = in_encoding("UTF-16LE", "\xFF\xFE")},
    {.name = "UTF-16, big end first",
     .columns = german,
     .separator = "\t",
     .encode = in_encoding("UTF-16BE", "\xFE\xFF")},
    {.name = "UTF-16 without a mark", .columns = german, .encode = in_encoding("UTF-16LE")},
    {.name = "Windows-1252",
     .columns = german,
     .separator = ";",
     .mark = ',',
     .line_end = "\r\n",
     .encode = in_encoding("CP1252")},
    {.name = "a preamble",
     .columns = plain,
     .preamble = "Sea trial of MV Example\nDate: 12 March 2024\n\nLogger: abc, v1.2\n"},
    {.name = "a preamble as wide as the table",
     .columns = plain,
     .separator = ";",
     .mark = ',',
     .line_end = "\r\n",
     .preamble = "Messfahrt;;;\r\nSchiff;Beispiel;;\r\n;;;\r\n"},
    {.name = "comments above the names", .columns = plain, .preamble = "# made by a logger\n# time = local\n% 2024\n"},
    {.name = "names in a comment", .columns = plain, .preamble = "# made by a logger\n# "},
    {.name = "a row of units", .columns = with_units_below(plain), .time_name = "Time", .time_units = "[s]"},
    {.name = "a row of units between semicolons",
     .columns = with_units_below(plain),
     .time_name = "Zeit",
     .separator = ";",
     .mark = ',',
     .time_units = "s"},
    {.name = "separators behind all rows", .columns = plain, .separator = ";", .row_end = ";", .name_end = ";"},
    {.name = "separators behind the samples", .columns = plain, .separator = ";", .row_end = ";;"},
    {.name = "names again in the middle",
     .columns = plain,
     .between = "Time [s],Heading [deg],Rudder angle [deg],SOG [kn]\n"},
    {.name = "long waiting", .columns = plain, .still_rows = 4000},
    {.name = "marks of missing values", .columns = with(plain, {missing_at("n/a")})},
    {.name = "English", .columns = english},
    {.name = "German", .columns = german, .time_name = "Zeit [s]"},
    {.name = "Norwegian", .columns = norwegian, .time_name = "Tid [s]"},
    {.name = "Dutch", .columns = dutch, .time_name = "Tijd [s]"},
    {.name = "Spanish", .columns = spanish, .time_name = "Tiempo [s]"},
    {.name = "Japanese", .columns = japanese, .time_name = "jikan [s]"},
    {.name = "no units at all", .columns = unitless, .time_name = "Time"},
    {.name = "research in radians", .columns = research, .time_name = "t [s]"},
    {.name = "twin rudders and shafts", .columns = twins},
    {.name = "positions in degrees", .columns = decimal_position},
    {.name = "positions in degrees with decimal commas", .columns = decimal_position, .separator = ";", .mark = ','},
    {.name = "positions in degrees and minutes", .columns = written_position},
    {.name = "positions as NMEA writes them", .columns = nmea_position},
    {.name = "positions of degrees and minutes in one number", .columns = minutes_in_numbers},
    {.name = "positions with columns of sides", .columns = sides_beside},
    {.name = "rudder angles with the letter of their side", .columns = letters},
    {.name = "rudder angles with letters and decimal commas", .columns = letters, .separator = ";", .mark = ','},
    {.name = "km/h and centimetres a second",
     .columns = with(
         plain, {{"STW [km/h]", Channel::speed_through_water, 1.0 / 3.6, 2}, {"Surge [cm/s]", Channel::u, 0.01, 0}})},
    {.name = "forces in MN",
     .columns = with(plain, {{"Thrust [MN]", Channel::thrust, 1e6, 4}, {"Torque [kNm]", Channel::torque, 1e3, 1}})},
    {.name = "milliseconds",
     .columns = plain,
     .time_name = "Time [ms]",
     .time = [](double t, char) { return number(t * 1e3, 0); }},
    {.name = "minutes",
     .columns = plain,
     .time_name = "Time [min]",
     .time = [](double t, char mark) { return number(t / 60.0, 7, mark); }},
    {.name = "seconds that do not begin at 0",
     .columns = plain,
     .time = [](double t, char) { return number(t + 1234.5, 2); }},
    {.name = "clock", .columns = plain, .time_name = "Uhrzeit", .time = clock_from(morning)},
    {.name = "clock with decimal commas",
     .columns = plain,
     .time_name = "Uhrzeit",
     .time = clock_from(morning, 3),
     .separator = ";",
     .mark = ','},
    {.name = "clock across midnight", .columns = plain, .time_name = "UTC", .time = clock_from(before_midnight)},
    {.name = "clock of twelve hours across noon",
     .columns = plain,
     .time_name = "Time",
     .time = clock_from(43200.0 - 60.0, 2, true)},
    {.name = "clock as a number",
     .columns = plain,
     .time_name = "UTC",
     .time =
         [](double t, char) {
           const double s = morning + t;
           const double hours = std::floor(s / 3600.0), minutes = std::floor(s / 60.0) - 60.0 * hours;
           return number(hours * 10000.0 + minutes * 100.0 + std::fmod(s, 60.0), 1);
         }},
    {.name = "ISO 8601 in UTC", .columns = plain, .time_name = "timestamp", .time = after("2024-03-12T", morning, "Z")},
    {.name = "ISO 8601 with a zone",
     .columns = plain,
     .time_name = "timestamp",
     .time = after("2024-03-12T", morning, "+02:00")},
    {.name = "German dates",
     .columns = plain,
     .time_name = "Zeitstempel",
     .time = after("12.03.2024 ", morning),
     .separator = ";",
     .mark = ','},
    {.name = "American dates", .columns = plain, .time_name = "Date/Time", .time = after("3/13/2024 ", morning)},
    {.name = "British dates", .columns = plain, .time_name = "Date/Time", .time = after("13/03/2024 ", morning)},
    {.name = "dates whose order midnight tells",
     .columns = plain,
     .time_name = "Date Time",
     .time = two_days("04/03/2024 ", "05/03/2024 ")},
    {.name = "dates with names of months",
     .columns = plain,
     .time_name = "Time",
     .time = after("12-Mar-2024 ", morning)},
    {.name = "days of a spreadsheet",
     .columns = plain,
     .time_name = "Time",
     .time = [](double t, char) { return number(45363.35 + t / 86400.0, 9); }},
    {.name = "parts of a day",
     .columns = plain,
     .time_name = "Time",
     .time = [](double t, char) { return number(0.35 + t / 86400.0, 9); }},
    {.name = "seconds since 1970",
     .columns = plain,
     .time_name = "unix time",
     .time = [](double t, char) { return number(1710232194.0 + t, 2); }},
    {.name = "milliseconds since 1970",
     .columns = plain,
     .time_name = "Time",
     .time = [](double t, char) { return number(1710232194000.0 + 1e3 * t, 0); }},
};

TEST_CASE("every dialect comes back within half a step of its last digit", "[core][import][round-trip]") {
  CHECK(dialects.size() >= 40);
  for (const auto& dialect : dialects) test::check_dialect(dialect);
}

TEST_CASE("an instant is known where date and zone are", "[core][import]") {
  const auto start_of = [](const std::string& name, std::function<std::string(double, char)> time,
                           const std::string& map = "") {
    const auto run =
        test::recording_of(
            test::imported({test::text_of({.columns = plain, .time_name = name, .time = std::move(time)})}, map))
            .recording;
    for (const auto& [key, value] : run.facts.remarks)
      if (key == "start_utc") return value;
    return std::string{};
  };
  CHECK(start_of("timestamp", after("2024-03-12T", morning, "Z")) == "\"2024-03-12T08:29:54Z\"");
  CHECK(start_of("timestamp", after("2024-03-12T", morning, "+02:00")) == "\"2024-03-12T06:29:54Z\"");
  CHECK(start_of("UTC", after("2024-03-12 ", morning)) == "\"2024-03-12T08:29:54Z\"");
  CHECK(start_of("Time", after("2024-03-12 ", morning)).empty());
  CHECK(start_of("Time", after("2024-03-12 ", morning), "time_zone = \"+01:00\"") == "\"2024-03-12T07:29:54Z\"");
  CHECK(start_of("Time (UTC+2)", after("2024-03-12 ", morning)) == "\"2024-03-12T06:29:54Z\"");
  CHECK(start_of("Uhrzeit (MEZ)", after("12.03.2024 ", morning)) == "\"2024-03-12T07:29:54Z\"");
  CHECK(start_of("UTC", clock_from(morning)).empty());
  CHECK(start_of("UTC", clock_from(morning), "[time]\norigin = \"2024-02-29\"") == "\"2024-02-29T08:29:54Z\"");
  CHECK(start_of("t", [](double t, char) { return number(1710232194.0 + t, 1); }) == "\"2024-03-12T08:29:54Z\"");
}

TEST_CASE("date and time of a spreadsheet may stand in two columns as numbers", "[core][import]") {
  const RawColumn part_of_day{
      "Time", Channel::psi,
      1.0,    9,
      "",     [](double t, char) { return number(std::fmod(before_midnight + t, 86400.0) / 86400.0, 9); }};
  const auto text =
      test::text_of({.columns = with({part_of_day}, plain), .time_name = "Date", .time = [](double t, char) {
                       return number(t < 61.0 ? 45363.0 : 45364.0, 0);
                     }});
  const auto import = test::imported({text}, "time_zone = \"Z\"");
  const auto run = test::recording_of(import).recording;
  REQUIRE(run.samples() == test::samples);
  CHECK(std::abs(run.time.back() - test::step * static_cast<double>(test::samples - 1)) < 2e-3);
  CHECK_THAT(import.text, ContainsSubstring("# start_utc = \"2024-03-12T23:58:59Z\""));
}

TEST_CASE("date and time may stand in two columns", "[core][import]") {
  std::string text = "Datum;Uhrzeit;Kurs [°];Ruder [°]\n";
  for (std::size_t i = 0; i < test::samples; ++i) {
    const double t = test::step * static_cast<double>(i);
    text += (t < 61.0 ? "31.12.2023;" : "01.01.2024;") + clock_from(before_midnight)(t, ',') + ";" +
            test::cell_of({"", Channel::psi, deg, 1}, t, ',') + ";" +
            test::cell_of({"", Channel::delta, deg, 1}, t, ',') + "\n";
  }
  const auto import = test::imported({text}, "time_zone = \"Z\"");
  const auto [run, warnings] = test::recording_of(import);
  CHECK(warnings.empty());
  REQUIRE(run.samples() == test::samples);
  CHECK(run.time.back() == test::step * static_cast<double>(test::samples - 1));
  CHECK_THAT(import.text, ContainsSubstring("# start_utc = \"2023-12-31T23:58:59Z\""));
}

}  // namespace
}  // namespace swayaw
