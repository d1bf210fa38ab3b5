#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "swayaw/nonlinear/estimates/estimated_ship.hpp"
#include "swayaw/nonlinear/ship.hpp"

/// How far the coefficients of an estimated ship are to be trusted.
namespace swayaw::inline nonlinear {

/// What one set of formulas says of a coefficient.
struct FormulaValue {
  std::string_view formula;  ///< "Clarke"
  double value;
};

/// A coefficient of an estimated ship, and how far from it others are: formulas, and measured ships.
struct CoefficientSpread {
  std::string key;                     ///< of the ship file; "kt" for a list
  double value;                        ///< as the ship has it; of a list the first
  std::vector<FormulaValue> formulas;  ///< that tell it, the one taken first; empty for what is assumed
  double
      between_formulas;  ///< root mean square of what other formulas say less the value, over it; 0 where none differs
  double from_measured;  ///< root mean square of measured numbers less their estimates, over the value here
  bool given = false;    ///< by the user; it has the trust of any published number

  /// How many of the formulas say different numbers; those of one origin count once.
  std::size_t distinct() const;

  /// Relative standard deviation: the larger of the two, between trust_in_published and least_trust.
  double relative() const;
};

/// Relative standard deviation of a coefficient of a ship file that says nothing; an estimate is not trusted more.
inline constexpr double trust_in_published = Confidence{}.coefficients;

/// At ten times its size a coefficient is as good as not known; a number near zero has no larger relative deviation.
inline constexpr double least_trust = 10.0;

/// Ships with measured hulls, on which the estimates are tried: KVLCC2 and KCS, published_ship.
std::vector<Ship> measured_ships();

/// Every coefficient of the ship that formulas tell, or that was compared with the measured ships.
///
/// Hull: Yoshimura and Masumoto and, linear, Clarke, both for even keel; Kijima. Added mass: Zhou; Clarke. Interaction:
/// Yoshimura and Masumoto; Kijima, whose epsilon and kappa are left out where that parabola is below 0.5.
///
/// @param options   those with which the ship was estimated
/// @param measured  ships of the MMG model; each is estimated from its own dimensions by the same formulas
std::vector<CoefficientSpread> estimate_spread(const HullDimensions<double>& hull, const EstimatedShip& estimate,
                                               const EstimateOptions& options,
                                               const std::vector<Ship>& measured = measured_ships());

/// As the table [confidence] of a ship file holds it.
Confidence confidence_of(const std::vector<CoefficientSpread>& spread);

}  // namespace swayaw::nonlinear
