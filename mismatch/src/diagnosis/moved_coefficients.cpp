#include "moved_coefficients.hpp"

#include <algorithm>
#include <cmath>

#include "replay_errors.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/nonlinear/models/force_breakdown.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"

namespace swayaw::inline mismatch::detail {
namespace {

/// A coefficient of the baseline as a fit moves it.
BaselineShift shift_of(const Parameter& n, double deviations) {
  return {std::string(n.key), n.value, n.value + n.deviation * deviations, deviations, std::string(n.table)};
}

/// The coefficients of a part that a fit moves most.
std::vector<BaselineShift> most_moved(const Trial& trial, const Point& point, std::string_view part) {
  constexpr std::size_t most = 2;
  std::vector<BaselineShift> shifts;
  for (std::size_t i = 0; i < trial.parameters.size(); ++i)
    if (trial.parameters[i].table == part)
      shifts.push_back(shift_of(trial.parameters[i], point[static_cast<Eigen::Index>(i)]));
  std::ranges::sort(shifts, std::greater{}, [](const BaselineShift& s) { return std::abs(s.deviations); });
  shifts.resize(std::min(most, shifts.size()));
  return shifts;
}

/// Yaw moment of the rudder at 10 deg on a straight course at the service speed.
double rudder_moment(const Ship& ship) {
  auto controls = self_propulsion(ship, service_speed(ship));
  controls.delta = radians(10.0);
  const auto split = force_breakdown(ship, {0.0, 0.0, 0.0, {service_speed(ship), 0.0, 0.0}}, controls);
  const auto rudder = std::ranges::find(split.parts, "rudder", &ForcePart<double>::name);
  return rudder == split.parts.end() ? missing : rudder->force.N;
}

/// A point at which the coefficients of a part alone are moved.
Point moved_alone(const Trial& trial, const Point& point, std::string_view part) {
  Point alone = Point::Zero(point.size());
  for (std::size_t i = 0; i < trial.parameters.size(); ++i)
    if (trial.parameters[i].table == part) alone[static_cast<Eigen::Index>(i)] = point[static_cast<Eigen::Index>(i)];
  return alone;
}

/// Of the fall of the discrepancy that moved coefficients bring: a part is named where its own bring more than half.
constexpr double most_of_it = 0.5;

}  // namespace

std::vector<BaselineShift> shifts_of(const Trial& trial, const Point& point) {
  std::vector<BaselineShift> shifts;
  for (std::size_t i = 0; i < trial.parameters.size(); ++i) {
    const auto& n = trial.parameters[i];
    const double z = point[static_cast<Eigen::Index>(i)];
    if (std::abs(z) > 2.0) shifts.push_back(shift_of(n, z));
  }
  std::ranges::sort(shifts, std::greater{}, [](const BaselineShift& s) { return std::abs(s.deviations); });
  return shifts;
}

std::optional<double> rudder_left(const Ship& given, const Ship& moved) try {
  const double left = rudder_moment(moved) / rudder_moment(given);
  return std::isfinite(left) ? std::optional(left) : std::nullopt;
} catch (const std::exception&) {
  return std::nullopt;
}

std::optional<MovedPart> moved_part(const Trial& trial, const Point& point, const Discrepancy& all, const Ship& given,
                                    const std::vector<RunErrors>& train, std::span<const Recording> runs) {
  if (all.refitted > 0.5 * all.given) return std::nullopt;
  std::vector<std::string_view> parts;
  for (const auto& n : trial.parameters)
    if (std::ranges::count(parts, n.table) == 0) parts.push_back(n.table);
  std::optional<MovedPart> best;
  for (const auto part : parts) {
    const auto alone = moved_alone(trial, point, part);
    const auto with_it = ships_at(trial, {}, alone);
    const auto by = discrepancy_of(with_after(train, with_it, runs), {});
    if (by && (!best || by->after < best->discrepancy))
      best = MovedPart{std::string(part), by->after, most_moved(trial, point, part),
                       part == "rudder" ? rudder_left(given, model_at(trial, {}, alone)) : std::nullopt};
  }
  const bool enough = best && all.given - best->discrepancy > most_of_it * (all.given - all.refitted);
  return enough ? best : std::nullopt;
}

}  // namespace swayaw::mismatch::detail
