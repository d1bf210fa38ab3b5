#pragma once

#include <fmt/format.h>

#include <span>
#include <vector>

#include "ship_filter.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/replay.hpp"

/// Filter and smoother of a recorded run. Not installed.
namespace swayaw {

/// Variances of the channels and, at the end, of the imperfection; or slopes of the log likelihood by their logarithms.
using FilterNoise = Eigen::Matrix<double, static_cast<int>(channel_count) + 3, 1>;

inline int place_of(Channel channel) { return static_cast<int>(index_of(channel)); }
inline int place_of_imperfection(int i) { return static_cast<int>(channel_count) + i; }

/// Sums over the prediction errors of a channel.
struct ChannelSums {
  double square = 0.0;   ///< of error over expected size
  double product = 0.0;  ///< of successive ones
  double last = 0.0;
  std::size_t count = 0;

  void add(double scaled) {
    square += scaled * scaled;
    product += scaled * last;
    last = scaled;
    ++count;
  }
};

template <class Model, int N>
class RunFilter {
 public:
  RunFilter(const Ship& ship, const Model& model, const Recording& run, std::span<const Channel> channels, double tau)
      : run_(run),
        channels_(channels),
        current_(ship.surroundings.current),
        predictor_(model, ship.surroundings, tau),
        tau_(tau),
        start_(recorded_state(ship, run, run.time.front())),
        L_(model.particulars.L),
        passed_(run.samples()) {
    const RecordedControls controls(ship, run);
    controls_.reserve(run.samples());
    for (const double time : run.time) controls_.push_back(controls.at(time));
    steps_.reserve(run.samples());
    sightings_.reserve(run.samples() * channels.size());
  }

  /// Filters the run: tell(k, belief) after the measurements of each sample. @return log likelihood
  template <class Tell>
  double forward(const FilterNoise& noise, Tell&& tell) {
    log_likelihood_ = 0.0;
    sums_ = {};
    steps_.clear();
    sightings_.clear();
    slopes_.clear();
    Belief<N> belief = start(noise);
    for (std::size_t k = 0; k < passed_.size(); ++k) {
      if (k > 0) sail(belief, k, noise);
      passed_[k].steps = steps_.size();
      measure(belief, k, noise);
      passed_[k].sightings = sightings_.size();
      tell(k, belief);
    }
    return log_likelihood_;
  }

  /// What comes after each sample, from the last to the first: tell(k, future).
  /// @return slopes of the log likelihood by the logarithms of the variances
  template <class Tell>
  FilterNoise backward(const FilterNoise& noise, Tell&& tell) const {
    FilterNoise slope = FilterNoise::Zero();
    Future<N> future;
    std::size_t slope_count = slopes_.size();
    for (std::size_t k = passed_.size(); k-- > 0;) {
      tell(k, future);
      const auto [first_step, first_sighting] = k == 0 ? Passed{} : passed_[k - 1];
      for (std::size_t i = passed_[k].sightings; i-- > first_sighting;) {
        const auto& seen = sightings_[i];
        const bool plain = plain_state(seen.channel) >= 0;
        slope[place_of(seen.channel)] +=
            noise[place_of(seen.channel)] * future.step_back(seen, plain ? ChannelSlope() : slopes_[--slope_count]);
      }
      for (std::size_t i = passed_[k].steps; i-- > first_step;) {
        add_slope(slope, noise, steps_[i].share, future);
        future.step_back(steps_[i]);
        add_slope(slope, noise, steps_[i].share, future);
      }
    }
    if (N == 9 && std::isfinite(tau_)) add_slope(slope, noise, 1.0, future);
    return slope;
  }

  std::size_t steps() const { return steps_.size(); }
  const ChannelSums& sums(Channel channel) const { return sums_[index_of(channel)]; }

 private:
  static constexpr int random = N == 9 ? 6 : 3;  ///< first of the states that random accelerations drive

  /// Steps and sightings up to and with a sample.
  struct Passed {
    std::size_t steps = 0;
    std::size_t sightings = 0;
  };

  /// Little is known of the start: a quarter of a ship length, of the speed and of a radian about the recorded state.
  Belief<N> start(const FilterNoise& noise) const {
    const double U = speed(start_.motion), quarter = 0.25;
    Belief<N> belief{FilterVector<N>::Zero(), FilterMatrix<N>::Zero()};
    belief.mean.template head<6>() << start_.x, start_.y, start_.psi, start_.motion.u, start_.motion.v, start_.motion.r;
    auto variance = belief.P.diagonal();
    variance.template head<6>() << L_, L_, 1.0, U, U, U / L_;
    if constexpr (N == 9) variance.template tail<3>() << U * U / L_, U * U / L_, U * U / (L_ * L_);
    variance = (quarter * variance).array().square().eval();
    if (N == 9 && std::isfinite(tau_)) variance.template tail<3>() = noise.tail<3>();
    return belief;
  }

  /// To sample k, in steps that are short for the ship.
  void sail(Belief<N>& belief, std::size_t k, const FilterNoise& noise) {
    const double h = run_.time[k] - run_.time[k - 1];
    const int count = predictor_.steps(speed(ship_state<N>(belief.mean).motion), h);
    for (int i = 0; i < count; ++i) {
      const auto& t = steps_.emplace_back(
          predictor_.sail(belief.mean, between(controls_[k - 1], controls_[k], (i + 0.5) / count), h / count));
      belief.P.diagonal().template segment<3>(random) += t.share * noise.tail<3>();
      belief.P = carried<N>(belief.P, t);
      belief.P.diagonal().template segment<3>(random) += t.share * noise.tail<3>();
    }
    if (!std::isfinite(belief.mean.sum()))
      throw Refusal(fmt::format("{}: the ship loses her way at {:.6g} s", run_.name, run_.time[k]));
  }

  void measure(Belief<N>& belief, std::size_t k, const FilterNoise& noise) {
    double product = 1.0;  // of variances, whose logarithm is slow
    for (const Channel channel : channels_) {
      const double value = run_[channel][k], R = noise[place_of(channel)];
      if (std::isnan(value)) continue;
      const int state = plain_state(channel);
      sightings_.push_back(state >= 0 ? taken_in<N>(belief, channel, state, value, R)
                                      : taken_in<N>(belief, channel, current_, value, R, slopes_.emplace_back()));
      const auto& seen = sightings_.back();
      const double square = seen.error * seen.error / seen.variance;
      log_likelihood_ -= 0.5 * square;
      product *= 2.0 * pi * seen.variance;
      sums_[index_of(channel)].add(std::copysign(std::sqrt(square), seen.error));
    }
    log_likelihood_ -= 0.5 * std::log(product);
  }

  static void add_slope(FilterNoise& slope, const FilterNoise& noise, double share, const Future<N>& future) {
    for (int i = 0; i < 3; ++i)
      slope[place_of_imperfection(i)] += share * noise[place_of_imperfection(i)] * future.slope(random + i);
  }

  const Recording& run_;
  std::span<const Channel> channels_;
  Current<double> current_;
  ShipPredictor<Model, N> predictor_;
  double tau_;
  ShipState<double> start_;
  double L_;
  std::vector<Controls<double>> controls_;
  std::vector<Passed> passed_;
  std::vector<Transition<N>> steps_;
  std::vector<Sighting<N>> sightings_;
  std::vector<ChannelSlope> slopes_;  ///< of the nonlinear ones
  std::array<ChannelSums, channel_count> sums_{};
  double log_likelihood_ = 0.0;
};

}  // namespace swayaw
