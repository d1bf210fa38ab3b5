#pragma once

#include <cstddef>
#include <tuple>

#include "swayaw/core/steering_gear.hpp"
#include "swayaw/nonlinear/models/parts/lifting_line_rudder.hpp"
#include "swayaw/nonlinear/models/parts/prime_parts.hpp"

namespace swayaw::inline nonlinear {

/// A single- or twin-screw ship in the physics-informed model: linear or cubic hull, semi-empirical rudder.
/// Source: [Alexandersson2024]
template <class S = double>
struct PiShip {
  using Scalar = S;

  ViscousWater<S> water;
  PrimeParticulars<S> particulars;
  PrimeAddedMass<S> added_mass;
  PrimeHull<S> hull;
  PrimePropeller<S> propeller;
  LiftingLineRudder<S> rudder;
  SteeringGear<S> steering_gear;

  static constexpr std::size_t branch_count = 6;

  /// Tables of the ship file and the parts they fill.
  static constexpr auto sections() {
    return std::tuple{
        Section<PiShip, ViscousWater<S>>{"water", &PiShip::water},
        Section<PiShip, PrimeParticulars<S>>{"particulars", &PiShip::particulars},
        Section<PiShip, PrimeAddedMass<S>>{"added_mass", &PiShip::added_mass},
        Section<PiShip, PrimeHull<S>>{"hull", &PiShip::hull},
        Section<PiShip, PrimePropeller<S>>{"propeller", &PiShip::propeller},
        Section<PiShip, LiftingLineRudder<S>>{"rudder", &PiShip::rudder},
        Section<PiShip, SteeringGear<S>>{"rudder", &PiShip::steering_gear},
    };
  }
};

}  // namespace swayaw::nonlinear
