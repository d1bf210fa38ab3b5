#pragma once

#include "abkowitz_ships.hpp"
#include "prime_ships.hpp"
#include "random_ships.hpp"
#include "swayaw/nonlinear/models/models.hpp"

/// Seeded ships of every model, for laws that all models share.
namespace swayaw::test {

class RandomModels {
 public:
  explicit RandomModels(unsigned seed) : mmg_(seed), prime_(seed), abkowitz_(seed) {}

  double uniform(double low, double high) { return mmg_.uniform(low, high); }

  /// Every number shaken; every term and option of the model is there in some of the ships.
  template <class Model>
  Model ship() {
    if constexpr (std::is_same_v<Model, MmgShip<double>>) return with_torque_limit(mmg_.ship());
    else if constexpr (std::is_same_v<Model, PiShip<double>>) return prime_.pi();
    else if constexpr (std::is_same_v<Model, PuShip<double>>) return prime_.pu();
    else return abkowitz_.ship();
  }

  /// Way ahead with drift up to 20 deg and r' up to 0.6.
  template <class Model>
  PlanarMotion<double> motion(const Model& ship) {
    return prime_.motion(ship.particulars.L, ship.particulars.U_0);
  }

  /// Rudder up to 40 deg, with a shaft speed or thrust near that of self-propulsion.
  template <class Model>
  Controls<double> controls(const Model& ship) {
    const double U = ship.particulars.U_0;
    Controls<double> c{.delta = uniform(-0.7, 0.7), .by_thrust = uniform(0, 1) < 0.5};
    if constexpr (requires { ship.propeller; }) {
      const double D = ship.propeller.D, T = ship.water.rho * D * D * U * U;
      c.rev = uniform(1.1, 2.0) * U / D;
      c.thrust = {uniform(0.1, 0.4) * T, uniform(0.1, 0.4) * T};
    }
    return c;
  }

 private:
  /// Half of the ships have an engine that gives less than the ordered shaft speed takes, in some motions.
  MmgShip<double> with_torque_limit(MmgShip<double> ship) {
    ship.engine.kind.index = uniform(0, 1) < 0.5;
    ship.propeller.q_0 = uniform(0.03, 0.05);
    ship.propeller.q_1 = uniform(-0.03, -0.02);
    ship.propeller.q_2 = uniform(-0.02, -0.01);
    const double D = ship.propeller.D, U = ship.particulars.U_0;
    ship.engine.Q_max = uniform(0.01, 0.1) * ship.water.rho * D * D * D * U * U;
    return ship;
  }

  RandomShips mmg_;
  RandomPrimeShips prime_;
  RandomAbkowitz abkowitz_;
};

// ---------------------------------------------------------------- without asymmetric numbers

inline MmgShip<double> symmetric(MmgShip<double> ship) {
  ship.rudder.gamma_R_negative = ship.rudder.gamma_R_positive;
  ship.propeller.C_2_negative = ship.propeller.C_2_positive;
  return ship;
}

inline void make_symmetric(LiftingLineRudder<double>& k, bool twin) {
  k.y_R_port = -k.y_R_starboard;
  k.gamma_0_port = twin ? -k.gamma_0_starboard : 0.0;
}

inline void make_symmetric(MathematicalRudder<double>&, bool) {}

template <PrimeShip Model>
Model symmetric(Model ship) {
  ship.hull.Y_0 = ship.hull.N_0 = 0.0;
  ship.propeller.y_P_port = -ship.propeller.y_P_starboard;
  ship.propeller.C_2_negative = ship.propeller.C_2_positive;
  make_symmetric(ship.rudder, ship.propeller.twin());
  return ship;
}

inline Ship ship_of(const ShipModel& model) {
  return {.name = "test ship", .model = model, .confidence = {}, .surroundings = {}};
}

}  // namespace swayaw::test
