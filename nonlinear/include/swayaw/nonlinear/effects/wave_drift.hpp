#pragma once

#include "swayaw/core/scalar.hpp"
#include "swayaw/nonlinear/effects/search_form.hpp"

namespace swayaw::inline nonlinear {

/// Mean second-order force of waves that come in at alpha = from − psi, 0 from ahead.
///
///     X = −ahead F cos(alpha),   Y = −F sin(alpha) |sin(alpha)|,   N = moment F L sin(2 alpha)
///
/// Seakeeping tests show both signs of the moment, by ship and wave length: 0 unless it is given.
template <class S = double>
struct WaveDrift {
  S from{};      ///< where the waves come from, clockwise from north [rad]
  S force{};     ///< F, sway force in beam waves [N]
  S ahead{0.4};  ///< surge force in head waves over F
  S moment{};    ///< yaw moment in waves on the bow, 45 deg, over F L

  static constexpr std::string_view id = "wave_drift";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr Scope scope = Scope::group;  ///< one sea a day
  static constexpr EffectText text{
      .phrase = "the drift force of waves",
      .label = "wave drift force",
      .law =
          "α = from − ψ: X = −a F cos α, Y = −F sin α \\|sin α\\|, N = m F L sin 2α; F = `force_N`, a = `ahead`, m "
          "= `moment`",
      .confused_with = "wind → it grows with the speed of the air, waves do not"};
  static constexpr std::string_view never_steady = "in waves";

  /// The law of the force is that of short waves on a wall: on simulated ships whose waves follow another it was found
  /// 14 % off (rms of 42, `swayaw_concealed` as on board, seeds 44 and 46), where the runs alone tell it to 10 %.
  static constexpr auto parameters() {
    using P = ParameterOf<WaveDrift, S>;
    return std::array{
        P{.key = "wave_from_rad",
          .member = &WaveDrift::from,
          .unit = "rad",
          .range = direction_range,
          .prior = pi,
          .law = 0.05,
          .decides = false,
          .direction = true},
        P{.key = "force_N",
          .member = &WaveDrift::force,
          .unit = "N",
          .range = non_negative,
          .prior = 1.0,
          .floor = 0.05,
          .law = 0.1,
          .scale = ShipUnit::force},
        P{.key = "ahead",
          .member = &WaveDrift::ahead,
          .required = false,
          .fallback = 0.4,
          .null = 0.4,
          .prior = 0.3,
          .decides = false},
        P{.key = "moment", .member = &WaveDrift::moment, .required = false, .prior = 0.1, .decides = false}};
  }

  /// What is left of it where no heading is meant: nothing.
  std::optional<WaveDrift> without_heading() const { return std::nullopt; }
};

template <class Model, class S>
PlanarForce<S> force(const WaveDrift<S>& e, const Model&, const Circumstances<S>& now) {
  const auto [s, c] = sin_cos(S(e.from - now.state.psi));
  const S& F = e.force;
  return {.X = -e.ahead * F * c, .Y = -F * s * size_of(s), .N = 2.0 * e.moment * F * now.ship.L * s * c};
}

inline SearchForm<WaveDrift<>> search_form(const WaveDrift<>& null, const SearchContext& context) {
  return by_parts(null, context["force_N"], context["wave_from_rad"],
                  {from_null(context["ahead"]), from_null(context["moment"])});
}

}  // namespace swayaw::nonlinear
