#pragma once

#include "swayaw/core/dual.hpp"
#include "swayaw/linear/sway_yaw.hpp"

/// Numbers in duals whose derivatives are those by logarithms: dx/d ln(x) = x. Not installed.
namespace swayaw::inline linear::detail {

/// @param i  place of the number among those that vary
template <int N>
Dual<N> by_logarithm(double value, int i) {
  Dual<N> x(value);
  x.v[i] = value;
  return x;
}

/// Coefficients by the logarithms of a1, b1, c1, a2, b2, c2, the first six of N.
template <int N>
SwayYawCoefficients<Dual<N>> by_logarithms(const SwayYawCoefficients<double>& m) {
  return {by_logarithm<N>(m.a1, 0), by_logarithm<N>(m.b1, 1), by_logarithm<N>(m.c1, 2),
          by_logarithm<N>(m.a2, 3), by_logarithm<N>(m.b2, 4), by_logarithm<N>(m.c2, 5)};
}

}  // namespace swayaw::linear::detail
