#include <algorithm>
#include <cmath>

#include "first_effect.hpp"

/// What drags at one side of a ship as on board, and what only looks as if it did.
using namespace swayaw;
using namespace swayaw::concealed;

namespace {

/// How far from the centreline it is told to hang.
void check_place(const ConcealedCase& c, const FoundEffect& found) {
  const auto& place = told(found, "drag_y_m");
  REQUIRE(c.labels.front().parameters.size() == 1);
  CHECK(std::abs(place.value - c.labels.front().parameters.front().value) < 3.5 * place.standard_error);
}

}  // namespace

// Weed grows with U^1.3, on a ship of another structure; reference runs tell how she was without it. Both cases were
// told more resistance.
TEST_CASE("weed at one bow is no more resistance but something unknown on that side", "[bench][on_board][limit]") {
  for (const auto& [structure, form, seed] : {std::tuple{"twin_screw", FileForm::mmg, 0x9abe662f8d0ecfbaull},
                                              std::tuple{"rolling", FileForm::mmg, 0x0655bfc46a4dcacaull}}) {
    const auto c = with_hidden(structure, form, "unknown_kelp", Severity::strong, seed);
    REQUIRE(!c.reference.empty());
    const auto d = diagnosed(c);
    INFO(structure << ": " << d.words);
    check_place(c, checked_first(d, DiagnosisVerdict::unexplained, "unknown"));
  }
}

// Without a recorded shaft speed it is what carries her at the speed with which a run begins, weed and all. As long as
// it was what would carry her without, a drag made things worse, and the weed was told as more resistance.
TEST_CASE("weed at one bow is told where no shaft speed is recorded", "[bench][on_board][limit]") {
  for (const auto& [form, severity, seed] : {std::tuple{FileForm::mmg, Severity::moderate, 0x4d1beb25ab5b6b33ull},
                                             std::tuple{FileForm::pi, Severity::strong, 0x725d929f89122f3eull}}) {
    const auto c = with_hidden("twin_screw", form, "unknown_kelp", severity, seed);
    REQUIRE(!c.reference.empty());
    REQUIRE(std::ranges::none_of(c.train, [](const Recording& run) { return run.has(Channel::rev); }));
    const auto d = diagnosed(c);
    INFO(d.words);
    check_place(c, checked_first(d, DiagnosisVerdict::unexplained, "unknown"));
  }
}

// A file in Abkowitz form has no resistance that could be larger. Nothing was told.
TEST_CASE("a drag is told where the file has no resistance, its side or not", "[bench][on_board][limit]") {
  const auto c =
      with_hidden("cross_flow", FileForm::abkowitz, "unknown_kelp", Severity::moderate, 0x2006312fb132ae5full);
  REQUIRE(!c.reference.empty());
  const auto d = diagnosed(c);
  INFO(d.words);
  const auto& found = checked_first(d, DiagnosisVerdict::unexplained, "unknown");
  const auto& drag = told(found, "drag");
  CHECK(drag.value > 5.0 * drag.standard_error);
  const auto& place = told(found, "drag_y_m");
  CHECK(std::abs(place.value) < 2.0 * place.standard_error);
  CHECK(d.words.find("on which side is not told") != std::string::npos);
}

// A drag at one side explained these runs better than either alone.
TEST_CASE("more resistance and an offset of the rudder are no drag at one side", "[bench][on_board][limit]") {
  const auto c =
      made(on_board_plan("twin_screw", FileForm::mmg,
                         {{"added_resistance", Severity::strong}, {"rudder_offset", Severity::moderate}}, 0x7530ec71));
  REQUIRE(c.labels.size() == 2);
  REQUIRE(!c.reference.empty());
  const auto d = diagnosed(c);
  INFO(d.words);
  REQUIRE(!d.candidates.empty());
  CHECK(d.candidates.front().effect == "unknown");
  CHECK(d.verdict == DiagnosisVerdict::missing_physics);
  REQUIRE(d.effects.size() == 2);
  for (const auto& label : c.labels)
    CHECK(std::ranges::count(d.effects, label.effect,
                             [](const FoundEffect& e) { return std::string(id_of(e.effect)); }) == 1);
}
