#pragma once

#include <cmath>
#include <span>

/// Sums over samples of which some are missing. Not installed.
namespace swayaw {

/// Count, sum and sum of squares of the samples that are there.
struct Sums {
  double count = 0.0;
  double sum = 0.0;
  double squares = 0.0;

  void add(double x) {
    if (std::isnan(x)) return;
    count += 1.0;
    sum += x;
    squares += x * x;
  }

  double mean() const { return count > 0.0 ? sum / count : 0.0; }
  double mean_square() const { return count > 0.0 ? squares / count : 0.0; }
  double rms() const { return std::sqrt(mean_square()); }
};

inline Sums sums_of(std::span<const double> values) {
  Sums sums;
  for (const double x : values) sums.add(x);
  return sums;
}

/// Root-mean-square distance from the mean.
inline double deviation(std::span<const double> values) {
  const double mean = sums_of(values).mean();
  Sums about_mean;
  for (const double x : values) about_mean.add(x - mean);
  return about_mean.rms();
}

}  // namespace swayaw
