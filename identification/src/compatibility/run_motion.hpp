#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "swayaw/core/recording.hpp"

/// Samples of a run made ready for kinematics.
namespace swayaw::inline identification::detail {

/// Middle of the times between samples [s].
double usual_step(const std::vector<double>& time);

/// Time since the sample before; 0 of the first [s].
inline double step_before(const std::vector<double>& time, std::size_t i) {
  return i > 0 ? time[i] - time[i - 1] : 0.0;
}

/// A ship's motion is on straight lines for no longer [s].
double longest_line(const std::vector<double>& time);

/// For each sample of the run the time without the channel that ends there, where it is too long to be integrated
/// across as if nothing happened [s]; 0 elsewhere.
std::vector<double> gaps_of(const Recording& run, Channel channel);

/// Where values are not missing.
std::vector<std::size_t> present(std::span<const double> values);

/// The channel at every sample, by straight lines across missing ones.
std::vector<double> filled(const Recording& run, Channel channel);

/// Values at a series of increasing times, at other times, by straight lines, drawn on beyond the ends. Linear in the
/// samples where the other times increase, too, but for some jumps.
std::vector<double> at_times(const std::vector<double>& time, const std::vector<double>& values,
                             const std::vector<double>& at);

/// ∫ f dt from the first sample, by trapezoids.
std::vector<double> integral(const std::vector<double>& time, const std::vector<double>& f);

/// The same of a smooth f, by Euler and Maclaurin: less   h² (f'(t_i) − f'(t_{i−1}))/12   in each step h.
std::vector<double> smooth_integral(const std::vector<double>& time, const std::vector<double>& f,
                                    const std::vector<double>& f_dot);

/// df/dt by central differences.
std::vector<double> slope(const std::vector<double>& time, const std::vector<double>& f);

/// Recorded, or the slope of the heading, at every sample [rad/s].
std::vector<double> yaw_rate(const Recording& run);

/// Yaw rate that the ship exceeds in a twentieth of the time [rad/s]; more than zero.
double hard_yaw_rate(const Recording& run);

/// A run on one course, within 20 deg.
bool is_straight(const Recording& run);

/// A run whose turning might as well be a zero of its gyro: on one course, within 20 deg, or in one steady turn that is
/// no faster than such a zero may be.
/// @param largest  zero of a gyro [rad/s]
bool turns_like_a_zero(const Recording& run, double largest);

double rms(const std::vector<double>& f);

}  // namespace swayaw::identification::detail
