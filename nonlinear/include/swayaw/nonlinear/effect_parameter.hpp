#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <string_view>

#include "swayaw/core/parameter.hpp"

/// What is known of a number of an effect before any recording is looked at.
namespace swayaw {

/// Where an effect acts.
enum class EffectPlace { air, water, force, actuator, sensor };

/// "force" for EffectPlace::force, alike.
std::string_view name_of(EffectPlace place);

/// One number of an effect, in SI and radians.
template <class Part, class Scalar>
struct EffectParameter {
  std::string_view key;  ///< name in ship files, with its unit
  Scalar Part::*member;
  Range range = any_number;  ///< accepted values
  double null = 0.0;         ///< where the effect does nothing; `unchanged`: at the ship's own number
  double prior = 0.0;        ///< standard deviation before any data, in `scale`
  double floor = 0.0;        ///< a smaller departure from null is a trace, in `scale`
  double law = 0.03;  ///< what its law is worth: standard deviation over departure from null, of directions in radians
  ShipUnit scale = ShipUnit::one;
  bool decides = true;       ///< the effect is off while every number that decides has its null value
  bool required = true;      ///< whether a ship file must give it
  double fallback = 0.0;     ///< value where a file does not give it
  std::string_view table{};  ///< where the model keeps the number that this one replaces; empty where it replaces none
  std::array<std::string_view, 2> replaces{};  ///< its key there; models may name it differently
};

/// The same effect with another scalar.
template <class To, template <class> class Kind, class From>
Kind<To> cast_effect(const Kind<From>& effect) {
  Kind<To> result{};
  constexpr auto source = Kind<From>::parameters();
  constexpr auto target = Kind<To>::parameters();
  for (std::size_t i = 0; i < source.size(); ++i) result.*target[i].member = To(effect.*source[i].member);
  if constexpr (requires { result.channel; }) result.channel = effect.channel;
  return result;
}

}  // namespace swayaw
