#pragma once

#include "commands.hpp"
#include "identify_answer.hpp"
#include "swayaw/app/page.hpp"
#include "swayaw/identification/linear_fit.hpp"

namespace swayaw::app {

/// The page of an identification: how the found ship predicts runs, and which coefficients can be trusted.
Page identify_page(const Question& question, const Answer& answer, const Predictions& predictions,
                   const IdentifyArguments& arguments);

}  // namespace swayaw::app
