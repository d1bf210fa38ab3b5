#pragma once

#include "commands.hpp"
#include "swayaw/app/page.hpp"
#include "swayaw/mismatch/diagnose.hpp"

namespace swayaw::app {

/// What the page of a diagnosis says first: how far off the model is, what explains it, whose fault it is, how sure
/// that is, and what to sail next.
Page diagnosis_first_screen(const Ship& ship, const Diagnosis& diagnosis, const DiagnoseArguments& asked);

}  // namespace swayaw::app
