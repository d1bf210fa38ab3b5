#include "swayaw/identification/state_estimate.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>

#include "ship_filter.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/replay.hpp"

namespace swayaw {
namespace {

// ---------------------------------------------------------------- what is known of a run

/// Channels of a run and what the filter takes for their noise.
struct Measurements {
  const Recording& run;
  std::vector<Channel> channels;
  std::array<double, channel_count> variance{};
};

std::vector<Channel> channels_of(const Recording& run, const EstimationOptions& options) {
  std::vector<Channel> used;
  const auto wanted = [&](Channel c) { return options.channels.empty() || std::ranges::count(options.channels, c) > 0; };
  std::ranges::copy_if(filter_channels, std::back_inserter(used), [&](Channel c) { return run.has(c) && wanted(c); });
  const auto tells = [&](std::initializer_list<Channel> list) {
    return std::ranges::any_of(list, [&](Channel c) { return std::ranges::count(used, c) > 0; });
  };
  const bool position = tells({Channel::x}) && tells({Channel::y});
  const bool speed = tells({Channel::u, Channel::u_ground, Channel::speed_through_water, Channel::speed_over_ground});
  if (!position && !speed) throw Refusal(fmt::format("{}: neither position nor speed is among the channels used", run.name));
  return used;
}

/// Noise to begin with where none is known: the scatter of second differences, √(1/6) of their size for white noise.
double rough_noise(const Recording& run, Channel channel) {
  double sum = 0.0;
  std::size_t count = 0;
  const auto value = run[channel];
  for (std::size_t i = 2; i < value.size(); ++i) {
    const double second = value[i] - 2.0 * value[i - 1] + value[i - 2];
    if (!std::isfinite(second)) continue;
    sum += second * second;
    ++count;
  }
  return count == 0 ? 1.0 : std::sqrt(sum / (6.0 * static_cast<double>(count)));
}

/// Least noise that a channel is credited with: rounding of files.
double floor_of(Channel channel, double L, double U) {
  switch (channel) {
    case Channel::x: case Channel::y: return 1e-5 * L;
    case Channel::psi: case Channel::course_over_ground: return 1e-5;
    case Channel::r: return 1e-5 * U / L;
    default: return 1e-5 * U;
  }
}

// ---------------------------------------------------------------- filter and smoother of one model

/// What the filter keeps of a sample for the smoother.
template <int N>
struct Passed {
  Belief<N> predicted;
  Belief<N> filtered;
  FilterMatrix<N> Phi;  ///< from the sample before
};

/// Sums over the innovations of a channel.
struct ChannelSums {
  double square = 0.0;  ///< of error over expected size
  double product = 0.0; ///< of successive ones
  double last = 0.0;
  std::size_t count = 0;
};

template <class Model, int N>
class RunFilter {
 public:
  RunFilter(const Ship& ship, const Model& model, const Measurements& measured, const RecordedControls& controls, double tau)
      : ship_(ship), measured_(measured), predictor_(model, ship.surroundings, tau), tau_(tau), passed_(measured.run.samples()) {
    for (const double time : measured.run.time) controls_.push_back(controls.at(time));
  }

  double forward(const FilterNoise& noise, const std::array<double, channel_count>& variance, const Belief<N>& start) {
    log_likelihood_ = 0.0;
    sums_ = {};
    Belief<N> belief = start;
    for (std::size_t k = 0; k < passed_.size(); ++k) {
      passed_[k].Phi = k == 0 ? FilterMatrix<N>(FilterMatrix<N>::Identity()) : sail(belief, k, noise);
      passed_[k].predicted = belief;
      measure(belief, k, variance);
      passed_[k].filtered = belief;
    }
    return log_likelihood_;
  }

  /// Rauch–Tung–Striebel: G = P_f Φᵀ P_p⁻¹, x_s = x_f + G (x_s⁺ − x_p⁺), P_s = P_f + G (P_s⁺ − P_p⁺) Gᵀ.
  std::vector<Belief<N>> backward() {
    std::vector<Belief<N>> smooth(passed_.size());
    gains_.resize(passed_.size());
    smooth.back() = passed_.back().filtered;
    for (std::size_t k = passed_.size() - 1; k-- > 0;) {
      const auto& [predicted, filtered, Phi] = passed_[k + 1];
      const auto& now = passed_[k].filtered;
      gains_[k] = predicted.P.llt().solve(FilterMatrix<N>(Phi * now.P)).transpose();
      const auto& G = gains_[k];
      smooth[k].mean = now.mean + G * (smooth[k + 1].mean - predicted.mean);
      smooth[k].P = now.P + G * (smooth[k + 1].P - predicted.P) * G.transpose();
    }
    return smooth;
  }

  std::vector<Belief<N>> filtered() const {
    std::vector<Belief<N>> beliefs;
    for (const auto& p : passed_) beliefs.push_back(p.filtered);
    return beliefs;
  }

  /// Noise that explains the smoothed run best, one step of expectation and maximisation.
  void improve(const std::vector<Belief<N>>& smooth, FilterNoise& noise, std::array<double, channel_count>& variance,
               const EstimationOptions& options, double L, double U) const {
    for (const Channel channel : measured_.channels)
      if (!options.noise[index_of(channel)]) variance[index_of(channel)] = std::max(noise_of(smooth, channel), std::pow(floor_of(channel, L, U), 2));
    if (options.imperfection) return;
    const auto size = imperfection_of(smooth);
    noise.size = {std::max(size[0], 1e-6 * U * U / L), std::max(size[1], 1e-6 * U * U / L), std::max(size[2], 1e-6 * U * U / (L * L))};
  }

  const std::array<ChannelSums, channel_count>& sums() const { return sums_; }
  double log_likelihood() const { return log_likelihood_; }

 private:
  /// To sample k, in steps that are short for the ship. @return Φ of the whole way
  FilterMatrix<N> sail(Belief<N>& belief, std::size_t k, const FilterNoise& noise) const {
    const auto& time = measured_.run.time;
    const double h = time[k] - time[k - 1];
    const int steps = predictor_.steps(speed(ship_state<N>(belief.mean).motion), h);
    FilterMatrix<N> Phi = FilterMatrix<N>::Identity();
    const auto Q = noise_over<N>(noise, h / steps);
    for (int i = 0; i < steps; ++i) {
      const auto begin = predictor_.between(controls_[k - 1], controls_[k], static_cast<double>(i) / steps);
      const auto end = predictor_.between(controls_[k - 1], controls_[k], static_cast<double>(i + 1) / steps);
      const auto step = predictor_.over(belief.mean, begin, end, h / steps);
      belief.mean = step.state;
      belief.P = step.Phi * belief.P * step.Phi.transpose() + Q;
      Phi = steps == 1 ? step.Phi : FilterMatrix<N>(step.Phi * Phi);
    }
    return Phi;
  }

  void measure(Belief<N>& belief, std::size_t k, const std::array<double, channel_count>& variance) {
    for (const Channel channel : measured_.channels) {
      const double value = measured_.run[channel][k];
      if (std::isnan(value)) continue;
      const auto [error, expected] = take_in(belief, channel, value, variance[index_of(channel)], ship_.surroundings.current);
      log_likelihood_ -= 0.5 * (error * error / expected + std::log(2.0 * pi * expected));
      auto& sums = sums_[index_of(channel)];
      const double scaled = error / std::sqrt(expected);
      sums.square += scaled * scaled;
      if (sums.count > 0) sums.product += scaled * sums.last;
      sums.last = scaled;
      ++sums.count;
    }
  }

  /// E (y − h(x))² over the smoothed run.
  double noise_of(const std::vector<Belief<N>>& smooth, Channel channel) const {
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t k = 0; k < smooth.size(); ++k) {
      const double value = measured_.run[channel][k];
      if (std::isnan(value)) continue;
      const auto e = expected<N>(channel, smooth[k].mean, ship_.surroundings.current);
      const double error = is_direction(channel) ? wrapped(value - e.value) : value - e.value;
      sum += error * error + e.row.dot(smooth[k].P * e.row);
      ++count;
    }
    return sum / static_cast<double>(count);
  }

  /// E w wᵀ of what the random accelerations did, per second, as sizes.
  std::array<double, 3> imperfection_of(const std::vector<Belief<N>>& smooth) const {
    constexpr int first = N == 9 ? 6 : 3;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t k = 1; k < smooth.size(); ++k) {
      const double h = measured_.run.time[k] - measured_.run.time[k - 1];
      const auto& Phi = passed_[k].Phi;
      // the smoothed state that the model leads to, linearized about the filtered one
      const FilterVector<N> lead = passed_[k].predicted.mean + Phi * (smooth[k - 1].mean - passed_[k - 1].filtered.mean);
      const FilterVector<N> w = smooth[k].mean - lead;
      const FilterMatrix<N> cross = smooth[k].P * gains_[k - 1].transpose();  // of states k and k − 1
      const FilterMatrix<N> W = smooth[k].P - cross * Phi.transpose() - Phi * cross.transpose() + Phi * smooth[k - 1].P * Phi.transpose();
      const double time = N == 9 ? -std::expm1(-2.0 * h / tau_) : h;
      for (int i = 0; i < 3; ++i) sum[i] += (w[first + i] * w[first + i] + std::max(0.0, W(first + i, first + i))) / time;
    }
    const double count = static_cast<double>(smooth.size() - 1);
    return {std::sqrt(sum[0] / count), std::sqrt(sum[1] / count), std::sqrt(sum[2] / count)};
  }

  const Ship& ship_;
  const Measurements& measured_;
  ShipPredictor<Model, N> predictor_;
  double tau_;
  std::vector<Controls<double>> controls_;
  std::vector<Passed<N>> passed_;
  std::vector<FilterMatrix<N>> gains_;
  std::array<ChannelSums, channel_count> sums_{};
  double log_likelihood_ = 0.0;
};

// ---------------------------------------------------------------- the whole

/// Little is known of the start: a quarter of a ship length, of the speed and of a radian about the recorded state.
template <int N>
Belief<N> start_of(const Ship& ship, const Recording& run, const FilterNoise& noise) {
  const auto s = recorded_state(ship, run, run.time.front());
  const double L = length(ship), U = speed(s.motion);
  Belief<N> start{FilterVector<N>::Zero(), FilterMatrix<N>::Zero()};
  start.mean.template head<6>() << s.x, s.y, s.psi, s.motion.u, s.motion.v, s.motion.r;
  const double deviation[] = {0.25 * L, 0.25 * L, 0.25, 0.25 * U, 0.25 * U, 0.25 * U / L};
  for (int i = 0; i < 6; ++i) start.P(i, i) = deviation[i] * deviation[i];
  if constexpr (N == 9) {
    start.P(6, 6) = noise.size.u * noise.size.u;
    start.P(7, 7) = noise.size.v * noise.size.v;
    start.P(8, 8) = noise.size.r * noise.size.r;
  }
  return start;
}

template <int N>
EstimatedState estimated(double time, const Belief<N>& belief) {
  EstimatedState result{.time = time, .state = ship_state<N>(belief.mean), .unmodelled = {0.0, 0.0, 0.0}, .covariance = {}};
  if constexpr (N == 9) result.unmodelled = {belief.mean[6], belief.mean[7], belief.mean[8]};
  for (int i = 0; i < N; ++i)
    for (int k = 0; k < N; ++k) result.covariance[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] = belief.P(i, k);
  return result;
}

ChannelInnovation innovation_of(Channel channel, const ChannelSums& sums, double variance) {
  const double count = static_cast<double>(sums.count);
  return {.channel = channel, .noise = std::sqrt(variance), .rms = std::sqrt(sums.square / count), .autocorrelation = sums.product / sums.square, .count = sums.count};
}

template <int N, class Model>
StateEstimate estimate(const Ship& ship, const Model& model, const Measurements& measured, const EstimationOptions& options) {
  const auto& run = measured.run;
  const double L = length(ship), U = service_speed(ship), tau = options.memory * L / U;
  FilterNoise noise{options.imperfection.value_or(Imperfection{{0.01 * U * U / L, 0.01 * U * U / L, 0.01 * U * U / (L * L)}}).size, tau};
  auto variance = measured.variance;
  RunFilter<Model, N> filter(ship, model, measured, RecordedControls(ship, run), tau);
  const bool known = options.imperfection && std::ranges::all_of(measured.channels, [&](Channel c) { return options.noise[index_of(c)].has_value(); });
  StateEstimate result{.states = {}, .innovations = {}, .imperfection = {}, .log_likelihood = 0.0, .iterations = 0, .converged = known};
  double before = filter.forward(noise, variance, start_of<N>(ship, run, noise));
  while (!result.converged && result.iterations < options.most_iterations) {
    filter.improve(filter.backward(), noise, variance, options, L, U);
    const double now = filter.forward(noise, variance, start_of<N>(ship, run, noise));
    ++result.iterations;
    result.converged = std::abs(now - before) < 0.01 * std::sqrt(static_cast<double>(run.samples()));
    before = now;
  }
  const auto beliefs = options.smooth ? filter.backward() : filter.filtered();
  for (std::size_t k = 0; k < beliefs.size(); ++k) result.states.push_back(estimated<N>(run.time[k], beliefs[k]));
  for (const Channel c : measured.channels) result.innovations.push_back(innovation_of(c, filter.sums()[index_of(c)], variance[index_of(c)]));
  result.imperfection = {noise.size};
  result.log_likelihood = filter.log_likelihood();
  return result;
}

}  // namespace

StateEstimate estimate_states(const Ship& ship, const Recording& run, const EstimationOptions& options) {
  if (run.samples() < 3) throw Refusal(fmt::format("{}: too few samples to estimate states", run.name));
  Measurements measured{.run = run, .channels = channels_of(run, options)};
  for (const Channel channel : measured.channels) {
    const auto& known = options.noise[index_of(channel)];
    const double deviation = known ? require_positive(*known, fmt::format("noise of {}", column_name(channel)))
                                   : std::max(rough_noise(run, channel), floor_of(channel, length(ship), service_speed(ship)));
    measured.variance[index_of(channel)] = deviation * deviation;
  }
  const auto with = [&](const auto& model) {
    return options.coloured ? estimate<9>(ship, model, measured, options) : estimate<6>(ship, model, measured, options);
  };
  return std::visit(with, ship.model);
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

}  // namespace swayaw
