#pragma once

#include <vector>

#include "trial.hpp"

/// Effects that give parameters of a model other values, on a ship whose own are not those of her file. Not installed.
namespace swayaw::inline mismatch::detail {

/// Whether an effect gives parameters of the model other values that count from the ship's own. Linear derivatives of
/// the hull count from her file, which knows them well: what reference runs move them by belongs to these manoeuvres,
/// and in three of 163 ships as on board (seed 54) in which they were not hidden other runs moved them back.
bool counts_from_own(const Effect& effect);

/// An effect of a form, in which other values are those of the ship file and a change, as it is beside a ship whose own
/// are others: they and the change, within their ranges. So it does nothing where its coordinates are zero, whatever
/// was found of her, or told by reference runs.
/// @param bare  the ship without effects
Effect effect_beside(const Trial& trial, Effect effect, const Ship& bare);

/// The ship's own values of the parameters of an effect, from which it counts those that it gives; the others are zero.
struct OwnValues {
  Eigen::VectorXd off;              ///< from those of the ship file
  std::vector<Eigen::Index> moved;  ///< coordinates of the baseline that move them
  Eigen::MatrixXd slopes;           ///< d(own values)/d(those)
};

OwnValues own_values(const Trial& trial, const Effect& effect, const Point& point);

}  // namespace swayaw::mismatch::detail
