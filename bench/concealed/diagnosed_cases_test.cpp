#include <algorithm>
#include <cmath>

#include "catch.hpp"
#include "concealed_case.hpp"
#include "on_board_case.hpp"
#include "swayaw/mismatch/diagnose.hpp"

using namespace swayaw;
using namespace swayaw::concealed;

namespace {

/// A case of a seed that was looked at, and how near a number of what is found must come.
struct SeenCase {
  const char* structure;
  FileForm form;
  const char* planned;
  Severity severity;
  std::uint64_t seed;
  std::string_view key;
  double near;  ///< of the true value, in its unit
};

/// What is said of a case in which one thing is hidden, which is named first.
Diagnosis of_named_first(const ConcealedCase& c, const DiagnosisOptions& options = {}) {
  REQUIRE(c.labels.size() == 1);
  auto d = diagnose(c.ship, c.train, c.reference, c.holdout, options);
  INFO(d.words);
  REQUIRE(!d.effects.empty());
  CHECK(id_of(d.effects.front().effect) == c.labels.front().effect);
  return d;
}

}  // namespace

// Strips of a tanker's hull are not the polynomial of her file; exact recordings tell that, as a drag of 0.13 to 0.21.
TEST_CASE("the polynomial of a hull lacks no cross-flow drag, and the smallest that is hidden is found",
          "[bench][limit]") {
  const auto diagnosed = [](std::string_view plan, std::size_t cases, std::uint64_t seed, std::size_t place) {
    const auto c = made(plan_named(plan, cases, seed).at(place));
    return std::pair{c.labels, diagnose(c.ship, c.train, c.reference, c.holdout)};
  };
  for (const std::size_t place : {42, 45}) {
    const auto [hidden, d] = diagnosed("clean", 1000, 777, place);
    INFO(d.words);
    CHECK(hidden.empty());
    CHECK(d.verdict == DiagnosisVerdict::nothing_missing);
    CHECK(d.as_form == std::vector<std::string>{"cross-flow drag"});
    CHECK(std::ranges::none_of(d.improved.effects, [](const Effect& e) { return id_of(e) == "cross_flow_drag"; }));
  }
  const auto [hidden, d] = diagnosed("singles", 110, 555, 67);
  INFO(d.words);
  REQUIRE(hidden.size() == 1);
  CHECK(hidden.front().severity == Severity::weak);
  REQUIRE(d.effects.size() == 1);
  CHECK(id_of(d.effects.front().effect) == hidden.front().effect);
}

// Another lever of the rudder, l_R, had been told with one number in place of the two that grew by one factor.
TEST_CASE("a flow straightening that is larger on both sides is told as that", "[bench][limit]") {
  const auto c = made(plan_named("all", 200, 2).at(29));
  REQUIRE(c.labels.size() == 1);
  REQUIRE(c.labels.front().effect == "flow_straightening");
  const auto d = of_named_first(c);
  INFO(d.words);
  const auto& found = d.effects.front().parameters;
  REQUIRE(found.size() == 2);
  for (const auto& truth : c.labels.front().parameters) {
    INFO(truth.key);
    const auto told = std::ranges::find(found, truth.key, &ParameterEstimate::key);
    REQUIRE(told != found.end());
    CHECK(std::abs(told->value - truth.value) < 2.0 * told->standard_error);
    CHECK(told->standard_error < 0.2 * truth.value);
  }
}

// Of 300 cases of a seed that was looked at these were missed, and not for the physics: the sway that an error of the
// compass feigns had taken the force away that resists it; a ship that cannot sail without her stream ended the search;
// a wind was refuted by runs that gained by it; a heel that nobody recorded was to act more than it gained.
TEST_CASE("what hides in a form, behind another summit or on other courses is found", "[bench][on_board][limit]") {
  using enum Severity;
  for (const auto& [structure, form, effect, severity, seed, key, near] :
       {SeenCase{"rolling", FileForm::abkowitz, "heading_bias", strong, 0x2839b0cf2138ceea, "bias_rad", radians(0.5)},
        SeenCase{"twin_screw", FileForm::mmg, "steady_current", strong, 0x8fb100ee6c458316, "current_speed_m_s", 0.2},
        SeenCase{"twin_screw", FileForm::mmg, "steady_wind", moderate, 0x1073438d0b2d0ad8, "wind_from_rad",
                 radians(20.0)},
        SeenCase{"twin_screw", FileForm::mmg, "roll_coupling", moderate, 0x5d9337de95d4f479, "N_phi", 0.05}}) {
    const auto c = made(on_board_plan(structure, form, {{effect, severity}}, seed));
    REQUIRE(c.labels.size() == 1);
    REQUIRE(c.labels.front().effect == effect);
    const auto d = diagnose(c.ship, c.train, c.reference, c.holdout);
    INFO(effect << ": " << d.words);
    REQUIRE(!d.effects.empty());
    const auto& found = d.effects.front();
    REQUIRE(id_of(found.effect) == effect);
    const auto truth = std::ranges::find(c.labels.front().parameters, key, &LabelNumber::key);
    const auto value = std::ranges::find(found.parameters, key, &ParameterEstimate::key);
    REQUIRE((truth != c.labels.front().parameters.end() && value != found.parameters.end()));
    CHECK(std::abs(wrapped(value->value - truth->value)) < near);
    CHECK(std::ranges::none_of(d.effects, [](const FoundEffect& e) { return id_of(e.effect) == "model_form"; }));
    CHECK(d.troubles.empty());
  }
}

// The form of her forces had held a third of the resistance, and wider priors made the rest 28 deviations of R_0.
TEST_CASE("a resistance that is much larger is found without reference runs", "[bench][on_board][limit]") {
  const auto c =
      made(on_board_plan("cross_flow", FileForm::mmg, {{"added_resistance", Severity::strong}}, 0x5a33837853161d66));
  REQUIRE(c.reference.empty());
  REQUIRE(c.labels.size() == 1);
  REQUIRE(c.labels.front().effect == "added_resistance");
  const auto d = diagnose(c.ship, c.train, c.reference, c.holdout);
  INFO(d.words);
  REQUIRE(!d.effects.empty());
  const auto& found = d.effects.front();
  REQUIRE(id_of(found.effect) == "added_resistance");
  const double truth = c.labels.front().parameters.front().value;
  CHECK(std::abs(found.parameters.front().value - truth) < 2.5 * found.parameters.front().standard_error);
}

// Coefficients had gone up to 8 of their deviations from the file, and beside them a shaft that slows by a fifth was
// predicted to gain nothing.
TEST_CASE("what predicts most beside the ship as given is found where coefficients have gone far from it",
          "[bench][on_board][limit]") {
  const auto c =
      made(on_board_plan("polynomial", FileForm::mmg, {{"heading_bias", Severity::strong}}, 0xa1e0da77a7023194));
  REQUIRE(c.labels.size() == 1);
  const auto d = diagnose(c.ship, c.train, c.reference, c.holdout);
  const auto candidate = std::ranges::find(d.candidates, c.labels.front().effect, &Candidate::effect);
  REQUIRE(candidate != d.candidates.end());
  CHECK(candidate->log_evidence_gain > 100.0);
}

// A log that reads 13 % too much and a stream: the runs used gained by either, and those held out, on other courses,
// lost by either.
TEST_CASE("two errors that runs held out refute one by one are found together", "[bench][on_board][limit]") {
  const auto c =
      made(on_board_plan("polynomial", FileForm::mmg,
                         {{"log_scale", Severity::strong}, {"steady_current", Severity::strong}}, 0x2762fd01d4e9c204));
  REQUIRE(c.labels.size() == 2);
  const auto d = diagnose(c.ship, c.train, c.reference, c.holdout);
  INFO(d.words);
  REQUIRE(d.effects.size() == 2);
  for (const auto& [key, near] :
       {std::pair{"scale", 0.03}, std::pair{"current_speed_m_s", 0.2}, std::pair{"current_to_rad", radians(15.0)}}) {
    INFO(key);
    std::optional<double> truth, value;
    for (const auto& label : c.labels)
      for (const auto& n : label.parameters)
        if (n.key == key) truth = n.value;
    for (const auto& found : d.effects)
      for (const auto& p : found.parameters)
        if (p.key == key) value = p.value;
    REQUIRE((truth && value));
    CHECK(std::abs(wrapped(*value - *truth)) < near);
  }
  for (const auto& candidate : d.candidates)
    if (candidate.effect == id_of(d.effects[0].effect) || candidate.effect == id_of(d.effects[1].effect))
      CHECK_FALSE(candidate.refuted);
  // in the first run a wrong fix lies beside a state that a replay takes up
  for (const auto& run : d.train)
    for (const auto& e : run.after)
      if (e.quantity == Quantity::yaw_rate) CHECK(e.normalised_beyond_waves() < 0.05);
}

// A wind that came first stood for half of the waves that were there.
TEST_CASE("what the whole would lack most is named first", "[bench][on_board][limit]") {
  const auto c =
      made(on_board_plan("twin_screw", FileForm::mmg, {{"wave_drift", Severity::strong}}, 0x30384f4eafe90b6f));
  const auto d = of_named_first(c);
  INFO(d.words);
  // what is told of it is that of the saved ship, though what might be form was dropped beside it
  CHECK(!d.as_form.empty());
  for (const auto& found : d.effects) {
    const auto saved =
        std::ranges::find(d.improved.effects, id_of(found.effect), [](const Effect& e) { return id_of(e); });
    REQUIRE(saved != d.improved.effects.end());
    for (const auto& p : parameters_of(d.improved, *saved)) {
      const auto told = std::ranges::find(found.parameters, p.key, &ParameterEstimate::key);
      if (told != found.parameters.end()) CHECK(told->value == p.value);
    }
  }
}

// Her hull pushes her round without bound at the drift of the hard turn, which no filter follows with the noise that is
// usual; with more of it one does, and what is hidden is found. There had been no answer.
TEST_CASE("a ship that runs away as her file has it is diagnosed all the same", "[bench][on_board][limit]") {
  const auto c = made(on_board_plan("podded", FileForm::mmg, {{"fluid_memory", Severity::strong}}, 0x9db7edcd851f2c23));
  const auto d = of_named_first(c);
  INFO(d.words);
  CHECK(d.troubles.empty());
}

// She loses her way in a zigzag beside an inexact form, whatever the noise: that had ended all. One effect is
// asked for here, as the search for more beside it takes most of the time.
TEST_CASE("what is found beside an exact form stands where a ship cannot sail beside an inexact one",
          "[bench][on_board][limit]") {
  const auto c =
      made(on_board_plan("polynomial", FileForm::mmg, {{"log_scale", Severity::moderate}}, 0x47bef0936804ecff));
  const auto d = of_named_first(c, {.most_effects = 1});
  INFO(d.words);
  REQUIRE(d.troubles.size() == 1);
  CHECK(d.troubles.front().find("beside an inexact form ended early") != std::string::npos);
}

// It blows up over a fifth of L/U, which what is fitted does at once: the interval of the onset had missed by 0.9 s.
TEST_CASE("onset and end of a gust are known to a part of the ship's length", "[bench][on_board][limit]") {
  const auto c = made(on_board_plan("podded", FileForm::pi, {{"gust", Severity::moderate}}, 0x1eecaa370231f8ad));
  const auto d = of_named_first(c);
  INFO(d.words);
  const auto& label = c.labels.front().parameters;
  const auto& found = d.effects.front().parameters;
  for (const std::string_view key : {"onset_s", "end_s"}) {
    INFO(key);
    const auto truth = std::ranges::find(label, key, &LabelNumber::key);
    const auto told = std::ranges::find(found, key, &ParameterEstimate::key);
    REQUIRE(truth != label.end());
    REQUIRE(told != found.end());
    CHECK(std::abs(told->value - truth->value) < 1.96 * told->standard_error);
  }
}

// Each is within what instruments and gears are off by from ship to ship, and gained 2 where that was ordinary.
TEST_CASE("what reference runs tell of instruments and gear makes small errors on other days findings",
          "[bench][on_board][limit]") {
  for (const auto& [structure, form, planned, severity, seed, key, near] :
       {SeenCase{"rolling", FileForm::mmg, "steering_gear_lag", Severity::strong, 0xf8a0476df4bf29b9, "lag_s", 0.5},
        SeenCase{"twin_screw", FileForm::abkowitz, "log_scale", Severity::moderate, 0x954d6a0cf38be6df, "scale",
                 0.005}}) {
    const auto c = made(on_board_plan(structure, form, {{planned, severity}}, seed));
    REQUIRE(c.labels.size() == 1);
    REQUIRE(!c.reference.empty());
    INFO(c.labels.front().effect);
    const auto d = diagnose(c.ship, c.train, c.reference, c.holdout);
    INFO(d.words);
    REQUIRE(d.effects.size() == 1);
    const auto& found = d.effects.front();
    CHECK(id_of(found.effect) == c.labels.front().effect);
    const auto value = std::ranges::find(found.parameters, key, &ParameterEstimate::key);
    REQUIRE(value != found.parameters.end());
    CHECK(std::abs(value->value - c.labels.front().parameters.front().value) < near);
  }
}
