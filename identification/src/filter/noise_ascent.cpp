#include "noise_ascent.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace swayaw::inline identification::detail {
namespace {

struct Iterate {
  Eigen::VectorXd p;
  Slope slope;
};

/// H⁺ = (1 − s yᵀ/yᵀs) H (1 − y sᵀ/yᵀs) + s sᵀ/yᵀs, with the step s and the loss of slope y; H stays positive.
void learn(Eigen::MatrixXd& H, const Iterate& from, const Iterate& to) {
  const Eigen::VectorXd s = to.p - from.p, y = from.slope.by_p - to.slope.by_p;
  const double ys = y.dot(s);
  if (ys <= 1e-12 * y.norm() * s.norm()) return;
  const Eigen::VectorXd Hy = H * y;
  H += (1.0 + y.dot(Hy) / ys) / ys * s * s.transpose() - (Hy * s.transpose() + s * Hy.transpose()) / ys;
}

/// A step that is likely worth while: H times the slope; no noise changes by more than a factor of 7 at once.
Eigen::VectorXd way_from(const Eigen::MatrixXd& H, const Slope& slope) {
  Eigen::VectorXd way = H * slope.by_p;
  return way * std::min(1.0, 2.0 / way.cwiseAbs().maxCoeff());
}

/// The first iterate that gains a part of what is predicted. Where a step leads down, the slope at its end corrects H,
/// and the next is shorter, as long as it is worth while.
std::optional<Iterate> climbed(const std::function<Slope(const Eigen::VectorXd&)>& at, const Iterate& from,
                               Eigen::MatrixXd& H, double worth) {
  Eigen::VectorXd way = way_from(H, from.slope);
  while (0.5 * way.dot(from.slope.by_p) >= worth) {
    const Eigen::VectorXd p = from.p + way;
    Iterate there{p, at(p)};
    if (std::isfinite(there.slope.value)) learn(H, from, there);
    if (there.slope.value > from.slope.value + 1e-4 * way.dot(from.slope.by_p)) return there;
    const double size = way.norm();
    way = way_from(H, from.slope);
    way *= std::min(1.0, 0.5 * size / way.norm());
  }
  return std::nullopt;  // the slope is not that of the likelihood
}

}  // namespace

NoiseAscent climb(const std::function<Slope(const Eigen::VectorXd&)>& at, const Eigen::VectorXd& start, Slope slope,
                  const Eigen::MatrixXd& expected, const AscentOptions& options, const Eigen::MatrixXd* known) {
  Eigen::MatrixXd H = known ? *known : expected;
  Iterate here{start, std::move(slope)};
  for (int iteration = 0;; ++iteration) {
    const double predicted_gain = 0.5 * here.slope.by_p.dot(H * here.slope.by_p);
    if (predicted_gain < options.worth || iteration == options.iterations)
      return {here.p, here.slope.value, iteration, predicted_gain < options.worth, std::move(H)};
    auto next = climbed(at, here, H, options.worth);
    if (!next) return {here.p, here.slope.value, iteration, predicted_gain < 0.1, std::move(H)};
    here = *std::move(next);
  }
}

}  // namespace swayaw::identification::detail
