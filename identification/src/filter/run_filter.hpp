#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "measurement_update.hpp"
#include "swayaw/nonlinear/replay.hpp"

/// Filter and smoother of a recorded run: any ship, with all her effects and instruments. Compiled once for 6 states
/// and once for 9. Not installed.
namespace swayaw::inline identification::detail {

/// Variances of the channels, what that of the error of a position gains in a second, and, at the end, variances of the
/// unmodelled accelerations of surge, sway and yaw; or slopes of the log likelihood by their logarithms.
using FilterNoise = Eigen::Matrix<double, static_cast<int>(channel_count) + 4, 1>;

inline int place_of(Channel channel) { return static_cast<int>(index_of(channel)); }
inline constexpr int place_of_walk = static_cast<int>(channel_count);
inline int place_of_process_noise(int i) { return static_cast<int>(channel_count) + 1 + i; }

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

/// The states of the ship that a filter has at its samples: those of the recorded times, or those that the heading
/// shows then, which is for fits; without a heading, the first channel. So a delay that channels share moves the
/// samples, and no reading against them: where samples stood at the recorded times a fit, which goes by residuals, put
/// −0.3 s on five channels of the KVLCC2 models where 0.3 s on the rudder is 200 in log evidence likelier. It is the
/// same channel always: where delays pass each other, the one in the middle becomes another, and sums of squares have
/// an edge there, at which fits stop.
enum class SampleTimes { recorded, shown };

/// By how much the samples are later than what they show [s], negative where earlier.
/// @param channels  that are compared
double lateness_of(const Ship& ship, std::span<const Channel> channels, SampleTimes times);

/// Rudder and propulsion of a run, worked out once for all ships whose rudder and propulsion do alike.
struct RunControls {
  RecordedControls recorded;  ///< with wind and depth
  std::vector<Controls<double>> at_samples;
  std::vector<Controls<double>> thirds;  ///< means of the thirds of the time before each sample but the first, or none
  RudderActuator actuator;
  ChannelError<double> rudder_record;
  ChannelError<double> wind_speed_record, wind_from_record;
  bool rudder_recorded, propulsion_recorded;  ///< what the recording tells is that of any ship
  double lateness;  ///< of the samples [s]: they show the ship, and have the controls, of so long ago; wind, and what
                    ///< acts for a time, are counted by the recorded times

  /// @param run    must outlive the controls
  /// @param finer  recording of the same run, if its samples are too few to tell the controls between them
  RunControls(const Ship& ship, const Recording& run, const Recording* finer, double lateness);

  /// Over a step of the filter on the way to sample k.
  Controls<double> in_step(const Recording& run, std::size_t k, double from, double to) const;

  /// By how much the rudder moves in it, as if evenly [rad]; 0 where it moves little from sample to sample.
  double rudder_moves(const Recording& run, std::size_t k, double from, double to) const;

  /// Those of another ship; nothing where they are the same.
  /// @param run, finer  that these were made of
  std::optional<RunControls> differing(const Ship& ship, const Recording& run, const Recording* finer,
                                       double lateness) const;
};

/// A filtered run, with what the smoother and residuals with the same gains need, unless it is not kept.
template <int N>
struct FilteredRun {
  bool kept = true;            ///< steps and innovations
  double outlying = HUGE_VAL;  ///< standard deviations beyond which a measurement is an outlier
  std::vector<Passed> passed;  ///< of the samples, and of times before and after them
  std::vector<Transition<N>> steps;
  std::vector<Reading> readings;           ///< of all channels, sample after sample
  std::vector<Innovation<N>> innovations;  ///< of each reading
  std::vector<FilterVector<N>> slopes;     ///< of channels that show no state alone
  /// Of each of `passed`, the times furthest from it that readings show before and after it, after it [s]; residuals
  /// keep them, for where another reading becomes the furthest their sum of squares has an edge.
  std::vector<std::array<double, 2>> shown;
  std::array<ChannelSums, channel_count> sums{};
  double tau = 0.0;  ///< memory of the unmodelled accelerations [s]
  std::shared_ptr<const RunControls> controls;
  std::size_t before = 0, after = 0;  ///< times that readings show before the first sample and after the last

  double log_likelihood() const { return passed.back().log_likelihood; }

  /// What each sample adds to it; the first has what is before the run, the last what is after it.
  std::vector<double> log_likelihoods() const {
    std::vector<double> of_samples;
    double told = 0.0;
    for (std::size_t k = before; k + after < passed.size(); ++k) {
      const auto last = k + after + 1 == passed.size() ? passed.size() - 1 : k;
      of_samples.push_back(passed[last].log_likelihood - std::exchange(told, passed[last].log_likelihood));
    }
    return of_samples;
  }

  /// Empty, with room for a run of so many samples; a step may be cut in several.
  void restart(std::size_t samples, std::size_t channels) {
    passed.clear(), shown.clear(), forget_steps();
    passed.reserve(samples);
    if (kept) steps.reserve(samples), innovations.reserve(samples * channels);
    sums = {};
  }

  void forget_steps() { steps.clear(), innovations.clear(), slopes.clear(); }
};

/// A ship with one unknown moved a little.
struct Neighbour {
  std::optional<Ship> ship;  ///< nothing where there can be none
  double step;               ///< of the unknown
};

template <int N>
class RunFilter {
 public:
  virtual ~RunFilter() = default;

  /// Filters the run.
  /// @param tell  if there is one, tell(k, estimate) after the measurements of each sample
  virtual void forward(const FilterNoise& noise, FilteredRun<N>& pass,
                       const std::function<void(std::size_t, const Gaussian<N>&)>& tell = {}) = 0;

  /// What comes after each sample, from the last to the first.
  /// @param tell  if there is one, tell(k, smoother) of each sample
  /// @return slopes of the log likelihood by the logarithms of the variances
  virtual FilterNoise backward(const FilterNoise& noise, const FilteredRun<N>& pass,
                               const std::function<void(std::size_t, const Smoother<N>&)>& tell = {}) const = 0;

  /// Innovations over their standard deviations, with the gains and the steps of a pass: of another ship what hers
  /// would be, of the same ship those of the pass.
  virtual void residuals(const FilteredRun<N>& pass, Eigen::Ref<Eigen::VectorXd> out) = 0;

  /// Derivatives of the residuals, a column for each neighbour.
  /// @param ship  that the filter was made of
  /// @return  whether each column was found: not that of a neighbour on whom other effects act or at other times, and
  ///          none on a ship with hidden states
  virtual std::vector<bool> slopes(const FilteredRun<N>& pass, const Ship& ship, std::span<const Neighbour> neighbours,
                                   Eigen::Ref<Eigen::MatrixXd> out) = 0;
};

/// Longest step of a filter where nothing else is asked, in ship lengths of way.
inline constexpr double usual_longest_step = 0.02;

/// @param run    must outlive the filter, as its channels
/// @param start  little is known of it
/// @param tau    memory of the unmodelled accelerations [s], or infinity
/// @param longest_step  in ship lengths of way
/// @param known  controls of a pass, used again where they serve
/// @param finer  recording of the same run that tells the controls between the samples; must outlive the filter
/// @throws Refusal  where one of her effects cannot act on her model
template <int N>
std::unique_ptr<RunFilter<N>> run_filter(const Ship& ship, const Recording& run, std::span<const Channel> channels,
                                         const ShipState<double>& start, double tau, SampleTimes times,
                                         double longest_step = usual_longest_step,
                                         std::shared_ptr<const RunControls> known = nullptr,
                                         const Recording* finer = nullptr);

}  // namespace swayaw::identification::detail
