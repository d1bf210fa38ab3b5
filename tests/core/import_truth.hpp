#pragma once

#include <algorithm>
#include <catch.hpp>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "files.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/import.hpp"
#include "swayaw/core/recording_csv.hpp"
#include "swayaw/core/refusal.hpp"

/// A zigzag in closed form, written in the dialects of loggers and spreadsheets.
namespace swayaw::test {

inline constexpr double deg = pi / 180.0, kn = 1852.0 / 3600.0, start_latitude = 53.5, start_longitude = 9.9;
inline constexpr std::size_t samples = 240;
inline constexpr double step = 0.5;  // s

/// What an ideal instrument shows at time t, in SI; the heading passes north.
inline double truth(Channel channel, double t) {
  const double w = 2.0 * pi / 80.0, swing = 25.0 * deg;
  switch (channel) {
    case Channel::psi: return 2.0 * deg + swing * std::sin(w * t);
    case Channel::r: return swing * w * std::cos(w * t);
    case Channel::delta: return 20.0 * deg * std::sin(w * t + 0.9);
    case Channel::delta_order: return 20.0 * deg * std::sin(w * t + 1.2);
    case Channel::speed_over_ground: return 7.2 + 0.4 * std::cos(2.0 * w * t);
    case Channel::speed_through_water: return 7.0 + 0.4 * std::cos(2.0 * w * t);
    case Channel::course_over_ground: return truth(Channel::psi, t) - 3.0 * deg * std::cos(w * t);
    case Channel::x: return 7.0 * t;
    case Channel::y: return 40.0 * std::sin(w * t);
    case Channel::u: return 6.9 + 0.3 * std::cos(2.0 * w * t);
    case Channel::v: return -0.8 * std::cos(w * t);
    case Channel::rev: return 1.6 + 0.01 * std::sin(w * t);
    case Channel::phi: return 4.0 * deg * std::sin(w * t + 0.3);
    case Channel::thrust: return 4.2e5 + 3e4 * std::sin(w * t);
    case Channel::torque: return 3.1e5 + 2e4 * std::sin(w * t);
    case Channel::wind_speed: return 8.0 + std::sin(w * t);
    case Channel::wind_from: return 200.0 * deg + 0.1 * std::sin(w * t);
    case Channel::depth: return 18.0 + std::sin(w * t);
    default: return 0.0;
  }
}

/// 53.5 degrees north and metres north of it, on the ellipsoid WGS 84.
inline double latitude(double t) {
  constexpr double a = 6378137.0, e2 = 0.00669437999014;
  const double s = std::sin(start_latitude * deg);
  const double meridian_radius = a * (1.0 - e2) / std::pow(1.0 - e2 * s * s, 1.5);
  return start_latitude + truth(Channel::x, t) / meridian_radius / deg;
}

inline double longitude(double t) {
  constexpr double a = 6378137.0, e2 = 0.00669437999014;
  const double s = std::sin(start_latitude * deg);
  const double circle_radius = a / std::sqrt(1.0 - e2 * s * s) * std::cos(start_latitude * deg);
  return start_longitude + truth(Channel::y, t) / circle_radius / deg;
}

inline std::string number(double value, int decimals, char mark = '.') {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  std::string result(text);
  std::ranges::replace(result, '.', mark);
  return result;
}

/// A column of a raw file.
struct RawColumn {
  std::string name;
  Channel channel;
  double unit;  ///< in SI
  int decimals;
  std::string units_cell = {};                         ///< of a row of units
  std::function<std::string(double, char)> cell = {};  ///< in place of the number
};

inline double shown_value(const RawColumn& c, double t) {
  double value = truth(c.channel, t) / c.unit;
  const bool wrapped = c.channel == Channel::psi || c.channel == Channel::course_over_ground;
  const double turn = 2.0 * pi / c.unit;
  if (wrapped) value = std::fmod(value + turn, turn);
  return value;
}

inline std::string cell_of(const RawColumn& c, double t, char mark) {
  return c.cell ? c.cell(t, mark) : number(shown_value(c, t), c.decimals, mark);
}

/// A raw file in the making.
struct Dialect {
  std::string name;
  std::vector<RawColumn> columns;
  std::string time_name = "Time [s]";
  std::function<std::string(double, char)> time = [](double t, char point) { return number(t, 1, point); };
  std::string separator = ",";
  char mark = '.';
  std::string line_end = "\n";
  std::string preamble = {};
  std::string row_end = {};     ///< such as a separator behind the last cell
  std::string name_end = {};    ///< the same of the row of names
  std::string time_units = {};  ///< cell of the row of units, which is written if any column has one
  std::string map = {};         ///< column map
  std::function<std::string(const std::string&)> encode = {};
  std::size_t still_rows = 0;  ///< before the manoeuvre
  bool quotes = false;
  std::string between = {};  ///< line put in after the hundredth row
};

inline std::string quoted(const Dialect& d, const std::string& cell) { return d.quotes ? '"' + cell + '"' : cell; }

inline std::string text_of(const Dialect& d) {
  std::string names = quoted(d, d.time_name), units = d.time_units, rows;
  bool has_units = !d.time_units.empty();
  for (const auto& c : d.columns) {
    names += d.separator + quoted(d, c.name);
    units += d.separator + c.units_cell;
    has_units = has_units || !c.units_cell.empty();
  }
  for (std::size_t i = 0; i < d.still_rows + samples; ++i) {
    // the ship waits at the state of time 0
    const double t = step * static_cast<double>(i),
                 motion = std::max(0.0, t - step * static_cast<double>(d.still_rows));
    rows += quoted(d, d.time(t, d.mark));
    for (const auto& c : d.columns) rows += d.separator + quoted(d, cell_of(c, motion, d.mark));
    rows += d.row_end + d.line_end;
    if (i == 100) rows += d.between;
  }
  const auto text =
      d.preamble + names + d.name_end + d.line_end + (has_units ? units + d.name_end + d.line_end : "") + rows;
  return d.encode ? d.encode(text) : text;
}

/// An import of texts by way of files in a folder of their own.
inline Import imported(const std::vector<std::string>& texts, const std::string& map = {}) {
  const Scratch scratch;
  std::vector<std::filesystem::path> files;
  for (const auto& text : texts) {
    files.push_back(scratch / (files.empty() ? "log.csv" : "log" + std::to_string(files.size() + 1) + ".csv"));
    write_text(files.back(), text);
  }
  ImportOptions options;
  if (!map.empty()) write_text(options.column_map = scratch / "map.toml", map);
  return import_table(files, options);
}

/// The line that an import is refused with, without the folder; empty if it is not.
inline std::string import_refusal(const std::vector<std::string>& texts, const std::string& map = {}) {
  try {
    imported(texts, map);
    return {};
  } catch (const FileError& error) {
    const std::string what = error.what();
    return what.substr(what.substr(0, what.find(':')).rfind('/') + 1);
  }
}

inline RecordingFile recording_of(const Import& import) { return parse_recording(import.text, "run.csv"); }

/// Whether a channel came back within half a step of its last digit.
inline void check_channel(const Recording& run, const RawColumn& c, std::size_t still_rows) {
  const auto values = run[c.channel];
  INFO(c.name << " as " << column_name(c.channel));
  REQUIRE(values.size() == run.samples());
  const bool position = c.channel == Channel::x || c.channel == Channel::y;
  // the plane about the first fix departs from the ellipsoid by centimetres
  const double tolerance = position ? 0.5 : 0.5000001 * std::pow(10.0, -c.decimals) * c.unit + 1e-12;
  double worst = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double t = step * (i < still_rows ? 0.0 : static_cast<double>(i - still_rows));
    const double error = values[i] - truth(c.channel, t);
    worst = std::max(worst, is_direction(c.channel) ? std::abs(std::remainder(error, 2.0 * pi)) : std::abs(error));
  }
  CHECK(worst <= tolerance);
}

/// The dialect is understood, and read without a warning.
inline Import check_dialect(const Dialect& d) {
  INFO(d.name);
  const auto import = imported({text_of(d)}, d.map);
  const auto [run, warnings] = recording_of(import);
  INFO(import.text.substr(0, 2000));
  CHECK(warnings.empty());
  REQUIRE(run.samples() == samples + d.still_rows);
  for (std::size_t i = 0; i < run.samples(); ++i) REQUIRE(std::abs(run.time[i] - step * static_cast<double>(i)) < 2e-3);
  for (const auto& c : d.columns) check_channel(run, c, d.still_rows);
  return import;
}

}  // namespace swayaw::test
