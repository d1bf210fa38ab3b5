#include <algorithm>
#include <cmath>

#include "catch.hpp"
#include "concealed_case.hpp"
#include "on_board_case.hpp"
#include "swayaw/mismatch/diagnose.hpp"

/// What stands behind an effect that is no more than an error in the form of a ship's forces.
using namespace swayaw;
using namespace swayaw::concealed;

// A stall, which runs held out bore out better, was found in place of the rudder and was no more than an error of form:
// both were told that nothing is missing.
TEST_CASE("a weak rudder that stands behind an error of form is found", "[bench][on_board]") {
  for (const auto& [structure, seed] :
       {std::pair{"modulus", 0x0a929d6aae151fbcull}, std::pair{"rolling", 0xd7d653f54793be32ull}}) {
    const auto c = made(on_board_plan(structure, FileForm::pi, {{"rudder_effectiveness", Severity::strong}}, seed));
    REQUIRE(c.labels.size() == 1);
    REQUIRE(c.labels.front().effect == "rudder_effectiveness");
    REQUIRE(!c.reference.empty());
    const auto d = diagnose(c.ship, c.train, c.reference, c.holdout);
    INFO(structure << ": " << d.words);
    CHECK(d.verdict == DiagnosisVerdict::missing_physics);
    REQUIRE(!d.effects.empty());
    const auto& found = d.effects.front();
    CHECK(id_of(found.effect) == "rudder_effectiveness");
    REQUIRE(found.parameters.size() == 1);
    CHECK(std::abs(found.parameters.front().value - c.labels.front().parameters.front().value) < 0.06);
    CHECK(std::ranges::count(d.as_form, "a rudder that stalls") == 1);
    const auto stall = std::ranges::find(d.candidates, "rudder_stall", &Candidate::effect);
    REQUIRE(stall != d.candidates.end());
    CHECK(stall->as_form);
  }
}
