#include <algorithm>
#include <cmath>

#include "catch.hpp"
#include "concealed_case.hpp"
#include "on_board_case.hpp"
#include "swayaw/mismatch/diagnose.hpp"

/// Forces that runs held out bear out, and that had been taken for the form of a ship's forces or for a trace.
using namespace swayaw;
using namespace swayaw::concealed;

namespace {

/// That what is hidden in a case is told first, a number of it this far off at most.
void check_found(const ConcealedCase& c, std::string_view key, double most) {
  REQUIRE(c.labels.size() == 1);
  const auto& label = c.labels.front();
  const auto d = diagnose(c.ship, c.train, c.reference, c.holdout);
  INFO(label.effect << ": " << d.words);
  CHECK(d.verdict == DiagnosisVerdict::missing_physics);
  REQUIRE(!d.effects.empty());
  CHECK(id_of(d.effects.front().effect) == label.effect);
  const auto& parameters = d.effects.front().parameters;
  const auto found = std::ranges::find(parameters, key, &ParameterEstimate::key);
  const auto truth = std::ranges::find(label.parameters, key, &LabelNumber::key);
  REQUIRE(found != parameters.end());
  REQUIRE(truth != label.parameters.end());
  CHECK(std::abs(found->value - truth->value) < most);
}

}  // namespace

// It gains 81 in the runs used, which alone may be the form of her forces, and 67 in those held out.
TEST_CASE("a force that follows the motion late is told by runs that were not used, too", "[bench][on_board]") {
  const auto c =
      made(on_board_plan("podded", FileForm::abkowitz, {{"fluid_memory", Severity::strong}}, 0x4596f8b633b2deb5ull));
  REQUIRE(c.reference.empty());
  check_found(c, "share", 0.15);
}

// Other linear derivatives of the hull, a few per cent of them, follow a part of what a slower shaft does.
TEST_CASE("a force of one number is told before a trace of several that follows it", "[bench][on_board]") {
  const auto c =
      made(on_board_plan("modulus", FileForm::mmg, {{"shaft_speed_drop", Severity::moderate}}, 0x20715bb390f02faeull));
  REQUIRE(!c.reference.empty());
  check_found(c, "relative_drop", 0.05);
}
