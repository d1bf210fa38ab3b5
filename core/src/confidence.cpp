#include "swayaw/core/confidence.hpp"

#include <algorithm>

namespace swayaw::inline core {

double Confidence::of(std::string_view key) const {
  const auto found = std::ranges::find(named, key, &std::pair<std::string, double>::first);
  return found == named.end() ? coefficients : found->second;
}

}  // namespace swayaw::core
