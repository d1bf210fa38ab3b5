#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "swayaw/nonlinear/effects/acting_effects.hpp"
#include "swayaw/nonlinear/instruments/instruments.hpp"
#include "swayaw/nonlinear/ship.hpp"

/// A ship as her effects make her.
///
/// Effects act in this order: parameters of the model, air and water, added forces, actuators, sensors. Whatever
/// simulates, balances or linearizes a ship takes her from here; without effects the model and her surroundings are
/// those of the ship.
namespace swayaw::inline nonlinear {

/// What begins or ends to act at a time: a gust, an unknown force.
struct Change {
  double time;  ///< [s]
  Wind<double> wind;
  bool windy;
  std::uint32_t acting;  ///< which effects act in her motion, as in ActingEffects

  template <class S>
  void blow(Surroundings<S>& around) const {
    around.wind = {S(wind.speed), S(wind.from)}, around.windy = windy;
  }

  template <class S, class T>
  void apply(Surroundings<S>& around, ActingEffects<T>& added) const {
    blow(around);
    added.acting = acting;
  }
};

template <class Model>
struct ActingShip {
  Model model;                        ///< its parameters as the effects change them
  Surroundings<double> surroundings;  ///< before the first change
  std::vector<Change> changes;        ///< in order of time
  ActingEffects<double> added;        ///< before the first change
  RudderActuator rudder;
  Instruments<double> instruments;

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

/// When effects begin and end, and what acts from then on.
std::vector<Change> changes_of(const Ship& ship);

/// What lies between the recorded rudder angle and the rudder.
RudderActuator rudder_actuator(const Ship& ship);

/// Her instruments.
Instruments<double> instruments_of(const Ship& ship);

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

/// The effects that do something.
std::vector<Effect> active_effects(const Ship& ship);

/// The model with its parameters as effects change them, in any scalar; effects of other kinds are passed over.
template <class Model>
Model changed_by(std::span<const EffectIn<typename Model::Scalar>> effects, Model model) {
  for (const auto& effect : effects) std::visit([&](const auto& e) { change_model(model, e); }, effect);
  return model;
}

/// The ship whose model and surroundings hold what they can of her effects: changed parameters, steady wind and
/// current. The others stay in her list: added forces, gusts, actuators, sensors.
/// @throws Refusal  as cannot_act tells
Ship with_effects_applied(const Ship& ship);

/// The ship with one more effect.
Ship with_effect(const Ship& ship, const Effect& effect);

// ---------------------------------------------------------------- parameters of effects, on a ship

/// The parameters of an effect that the model of the ship has a place for; none if it cannot act. One that is
/// `unchanged` has the value of the ship.
std::vector<Parameter> parameters_of(const Ship& ship, const Effect& effect);

// ---------------------------------------------------------------- implementation

extern template ActingShip<MmgShip<double>> acting_ship(const Ship&, const MmgShip<double>&);
extern template ActingShip<PiShip<double>> acting_ship(const Ship&, const PiShip<double>&);
extern template ActingShip<PuShip<double>> acting_ship(const Ship&, const PuShip<double>&);
extern template ActingShip<AbkowitzShip<double>> acting_ship(const Ship&, const AbkowitzShip<double>&);

}  // namespace swayaw::nonlinear
