#pragma once

#include "swayaw/core/scalar.hpp"

namespace swayaw::inline nonlinear {

/// How much of the usual growth in shallow water a ship shows; 1 is the middle of what tests of other ships show, where
/// most lie between 0.6 and 1.6.
template <class S = double>
struct ShallowWaterGrowth {
  S sway{1.0};        ///< Y_v, N_v
  S yaw{1.0};         ///< Y_r, N_r
  S cubic{1.0};       ///< cubic terms of sway and yaw
  S mass{1.0};        ///< added masses
  S resistance{1.0};  ///< R_0
  S wake{0.5};        ///< share of the published change of wake, thrust deduction and flow straightening
};

/// What finite depth makes of the numbers of a ship: factors on those of deep water.
template <class S = double>
struct ShallowWaterFactors {
  S sway, yaw, cubic, R_0;
  S m_x, m_y, J_z;
  S one_minus_t;  ///< on 1 − t_P
  S one_minus_w;  ///< on 1 − w_P
  S gamma_R;
};

/// Factors at a depth over draught h/d of a ship with block coefficient C_B. With x = d/h and G = x^2.5/(1 − x)^0.8,
///
///     Y_v, N_v: 1 + 0.75 sway G    Y_r, N_r: 1 + 0.35 yaw G    cubic terms: 1 + 0.6 cubic G    R_0: 1 + 0.12
///     resistance G m_y: 1 + 0.45 mass G    m_x, J_z: 1 + 0.35 mass G 1 − t_P: (1 − 0.2 x + 0.7295 x²)^−wake    1 −
///     w_P: cos(1.4 C_B x)^wake    gamma_R: (1 + 0.0161 x + 4.4222 x² − 4.9825 x³)^wake
///
/// Published formulas and tests differ by a factor of two and more in their growth at h/d = 1.2 (Y_v of full ships 2 to
/// 5 times that of deep water) but agree on its order: sway most, then cubic terms and added mass, yaw, resistance
/// least. The sizes here are a choice in their middle. G goes to 0 in deep water. Source: order and last line
/// [Furukawa2016], [Tang2020], added masses [Li1990], as public programs have them
template <class S>
ShallowWaterFactors<S> shallow_water_factors(const S& C_B, const S& depth_over_draught,
                                             const ShallowWaterGrowth<S>& growth) {
  const S x = 1.0 / depth_over_draught;
  const S G = exp(2.5 * log(x) - 0.8 * log(S(1.0 - x)));
  const auto to_the_wake = [&](const S& base) { return S(exp(growth.wake * log(base))); };
  return {
      .sway = 1.0 + 0.75 * growth.sway * G,
      .yaw = 1.0 + 0.35 * growth.yaw * G,
      .cubic = 1.0 + 0.6 * growth.cubic * G,
      .R_0 = 1.0 + 0.12 * growth.resistance * G,
      .m_x = 1.0 + 0.35 * growth.mass * G,
      .m_y = 1.0 + 0.45 * growth.mass * G,
      .J_z = 1.0 + 0.35 * growth.mass * G,
      .one_minus_t = 1.0 / to_the_wake(S(1.0 - 0.2 * x + 0.7295 * x * x)),
      .one_minus_w = to_the_wake(S(cos(1.4 * C_B * x))),
      .gamma_R = to_the_wake(S(1.0 + x * (0.0161 + x * (4.4222 - 4.9825 * x)))),
  };
}

}  // namespace swayaw::nonlinear
