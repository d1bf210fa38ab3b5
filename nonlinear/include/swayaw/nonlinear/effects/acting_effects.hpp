#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <tuple>

#include "swayaw/core/motion.hpp"
#include "swayaw/nonlinear/effects.hpp"
#include "swayaw/nonlinear/models/models.hpp"
#include "swayaw/nonlinear/surroundings/surroundings.hpp"

/// Effects that act in the equations of motion: forces that a model has no place for, and what the engine does. Written
/// once for double and dual; each in its own file, see effects/effect.hpp.
namespace swayaw::inline nonlinear {

// ---------------------------------------------------------------- which kinds

namespace detail {

template <class Kind>
constexpr bool acts_in_motion = AddsForce<Kind> || DrivesEngine<Kind>;

template <class S, std::size_t... I>
auto acting_kinds(std::index_sequence<I...>) -> decltype(std::tuple_cat(
    std::declval<std::conditional_t<acts_in_motion<std::variant_alternative_t<I, Effect>>,
                                    std::tuple<std::variant_alternative_t<I, EffectIn<S>>>, std::tuple<>>>()...));

template <class Kind>
constexpr std::size_t hidden_size() {
  if constexpr (requires { Kind::hidden; }) return Kind::hidden.size();
  else return 0;
}

}  // namespace detail

/// One of each kind that acts in the equations of motion, in the order of the catalogue.
template <class S>
using ActingKinds = decltype(detail::acting_kinds<S>(std::make_index_sequence<effect_count>()));

inline constexpr std::size_t acting_count = std::tuple_size_v<ActingKinds<double>>;
static_assert(acting_count <= 32);

template <std::size_t I>
using ActingKind = std::tuple_element_t<I, ActingKinds<double>>;

namespace detail {

/// Where the hidden state of the i-th acting kind begins.
template <std::size_t... I>
constexpr auto hidden_places(std::index_sequence<I...>) {
  std::array<std::size_t, sizeof...(I) + 1> places{};
  const std::array<std::size_t, sizeof...(I)> sizes{hidden_size<ActingKind<I>>()...};
  for (std::size_t i = 0; i < sizes.size(); ++i) places[i + 1] = places[i] + sizes[i];
  return places;
}

/// Bit i is set where that holds for the i-th acting kind.
template <std::size_t... I>
constexpr std::uint32_t with_hidden(std::index_sequence<I...>) {
  return ((hidden_size<ActingKind<I>>() > 0 ? std::uint32_t{1} << I : 0) | ...);
}

template <std::size_t... I>
constexpr std::uint32_t engines(std::index_sequence<I...>) {
  return ((DrivesEngine<ActingKind<I>> ? std::uint32_t{1} << I : 0) | ...);
}

}  // namespace detail

inline constexpr auto hidden_place = detail::hidden_places(std::make_index_sequence<acting_count>());
inline constexpr std::size_t hidden_count = hidden_place.back();

/// All hidden states, kind after kind: heel and its rate, the motion that the damping remembers. See hidden_quantities.
template <class S = double>
using Hidden = std::array<S, hidden_count>;

inline constexpr std::array<HiddenQuantity, hidden_count> hidden_quantities = [] {
  std::array<HiddenQuantity, hidden_count> all{};
  std::size_t next = 0;
  for_each_kind([&]<class Kind>() {
    if constexpr (detail::hidden_size<Kind>() > 0)
      for (const auto& quantity : Kind::hidden) all[next++] = quantity;
  });
  return all;
}();

/// The hidden state that a channel shows; 0 where none is.
template <class S>
S shown_by(const Hidden<S>& hidden, Channel channel) {
  for (std::size_t i = 0; i < hidden_count; ++i)
    if (hidden_quantities[i].channel == channel) return hidden[i];
  return S(0.0);
}

// ---------------------------------------------------------------- the effects of a ship

/// Effects of a ship that act in her equations of motion, with what they need to know of her. One that is not there is
/// not computed.
template <class S = double>
struct ActingEffects {
  ShipFacts<S> ship{};
  ActingKinds<S> kinds{};    ///< all parameters known
  std::uint32_t acting = 0;  ///< bit i: whether the i-th kind acts now

  bool any() const { return acting != 0; }

  /// Whether one of them has a hidden state.
  bool hidden() const { return (acting & detail::with_hidden(std::make_index_sequence<acting_count>())) != 0; }

  /// Whether one of them changes the shaft speed.
  bool engine() const { return (acting & detail::engines(std::make_index_sequence<acting_count>())) != 0; }
};

/// Calls visit(index, effect) for every kind that acts.
template <class Acting, class Visit>
void for_each_acting(Acting& a, Visit&& visit) {
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    const auto visit_one = [&](auto index) {
      if (a.acting >> index.value & 1u) visit(index, std::get<index.value>(a.kinds));
    };
    (visit_one(std::integral_constant<std::size_t, I>{}), ...);
  }
  (std::make_index_sequence<acting_count>());
}

/// The same with another scalar.
template <class To, class From>
ActingEffects<To> cast(const ActingEffects<From>& a) {
  const auto cast_all = [](const auto&... kind) { return ActingKinds<To>{cast_effect<To>(kind)...}; };
  return {.ship = cast<To>(a.ship), .kinds = std::apply(cast_all, a.kinds), .acting = a.acting};
}

/// Which of the effects act at a time, bit by bit as in ActingEffects.
std::uint32_t acting_at(std::span<const Effect> effects, double time);

/// The effects that act in the motion of a ship with these dimensions, all of them at once, in any scalar. Effects of
/// other kinds are passed over.
template <class Model, class S = typename Model::Scalar>
ActingEffects<S> acting_effects(const Model& model, std::span<const EffectIn<S>> effects);

/// Without what goes with the heading: waves, those terms of an unknown force.
template <class S>
ActingEffects<S> without_heading(const ActingEffects<S>& a) {
  auto result = a;
  for_each_acting(a, [&](auto i, const auto& e) {
    if constexpr (requires { e.without_heading(); }) {
      if (const auto rest = e.without_heading()) std::get<i.value>(result.kinds) = *rest;
      else result.acting &= ~(std::uint32_t{1} << i.value);
    }
  });
  return result;
}

// ---------------------------------------------------------------- what they do

/// The controls with the shaft speed that the engine keeps.
template <class S>
Controls<S> driven(const ActingEffects<S>& a, const PlanarMotion<S>& m, Controls<S> controls) {
  if (!a.engine()) return controls;
  for_each_acting(a, [&](auto i, const auto& e) {
    if constexpr (DrivesEngine<ActingKind<i.value>>) drive(e, a.ship, m, controls);
  });
  return controls;
}

/// The part of a hidden state that is of the i-th acting kind.
template <std::size_t I, class S>
std::span<const S> hidden_of(const Hidden<S>& hidden) {
  return std::span<const S>(hidden).subspan(hidden_place[I], hidden_place[I + 1] - hidden_place[I]);
}

/// Calls add(name, force) for every force that is there. `controls` as recorded.
template <class Model, class S, class Add>
void for_each_added(const Model& model, const ActingEffects<S>& a, const ShipState<S>& state, const Hidden<S>& hidden,
                    const Controls<S>& controls, Add&& add) {
  const auto actual = driven(a, state.motion, controls);
  for_each_acting(a, [&](auto i, const auto& e) {
    if constexpr (AddsForce<ActingKind<i.value>>)
      add(e.id, force(e, model, Circumstances<S>{a.ship, state, controls, actual, hidden_of<i.value, S>(hidden)}));
  });
}

/// Sum of the added forces.
template <class Model, class S>
PlanarForce<S> added_force(const Model& model, const ActingEffects<S>& a, const ShipState<S>& state,
                           const Hidden<S>& hidden, const Controls<S>& controls) {
  PlanarForce<S> sum{S(0.0), S(0.0), S(0.0)};
  for_each_added(model, a, state, hidden, controls, [&](std::string_view, const PlanarForce<S>& f) { sum = sum + f; });
  return sum;
}

/// Whether one of the effects has hidden states that may follow the force of the rudder.
template <class S>
bool may_follow_rudder(const ActingEffects<S>& a) {
  bool may = false;
  for_each_acting(a, [&](auto, const auto& e) {
    may = may || requires { follows_rudder(e); };
  });
  return may;
}

/// Sway force of the rudder over the mass of the ship, Y_R/(ρ∇) [m/s²].
/// @param controls  as recorded
template <class Model, class S>
S sway_by_rudder(const Model& model, const ActingEffects<S>& a, const PlanarMotion<S>& m, const Controls<S>& controls) {
  return forces(model, m, driven(a, m, controls)).rudder.Y / (a.ship.rho * a.ship.nabla);
}

/// The same where a hidden state follows it; else 0, and it is not worked out.
template <class Model, class S>
S followed_sway_by_rudder(const Model& model, const ActingEffects<S>& a, const PlanarMotion<S>& m,
                          const Controls<S>& controls) {
  bool follows = false;
  for_each_acting(a, [&](auto, const auto& e) {
    if constexpr (requires { follows_rudder(e); }) follows = follows || follows_rudder(e);
  });
  return follows ? sway_by_rudder(model, a, m, controls) : S(0.0);
}

/// Rates of the hidden states.
/// @param by_rudder  sway_by_rudder
template <class S>
Hidden<S> hidden_rates(const ActingEffects<S>& a, const PlanarMotion<S>& m, const Hidden<S>& hidden,
                       const S& by_rudder) {
  Hidden<S> rates{};
  for_each_acting(a, [&](auto i, const auto& e) {
    constexpr auto place = hidden_place[i.value];
    if constexpr (requires { follows_rudder(e); })
      std::ranges::copy(hidden_rates(e, a.ship, m, hidden_of<i.value, S>(hidden), by_rudder), rates.begin() + place);
    else if constexpr (detail::hidden_size<ActingKind<i.value>>() > 0)
      std::ranges::copy(hidden_rates(e, a.ship, m, hidden_of<i.value, S>(hidden)), rates.begin() + place);
  });
  return rates;
}

template <class Model, class S>
Hidden<S> hidden_rates(const Model& model, const ActingEffects<S>& a, const PlanarMotion<S>& m, const Hidden<S>& hidden,
                       const Controls<S>& controls) {
  return hidden_rates(a, m, hidden, followed_sway_by_rudder(model, a, m, controls));
}

/// Hidden states of a motion that has lasted long.
template <class S>
Hidden<S> steady_hidden(const ActingEffects<S>& a, const PlanarMotion<S>& m, const S& by_rudder) {
  Hidden<S> steady{};
  for_each_acting(a, [&](auto i, const auto& e) {
    constexpr auto place = hidden_place[i.value];
    if constexpr (requires { follows_rudder(e); })
      std::ranges::copy(steady_hidden(e, a.ship, m, by_rudder), steady.begin() + place);
    else if constexpr (detail::hidden_size<ActingKind<i.value>>() > 0)
      std::ranges::copy(steady_hidden(e, a.ship, m), steady.begin() + place);
  });
  return steady;
}

template <class Model, class S>
Hidden<S> steady_hidden(const Model& model, const ActingEffects<S>& a, const PlanarMotion<S>& m,
                        const Controls<S>& controls) {
  return steady_hidden(a, m, followed_sway_by_rudder(model, a, m, controls));
}

/// Force of model and effects in a motion that lasts, without what depends on the heading: wind, waves, an unknown
/// force that does.
template <template <class> class Model, class S, std::size_t N>
PlanarForce<S> steady_force(const Model<S>& ship, const ActingEffects<S>& added, const PlanarMotion<S>& m,
                            const Controls<S>& controls, const Branch<S, N>& branch) {
  const auto own = forces(ship, m, driven(added, m, controls), branch).total();
  if (!added.any()) return own;
  return own + added_force(ship, without_heading(added), ShipState<S>{S(0.0), S(0.0), S(0.0), m},
                           steady_hidden(ship, added, m, controls), controls);
}

template <template <class> class Model, class S>
PlanarForce<S> steady_force(const Model<S>& ship, const ActingEffects<S>& added, const PlanarMotion<S>& m,
                            const Controls<S>& controls) {
  if (!added.any()) return forces(ship, m, controls).total();
  return steady_force(ship, added, m, controls, branch_at(ship, m, driven(added, m, controls)));
}

// ---------------------------------------------------------------- implementation

/// What effects need to know of a ship. Without a propeller of known place it is at the stern.
template <class Model, class S = typename Model::Scalar>
ShipFacts<S> ship_facts(const Model& model) {
  ShipFacts<S> f;
  f.rho = model.water.rho;
  f.L = model.particulars.L;
  f.U_0 = model.particulars.U_0;
  if constexpr (requires { model.particulars.d; }) {
    f.B = model.particulars.B;
    f.d = model.particulars.d;
    f.nabla = model.particulars.nabla;
    f.k_xx = 0.4 * f.B;
  }
  if constexpr (requires { model.propeller.x_P; }) f.x_P = model.propeller.x_P;
  if constexpr (std::is_same_v<Model, MmgShip<S>>) f.x_P = f.x_P * f.L;
  if (value_of(f.x_P) == 0.0) f.x_P = -0.5 * f.L;
  return f;
}

/// The effect with all its parameters known.
template <class Kind, class S>
Kind completed(const Kind& effect, const ShipFacts<S>& ship) {
  if constexpr (requires { effect.completed(ship); }) return effect.completed(ship);
  else return effect;
}

template <class Model, class S>
ActingEffects<S> acting_effects(const Model& model, std::span<const EffectIn<S>> effects) {
  ActingEffects<S> a{.ship = ship_facts(model), .kinds = {}, .acting = 0};
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    const auto take = [&]<class Kind>(std::size_t i, Kind& place) {
      const auto* found = find<Kind>(effects);
      if (!found) return;
      place = completed(*found, a.ship);
      a.acting |= std::uint32_t{1} << i;
    };
    (take(I, std::get<I>(a.kinds)), ...);
  }
  (std::make_index_sequence<acting_count>());
  return a;
}

}  // namespace swayaw::nonlinear
