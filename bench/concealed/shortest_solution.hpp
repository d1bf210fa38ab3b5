#pragma once

#include <Eigen/Core>

namespace swayaw::concealed {

/// Of all x that bring A x nearest to b.
Eigen::VectorXd shortest_solution(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

}  // namespace swayaw::concealed
