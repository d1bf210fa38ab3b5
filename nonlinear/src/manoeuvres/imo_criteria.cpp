#include "swayaw/nonlinear/manoeuvres/imo_criteria.hpp"

#include <algorithm>
#include <cmath>

#include "swayaw/core/angle.hpp"

namespace swayaw::inline nonlinear {
namespace {

Criterion judged(std::string_view name, Side side, const std::optional<double>& value, double limit,
                 std::string_view unit) {
  Criterion result{.name = name, .side = side, .value = value, .limit = limit, .unit = unit, .pass = {}};
  if (value) result.pass = *value <= limit;
  return result;
}

Criterion length_criterion(std::string_view name, Side side, const std::optional<double>& metres, double limit,
                           double L) {
  return judged(name, side, metres ? std::optional(*metres / L) : std::nullopt, limit, "L");
}

Criterion overshoot_criterion(std::string_view name, const Zigzag& zigzag, std::size_t which, Side side, double limit) {
  std::optional<double> value;
  if (which < zigzag.reversals.size() && zigzag.reversals[which].overshoot)
    value = degrees(*zigzag.reversals[which].overshoot);
  return judged(name, side, value, degrees(limit), "deg");
}

constexpr bool same(double a, double b) { return a - b < 1e-9 && b - a < 1e-9; }

constexpr double longest_initial_turning = 2.5;  // L

void append(std::vector<Criterion>& all, const std::vector<Criterion>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

double first_overshoot_limit(double L_over_V) { return radians(std::clamp(5.0 + 0.5 * L_over_V, 10.0, 20.0)); }

double second_overshoot_limit(double L_over_V) { return radians(std::clamp(17.5 + 0.75 * L_over_V, 25.0, 40.0)); }

double turning_rudder(const Ship& ship) { return std::min(radians(35.0), steering_gear(ship).max_angle); }

std::vector<Criterion> criteria_of(const Zigzag& zigzag, const ZigzagOrder& order, double L) {
  const double L_over_V = L / zigzag.approach_speed;
  const auto is = [&](double angle) {
    return same(order.rudder, radians(angle)) && same(order.heading, radians(angle));
  };
  if (is(10.0))
    return {length_criterion("initial_turning", order.first, zigzag.initial_turning, longest_initial_turning, L),
            overshoot_criterion("first_overshoot_10_10", zigzag, 0, order.first, first_overshoot_limit(L_over_V)),
            overshoot_criterion("second_overshoot_10_10", zigzag, 1, order.first, second_overshoot_limit(L_over_V))};
  if (is(20.0)) return {overshoot_criterion("first_overshoot_20_20", zigzag, 0, order.first, radians(25.0))};
  return {};
}

std::vector<Criterion> criteria_of(const TurningCircle& circle, const TurnOrder& order, double L,
                                   double turning_rudder) {
  std::vector<Criterion> result;
  if (same(order.rudder, turning_rudder)) {
    result.push_back(length_criterion("advance", order.side, circle.advance, 4.5, L));
    result.push_back(length_criterion("tactical_diameter", order.side, circle.tactical_diameter, 5.0, L));
  }
  if (same(order.rudder, radians(10.0)))
    result.push_back(
        length_criterion("initial_turning", order.side, circle.initial_turning, longest_initial_turning, L));
  return result;
}

ImoCriteria imo_criteria(const Ship& ship, const ManoeuvreOptions& options) {
  ManoeuvreOptions sampled = options, bare = options;
  sampled.duration = bare.duration = std::nullopt;
  sampled.sampled = true;  // for the way made
  bare.sampled = false;
  ImoCriteria result{
      .criteria = {}, .L = length(ship), .speed = options.speed.value_or(service_speed(ship)), .propulsion = {}};
  for (const Side side : {Side::starboard, Side::port}) {
    const TurnOrder turn{turning_rudder(ship), side};
    const ZigzagOrder ten{radians(10.0), radians(10.0), side}, twenty{radians(20.0), radians(20.0), side};
    const auto circle = turning_circle(ship, turn, bare);
    append(result.criteria, criteria_of(circle, turn, result.L, turn.rudder));
    append(result.criteria, criteria_of(zigzag(ship, ten, sampled), ten, result.L));
    append(result.criteria, criteria_of(zigzag(ship, twenty, bare), twenty, result.L));
    result.propulsion = circle.propulsion;
  }
  for (auto& c : result.criteria) c.pass = c.pass.value_or(false);
  return result;
}

}  // namespace swayaw::nonlinear
