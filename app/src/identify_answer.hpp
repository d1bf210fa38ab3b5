#pragma once

#include <optional>
#include <string>
#include <vector>

#include "run_selection.hpp"
#include "swayaw/core/parameter.hpp"
#include "swayaw/core/recording.hpp"
#include "swayaw/identification/identify.hpp"
#include "swayaw/identification/trajectory_fit.hpp"
#include "swayaw/mismatch/quantity.hpp"

/// What `swayaw identify` was asked and what it answers, for text, JSON and page.
namespace swayaw::app {

struct Question {
  Ship ship;
  std::vector<Recording> runs;
  std::vector<Recording> holdout;
  ForceFitOptions options;
  std::vector<SetAside> aside{};
};

/// A coefficient as it is written to the file.
struct Found {
  Parameter before;
  Estimate estimate;
  double low, high;
  std::optional<double> variance_inflation;
  bool undetermined;
};

struct ZigzagCheck {
  std::string run;
  std::vector<double> recorded;
  std::optional<std::vector<double>> before, after;
};

struct Answer {
  Ship ship;  ///< as written
  ForceFit forces;
  std::optional<TrajectoryFit> trajectories;
  bool from_trajectories = false;
  bool lacks_something = false;  ///< on trajectories the residuals are not noise: the model is not the ship
  std::string reason;            ///< why these
  std::vector<Found> found;
  StabilityVerdict stability;
  std::vector<Resample> resamples;
  std::vector<ZigzagCheck> zigzags;
  std::vector<std::string> advice;
  std::vector<std::string> troubles{};  ///< late steps that failed, in words; the rest is as found
  std::string failed{};  ///< why what was asked for was not done though other things were; empty if it was
};

// ---------------------------------------------------------------- errors of replays

/// Error of a quantity over windows of two ship lengths, over its variation.
struct ErrorShare {
  Quantity quantity;
  double share;
};

/// How a run is predicted; nothing where the ship cannot sail it.
struct Prediction {
  std::string run;
  std::optional<std::vector<ErrorShare>> before, after;
};

/// Root mean square, over runs and their quantities, of the errors over the variation.
struct PredictionErrors {
  double before, after;
  std::vector<std::string> lost;  ///< runs that the ship sailed before and does not now

  bool worse() const { return after > before || !lost.empty(); }
};

/// @return nothing where there is no run, or none could be sailed before
std::optional<PredictionErrors> together(const std::vector<Prediction>& predictions);

struct Predictions {
  std::vector<Prediction> train, holdout;
};

}  // namespace swayaw::app
