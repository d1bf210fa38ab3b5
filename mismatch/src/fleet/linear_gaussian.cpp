#include "linear_gaussian.hpp"

#include "swayaw/core/detail/matrices.hpp"

namespace swayaw::inline mismatch::detail {

using core::detail::inverse, core::detail::log_determinant;

Told blurred(const Told& told, const Eigen::MatrixXd& L) {
  const Eigen::MatrixXd AL = told.A * L;
  Eigen::MatrixXd M = L.transpose() * AL;
  M.diagonal().array() += 1.0;
  const Eigen::MatrixXd of_n = inverse(M);
  const Eigen::VectorXd Lb = L.transpose() * told.b;
  return {told.A - AL * of_n * AL.transpose(), told.b - AL * (of_n * Lb),
          told.c + 0.5 * Lb.dot(of_n * Lb) - 0.5 * log_determinant(M)};
}

NormalLaw posterior(const Told& told, const Eigen::VectorXd& m, const Eigen::MatrixXd& L) {
  Eigen::MatrixXd M = L.transpose() * told.A * L;
  M.diagonal().array() += 1.0;
  const Eigen::MatrixXd of_n = inverse(M);
  const Eigen::VectorXd g = L.transpose() * (told.b - told.A * m), n = of_n * g;
  return {m + L * n, L * of_n * L.transpose(),
          told.c + told.b.dot(m) - 0.5 * m.dot(told.A * m) + 0.5 * g.dot(n) - 0.5 * log_determinant(M)};
}

}  // namespace swayaw::mismatch::detail
