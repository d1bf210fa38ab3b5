#pragma once

#include <array>

#include "swayaw/nonlinear/models/mmg/mmg_forces.hpp"

/// The forces of a model part by part, as people read them. Not installed.
namespace swayaw::inline nonlinear::detail {

template <class Model, class Forces>
auto force_parts(const Model&, const Forces& split) {
  return split.parts();
}

/// What the rudder makes the hull bear, a_H times its side force at x_H, stands by itself: the law of the rudder has
/// both together.
inline std::array<ForcePart<double>, 4> force_parts(const MmgShip<double>& ship, const MmgForces<double>& split) {
  const auto& k = ship.rudder;
  const double whole = 1.0 + k.a_H, share = whole != 0.0 ? k.a_H / whole : 0.0;
  const PlanarForce<double> induced{0.0, share * split.rudder.Y, share * split.rudder.Y * k.x_H * ship.particulars.L};
  const PlanarForce<double> rudder{split.rudder.X, split.rudder.Y - induced.Y, split.rudder.N - induced.N};
  return {
      {{"hull", split.hull}, {"propeller", split.propeller}, {"rudder", rudder}, {"rudder_hull_interaction", induced}}};
}

}  // namespace swayaw::nonlinear::detail
