#include "other_values.hpp"

#include <algorithm>
#include <cmath>

namespace swayaw::inline mismatch::detail {
namespace {

/// What the parameters of an effect are of the ship's own; zero where the effect leaves them so.
Eigen::VectorXd own_of(const Ship& bare, const Effect& effect) {
  const auto parameters = parameters_of(bare, effect);
  Eigen::VectorXd own = Eigen::VectorXd::Zero(std::ssize(parameters));
  for (std::size_t i = 0; i < parameters.size(); ++i)
    if (!std::isnan(parameter_value(effect, parameters[i].index)))
      own[static_cast<Eigen::Index>(i)] = parameters[i].null;
  return own;
}

/// Zero where both are the same infinity.
Eigen::VectorXd difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return (a.array() == b.array()).select(0.0, a - b);
}

}  // namespace

bool counts_from_own(const Effect& effect) {
  if (std::holds_alternative<HullLinearDerivatives<>>(effect)) return false;
  bool gives = false;
  for_each_parameter(effect, [&](const auto& p, double) { gives = gives || std::isnan(p.null); });
  return gives;
}

Effect effect_beside(const Trial& trial, Effect effect, const Ship& bare) {
  if (!counts_from_own(effect)) return effect;
  const auto given = parameters_of(trial.ship, effect), now = parameters_of(bare, effect);
  for (std::size_t i = 0; i < given.size(); ++i)
    if (double& value = parameter_value(effect, given[i].index); !std::isnan(value))
      value = std::clamp(value + now[i].null - given[i].null, given[i].range.low, given[i].range.high);
  return effect;
}

OwnValues own_values(const Trial& trial, const Effect& effect, const Point& point) {
  const auto given = own_of(trial.ship, effect);
  OwnValues own{.off = Eigen::VectorXd::Zero(given.size()), .moved = {}, .slopes = {given.size(), 0}};
  if (!counts_from_own(effect)) return own;
  const auto at = own_of(bare_ship_at(trial, point), effect);
  own.off = difference(at, given);
  for (Eigen::Index i = 0; i < std::ssize(trial.parameters); ++i) {
    constexpr double step = 0.01;  // deviations; values are linear in them
    Point other = point;
    other[i] += step;
    const Eigen::VectorXd slope = difference(own_of(bare_ship_at(trial, other), effect), at) / step;
    if (!(slope.cwiseAbs().maxCoeff() > 0.0)) continue;
    own.moved.push_back(i);
    own.slopes.conservativeResize(Eigen::NoChange, own.slopes.cols() + 1);
    own.slopes.rightCols(1) = slope;
  }
  return own;
}

}  // namespace swayaw::mismatch::detail
