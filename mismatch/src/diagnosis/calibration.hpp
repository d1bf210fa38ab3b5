#pragma once

#include <span>

#include "../trial/trial.hpp"

/// What runs in which nothing is hidden tell of the baseline. Not installed.
namespace swayaw::inline mismatch::detail {

/// Runs in which nothing is hidden tell the baseline.
void calibrate(Trial& trial, const Ship& ship, std::span<const Recording> reference, std::span<const Channel> channels,
               bool on_board);

}  // namespace swayaw::mismatch::detail
