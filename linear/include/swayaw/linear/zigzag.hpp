#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "swayaw/core/side.hpp"
#include "swayaw/linear/response.hpp"

/// The zigzag of a ship in linear motion, exact: every leg is a closed form, every switch the root of one.
namespace swayaw::inline linear {

/// Zigzag D/H in dimensionless time.
struct LinearZigzagOrder {
  double rudder;   ///< D [rad], positive
  double heading;  ///< H [rad], positive
  double rate;     ///< rudder rate, radians per ship length; infinite for a step
  Side first = Side::starboard;
  std::size_t reversals = 6;  ///< how many to sail for
  double longest = 1000.0;    ///< ship lengths after which the zigzag is given up
};

/// What ends a leg.
enum class LegEnd {
  limit,    ///< nothing; the next leg goes on as this one
  arrival,  ///< the rudder is at its order
  heading,  ///< the heading reaches H, the rudder is reversed
  peak,     ///< the yaw rate passes zero
};

/// Motion under a rudder that moves in one straight line.
template <class S = double>
struct Leg {
  S from;    ///< s' at its start
  S length;  ///< ship lengths until its end
  LinearState<S> start;
  RudderLine<S> rudder;
  LegEnd end;
};

/// A rudder reversal and the heading peak that follows it.
template <class S = double>
struct LinearReversal {
  S execute;        ///< s' at which the heading reaches H
  S peak;           ///< s' at which the yaw rate passes zero
  S overshoot;      ///< heading beyond H at the peak [rad]
  std::size_t leg;  ///< first leg after the reversal
};

template <class S = double>
struct LinearZigzag {
  std::vector<LinearReversal<S>> reversals;
  std::vector<Leg<S>> legs;

  /// From the last reversal but two to the last, if there are three.
  std::optional<S> period() const {
    if (reversals.size() < 3) return std::nullopt;
    return reversals.back().execute - reversals[reversals.size() - 3].execute;
  }
};

/// The zigzag from straight ahead on heading 0, the rudder ordered at s' = 0. Fewer reversals than asked for when the
/// heading does not reach H, or does not come back, within `longest`.
///
/// @throws std::domain_error  if an angle or the rate is not positive
LinearZigzag<double> linear_zigzag(const SwayYawCoefficients<double>& ship, const LinearZigzagOrder& order);

/// Coefficients whose yaw equation is Nomoto's first-order equation T d(omega')/ds' + omega' = K delta; drift stays
/// zero.
template <class S>
SwayYawCoefficients<S> first_order_ship(const S& K, const S& T) {
  return {.a1 = S(-1.0), .b1 = S(0.0), .c1 = S(0.0), .a2 = S(0.0), .b2 = -1.0 / T, .c2 = K / T};
}

/// How long a leg lasts in duals: one Newton step, s − g/(dg/ds), from the root in numbers.
template <class S>
S carried_length(const LinearResponse<S>& ship, const Leg<S>& leg, double heading, double arrival) {
  const S& s = leg.length;
  if (leg.end == LegEnd::limit) return s;
  if (leg.end == LegEnd::arrival) return (arrival - leg.rudder.value) / leg.rudder.rate;
  const auto x = state_after(ship, leg.start, leg.rudder, s);
  if (leg.end == LegEnd::peak)
    return s - x.omega / value_of(rates(ship.m, x, S(leg.rudder.value + leg.rudder.rate * s)).omega);
  return s - (x.psi - std::copysign(heading, value_of(x.psi))) / value_of(x.omega);
}

/// The same zigzag carried through duals: exact derivatives of every switch, peak and state by what the coefficients
/// depend on.
///
/// @param zigzag  the zigzag of the values of `coefficients`
template <class S>
LinearZigzag<S> carried_through(const LinearZigzag<double>& zigzag, const SwayYawCoefficients<S>& coefficients,
                                const LinearZigzagOrder& order) {
  const LinearResponse<S> ship(coefficients);
  LinearZigzag<S> result;
  S now(0.0), angle(0.0);
  LinearState<S> state{S(0.0), S(0.0), S(0.0)};
  for (std::size_t i = 0; i < zigzag.legs.size(); ++i) {
    const auto& known = zigzag.legs[i];
    const double next_angle = known.rudder.value + known.rudder.rate * known.length;
    if (std::isinf(order.rate)) angle = S(known.rudder.value);
    Leg<S> leg{now, S(known.length), state, {angle, S(known.rudder.rate)}, known.end};
    leg.length = carried_length(ship, leg, order.heading, next_angle);
    state = state_after(ship, state, leg.rudder, leg.length);
    now = now + leg.length;
    angle = leg.end == LegEnd::arrival ? S(next_angle) : S(leg.rudder.value + leg.rudder.rate * leg.length);
    result.legs.push_back(leg);
    if (leg.end == LegEnd::heading && result.reversals.size() < zigzag.reversals.size())
      result.reversals.push_back({now, S(0.0), S(0.0), i + 1});
    if (leg.end == LegEnd::peak) {
      result.reversals.back().peak = now;
      result.reversals.back().overshoot = select(state.psi > S(0.0), state.psi, S(-state.psi)) - order.heading;
    }
  }
  return result;
}

}  // namespace swayaw::linear
