#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <string_view>
#include <tuple>
#include <utility>

/// A part is a small struct of numbers. Its list of parameters is written once, beside the struct;
/// ship files, confidence, fits and reports read that list.
namespace swayaw {

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

/// What a number is: a coefficient can be uncertain and be fitted, a fact cannot.
enum class Role { fact, coefficient };

/// One number of a part.
template <class Part, class Scalar>
struct Parameter {
  std::string_view key;   ///< name in ship files; "kt[0]" is the first number of a list
  Scalar Part::*member;   ///< where it is kept, in SI
  std::string_view unit;  ///< unit in ship files, "-" for none
  Range range;            ///< accepted values, in that unit
  Role role = Role::fact;
  double si = 1.0;        ///< SI value of one unit
  bool required = true;   ///< whether a ship file must give it
  double fallback = 0.0;  ///< value of an optional number that is not given, in SI
};

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

/// How many numbers the sections of a ship list.
template <class Ship>
constexpr std::size_t number_count() {
  const auto count = []<class Part>(const Section<Ship, Part>&) { return Part::parameters().size(); };
  return std::apply([&](const auto&... section) { return (count(section) + ...); }, Ship::sections());
}

/// Calls visit(number) for every number of a ship, in the order of its sections.
template <class Ship, class Visit>
void for_each_number(Ship& ship, Visit&& visit) {
  const auto visit_part = [&](auto& part) {
    for (const auto& parameter : part.parameters()) visit(part.*parameter.member);
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

}  // namespace swayaw
