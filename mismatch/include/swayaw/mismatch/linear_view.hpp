#pragma once

#include <span>
#include <string>
#include <vector>

#include "swayaw/core/recording.hpp"
#include "swayaw/nonlinear/ship.hpp"

/// Recordings and a model seen by the linear floor: what K, T and the drift–yaw loop of zigzags say of a mismatch.
namespace swayaw::inline mismatch {

/// A zigzag by Nomoto's first-order equation and its loop in the plane of drift and yaw rate.
struct ZigzagView {
  double K;          ///< K L/U, rudder positive to port
  double T;          ///< T U/L
  double delta_r;    ///< rudder offset that acts beside the recorded angle [rad]
  double loop_area;  ///< ∮ beta d(r') over one period; NaN where the sway velocity was not recorded
};

struct LinearView {
  std::string run;
  double amplitude;  ///< largest rudder angle [rad]
  ZigzagView recorded, model;
};

/// Each zigzag among the runs beside the model's replay of it. Speeds are the means over the run.
///
/// Runs that are no zigzags, or that the model cannot sail, are left out.
std::vector<LinearView> linear_view(const Ship& model, std::span<const Recording> runs);

/// What follows, in words: offset, linear or nonlinear gain, history. Empty where recordings and model agree within a
/// tenth, and the offsets within 0.3 deg.
std::string words_of(std::span<const LinearView> views);

}  // namespace swayaw::mismatch
