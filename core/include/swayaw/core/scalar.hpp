#pragma once

#include <cmath>
#include <type_traits>
#include <utility>

/// Physics is written once, as a template over its scalar: `double` for a number, a dual
/// (dual.hpp) for exact derivatives, a pack (pack.hpp) for many ships at once.
///
/// Unqualified `sqrt`, `sin`, … inside namespace swayaw find the std functions through these
/// using-declarations and the functions of duals and packs through argument-dependent lookup.
namespace swayaw {

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

/// x where positive, else 0.
template <class Scalar>
Scalar positive_part(const Scalar& x) {
  return select(x > Scalar(0.0), x, Scalar(0.0));
}

}  // namespace swayaw
