#include "swayaw/identification/captive.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "../forces/force_component.hpp"
#include "captive_force.hpp"
#include "swayaw/core/refusal.hpp"

namespace swayaw::inline identification {
using namespace detail;
namespace {

using Eigen::Index;

double unit_of(const Ship& ship, const CaptivePoint& point, ForceComponent component) {
  return force_unit(ship, speed(point.moments.front().motion), component);
}

bool of_kind(const CaptivePoint& point, const std::vector<std::string>& tests) {
  return tests.empty() ||
         std::ranges::any_of(tests, [&](const auto& test) { return std::ranges::count(point.tests, test) > 0; });
}

bool chosen(const CaptivePoint& point, const CaptiveSelection& s) {
  constexpr double rounding = 1e-9;
  const auto& first = point.moments.front();
  return of_kind(point, s.tests) && std::abs(drift_angle(first.motion)) <= s.max_drift + rounding &&
         std::abs(first.controls.delta) <= s.max_rudder + rounding &&
         std::abs(first.controls.delta) >= s.min_rudder - rounding && speed(first.motion) >= s.min_speed - rounding &&
         std::ranges::count(s.without_runs, point.run) == 0;
}

/// d(force)/d(coefficients) of a point, a row in primes.
Eigen::VectorXd features(const Ship& ship, const CaptivePoint& point, std::span<const Parameter> parameters,
                         ForceComponent component) {
  Eigen::VectorXd row(static_cast<Index>(parameters.size()));
  const auto derivative = [&](const auto& model) {
    for (std::size_t j = 0; j < parameters.size(); ++j) {
      const auto force = captive_force(seeded<1>(model, parameters.subspan(j, 1)), rigid_body(model), point);
      row[static_cast<Index>(j)] = component_of(force, component).v[0] / unit_of(ship, point, component);
    }
  };
  std::visit(derivative, ship.model);
  return row;
}

Ship with_zeros(const Ship& ship, std::span<const Parameter> parameters) {
  return with_values(ship, parameters, std::vector<double>(parameters.size(), 0.0));
}

/// The force is linear: at ones it is what it is at zeros and the sum of its derivatives there.
void require_linear(const Ship& at_zero, std::span<const Parameter> parameters, const CaptiveStep& step,
                    const CaptivePoint& point, const Eigen::VectorXd& row) {
  const double unit = unit_of(at_zero, point, step.component);
  const double zero = component_of(captive_force(at_zero, point), step.component) / unit;
  const auto ones = with_values(at_zero, parameters, std::vector<double>(parameters.size(), 1.0));
  const double one = component_of(captive_force(ones, point), step.component) / unit;
  if (!(std::abs(one - zero - row.sum()) <= 1e-8 * (std::abs(one) + std::abs(zero) + row.cwiseAbs().sum())))
    throw Refusal(fmt::format("{}: {} is not linear in {}", at_zero.name, in_words(step.component),
                              fmt::join(step.coefficients, ", ")));
}

/// y = measured − what the ship does without the coefficients of the step.
Design design_of(const Ship& at_zero, std::span<const CaptivePoint> points, const CaptiveStep& step,
                 std::span<const Parameter> parameters) {
  Design design{.names = step.coefficients, .X = {}, .y = {}};
  design.X.resize(static_cast<Index>(points.size()), static_cast<Index>(parameters.size()));
  design.y.resize(design.X.rows());
  Index i = 0;
  for (const auto& point : points) {
    const double known = component_of(captive_force(at_zero, point), step.component);
    design.X.row(i) = features(at_zero, point, parameters, step.component).transpose();
    design.y[i] = (component_of(point.measured, step.component) - known) / unit_of(at_zero, point, step.component);
    require_linear(at_zero, parameters, step, point, design.X.row(i++).transpose());
  }
  return design;
}

std::vector<CaptivePoint> points_of(const CaptiveStep& step, std::span<const CaptivePoint> points) {
  auto mine = selected(points, step.points);
  std::erase_if(mine,
                [&](const CaptivePoint& point) { return std::isnan(component_of(point.measured, step.component)); });
  if (mine.empty())
    throw Refusal(
        fmt::format("no {} was measured in {}", in_words(step.component), fmt::join(step.points.tests, ", ")));
  return mine;
}

void require_apart(const CaptiveStep& step, std::span<const CaptivePoint> points, const CaptiveSelection& validation) {
  if (validation.tests.empty()) return;
  for (const auto& point : points)
    if (chosen(point, validation))
      throw Refusal(fmt::format("run {} is kept for validation and may not be used for {}", point.run,
                                fmt::join(step.coefficients, ", ")));
}

std::vector<Parameter> all_found(const Ship& ship, const CaptivePlan& plan) {
  std::vector<std::string> names;
  for (const auto& step : plan.steps) names.insert(names.end(), step.coefficients.begin(), step.coefficients.end());
  return parameters_of(ship, names);
}

}  // namespace

std::string_view in_words(ForceComponent component) {
  return component == ForceComponent::X ? "X" : component == ForceComponent::Y ? "Y" : "N";
}

std::vector<CaptivePoint> selected(std::span<const CaptivePoint> points, const CaptiveSelection& selection) {
  std::vector<CaptivePoint> result;
  std::ranges::copy_if(points, std::back_inserter(result), [&](const auto& point) { return chosen(point, selection); });
  return result;
}

PlanarForce<double> captive_force(const Ship& ship, const CaptivePoint& point) {
  return std::visit([&](const auto& model) { return captive_force(model, rigid_body(model), point); }, ship.model);
}

PlanarForce<double> CaptiveError::relative() const {
  return {rms.X / measured.X, rms.Y / measured.Y, rms.N / measured.N};
}

CaptiveError captive_error(const Ship& ship, std::span<const CaptivePoint> points, const CaptiveSelection& selection) {
  const auto mine = selected(points, selection);
  CaptiveError error{.points = mine.size(), .rms = {}, .measured = {}};
  for (const auto component : force_components) {
    double squares = 0.0, of_measured = 0.0;
    std::size_t count = 0;
    for (const auto& point : mine) {
      const double unit = unit_of(ship, point, component), y = component_of(point.measured, component) / unit;
      if (std::isnan(y)) continue;
      const double e = component_of(captive_force(ship, point), component) / unit - y;
      squares += e * e;
      of_measured += y * y;
      ++count;
    }
    component_of(error.rms, component) = std::sqrt(squares / static_cast<double>(count));
    component_of(error.measured, component) = std::sqrt(of_measured / static_cast<double>(count));
  }
  return error;
}

PlanarForce<double> captive_error(const Ship& ship, std::span<const CaptivePoint> points, double max_drift) {
  return captive_error(ship, points, {.tests = {"static_drift"}, .max_drift = max_drift, .max_rudder = 0.0}).relative();
}

CaptiveFit fit_captive(const Ship& ship, std::span<const CaptivePoint> points, const CaptivePlan& plan,
                       const RegressionOptions& options) {
  CaptiveFit result{.ship = with_zeros(ship, all_found(ship, plan)), .steps = {}, .validation = {}};
  for (const auto& step : plan.steps) {
    const auto parameters = parameters_of(result.ship, step.coefficients);
    const auto mine = points_of(step, points);
    require_apart(step, mine, plan.validation);
    const auto fit = regress(design_of(with_zeros(result.ship, parameters), mine, step, parameters), options);
    std::vector<double> values;
    for (const auto& c : fit.coefficients) values.push_back(std::isfinite(c.estimate.value) ? c.estimate.value : 0.0);
    result.ship = with_values(result.ship, parameters, values);
    result.validation = captive_error(result.ship, points, plan.validation);
    result.steps.push_back({step, mine.size(), fit, result.validation});
  }
  return result;
}

}  // namespace swayaw::identification
