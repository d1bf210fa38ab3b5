#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "swayaw/nonlinear/added_forces.hpp"
#include "swayaw/nonlinear/changed_numbers.hpp"
#include "swayaw/nonlinear/ship.hpp"

/// A ship as her effects make her.
///
/// Effects act in this order: numbers of the model, air and water, added forces, actuators, sensors. Whatever
/// simulates, balances or linearizes a ship takes her from here; without effects the model and her surroundings are
/// those of the ship.
namespace swayaw {

/// What begins or ends to act at a time: a gust, an unknown force.
struct Change {
  double time;  ///< [s]
  Wind<double> wind;
  bool windy;
  bool mapped;  ///< whether the unknown force acts

  template <class S>
  void apply(Surroundings<double>& around, AddedForces<S>& added) const {
    around.wind = wind, around.windy = windy;
    added.mapped = mapped;
  }
};

/// What lies between a recorded rudder angle and the rudder, in this order: play, lag with its largest rate, offset.
struct RudderActuator {
  double width = 0.0;                                     ///< of the play [rad]
  double lag = 0.0;                                       ///< T [s]
  double rate = std::numeric_limits<double>::infinity();  ///< [rad/s]
  double offset = 0.0;                                    ///< [rad]
  double record_delay = 0.0;                              ///< of the recorded angle [s]

  bool any() const { return moves() || offset != 0.0 || record_delay != 0.0; }

  /// Whether the rudder has a motion of its own.
  bool moves() const { return width > 0.0 || lag > 0.0 || rate < std::numeric_limits<double>::infinity(); }
};

template <class Model>
struct ActingShip {
  Model model;                        ///< its numbers as the effects change them
  Surroundings<double> surroundings;  ///< before the first change
  std::vector<Change> changes;        ///< in order of time
  AddedForces<double> added;          ///< before the first change
  RudderActuator rudder;
  std::vector<Effect> sensors;

  /// As she is at a time.
  ActingShip at(double time) const {
    ActingShip now = *this;
    for (const auto& change : changes)
      if (change.time <= time) change.apply(now.surroundings, now.added);
    return now;
  }
};

/// Wind and current of the ship at a time; constant between the times of changes_of.
Surroundings<double> surroundings_at(const Ship& ship, double time);

/// When gusts and an unknown force begin and end, and what acts from then on.
std::vector<Change> changes_of(const Ship& ship);

/// What lies between the recorded rudder angle and the rudder.
RudderActuator rudder_actuator(const Ship& ship);

/// Effects of her instruments.
std::vector<Effect> sensor_effects(const Ship& ship);

/// Forces that the effects add to a model of a ship with these dimensions, in any scalar. Effects of other kinds are
/// passed over.
template <class Model, class S = typename Model::Scalar>
AddedForces<S> added_forces(const Model& model, std::span<const EffectIn<S>> effects);

/// Why the effect cannot act on the model, in words; empty if it can. The wind needs a windage besides.
std::string cannot_act(const ShipModel& model, const Effect& effect);

/// The ship with her effects at work.
/// @throws Refusal  as cannot_act tells
template <class Model>
ActingShip<Model> acting_ship(const Ship& ship, const Model& model);

/// Calls f with the acting ship of her model.
template <class F>
decltype(auto) visit_acting(const Ship& ship, F&& f) {
  return std::visit([&](const auto& model) -> decltype(auto) { return std::forward<F>(f)(acting_ship(ship, model)); },
                    ship.model);
}

/// The ship whose model and surroundings hold what they can of her effects: changed numbers, steady wind and current.
/// The others stay in her list: added forces, gusts, actuators, sensors.
/// @throws Refusal  as cannot_act tells
Ship with_effects_applied(const Ship& ship);

/// The same without effects of her instruments, for a run that as_it_was has put right.
Ship without_sensor_effects(const Ship& ship);

/// The ship with one more effect.
Ship with_effect(const Ship& ship, const Effect& effect);

// ---------------------------------------------------------------- numbers of effects, on a ship

/// The parameters of an effect that the model of the ship has a place for; none if it cannot act. One that is
/// `unchanged` has the value of the ship.
std::vector<Parameter> parameters_of(const Ship& ship, const Effect& effect);

// ---------------------------------------------------------------- implementation

template <class Model, class S>
AddedForces<S> added_forces(const Model& model, std::span<const EffectIn<S>> effects) {
  AddedForces<S> a;
  a.rho = model.water.rho;
  a.L = model.particulars.L;
  a.U_0 = model.particulars.U_0;
  if constexpr (requires { model.particulars.d; }) {
    const auto& p = model.particulars;
    a.d = p.d;
    a.k_xx = 0.4 * p.B;
  }
  if constexpr (requires { model.propeller.x_P; }) a.x_P = model.propeller.x_P;
  if constexpr (std::is_same_v<Model, MmgShip<S>>) a.x_P = a.x_P * a.L;
  if (value_of(a.x_P) == 0.0) a.x_P = -0.5 * a.L;
  const auto take = [&]<class Kind>(bool& there, Kind& place) {
    if (const auto* found = find<Kind>(effects)) {
      there = true;
      place = *found;
    }
  };
  take(a.cross_flow, a.drag);
  take(a.waves, a.wave);
  take(a.side_force, a.side);
  take(a.roll, a.coupling);
  take(a.memory, a.lag);
  take(a.droop, a.drop);
  take(a.mapped, a.map);
  if constexpr (requires { model.particulars.B; }) {
    if (std::isnan(value_of(a.coupling.GM))) a.coupling.GM = 0.05 * model.particulars.B;
    if (std::isnan(value_of(a.coupling.lever))) a.coupling.lever = 0.5 * a.d;
  }
  return a;
}

extern template ActingShip<MmgShip<double>> acting_ship(const Ship&, const MmgShip<double>&);
extern template ActingShip<PiShip<double>> acting_ship(const Ship&, const PiShip<double>&);
extern template ActingShip<PuShip<double>> acting_ship(const Ship&, const PuShip<double>&);
extern template ActingShip<AbkowitzShip<double>> acting_ship(const Ship&, const AbkowitzShip<double>&);

}  // namespace swayaw
