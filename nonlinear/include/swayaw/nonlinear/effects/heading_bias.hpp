#pragma once

#include "swayaw/nonlinear/effects/instrument.hpp"

namespace swayaw::inline nonlinear {

/// Recorded minus true heading.
template <class S = double>
struct HeadingBias {
  S bias{};  ///< [rad]

  static constexpr std::string_view id = "heading_bias";
  static constexpr EffectPlace place = EffectPlace::sensor;
  static constexpr Scope scope = Scope::group;  ///< a compass is set once a day
  static constexpr EffectText text{.phrase = "an error of the compass",
                                   .label = "compass error",
                                   .law = "recorded minus true ψ",
                                   .confused_with = "current"};

  /// The floor of 0.3 deg is that of practice.
  static constexpr auto parameters() {
    return std::array{ParameterOf<HeadingBias, S>{.key = "bias_rad",
                                                  .member = &HeadingBias::bias,
                                                  .unit = "rad",
                                                  .range = {-pi, pi},
                                                  .prior = radians(2.0),
                                                  .floor = radians(0.3),
                                                  .law = 0.0}};
  }

  /// The quantity that it shows wrong.
  std::string_view shows_wrong() const { return "heading"; }
};

template <class S>
void put_on(Instruments<S>& instruments, const HeadingBias<S>& e) {
  instruments[Channel::psi].bias = e.bias;
}

}  // namespace swayaw::nonlinear
