#include "shortest_solution.hpp"

#include <Eigen/QR>

namespace swayaw::concealed {

Eigen::VectorXd shortest_solution(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
  return A.completeOrthogonalDecomposition().solve(b);
}

}  // namespace swayaw::concealed
