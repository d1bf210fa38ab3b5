#include <algorithm>
#include <cmath>

#include "catch.hpp"
#include "concealed_case.hpp"
#include "on_board_case.hpp"
#include "swayaw/mismatch/diagnose.hpp"

using namespace swayaw;
using namespace swayaw::concealed;

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

// Of 300 cases of a seed that was looked at these were missed, and not for the physics: the sway that an error of the
// compass feigns had taken the force away that resists it; a ship that cannot sail without her stream ended the search;
// a wind was refuted by runs that gained by it; a heel that nobody recorded was to act more than it gained.
TEST_CASE("what hides in a form, behind another summit or on other courses is found", "[bench][on_board][limit]") {
  struct Missed {
    std::size_t place;  ///< in the plan
    std::string_view effect, key;
    double near;  ///< of the true value, in its unit
  };
  const auto plan = plan_named("on_board", 300, 34);
  for (const auto& [place, effect, key, near] :
       {Missed{170, "heading_bias", "bias_rad", radians(0.5)}, Missed{108, "steady_current", "current_speed_m_s", 0.2},
        Missed{103, "steady_wind", "wind_from_rad", radians(20.0)}, Missed{21, "roll_coupling", "N_phi", 0.05}}) {
    const auto c = made(plan.at(place));
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

// Coefficients had gone up to 8 of their deviations from the file, and beside them a shaft that slows by a fifth was
// predicted to gain nothing.
TEST_CASE("what predicts most beside the ship as given is found where coefficients have gone far from it",
          "[bench][on_board][limit]") {
  const auto c = made(plan_named("on_board", 300, 35).at(38));
  REQUIRE(c.labels.size() == 1);
  const auto d = diagnose(c.ship, c.train, c.reference, c.holdout);
  const auto candidate = std::ranges::find(d.candidates, c.labels.front().effect, &Candidate::effect);
  REQUIRE(candidate != d.candidates.end());
  CHECK(candidate->log_evidence_gain > 100.0);
}

// A log that reads 13 % too much and a stream: the runs used gained by either, and those held out, on other courses,
// lost by either.
TEST_CASE("two errors that runs held out refute one by one are found together", "[bench][on_board][limit]") {
  const auto c = made(plan_named("on_board", 300, 35).at(142));
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
  const auto c = made(plan_named("on_board", 300, 35).at(30));
  REQUIRE(c.labels.size() == 1);
  const auto d = diagnose(c.ship, c.train, c.reference, c.holdout);
  INFO(d.words);
  REQUIRE(!d.effects.empty());
  CHECK(id_of(d.effects.front().effect) == c.labels.front().effect);
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
  const auto c = made(plan_named("on_board", 300, 41).at(240));
  REQUIRE(c.labels.size() == 1);
  const auto d = diagnose(c.ship, c.train, c.reference, c.holdout);
  INFO(d.words);
  REQUIRE(!d.effects.empty());
  CHECK(id_of(d.effects.front().effect) == c.labels.front().effect);
  CHECK(d.troubles.empty());
}

// Each is within what instruments and gears are off by from ship to ship, and gained 2 where that was ordinary.
TEST_CASE("what reference runs tell of instruments and gear makes small errors on other days findings",
          "[bench][on_board][limit]") {
  for (const auto& [number, key, near] : {std::tuple{198, "lag_s", 0.5}, std::tuple{153, "scale", 0.005}}) {
    const auto c = made(plan_named("on_board", 300, 40).at(static_cast<std::size_t>(number)));
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
