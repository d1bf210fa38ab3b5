#include <algorithm>
#include <cmath>
#include <utility>

#include "first_effect.hpp"

/// Effects that had been passed over: something that is no more than an error in the form of a ship's forces, or a
/// trace, had stood before them, and the answer was that nothing is missing.
using namespace swayaw;
using namespace swayaw::concealed;

namespace {

/// That what is hidden in a case comes first, and a parameter of it this far off at most.
void check_found(const ConcealedCase& c, const Diagnosis& d, std::string_view key, double most) {
  const auto& label = c.labels.front();
  const auto& found = checked_first(d, DiagnosisVerdict::missing_physics, label.effect);
  const auto truth = std::ranges::find(label.parameters, key, &LabelNumber::key);
  REQUIRE(truth != label.parameters.end());
  CHECK(std::abs(told(found, key).value - truth->value) < most);
}

/// A ship with a PI file, the lift of whose rudder is a third off, told beside reference runs.
/// @param shaft  whether its speed is recorded
Diagnosis with_weak_rudder(std::string_view structure, bool shaft, std::uint64_t seed) {
  const auto c = with_hidden(structure, FileForm::pi, "rudder_effectiveness", Severity::strong, seed);
  REQUIRE(!c.reference.empty());
  REQUIRE(c.train.front().has(Channel::rev) == shaft);
  auto d = diagnosed(c);
  INFO(structure << ": " << d.words);
  check_found(c, d, "factor", 0.06);
  CHECK(d.effects.front().parameters.size() == 1);
  return d;
}

}  // namespace

// A stall, which runs held out bore out better, was found in place of the rudder and was no more than an error of form.
TEST_CASE("a weak rudder that stands behind an error of form is found", "[bench][on_board]") {
  const auto d = with_weak_rudder("modulus", true, 0x0a929d6aae151fbcull);
  INFO(d.words);
  CHECK(std::ranges::count(d.as_form, "a rudder that stalls") == 1);
  const auto stall = std::ranges::find(d.candidates, "rudder_stall", &Candidate::effect);
  REQUIRE(stall != d.candidates.end());
  CHECK(stall->as_form);
}

// The same stall stood before it as long as what carries her, whose shaft speed is not recorded, did not carry the form
// of her forces.
TEST_CASE("a weak rudder is found where no shaft speed is recorded", "[bench][on_board]") {
  const auto d = with_weak_rudder("rolling", false, 0xd7d653f54793be32ull);
  INFO(d.words);
  CHECK(d.as_form.empty());
}

// It gains 81 in the runs used, which alone may be the form of her forces, and 67 in those held out.
TEST_CASE("a force that follows the motion late is told by runs that were not used, too", "[bench][on_board]") {
  const auto c = with_hidden("podded", FileForm::abkowitz, "fluid_memory", Severity::strong, 0x4596f8b633b2deb5ull);
  REQUIRE(c.reference.empty());
  const auto d = diagnosed(c);
  INFO(d.words);
  check_found(c, d, "share", 0.15);
}

// Other linear derivatives of the hull, a few per cent of them, follow a part of what a slower shaft does.
TEST_CASE("a force of one number is told before a trace of several that follows it", "[bench][on_board]") {
  const auto c = with_hidden("modulus", FileForm::mmg, "shaft_speed_drop", Severity::moderate, 0x20715bb390f02faeull);
  REQUIRE(!c.reference.empty());
  const auto d = diagnosed(c);
  INFO(d.words);
  check_found(c, d, "relative_drop", 0.05);
}

// Counted from her file, of which reference runs say otherwise, they were a trace, and a cross-flow drag stood in their
// place; counted from what reference runs tell they gain more than that in the runs used and in those held out.
TEST_CASE("other cubic terms of the hull are told from those of reference runs", "[bench][on_board]") {
  const auto c =
      with_hidden("twin_screw", FileForm::mmg, "hull_nonlinear_damping", Severity::moderate, 0x1407c4634fd93a31ull);
  REQUIRE(!c.reference.empty());
  const auto d = diagnosed(c);
  INFO(d.words);
  const auto& found = checked_first(d, DiagnosisVerdict::missing_physics, "hull_nonlinear_damping");
  CHECK(found.probability > 0.8);
  const auto drag = std::ranges::find(d.candidates, "cross_flow_drag", &Candidate::effect);
  REQUIRE(drag != d.candidates.end());
  CHECK(drag->log_evidence_gain < d.candidates.front().log_evidence_gain);
}

// Her roll, which the reference runs hold, gains 79 with runs held out as a trace and takes up a part of the weak
// rudder, which gains 32.
TEST_CASE("a weak rudder is found before a roll that reference runs hold", "[bench][on_board]") {
  const auto c = made(on_board_plan("rolling", FileForm::pi,
                                    {{"heading_bias", Severity::strong}, {"rudder_effectiveness", Severity::moderate}},
                                    0x6ef1795ee7ba84d6ull));
  REQUIRE(c.labels.size() == 2);
  REQUIRE(!c.reference.empty());
  const auto d = diagnosed(c);
  INFO(d.words);
  CHECK(d.verdict == DiagnosisVerdict::missing_physics);
  REQUIRE(d.effects.size() == 2);
  for (const auto& label : c.labels) {
    INFO(label.effect);
    const auto found =
        std::ranges::find(d.effects, label.effect, [](const FoundEffect& e) { return std::string(id_of(e.effect)); });
    REQUIRE(found != d.effects.end());
    const auto& truth = label.parameters.front();
    const auto& value = told(*found, truth.key);
    CHECK(std::abs(value.value - truth.value) < 2.0 * value.standard_error);
  }
  CHECK(std::ranges::count(d.traces, "heel that acts on sway and yaw") == 1);
}
