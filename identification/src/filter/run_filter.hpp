#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "measurement_update.hpp"
#include "swayaw/nonlinear/replay.hpp"

/// Filter and smoother of a recorded run: any ship, with all her effects and instruments. Compiled once for 6 states
/// and once for 9. Not installed.
namespace swayaw::inline identification::detail {

/// Variances of the channels and, at the end, of the unmodelled accelerations of surge, sway and yaw; or slopes of the
/// log likelihood by their logarithms.
using FilterNoise = Eigen::Matrix<double, static_cast<int>(channel_count) + 3, 1>;

inline int place_of(Channel channel) { return static_cast<int>(index_of(channel)); }
inline int place_of_process_noise(int i) { return static_cast<int>(channel_count) + i; }

/// Sums over the innovations of a channel.
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

/// Everything up to and with a sample.
struct Passed {
  std::size_t steps = 0;
  std::size_t innovations = 0;
  double log_likelihood = 0.0;
};

/// A filtered run, with what the smoother and residuals with the same gains need, unless it is not kept.
template <int N>
struct FilteredRun {
  bool kept = true;  ///< steps and innovations
  std::vector<Passed> passed;
  std::vector<Transition<N>> steps;
  std::vector<Innovation<N>> innovations;
  std::vector<ChannelSlope> slopes;  ///< of channels that show no state alone
  std::array<ChannelSums, channel_count> sums{};
  double tau = 0.0;  ///< memory of the unmodelled accelerations [s]

  double log_likelihood() const { return passed.back().log_likelihood; }

  /// Empty, with room for a run of so many samples; a step may be cut in several.
  void restart(std::size_t samples, std::size_t channels) {
    passed.clear(), forget_steps();
    passed.reserve(samples);
    if (kept) steps.reserve(samples), innovations.reserve(samples * channels);
    sums = {};
  }

  void forget_steps() { steps.clear(), innovations.clear(), slopes.clear(); }
};

/// A step of the filter [s].
struct Interval {
  double from, to;
};

template <int N>
class RunFilter {
 public:
  /// @param run    must outlive the filter, as its channels
  /// @param start  little is known of it
  /// @param tau    memory of the unmodelled accelerations [s], or infinity
  /// @throws Refusal  where one of her effects cannot act on her model
  RunFilter(const Ship& ship, const Recording& run, std::span<const Channel> channels, const ShipState<double>& start,
            double tau);

  /// Filters the run.
  /// @param tell  if there is one, tell(k, estimate) after the measurements of each sample
  void forward(const FilterNoise& noise, FilteredRun<N>& pass,
               const std::function<void(std::size_t, const Gaussian<N>&)>& tell = {});

  /// What comes after each sample, from the last to the first.
  /// @param tell  if there is one, tell(k, smoother) of each sample
  /// @return slopes of the log likelihood by the logarithms of the variances
  FilterNoise backward(const FilterNoise& noise, const FilteredRun<N>& pass,
                       const std::function<void(std::size_t, const Smoother<N>&)>& tell = {}) const;

  /// Innovations over their standard deviations, with the gains and the steps of a pass: of another ship what hers
  /// would be, of the same ship those of the pass.
  void residuals(const FilteredRun<N>& pass, Eigen::Ref<Eigen::VectorXd> out);

 private:
  static constexpr int random = N == 9 ? 6 : 3;  ///< first of the states that random accelerations drive

  bool has_memory() const { return N == 9 && std::isfinite(predictor_.tau()); }
  FilterVector<N> first_state() const;
  Gaussian<N> start(const FilterNoise& noise) const;
  void require_motion(const FilterVector<N>& x, std::size_t k) const;
  Interval step_in(std::size_t k, int i, int count) const;
  Controls<double> controls_in(std::size_t k, const Interval& step) const;
  void predict(Gaussian<N>& estimate, std::size_t k, const FilterNoise& noise, FilteredRun<N>& pass);
  double measure(Gaussian<N>& estimate, std::size_t k, const FilterNoise& noise, FilteredRun<N>& pass);
  Innovation<N> update(Gaussian<N>& estimate, Channel channel, std::size_t k, double R, FilteredRun<N>& pass);
  double expected(Channel channel, const FilterVector<N>& x, const Sight& sight) const;
  Sight sight_of(const FilterVector<N>& x) const;
  Sight late_sight(const FilterVector<N>& x, std::size_t k) const;
  static void add_slope(FilterNoise& slope, const FilterNoise& noise, double share, const Smoother<N>& smoother);

  const Recording& run_;
  std::span<const Channel> channels_;
  ShipPredictor<N> predictor_;
  ChannelObserver observer_;
  RecordedControls controls_;
  std::vector<Controls<double>> at_samples_;
  ShipState<double> start_;
  double L_, U_0_;
};

extern template class RunFilter<6>;
extern template class RunFilter<9>;

}  // namespace swayaw::identification::detail
