#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <string_view>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/channel.hpp"
#include "swayaw/core/motion.hpp"
#include "swayaw/core/parameter.hpp"
#include "swayaw/nonlinear/models/controls.hpp"

/// What the file of an effect may hold. docs/decisions/005_one_file_per_effect.md shows how one is added.
///
/// Every effect is a struct over its scalar with `id`, `place`, `scope`, `text` and `parameters()`, and acts in exactly
/// one of these ways, by a free function beside the struct:
///
///     force(effect, model, now)               a force on the ship, with hidden_rates and steady_hidden where a motion
///                                             of its own stands behind it
///     drive(effect, facts, motion, controls)  another shaft speed than recorded
///     wind(effect), current(effect)           the air and the water around her
///     change(model, effect)                   other parameters of the model; what replaces them one by one says so in
///                                             its list of parameters and needs no function
///     actuate(effect, actuator)               between the recorded rudder angle and the rudder
///     put_on(instruments, effect)             what an instrument shows
///
/// What it does not say has a default. It may say besides: `acts_on(model)`, whether a model has what it needs;
/// `search_form(null, context)`, the coordinates of a search; `onset` and `end`; `channel`, that it is of;
/// `completed(facts)`, where the ship gives parameters; `without_heading()` and `never_steady`; `takes_rudder_lift`;
/// `is_of_every_ship(effect, parameters)`; `needed_besides(effect)` by a file; `stand_beside(a, b)`, where
/// a ship may have several; of an instrument `shows_wrong()`.
namespace swayaw::inline nonlinear {

/// Where an effect acts.
enum class EffectPlace { air, water, force, actuator, sensor };

/// "force" for EffectPlace::force, alike.
std::string_view name_of(EffectPlace place);

/// An effect in words.
struct EffectText {
  std::string_view phrase;         ///< in a sentence: "a steady wind"
  std::string_view label;          ///< in a list: "steady wind"
  std::string_view law;            ///< what it does, as Markdown, in the symbols of docs/notation.md
  std::string_view confused_with;  ///< what recordings often cannot tell it from → what separates them
};

inline constexpr double effect_gravity = 9.81;  ///< [m/s²]

/// Angles on the earth, clockwise from north [rad].
inline constexpr Range direction_range{.low = -2.0 * pi, .high = 2.0 * pi};

// ---------------------------------------------------------------- parameters

/// A parameter of the model that gets another value; where none is given it stays as it is. Its prior is a quarter of
/// the ship's own value, its floor 5 %.
/// @param law  what the law is worth: 3 %, of cubic terms 20 %, the spread between ways of writing them
/// (docs/diagnose.md)
template <class Part, class S>
constexpr ParameterOf<Part, S> other_value(std::string_view key, S Part::*member, std::string_view table,
                                           std::string_view replaced, std::string_view other_name = {},
                                           Range range = any_number, double law = 0.03) {
  return {.key = key,
          .member = member,
          .range = range,
          .required = false,
          .fallback = unchanged,
          .null = unchanged,
          .prior = 0.25,
          .floor = 0.05,
          .law = law,
          .scale = ShipUnit::own,
          .table = table,
          .replaces = {replaced, other_name}};
}

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

// ---------------------------------------------------------------- time

/// Whether an effect of that kind begins and ends.
template <class Kind>
concept BeginsAndEnds = requires(Kind e) {
  e.onset;
  e.end;
};

/// Whether an effect acts at a time: from its onset on, until its end.
template <class Kind>
bool acts_at(const Kind& effect, double time) {
  if constexpr (BeginsAndEnds<Kind>) return effect.onset <= time && time < effect.end;
  else return true;
}

// ---------------------------------------------------------------- forces

/// What the forces of effects need to know of the ship.
template <class S = double>
struct ShipFacts {
  S rho{}, L{}, B{}, d{};
  S nabla{};   ///< displaced volume [m³]
  S U_0{1.0};  ///< service speed [m/s]
  S x_P{};     ///< propeller forward of midship [m]
  S k_xx{};    ///< radius of gyration in roll, 0.4 B [m]
};

/// The same with another scalar.
template <class To, class From>
ShipFacts<To> cast(const ShipFacts<From>& f) {
  return {To(f.rho), To(f.L), To(f.B), To(f.d), To(f.nabla), To(f.U_0), To(f.x_P), To(f.k_xx)};
}

/// What a force of an effect acts in.
template <class S = double>
struct Circumstances {
  const ShipFacts<S>& ship;
  const ShipState<S>& state;
  const Controls<S>& recorded;  ///< controls as recorded
  const Controls<S>& actual;    ///< with the shaft speed that the engine keeps
  std::span<const S> hidden;    ///< the hidden state of the effect itself
};

/// A state of an effect that is not of the ship's motion: heel, or what her damping remembers.
struct HiddenQuantity {
  std::string_view symbol;
  ShipUnit scale;                    ///< one, speed or yaw_rate: in what the error of a step is counted
  std::optional<Channel> channel{};  ///< that shows it

  /// One of its scale, on a ship of that length and speed.
  constexpr double one(double L, double U) const {
    return scale == ShipUnit::speed ? U : scale == ShipUnit::yaw_rate ? U / L : 1.0;
  }
};

// ---------------------------------------------------------------- actuators

/// What lies between a recorded rudder angle and the rudder, in this order: play, lag with its largest rate, offset.
struct RudderActuator {
  double width = 0.0;                                     ///< of the play [rad]
  double lag = 0.0;                                       ///< T [s]
  double rate = std::numeric_limits<double>::infinity();  ///< [rad/s]
  double offset = 0.0;                                    ///< [rad]
  bool record_late = false;                               ///< the angle is recorded late, or smoothed

  bool any() const { return moves() || offset != 0.0 || record_late; }

  /// Whether the rudder has a motion of its own.
  bool moves() const { return width > 0.0 || lag > 0.0 || rate < std::numeric_limits<double>::infinity(); }
};

}  // namespace swayaw::nonlinear
