#include <algorithm>
#include <cmath>

#include "swayaw/core/angle.hpp"
#include "trial_run.hpp"

namespace swayaw::inline identification::detail {
namespace {

// A rudder within this of its mean is held; steps that take less than this share of the run are ramps.
constexpr double held_within = radians(0.7), shortest_share = 0.02;

SpiralStep step_of(const TrialRun& run, double sum, std::size_t first, std::size_t last) {
  const double from = run.delta.time[first], to = run.delta.time[last - 1], middle = 0.5 * (from + to);
  SpiralStep step{
      .delta = sum / static_cast<double>(last - first), .from = from, .to = to, .yaw_rate = {missing, missing}};
  const double quarter = 0.5 * (to - middle);
  const auto late = line_over(run.psi, middle, to), third = line_over(run.psi, middle, middle + quarter),
             fourth = line_over(run.psi, middle + quarter, to);
  if (!late) return step;
  // what still changes from the third quarter to the fourth counts
  const double unsettled = third && fourth ? fourth->slope.value - third->slope.value : 0.0;
  step.yaw_rate = {late->slope.value, together(late->slope.standard_error, unsettled)};
  return step;
}

/// Times with the rudder held, in steps of a spiral.
std::vector<SpiralStep> held_steps(const TrialRun& run) {
  const auto& d = run.delta;
  const double shortest = shortest_share * (d.time.back() - d.time.front()),
               slack = std::max(held_within, 4.0 * d.noise.deviation);
  std::vector<SpiralStep> steps;
  for (std::size_t first = 0; first < d.size();) {
    double sum = d.value[first];
    std::size_t last = first + 1;
    while (last < d.size() && std::abs(d.value[last] - sum / static_cast<double>(last - first)) <= slack)
      sum += d.value[last++];
    if (last - first >= 10 && d.time[last - 1] - d.time[first] >= shortest)
      steps.push_back(step_of(run, sum, first, last));
    first = last;
  }
  std::erase_if(steps, [](const SpiralStep& s) { return std::isnan(s.yaw_rate.value); });
  return steps;
}

}  // namespace

SpiralTrial spiral_trial(const TrialRun& run) {
  SpiralTrial result{.steps = held_steps(run), .loop_width = {}, .loop_height = {}};
  double least = missing, most = missing;
  for (std::size_t i = 0; i < result.steps.size(); ++i) {
    for (std::size_t k = i + 2; k < result.steps.size(); ++k) {
      const auto &a = result.steps[i], &b = result.steps[k];
      const Told apart{std::abs(a.yaw_rate.value - b.yaw_rate.value),
                       together(a.yaw_rate.standard_error, b.yaw_rate.standard_error)};
      if (std::abs(a.delta - b.delta) > 2.0 * held_within || apart.value < 3.0 * apart.standard_error) continue;
      const double delta = 0.5 * (a.delta + b.delta);
      least = std::fmin(least, delta);
      most = std::fmax(most, delta);
      if (!result.loop_height || apart.value > result.loop_height->value) result.loop_height = apart;
    }
  }
  if (result.loop_height) result.loop_width = most - least;
  return result;
}

SteadyTrial steady_trial(const TrialRun& run) {
  const double from = run.psi.time.front(), to = run.end();
  const auto& recording = *run.recording;
  const auto mean = [&](const Samples& s) -> MaybeTold {
    if (const auto line = line_over(s, from, to)) return line->value;
    return std::nullopt;
  };
  SteadyTrial result{.helm = *mean(run.delta),
                     .yaw_rate = line_over(run.psi, from, to)->slope,
                     .speed = mean(run.speed),
                     .drift = {},
                     .leeway = {}};
  result.drift = mean(drift_samples(recording));
  if (!run.has_track()) return result;
  const auto x = line_over(run.x, from, to), y = line_over(run.y, from, to);
  const auto heading = mean(run.psi);
  if (!x || !y || !heading) return result;
  const double V = std::hypot(x->slope.value, y->slope.value);
  if (V > 0.0)
    result.leeway =
        Told{wrapped(std::atan2(y->slope.value, x->slope.value) - heading->value),
             together(heading->standard_error, std::max(x->slope.standard_error, y->slope.standard_error) / V)};
  return result;
}

}  // namespace swayaw::identification::detail
