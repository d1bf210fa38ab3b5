#pragma once

#include "swayaw/core/scalar.hpp"

/// What a rudder loses of its lift: to stall, and to the gap above it.
namespace swayaw::inline nonlinear {

/// 1/(1 + exp(−x)).
template <class S>
S logistic(const S& x) {
  const S e = decay(S(size_of(x)));
  return select(x < S(0.0), S(e / (1.0 + e)), S(1.0 / (1.0 + e)));
}

/// A rudder that loses less than this share of its lift at 35 deg does what every rudder does.
inline constexpr double ordinary_lift_loss_at_35_deg = 0.1;

/// A rudder that stalls: alpha_s is the angle of attack where half of what it loses is lost.
template <class S = double>
struct Stall {
  S alpha_s;  ///< [rad], 0 for none
  S depth;    ///< share of the lift lost in the end, 0 to 1
  S width;    ///< w [rad]: from 12 to 88 % of the loss over 4 w
};

/// Share of the lift that is left at an angle of attack; 1 at 0, and where alpha_s is 0: no stall.
///
///     1 − depth (l(|alpha|) − l(0))/(1 − l(0)),   l(alpha) = 1/(1 + exp(−(alpha − alpha_s)/w))
///
/// It goes over to the lower lift of a separated flow. Low-aspect rudders of [Whicker1958] lose 20 to 35 % within 8 deg
/// of the largest lift and more beyond.
template <class S>
S stall_factor(const Stall<S>& stall, const S& alpha) {
  const S w = stall.width, at_0 = logistic(S(-stall.alpha_s / w));
  const S lost = stall.depth * (logistic(S((size_of(alpha) - stall.alpha_s) / w)) - at_0) / (1.0 - at_0);
  return select(stall.alpha_s > S(0.0), S(1.0 - lost), S(1.0));
}

/// Share of the lift that is left with a gap that opens beyond delta_lim, 1 + s (|delta| − delta_lim)², never below 0;
/// s ≤ 0. Source: [Alexandersson2024] eq (30)
template <class S>
S open_gap_factor(const S& delta_lim, const S& s, const S& delta) {
  const S beyond = positive_part(S(size_of(delta) - delta_lim));
  return positive_part(S(1.0 + s * beyond * beyond));
}

}  // namespace swayaw::nonlinear
