#pragma once

#include <filesystem>
#include <optional>

#include "indices_page.hpp"
#include "swayaw/core/side.hpp"
#include "swayaw/nonlinear/linearization.hpp"

/// Linear models as MATLAB files, with the fields of `ss` (docs/matlab.md): A, B, C, D in SI, names and units of
/// states, inputs and outputs, and the transfer function from rudder to yaw rate.
namespace swayaw::app {

/// Coupled equations of sway and yaw; where the ship has none, the transfer function alone.
void write_linear_model(const std::filesystem::path& file, const SteeringSides& sides, double speed);

/// A linearization with its operating point, and where the forces have a kink those of turns to each side.
struct LinearizedSides {
  Linearization mean;
  std::optional<Linearization> port, starboard;
};

/// Small motions of surge, sway and yaw.
void write_linear_model(const std::filesystem::path& file, const Ship& ship, const LinearizedSides& sides);

}  // namespace swayaw::app
