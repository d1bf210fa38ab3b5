#pragma once

#include <algorithm>
#include <cmath>

#include "model_ships.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"
#include "swayaw/nonlinear/surroundings/windage_sources.hpp"

/// Seeded effects that can act on a ship.
namespace swayaw::test {

/// A ship with something for the wind to take hold of.
inline Ship with_areas(const ShipModel& model) {
  Ship ship = ship_of(model);
  const double L = length(ship);
  ship.surroundings.windage = *windage_from({.frontal = 0.02 * L * L, .lateral = 0.08 * L * L, .length = L});
  return ship;
}

class RandomEffects {
 public:
  explicit RandomEffects(unsigned seed) : random_(seed), of_others_(seed) {}

  double uniform(double low, double high) { return random_.uniform(low, high); }

  /// Some way off null, in every number that the model has; nothing if the effect cannot act on it.
  std::optional<Effect> of_kind(std::string_view id, const Ship& ship) {
    Effect effect = make_effect(id);
    if (id == ShallowWater<>::id) parameter_value(effect, 0) = uniform(1.3, 3.0);
    if (id == RudderStall<>::id) parameter_value(effect, 0) = uniform(0.1, 0.3);
    if (!cannot_act(ship.model, effect).empty()) return std::nullopt;
    if (id == ShallowWater<>::id || id == RudderStall<>::id) return effect;
    const auto numbers = parameters_of(ship, effect);
    if (numbers.empty()) return std::nullopt;
    // numbers of their own for some instruments and the lever: those of the others make ships that are known to sail
    const bool by_itself = id == VelocityAxes<>::id || id == ClockDrift<>::id || id == ChannelFilter<>::id;
    for (const auto& n : numbers)
      parameter_value(effect, n.index) = off_null(n, by_itself || n.key == "rudder_lever_m" ? of_others_ : random_);
    if (id == HullLinearDerivatives<>::id || id == HullNonlinearDamping<>::id) keep_damped(effect, numbers);
    std::visit([&](auto& e) { set_window(e, ship); }, effect);
    // a clock that jumps ahead leaves a gap, and which angles the rudder had in it nothing tells
    if (auto* clock = std::get_if<ClockDrift<>>(&effect)) *clock = {.channel = Channel::delta, .rate = clock->rate};
    if (auto* filter = std::get_if<ChannelFilter<>>(&effect)) filter->time *= 0.5;  // as on board, 0.01 to 0.02 L/U
    if (auto* gap = std::get_if<RudderGap<>>(&effect)) gap->delta_lim = uniform(0.04, 0.08);  // opens in any zigzag
    if (auto* gear = std::get_if<SteeringGearLag<>>(&effect)) gear->rate = 0.5 * steering_gear(ship).rate;
    return effect;
  }

 private:
  /// Other derivatives may leave a ship without any bounded motion: more of each is safe.
  static void keep_damped(Effect& effect, std::span<const Parameter> numbers) {
    for (const auto& n : numbers) parameter_value(effect, n.index) = n.null;
    for (const auto& n : numbers)
      if (n.key == "N_r" || n.key == "Y_v" || n.key == "N_rrr" || n.key == "Y_vvv")
        parameter_value(effect, n.index) = n.null - 0.2 * std::abs(n.null) - (n.null == 0.0 ? 0.01 : 0.0);
  }

  static double off_null(const Parameter& n, RandomModels& random) {
    const double sign = random.uniform(-1.0, 1.0) < 0.0 ? -1.0 : 1.0, size = random.uniform(0.2, 0.4) * n.deviation;
    const double base = std::isfinite(n.null) ? n.null : 0.0;
    const double value = base + sign * size;
    return n.range.contains(value) ? value : base - sign * size;
  }

  template <class Kind>
  void set_window(Kind&, const Ship&) {}

  template <BeginsAndEnds Kind>
  void set_window(Kind& effect, const Ship& ship) {
    const double time_unit = time_unit_of(ship);
    effect.onset = uniform(1.0, 4.0) * time_unit;
    effect.end = effect.onset + uniform(1.0, 4.0) * time_unit;
  }

  RandomModels random_, of_others_;
};

}  // namespace swayaw::test
