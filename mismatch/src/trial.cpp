#include "trial.hpp"

#include <algorithm>
#include <cmath>

#include "swayaw/core/refusal.hpp"

namespace swayaw::inline mismatch::detail {

Trial trial_of(const Ship& ship, std::span<const Recording> runs, std::span<const Channel> channels) {
  Trial trial{
      .ship = ship, .parameters = {}, .lift_loss = ordinary_lift_loss(ship), .mean = {}, .precision = {}, .runs = {}};
  for (const auto& n : parameters_of(ship))
    if (n.role == Role::coefficient && n.deviation > 0.0) trial.parameters.push_back(n);
  const auto size = trial.baseline_size();
  trial.mean = Eigen::VectorXd::Zero(size);
  trial.precision = Eigen::MatrixXd::Identity(size, size);
  if (trial.lift_loss)
    trial.precision(size - 1, size - 1) = 1.0 / std::pow(trial.lift_loss->coordinates.front().deviation, 2);
  trial.runs = prepared_runs(ship, runs, channels);
  return trial;
}

Trial with_inflated_prior(Trial trial, double factor) {
  trial.precision /= factor * factor;
  return trial;
}

// ---------------------------------------------------------------- unknowns

namespace {

bool takes_lift(const EffectForm* form) { return takes_rudder_lift(form->id); }

/// A coefficient of the baseline, in its deviations from the value of the ship file, kept to its range.
Unknown unknown_of(const Parameter& p, double mean) {
  constexpr double clear = 1e-3;  // deviations from an end that is itself refused
  const auto in_deviations = [&](double value) { return (value - p.value) / p.deviation; };
  return {.name = p.name,
          .mean = mean,
          .low = in_deviations(p.range.low) + (p.range.above_low ? clear : 0.0),
          .high = in_deviations(p.range.high)};
}

/// Its value at a coordinate, rounding kept out of what is refused.
double value_at(const Parameter& p, double c) {
  return std::clamp(p.value + p.deviation * c, p.range.low, p.range.high);
}

Unknown unknown_of(const Coordinate& c) {
  return {.name = c.name, .mean = c.centre, .low = c.low, .high = c.high, .step = c.step};
}

}  // namespace

EstimationProblem problem_of(const Trial& trial, const Hypothesis& hypothesis) {
  const auto base = trial.baseline_size();
  std::vector<Unknown> unknowns;
  for (std::size_t i = 0; i < trial.parameters.size(); ++i)
    unknowns.push_back(unknown_of(trial.parameters[i], trial.mean[static_cast<Eigen::Index>(i)]));
  if (trial.lift_loss) unknowns.push_back({.name = "lift loss", .mean = trial.mean[base - 1], .low = 0.0});
  std::vector<double> deviations;
  for (const auto* form : hypothesis)
    for (const auto& c : form->coordinates) unknowns.push_back(unknown_of(c)), deviations.push_back(c.deviation);
  const auto size = std::ssize(unknowns);
  Eigen::MatrixXd precision = Eigen::MatrixXd::Zero(size, size);
  precision.topLeftCorner(base, base) = trial.precision;
  for (std::size_t i = 0; i < deviations.size(); ++i) {
    const auto k = base + static_cast<Eigen::Index>(i);
    precision(k, k) = 1.0 / (deviations[i] * deviations[i]);
  }
  return {
      .unknowns = std::move(unknowns),
      .precision = std::move(precision),
      .runs = trial.runs,
      .ship_in = [&trial, hypothesis](const Point& point, std::size_t) { return ship_at(trial, hypothesis, point); },
      .scale = trial.ship};
}

EstimationProblem problem_of(const Trial& trial, const Ship& ship) {
  return {.unknowns = {},
          .precision = {},
          .runs = trial.runs,
          .ship_in = [ship](const Point&, std::size_t) { return ship; },
          .scale = trial.ship};
}

Ship ship_at(const Trial& trial, const Hypothesis& hypothesis, const Point& point) {
  std::vector<double> values;
  for (std::size_t i = 0; i < trial.parameters.size(); ++i)
    values.push_back(value_at(trial.parameters[i], point[static_cast<Eigen::Index>(i)]));
  Ship ship = with_values(trial.ship, trial.parameters, values);
  Eigen::Index next = trial.baseline_size();
  if (trial.lift_loss && std::ranges::none_of(hypothesis, takes_lift)) {
    const double loss = std::max(0.0, point[next - 1]);
    ship.effects.push_back(trial.lift_loss->at({&loss, 1}));
  }
  for (const auto* form : hypothesis) {
    const auto size = form->coordinates.size();
    ship.effects.push_back(form->at({point.data() + next, size}));
    next += static_cast<Eigen::Index>(size);
  }
  return ship;
}

Point with_start(const Point& before, std::span<const double> last_start) {
  Point point(before.size() + std::ssize(last_start));
  point << before, Eigen::Map<const Eigen::VectorXd>(last_start.data(), std::ssize(last_start));
  return point;
}

// ---------------------------------------------------------------- estimation

MapFit fit(const Trial& trial, const Hypothesis& hypothesis, const Point& start, const Noise& noise,
           const Eigen::MatrixXd* known, int rounds) {
  return fit(problem_of(trial, hypothesis), start, noise, trial.baseline_size(), known, rounds);
}

LinearizedFit linearized(const Trial& trial, const Hypothesis& accepted, const MapFit& fit) {
  return linearized(problem_of(trial, accepted), fit);
}

PredictedGain predicted_gain(const Trial& trial, const Hypothesis& accepted, const LinearizedFit& before,
                             const EffectForm& form, std::span<const double> start, int iterations) {
  Hypothesis hypothesis = accepted;
  hypothesis.push_back(&form);
  return predicted_gain(problem_of(trial, hypothesis), before, start, iterations);
}

Eigen::MatrixXd information(const Trial& trial, const LinearizedFit& baseline, const EffectForm& form) {
  constexpr double step = 0.1;  // of coordinates whose usual size is 1
  std::vector<double> null;
  for (const auto& c : form.coordinates) null.push_back(c.centre);
  const auto J = further_slopes(problem_of(trial, {&form}), baseline, null, step);
  return J.transpose() * baseline.projected(J);
}

}  // namespace swayaw::mismatch::detail
