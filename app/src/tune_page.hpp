#pragma once

#include "commands.hpp"
#include "swayaw/app/page.hpp"
#include "swayaw/identification/index_tuning.hpp"

namespace swayaw::app {

/// The page of a tuning: whether the ship turns as measured now, and what had to change.
Page tune_page(const Ship& before, const MeasuredIndices& measured, const Tuning& tuning,
               const TuneArguments& arguments);

}  // namespace swayaw::app
