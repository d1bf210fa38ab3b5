#pragma once

#include <Eigen/Core>
#include <cmath>
#include <span>

#include "swayaw/core/angle.hpp"

/// Noise on the samples of a channel: how large it is, and for how many samples it remembers.
namespace swayaw::inline identification::detail {

/// Noise as a smoothing filter leaves it, its correlation k samples apart a bell: rho_k = exp(−π k²/memory²).
struct SampleNoise {
  double deviation = 0.0;  ///< standard deviation on a sample
  double memory = 1.0;     ///< samples that say as much of a mean as one would alone, 1 + 2 Σ rho_k; 1 of white noise
  double bell = 0.0;       ///< standard deviation of the weights of the filter, 0 for none [samples]

  double correlation(double k) const { return std::exp(-pi * k * k / (memory * memory)); }

  /// Samples after which nothing is remembered, rho < 0.001; 0 of white noise.
  Eigen::Index reach() const { return memory > 1.0 ? static_cast<Eigen::Index>(1.49 * memory) : 0; }

  /// Standard deviation of the mean of so many samples: √((1 + 2 Σ (1 − k/n) rho_k)/n) of that on one.
  double of_mean(std::size_t n) const;

  /// Σ_i Σ_k rho_|i−k| p_i p_kᵀ over the rows of P, the covariance of Pᵀ e for a unit of noise.
  Eigen::Matrix4d covariance_of_sum(const Eigen::MatrixX4d& P) const;
};

/// From differences of fifth order between samples m apart, robust against motion by the smaller three quarters of
/// their squares:
///
///     d = x_i − 5 x_{i−m} + 10 x_{i−2m} − 10 x_{i−3m} + 5 x_{i−4m} − x_{i−5m}
///     V(m) = E d² = gamma (252 − 420 rho_m + 240 rho_2m − 90 rho_3m + 20 rho_4m − 2 rho_5m)
///
/// V is the same at all m for white noise; behind a filter it rises until m is beyond its memory and is level there;
/// motion, m¹⁰, never is. So gamma is told by the first m from which V is level, or rises least, and its correlations
/// by V below that. Noise whose V always rises counts as white.
///
/// @param digit  of the values: the noise is not smaller than that of rounding, digit²/12
SampleNoise noise_of(std::span<const double> values, double digit);

}  // namespace swayaw::identification::detail
