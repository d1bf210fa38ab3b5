#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

/// A part is a small struct of parameters. Its list of parameters is written once, beside the struct;
/// ship files, confidence, fits and reports read that list.
namespace swayaw::inline core {

/// Values that make sense, in the unit of the ship file. `low` itself is refused when `above_low`, 0 when `not_zero`.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool above_low = false;
  bool not_zero = false;

  constexpr bool contains(double value) const {
    return (above_low ? value > low : value >= low) && value <= high && !(not_zero && value == 0.0);
  }
};

inline constexpr Range any_number{};
inline constexpr Range positive{.low = 0.0, .above_low = true};
inline constexpr Range non_negative{.low = 0.0};
inline constexpr Range not_zero{.not_zero = true};
inline constexpr Range fraction{.low = 0.0, .high = 1.0};

/// What a parameter is: a coefficient can be uncertain and be fitted, a fact cannot.
enum class Role { fact, coefficient };

/// How far one value of a parameter reaches: all runs of the ship, runs of the same day and loading, one run.
enum class Scope { ship, group, run };

/// "ship" for Scope::ship, alike.
constexpr std::string_view name_of(Scope scope) {
  return scope == Scope::ship ? "ship" : scope == Scope::group ? "group" : "run";
}

/// What a prior or a floor is counted in: sizes that grow with the ship.
enum class ShipUnit {
  one,       ///< the unit of the parameter itself
  speed,     ///< service speed U
  wind,      ///< sqrt(U² + 0.1 gL): what blows where ships of that size sail; a floor counts U alone
  time,      ///< L/U
  length,    ///< L
  yaw_rate,  ///< U/L
  force,     ///< resistance-like force, 1e-3 ½ρL²U²
  own,       ///< size of the parameter of the ship that the effect replaces
};

/// Stands for a parameter that an effect leaves as the ship has it.
inline constexpr double unchanged = std::numeric_limits<double>::quiet_NaN();

/// A parameter of a part, of a ship or of an effect, as the part declares it.
template <class Part, class Scalar>
struct ParameterOf {
  std::string_view key;         ///< name in ship files; "kt[0]" is the first of a list
  Scalar Part::*member;         ///< where it is kept, in SI
  std::string_view unit = "-";  ///< unit in ship files, "-" for none
  Range range = any_number;     ///< accepted values, in that unit
  Role role = Role::fact;
  double si = 1.0;        ///< SI value of one unit
  bool required = true;   ///< whether a ship file must give it
  double fallback = 0.0;  ///< value of an optional parameter that is not given, in SI

  // of an effect, what is known before any recording is looked at
  double null = 0.0;   ///< where the effect does nothing; `unchanged`: at the ship's own value
  double prior = 0.0;  ///< standard deviation before any data, in `scale`
  double floor = 0.0;  ///< a smaller departure from null is a trace, in `scale`
  double law = 0.03;   ///< what its law is worth: standard deviation over departure from null, of what does not decide
                       ///< over its value, of directions in radians
  ShipUnit scale = ShipUnit::one;
  bool decides = true;     ///< the effect is off while every parameter that decides has its null value
  bool direction = false;  ///< on the earth, clockwise from north
  std::string_view
      table{};  ///< where the model keeps the parameter that this one replaces; empty where it replaces none
  std::array<std::string_view, 2> replaces{};  ///< its key there; models may name it differently
};

/// A parameter with its value, of a ship or of an effect on her: what a fit moves, a prior knows and a report names.
struct Parameter {
  std::string name;        ///< key of the ship file, "N_v", or "rudder.x_prime" where two tables have that key
  std::string_view table;  ///< of the ship file; of an effect its id
  std::string_view key;
  std::string_view unit;  ///< in ship files, "-" for none
  std::size_t index;      ///< place among the parameters of the model or the effect
  double value;           ///< SI
  Range range;            ///< accepted values, SI
  double si = 1.0;        ///< SI value of one unit
  Role role = Role::coefficient;
  Scope scope = Scope::ship;
  double null = 0.0;       ///< mean before any data: the value of the ship file, or where the effect does nothing
  double deviation = 0.0;  ///< standard deviation about null before any data, SI; 0 for a fact
  double floor = 0.0;      ///< a smaller departure from null is a trace, SI
  double law = 0.0;        ///< what the law of an effect is worth: standard deviation over departure from null
  bool decides = true;     ///< its departure from null is the effect
  bool direction = false;  ///< on the earth, clockwise from north
};

/// The range in another unit: an SI range from one in units of `si`.
constexpr Range scaled(Range range, double si) {
  range.low *= si, range.high *= si;
  return range;
}

/// Which of several forms of the physics a part takes. It is the same for all lanes of a pack.
struct Selection {
  int index = 0;
};

/// A selection of a part and the words for it in ship files; the first is taken unless the file says otherwise.
template <class Part>
struct Choice {
  std::string_view key;
  Selection Part::*member;
  std::array<std::string_view, 3> names;  ///< unused ones are empty
};

/// The choices of a part; none unless it lists them.
template <class Part>
constexpr auto choices_of() {
  if constexpr (requires { Part::choices(); }) return Part::choices();
  else return std::array<Choice<Part>, 0>{};
}

/// A part of a ship and the table of the ship file that holds its numbers.
template <class Ship, class Part>
struct Section {
  std::string_view table;
  Part Ship::*part;
};

/// The list of a part, made once.
template <class Part>
inline constexpr auto parameter_list = Part::parameters();

/// How many parameters the sections of a ship list.
template <class Ship>
constexpr std::size_t parameter_count() {
  const auto count = []<class Part>(const Section<Ship, Part>&) { return Part::parameters().size(); };
  return std::apply([&](const auto&... section) { return (count(section) + ...); }, Ship::sections());
}

/// Calls visit(value) for the value of every parameter of a ship, in the order of her sections.
template <class Ship, class Visit>
void for_each_value(Ship& ship, Visit&& visit) {
  const auto visit_part = [&](auto& part) {
    for (const auto& parameter : parameter_list<std::remove_cvref_t<decltype(part)>>) visit(part.*parameter.member);
  };
  std::apply([&](const auto&... section) { (visit_part(ship.*section.part), ...); }, Ship::sections());
}

/// The same part with another scalar.
template <class To, template <class> class Part, class From>
Part<To> cast_part(const Part<From>& part) {
  Part<To> result{};
  constexpr auto source = Part<From>::parameters();
  constexpr auto target = Part<To>::parameters();
  for (std::size_t i = 0; i < source.size(); ++i) result.*target[i].member = To(part.*source[i].member);
  constexpr auto chosen = choices_of<Part<From>>();
  constexpr auto choice = choices_of<Part<To>>();
  for (std::size_t i = 0; i < chosen.size(); ++i) result.*choice[i].member = part.*chosen[i].member;
  return result;
}

/// The same ship with another scalar, number by number.
template <class To, template <class> class Ship, class From>
Ship<To> cast(const Ship<From>& ship) {
  Ship<To> result{};
  const auto copy_all = [&]<std::size_t... I>(std::index_sequence<I...>) {
    constexpr auto source = Ship<From>::sections();
    constexpr auto target = Ship<To>::sections();
    ((result.*std::get<I>(target).part = cast_part<To>(ship.*std::get<I>(source).part)), ...);
  };
  copy_all(std::make_index_sequence<std::tuple_size_v<decltype(Ship<From>::sections())>>{});
  return result;
}

}  // namespace swayaw::core
