#pragma once

#include <cmath>
#include <type_traits>
#include <utility>

/// Physics is written once, as a template over its scalar: `double` for a number, a dual
/// (dual.hpp) for exact derivatives, a pack (pack.hpp) for many ships at once.
///
/// Unqualified `sqrt`, `sin`, … inside namespace swayaw find the std functions through these
/// using-declarations and the functions of duals and packs through argument-dependent lookup.
namespace swayaw::inline core {

using std::abs;
using std::atan;
using std::atan2;
using std::cos;
using std::exp;
using std::hypot;
using std::log;
using std::sin;
using std::sqrt;

/// Result of a comparison: bool, or one bool per lane of a pack.
template <class Scalar>
using Mask = decltype(std::declval<Scalar>() < std::declval<Scalar>());

/// `condition ? a : b` for every scalar. Packs bring their own, lane by lane.
template <class Scalar>
Scalar select(bool condition, const Scalar& a, const Scalar& b) {
  return condition ? a : b;
}

/// The number in a double or a dual, without derivatives.
template <class Scalar>
double value_of(const Scalar& x) {
  if constexpr (requires { x.a; }) return x.a;
  else return x;
}

/// The number in a double or a dual, or in the first lane of a pack: for facts that are the same in all lanes.
template <class Scalar>
double first_lane(const Scalar& x) {
  if constexpr (requires { x.get(0); }) return x.get(0);
  else return value_of(x);
}

/// Whether a condition holds, in every lane of a pack.
inline bool all(bool condition) { return condition; }

/// Whether a condition holds, in some lane of a pack.
inline bool any(bool condition) { return condition; }

template <class S>
struct SinCos {
  S sin, cos;
};

/// Elementary functions that a kind of scalar may have its own of, as packs do (pack.hpp).
template <class S>
struct Elementary {
  static SinCos<S> sin_cos(const S& x) { return {sin(x), cos(x)}; }
  static S decay(const S& x) { return exp(-x); }
  static S angle_of(const S& y, const S& x) { return atan2(y, x); }
};

/// Sine and cosine at once.
template <class S>
SinCos<S> sin_cos(const S& angle) {
  return Elementary<S>::sin_cos(angle);
}

/// exp(−x) for x ≥ 0.
template <class S>
S decay(const S& x) {
  return Elementary<S>::decay(x);
}

/// Angle of the vector (x, y), in (−π, π].
template <class S>
S angle_of(const S& y, const S& x) {
  return Elementary<S>::angle_of(y, x);
}

/// |x|
template <class S>
S size_of(const S& x) {
  return select(x < S(0.0), S(-x), x);
}

/// The lesser of two.
template <class S>
S lesser(const S& a, const S& b) {
  return select(b < a, b, a);
}

/// The greater of two.
template <class S>
S greater(const S& a, const S& b) {
  return select(a < b, b, a);
}

/// x where positive, else 0.
template <class Scalar>
Scalar positive_part(const Scalar& x) {
  return select(x > Scalar(0.0), x, Scalar(0.0));
}

/// √x where x is positive, else 0. Its slope is 0 there, too, where that of √(positive_part(x)) is no number.
template <class Scalar>
Scalar root_of_positive(const Scalar& x) {
  return select(x > Scalar(0.0), Scalar(sqrt(select(x > Scalar(0.0), x, Scalar(1.0)))), Scalar(0.0));
}

}  // namespace swayaw::core
