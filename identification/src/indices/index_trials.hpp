#pragma once

#include <Eigen/Core>
#include <span>
#include <variant>
#include <vector>

#include "swayaw/identification/index_tuning.hpp"

/// Measured manoeuvres sailed by a ship. Not installed.
namespace swayaw::inline identification::detail {

/// One manoeuvre as the ship sails it.
struct SimulatedTrial {
  std::variant<TurningCircle, Zigzag> run;
  Eigen::VectorXd indices;  ///< those measured [SI]; not a number for what does not exist
  double decay;  ///< of the steady turn, if one of its indices was measured, per ship length; not a number if there is
                 ///< none
};

class IndexTrials {
 public:
  explicit IndexTrials(const MeasuredIndices& measured) : measured_(measured) {}

  const std::vector<MeasuredTrial>& trials() const { return measured_.trials; }
  const SimulationCount& simulations() const { return simulations_; }

  /// How many turning circles there are.
  int turns() const;

  /// @throws as turning_circle and zigzag do
  SimulatedTrial simulate(const Ship& ship, const MeasuredTrial& trial);

  /// Derivatives of the indices by parameters of the ship.
  Eigen::MatrixXd slopes(const Ship& ship, const MeasuredTrial& trial, const SimulatedTrial& simulated,
                         std::span<const Parameter> parameters);

 private:
  ManoeuvreOptions options_for(const MeasuredTrial& trial) const;
  void count(const MeasuredTrial& trial, std::size_t times = 1);

  const MeasuredIndices& measured_;
  SimulationCount simulations_;
};

/// Whether an index of the steady turn was measured.
bool asks_for_steady_turn(const MeasuredTrial& trial);

}  // namespace swayaw::identification::detail
