#pragma once

#include "swayaw/nonlinear/effects/search_form.hpp"
#include "swayaw/nonlinear/surroundings/surroundings.hpp"

namespace swayaw::inline nonlinear {

/// A uniform stream: it carries the ship along.
template <class S = double>
struct SteadyCurrent {
  S speed{};  ///< [m/s]
  S to{};     ///< clockwise from north [rad]

  static constexpr std::string_view id = "steady_current";
  static constexpr EffectPlace place = EffectPlace::water;
  static constexpr Scope scope = Scope::group;  ///< one stream a day
  static constexpr EffectText text{.phrase = "a current",
                                   .label = "steady current",
                                   .law = "carries the ship along",
                                   .confused_with = "heading bias → the opposite heading; a log"};

  /// The floor of 0.02 U is that of practice; kinematics are exact.
  static constexpr auto parameters() {
    using P = ParameterOf<SteadyCurrent, S>;
    return std::array{P{.key = "current_speed_m_s",
                        .member = &SteadyCurrent::speed,
                        .unit = "m/s",
                        .range = non_negative,
                        .prior = 0.1,
                        .floor = 0.02,
                        .law = 0.0,
                        .scale = ShipUnit::speed},
                      P{.key = "current_to_rad",
                        .member = &SteadyCurrent::to,
                        .unit = "rad",
                        .range = direction_range,
                        .prior = pi,
                        .law = 0.0,
                        .decides = false,
                        .direction = true}};
  }
};

template <class S>
Current<S> current(const SteadyCurrent<S>& e) {
  return {e.speed, e.to};
}

/// Kinematics are linear in the parts: one start, at rest.
inline SearchForm<SteadyCurrent<>> search_form(const SteadyCurrent<>& null, const SearchContext& context) {
  auto form = usual_form(null, context);
  form.starts = {{0.0, 0.0}};
  return form;
}

}  // namespace swayaw::nonlinear
