#pragma once

#include <algorithm>
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

}  // namespace swayaw::core::detail
