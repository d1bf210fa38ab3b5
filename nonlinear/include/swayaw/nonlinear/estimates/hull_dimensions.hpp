#pragma once

#include <string>
#include <vector>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/scalar.hpp"

/// Main dimensions, from which estimate.hpp, kijima.hpp and clarke.hpp guess what was not measured.
namespace swayaw::inline nonlinear {

template <class S = double>
struct HullDimensions {
  S L;              ///< length between perpendiculars [m]
  S B;              ///< beam [m]
  S d;              ///< mean draught [m]
  S C_B;            ///< block coefficient, displaced volume over L B d
  S trim = S(0.0);  ///< draught aft less draught forward [m]
};

/// Displaced volume C_B L B d [m^3].
template <class S>
S displaced_volume(const HullDimensions<S>& h) {
  return h.C_B * h.L * h.B * h.d;
}

/// Mass over ½ρL²d, m' = 2 C_B B/L.
template <class S>
S mass_prime(const HullDimensions<S>& h) {
  return 2.0 * h.C_B * h.B / h.L;
}

/// C_B B/L, on which most formulas of the MMG group rest.
template <class S>
S fullness(const HullDimensions<S>& h) {
  return h.C_B * h.B / h.L;
}

/// Aspect ratio of the hull seen as a wing, k = 2d/L.
template <class S>
S wing_aspect(const HullDimensions<S>& h) {
  return 2.0 * h.d / h.L;
}

/// Ships for which a set of formulas may be used. Both ends belong to the range.
struct HullRange {
  struct Span {
    double low, high;
  };
  Span C_B;
  Span L_over_B;
  Span B_over_d;
  Span trim_over_d;
  Span fineness_trimmed{0.0, 1.0};  ///< d (1 − C_B)/B of a ship with trim
};

/// One sentence for each ratio of the hull that lies outside the range; empty inside it.
///
/// @throws std::domain_error  if length, beam, draught or block coefficient is not positive
std::vector<std::string> outside(const HullDimensions<double>& hull, const HullRange& range);

}  // namespace swayaw::nonlinear
