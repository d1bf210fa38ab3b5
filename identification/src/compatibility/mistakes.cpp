#include "mistakes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "relations.hpp"
#include "run_motion.hpp"
#include "swayaw/core/channel_table.hpp"

namespace swayaw::inline identification::detail {
namespace {

using Kind = InstrumentErrorKind;

using core::detail::degree;
using core::detail::knot;

/// Changes of a series over blocks of time: what is slow and large, without noise.
std::vector<double> changes(const std::vector<double>& f, std::size_t blocks) {
  std::vector<double> result;
  for (std::size_t b = 1; b <= blocks; ++b)
    result.push_back(f[b * (f.size() - 1) / blocks] - f[(b - 1) * (f.size() - 1) / blocks]);
  return result;
}

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// a ≈ factor b, and how well: the cosine between them.
struct Proportion {
  double factor;
  double cosine;
};

Proportion proportion(const std::vector<double>& a, const std::vector<double>& b) {
  const double ab = dot(a, b), aa = dot(a, a), bb = dot(b, b);
  if (!(aa > 0.0) || !(bb > 0.0)) return {1.0, 0.0};
  const double cosine = ab / std::sqrt(aa * bb);
  return {std::sqrt(aa / bb) * (ab < 0.0 ? -1.0 : 1.0), std::abs(cosine)};
}

/// The factor of those that is meant by a measured one; 1 where none is.
double meant(double measured, std::span<const double> factors) {
  constexpr double near = 1.3;  // a factor may be off by scale and noise; the nearest two units differ by 1.85
  for (const double f : factors)
    if (std::abs(std::log(measured / f)) < std::log(near)) return f;
  return 1.0;
}

constexpr std::size_t blocks = 40;  // of a manoeuvre: a few seconds to a minute each
constexpr double clear = 0.9;       // cosine from which two series are the same but for a factor
constexpr std::array angle_units{1.0 / degree, degree, 60.0, 1.0 / 60.0, 60.0 / degree, degree / 60.0};
constexpr std::array speed_units{1.0 / knot, knot, 3.6, 1.0 / 3.6};

void put(std::vector<InstrumentError>& found, Channel channel, Kind kind, double value) {
  found.push_back({.channel = channel, .kind = kind, .value = value, .standard_error = 0.0, .told = true});
}

/// Heading against integrated yaw rate. Which of the two is wrong is told by its size.
void check_heading(const Recording& run, std::vector<InstrumentError>& found) {
  constexpr double degrees_called_radians = 4.0 * pi;           // [rad]: two turns, which few manoeuvres make
  constexpr double radians_called_degrees = 2.0 * pi * degree;  // [rad]: all headings lie below
  if (!run.has(Channel::r)) return;
  const auto psi = filled(run, Channel::psi), r = filled(run, Channel::r);
  const auto [factor, cosine] = proportion(changes(psi, blocks), changes(integral(run.time, r), blocks));
  if (cosine < clear) return;
  if (factor < 0.0) put(found, Channel::r, Kind::sign, -1.0);
  const double unit = meant(std::abs(factor), angle_units);
  if (unit == 1.0) return;
  const auto [low, high] = std::ranges::minmax(psi);
  const bool heading = unit > 1.0 ? high - low > degrees_called_radians : std::max(-low, high) < radians_called_degrees;
  if (heading) put(found, Channel::psi, Kind::unit, unit);
  else put(found, Channel::r, Kind::unit, 1.0 / unit);
}

/// Heading and yaw rate, both in degrees: against the course over ground of the track.
double course_factor(const Recording& run) {
  const auto x = filled(run, Channel::x), y = filled(run, Channel::y), psi = filled(run, Channel::psi);
  const auto dx = changes(x, blocks), dy = changes(y, blocks);
  std::vector<double> course(blocks);
  for (std::size_t b = 0; b < blocks; ++b)
    course[b] = b > 0 ? unwrapped(std::atan2(dy[b], dx[b]), course[b - 1]) : std::atan2(dy[b], dx[b]);
  std::vector<double> heading(blocks);
  for (std::size_t b = 0; b < blocks; ++b) heading[b] = psi[(2 * b + 1) * (psi.size() - 1) / (2 * blocks)];
  const auto [factor, cosine] = proportion(changes(heading, blocks - 1), changes(course, blocks - 1));
  return cosine > 0.7 ? factor : 1.0;
}

/// Radians called degrees: no ship that changes her course by 20 deg and more does so with a rudder of one, nor answers
/// a degree of it with half a degree of heading in each second.
bool answers_too_strongly(const Recording& run, const std::vector<double>& delta, double largest) {
  constexpr double too_small = 0.0125;  // [rad]: 41 deg, taken for radians called degrees
  constexpr double manoeuvre = 0.5;     // [rad] of heading: less than a zigzag 10/10
  constexpr double strongest = 0.5;     // [1/s]: a model of 2 m has a gain K of 0.3
  const auto psi = filled(run, Channel::psi);
  const auto [low, high] = std::ranges::minmax(psi);
  if (largest > too_small || high - low < manoeuvre) return false;
  return rms(changes(psi, blocks)) > strongest * rms(changes(integral(run.time, delta), blocks));
}

void check_angles(const Recording& run, std::vector<InstrumentError>& found) {
  constexpr double hard_over = 1.6;  // [rad]: no rudder goes beyond 90 deg
  for (const Channel rudder : {Channel::delta, Channel::delta_order}) {
    if (!run.has(rudder)) continue;
    const auto delta = filled(run, rudder);
    const double largest = std::abs(std::ranges::max(delta, {}, [](double d) { return std::abs(d); }));
    if (largest > hard_over) put(found, rudder, Kind::unit, 1.0 / degree);
    else if (answers_too_strongly(run, delta, largest)) put(found, rudder, Kind::unit, degree);
  }
}

/// Way by positions and by a velocity, as pairs (x, y) of blocks.
struct Ways {
  std::vector<double> track, reckoned;
};

struct Turned {
  double u = 1.0, v = 1.0, y = 1.0;
  bool exchanged = false;  ///< x and y
};

Ways ways(const Recording& run, Channel surge, Channel sway, const Turned& turned) {
  const auto psi = filled(run, Channel::psi), u = filled(run, surge);
  const auto v = run.has(sway) ? filled(run, sway) : std::vector<double>(run.samples(), 0.0);
  std::vector<double> V_x(run.samples()), V_y(run.samples());
  for (std::size_t i = 0; i < run.samples(); ++i) {
    V_x[i] = turned.u * u[i] * std::cos(psi[i]) - turned.v * v[i] * std::sin(psi[i]);
    V_y[i] = turned.u * u[i] * std::sin(psi[i]) + turned.v * v[i] * std::cos(psi[i]);
  }
  Ways w;
  const auto append = [](std::vector<double>& to, const std::vector<double>& more, double factor) {
    for (const double x : more) to.push_back(factor * x);
  };
  append(w.track, changes(filled(run, turned.exchanged ? Channel::y : Channel::x), blocks), 1.0);
  append(w.track, changes(filled(run, turned.exchanged ? Channel::x : Channel::y), blocks), turned.y);
  append(w.reckoned, changes(integral(run.time, V_x), blocks), 1.0);
  append(w.reckoned, changes(integral(run.time, V_y), blocks), 1.0);
  return w;
}

double cosine_of(const Recording& run, Channel surge, Channel sway, const Turned& turned) {
  const auto w = ways(run, surge, sway, turned);
  const auto p = proportion(w.reckoned, w.track);
  return p.factor > 0.0 ? p.cosine : -p.cosine;
}

/// Axes of the positions: as they are, y to port, or x and y exchanged, whichever the way by heading and speed fits far
/// better than the others.
void check_axes(const Recording& run, Channel surge, Channel sway, std::vector<InstrumentError>& found) {
  constexpr double far = 0.1;  // of the cosine: a track that current and noise spoil loses less
  const double as_it_is = cosine_of(run, surge, sway, {});
  const double mirrored = cosine_of(run, surge, sway, {.y = -1.0});
  const double exchanged = cosine_of(run, surge, sway, {.exchanged = true});
  if (mirrored > clear && mirrored > std::max(as_it_is, exchanged) + far) put(found, Channel::y, Kind::sign, -1.0);
  else if (exchanged > clear && exchanged > std::max(as_it_is, mirrored) + far)
    put(found, Channel::x, Kind::axes, pi / 2.0);
}

/// Sway to port: what of the way the surge leaves over is minus the way by sway.
void check_sway(const Recording& run, Channel surge, Channel sway, std::vector<InstrumentError>& found) {
  if (!run.has(sway)) return;
  const auto straight = ways(run, surge, sway, {.v = 0.0}), across = ways(run, surge, sway, {.u = 0.0});
  const double factor = proportion(straight.track, straight.reckoned).factor;
  std::vector<double> left(straight.track.size());
  for (std::size_t i = 0; i < left.size(); ++i) left[i] = straight.track[i] - factor * straight.reckoned[i];
  const auto p = proportion(left, across.reckoned);
  if (p.factor < -0.5 && p.cosine > 0.7) put(found, sway, Kind::sign, -1.0);
}

void check_speed(const Recording& run, std::vector<InstrumentError>& found) {
  for (const Channel surge : speeds_of(run)) {
    const Channel sway = surge == Channel::u_ground ? Channel::v_ground : Channel::v;
    const auto w = ways(run, surge, sway, {});
    const auto [factor, cosine] = proportion(w.reckoned, w.track);
    if (cosine < clear) continue;
    const double unit = meant(std::abs(factor), speed_units);
    if (unit != 1.0) put(found, surge, Kind::unit, unit);
    if (unit != 1.0 && surge != Channel::speed_through_water && run.has(sway)) put(found, sway, Kind::unit, unit);
    if (factor < 0.0) put(found, surge, Kind::sign, -1.0);
  }
}

/// A rudder that is there in one sample would have to move at many times the rate at which the ship turns: steering
/// gears of ships and models move at two to six times her largest yaw rate.
void check_order(const Recording& run, std::vector<InstrumentError>& found) {
  constexpr double impossible = 10.0, step_of_order = 4.0 * degree;
  if (!run.has(Channel::delta)) return;
  const auto delta = filled(run, Channel::delta);
  const double turning = hard_yaw_rate(run);
  double in_jumps = 0.0, all = 0.0, fastest = 0.0;
  for (std::size_t i = 1; i < delta.size(); ++i) {
    const double moved = std::abs(delta[i] - delta[i - 1]), rate = moved / (run.time[i] - run.time[i - 1]);
    all += moved;
    if (moved < step_of_order || rate < impossible * turning) continue;
    in_jumps += moved;
    fastest = std::max(fastest, rate);
  }
  if (all > 0.0 && in_jumps > 0.6 * all && in_jumps > 3.0 * step_of_order)
    put(found, Channel::delta, Kind::order, fastest);
}

void scale(Recording& run, Channel channel, double factor) {
  for (double& x : run.channels[index_of(channel)]) x *= factor;
}

}  // namespace

std::vector<InstrumentError> mistakes_of(const Recording& run) {
  std::vector<InstrumentError> found;
  check_angles(run, found);
  check_heading(run, found);
  auto mended = without(run, found);
  const bool track = run.has(Channel::x) && run.has(Channel::y);
  if (track) {
    // heading and yaw rate agree with each other, and both with nothing else
    if (const double unit = meant(std::abs(course_factor(mended)), angle_units); unit != 1.0) {
      put(found, Channel::psi, Kind::unit, unit);
      if (run.has(Channel::r)) put(found, Channel::r, Kind::unit, unit);
      mended = without(run, found);
    }
    if (const auto speeds = speeds_of(mended); !speeds.empty()) {
      const Channel surge = speeds.front(), sway = surge == Channel::u_ground ? Channel::v_ground : Channel::v;
      check_axes(mended, surge, sway, found);
      mended = without(run, found);
      check_sway(mended, surge, sway, found);
      check_speed(mended, found);
    }
  }
  check_order(mended, found);
  return found;
}

Recording without(Recording run, std::span<const InstrumentError> mistakes) {
  for (const auto& m : mistakes) {
    if (m.kind == Kind::unit) scale(run, m.channel, 1.0 / m.value);
    else if (m.kind == Kind::sign) scale(run, m.channel, -1.0);
    else if (m.kind == Kind::order)
      std::swap(run.channels[index_of(Channel::delta)], run.channels[index_of(Channel::delta_order)]);
    else if (m.kind == Kind::axes) std::swap(run.channels[index_of(Channel::x)], run.channels[index_of(Channel::y)]);
  }
  return run;
}

}  // namespace swayaw::identification::detail
