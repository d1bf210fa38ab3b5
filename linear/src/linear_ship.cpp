#include "swayaw/linear/linear_ship.hpp"

#include <fmt/format.h>

#include "swayaw/core/refusal.hpp"

namespace swayaw::inline linear {
namespace {

SteeringIndices<double> indices_of(const SteeringIndices<double>& i) { return i; }
SteeringIndices<double> indices_of(const SwayYawCoefficients<double>& m) { return steering_indices(m); }
SteeringIndices<double> indices_of(const LinearParts<double>& p) { return steering_indices(coefficients(p).total()); }

std::string why_no_equations(const SteeringIndices<double>& i) {
  if (i.Kb == 0.0) return "Kb is 0: a rudder that does not change the drift angle does not tell the coupled equations";
  if (i.Kw == 0.0) return "Kw is 0: a rudder that does not change the yaw rate does not tell the coupled equations";
  return fmt::format("T3b and T3w are both {}: the indices do not tell the coupled equations", i.T3b);
}

bool determine_equations(const SteeringIndices<double>& i) { return i.Kb != 0.0 && i.Kw != 0.0 && i.T3b != i.T3w; }

SwayYawCoefficients<double> coefficients_of(const SteeringIndices<double>& i) {
  if (!determine_equations(i)) throw Refusal(why_no_equations(i));
  return coefficients_from(i);
}
SwayYawCoefficients<double> coefficients_of(const SwayYawCoefficients<double>& m) { return m; }
SwayYawCoefficients<double> coefficients_of(const LinearParts<double>& p) { return coefficients(p).total(); }

}  // namespace

SwayYawTransfer<double> transfer_functions(const LinearShip& ship) {
  if (const auto* i = std::get_if<SteeringIndices<double>>(&ship.form)) return transfer_functions(*i);
  return transfer_functions(coefficients(ship));
}

SteeringIndices<double> indices(const LinearShip& ship) {
  return std::visit([](const auto& form) { return indices_of(form); }, ship.form);
}

bool has_coefficients(const LinearShip& ship) {
  const auto* i = std::get_if<SteeringIndices<double>>(&ship.form);
  return !i || determine_equations(*i);
}

SwayYawCoefficients<double> coefficients(const LinearShip& ship) {
  return std::visit([](const auto& form) { return coefficients_of(form); }, ship.form);
}

SwayYawCoefficients<double> yaw_coefficients(const LinearShip& ship) {
  if (has_coefficients(ship)) return coefficients(ship);
  auto other = indices(ship);
  if (other.Kw == 0.0) throw Refusal(why_no_equations(other));
  other.Kb = other.Kw;
  other.T3b = other.T3w + other.T1_plus_T2 + 1.0;  // any but T3w
  if (other.T3b == other.T3w) other.T3b += 1.0;
  return coefficients_from(other);
}

SnameDerivatives<double> inertia(const LinearHull<double>& hull) {
  const double m = 2.0 * hull.c_B / hull.L_over_B;
  SnameDerivatives<double> d{};
  d.m = m;
  d.I_z = m * hull.r_z * hull.r_z;
  d.Y_vdot = -m * hull.k_22;
  d.N_rdot = -m * hull.r_66 * hull.r_66;
  return d;
}

}  // namespace swayaw::linear
