#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "swayaw/app/page.hpp"

namespace swayaw {

/// Pages whose first screen is static and whose further plots are drawn in the browser.
///
/// One that shows a comparison document ("swayaw.comparison/1"). The page holds its plotting library and its data, and
/// asks nothing of the network. The series in it are thinned and rounded to six significant digits; all other values
/// are kept as given.
std::string comparison_page(const Page& page, const nlohmann::json& document);

/// One HTML page that shows a drift–yaw loop document ("swayaw.loop/1"): indices, zigzag, loop, the
/// map of a loop measure over T3b and T3w. Every plot can be saved as SVG.
std::string loop_page(const Page& page, const nlohmann::json& document);

/// One HTML page that shows a diagnosis document ("swayaw.diagnosis/2") with the series of its runs: the verdict, the
/// missing force over time and in the drift–yaw plane, the ranking of effects, replays, and what to sail next. The
/// series are rounded as those of a comparison.
std::string diagnosis_page(const Page& page, const nlohmann::json& document);

/// One HTML page that shows a document of a check ("swayaw.check/1"): what was told of instruments, with the standard
/// errors of all runs side by side, and what the samples of each channel are like.
std::string check_page(const Page& page, const nlohmann::json& document);

/// One HTML page for the owner that shows judged trials ("swayaw.trial/1") with their rows and series: the verdict of
/// MSC.137(76), a table of numbers for each run, heading and rudder, the track.
std::string trial_page(const Page& page, const nlohmann::json& document);

}  // namespace swayaw
