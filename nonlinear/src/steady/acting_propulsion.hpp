#pragma once

#include <optional>

#include "swayaw/nonlinear/effects/acting_ship.hpp"
#include "swayaw/nonlinear/models/controls.hpp"

/// What carries a ship with her effects, model by model. Not installed.
namespace swayaw::inline nonlinear::detail {

/// As ordered, else what carries her straight ahead at that speed with those of her effects that go with her motion
/// alone, and so act on a straight course all the time: what drags on her.
/// @throws as propulsion of a ship
template <class Model>
Controls<double> acting_propulsion(const ActingShip<Model>& acting, double speed, const std::optional<double>& rev = {},
                                   const std::optional<double>& thrust = {});

/// What carries her straight ahead at that speed on that heading, with all that acts on her now, wind and waves among
/// it; where these push her faster than that, what carries her without them.
/// @throws as self_propulsion
template <class Model>
Controls<double> settled_propulsion(const ActingShip<Model>& acting, double speed, double psi);

extern template Controls<double> acting_propulsion(const ActingShip<MmgShip<double>>&, double,
                                                   const std::optional<double>&, const std::optional<double>&);
extern template Controls<double> acting_propulsion(const ActingShip<PiShip<double>>&, double,
                                                   const std::optional<double>&, const std::optional<double>&);
extern template Controls<double> acting_propulsion(const ActingShip<PuShip<double>>&, double,
                                                   const std::optional<double>&, const std::optional<double>&);
extern template Controls<double> acting_propulsion(const ActingShip<AbkowitzShip<double>>&, double,
                                                   const std::optional<double>&, const std::optional<double>&);

extern template Controls<double> settled_propulsion(const ActingShip<MmgShip<double>>&, double, double);
extern template Controls<double> settled_propulsion(const ActingShip<PiShip<double>>&, double, double);
extern template Controls<double> settled_propulsion(const ActingShip<PuShip<double>>&, double, double);
extern template Controls<double> settled_propulsion(const ActingShip<AbkowitzShip<double>>&, double, double);

}  // namespace swayaw::nonlinear::detail
