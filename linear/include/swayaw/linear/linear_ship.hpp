#pragma once

#include <array>
#include <string>
#include <variant>

#include "swayaw/core/confidence.hpp"
#include "swayaw/core/parameter.hpp"
#include "swayaw/core/steering_gear.hpp"
#include "swayaw/linear/dimensional.hpp"
#include "swayaw/linear/indices.hpp"
#include "swayaw/linear/ship_parts.hpp"
#include "swayaw/linear/sname.hpp"

namespace swayaw::inline linear {

/// What gives a linear ship dimension.
template <class S = double>
struct LinearParticulars {
  S L;    ///< length [m]
  S U_0;  ///< service speed [m/s]

  static constexpr auto parameters() {
    using P = ParameterOf<LinearParticulars, S>;
    return std::array{
        P{"length_m", &LinearParticulars::L, "m", positive},
        P{"service_speed_m_s", &LinearParticulars::U_0, "m/s", positive},
    };
  }
};

/// What is known of a linear ship: hull and rudder, the coupled equations, or the two second-order equations.
using LinearForm = std::variant<LinearParts<double>, SwayYawCoefficients<double>, SteeringIndices<double>>;

/// A ship in linear motion.
struct LinearShip {
  std::string name;
  LinearParticulars<double> particulars;
  SteeringGear<double> steering_gear;
  LinearForm form;
  Confidence confidence;
};

/// Transfer functions; every linear ship has them.
SwayYawTransfer<double> transfer_functions(const LinearShip& ship);

/// Steering indices. Infinite or not a number for a neutral ship, or where Kb or Kw is 0, unless the ship is given by
/// them.
SteeringIndices<double> indices(const LinearShip& ship);

/// Whether there are coupled equations: not where the ship is given by indices with T3b = T3w, or Kb or Kw = 0.
bool has_coefficients(const LinearShip& ship);

/// Coefficients of the coupled equations.
/// @throws Refusal  unless `has_coefficients`
SwayYawCoefficients<double> coefficients(const LinearShip& ship);

/// Coefficients with the ship's yaw equation: her own, or else those of another ship whose heading moves alike and
/// whose drift does not.
/// @throws Refusal  if Kw = 0
SwayYawCoefficients<double> yaw_coefficients(const LinearShip& ship);

/// Hull and rudder, if the ship is given by them; else nullptr.
inline const LinearParts<double>* parts(const LinearShip& ship) { return std::get_if<LinearParts<double>>(&ship.form); }

/// Length of the ship and a speed.
inline PrimeScale prime_scale(const LinearShip& ship, double speed) { return {.L = ship.particulars.L, .U = speed}; }

/// Mass, inertia and added masses of a hull with the centre of gravity midship, in the prime system ½ρL²T of
/// `LinearHull`; the derivatives are left 0. m' = 2 c_B B/L
SnameDerivatives<double> inertia(const LinearHull<double>& hull);

}  // namespace swayaw::linear
