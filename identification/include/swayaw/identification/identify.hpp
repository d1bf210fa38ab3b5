#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "swayaw/identification/force_fit.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"

/// What a user of recordings wants to know besides the coefficients: which ones to look for, whether the ship is
/// stable, how much they depend on the choice of runs, and whether the ship steers as recorded. docs/identification.md
namespace swayaw::inline identification {

/// The ship in another model with the same hull, propeller and steering gear: "pi" and "pu" take each other's, a rudder
/// polynomial begins at 0. Her own model is returned as it is.
/// @throws Refusal  where the other model needs parameters that she does not have
Ship in_model(const Ship& ship, std::string_view model);

/// Coefficients that are looked for unless others are named: those of hull (and, in a PU ship, rudder polynomial) that
/// are not 0; where all are 0, those of the model's published form.
std::vector<std::string> usual_parameters(const Ship& ship);

// ---------------------------------------------------------------- stability

enum class StraightCourse { stable, unstable, not_told };

/// Whether the fitted ship keeps a straight course, for motions of the size of the recordings.
///
/// A hull that is linear in drift and yaw rate and was fitted to large motions is a mean over them: damping grows with
/// the motion, so such a ship may look stable and not be. She is never called stable from motions beyond r' = 0.25.
struct StabilityVerdict {
  StraightCourse straight_course;
  double e0;              ///< stable where positive: 1/(T1' T2')
  double standard_error;  ///< from the covariances of the sway and yaw equations
  MotionRange range;
  bool linear_hull;   ///< the fitted hull has no nonlinear term in sway and yaw
  std::string words;  ///< one sentence
};

StabilityVerdict stability_verdict(const ForceFit& fit);

// ---------------------------------------------------------------- choice of runs

/// Coefficients from some of the runs.
struct Resample {
  std::string runs;  ///< "all but zz10.csv", "zz10.csv alone", "rudder 20 deg alone"
  std::vector<std::optional<double>>
      values;  ///< of the parameters, in the order of the options; nothing where not determined
};

/// All runs, each run left out, each alone, and each rudder amplitude alone where there are several. States are those
/// of `fit`.
std::vector<Resample> resample(const Ship& ship, std::span<const Recording> runs, const ForceFit& fit,
                               const ForceFitOptions& options);

/// Largest rudder angle of a run to the whole degree [deg].
int rudder_amplitude(const Ship& ship, const Recording& run);

// ---------------------------------------------------------------- zigzags

/// Rudder and heading of the zigzag that a run says it is, and the side turned to first; nothing for other runs.
std::optional<ZigzagOrder> zigzag_order(const Recording& run);

/// Heading peaks beyond the switch angle in a recorded zigzag, as they come [rad]: each the extreme between two
/// reversals of the rudder, counted from the heading before the first order.
std::vector<double> recorded_overshoots(const Recording& run, const ZigzagOrder& order);

/// Overshoots of a ship in the zigzag of a run, from its recorded speed with its mean shaft speed or thrust [rad].
/// Nothing where the ship cannot sail it.
std::optional<std::vector<double>> simulated_overshoots(const Ship& ship, const Recording& run,
                                                        const ZigzagOrder& order, std::size_t most);

}  // namespace swayaw::identification
