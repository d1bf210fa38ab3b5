#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "swayaw/core/recording.hpp"

/// Instruments judged by kinematics alone, before any ship is: data compatibility, as aircraft identification has it.
///
///     ẋ = u cos psi − v sin psi,    ẏ = u sin psi + v cos psi,    dpsi/dt = r
///
/// hold for every ship. What breaks them is an error of an instrument, of a clock or of a file.
/// Source: [Klein2006] chapter 10
namespace swayaw::inline identification {

/// What an instrument, a clock or a column does wrong. c is the channel, c₀ the truth.
enum class InstrumentErrorKind {
  unit,         ///< c = value c₀: a column in another unit than its name says
  sign,         ///< c = −c₀; of y: positive to port; of the rudder: positive to the other side
  order,        ///< the column is the order, not the angle; value: the rate that the angle would need [rad/s]
  zero,         ///< c = c₀ + value
  scale,        ///< c = (1 + value) c₀
  delay,        ///< c(t) = c₀(t − value) [s]
  clock,        ///< c's clock wanders: standard deviation of its error after a minute [s]
  clock_rate,   ///< c's clock loses `value` seconds in each: c(t) = c₀(t − value t)
  jump,         ///< from `at` on c is late by `value` more [s]
  smoothing,    ///< c is the mean of c₀ over value [s]
  axes,         ///< velocity axes turned to starboard against the heading, or the heading low by the same [rad]
  lever_arm_x,  ///< the positions are of a point this far forward of midship [m]
  lever_arm_y,  ///< the same to starboard [m]
};

/// One error of one channel.
struct InstrumentError {
  Channel channel;
  InstrumentErrorKind kind;
  double value;
  double standard_error;
  bool told = false;               ///< larger than what chance makes of none, and than what matters
  double at = 0.0;                 ///< of a jump, on the run's clock [s]
  double at_standard_error = 0.0;  ///< [s]
  /// What a lateness may be, where several things look alike: "delay", "one-sided mean", "first-order lag" of a yaw
  /// rate; "positions early", "velocities over ground late" …
  std::vector<std::string_view> readings = {};
};

/// Name in JSON, "delay".
std::string_view name_of(InstrumentErrorKind kind);

/// "s", "rad", "rad/s", "m", "m/s" or "" of the value.
std::string_view unit_of(const InstrumentError& error);

/// Whether no number of the run can be believed before it is mended: sign, unit, order.
bool is_mistake(InstrumentErrorKind kind);

/// What the samples of a channel are like.
struct ChannelCharacter {
  Channel channel;
  std::size_t samples = 0;            ///< with a value
  double step = 0.0;                  ///< of rounding; 0 if none is seen
  double noise = 0.0;                 ///< standard deviation of the white part
  double interval = 0.0;              ///< mean time between samples that were measured [s]
  bool interpolated = false;          ///< samples between fixes are on straight lines
  std::vector<std::size_t> outliers;  ///< single samples, or samples of one fix, far from their neighbours
  std::vector<std::size_t> measured;  ///< neither missing nor an outlier nor on a straight line between fixes
};

/// Samples of a channel that were really measured, as their places in the run: without those that are missing, without
/// outliers, and, where a file joins fixes by straight lines, the fixes alone. Only they tell something; errors of all
/// others are those of their neighbours. Where such a line is level, every sample counts as measured.
///
/// @return ascending; empty if the run has no such channel. n log n of the samples
std::vector<std::size_t> measured_samples_of(const Recording& run, Channel channel);

/// The run with outliers of the channels that show the motion missing, as a wrong fix of the satellites: one, that was
/// interpolated to the times of the file, shows in two samples. What goes on from a recorded state would take it up.
Recording without_outliers(Recording run);

/// A channel that was not measured, and what it was made of: "a constant, 0 m/s", "the yaw rate", "the slope of the
/// positions". It tells nothing, and the check leaves it out.
struct DerivedChannel {
  Channel channel;
  std::string made_of;
};

/// What was found in one run.
struct RunCheck {
  std::string run;
  std::string group;  ///< as group_of has it
  std::vector<ChannelCharacter> channels;
  std::vector<InstrumentError> errors;  ///< those that could be told, and those that could not: `told`
  std::vector<DerivedChannel> derived;
  std::vector<double> gaps;              ///< begin, end, begin, end … without samples [s]
  std::vector<std::string> cannot_tell;  ///< what this run has no channels or no motion for, one line each

  /// The first that forbids to believe the run.
  const InstrumentError* mistake() const;
};

/// That a check needs.
inline constexpr std::size_t samples_for_check = 20;

/// Checks one run. Linear in the number of samples, but for sorting.
///
/// @throws Refusal  if it has fewer than `samples_for_check`
RunCheck check_run(const Recording& run);

/// Errors of instruments that several runs have in common: the mean by information, its standard error not less than
/// the scatter of the runs allows. A jump of a clock is of its run alone.
std::vector<InstrumentError> pooled(std::span<const RunCheck> runs);

/// Runs with instruments, loading and surroundings in common: those with the same `group`; without that key, those of
/// the same day by `start_utc`; without either, all.
///
/// @return the text of the group, the day as 2022-10-27, or nothing
std::string group_of(const Recording& run);

/// What the runs of a group have in common.
struct GroupCheck {
  std::string group;
  std::vector<std::string> runs;
  std::vector<InstrumentError> errors;  ///< pooled
};

/// Groups in the order of their first runs.
std::vector<GroupCheck> grouped(std::span<const RunCheck> runs);

/// Runs that were cut from one log: on one clock, with the same samples where they overlap, as some do. What a clock
/// that wanders hides in each of them, the way made good of all may tell.
///
/// @return nothing if they are not from one log
std::optional<Recording> joined(std::span<const Recording> runs);

/// The run without the errors that were told, and without outliers. Clocks are set right by straight lines between
/// samples; a smoothed channel stays as it is.
Recording repaired(const Recording& run, const RunCheck& check);

/// "yaw rate: zero 0.031 ± 0.002 deg/s"
std::string words_for(const InstrumentError& error);

/// What to do about a mistake: the key, column or option that mends it; empty for others.
std::string remedy_for(const InstrumentError& error);

}  // namespace swayaw::identification
