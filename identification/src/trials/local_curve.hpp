#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <vector>

#include "sample_noise.hpp"
#include "swayaw/identification/trial.hpp"

/// Numbers between samples, with their standard errors.
namespace swayaw::inline identification::detail {

inline constexpr double forever = std::numeric_limits<double>::infinity();

/// Samples of a quantity, without the missing ones, and the noise on them.
struct Samples {
  std::vector<double> time, value;
  SampleNoise noise;
  double digit = 0.0;  ///< smallest step between two different values

  std::size_t size() const { return time.size(); }

  /// First sample not before that time.
  std::size_t index_at(double t) const;
};

/// Noise by third differences, not less than rounding to q makes it, q/√12; q is the smallest step.
Samples samples_of(std::vector<double> time, std::vector<double> value);
Samples samples_of(const Recording& run, Channel channel);

/// √(a² + b² + c²) of standard errors.
double together(double a, double b, double c = 0.0);

/// A cubic in (t − centre)/unit, by least squares.
struct LocalCubic {
  double centre, unit;
  Eigen::Vector4d c;
  Eigen::Matrix4d covariance;
  double rounding = 0.0;  ///< error of the last digit that stays however many samples are taken
  double blur = 0.0;  ///< half the variance of the bell that smoothed the samples [s²]: moves them by blur d²x/dt²

  Told value(double t) const;
  Told slope(double t) const;
  double curvature(double t) const;
};

/// The cubic about a time, over the samples nearest to it in [from, to]: as many as agree. The window grows from five
/// samples while the intervals of 0.7 standard errors about its values, and about its slopes, still have a
/// point in common (intersection of confidence intervals), so that its noise is small and its bias not larger than
/// that.
///
/// Source: [Goldenshluger1997]
/// @return nothing where there are fewer than five samples
std::optional<LocalCubic> local_cubic(const Samples& samples, double at, double from = -forever, double to = forever);

/// Value at a time.
MaybeTold value_at(const Samples& samples, double at, double from = -forever, double to = forever);

/// Mean of the samples in [from, to] nearest to `to` that agree, by the same rule; nothing without three.
MaybeTold level_before(const Samples& samples, double from, double to);

/// First time in [from, to] at which the value passes `level`, rising if `sign` > 0, else falling.
MaybeTold passage(const Samples& samples, double level, double sign, double from, double to);

struct Peak {
  Told time, value;
};

/// The largest of sign × value inside (from, to); nothing where it lies at an end.
std::optional<Peak> peak(const Samples& samples, double sign, double from, double to);

/// Straight line by least squares over [from, to].
struct Line {
  Told value;  ///< in the middle, the mean
  Told slope;
};

/// @return nothing with fewer than four samples. The standard errors are of the scatter about the line, lengthened
/// where successive samples are off alike.
std::optional<Line> line_over(const Samples& samples, double from, double to);

}  // namespace swayaw::identification::detail
