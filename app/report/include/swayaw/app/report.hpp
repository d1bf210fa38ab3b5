#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "swayaw/app/page.hpp"

namespace swayaw {

/// Pages whose first screen is static and whose further plots a script draws in the browser from the data that are in
/// the page, and with the plotting library that is in it: it asks nothing of the network. Data are what the script
/// reads; their names are those of the command's JSON document. Every plot can be saved as SVG.

/// Errors and series of compared runs. The series are thinned and rounded to six significant digits; all other values
/// are kept as given.
std::string comparison_page(const Page& page, const nlohmann::json& data);

/// Indices, zigzag, drift–yaw loop, and the map of a loop measure over T3b and T3w.
std::string loop_page(const Page& page, const nlohmann::json& data);

/// Of a diagnosis the missing force over time and in the drift–yaw plane, the ranking of effects, replays, and what to
/// sail next. The series are rounded as those of a comparison.
std::string diagnosis_page(const Page& page, const nlohmann::json& data);

/// What was told of instruments, with the standard errors of all runs side by side, and what the samples of each
/// channel are like.
std::string check_page(const Page& page, const nlohmann::json& data);

/// Of judged trials a table of numbers for each run, heading and rudder, the track.
std::string trial_page(const Page& page, const nlohmann::json& data);

}  // namespace swayaw
