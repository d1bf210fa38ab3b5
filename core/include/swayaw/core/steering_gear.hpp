#pragma once

#include <array>
#include <limits>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/parameter.hpp"
#include "swayaw/core/scalar.hpp"

namespace swayaw::inline core {

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
    using P = ParameterOf<SteeringGear, S>;
    constexpr double degree = pi / 180.0;
    return std::array{
        P{.key = "rate_deg_s", .member = &SteeringGear::rate, .unit = "deg/s", .range = positive, .si = degree},
        P{.key = "max_angle_deg",
          .member = &SteeringGear::max_angle,
          .unit = "deg",
          .range = {.low = 0.0, .high = 90.0, .above_low = true},
          .si = degree},
        P{.key = "lag_s", .member = &SteeringGear::lag, .unit = "s", .range = non_negative, .required = false},
        P{.key = "dead_band_deg",
          .member = &SteeringGear::dead_band,
          .unit = "deg",
          .range = non_negative,
          .si = degree,
          .required = false},
    };
  }
};

/// @throws std::domain_error  if an ordered angle [rad] is not positive or beyond the largest
void require_rudder(double angle, const SteeringGear<double>& gear);

/// Rudder angle over time in closed form: at its largest rate at first, then along an exponential, then at rest.
/// It holds until the next order.
template <class S = double>
class RudderMotion {
 public:
  /// From an angle at `time` at that rate, for ever.
  static RudderMotion moving(const S& time, const S& angle, const S& rate) {
    RudderMotion motion;
    motion.start_ = time;
    motion.angle_ = angle;
    motion.rate_ = rate;
    return motion;
  }

  /// From an angle at `time` towards the order, as the steering gear can.
  static RudderMotion ordered(const SteeringGear<S>& gear, const S& time, const S& angle, const S& order) {
    const S error = order - angle, band = gear.dead_band;
    const S side = select(error < S(0.0), S(-1.0), S(1.0)), size = size_of(error);
    const Mask<S> stays = size <= band;
    auto motion = moving(time, angle, select(stays, S(0.0), S(side * gear.rate)));
    // |e|/T reaches the rate when |e| = T rate; the rudder may come to rest before
    const S slow = lesser(greater(S(gear.lag * gear.rate), band), greater(band, size));
    // T ln(|e|/b) until |e| = b; without a dead band the rudder never quite arrives
    const Mask<S> settles = slow > band;
    S settling = S(0.0);
    if (any(settles))
      settling = select(settles, select(band > S(0.0), S(gear.lag * log(slow / band)), S(never)), settling);
    motion.slowing_ = select(stays, S(never), S(time + (size - slow) / gear.rate));
    motion.rest_ = motion.slowing_ + settling;
    motion.order_ = order;
    motion.error_ = side * slow;
    motion.lag_ = gear.lag;
    motion.final_ = order - side * band;
    return motion;
  }

  /// From `time` on late behind a straight line with that lag: a + b t − lead exp(−t/T), t since then, for ever.
  static RudderMotion trailing(const S& time, const S& a, const S& b, const S& lead, const S& lag) {
    RudderMotion motion = moving(time, a - lead, b);
    motion.slowing_ = time;
    motion.order_ = a;
    motion.order_rate_ = b;
    motion.error_ = lead;
    motion.lag_ = lag;
    return motion;
  }

  /// The same motion with an angle added.
  RudderMotion shifted(const S& angle) const {
    RudderMotion motion = *this;
    for (const auto member : {&RudderMotion::angle_, &RudderMotion::order_, &RudderMotion::final_})
      motion.*member = motion.*member + angle;
    return motion;
  }

  /// When it begins.
  const S& start() const { return start_; }

  /// Time constant of what it does at that time; 0 where it moves along a straight line.
  S fading(const S& time) const { return select(time >= slowing_ && time < rest_, lag_, S(0.0)); }

  S at(const S& time) const {
    const S ramp = angle_ + rate_ * (time - start_);
    const Mask<S> on_ramp = time <= slowing_ && time < rest_;
    if (all(on_ramp)) return ramp;
    const Mask<S> fading = time > slowing_ && time < rest_;
    S end = final_;
    if (any(fading))
      end = select(fading, S(order_ + order_rate_ * (time - slowing_) - error_ * decay(S((time - slowing_) / lag_))),
                   end);
    return select(on_ramp, ramp, end);
  }

  /// First time after `time` at which the rate jumps or begins to fall; infinity if there is none.
  S next_kink(const S& time) const { return select(time < slowing_, slowing_, select(time < rest_, rest_, S(never))); }

  /// One or the other motion, lane by lane.
  friend RudderMotion select(const Mask<S>& condition, const RudderMotion& a, const RudderMotion& b) {
    RudderMotion c;
    for (const auto member : {&RudderMotion::start_, &RudderMotion::angle_, &RudderMotion::rate_,
                              &RudderMotion::slowing_, &RudderMotion::order_, &RudderMotion::order_rate_,
                              &RudderMotion::error_, &RudderMotion::lag_, &RudderMotion::rest_, &RudderMotion::final_})
      c.*member = select(condition, a.*member, b.*member);
    return c;
  }

 private:
  static constexpr double never = std::numeric_limits<double>::infinity();

  S start_ = S(0.0);       ///< [s]
  S angle_ = S(0.0);       ///< at start [rad]
  S rate_ = S(0.0);        ///< until slowing [rad/s]
  S slowing_ = S(never);   ///< when the exponential begins [s]
  S order_ = S(0.0);       ///< delta_c [rad]
  S order_rate_ = S(0.0);  ///< of the angle that the exponential tends to [rad/s]
  S error_ = S(0.0);       ///< delta_c − delta when slowing begins [rad]
  S lag_ = S(0.0);         ///< T [s]
  S rest_ = S(never);      ///< when the rudder stops [s]
  S final_ = S(0.0);       ///< angle at rest [rad]
};

}  // namespace swayaw::core
