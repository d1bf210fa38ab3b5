#include "swayaw/mismatch/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "statistics.hpp"
#include "swayaw/core/refusal.hpp"

namespace swayaw {
namespace {

// ---------------------------------------------------------------- recorded motion

/// Recorded states a quarter of L/U apart, joined by straight lines.
class RecordedMotion {
 public:
  RecordedMotion(const Ship& ship, const Recording& run) {
    const double step = 0.25 * length(ship) / service_speed(ship);
    const double begin = run.time.front(), end = run.time.back();
    const auto count = static_cast<std::size_t>(std::ceil((end - begin) / step)) + 1;
    for (std::size_t i = 0; i < count; ++i) {
      times_.push_back(std::min(end, begin + static_cast<double>(i) * step));
      motions_.push_back(recorded_state(ship, run, times_.back()).motion);
    }
  }

  PlanarMotion<double> operator()(double time) const {
    const auto after = std::ranges::upper_bound(times_, time) - times_.begin();
    const auto k = std::clamp<std::ptrdiff_t>(after, 1, std::ssize(times_) - 1);
    const auto &a = motions_[static_cast<std::size_t>(k - 1)], &b = motions_[static_cast<std::size_t>(k)];
    const double t0 = times_[static_cast<std::size_t>(k - 1)], t1 = times_[static_cast<std::size_t>(k)];
    const double s = t1 > t0 ? (time - t0) / (t1 - t0) : 0.0;
    return {a.u + s * (b.u - a.u), a.v + s * (b.v - a.v), a.r + s * (b.r - a.r)};
  }

 private:
  std::vector<double> times_;
  std::vector<PlanarMotion<double>> motions_;
};

Conditions conditions_of(const Ship& ship, const Recording& run, const RecordedMotion& motion, const RecordedControls& controls) {
  Conditions conditions;
  for (const double time : run.time) {
    const auto m = motion(time);
    conditions.drift.push_back(drift_angle(m));
    conditions.yaw_rate.push_back(m.r * length(ship) / speed(m));
    conditions.rudder.push_back(controls.rudder(time));
  }
  return conditions;
}

/// First samples of windows in which the ship makes that way; a short rest joins the last window.
std::vector<std::size_t> window_starts(const Recording& run, const RecordedMotion& motion, double way) {
  std::vector<std::size_t> starts{0};
  double made = 0.0;
  for (std::size_t i = 1; i < run.samples(); ++i) {
    made += speed(motion(run.time[i - 1])) * (run.time[i] - run.time[i - 1]);
    if (made < way) continue;
    starts.push_back(i);
    made = 0.0;
  }
  if (starts.size() > 1 && made < 0.5 * way) starts.pop_back();
  return starts;
}

// ---------------------------------------------------------------- simulation

void append(Recording& to, const Recording& from) {
  to.time.insert(to.time.end(), from.time.begin(), from.time.end());
  for (std::size_t c = 0; c < channel_count; ++c)
    to.channels[c].insert(to.channels[c].end(), from.channels[c].begin(), from.channels[c].end());
}

/// Simulation that takes up the recorded state at every window.
Recording restarted_replay(const Ship& ship, const Recording& run, const RecordedControls& controls,
                           const std::vector<std::size_t>& starts, const ReplayOptions& options) {
  Recording all;
  all.name = ship.name;
  const std::span<const double> times(run.time);
  for (std::size_t k = 0; k < starts.size(); ++k) {
    const std::size_t end = k + 1 < starts.size() ? starts[k + 1] : times.size();
    const auto window = times.subspan(starts[k], end - starts[k]);
    append(all, replay_from(ship, controls, recorded_state(ship, run, window.front()), window, options));
  }
  return all;
}

// ---------------------------------------------------------------- errors

/// Windows whose mean squared error most exceeds that of the run (largest sum of a contiguous part).
std::optional<WorstInterval> worst_interval(const Recording& run, std::span<const double> errors, const std::vector<std::size_t>& starts) {
  const Sums all = sums_of(errors);
  if (all.squares <= 0.0 || starts.size() < 2) return std::nullopt;
  const auto window = [&](std::size_t k) {
    const std::size_t end = k + 1 < starts.size() ? starts[k + 1] : errors.size();
    return sums_of(errors.subspan(starts[k], end - starts[k]));
  };
  double best = 0.0, excess = 0.0;
  std::size_t first = 0, best_first = 0, best_last = 0;
  for (std::size_t k = 0; k < starts.size(); ++k) {
    if (excess <= 0.0) {
      excess = 0.0;
      first = k;
    }
    const Sums s = window(k);
    excess += s.squares - s.count * all.mean_square();
    if (excess <= best) continue;
    best = excess;
    best_first = first;
    best_last = k;
  }
  if (best <= 0.0) return std::nullopt;
  const std::size_t end = best_last + 1 < starts.size() ? starts[best_last + 1] : errors.size();
  const Sums inside = sums_of(errors.subspan(starts[best_first], end - starts[best_first]));
  return WorstInterval{run.time[starts[best_first]], run.time[std::min(end, run.samples() - 1)], inside.squares / all.squares, inside.rms()};
}

/// Scatter of the samples about the parabola through their neighbours, from third differences.
/// For white noise of deviation s the third difference has deviation sqrt(20) s.
double noise_of(std::span<const double> values) {
  Sums third;
  for (std::size_t i = 3; i < values.size(); ++i) third.add(values[i] - 3.0 * values[i - 1] + 3.0 * values[i - 2] - values[i - 3]);
  return third.rms() / std::sqrt(20.0);
}

double noise_of(const Recording& run, Quantity quantity) {
  if (quantity == Quantity::position) return std::hypot(noise_of(run[Channel::x]), noise_of(run[Channel::y]));
  return noise_of(values_of(run, quantity));
}

QuantityError error_of(const Comparison& c, Quantity quantity) {
  const auto errors = errors_of(c.restarted, c.recorded, quantity);
  const Sums sums = sums_of(errors);
  auto regions = errors_by_region(errors, c.conditions);
  const auto region = worst_region(regions);
  return {.quantity = quantity,
          .variation = variation_of(c.recorded, quantity),
          .noise = noise_of(c.recorded, quantity),
          .window_rms = sums.rms(),
          .bias = sums.mean(),
          .open_loop_rms = sums_of(errors_of(c.open_loop, c.recorded, quantity)).rms(),
          .worst = worst_interval(c.recorded, errors, c.window_starts),
          .regions = std::move(regions),
          .region = region};
}

}  // namespace

Comparison compare(const Ship& ship, const Recording& run, const CompareOptions& options) {
  if (run.samples() < 3) throw Refusal(fmt::format("{}: {} samples are too few to compare", run.name, run.samples()));
  const RecordedControls controls(ship, run, options.replay);
  const RecordedMotion motion(ship, run);
  Comparison c{.recorded = run, .open_loop = {}, .restarted = {}, .window_starts = {}, .conditions = {}, .errors = {}};
  c.open_loop = replay(ship, run, options.replay);
  c.window_starts = window_starts(run, motion, require_positive(options.window_lengths, "window [ship lengths]") * length(ship));
  c.restarted = restarted_replay(ship, run, controls, c.window_starts, options.replay);
  c.conditions = conditions_of(ship, run, motion, controls);
  for (const auto quantity : all_quantities)
    if (tells(run, quantity)) c.errors.push_back(error_of(c, quantity));
  return c;
}

std::string verdict(const std::vector<Comparison>& comparisons) {
  const Comparison* where = nullptr;
  const QuantityError* worst = nullptr;
  for (const auto& c : comparisons) {
    for (const auto& e : c.errors) {
      if (e.quantity == Quantity::position) continue;  // its variation is the length of the run
      if (worst && e.normalised() <= worst->normalised()) continue;
      where = &c;
      worst = &e;
    }
  }
  if (!worst) return "The runs hold nothing to compare.";
  std::string name(name_of(worst->quantity));
  std::ranges::replace(name, '_', ' ');
  auto text = fmt::format("The model is farthest off in {}: {:.0f} % of its variation in {}", name, 100.0 * worst->normalised(), where->recorded.name);
  if (worst->worst) text += fmt::format(", most of it from {:.6g} to {:.6g} s", worst->worst->from, worst->worst->to);
  if (worst->region) text += fmt::format(", largest at {}", words_for(*worst->region));
  return text + '.';
}

}  // namespace swayaw
