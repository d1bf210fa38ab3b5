#include "swayaw/nonlinear/effects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

namespace swayaw::inline nonlinear {
namespace {

/// One of each kind, where it does nothing.
template <std::size_t... I>
std::array<Effect, sizeof...(I)> all_kinds(std::index_sequence<I...>) {
  return {Effect(std::in_place_index<I>)...};
}

template <std::size_t... I>
constexpr std::array<std::string_view, sizeof...(I)> all_ids(std::index_sequence<I...>) {
  static_assert(((ways_to_act<std::variant_alternative_t<I, Effect>> == 1) && ...),
                "every effect acts in exactly one way");
  return {std::variant_alternative_t<I, Effect>::id...};
}

constexpr auto ids = all_ids(std::make_index_sequence<effect_count>());

/// "late channel (rudder)"
std::string with_channel(std::string_view words, const Effect& effect) {
  const auto* channel = channel_of(effect);
  return channel ? fmt::format("{} ({})", words, plain_name(*channel)) : std::string(words);
}

}  // namespace

std::string_view name_of(EffectPlace place) {
  constexpr std::array<std::string_view, 5> names{"air", "water", "force", "actuator", "sensor"};
  return names[static_cast<std::size_t>(place)];
}

std::span<const std::string_view> effect_ids() { return ids; }

std::optional<Effect> effect_named(std::string_view id) {
  static const auto kinds = all_kinds(std::make_index_sequence<effect_count>());
  const auto found = std::ranges::find(ids, id);
  if (found == ids.end()) return std::nullopt;
  return kinds[static_cast<std::size_t>(found - ids.begin())];
}

Effect make_effect(std::string_view id) {
  if (const auto effect = effect_named(id)) return *effect;
  throw std::domain_error(fmt::format("{} is no effect (known: {})", id, fmt::join(ids, ", ")));
}

// ---------------------------------------------------------------- one effect

std::string_view id_of(const Effect& effect) {
  return std::visit([](const auto& e) { return e.id; }, effect);
}

EffectPlace place_of(const Effect& effect) {
  return std::visit([](const auto& e) { return e.place; }, effect);
}

Scope scope_of(const Effect& effect) {
  return std::visit([](const auto& e) { return e.scope; }, effect);
}

const EffectText& text_of(const Effect& effect) {
  return std::visit([](const auto& e) -> const EffectText& { return e.text; }, effect);
}

std::string phrase_of(const Effect& effect) { return with_channel(text_of(effect).phrase, effect); }
std::string label_of(const Effect& effect) { return with_channel(text_of(effect).label, effect); }

std::size_t parameter_count(const Effect& effect) {
  return std::visit([](const auto& e) { return e.parameters().size(); }, effect);
}

double& parameter_value(Effect& effect, std::size_t index) {
  return std::visit(
      [&](auto& e) -> double& { return e.*parameter_list<std::remove_cvref_t<decltype(e)>>[index].member; }, effect);
}

const double& parameter_value(const Effect& effect, std::size_t index) {
  return parameter_value(const_cast<Effect&>(effect), index);
}

bool is_null(const Effect& effect) {
  bool null = true;
  for_each_parameter(effect, [&](const auto& p, double value) {
    const bool same = value == p.null || (std::isnan(p.null) && std::isnan(value));
    null = null && (same || !p.decides);
  });
  return null;
}

// ---------------------------------------------------------------- what some have

std::optional<ActingTime> acting_time(const Effect& effect) {
  return std::visit(
      []<class Kind>(const Kind& e) -> std::optional<ActingTime> {
        if constexpr (BeginsAndEnds<Kind>)
          if (std::isfinite(e.onset)) return ActingTime{e.onset, e.end};
        return std::nullopt;
      },
      effect);
}

bool begins_and_ends(const Effect& effect) {
  return std::visit([]<class Kind>(const Kind&) { return BeginsAndEnds<Kind>; }, effect);
}

bool acts_at(const Effect& effect, double time) {
  return std::visit([time](const auto& e) { return acts_at(e, time); }, effect);
}

Channel* channel_of(Effect& effect) {
  return std::visit(
      [](auto& e) -> Channel* {
        if constexpr (requires { e.channel; }) return &e.channel;
        else return nullptr;
      },
      effect);
}

const Channel* channel_of(const Effect& effect) { return channel_of(const_cast<Effect&>(effect)); }

std::string_view lacks(const Effect& effect) {
  return std::visit(
      [](const auto& e) -> std::string_view {
        if constexpr (requires { needed_besides(e); }) return needed_besides(e);
        else return {};
      },
      effect);
}

bool exclude_each_other(const Effect& a, const Effect& b) {
  const auto *of_a = channel_of(a), *of_b = channel_of(b);
  if (a.index() != b.index() || (of_a && *of_a != *of_b)) return false;
  return std::visit(
      [&b]<class Kind>(const Kind& e) {
        if constexpr (requires { stand_beside(e, e); }) return !stand_beside(e, std::get<Kind>(b));
        else return true;
      },
      a);
}

std::string_view shown_wrong(const Effect& effect) {
  return std::visit(
      [](const auto& e) -> std::string_view {
        if constexpr (requires { e.shows_wrong(); }) return e.shows_wrong();
        else return {};
      },
      effect);
}

bool takes_rudder_lift(std::string_view id) {
  bool takes = false;
  for_each_kind([&]<class Kind>() {
    if constexpr (requires { Kind::takes_rudder_lift; }) takes = takes || Kind::id == id;
  });
  return takes;
}

bool is_ordinary(const Effect& effect, std::span<const Parameter> parameters) {
  return std::visit(
      [parameters](const auto& e) {
        if constexpr (requires { is_of_every_ship(e, parameters); }) return is_of_every_ship(e, parameters);
        else return false;
      },
      effect);
}

std::string_view never_steady(const Effect& effect) {
  return std::visit(
      []<class Kind>(const Kind& e) -> std::string_view {
        if constexpr (requires { e.lets_turns_be_steady(); })
          if (e.lets_turns_be_steady()) return {};
        if constexpr (requires { Kind::never_steady; }) return Kind::never_steady;
        else return GivesWind<Kind> ? "in wind" : "";
      },
      effect);
}

}  // namespace swayaw::nonlinear
