#include "swayaw/mismatch/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "statistics.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/identification/map_fit.hpp"

namespace swayaw::inline mismatch {
using namespace detail;
namespace {

// ---------------------------------------------------------------- recorded motion

/// Recorded states a quarter of L/U apart, joined by straight lines.
class RecordedMotion {
 public:
  RecordedMotion(const Ship& ship, const Recording& run) {
    const double step = 0.25 * time_unit_of(ship);
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

Conditions conditions_of(const Ship& ship, const Recording& run, const RecordedMotion& motion,
                         const RecordedControls& controls) {
  Conditions conditions;
  for (const double time : run.time) {
    const auto m = motion(time);
    conditions.drift.push_back(drift_angle(m));
    conditions.yaw_rate.push_back(m.r * length(ship) / speed(m));
    conditions.rudder.push_back(controls.rudder(time));
  }
  return conditions;
}

/// For each sample whether all that tells the state was recorded shortly before and after it: within a quarter of L/U,
/// or twice the time between samples of a slow channel. In a gap the state is only guessed.
std::vector<bool> amid_samples(const Recording& run, double time_unit) {
  std::vector<bool> told(run.samples(), true);
  for (const auto channel : {Channel::psi, Channel::r, Channel::u, Channel::v, Channel::u_ground, Channel::v_ground,
                             Channel::speed_through_water, Channel::speed_over_ground, Channel::course_over_ground,
                             Channel::x, Channel::y}) {
    if (!run.has(channel)) continue;
    const Interpolant recorded(run, channel);
    const auto times = recorded.times();
    const double interval = (times.back() - times.front()) / std::max(1.0, static_cast<double>(times.size()) - 1.0),
                 near = std::max(0.25 * time_unit, 2.0 * interval);
    for (std::size_t i = 0; i < run.samples(); ++i) {
      const double now = run.time[i];
      const auto here = std::ranges::lower_bound(times, now), after = std::ranges::upper_bound(times, now);
      told[i] =
          told[i] && here != times.begin() && after != times.end() && now - here[-1] <= near && *after - now <= near;
    }
  }
  return told;
}

/// First samples of windows in which the ship makes that way, or half as much again where her state is not told; a
/// short rest joins the last window.
std::vector<std::size_t> window_starts(const Recording& run, const RecordedMotion& motion,
                                       const std::vector<bool>& told, double way) {
  constexpr double longest = 1.5;
  std::vector<std::size_t> starts{0};
  double made = 0.0;
  for (std::size_t i = 1; i < run.samples(); ++i) {
    made += speed(motion(run.time[i - 1])) * (run.time[i] - run.time[i - 1]);
    if (made < (told[i] ? way : longest * way)) continue;
    starts.push_back(i);
    made = 0.0;
  }
  if (starts.size() > 1 && made < 0.5 * way) starts.pop_back();
  return starts;
}

// ---------------------------------------------------------------- simulation

/// Simulation that takes up the recorded state at every window.
Recording restarted_replay(const Ship& ship, const Recording& run, const RecordedControls& controls,
                           const std::vector<std::size_t>& starts, const ReplayOptions& options) {
  std::vector<double> times;
  for (const auto i : starts) times.push_back(run.time[i]);
  const auto told = recorded_states(ship, run, times);
  std::vector<ReplayStart> states;
  for (std::size_t k = 0; k < starts.size(); ++k) states.push_back({starts[k], told[k]});
  auto all = replay_anew(ship, controls, states, run.time, options);
  all.name = ship.name;
  return all;
}

// ---------------------------------------------------------------- errors

/// Windows whose mean squared error most exceeds that of the run (largest sum of a contiguous part).
std::optional<WorstInterval> worst_interval(const Recording& run, std::span<const double> errors,
                                            const std::vector<std::size_t>& starts) {
  const Sums all = sums_of(errors);
  if (all.squares <= 0.0 || starts.size() < 2) return std::nullopt;
  const auto end_of = [&](std::size_t k) { return k + 1 < starts.size() ? starts[k + 1] : errors.size(); };
  std::vector<double> excess;
  for (std::size_t k = 0; k < starts.size(); ++k) {
    const Sums s = sums_of(errors.subspan(starts[k], end_of(k) - starts[k]));
    excess.push_back(s.squares - s.count * all.mean_square());
  }
  const auto worst = largest_sum(excess);
  if (!worst) return std::nullopt;
  const std::size_t begin = starts[worst->first], end = end_of(worst->last);
  const Sums inside = sums_of(errors.subspan(begin, end - begin));
  return WorstInterval{run.time[begin], run.time[std::min(end, run.samples() - 1)], inside.squares / all.squares,
                       inside.rms()};
}

/// Scatter of the samples about the parabola through their neighbours, from third differences.
/// For white noise of deviation s the third difference has deviation sqrt(20) s.
double noise_of(std::span<const double> values) {
  Sums third;
  for (std::size_t i = 3; i < values.size(); ++i)
    third.add(values[i] - 3.0 * values[i - 1] + 3.0 * values[i - 2] - values[i - 3]);
  return third.rms() / std::sqrt(20.0);
}

/// of(values) of a quantity of a run; of a position that of both its coordinates together.
template <class Of>
double of_quantity(const Recording& run, Quantity quantity, Of&& of) {
  if (quantity == Quantity::position) return std::hypot(of(run[Channel::x]), of(run[Channel::y]));
  return of(values_of(run, quantity));
}

QuantityError error_of(const Comparison& c, Quantity quantity, const WaveMotion& of_waves) {
  const auto errors = errors_of(c.restarted, c.recorded, quantity);
  const Sums sums = sums_of(errors);
  auto regions = errors_by_region(errors, c.conditions);
  const auto region = worst_region(regions);
  using Values = std::span<const double>;
  const double scatter = of_quantity(c.recorded, quantity, [](Values values) { return noise_of(values); }),
               waves = of_quantity(c.recorded, quantity, [&](Values values) { return of_waves.size_in(values); });
  return {.quantity = quantity,
          .variation = variation_of(c.recorded, quantity),
          .noise = std::max(scatter, waves),
          .waves = waves,
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
  const double time_unit = time_unit_of(ship);
  const RecordedControls controls(ship, run, options.replay);
  const RecordedMotion motion(ship, run);
  Comparison c{.recorded = run, .open_loop = {}, .restarted = {}, .window_starts = {}, .conditions = {}, .errors = {}};
  c.open_loop = replay(ship, run, options.replay);
  c.window_starts = window_starts(run, motion, amid_samples(run, time_unit),
                                  require_positive(options.window_lengths, "window [ship lengths]") * length(ship));
  c.restarted = restarted_replay(ship, run, controls, c.window_starts, options.replay);
  c.conditions = conditions_of(ship, run, motion, controls);
  const WaveMotion waves(run, time_unit);
  for (const auto quantity : all_quantities)
    if (tells(run, quantity)) c.errors.push_back(error_of(c, quantity, waves));
  return c;
}

// ---------------------------------------------------------------- all runs together

namespace {

/// Sums of squares and of errors, from their means.
struct Pool {
  double samples = 0.0;
  double squares = 0.0;
  double sum = 0.0;

  void add(double count, double rms, double bias) {
    samples += count;
    squares += count * rms * rms;
    sum += count * bias;
  }

  double rms() const { return samples > 0.0 ? std::sqrt(squares / samples) : 0.0; }
  double bias() const { return samples > 0.0 ? sum / samples : 0.0; }
};

std::vector<const QuantityError*> errors_in(const std::vector<Comparison>& comparisons, Quantity quantity,
                                            std::vector<double>& samples) {
  std::vector<const QuantityError*> errors;
  for (const auto& c : comparisons) {
    for (const auto& e : c.errors) {
      if (e.quantity != quantity) continue;
      errors.push_back(&e);
      samples.push_back(static_cast<double>(c.recorded.samples()));
    }
  }
  return errors;
}

std::vector<RegionError> pooled_regions(const std::vector<const QuantityError*>& errors) {
  std::vector<RegionError> all;
  for (const auto* e : errors) {
    for (const auto& region : e->regions) {
      const auto same = std::ranges::find_if(all, [&](const auto& r) {
        return r.variable == region.variable && r.from == region.from && r.to == region.to;
      });
      if (same == all.end()) {
        all.push_back(region);
        continue;
      }
      Pool pool;
      for (const auto& r : {*same, region}) pool.add(static_cast<double>(r.samples), r.rms, r.bias);
      *same = {region.variable, region.from, region.to, same->samples + region.samples, pool.rms(), pool.bias(), 0.0};
    }
  }
  std::ranges::sort(all, {}, [](const auto& r) { return std::pair(r.variable, r.from.value_or(-10.0)); });
  const auto squares = [](const RegionError& r) { return static_cast<double>(r.samples) * r.rms * r.rms; };
  for (auto& region : all) {
    double total = 0.0;
    for (const auto& other : all)
      if (other.variable == region.variable) total += squares(other);
    region.share = total > 0.0 ? squares(region) / total : 0.0;
  }
  return all;
}

QuantityError pooled(const std::vector<Comparison>& comparisons, Quantity quantity) {
  std::vector<double> samples;
  const auto errors = errors_in(comparisons, quantity, samples);
  Pool window, variation, noise, waves, open_loop;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    window.add(samples[i], errors[i]->window_rms, errors[i]->bias);
    variation.add(samples[i], errors[i]->variation, 0.0);
    noise.add(samples[i], errors[i]->noise, 0.0);
    waves.add(samples[i], errors[i]->waves, 0.0);
    open_loop.add(samples[i], errors[i]->open_loop_rms, 0.0);
  }
  auto regions = pooled_regions(errors);
  const auto region = worst_region(regions);
  return {.quantity = quantity,
          .variation = variation.rms(),
          .noise = noise.rms(),
          .waves = waves.rms(),
          .window_rms = window.rms(),
          .bias = window.bias(),
          .open_loop_rms = open_loop.rms(),
          .worst = {},
          .regions = std::move(regions),
          .region = region};
}

/// The run in which the window error of the quantity is largest.
std::pair<const Comparison*, const QuantityError*> worst_run(const std::vector<Comparison>& comparisons,
                                                             Quantity quantity) {
  std::pair<const Comparison*, const QuantityError*> worst{};
  for (const auto& c : comparisons)
    for (const auto& e : c.errors)
      if (e.quantity == quantity && (!worst.second || e.window_rms > worst.second->window_rms)) worst = {&c, &e};
  return worst;
}

}  // namespace

std::vector<QuantityError> pooled(const std::vector<Comparison>& comparisons) {
  std::vector<QuantityError> all;
  for (const auto quantity : all_quantities)
    if (worst_run(comparisons, quantity).first) all.push_back(pooled(comparisons, quantity));
  return all;
}

std::string verdict(const std::vector<Comparison>& comparisons) {
  auto all = pooled(comparisons);
  std::erase_if(all, [](const auto& e) { return e.quantity == Quantity::position; });
  const auto share = [](const QuantityError& e) { return e.variation > 0.0 ? e.beyond_noise() / e.variation : 0.0; };
  const auto worst = std::ranges::max_element(all, {}, share);
  if (worst == all.end()) return "The runs hold nothing to compare.";
  std::string name(name_of(worst->quantity));
  std::ranges::replace(name, '_', ' ');
  auto text = fmt::format("The model is farthest off in {}, by {:.0f} % of its variation", name, 100.0 * share(*worst));
  constexpr double mostly_bias = 0.7;  // of the error: half of its square
  if (std::abs(worst->bias) > mostly_bias * worst->window_rms)
    text += fmt::format(", and too {} nearly throughout", worst->bias > 0.0 ? "high" : "low");
  const auto [run, error] = worst_run(comparisons, worst->quantity);
  text += fmt::format("; worst in {}", run->recorded.name);
  if (error->worst) text += fmt::format(" from {:.5g} to {:.5g} s", error->worst->from, error->worst->to);
  if (error->region) text += fmt::format(", with {}", words_for(*error->region));
  return text + '.';
}

}  // namespace swayaw::mismatch
