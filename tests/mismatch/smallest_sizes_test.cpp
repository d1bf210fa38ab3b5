#include <algorithm>
#include <catch.hpp>

#include "planted_sizes.hpp"

/// The list of smallest effects that would have shown is true: planted at the listed size, nine of ten are found.
namespace swayaw {
namespace {

TEST_CASE("effects of the sizes that are listed as the smallest to show are found", "[mismatch][second-route]") {
  const auto sizes = test::listed_sizes();
  REQUIRE(!sizes.empty());
  for (const auto effect : {"steady_current", "rudder_offset", "added_resistance"}) {
    const auto size = std::ranges::find(sizes, effect, &DetectableSize::effect);
    REQUIRE(size != sizes.end());
    INFO(effect << " " << size->value);
    CHECK(test::found_of(*size, 4).first >= 3);
  }
}

}  // namespace
}  // namespace swayaw
