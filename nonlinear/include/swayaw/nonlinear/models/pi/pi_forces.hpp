#pragma once

#include <array>

#include "swayaw/nonlinear/models/parts/lifting_line_forces.hpp"
#include "swayaw/nonlinear/models/parts/prime_forces.hpp"
#include "swayaw/nonlinear/models/pi/pi_ship.hpp"

/// Forces of the physics-informed model, written once for double, dual and pack.
/// Valid for way ahead, u > 0, and a shaft that turns ahead, or a given thrust (validity.hpp). Source:
/// [Alexandersson2024]
namespace swayaw::inline nonlinear {

/// Names of the branches.
struct PiBranch {
  static constexpr std::size_t wake = 0;              ///< beta_P > 0
  static constexpr std::size_t gap = 1;               ///< |delta| > delta_lim
  static constexpr std::size_t gap_lifts = 2;         ///< K_gap > 0
  static constexpr std::size_t crossflow = 3;         ///< gamma_g > 0
  static constexpr std::size_t attack_port = 4;       ///< alpha > 0 at the port or only rudder
  static constexpr std::size_t attack_starboard = 5;  ///< alpha > 0 at the starboard rudder
};

/// Propellers and what reaches the rudders behind them.
template <class S>
struct PiFlow {
  Sides<S> thrust;  ///< [N]
  Sides<PropellerRace<S>> race;
  Sides<RudderInflow<S>> inflow;
};

template <class S>
PiFlow<S> flow_at_rudders(const PiShip<S>& ship, const PlanarMotion<S>& m, const Controls<S>& controls,
                          const Mask<S>& beta_P_positive, const Mask<S>& gamma_g_positive) {
  const auto& k = ship.rudder;
  const S V_A = propeller_inflow(ship, m, beta_P_positive);
  const S r_0 = 0.5 * ship.propeller.D;
  PiFlow<S> flow{.thrust = propeller_thrust(ship, controls, V_A), .race = {}, .inflow = {}};
  flow.race.port = race_at(k.x, r_0, ship.water.rho, V_A, flow.thrust.port);
  flow.inflow.port = rudder_inflow(k, m, flow.race.port, k.y_R_port, gamma_g_positive);
  if (ship.propeller.twin()) {
    flow.race.starboard = race_at(k.x, r_0, ship.water.rho, V_A, flow.thrust.starboard);
    flow.inflow.starboard = rudder_inflow(k, m, flow.race.starboard, k.y_R_starboard, gamma_g_positive);
  }
  return flow;
}

/// The branch functions at a flow that was found with the signs of beta_P and V_g.
template <class S>
std::array<S, 6> branch_functions(const PiShip<S>& ship, const S& delta, const S& beta_P, const S& V_g,
                                  const PiFlow<S>& flow) {
  const auto& k = ship.rudder;
  const auto has_gap = k.s != S(0.0);
  const S beyond = abs(delta) - k.delta_lim;
  return {
      beta_P,
      select(has_gap, beyond, S(-1.0)),
      k.gap_clipped() ? select(beyond > S(0.0), S(1.0 + k.s * beyond * beyond), S(1.0)) : S(1.0),
      V_g,
      delta + k.gamma_0_port + flow.inflow.port.gamma,
      ship.propeller.twin() ? S(delta + k.gamma_0_starboard + flow.inflow.starboard.gamma) : S(1.0),
  };
}

/// Where the force has a kink or a jump; see PiBranch. A term that the ship does not have never changes.
template <class S>
std::array<S, 6> branch_functions(const PiShip<S>& ship, const PlanarMotion<S>& m, const Controls<S>& controls) {
  const S beta_P = wake_branch_function(ship, m);
  const S V_g = geometric_crossflow(ship.rudder, m);
  return branch_functions(ship, controls.delta, beta_P, V_g,
                          flow_at_rudders(ship, m, controls, beta_P > S(0.0), V_g > S(0.0)));
}

/// Forces split by part, about midship.
template <class S>
struct PiForces {
  PlanarForce<S> hull;
  PlanarForce<S> propeller;
  PlanarForce<S> rudder;
  PlanarForce<S> rudder_hull_interaction;

  PlanarForce<S> total() const { return hull + propeller + rudder + rudder_hull_interaction; }

  std::array<ForcePart<S>, 4> parts() const {
    return {{{"hull", hull},
             {"propeller", propeller},
             {"rudder", rudder},
             {"rudder_hull_interaction", rudder_hull_interaction}}};
  }
};

/// Force of the rudder, or of both, without that on the hull.
template <class S>
PlanarForce<S> rudder_force(const PiShip<S>& ship, const S& delta, const PiFlow<S>& flow, const Branch<S, 6>& branch) {
  const auto& k = ship.rudder;
  const auto plan = planform(k);
  const S K_gap = gap_factor(k, delta, branch[PiBranch::gap], branch[PiBranch::gap_lifts]);
  const auto one = [&](const PropellerRace<S>& race, const RudderInflow<S>& inflow, const S& gamma_0, const S& y_R,
                       const Mask<S>& alpha_positive) {
    const S alpha_f = gamma_0 + inflow.gamma;
    const S lambda_R = lift_diminution(race, plan.chord);
    const auto f = lift_and_drag(k, ship.water.rho, ship.water.nu, plan, lambda_R, inflow, S(delta + alpha_f),
                                 alpha_positive, K_gap);
    return turned_to_ship(f, alpha_f, k.x_R, y_R);
  };
  const auto port = one(flow.race.port, flow.inflow.port, k.gamma_0_port, k.y_R_port, branch[PiBranch::attack_port]);
  if (!ship.propeller.twin()) return port;
  return port + one(flow.race.starboard, flow.inflow.starboard, k.gamma_0_starboard, k.y_R_starboard,
                    branch[PiBranch::attack_starboard]);
}

/// All forces in a given flow.
template <class S>
PiForces<S> forces(const PiShip<S>& ship, const PlanarMotion<S>& m, const S& delta, const PiFlow<S>& flow,
                   const Branch<S, 6>& branch) {
  const auto rudder = rudder_force(ship, delta, flow, branch);
  return {
      .hull = hull_force(ship, m),
      .propeller = propeller_force(ship.propeller, flow.thrust),
      .rudder = rudder,
      .rudder_hull_interaction = rudder_hull_interaction(ship.rudder, rudder),
  };
}

/// All forces, on a given branch.
template <class S>
PiForces<S> forces(const PiShip<S>& ship, const PlanarMotion<S>& m, const Controls<S>& controls,
                   const Branch<S, 6>& branch) {
  return forces(ship, m, controls.delta,
                flow_at_rudders(ship, m, controls, branch[PiBranch::wake], branch[PiBranch::crossflow]), branch);
}

/// All forces on the branch of the motion; the flow that tells the branch is found once.
template <class S>
PiForces<S> forces(const PiShip<S>& ship, const PlanarMotion<S>& m, const Controls<S>& controls) {
  const S beta_P = wake_branch_function(ship, m);
  const S V_g = geometric_crossflow(ship.rudder, m);
  const auto flow = flow_at_rudders(ship, m, controls, beta_P > S(0.0), V_g > S(0.0));
  const auto g = branch_functions(ship, controls.delta, beta_P, V_g, flow);
  Branch<S, 6> branch{};
  for (std::size_t i = 0; i < g.size(); ++i) branch[i] = g[i] > S(0.0);
  return forces(ship, m, controls.delta, flow, branch);
}

}  // namespace swayaw::nonlinear
