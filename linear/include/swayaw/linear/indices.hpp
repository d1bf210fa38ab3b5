#pragma once

#include <optional>

#include "swayaw/linear/sway_yaw.hpp"

namespace swayaw::inline linear {

/// Steering indices of the second-order equations of drift and yaw, dimensionless:
///
///     T1 T2 d²(beta)/ds'² + (T1 + T2) d(beta)/ds' + beta = Kb (delta + T3b d(delta)/ds')
///     T1 T2 d²(omega')/ds'² + (T1 + T2) d(omega')/ds' + omega' = Kw (delta + T3w d(delta)/ds')
///
/// Product and sum of T1 and T2 are real for complex poles too. Kb and Kw are negative for a stable ship, since a
/// rudder angle to port is positive.
/// Source: [Artyszuk2016] eqs (15), (16)
template <class S = double>
struct SteeringIndices {
  S T1T2;        ///< product of the time constants
  S T1_plus_T2;  ///< their sum
  S T3b;         ///< rudder-rate time constant of drift
  S T3w;         ///< rudder-rate time constant of yaw
  S Kb;          ///< gain of drift
  S Kw;          ///< gain of yaw

  static constexpr auto parameters() {
    constexpr auto index = [](std::string_view key, S SteeringIndices::*member, const Range& range = any_number) {
      return ParameterOf<SteeringIndices, S>{key, member, "-", range, Role::coefficient};
    };
    return std::array{
        index("T1T2", &SteeringIndices::T1T2, not_zero),
        index("T1_plus_T2", &SteeringIndices::T1_plus_T2),
        index("T3b", &SteeringIndices::T3b),
        index("T3w", &SteeringIndices::T3w),
        index("Kb", &SteeringIndices::Kb),
        index("Kw", &SteeringIndices::Kw),
    };
  }
};

/// T1 and T2, real.
template <class S = double>
struct TimeConstants {
  S T1;  ///< of the slower mode (negative for an unstable ship)
  S T2;  ///< of the faster mode
};

/// Indices of transfer functions. Source: [Artyszuk2016] eqs (17)–(24)
/// Infinite or not a number for a neutral ship (e0 = 0) or where Kb or Kw is 0: there use the transfer functions.
template <class S>
SteeringIndices<S> steering_indices(const SwayYawTransfer<S>& h) {
  return {
      .T1T2 = 1.0 / h.e0,
      .T1_plus_T2 = h.e1 / h.e0,
      .T3b = h.nb1 / h.nb0,
      .T3w = h.nw1 / h.nw0,
      .Kb = h.nb0 / h.e0,
      .Kw = h.nw0 / h.e0,
  };
}

template <class S>
SteeringIndices<S> steering_indices(const SwayYawCoefficients<S>& m) {
  return steering_indices(transfer_functions(m));
}

/// Transfer functions with given indices.
template <class S>
SwayYawTransfer<S> transfer_functions(const SteeringIndices<S>& i) {
  const S e0 = 1.0 / i.T1T2;
  return {
      .e0 = e0,
      .e1 = i.T1_plus_T2 * e0,
      .nb0 = i.Kb * e0,
      .nb1 = i.Kb * i.T3b * e0,
      .nw0 = i.Kw * e0,
      .nw1 = i.Kw * i.T3w * e0,
  };
}

/// Coupled equations with given indices, the inverse of `steering_indices`, as printed:
///
///     a1 = [P − T3b (S − T3w)] / [(T3b − T3w) P]          b1 = (Kb/Kw) [T3b (S − T3b) − P] / [(T3b − T3w) P]
///     a2 = (Kw/Kb) [P − T3w (S − T3w)] / [(T3b − T3w) P]  b2 = [T3w (S − T3b) − P] / [(T3b − T3w) P]
///     c1 = T3b Kb / P                                     c2 = T3w Kw / P,    P = T1 T2, S = T1 + T2
///
/// For T3b = T3w there is no such ship unless T3 is T1 or T2: the result is infinite or not a number.
/// Source: [Artyszuk2016] eqs (29)–(34)
template <class S>
SwayYawCoefficients<S> coefficients_from(const SteeringIndices<S>& i) {
  const S &P = i.T1T2, &sum = i.T1_plus_T2;
  const S over = 1.0 / ((i.T3b - i.T3w) * P);
  return {
      .a1 = (P - i.T3b * (sum - i.T3w)) * over,
      .b1 = i.Kb / i.Kw * (i.T3b * (sum - i.T3b) - P) * over,
      .c1 = i.T3b * i.Kb / P,
      .a2 = i.Kw / i.Kb * (P - i.T3w * (sum - i.T3w)) * over,
      .b2 = (i.T3w * (sum - i.T3b) - P) * over,
      .c2 = i.T3w * i.Kw / P,
  };
}

/// The same by matrices. With w = A c and the controllability matrix [c w],
///
///     A = [w   tr(A) w − det(A) c] [c   w]⁻¹,   c = (T3b Kb, T3w Kw)/P,   w = (nb0 − e1 nb1, nw0 − e1 nw1)
///
/// by Cayley–Hamilton, A² c = tr(A) A c − det(A) c.
template <class S>
SwayYawCoefficients<S> coefficients_by_controllability(const SteeringIndices<S>& i) {
  const auto h = transfer_functions(i);
  const S c1 = h.nb1, c2 = h.nw1;
  const S w1 = h.nb0 - h.e1 * c1, w2 = h.nw0 - h.e1 * c2;            // A c, since n(s) = c s + (A c + e1 c)
  const S z1 = -h.e1 * w1 - h.e0 * c1, z2 = -h.e1 * w2 - h.e0 * c2;  // A w
  const S over = 1.0 / (c1 * w2 - c2 * w1);
  return {
      .a1 = (w1 * w2 - z1 * c2) * over,
      .b1 = (z1 * c1 - w1 * w1) * over,
      .c1 = c1,
      .a2 = (w2 * w2 - z2 * c2) * over,
      .b2 = (z2 * c1 - w2 * w1) * over,
      .c2 = c2,
  };
}

/// T1 and T2 from product and sum, without cancellation.
///
///     T² − (T1 + T2) T + T1 T2 = 0, the larger magnitude first; for a stable ship T1 > T2
///
/// @return nothing when they are a complex pair
template <class S>
std::optional<TimeConstants<S>> time_constants(const SwayYawTransfer<S>& h) {
  // poles l² + e1 l + e0 = 0: the faster one without cancellation, the slower one from the product
  const S discriminant = h.e1 * h.e1 - 4.0 * h.e0;
  if (discriminant < S(0.0)) return std::nullopt;
  const S root = sqrt(discriminant);
  const S fast = h.e1 >= S(0.0) ? S(-0.5 * (h.e1 + root)) : S(0.5 * (root - h.e1));
  return TimeConstants<S>{.T1 = -fast / h.e0, .T2 = -1.0 / fast};
}

/// Nomoto's first-order equation T d(omega')/ds' + omega' = K delta.
template <class S = double>
struct FirstOrder {
  S K;  ///< gain
  S T;  ///< time constant
};

/// First-order equations of drift and yaw with the same steady value and the same area under the response:
/// T_b = T1 + T2 − T3b, T_w = T1 + T2 − T3w. Source: [Artyszuk2016] eqs (41), (42)
template <class S>
FirstOrder<S> first_order_drift(const SteeringIndices<S>& i) {
  return {.K = i.Kb, .T = i.T1_plus_T2 - i.T3b};
}

template <class S>
FirstOrder<S> first_order_yaw(const SteeringIndices<S>& i) {
  return {.K = i.Kw, .T = i.T1_plus_T2 - i.T3w};
}

/// How much of the accuracy of its input each conversion can lose: condition numbers of the logarithmic Jacobians
/// d ln(out)/d ln(in) between (a1 … c2) and (T1T2, T1+T2, T3b, T3w, Kb, Kw), largest over smallest singular value.
/// Infinite where the conversion does not exist.
double condition_number(const SwayYawCoefficients<double>& m);

/// Distance to T3b = T3w relative to their size, |T3b − T3w|/(|T3b| + |T3w|), in [0, 1]: 0 where no inverse exists.
template <class S>
S inverse_distance(const SteeringIndices<S>& i) {
  return abs(i.T3b - i.T3w) / (abs(i.T3b) + abs(i.T3w));
}

}  // namespace swayaw::linear
