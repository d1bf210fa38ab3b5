#pragma once

#include <algorithm>
#include <string_view>

#include "catch.hpp"
#include "concealed_case.hpp"
#include "swayaw/mismatch/diagnose.hpp"

/// For tests of single cases: what is told of one, and the effect that comes first.
namespace swayaw::concealed {

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
