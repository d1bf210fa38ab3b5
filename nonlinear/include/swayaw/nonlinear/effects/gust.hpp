#pragma once

#include <limits>

#include "swayaw/nonlinear/effects/search_form.hpp"
#include "swayaw/nonlinear/surroundings/wind.hpp"

namespace swayaw::inline nonlinear {

/// Wind from onset to end, in the time of the run, on top of a steady one.
template <class S = double>
struct Gust {
  S speed{};                                           ///< [m/s]
  S from{};                                            ///< clockwise from north [rad]
  S onset{};                                           ///< [s]
  S end = S(std::numeric_limits<double>::infinity());  ///< [s]

  static constexpr std::string_view id = "gust";
  static constexpr EffectPlace place = EffectPlace::air;
  static constexpr Scope scope = Scope::run;
  static constexpr EffectText text{.phrase = "a gust",
                                   .label = "gust of wind",
                                   .law = "a wind from onset to end, in the time of the run, on top of a steady one",
                                   .confused_with = "any force with an onset"};

  /// As a steady wind; onset and end anywhere in some five L/U.
  static constexpr auto parameters() {
    using P = ParameterOf<Gust, S>;
    constexpr double never = std::numeric_limits<double>::infinity();
    return std::array{P{.key = "wind_speed_m_s",
                        .member = &Gust::speed,
                        .unit = "m/s",
                        .range = non_negative,
                        .prior = 1.0,
                        .floor = 0.2,
                        .law = 0.1,
                        .scale = ShipUnit::wind},
                      P{.key = "wind_from_rad",
                        .member = &Gust::from,
                        .unit = "rad",
                        .range = direction_range,
                        .prior = pi,
                        .law = 0.05,
                        .decides = false,
                        .direction = true},
                      P{.key = "onset_s",
                        .member = &Gust::onset,
                        .unit = "s",
                        .prior = 5.0,
                        .law = 0.0,
                        .scale = ShipUnit::time,
                        .decides = false},
                      P{.key = "end_s",
                        .member = &Gust::end,
                        .unit = "s",
                        .required = false,
                        .fallback = never,
                        .null = never,
                        .prior = 5.0,
                        .law = 0.0,
                        .scale = ShipUnit::time,
                        .decides = false}};
  }
};

template <class S>
Wind<S> wind(const Gust<S>& e) {
  return {e.speed, e.from};
}

/// North and east part, and a time that is looked for in the whole run.
inline SearchForm<Gust<>> search_form(const Gust<>& null, const SearchContext& context) {
  const auto &speed = context["wind_speed_m_s"], &from = context["wind_from_rad"];
  auto form = by_parts(null, speed, from, {in_run(context["onset_s"], context), in_run(context["end_s"], context)});
  form.starts = starts_in_run(by_parts(null, speed, from).starts, context.duration / context.time_unit);
  form.at = [at = std::move(form.at), unit = context.time_unit](std::span<const double> c) {
    return not_too_short(at(c), unit);
  };
  return form;
}

}  // namespace swayaw::nonlinear
