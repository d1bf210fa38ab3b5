#include <algorithm>
#include <array>
#include <cmath>

#include "run_motion.hpp"
#include "swayaw/core/detail/matrices.hpp"
#include "track_regression.hpp"

namespace swayaw::inline identification::detail {
namespace {

constexpr double minute = 60.0;  // [s]

/// A cause of delays and what it leaves unexplained.
struct Cause {
  InstrumentError error;
  double left;  ///< chi-squared
};

/// In words, by the sign. Velocities in earth axes that are late make positions early; velocities in axes of the hull
/// make positions and heading early. A filter of the velocities is a delay of them.
void put_readings(std::vector<std::string_view>& readings, const InstrumentError& e, Channel speed) {
  const bool late = e.value > 0.0;
  const auto put = [&](std::string_view if_late, std::string_view if_early) {
    readings.push_back(late ? if_late : if_early);
  };
  if (e.channel == Channel::psi) put("heading late", "heading early");
  if (e.channel == Channel::x) put("positions late", "positions early");
  if (e.channel == Channel::x && speed == Channel::u_ground)
    put("velocities over ground early", "velocities over ground late or filtered");
  if (e.channel != speed) return;
  put("velocities late or filtered", "velocities early");
  put("positions and heading early", "positions and heading late");
}

/// The clocks of positions, heading and velocities from how late positions and heading are against velocities: one
/// alone where that explains both,   late = tau e,  e = (1, 0), (0, 1) or (−1, −1), else positions and heading. All
/// that explain it as well are its readings.
std::vector<InstrumentError> delays_of(Channel speed, const Eigen::Vector2d& late, const Eigen::Matrix2d& C) {
  constexpr double explained = 9.0;  // chi-squared of what is left: 3 standard deviations
  constexpr double alike = 4.0;      // within which the clock of the positions is the likeliest to be wrong
  using Kind = InstrumentErrorKind;
  const Eigen::Matrix2d information = core::detail::inverse(C);
  const auto by = [&](Channel channel, const Eigen::Vector2d& e) {
    const double weight = e.dot(information * e), tau = e.dot(information * late) / weight;
    const Eigen::Vector2d left = late - tau * e;
    return Cause{{channel, Kind::delay, tau, 1.0 / std::sqrt(weight)}, left.dot(information * left)};
  };
  std::vector<Cause> causes{by(Channel::x, {1.0, 0.0}), by(Channel::psi, {0.0, 1.0}), by(speed, {-1.0, -1.0})};
  const double least = std::ranges::min(causes, {}, &Cause::left).left;
  if (least > explained) {
    InstrumentError positions{Channel::x, Kind::delay, late[0], std::sqrt(C(0, 0))};
    put_readings(positions.readings, positions, speed);
    return {positions, {Channel::psi, Kind::delay, late[1], std::sqrt(C(1, 1))}};
  }
  std::erase_if(causes, [&](const Cause& cause) { return cause.left > least + alike; });
  auto first = causes.front().error;
  for (const auto& cause : causes) put_readings(first.readings, cause.error, speed);
  return {first};
}

/// Where a clock jumps. Its size is a way over a speed: without sway the way is known to the drift of the ship.
std::vector<InstrumentError> jumps_of(const TrackFit& track, bool has_sway) {
  constexpr double drift_of_way = 0.15;  // of 148 jumps in zigzags and turns 95 % were off by less than 30 %
  std::vector<InstrumentError> found;
  Eigen::Index column = first_jump;
  for (const auto& jump : track.clock.jumps) {
    const double by_fit = std::sqrt(track.fit.covariance(column, column));
    const double standard_error = has_sway ? by_fit : std::hypot(by_fit, drift_of_way * jump.size);
    found.push_back({Channel::x, InstrumentErrorKind::jump, jump.size, standard_error, false, jump.at, jump.at_error});
    ++column;
  }
  return found;
}

/// How a clock runs, and where it jumps.
void put_clock(std::vector<InstrumentError>& found, const TrackFit& track, bool has_sway) {
  using Kind = InstrumentErrorKind;
  const auto& C = track.fit.covariance;
  const auto standard_error = [&](Eigen::Index at) { return std::sqrt(C(at, at)); };
  if (track.kind == ClockKind::wandering)
    found.push_back({Channel::x, Kind::clock, track.fit.errors.clock * std::sqrt(minute), 0.0, true});
  if (track.kind == ClockKind::steady)
    found.push_back({Channel::x, Kind::clock_rate, track.clock.rate, standard_error(drift)});
  for (const auto& jump : jumps_of(track, has_sway)) found.push_back(jump);
}

}  // namespace

std::vector<Channel> speeds_of(const Recording& run) {
  std::vector<Channel> speeds;
  if (run.has(Channel::u_ground) && run.has(Channel::v_ground)) speeds.push_back(Channel::u_ground);
  if (run.has(Channel::u)) speeds.push_back(Channel::u);
  if (run.has(Channel::speed_through_water)) speeds.push_back(Channel::speed_through_water);
  return speeds;
}

std::vector<InstrumentError> track_errors(const Recording& run, Channel speed) {
  if (!run.has(Channel::x) || !run.has(Channel::y)) return {};
  const auto source = source_of(run, speed);
  const auto track = on_likeliest_clock(run, source);
  if (!source.has_sway && !is_straight(run)) return jumps_of(track, false);
  const auto& fit = track.fit;
  const auto error = [&](Channel channel, InstrumentErrorKind kind, TrackColumn at, double value) {
    return InstrumentError{channel, kind, value, std::sqrt(fit.covariance(at, at))};
  };
  // p = p_0 + (1 + k) R(eps) I
  const double along = 1.0 + fit.beta[scale], across = fit.beta[axes];
  const double eps = std::atan2(across, along), one_more = std::hypot(along, across);
  std::vector<InstrumentError> found{
      error(speed, InstrumentErrorKind::scale, scale, 1.0 / one_more - 1.0),
      error(source.has_sway ? speed : Channel::psi, InstrumentErrorKind::axes, axes, eps)};
  put_clock(found, track, source.has_sway);
  if (track.kind != ClockKind::good) {
    constexpr double persistence = 300.0;  // [s], of the rate of the one such clock that was seen, R/V Gunnerus's
    // a clock that does not keep time may have run fast or slow for minutes: as much of the way is not known
    const double share = std::min(1.0, std::sqrt(persistence / (run.time.back() - run.time.front())));
    found[0].standard_error = std::hypot(found[0].standard_error, share * InstrumentPriors{}.drift);
  }
  if (track.kind == ClockKind::wandering) return found;
  if (!source.has_sway) return found;
  const Eigen::Vector2d late_by{track.clock.delay, fit.beta[heading_delay]};
  for (const auto& e : delays_of(speed, late_by, fit.covariance({delay, heading_delay}, {delay, heading_delay})))
    found.push_back(e);
  found.push_back(error(Channel::x, InstrumentErrorKind::lever_arm_x, lever_x, fit.beta[lever_x]));
  found.push_back(error(Channel::x, InstrumentErrorKind::lever_arm_y, lever_y, fit.beta[lever_y]));
  return found;
}

}  // namespace swayaw::identification::detail
