#pragma once

#include <Eigen/Core>

/// Products of the columns of a matrix. Not installed.
namespace swayaw::inline identification::detail {

/// [X y]ᵀ [X y], with the widest packs of this processor.
Eigen::MatrixXd gram_of(const Eigen::MatrixXd& X, const Eigen::VectorXd& y);

}  // namespace swayaw::identification::detail
