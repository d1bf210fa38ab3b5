#pragma once

#include <cmath>
#include <optional>
#include <span>

/// Sums over samples of which some are missing. Not installed.
namespace swayaw::inline mismatch::detail {

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

/// First and last of contiguous values.
struct IndexRange {
  std::size_t first, last;
};

/// The contiguous values with the largest sum; nothing where no sum is positive.
inline std::optional<IndexRange> largest_sum(std::span<const double> values) {
  std::optional<IndexRange> found;
  double best = 0.0, now = 0.0;
  std::size_t start = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (now <= 0.0) now = 0.0, start = i;
    now += values[i];
    if (now > best) best = now, found = IndexRange{start, i};
  }
  return found;
}

}  // namespace swayaw::mismatch::detail
