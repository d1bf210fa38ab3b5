#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "swayaw/core/scalar.hpp"
#include "swayaw/nonlinear/effects/effect_list.hpp"
#include "swayaw/nonlinear/effects/instrument.hpp"
#include "swayaw/nonlinear/effects/other_values.hpp"

/// What a model left out, as values: added to a ship, written to her file, simulated and fitted.
namespace swayaw::inline nonlinear {

using Effect = EffectIn<double>;

inline constexpr std::size_t effect_count = std::variant_size_v<Effect>;

/// Names of all effects, as in ship files.
std::span<const std::string_view> effect_ids();

/// The effect of that name where it does nothing; nothing if there is none of that name.
std::optional<Effect> effect_named(std::string_view id);

/// The effect of that name where it does nothing.
/// @throws std::domain_error  if there is none of that name
Effect make_effect(std::string_view id);

// ---------------------------------------------------------------- what a kind does, told by its functions

template <class Kind>
concept ChangesModel = puts_values<Kind>() || requires(MmgShip<double>& model, const Kind& e) {
  change(model, e);
};

template <class Kind>
concept AddsForce = requires(const MmgShip<double>& model, const Kind& e, const Circumstances<double>& now) {
  force(e, model, now);
};

template <class Kind>
concept DrivesEngine = requires(const Kind& e, const ShipFacts<double>& ship, const PlanarMotion<double>& m,
                                Controls<double>& controls) {
  drive(e, ship, m, controls);
};

template <class Kind>
concept GivesWind = requires(const Kind& e) {
  wind(e);
};

template <class Kind>
concept GivesCurrent = requires(const Kind& e) {
  current(e);
};

template <class Kind>
concept ActuatesRudder = requires(const Kind& e, RudderActuator& actuator) {
  actuate(e, actuator);
};

template <class Kind>
concept IsInstrument = requires(Instruments<double>& instruments, const Kind& e) {
  put_on(instruments, e);
};

/// In how many ways effects of a kind act; an instrument may be of the rudder besides.
template <class Kind>
constexpr int ways_to_act = ChangesModel<Kind> + AddsForce<Kind> + DrivesEngine<Kind> + GivesWind<Kind> +
                            GivesCurrent<Kind> + (ActuatesRudder<Kind> && !IsInstrument<Kind>)+IsInstrument<Kind>;

/// Calls `visit.operator()<Kind>()` for every kind.
template <class Visit>
constexpr void for_each_kind(Visit&& visit) {
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (visit.template operator()<std::variant_alternative_t<I, Effect>>(), ...);
  }
  (std::make_index_sequence<effect_count>());
}

// ---------------------------------------------------------------- one effect

std::string_view id_of(const Effect& effect);

EffectPlace place_of(const Effect& effect);

Scope scope_of(const Effect& effect);

const EffectText& text_of(const Effect& effect);

/// Its phrase and its label, with the channel that it is of: "a channel that is late (rudder)".
std::string phrase_of(const Effect& effect);
std::string label_of(const Effect& effect);

/// Calls visit(parameter, value) for every parameter of an effect, in the order of its list.
template <class E, class Visit>
void for_each_parameter(E& effect, Visit&& visit) {
  const auto visit_kind = [&](auto& e) {
    for (const auto& parameter : parameter_list<std::remove_cvref_t<decltype(e)>>)
      visit(parameter, e.*parameter.member);
  };
  std::visit(visit_kind, effect);
}

/// How many parameters an effect has.
std::size_t parameter_count(const Effect& effect);

/// A parameter of an effect by its place in the list.
double& parameter_value(Effect& effect, std::size_t index);
const double& parameter_value(const Effect& effect, std::size_t index);

/// Whether an effect of that kind does nothing: every parameter that decides has its null value.
bool is_null(const Effect& effect);

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

// ---------------------------------------------------------------- what some have

/// From when to when an effect acts [s].
struct ActingTime {
  double onset, end;
};

/// Nothing for an effect that acts all the time.
std::optional<ActingTime> acting_time(const Effect& effect);

/// Whether effects of that kind begin and end.
bool begins_and_ends(const Effect& effect);

/// Whether an effect acts at a time.
bool acts_at(const Effect& effect, double time);

/// The channel that an effect is of, or nullptr.
Channel* channel_of(Effect& effect);
const Channel* channel_of(const Effect& effect);

/// What a file must give of the effect besides its required numbers, in words; empty if nothing.
std::string_view lacks(const Effect& effect);

/// Whether a ship cannot have both: at most one of a kind, but of different channels, and one for each jump of a clock.
bool exclude_each_other(const Effect& a, const Effect& b);

/// The quantity that a wrong instrument shows wrong; nothing for forces.
std::string_view shown_wrong(const Effect& effect);

/// Whether it is a loss of lift of the rudder.
bool takes_rudder_lift(std::string_view id);

/// Whether it is no more than what every ship has. @param parameters  of the effect on the ship
bool is_ordinary(const Effect& effect, std::span<const Parameter> parameters);

/// Why no turn is ever steady with it, in words: "in wind"; empty where turns are.
std::string_view never_steady(const Effect& effect);

}  // namespace swayaw::nonlinear
