#pragma once

#include <array>
#include <limits>
#include <string_view>

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
  std::string_view key;     ///< name in ship files; "kt[0]" is the first number of a list
  Scalar Part::*member;     ///< where it is kept, in SI
  std::string_view unit;    ///< unit in ship files, "-" for none
  Range range;              ///< accepted values, in that unit
  Role role = Role::fact;
  double si = 1.0;          ///< SI value of one unit
  bool required = true;     ///< an optional number that is not given stays 0
};

/// A part of a ship and the table of the ship file that holds its numbers.
template <class Ship, class Part>
struct Section {
  std::string_view table;
  Part Ship::*part;
};

}  // namespace swayaw
