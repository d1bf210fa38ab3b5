#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "swayaw/identification/measured_indices.hpp"
#include "swayaw/nonlinear/coefficients.hpp"

/// Coefficients of a ship from measured indices of her manoeuvres (docs/index_tuning.md). Source: [Kulbiej2021] section
/// 4
namespace swayaw::inline identification {

/// Manoeuvres that were sailed; one more voyage for the derivatives of a manoeuvre counts as one.
struct SimulationCount {
  int turns = 0;
  int zigzags = 0;
};

// ---------------------------------------------------------------- sensitivity

/// What the parameters of a ship do to the indices: one row for each index, one column for each number. An entry is not
/// a number where an index does not exist.
struct IndexSensitivity {
  std::vector<double> indices;                    ///< of the ship [SI], in the order of the file
  std::vector<std::vector<double>> exact;         ///< d ln index / d ln number
  std::vector<std::vector<double>> ten_per_cent;  ///< relative change of the index for 10 % more of the number
  SimulationCount simulations;
};

/// @throws Refusal  as `tune` does
IndexSensitivity index_sensitivity(const Ship& ship, const MeasuredIndices& measured,
                                   const std::vector<Parameter>& parameters);

// ---------------------------------------------------------------- what the indices determine

/// A combination of relative changes of the parameters that the indices see as one.
struct IndexCombination {
  double singular_value;        ///< of the relative Jacobian, each row over the relative tolerance of its index
  double standard_error;        ///< relative, from the indices alone: 1 over the singular value
  bool determined;              ///< to better than a half, so that its sign is known
  std::vector<double> weights;  ///< of the parameters; their squares add up to 1
};

/// Combinations from the best to the worst determined.
///
/// @param sensitivity  d ln index / d ln number
/// @param tolerance    relative standard deviation of each index
std::vector<IndexCombination> determined_combinations(const std::vector<std::vector<double>>& sensitivity,
                                                      const std::vector<double>& tolerance);

// ---------------------------------------------------------------- tuning

enum class TuningStatus {
  converged,
  simulation_limit,  ///< the parameters are the best found
  interrupted,       ///< likewise
};

std::string_view in_words(TuningStatus status);

/// Σ (1 − I/I_measured)², unweighted. Source: [Kulbiej2021] section 4.1, whose formula has lost the square that its
/// text names
struct TuningError {
  double turns;
  double zigzags;
};

struct TuningProgress {
  SimulationCount simulations;
  TuningError error;  ///< of the best ship so far
};

struct TuningOptions {
  std::vector<std::string> parameters;  ///< that may change; unless given those of the hull but for its resistance
  std::optional<double>
      prior;  ///< relative standard deviation of each number; that of the ship's [confidence] unless given
  std::optional<double> most_change;  ///< largest relative change of a number
  int most_turns = 300;               ///< turning circles to be sailed at most
  double least_decay =
      0.02;  ///< what a steady turn must keep: the slowest decay of a disturbance, per ship length of way
  std::function<bool(const TuningProgress&)>
      watch;  ///< called now and then; false ends the tuning with the best ship so far
};

/// A number that was tuned.
struct TunedParameter {
  Parameter number;  ///< as it was
  double value;      ///< as it is [SI]
  double prior;      ///< relative standard deviation before; infinity for none
  double deviation;  ///< and after
  double told;  ///< share of it, in squares, that lies in determined combinations: 1 for a number that the indices tell
  bool at_bound;  ///< held by most_change or the range of the ship file

  bool determined() const { return told >= 0.5; }
};

/// An index before and after [SI]; not a number where it does not exist.
struct TunedIndex {
  std::size_t trial;  ///< among the measured
  MeasuredIndex measured;
  double before;
  double after;
};

struct Tuning {
  TuningStatus status;
  Ship ship;
  std::vector<TunedParameter> parameters;
  std::vector<TunedIndex> indices;
  TuningError before, after;
  SimulationCount simulations;
  std::vector<IndexCombination> combinations;  ///< of the ship as she was
  std::vector<double>
      decay;  ///< of each turn after tuning, per ship length; not a number where no steady turn was asked for
};

/// Weighted least squares with a prior:
///
///     Σ ((I(theta) − I_measured)/sd)² + Σ ((theta − theta_0)/(prior theta_0))²  →  least
///
/// Gauss–Newton steps in a trust region, with exact derivatives (index_slopes.hpp). A ship who lost a manoeuvre that
/// was measured, whose steady turn is unstable or decays slower than least_decay, or in one step by nine tenths, is no
/// candidate: the region shrinks.
///
/// @throws Refusal            for a ship in wind, one who does not reach a measured index to begin with, one without
/// the parameters to change,
///                            or where a number to change is 0
/// @throws std::domain_error  if an option is not positive, or a rudder angle beyond the ship's largest
Tuning tune(const Ship& ship, const MeasuredIndices& measured, const TuningOptions& options = {});

/// The parameters that `tune` changes.
/// @throws Refusal  as `tune` does
std::vector<Parameter> tuned_parameters(const Ship& ship, const TuningOptions& options);

}  // namespace swayaw::identification
