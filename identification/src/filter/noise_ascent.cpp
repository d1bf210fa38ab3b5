#include "noise_ascent.hpp"

#include <optional>
#include <utility>

namespace swayaw::inline identification::detail {
namespace {

struct Iterate {
  Eigen::VectorXd p;
  Slope slope;
};

/// The first iterate on the way that keeps a part of the predicted gain: the whole way, half of it, …
std::optional<Iterate> climbed(const std::function<Slope(const Eigen::VectorXd&)>& at, const Iterate& from,
                               const Eigen::VectorXd& way) {
  const double predicted_gain = way.dot(from.slope.by_p);
  constexpr double least = 1.0 / 16.0;  // where less is needed, the slope is not that of the likelihood
  for (double share = 1.0; share >= least; share *= 0.5) {
    const Eigen::VectorXd p = from.p + share * way;
    if (auto slope = at(p); slope.value > from.slope.value + 1e-4 * share * predicted_gain)
      return Iterate{p, std::move(slope)};
  }
  return std::nullopt;
}

/// H⁺ = (1 − s yᵀ/yᵀs) H (1 − y sᵀ/yᵀs) + s sᵀ/yᵀs, with the step s and the loss of slope y; H stays positive.
void learn(Eigen::MatrixXd& H, const Iterate& from, const Iterate& to) {
  const Eigen::VectorXd s = to.p - from.p, y = from.slope.by_p - to.slope.by_p;
  const double ys = y.dot(s);
  if (ys <= 1e-12 * y.norm() * s.norm()) return;
  const Eigen::VectorXd Hy = H * y;
  H += (1.0 + y.dot(Hy) / ys) / ys * s * s.transpose() - (Hy * s.transpose() + s * Hy.transpose()) / ys;
}

}  // namespace

NoiseAscent climb(const std::function<Slope(const Eigen::VectorXd&)>& at, const Eigen::VectorXd& start, Slope slope,
                  const Eigen::MatrixXd& expected, const AscentOptions& options, const Eigen::MatrixXd* known) {
  Eigen::MatrixXd H = known ? *known : expected;
  Iterate here{start, std::move(slope)};
  for (int iteration = 0;; ++iteration) {
    Eigen::VectorXd way = H * here.slope.by_p;
    const double predicted_gain = 0.5 * way.dot(here.slope.by_p);
    if (predicted_gain < options.worth || iteration == options.iterations)
      return {here.p, here.slope.value, iteration, predicted_gain < options.worth, std::move(H)};
    way *= std::min(1.0, 2.0 / way.cwiseAbs().maxCoeff());  // no noise changes by more than a factor of 7 at once
    const auto next = climbed(at, here, way);
    if (!next && H == expected) return {here.p, here.slope.value, iteration, predicted_gain < 0.1, std::move(H)};
    if (!next) {
      H = expected;
      continue;
    }
    learn(H, here, *next);
    here = *next;
  }
}

}  // namespace swayaw::identification::detail
