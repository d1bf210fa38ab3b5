#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace swayaw::inline core::detail {

/// What the column map says of numbers.
struct NumberRules {
  char decimal = '\0';                          ///< '.' or ','; 0: as each column shows
  char thousands = '\0';                        ///< '.' or ','; 0: none but where unambiguous
  std::vector<std::string> missing_texts = {};  ///< cells that stand for no value, besides the usual ones
  std::vector<double> missing_numbers = {};     ///< -999
};

enum class Separators {
  none,            ///< 12
  point,           ///< 12.5
  comma,           ///< 12,5
  doubtful_point,  ///< 12.500: a thousand or three decimals?
  doubtful_comma,  ///< 12,500
};

/// A number as a cell shows it.
struct NumberCell {
  double value = 0.0;
  Separators separators = Separators::none;
  int decimals = 0;             ///< digits behind the decimal point, power of ten considered
  bool is_plain = false;        ///< the cell can be written as it is
  std::string_view unit = {};   ///< behind the number: "12.5 kn"
  std::array<char, 48> digits;  ///< with a decimal point, no group separators, no unit
  std::size_t length = 0;

  std::string_view text() const { return {digits.data(), length}; }
};

/// The finite number at the front of a cell. A lone separator is that of decimals unless the rules say other.
std::optional<NumberCell> number_cell(std::string_view cell, const NumberRules& rules);

enum class CellKind { missing, number, text };

/// @param number  set where the cell is one
/// @return missing for an empty cell, one of the usual marks (NaN, n/a, #N/A, -, null ...), or one of the rules
CellKind read_cell(std::string_view cell, const NumberRules& rules, NumberCell& number);

}  // namespace swayaw::core::detail
