#pragma once

#include "commands.hpp"

namespace swayaw::app {

/// `identify --model linear`: the coupled equations of sway and yaw, from recordings that tell drift.
void identify_linear(const IdentifyArguments& arguments);

}  // namespace swayaw::app
