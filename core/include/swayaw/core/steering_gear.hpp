#pragma once

#include <array>
#include <limits>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/parameter.hpp"

namespace swayaw {

/// How the rudder follows its order delta_c:
///
///     d(delta)/dt = e/T, at most the rate, while |e| > b,   e = delta_c − delta
///     d(delta)/dt = 0                      when |e| ≤ b
template <class S = double>
struct SteeringGear {
  S rate;       ///< largest rate [rad/s]
  S max_angle;  ///< [rad]
  S lag;        ///< T [s], 0 for a rudder that keeps its rate until it arrives
  S dead_band;  ///< b [rad], 0 for none

  static constexpr auto parameters() {
    using P = Parameter<SteeringGear, S>;
    constexpr double degree = pi / 180.0;
    return std::array{
        P{.key = "rate_deg_s", .member = &SteeringGear::rate, .unit = "deg/s", .range = positive, .si = degree},
        P{.key = "max_angle_deg", .member = &SteeringGear::max_angle, .unit = "deg",
          .range = {.low = 0.0, .high = 90.0, .above_low = true}, .si = degree},
        P{.key = "lag_s", .member = &SteeringGear::lag, .unit = "s", .range = non_negative, .required = false},
        P{.key = "dead_band_deg", .member = &SteeringGear::dead_band, .unit = "deg", .range = non_negative, .si = degree, .required = false},
    };
  }
};

/// @throws std::domain_error  if an ordered angle [rad] is not positive or beyond the largest
void require_rudder(double angle, const SteeringGear<double>& gear);

/// Rudder angle over time in closed form: at its largest rate at first, then along an exponential, then at rest.
/// It holds until the next order.
class RudderMotion {
 public:
  /// From an angle at `time` at that rate, for ever.
  static RudderMotion moving(double time, double angle, double rate);

  /// From an angle at `time` towards the order, as the steering gear can.
  static RudderMotion ordered(const SteeringGear<double>& gear, double time, double angle, double order);

  double at(double time) const;

  /// First time after `time` at which the rate jumps or begins to fall; infinity if there is none.
  double next_kink(double time) const;

 private:
  static constexpr double never = std::numeric_limits<double>::infinity();

  double start_ = 0.0;      ///< [s]
  double angle_ = 0.0;      ///< at start [rad]
  double rate_ = 0.0;       ///< until slowing [rad/s]
  double slowing_ = never;  ///< when the exponential begins [s]
  double order_ = 0.0;      ///< delta_c [rad]
  double error_ = 0.0;      ///< delta_c − delta when slowing begins [rad]
  double lag_ = 0.0;        ///< T [s]
  double rest_ = never;     ///< when the rudder stops [s]
  double final_ = 0.0;      ///< angle at rest [rad]
};

}  // namespace swayaw
