#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "../filter/noise_ascent.hpp"
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

double position_walk(const Ship& ship, const Noise& noise) {
  const double L = length(ship);
  return std::pow(noise.walk * L, 2) * service_speed(ship) / L;
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
  for (const auto& run : passes->runs) runs.push_back(run.log_likelihoods());
  return runs;
}

namespace {

/// Scales of the process noise that are tried.
constexpr std::array scales{0.1, 0.25, 0.6, 1.5, 4.0, 10.0, 25.0, 60.0, 150.0, 400.0};

/// Log likelihood that a noise of its own must gain, of an axis or a channel: three standard deviations of one number.
constexpr double worth_of_a_noise = 5.0;

/// Channels of motion that some run of a problem has.
std::vector<Channel> compared_channels(const EstimationProblem& problem) {
  std::vector<Channel> channels;
  std::ranges::copy_if(motion_channels(), std::back_inserter(channels), [&](Channel channel) {
    return std::ranges::any_of(problem.runs,
                               [&](const PreparedRun& run) { return std::ranges::count(run.channels, channel) > 0; });
  });
  return channels;
}

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
    for (const auto channel : compared_channels(problem)) {
      const auto of = [&](Noise& noise) -> double& { return noise.factor[index_of(channel)]; };
      if (all || of(best.noise) != 1.0) moved |= climb_powers(0, 12, of);
    }
    return moved;
  }
};

// ---------------------------------------------------------------- real instruments

/// Sizes of all noises as logarithms, each with a normal prior about what is usual: a factor of e² either way for
/// instruments, of 2 for the process noise, without which a ship whose sway no channel shows is tied to nothing.
class NoiseSizes {
 public:
  NoiseSizes(const EstimationProblem& problem, const Noise& start) : start_(start) {
    for (int i = 0; i < 3; ++i) sizes_.push_back({place_of_process_noise(i), ordinary, std::log(2.0)});
    const auto channels = compared_channels(problem);
    for (const auto channel : channels) sizes_.push_back({place_of(channel), 1.0, wide});
    if (std::ranges::count(channels, Channel::x) > 0) sizes_.push_back({place_of_walk, usual_walk, wide});
  }

  Eigen::VectorXd point() const {
    Eigen::VectorXd p(std::ssize(sizes_));
    Noise noise = start_;
    for (std::size_t i = 0; i < sizes_.size(); ++i)
      p[static_cast<Eigen::Index>(i)] = std::log(std::max(of(noise, sizes_[i].place), 1e-6 * sizes_[i].usual));
    return p;
  }

  Noise noise(const Eigen::VectorXd& p) const {
    Noise noise = start_;
    for (std::size_t i = 0; i < sizes_.size(); ++i)
      of(noise, sizes_[i].place) = std::exp(p[static_cast<Eigen::Index>(i)]);
    return noise;
  }

  /// ln of the prior, and its slope.
  Slope prior(const Eigen::VectorXd& p) const {
    double value = 0.0;
    Eigen::VectorXd d(p.size());
    for (std::size_t i = 0; i < sizes_.size(); ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      const double z = (p[k] - std::log(sizes_[i].usual)) / sizes_[i].deviation;
      value -= 0.5 * z * z;
      d[k] = -z / sizes_[i].deviation;
    }
    return {value, d};
  }

  /// Of the logarithms, of noises that are seen so many times: 1/2n, with the prior.
  Eigen::MatrixXd covariance(const FilterNoise& seen) const {
    Eigen::VectorXd variance(std::ssize(sizes_));
    std::ranges::transform(sizes_, variance.begin(), [&](const Size& size) {
      return 1.0 / (2.0 * seen[size.place] + std::pow(size.deviation, -2));
    });
    return variance.asDiagonal();
  }

  /// By the logarithms of sizes, from that by the logarithms of variances.
  Eigen::VectorXd slope(const FilterNoise& by_log) const {
    Eigen::VectorXd slope(std::ssize(sizes_));
    for (std::size_t i = 0; i < sizes_.size(); ++i) slope[static_cast<Eigen::Index>(i)] = 2.0 * by_log[sizes_[i].place];
    return slope;
  }

 private:
  static constexpr double ordinary = 1.0;     ///< scale of the process noise
  static constexpr double usual_walk = 1e-3;  ///< of L in L/U: 20 cm of a ship of 200 m in half a minute
  static constexpr double wide = 2.0;

  struct Size {
    int place;
    double usual;
    double deviation;  ///< of the logarithm
  };

  static double& of(Noise& noise, int place) {
    if (place == place_of_walk) return noise.walk;
    if (place > place_of_walk) return noise.axes[static_cast<std::size_t>(place - place_of_process_noise(0))];
    return noise.factor[static_cast<std::size_t>(place)];
  }

  Noise start_;
  std::vector<Size> sizes_;
};

/// Noises at which innovations are about as large as expected, and the passes with them.
struct Begun {
  Noise noise;
  std::shared_ptr<const FilteredRuns> passes;
};

/// The noise of each channel takes the size of its innovations, root mean square, where they are far larger than
/// expected: from noises that are too small the way up leads to any of several summits.
Begun begun(const EstimationProblem& problem, const Point& point, const Noise& start) {
  constexpr double far = 5.0;
  Begun here{start, filtered(problem, point, start)};
  for (bool moved = true; std::exchange(moved, false);) {
    for (const auto channel : compared_channels(problem)) {
      double squares = 0.0, count = 0.0;
      for (const auto& run : here.passes->runs) {
        const auto& sums = run.sums[index_of(channel)];
        squares += sums.square, count += static_cast<double>(sums.count);
      }
      if (!(squares > far * far * count)) continue;
      here.noise.factor[index_of(channel)] *= std::sqrt(squares / count);
      moved = true;
    }
    if (moved) here.passes = filtered(problem, point, here.noise, here.passes.get());
  }
  return here;
}

/// The likeliest sizes of all noises together, up the exact slope.
Likelihood climbed_noise(const EstimationProblem& problem, const Point& point, const Noise& start,
                         Eigen::MatrixXd& covariance) try {
  constexpr AscentOptions options{.iterations = 30, .worth = 0.05};
  const auto first = begun(problem, point, start);
  const NoiseSizes sizes(problem, first.noise);
  const auto slope = [&](const Eigen::VectorXd& p, const Noise& noise, const FilteredRuns& passes) -> Slope {
    const auto prior = sizes.prior(p);
    const double value = passes.log_likelihood() + prior.value;
    if (!std::isfinite(value)) return {-HUGE_VAL, Eigen::VectorXd::Zero(p.size())};
    return {value, sizes.slope(log_likelihood_slope(problem, point, noise, passes)) + prior.by_p};
  };
  const auto at = [&](const Eigen::VectorXd& p) -> Slope {
    const auto noise = sizes.noise(p);
    try {
      return slope(p, noise, *filtered(problem, point, noise, first.passes.get()));
    } catch (const std::exception&) {
      return {-HUGE_VAL, Eigen::VectorXd::Zero(p.size())};
    }
  };
  const auto start_p = sizes.point();
  auto found = climb(at, start_p, slope(start_p, first.noise, *first.passes),
                     sizes.covariance(noises_seen(problem, first.noise, *first.passes)), options,
                     covariance.size() > 0 ? &covariance : nullptr);
  covariance = std::move(found.covariance);
  return {found.value, sizes.noise(found.p)};
} catch (const std::exception&) {  // she cannot sail like that
  return {-HUGE_VAL, start};
}

}  // namespace

Likelihood best_noise(const EstimationProblem& problem, const Point& point, const Noise& start, bool every_channel) {
  Eigen::MatrixXd covariance;
  return detail::best_noise(problem, point, start, every_channel, covariance);
}

Likelihood detail::best_noise(const EstimationProblem& problem, const Point& point, const Noise& start,
                              bool every_channel, Eigen::MatrixXd& covariance) {
  if (start.with_memory) return climbed_noise(problem, point, start, covariance);
  NoiseSearch search{problem, point, {log_likelihood(problem, point, start), start}};
  search.climb_scale();
  for (int i = 0; i < 3 && search.climb_factors(every_channel); ++i) search.climb_scale();
  for (int i = 0; i < 3 && search.best.noise.apart && search.climb_axes(); ++i) search.climb_factors(every_channel);
  return search.best;
}

}  // namespace swayaw::identification
