#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <span>
#include <vector>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/scalar.hpp"

/// Smooth functions of a direction: what they are at −pi they are at pi, with all derivatives they have.
namespace swayaw::inline nonlinear {

/// f(alpha) = a_0 + sum over k = 1, 2, … of a_k cos(k alpha) + b_k sin(k alpha).
template <class S = double>
struct FourierSeries {
  S a_0 = S(0.0);
  std::vector<S> a{};  ///< a_1, a_2, …; may be shorter or longer than b
  std::vector<S> b{};  ///< b_1, b_2, …
};

/// Every angle is accepted.
template <class S>
S value_at(const FourierSeries<S>& f, const S& angle) {
  const S c = cos(angle), s = sin(angle);
  S c_k = c, s_k = s, sum = f.a_0;
  for (std::size_t i = 0; i < std::max(f.a.size(), f.b.size()); ++i) {
    if (i < f.a.size()) sum = sum + f.a[i] * c_k;
    if (i < f.b.size()) sum = sum + f.b[i] * s_k;
    // cos((k + 1) alpha) = cos(k alpha) cos(alpha) − sin(k alpha) sin(alpha), the sine alike
    const S next = c_k * c - s_k * s;
    s_k = s_k * c + c_k * s;
    c_k = next;
  }
  return sum;
}

/// c_0 + c_1 t + c_2 t² + c_3 t³ with t = angle − start, as far as the next piece.
template <class S = double>
struct SplinePiece {
  S start;
  std::array<S, 4> c;
};

/// Piecewise cubic function of an angle, twice continuously differentiable, with period 2 pi.
struct PeriodicSpline {
  std::vector<SplinePiece<>> pieces;  ///< starts increase in [−pi, pi); the last piece ends where the first begins
};

/// The periodic cubic spline through (angle, value).
///
/// With steps h_i and second derivatives M_i at the nodes, continuity of the first derivative asks, indices modulo n,
///
///     h_(i−1) M_(i−1) + 2 (h_(i−1) + h_i) M_i + h_i M_(i+1) = 6 ((f_(i+1) − f_i)/h_i − (f_i − f_(i−1))/h_(i−1))
///
/// Error for n even steps h: at most (5/384) h⁴ max|f''''|.
///
/// @throws std::domain_error  with fewer than three nodes, or if angles do not increase in [−pi, pi)
PeriodicSpline periodic_spline(std::span<const double> angle, std::span<const double> value);

/// The piece that an angle in [starts.front(), starts.front() + 2 pi) is on, lane by lane in a pack.
template <class S>
SplinePiece<S> piece_at(const PeriodicSpline& spline, const S& angle) {
  const auto as_scalar = [](const SplinePiece<>& p) {
    return SplinePiece<S>{S(p.start), {S(p.c[0]), S(p.c[1]), S(p.c[2]), S(p.c[3])}};
  };
  const auto& pieces = spline.pieces;
  if constexpr (std::same_as<Mask<S>, bool>) {
    const auto behind = std::ranges::upper_bound(pieces, value_of(angle), {}, &SplinePiece<>::start);
    return as_scalar(behind == pieces.begin() ? *behind : *(behind - 1));
  } else {
    auto piece = as_scalar(pieces.front());
    for (std::size_t i = 1; i < pieces.size(); ++i) {
      const auto here = angle >= S(pieces[i].start);
      const auto next = as_scalar(pieces[i]);
      piece.start = select(here, next.start, piece.start);
      for (std::size_t k = 0; k < 4; ++k) piece.c[k] = select(here, next.c[k], piece.c[k]);
    }
    return piece;
  }
}

/// The angle must lie in [−pi, pi].
template <class S>
S value_at(const PeriodicSpline& spline, const S& angle) {
  const S turned = select(angle < S(spline.pieces.front().start), S(angle + 2.0 * pi), angle);
  const auto [start, c] = piece_at(spline, turned);
  const S t = turned - start;
  return c[0] + t * (c[1] + t * (c[2] + t * c[3]));
}

}  // namespace swayaw::nonlinear
