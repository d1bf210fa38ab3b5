#pragma once

#include <cstddef>
#include <tuple>

#include "swayaw/core/steering_gear.hpp"
#include "swayaw/nonlinear/models/parts/mathematical_rudder.hpp"
#include "swayaw/nonlinear/models/parts/prime_parts.hpp"

namespace swayaw::inline nonlinear {

/// A single- or twin-screw ship in the physics-uninformed model: linear or cubic hull, polynomial rudder.
/// Source: [Alexandersson2024]
template <class S = double>
struct PuShip {
  using Scalar = S;

  ViscousWater<S> water;
  PrimeParticulars<S> particulars;
  PrimeAddedMass<S> added_mass;
  PrimeHull<S> hull;
  PrimePropeller<S> propeller;
  MathematicalRudder<S> rudder;
  SteeringGear<S> steering_gear;

  static constexpr std::size_t branch_count = 1;

  /// Tables of the ship file and the parts they fill.
  static constexpr auto sections() {
    return std::tuple{
        Section<PuShip, ViscousWater<S>>{"water", &PuShip::water},
        Section<PuShip, PrimeParticulars<S>>{"particulars", &PuShip::particulars},
        Section<PuShip, PrimeAddedMass<S>>{"added_mass", &PuShip::added_mass},
        Section<PuShip, PrimeHull<S>>{"hull", &PuShip::hull},
        Section<PuShip, PrimePropeller<S>>{"propeller", &PuShip::propeller},
        Section<PuShip, MathematicalRudder<S>>{"rudder", &PuShip::rudder},
        Section<PuShip, SteeringGear<S>>{"rudder", &PuShip::steering_gear},
    };
  }
};

}  // namespace swayaw::nonlinear
