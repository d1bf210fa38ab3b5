#include "local_fit.hpp"

#include <algorithm>
#include <cmath>

#include "../steady/small_matrices.hpp"

namespace swayaw::inline nonlinear::detail {

std::optional<ValueAndRate> local_fit(const Recording& run, Channel channel, double time, double from, double to,
                                      int degree) {
  const auto values = run[channel];
  if (values.empty()) return std::nullopt;
  const auto first = std::ranges::lower_bound(run.time, from) - run.time.begin();
  const double scale = std::max(to - from, 1e-9);
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();  // Σ p pᵀ with p = (1, τ, τ²)
  Eigen::Vector3d b = Eigen::Vector3d::Zero();  // Σ p y
  int count = 0;
  for (auto i = static_cast<std::size_t>(first); i < run.samples() && run.time[i] <= to; ++i) {
    if (std::isnan(values[i])) continue;
    const double tau = (run.time[i] - time) / scale;
    const Eigen::Vector3d p(1.0, tau, tau * tau);
    A += p * p.transpose();
    b += p * values[i];
    ++count;
  }
  if (count == 0) return std::nullopt;
  // as many as the samples carry and one less, but two are joined: the start of a run whose rudder moves at once is the
  // first of them, and not half a step further on
  const int terms = std::min(degree + 1, count == 2 ? 2 : std::max(1, count - 1));
  for (int i = terms; i < 3; ++i) {
    A.row(i).setZero();
    A.col(i).setZero();
    A(i, i) = 1.0;
    b[i] = 0.0;
  }
  const Eigen::Vector3d c = solve(A, b);
  return ValueAndRate{c[0], c[1] / scale};
}

}  // namespace swayaw::nonlinear::detail
