#pragma once

#include <optional>
#include <vector>

#include "swayaw/app/page.hpp"
#include "swayaw/identification/data_compatibility.hpp"

namespace swayaw::app {

/// What the page of checked recordings says first: whether they can be believed, what is off, and what to do.
///
/// @param log  the log that the runs were cut from, if they were
Page first_screen(const std::vector<RunCheck>& checks, const std::optional<RunCheck>& log, bool si);

}  // namespace swayaw::app
