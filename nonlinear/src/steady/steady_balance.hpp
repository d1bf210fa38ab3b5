#pragma once

#include <Eigen/Core>
#include <memory>

#include "swayaw/nonlinear/ship.hpp"

/// Acceleration of a ship whose motion lasts. Not installed.
namespace swayaw::inline nonlinear::detail {

/// Acceleration (du, dv, dr)/dt and its derivatives by (u, v, r, delta).
struct SteadyBalance {
  Eigen::Vector3d acceleration;
  Eigen::Matrix<double, 3, 4> jacobian;
};

/// The equations of a motion that lasts, without what goes with the heading, for any model: who looks for steady
/// motions need not know which it is.
class SteadyEquations {
 public:
  /// @throws Refusal  if an effect of the ship cannot act on her
  SteadyEquations(const Ship& ship, const Controls<double>& propulsion);
  ~SteadyEquations();

  SteadyBalance at(const PlanarMotion<double>& m, double delta) const;

  /// Length of the ship [m].
  double L() const;

 private:
  class OfModel;
  template <class Model>
  class InDuals;
  std::unique_ptr<const OfModel> equations_;
  double L_;
};

}  // namespace swayaw::nonlinear::detail
