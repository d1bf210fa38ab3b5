#include "swayaw/identification/state_estimate.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "noise_ascent.hpp"
#include "run_filter.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/replay.hpp"

namespace swayaw::inline identification {
using namespace detail;
namespace {

// ---------------------------------------------------------------- what is known

void require_position_or_speed(const Recording& run, std::span<const Channel> used) {
  const auto told = [&](Channel c) { return run.has(c) && std::ranges::count(used, c) > 0; };
  const bool position = told(Channel::x) && told(Channel::y);
  const bool speed = told(Channel::u) || told(Channel::u_ground) || told(Channel::speed_through_water) ||
                     told(Channel::speed_over_ground);
  if (!position && !speed)
    throw Refusal(fmt::format("{}: neither position nor speed is among the channels used", run.name));
  if (run.samples() < 3) throw Refusal(fmt::format("{}: too few samples to estimate states", run.name));
}

/// Least noise that a channel is credited with, over its unit: the rounding of files with six digits.
constexpr double least_noise = 1e-5;

// ---------------------------------------------------------------- variances as parameters without bounds

/// The variances that are to be found, as σ² = least² + exp(2 p): no p makes a noise so small that rounding matters.
class UnknownVariances {
 public:
  UnknownVariances(const Ship& ship, std::span<const Recording> runs, std::span<const Channel> channels,
                   const EstimationOptions& options) {
    const double L = length(ship), U = service_speed(ship);
    for (const Channel c : channels) {
      const double least = least_noise * unit_of(c, L, U);
      if (const auto& known = options.noise[index_of(c)])
        noise_[place_of(c)] = std::pow(require_positive(*known, fmt::format("noise of {}", column_name(c))), 2);
      else {
        double begin = 2.0 * least;
        for (const auto& run : runs) begin = std::max(begin, white_noise_of(run[c]));
        set_free(place_of(c), least, begin);
      }
    }
    // U²/L and U²/L²; of white accelerations what they make of a velocity in L/U
    const double unit = options.coloured ? U * U / L : U * std::sqrt(U / L);
    for (int i = 0; i < 3; ++i)
      if (!options.process_noise)
        set_free(place_of_process_noise(i), 1e-6 * unit / (i < 2 ? 1.0 : L), 0.01 * unit / (i < 2 ? 1.0 : L));
    if (options.process_noise) noise_.tail<3>() = of(*options.process_noise).array().square();
  }

  Eigen::Index free() const { return static_cast<Eigen::Index>(free_.size()); }

  Eigen::VectorXd start() const {
    return at([&](const Free& f) { return 0.5 * std::log(noise_[f.place] - f.least); });
  }

  FilterNoise noise(const Eigen::VectorXd& p) const {
    FilterNoise noise = noise_;
    for (Eigen::Index i = 0; i < p.size(); ++i) noise[free_[i].place] = free_[i].least + std::exp(2.0 * p[i]);
    return noise;
  }

  /// Slopes by p from those by ln σ²: d(ln σ²)/dp = 2 (1 − least²/σ²).
  Eigen::VectorXd slope(const FilterNoise& by_log, const FilterNoise& noise) const {
    return at([&](const Free& f) { return 2.0 * (1.0 - f.least / noise[f.place]) * by_log[f.place]; });
  }

  /// 1/2n where n noises are seen, so that the first step is one of expectation and maximisation.
  Eigen::MatrixXd covariance(const FilterNoise& count) const {
    return at([&](const Free& f) { return 0.5 / std::max(count[f.place], 1.0); }).asDiagonal();
  }

 private:
  struct Free {
    int place;
    double least;  ///< variance
  };

  static Eigen::Vector3d of(const ProcessNoise& i) { return {i.size.u, i.size.v, i.size.r}; }

  void set_free(int place, double least, double begin) {
    free_.push_back({place, least * least});
    noise_[place] = begin * begin;
  }

  Eigen::VectorXd at(auto&& value) const {
    Eigen::VectorXd p(free());
    for (Eigen::Index i = 0; i < free(); ++i) p[i] = value(free_[static_cast<std::size_t>(i)]);
    return p;
  }

  std::vector<Free> free_;
  FilterNoise noise_ = FilterNoise::Zero();
};

// ---------------------------------------------------------------- estimates

/// Filters of the runs of one ship.
template <int N>
class Estimator {
 public:
  Estimator(const Ship& ship, std::span<const Recording> runs, const EstimationOptions& options)
      : options_(options),
        channels_(recorded_channels(runs, measured_channels(), options.channels)),
        unknown_(ship, runs, channels_, options),
        passes_(runs.size()) {
    const double time_unit = time_unit_of(ship),
                 tau = require_positive(options.memory, "memory of the process noise") * time_unit;
    for (const auto& run : runs) {
      require_position_or_speed(run, channels_);
      ship_times_ += (run.time.back() - run.time.front()) / time_unit;
      filters_.push_back(
          run_filter<N>(ship, run, channels_, recorded_state(ship, run, run.time.front()), tau, SampleTimes::recorded));
    }
  }

  Estimator(const Estimator&) = delete;  // the filters refer to the channels

  NoiseEstimate noise() {
    auto result = search();
    if (unknown_.free() == 0) result.log_likelihood = forward();
    return result;
  }

  /// Of the only run.
  StateEstimate states(const Recording& run) {
    StateEstimate result{.states = {}, .innovations = {}, .noise = search()};
    result.states.reserve(run.samples());
    auto& pass = passes_.front();
    pass.kept = options_.smooth;
    filters_.front()->forward(noise_, pass, [&](std::size_t k, const Gaussian<N>& estimate) {
      result.states.push_back(filtered(run.time, k, estimate));
    });
    result.noise.log_likelihood = pass.log_likelihood();
    if (options_.smooth)
      filters_.front()->backward(
          noise_, pass, [&](std::size_t k, const Smoother<N>& smoother) { smooth(result.states[k], smoother); });
    for (const Channel c : channels_) {
      const auto& sums = pass.sums[index_of(c)];
      result.innovations.push_back({.channel = c,
                                    .noise = deviation(place_of(c)),
                                    .rms = std::sqrt(sums.square / static_cast<double>(sums.count)),
                                    .autocorrelation = sums.product / sums.square,
                                    .count = sums.count});
    }
    return result;
  }

 private:
  /// Finds the noise that is not known.
  NoiseEstimate search() {
    const auto start = unknown_.start();
    noise_ = unknown_.noise(start);
    NoiseAscent found{.p = start, .value = 0.0, .iterations = 0, .converged = true, .covariance = {}};
    if (unknown_.free() > 0) {
      auto at_start = slope(start);
      found = climb([&](const Eigen::VectorXd& p) { return slope(p); }, start, std::move(at_start),
                    unknown_.covariance(counts()), {.iterations = options_.most_iterations});
    }
    noise_ = unknown_.noise(found.p);
    const auto size = [&](int i) { return deviation(place_of_process_noise(i)); };
    NoiseEstimate result{.noise = {},
                         .process_noise = {{size(0), size(1), size(2)}},
                         .log_likelihood = found.value,
                         .iterations = found.iterations,
                         .converged = found.converged};
    for (const Channel c : channels_) result.noise[index_of(c)] = deviation(place_of(c));
    return result;
  }

  double deviation(int place) const { return std::sqrt(noise_[place]); }

  double forward() {
    double sum = 0.0;
    for (std::size_t i = 0; i < filters_.size(); ++i) {
      filters_[i]->forward(noise_, passes_[i]);
      sum += passes_[i].log_likelihood();
    }
    return sum;
  }

  Slope slope(const Eigen::VectorXd& p) {
    noise_ = unknown_.noise(p);
    FilterNoise by_log = FilterNoise::Zero();
    const double value = forward();
    for (std::size_t i = 0; i < filters_.size(); ++i) by_log += filters_[i]->backward(noise_, passes_[i]);
    return {value, unknown_.slope(by_log, noise_)};
  }

  /// How many noises of each kind the runs show: one of a channel in each sample; of the accelerations one in the time
  /// that the ship takes to follow them, for what is faster the measurements do not tell. Searches of 48 simulated runs
  /// took 1,012 iterations with one in each step, 766 so.
  FilterNoise counts() const {
    FilterNoise count = FilterNoise::Zero();
    for (const auto& pass : passes_)
      for (const Channel c : channels_) count[place_of(c)] += static_cast<double>(pass.sums[index_of(c)].count);
    count.tail<3>().setConstant(ship_times_);
    return count;
  }

  /// The mean of a white acceleration until the next sample, h later, has the variance σ²/h.
  EstimatedState filtered(std::span<const double> time, std::size_t k, const Gaussian<N>& estimate) const {
    const auto& x = estimate.mean;
    EstimatedState result{.time = time[k], .state = ship_state<N>(x), .unmodelled = {0.0, 0.0, 0.0}, .covariance = {}};
    for (int i = 0; i < N; ++i)
      for (int j = 0; j <= i; ++j) at(result.covariance, i, j) = estimate.P(i, j);
    const double h = k + 1 < time.size() ? time[k + 1] - time[k] : time[k] - time[k - 1];
    if constexpr (N == 9) result.unmodelled = {x[6], x[7], x[8]};
    else
      for (int i = 0; i < 3; ++i) at(result.covariance, 6 + i, 6 + i) = noise_[place_of_process_noise(i)] / h;
    return result;
  }

  /// x + P r and P − P M P. A white acceleration is seen through the velocity: its mean σ² r, its covariance −P M σ²
  /// with the state and σ²/h − σ² M σ² of its own.
  void smooth(EstimatedState& estimate, const Smoother<N>& smoother) const {
    auto& P_s = estimate.covariance;
    FilterMatrix<N> P;
    for (int i = 0; i < N; ++i)
      for (int j = 0; j <= i; ++j) P(i, j) = P(j, i) = at(P_s, i, j);
    const FilterVector<N> gain = P * smoother.r;
    const FilterMatrix<N> MP = smoother.M.lazyProduct(P);
    for (int i = 0; i < N; ++i)
      for (int j = 0; j <= i; ++j) at(P_s, i, j) -= P.col(i).dot(MP.col(j));
    auto& [time, s, a, covariance] = estimate;
    s = {s.x + gain[0],
         s.y + gain[1],
         s.psi + gain[2],
         {s.motion.u + gain[3], s.motion.v + gain[4], s.motion.r + gain[5]}};
    if constexpr (N == 9) a = {a.u + gain[6], a.v + gain[7], a.r + gain[8]};
    else {
      const Eigen::Vector3d W = noise_.template tail<3>(), mean = W.cwiseProduct(smoother.r.template tail<3>());
      a = {mean[0], mean[1], mean[2]};
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 6; ++j) at(P_s, 6 + i, j) = -W[i] * MP(3 + i, j);
        for (int j = 0; j <= i; ++j) at(P_s, 6 + i, 6 + j) -= W[i] * smoother.M(3 + i, 3 + j) * W[j];
      }
    }
  }

  static double& at(StateCovariance& covariance, int i, int k) {
    return covariance(static_cast<std::size_t>(i), static_cast<std::size_t>(k));
  }

  const EstimationOptions& options_;
  std::vector<Channel> channels_;
  UnknownVariances unknown_;
  std::vector<std::unique_ptr<RunFilter<N>>> filters_;
  std::vector<FilteredRun<N>> passes_;
  FilterNoise noise_ = FilterNoise::Zero();
  double ship_times_ = 0.0;  ///< time of all runs over L/U
};

/// ask(estimator) of the filter that the options want.
template <class Ask>
auto with_estimator(const Ship& ship, std::span<const Recording> runs, const EstimationOptions& options, Ask&& ask) {
  if (options.coloured) return ask(Estimator<9>(ship, runs, options));
  return ask(Estimator<6>(ship, runs, options));
}

}  // namespace

StateEstimate estimate_states(const Ship& ship, const Recording& run, const EstimationOptions& options) {
  return with_estimator(ship, {&run, 1}, options, [&](auto&& estimator) { return estimator.states(run); });
}

NoiseEstimate estimate_noise(const Ship& ship, std::span<const Recording> runs, const EstimationOptions& options) {
  return with_estimator(ship, runs, options, [](auto&& estimator) { return estimator.noise(); });
}

Recording StateEstimate::recording(const Recording& run) const {
  Recording result = run;
  result.extra.clear();
  const auto fill = [&](Channel channel, auto&& value) {
    auto column = result.fill(channel);
    for (std::size_t i = 0; i < states.size(); ++i) column[i] = value(states[i].state);
  };
  fill(Channel::x, [](const auto& s) { return s.x; });
  fill(Channel::y, [](const auto& s) { return s.y; });
  fill(Channel::psi, [](const auto& s) { return s.psi; });
  fill(Channel::u, [](const auto& s) { return s.motion.u; });
  fill(Channel::v, [](const auto& s) { return s.motion.v; });
  fill(Channel::r, [](const auto& s) { return s.motion.r; });
  return result;
}

}  // namespace swayaw::identification
