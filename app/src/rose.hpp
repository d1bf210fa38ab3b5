#pragma once

#include <vector>

#include "swayaw/app/page.hpp"
#include "swayaw/mismatch/diagnose.hpp"
#include "user_units.hpp"

namespace swayaw::app {

/// A section for each effect found that has a direction over the earth: a rose with the direction, where it is with
/// 95 %, and the headings that were sailed. Where it differs from run to run, one for each.
std::vector<PageSection> direction_sections(const Diagnosis& diagnosis, const UserUnits& units);

}  // namespace swayaw::app
