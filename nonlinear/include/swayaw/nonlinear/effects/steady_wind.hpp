#pragma once

#include "swayaw/nonlinear/effects/effect.hpp"
#include "swayaw/nonlinear/surroundings/wind.hpp"

namespace swayaw::inline nonlinear {

/// Wind that blows all the time; its load is that of wind.hpp.
template <class S = double>
struct SteadyWind {
  S speed{};  ///< [m/s]
  S from{};   ///< clockwise from north [rad]

  static constexpr std::string_view id = "steady_wind";
  static constexpr EffectPlace place = EffectPlace::air;
  static constexpr Scope scope = Scope::group;  ///< one wind a day
  static constexpr EffectText text{.phrase = "a steady wind",
                                   .label = "steady wind",
                                   .law = "load of [wind.md](wind.md)",
                                   .confused_with = "waves, current → headings all round"};

  /// The floor of 0.2 U is that of practice; the law, 10 % of the speed, is the spread of wind coefficients.
  static constexpr auto parameters() {
    using P = ParameterOf<SteadyWind, S>;
    return std::array{P{.key = "wind_speed_m_s",
                        .member = &SteadyWind::speed,
                        .unit = "m/s",
                        .range = non_negative,
                        .prior = 1.0,
                        .floor = 0.2,
                        .law = 0.1,
                        .scale = ShipUnit::wind},
                      P{.key = "wind_from_rad",
                        .member = &SteadyWind::from,
                        .unit = "rad",
                        .range = direction_range,
                        .prior = pi,
                        .law = 0.05,
                        .decides = false,
                        .direction = true}};
  }
};

template <class S>
Wind<S> wind(const SteadyWind<S>& e) {
  return {e.speed, e.from};
}

}  // namespace swayaw::nonlinear
