#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace swayaw::inline core {

/// How far the numbers of a ship are trusted: relative standard deviations of its coefficients.
struct Confidence {
  double coefficients = 0.1;                          ///< of every coefficient not named below
  std::vector<std::pair<std::string, double>> named;  ///< key of the ship file, relative standard deviation

  /// Relative standard deviation of the coefficient with that key.
  double of(std::string_view key) const;
};

}  // namespace swayaw::core
