#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "swayaw/core/channel.hpp"

namespace swayaw::inline core {

/// Stands for a missing sample.
inline constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// A run key that only other programs understand, as written in the file.
struct RunRemark {
  std::string key;
  std::string value;  ///< TOML
};

/// A column that swayaw does not understand, as written in the file.
struct ExtraColumn {
  std::string name;
  std::vector<std::string> cells;  ///< text, one for each sample
};

/// What is known of a run besides its samples.
struct RunFacts {
  std::string manoeuvre;              ///< "zigzag 10/10", "turn 35", free text; empty if not said
  std::optional<double> execute;      ///< time of the first rudder order [s]
  std::optional<double> water_depth;  ///< [m]
  std::vector<RunRemark> remarks;
};

/// Samples of a ship in motion, recorded at sea, in a tank or by a simulation.
///
/// SI, radians, rudder positive to port, position and velocity of midship, heading unwrapped.
/// Time increases strictly; sampling may be irregular; a missing sample is NaN.
struct Recording {
  std::string name;  ///< file name, or what made it
  RunFacts facts;
  std::vector<double> time;                                 ///< [s]
  std::array<std::vector<double>, channel_count> channels;  ///< empty, or as long as `time`
  std::vector<ExtraColumn> extra;

  std::size_t samples() const { return time.size(); }

  /// Whether the channel has at least one sample.
  bool has(Channel channel) const;

  /// Samples of a channel; empty if it was not recorded.
  std::span<const double> operator[](Channel channel) const { return channels[index_of(channel)]; }

  /// Samples of a channel to be filled, missing at first.
  std::span<double> fill(Channel channel);
};

/// Those of `among` that some run has, in their order; of a list of wanted ones no others.
std::vector<Channel> recorded_channels(std::span<const Recording> runs, std::span<const Channel> among,
                                       std::span<const Channel> wanted = {});

/// Standard deviation of the white noise on samples that change slowly otherwise, from the median of their third
/// differences: robust against motion and outliers. 0 where fewer than ten tell it.
double white_noise_of(std::span<const double> values);

/// Samples of a channel joined by straight lines, across missing samples too.
/// Before the first and after the last sample the value is held.
class Interpolant {
 public:
  /// @throws Refusal  if all samples are missing
  Interpolant(const Recording& recording, Channel channel);

  double operator()(double time) const;

  std::span<const double> times() const { return time_; }
  std::span<const double> values() const { return value_; }

 private:
  std::vector<double> time_;
  std::vector<double> value_;
};

}  // namespace swayaw::core
