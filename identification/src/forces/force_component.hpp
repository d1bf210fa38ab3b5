#pragma once

#include <array>

#include "swayaw/core/motion.hpp"
#include "swayaw/identification/captive.hpp"
#include "swayaw/nonlinear/ship.hpp"

/// Surge force, sway force and yaw moment one by one. Not installed.
namespace swayaw::inline identification::detail {

inline constexpr std::array force_components{ForceComponent::X, ForceComponent::Y, ForceComponent::N};

template <class S>
S& component_of(PlanarForce<S>& force, ForceComponent component) {
  return component == ForceComponent::X ? force.X : component == ForceComponent::Y ? force.Y : force.N;
}

template <class S>
S component_of(const PlanarForce<S>& force, ForceComponent component) {
  return component == ForceComponent::X ? force.X : component == ForceComponent::Y ? force.Y : force.N;
}

/// ½ρL²U² [N], of the moment ½ρL³U² [N m].
template <class S>
S force_unit(const Ship& ship, const S& U, ForceComponent component) {
  const double rho = std::visit([](const auto&model) { return model.water.rho; }, ship.model), L = length(ship);
  return 0.5 * rho * L * L * U * U * (component == ForceComponent::N ? L : 1.0);
}

}  // namespace swayaw::identification::detail
