#include "page_writing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/channel_table.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/core/version.hpp"
#include "terminal.hpp"
#include "user_units.hpp"

namespace swayaw::app {
namespace {

/// Rows of the table beside a picture: as many as can be read at a glance.
constexpr std::size_t most_rows = 13;

std::string heading_of(const Axis& axis, const std::string& name) {
  const auto unit = axis.unit.empty() ? "" : ", " + axis.unit;
  return (name.empty() ? axis.quantity : name) + unit;
}

/// Values of a curve at an abscissa, by the nearest point.
double at(const Curve& curve, double x) {
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < curve.x.size(); ++i)
    if (std::abs(curve.x[i] - x) < std::abs(curve.x[nearest] - x)) nearest = i;
  return curve.y[nearest];
}

/// Points of the named curves of a panel, as many of each: of tracks, which cross themselves.
PageTable points_of(const std::string& caption, const Panel& panel, const std::vector<const Curve*>& named) {
  PageTable table{.caption = caption, .columns = {"Share of the run"}, .rows = {}};
  for (const auto* curve : named)
    for (const auto* axis : {&panel.x, &panel.y}) table.columns.push_back(curve->name + ", " + heading_of(*axis, ""));
  for (std::size_t k = 0; k < most_rows; ++k) {
    std::vector<PageCell> row{percent_of(static_cast<double>(k) / (most_rows - 1))};
    for (const auto* curve : named) {
      const auto i = k * (curve->x.size() - 1) / (most_rows - 1);
      row.emplace_back(with_error(curve->x[i])), row.emplace_back(with_error(curve->y[i]));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// The named curves of the first panel, row by row over its abscissa.
PageTable numbers_of(const Plot& plot) {
  PageTable table{.caption = plot.title, .columns = {}, .rows = {}};
  const auto& panel = plot.panels.front();
  std::vector<const Curve*> named;
  for (const auto& curve : panel.curves)
    if (!curve.name.empty() && !curve.x.empty()) named.push_back(&curve);
  if (named.empty()) return table;
  if (panel.same_scale) return points_of(plot.title, panel, named);
  table.columns.push_back(heading_of(panel.x, ""));
  for (const auto* curve : named) table.columns.push_back(heading_of(panel.y, curve->name));
  const auto& x = named.front()->x;
  for (std::size_t k = 0; k < most_rows; ++k) {
    const double place = x[k * (x.size() - 1) / (most_rows - 1)];
    std::vector<PageCell> row{with_error(place)};
    for (const auto* curve : named) row.emplace_back(with_error(at(*curve, place)));
    table.rows.push_back(std::move(row));
    if (x.size() < most_rows && k + 1 == x.size()) break;
  }
  return table;
}

/// Bow, shoulders and stern seen from above, forward and starboard in ship lengths.
constexpr std::array<std::array<double, 2>, 6> outline{
    {{0.5, 0.0}, {0.3, 0.085}, {-0.5, 0.085}, {-0.5, -0.085}, {0.3, -0.085}, {0.5, 0.0}}};

Curve hull_at(double x, double y, double psi, double L, const char* colour) {
  Curve hull{.name = {}, .x = {}, .y = {}, .stroke = {.colour = colour, .width = 1.0}};
  for (const auto& [ahead, starboard] : outline) {
    hull.x.push_back(y + L * (ahead * std::sin(psi) + starboard * std::cos(psi)));
    hull.y.push_back(x + L * (ahead * std::cos(psi) - starboard * std::sin(psi)));
  }
  return hull;
}

/// An arrow that points where the wind blows, in the corner to the north-west.
Curve wind_arrow(const std::vector<Curve>& tracks, double from) {
  double west = HUGE_VAL, east = -HUGE_VAL, south = HUGE_VAL, north = -HUGE_VAL;
  for (const auto& track : tracks)
    for (std::size_t i = 0; i < track.x.size(); ++i) {
      if (!std::isfinite(track.x[i]) || !std::isfinite(track.y[i])) continue;
      west = std::min(west, track.x[i]), east = std::max(east, track.x[i]);
      south = std::min(south, track.y[i]), north = std::max(north, track.y[i]);
    }
  const double size = 0.12 * std::max(east - west, north - south), x0 = west, y0 = north;
  const double to = from + pi, sine = std::sin(to), cosine = std::cos(to);
  const auto point = [&](double along, double across) {
    return std::array{x0 + size * (along * sine + across * cosine), y0 + size * (along * cosine - across * sine)};
  };
  Curve arrow{.name = "wind", .x = {}, .y = {}, .stroke = {.colour = ink::line, .width = 2.0}};
  for (const auto& [x, y] : {point(-0.5, 0.0), point(0.5, 0.0), point(0.2, 0.15), point(0.5, 0.0), point(0.2, -0.15)})
    arrow.x.push_back(x), arrow.y.push_back(y);
  return arrow;
}

/// Distance of marks, 1, 2 or 5 of a power of ten, of which no more than four stand on the longer side of all
/// tracks: the labels of more run into each other on a phone.
double mark_distance(const std::vector<Curve>& tracks) {
  double span = 0.0;
  for (const auto values : {&Curve::x, &Curve::y}) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const auto& track : tracks)
      for (const double value : track.*values)
        if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
    span = std::max(span, high - low);
  }
  if (!(span > 0.0)) return 0.0;
  const double ten = std::pow(10.0, std::floor(std::log10(span / 3.0))), ratio = span / 3.0 / ten;
  return ten * (ratio < 1.2 ? 1.0 : ratio < 2.4 ? 2.0 : ratio < 6.0 ? 5.0 : 10.0);
}

/// An axis in degrees, and what is drawn over it, in radians.
void put_in_radians(Panel& panel, Axis Panel::*axis, std::vector<double> Curve::*values) {
  auto& [quantity, unit, logarithmic, tick] = panel.*axis;
  if (unit != "deg" && unit != "deg/s") return;
  unit = unit == "deg" ? "rad" : "rad/s";
  tick = 0.0;  // marks of degrees are none of radians
  for (auto& curve : panel.curves)
    for (double& value : curve.*values) value = radians(value);
}

void put_in_radians(Plot& plot) {
  for (auto& panel : plot.panels) {
    put_in_radians(panel, &Panel::x, &Curve::x);
    put_in_radians(panel, &Panel::y, &Curve::y);
  }
}

bool is_in_degrees(Channel channel) {
  const auto dimension = dimension_of(channel);
  return dimension == Dimension::angle || dimension == Dimension::bearing || dimension == Dimension::yaw_rate;
}

}  // namespace

PagePicture picture_of(Plot plot, std::string words, std::string caption, const UserUnits& units, int height) {
  if (units.si()) put_in_radians(plot);
  PagePicture picture{.words = std::move(words), .svg = {}, .caption = std::move(caption), .numbers = numbers_of(plot)};
  // so narrow that its words can be read on a phone
  plot.width = 560, plot.height_of_panel = height, plot.height_of_rest = 60;
  static bool said = false;
  try {
    picture.svg = svg_of(plot);
  } catch (const Refusal& without) {
    if (!std::exchange(said, true)) say_aside("swayaw: the page has no pictures: {}\n", without.what());
  }
  return picture;
}

Panel track_panel(std::vector<Curve> tracks, double wind_from) {
  if (std::isfinite(wind_from)) tracks.push_back(wind_arrow(tracks, wind_from));
  const double tick = mark_distance(tracks);
  return {.x = {.quantity = "East", .unit = "m", .tick = tick},
          .y = {.quantity = "North", .unit = "m", .tick = tick},
          .curves = std::move(tracks),
          .same_scale = true};
}

Curve track_of(const Recording& run, std::string name, Stroke stroke) {
  Curve track{.name = std::move(name), .x = {}, .y = {}, .stroke = stroke};
  if (!run.has(Channel::x) || !run.has(Channel::y)) return track;
  track.x.assign(run[Channel::y].begin(), run[Channel::y].end());
  track.y.assign(run[Channel::x].begin(), run[Channel::x].end());
  return track;
}

std::vector<Curve> hulls_along(const Recording& run, double L, const char* colour) {
  std::vector<Curve> hulls;
  if (!run.has(Channel::x) || !run.has(Channel::y) || !run.has(Channel::psi) || !(L > 0.0)) return hulls;
  const auto x = run[Channel::x], y = run[Channel::y], psi = run[Channel::psi];
  double way = 0.0, whole = 0.0;
  std::vector<double> steps(run.samples(), 0.0);
  std::size_t last = run.samples();
  for (std::size_t i = 0; i < run.samples(); ++i) {
    if (std::isnan(x[i] + y[i] + psi[i])) continue;
    if (last < i) whole += steps[i] = std::hypot(x[i] - x[last], y[i] - y[last]);
    last = i;
  }
  const double apart = std::max(2.0 * L, whole / 12.0);
  way = apart;
  for (std::size_t i = 0; i < run.samples(); ++i) {
    if (std::isnan(x[i] + y[i] + psi[i])) continue;
    if ((way += steps[i]) < apart) continue;
    way = 0.0;
    hulls.push_back(hull_at(x[i], y[i], psi[i], L, colour));
  }
  return hulls;
}

Curve over_time(const Recording& run, Channel channel, std::string name, Stroke stroke) {
  Curve curve{.name = std::move(name), .x = {}, .y = {}, .stroke = stroke};
  if (!run.has(channel)) return curve;
  const double one = is_in_degrees(channel) ? radians(1.0) : 1.0;
  curve.x = run.time;
  for (const double value : run[channel]) curve.y.push_back(value / one);
  return curve;
}

void write_page(const std::filesystem::path& file, const std::string& html) {
  write_text(file, html);
  say_aside("swayaw: report written to {}\n", file.string());
}

std::string made_by() { return fmt::format("Made by swayaw {}.", version()); }

}  // namespace swayaw::app
