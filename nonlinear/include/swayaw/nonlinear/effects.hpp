#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "swayaw/core/scalar.hpp"
#include "swayaw/nonlinear/force_effects.hpp"
#include "swayaw/nonlinear/instrument_effects.hpp"
#include "swayaw/nonlinear/number_effects.hpp"

/// What a model left out, as values: added to a ship, written to her file, simulated and fitted.
namespace swayaw {

/// Every effect that can be simulated, in the order of the table of docs/effects.md.
template <class S>
using EffectIn =
    std::variant<SteadyWind<S>, Gust<S>, SteadyCurrent<S>, WaveDrift<S>, ShallowWater<S>, HullLinearDerivatives<S>,
                 HullNonlinearDamping<S>, CrossFlowDrag<S>, AddedResistance<S>, SpeedLossInTurn<S>, AddedMass<S>,
                 RudderEffectiveness<S>, RudderHullInteraction<S>, RudderStall<S>, RudderGap<S>, FlowStraightening<S>,
                 RaceOnRudder<S>, PropellerSideForce<S>, WakeChange<S>, ShaftSpeedDrop<S>, RudderOffset<S>,
                 SteeringGearLag<S>, SteeringGearBacklash<S>, RollCoupling<S>, FluidMemory<S>, HeadingBias<S>,
                 GyroBias<S>, LogScale<S>, AntennaLeverArm<S>, ChannelDelay<S>, UnknownForce<S>>;

using Effect = EffectIn<double>;

inline constexpr std::size_t effect_count = std::variant_size_v<Effect>;

/// Names of all effects, as in ship files.
std::span<const std::string_view> effect_ids();

/// The effect of that name where it does nothing; nothing if there is none of that name.
std::optional<Effect> effect_named(std::string_view id);

/// The effect of that name where it does nothing.
/// @throws std::domain_error  if there is none of that name
Effect make_effect(std::string_view id);

template <class S>
std::string_view id_of(const EffectIn<S>& effect) {
  return std::visit([](const auto& e) { return e.id; }, effect);
}

template <class S>
EffectPlace place_of(const EffectIn<S>& effect) {
  return std::visit([](const auto& e) { return e.place; }, effect);
}

/// Calls visit(parameter, number) for every number of an effect, in the order of its list.
template <class E, class Visit>
void for_each_parameter(E& effect, Visit&& visit) {
  const auto visit_kind = [&](auto& e) {
    for (const auto& parameter : e.parameters()) visit(parameter, e.*parameter.member);
  };
  std::visit(visit_kind, effect);
}

/// How many numbers an effect has.
template <class S>
std::size_t parameter_count(const EffectIn<S>& effect) {
  return std::visit([](const auto& e) { return e.parameters().size(); }, effect);
}

/// A number of an effect by its place in the list.
template <class S>
S& parameter_value(EffectIn<S>& effect, std::size_t index) {
  return std::visit([&](auto& e) -> S& { return e.*(e.parameters()[index].member); }, effect);
}

template <class S>
const S& parameter_value(const EffectIn<S>& effect, std::size_t index) {
  return parameter_value(const_cast<EffectIn<S>&>(effect), index);
}

/// Whether an effect of that kind does nothing: every number that decides has its null value.
template <class S>
bool is_null(const EffectIn<S>& effect) {
  bool null = true;
  for_each_parameter(effect, [&](const auto& p, const S& number) {
    const bool same = value_of(number) == p.null || (std::isnan(p.null) && std::isnan(value_of(number)));
    null = null && (same || !p.decides);
  });
  return null;
}

/// The effect of that kind in a list, or nullptr.
template <class Kind, class S>
const Kind* find(std::span<const EffectIn<S>> effects) {
  for (const auto& effect : effects)
    if (const auto* found = std::get_if<Kind>(&effect)) return found;
  return nullptr;
}

/// The same effect with another scalar.
template <class To, class From>
EffectIn<To> cast(const EffectIn<From>& effect) {
  const auto cast_kind = []<template <class> class Kind>(const Kind<From>& e) -> EffectIn<To> {
    return cast_effect<To>(e);
  };
  return std::visit(cast_kind, effect);
}

}  // namespace swayaw
