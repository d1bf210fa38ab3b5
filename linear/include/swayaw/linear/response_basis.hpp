#pragma once

#include <array>
#include <cmath>

#include "swayaw/core/scalar.hpp"

namespace swayaw::inline linear {

/// Functions of time of which every response of the second-order equations to a piecewise linear rudder is made.
///
/// With the characteristic equation l² − tr l + det = 0 of A, let h_0 be the impulse response of 1/(s² − tr s + det),
/// h_{−1} its derivative and h_{k+1} the integral of h_k from 0. Then
///
///     exp(A s) = (h_{−1} − tr h_0) I + h_0 A,   and its k-fold integral is (h_{k−1} − tr h_k) I + h_k A.
///
/// Regular for real, equal, complex and zero poles.
template <class S>
struct ResponseBasis {
  S h_1;  ///< h_{−1}
  S h0, h1, h2, h3;
};

namespace detail {

/// 1/n. Series multiply by it, since division is slow.
inline constexpr std::array<double, 20> one_over = [] {
  std::array<double, 20> table{};
  for (std::size_t n = 1; n < table.size(); ++n) table[n] = 1.0 / static_cast<double>(n);
  return table;
}();

/// Σ p_j s^{j+1+k}/(j+1+k)! with p_0 = 1, p_1 = tr, p_{j+1} = tr p_j − det p_{j−1}: for small |l| s.
template <class S>
ResponseBasis<S> basis_by_series(const S& tr, const S& det, const S& s) {
  // all five at once by Horner from the last term; h_k needs s^{j+1+k}/(j+1+k)!
  constexpr int terms = 14;
  std::array<S, terms> p;
  p[0] = S(1.0);
  p[1] = tr;
  for (int j = 2; j < terms; ++j)
    p[static_cast<std::size_t>(j)] = tr * p[static_cast<std::size_t>(j - 1)] - det * p[static_cast<std::size_t>(j - 2)];
  const auto sum = [&](int k) {  // Σ p_j s^j (k+1)!/(j+1+k)!
    S value = p[terms - 1];
    for (int j = terms - 2; j >= 0; --j)
      value = p[static_cast<std::size_t>(j)] + value * (s * one_over[static_cast<std::size_t>(j + 2 + k)]);
    return value;
  };
  const S s2 = s * s;
  return {.h_1 = sum(-1),
          .h0 = s * sum(0),
          .h1 = s2 * 0.5 * sum(1),
          .h2 = s2 * s * (1.0 / 6.0) * sum(2),
          .h3 = s2 * s2 * (1.0 / 24.0) * sum(3)};
}

/// φ_1 … φ_3 of z = l s with e = exp(z): φ_k = (φ_{k−1} − 1/(k−1)!)/z, by series near 0.
template <class S>
std::array<S, 3> phi_functions(const S& z, const S& e) {
  if (std::abs(value_of(z)) > 0.5) {
    const S phi1 = (e - 1.0) / z, phi2 = (phi1 - 1.0) / z;
    return {phi1, phi2, (phi2 - 0.5) / z};
  }
  const auto series = [&](int k) {  // k! φ_k = Σ z^j k!/(j+k)!
    S value(1.0);
    for (int j = 13; j >= 1; --j) value = 1.0 + value * (z * one_over[static_cast<std::size_t>(j + k)]);
    return value;
  };
  return {series(1), 0.5 * series(2), (1.0 / 6.0) * series(3)};
}

/// h_k = (g_k(l1) − g_k(l2))/(l1 − l2), g_k(l) = s^k φ_k(l s), for poles well apart.
template <class S>
ResponseBasis<S> basis_by_modes(const S& l1, const S& l2, const S& s) {
  const S over = 1.0 / (l1 - l2);
  const S e1 = exp(l1 * s), e2 = exp(l2 * s);
  const auto f1 = phi_functions(S(l1 * s), e1), f2 = phi_functions(S(l2 * s), e2);
  const S s2 = s * s;
  return {.h_1 = (l1 * e1 - l2 * e2) * over,
          .h0 = (e1 - e2) * over,
          .h1 = s * (f1[0] - f2[0]) * over,
          .h2 = s2 * (f1[1] - f2[1]) * over,
          .h3 = s2 * s * (f1[2] - f2[2]) * over};
}

/// From cos or cosh, with h_{k−1} − tr h_k + det h_{k+1} = s^k/k!, for poles near each other or complex.
template <class S>
ResponseBasis<S> basis_by_recursion(const S& tr, const S& det, const S& q, const S& s) {
  const S mu = 0.5 * tr, z = q * s * s;  // l = mu ± sqrt(q)
  const double size = value_of(z);
  S even(1.0), odd(1.0);  // cosh(sqrt z), sinh(sqrt z)/sqrt z
  if (size > 0.01) {
    const S w = sqrt(z), up = exp(w), down = 1.0 / up;
    even = 0.5 * (up + down);
    odd = 0.5 * (up - down) / w;
  } else if (size < -0.01) {
    const S w = sqrt(-z);
    even = cos(w);
    odd = sin(w) / w;
  } else {
    even = 1.0 + z / 2.0 * (1.0 + z / 12.0 * (1.0 + z / 30.0 * (1.0 + z / 56.0 * (1.0 + z / 90.0))));
    odd = 1.0 + z / 6.0 * (1.0 + z / 20.0 * (1.0 + z / 42.0 * (1.0 + z / 72.0 * (1.0 + z / 110.0))));
  }
  const S decay = exp(mu * s);
  const S h0 = decay * s * odd, h_1 = decay * even + mu * h0;
  const S h1 = (1.0 - h_1 + tr * h0) / det;
  const S h2 = (s - h0 + tr * h1) / det;
  return {.h_1 = h_1, .h0 = h0, .h1 = h1, .h2 = h2, .h3 = (0.5 * s * s - h1 + tr * h2) / det};
}

}  // namespace detail

/// Poles of a second-order equation, prepared for many times.
template <class S>
struct Poles {
  S tr;          ///< sum of the poles
  S det;         ///< their product
  S q;           ///< (tr/2)² − det, square of half their distance; negative for a complex pair
  S slow, fast;  ///< the poles, if they are real and well apart
  bool apart;
  double size;  ///< largest magnitude
};

template <class S>
Poles<S> poles(const S& tr, const S& det) {
  const S mu = 0.5 * tr, q = mu * mu - det;
  const double m = std::abs(value_of(mu)), distance2 = value_of(q);
  Poles<S> p{.tr = tr,
             .det = det,
             .q = q,
             .slow = mu,
             .fast = mu,
             .apart = distance2 > 0.04 * m * m && distance2 > 0.0,
             .size = 0.0};
  p.size = distance2 >= 0.0 ? m + std::sqrt(distance2) : std::sqrt(std::abs(value_of(det)));
  if (!p.apart) return p;
  // the faster pole without cancellation, the slower one from the product
  const S root = sqrt(q);
  p.fast = value_of(mu) <= 0.0 ? S(mu - root) : S(mu + root);
  p.slow = det / p.fast;
  return p;
}

/// The basis functions at time s ≥ 0.
template <class S>
ResponseBasis<S> response_basis(const Poles<S>& p, const S& s) {
  if (p.size * value_of(s) < 0.5) return detail::basis_by_series(p.tr, p.det, s);
  if (p.apart) return detail::basis_by_modes(p.slow, p.fast, s);
  return detail::basis_by_recursion(p.tr, p.det, p.q, s);
}

}  // namespace swayaw::linear
