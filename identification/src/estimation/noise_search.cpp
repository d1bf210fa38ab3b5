#include <algorithm>
#include <array>
#include <cmath>

#include "filtered_runs.hpp"
#include "swayaw/core/refusal.hpp"

/// Noise that suits a ship best, by the likelihood of grids.
namespace swayaw::inline identification {
using namespace detail;

PlanarAcceleration<double> process_noise(const Ship& ship, const Noise& noise) {
  // of sway over U²/L, a size that the scale multiplies and likelihood finds; surge and yaw, by L, beside sway, which
  // stay unless the axes are apart
  constexpr double sway = 0.002, surge = 0.3, yaw = 1.5;
  const double U = service_speed(ship), L = length(ship), a = sway * noise.scale * U * U / L;
  return {surge * a * noise.axes[0], a * noise.axes[1], yaw * a / L * noise.axes[2]};
}

double log_likelihood(const EstimationProblem& problem, const Point& point, const Noise& noise) {
  try {
    return filtered(problem, point, noise)->log_likelihood();
  } catch (const std::exception&) {
    return -HUGE_VAL;
  }
}

std::vector<std::vector<double>> log_likelihoods(const EstimationProblem& problem, const Point& point,
                                                 const Noise& noise) {
  std::vector<std::vector<double>> runs;
  const auto passes = filtered(problem, point, noise);
  for (const auto& run : passes->runs) {
    double before = 0.0;
    auto& samples = runs.emplace_back();
    for (const auto& passed : run.passed)
      samples.push_back(passed.log_likelihood - std::exchange(before, passed.log_likelihood));
  }
  return runs;
}

namespace {

/// Scales of the process noise that are tried.
constexpr std::array scales{0.1, 0.25, 0.6, 1.5, 4.0, 10.0, 25.0, 60.0, 150.0, 400.0};

/// Log likelihood that a noise of its own must gain, of an axis or a channel: three standard deviations of one number.
constexpr double worth_of_a_noise = 5.0;

/// The likeliest noise so far, with the problem that it is of.
struct NoiseSearch {
  const EstimationProblem& problem;
  const Point& point;
  Likelihood best;

  /// Climbs one number along its grid from where it is. @return whether it moved
  template <class Set>
  bool climb(int first, int last, int here, double worth, Set&& set) {
    int at = here;
    const auto better = [&](int i) {
      if (i < first || i > last) return false;
      Noise noise = best.noise;
      set(noise, i);
      const double value = log_likelihood(problem, point, noise);
      if (!(value > best.log_likelihood + worth)) return false;
      best = {value, noise};
      at = i;
      return true;
    };
    for (const int way : {-1, 1}) {
      while (better(at + way)) {}
      if (at != here) break;
    }
    return at != here;
  }

  bool climb_scale() {
    const auto nearest =
        std::ranges::min_element(scales, {}, [&](double s) { return std::abs(std::log(s / best.noise.scale)); });
    return climb(0, static_cast<int>(scales.size()) - 1, static_cast<int>(nearest - scales.begin()), 0.0,
                 [](Noise& noise, int i) { noise.scale = scales[static_cast<std::size_t>(i)]; });
  }

  /// A positive number by powers of two.
  template <class Of>
  bool climb_powers(int first, int last, Of&& of) {
    return climb(first, last, static_cast<int>(std::lround(std::log2(of(best.noise)))), worth_of_a_noise,
                 [&](Noise& noise, int i) { of(noise) = std::ldexp(1.0, i); });
  }

  /// The process noise of each axis and its memory.
  bool climb_axes() {
    bool moved = false;
    for (std::size_t k = 0; k < 3; ++k)
      moved |= climb_powers(-6, 6, [k](Noise& noise) -> double& { return noise.axes[k]; });
    return climb_powers(-5, 4, [](Noise& noise) -> double& { return noise.memory; }) || moved;
  }

  /// Noise of the channels.
  bool climb_factors(bool all) {
    bool moved = false;
    for (const auto channel : motion_channels()) {
      const auto has = [&](const PreparedRun& run) { return std::ranges::count(run.channels, channel) > 0; };
      if (std::ranges::none_of(problem.runs, has)) continue;
      const auto of = [&](Noise& noise) -> double& { return noise.factor[index_of(channel)]; };
      if (all || of(best.noise) != 1.0) moved |= climb_powers(0, 12, of);
    }
    return moved;
  }
};

}  // namespace

Likelihood best_noise(const EstimationProblem& problem, const Point& point, const Noise& start, bool every_channel) {
  NoiseSearch search{problem, point, {log_likelihood(problem, point, start), start}};
  search.climb_scale();
  for (int i = 0; i < 3 && search.climb_factors(every_channel); ++i) search.climb_scale();
  for (int i = 0; i < 3 && search.best.noise.apart && search.climb_axes(); ++i) search.climb_factors(every_channel);
  return search.best;
}

}  // namespace swayaw::identification
