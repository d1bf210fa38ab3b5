#pragma once

#include <Eigen/Core>
#include <span>
#include <variant>
#include <vector>

#include "swayaw/identification/index_tuning.hpp"

/// Measured manoeuvres sailed by a ship. Not installed.
namespace swayaw {

/// One manoeuvre as the ship sails it.
struct SailedTrial {
  std::variant<TurningCircle, Zigzag> run;
  Eigen::VectorXd indices;  ///< those measured [SI]; not a number for what does not exist
  double decay;  ///< of the steady turn, if one of its indices was measured, per ship length; not a number if there is
                 ///< none
};

class IndexTrials {
 public:
  explicit IndexTrials(const MeasuredIndices& measured) : measured_(measured) {}

  const std::vector<MeasuredTrial>& trials() const { return measured_.trials; }
  const VoyageCount& voyages() const { return voyages_; }

  /// How many turning circles there are.
  int turns() const;

  /// @throws as turning_circle and zigzag do
  SailedTrial sail(const Ship& ship, const MeasuredTrial& trial);

  /// Derivatives of the indices by numbers of the ship.
  Eigen::MatrixXd slopes(const Ship& ship, const MeasuredTrial& trial, const SailedTrial& sailed,
                         std::span<const Parameter> numbers);

 private:
  ManoeuvreOptions options_for(const MeasuredTrial& trial) const;
  void count(const MeasuredTrial& trial, std::size_t times = 1);

  const MeasuredIndices& measured_;
  VoyageCount voyages_;
};

/// Whether an index of the steady turn was measured.
bool asks_for_steady_turn(const MeasuredTrial& trial);

}  // namespace swayaw
