#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "swayaw/core/recording.hpp"
#include "swayaw/mismatch/quantity.hpp"
#include "swayaw/mismatch/region.hpp"
#include "swayaw/nonlinear/replay.hpp"
#include "swayaw/nonlinear/ship.hpp"

/// Where a simulation and a recording differ (docs/compare.md).
///
/// The recorded rudder and shaft speed drive the ship from the recorded state, anew every two ship lengths of way, so
/// that errors show where the model is wrong instead of piling up; and once more from the start of the run to its end.
namespace swayaw::inline mismatch {

struct CompareOptions {
  double window_lengths = 2.0;  ///< way made between restarts, in ship lengths
  ReplayOptions replay;
};

/// Part of a run that holds most of the error above the run's mean.
struct WorstInterval {
  double from;   ///< [s]
  double to;     ///< [s]
  double share;  ///< of all squared errors
  double rms;
};

/// Simulated minus recorded, in the SI unit of the quantity.
struct QuantityError {
  Quantity quantity;
  double variation;   ///< root-mean-square variation of the recorded quantity in the run
  double noise;       ///< root-mean-square scatter of the samples about local parabolas, or waves where they are more
  double waves;       ///< root mean square of what waves add to the recorded quantity, 0 where none move her
  double window_rms;  ///< restarted every window
  double bias;        ///< mean error, restarted every window
  double open_loop_rms;  ///< never restarted
  std::optional<WorstInterval> worst;
  std::vector<RegionError> regions;
  std::optional<RegionError> region;  ///< the worst of them

  /// Window error beyond the noise of the recording, sqrt(max(0, window_rms² − noise²)).
  double beyond_noise() const { return std::sqrt(std::max(0.0, window_rms * window_rms - noise * noise)); }
  /// Window error beyond what waves add, over the variation.
  double normalised_beyond_waves() const {
    return variation > 0.0 ? std::sqrt(std::max(0.0, window_rms * window_rms - waves * waves)) / variation : 0.0;
  }
  /// Whether waves add as much to the recording as the window error is.
  bool is_in_waves() const { return waves > 0.0 && window_rms <= waves; }
  double normalised() const { return variation > 0.0 ? window_rms / variation : 0.0; }
  double open_loop_normalised() const { return variation > 0.0 ? open_loop_rms / variation : 0.0; }
};

/// One run beside its simulations, which share its times.
struct Comparison {
  Recording recorded;
  Recording open_loop;
  Recording restarted;                     ///< window after window
  std::vector<std::size_t> window_starts;  ///< first sample of each window
  Conditions conditions;
  std::vector<QuantityError> errors;  ///< of every quantity that the run tells
};

/// @throws Refusal  if the run does not tell rudder or speed, or has fewer than three samples
Comparison compare(const Ship& ship, const Recording& run, const CompareOptions& options = {});

/// Errors of each quantity in all runs together, sample by sample; without a worst interval.
std::vector<QuantityError> pooled(const std::vector<Comparison>& comparisons);

/// One sentence: in which quantity the ship is farthest off, beyond noise, over all runs together and in units of its
/// variation, and in which run, interval and region most. Position is left out: its variation is the length of the run.
std::string verdict(const std::vector<Comparison>& comparisons);

}  // namespace swayaw::mismatch
