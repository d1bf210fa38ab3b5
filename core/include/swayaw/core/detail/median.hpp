#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace swayaw::inline core::detail {

/// The middle one of values in their order, of an even number the upper of the two.
///
/// @param values  at least one
inline double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// The median of their sizes: of normal deviates 1/1.4826 of the standard deviation, robust against a few that are
/// large.
inline double median_size_of(std::vector<double> values) {
  for (double& x : values) x = std::abs(x);
  return median_of(std::move(values));
}

}  // namespace swayaw::core::detail
