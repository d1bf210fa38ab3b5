#include "swayaw/nonlinear/effects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

namespace swayaw {
namespace {

/// One of each kind, where it does nothing.
template <std::size_t... I>
std::array<Effect, sizeof...(I)> all_kinds(std::index_sequence<I...>) {
  return {Effect(std::in_place_index<I>)...};
}

template <std::size_t... I>
constexpr std::array<std::string_view, sizeof...(I)> all_ids(std::index_sequence<I...>) {
  return {std::variant_alternative_t<I, Effect>::id...};
}

constexpr auto ids = all_ids(std::make_index_sequence<effect_count>());

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

}  // namespace swayaw
