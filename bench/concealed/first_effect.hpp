#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

#include "catch.hpp"
#include "concealed_case.hpp"
#include "on_board_case.hpp"
#include "swayaw/mismatch/diagnose.hpp"

/// For tests of single cases: what is told of one, and the effect that comes first.
namespace swayaw::concealed {

/// A case as on board in which this effect is hidden, not another in its place.
inline ConcealedCase with_hidden(std::string_view structure, FileForm form, const std::string& effect,
                                 Severity severity, std::uint64_t seed) {
  auto c = made(on_board_plan(structure, form, {{effect, severity}}, seed));
  REQUIRE(c.labels.size() == 1);
  REQUIRE(c.labels.front().effect == effect);
  return c;
}

inline Diagnosis diagnosed(const ConcealedCase& c) { return diagnose(c.ship, c.train, c.reference, c.holdout); }

/// Checks the verdict, that something is told, and what comes first.
inline const FoundEffect& checked_first(const Diagnosis& d, DiagnosisVerdict verdict, std::string_view effect) {
  CHECK(d.verdict == verdict);
  REQUIRE(!d.effects.empty());
  CHECK(id_of(d.effects.front().effect) == effect);
  return d.effects.front();
}

/// A parameter that must be told.
inline const ParameterEstimate& told(const FoundEffect& effect, std::string_view key) {
  const auto found = std::ranges::find(effect.parameters, key, &ParameterEstimate::key);
  REQUIRE(found != effect.parameters.end());
  return *found;
}

}  // namespace swayaw::concealed
