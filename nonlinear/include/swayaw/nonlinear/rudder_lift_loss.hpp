#pragma once

#include "swayaw/core/scalar.hpp"

/// What a rudder loses of its lift: to stall, and to the gap above it.
namespace swayaw {

/// Share of the lift that is left at an angle of attack beyond the stall angle alpha_s; 1 below it, and where alpha_s is 0: no stall.
///
///     1/(1 + k x³/(x² + w²)),   x = |alpha| − alpha_s > 0,   k = 2.5/rad, w = 0.05 rad
///
/// It falls with slope −k once the stall is w = 3 deg deep, and is smooth to the second derivative at alpha_s.
/// The slope is a choice, a quarter of the lift lost 7 to 8 deg beyond: low-aspect rudders of [Whicker1958] lose 20 to 35 %.
template <class S>
S stall_factor(const S& alpha_s, const S& alpha) {
  constexpr double k = 2.5, w = 0.05;
  const S x = select(alpha_s > S(0.0), positive_part(S(size_of(alpha) - alpha_s)), S(0.0));
  return 1.0 / (1.0 + k * x * x * x / (x * x + w * w));
}

/// Share of the lift that is left with a gap that opens beyond delta_lim, 1 + s (|delta| − delta_lim)², never below 0; s ≤ 0.
/// Source: [Alexandersson2024] eq (30)
template <class S>
S open_gap_factor(const S& delta_lim, const S& s, const S& delta) {
  const S beyond = positive_part(S(size_of(delta) - delta_lim));
  return positive_part(S(1.0 + s * beyond * beyond));
}

}  // namespace swayaw
