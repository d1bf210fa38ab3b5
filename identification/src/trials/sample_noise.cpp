#include "sample_noise.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

namespace swayaw::inline identification::detail {
namespace {

// Level is a V that rises by less than 1.44 when m is doubled; where motion takes over before it is, the least rise
// tells the noise if it is less than 4. Noise with a memory ends at 1, motion alone begins at 1000. The mean over 300
// samples scatters by a tenth.
constexpr double level_rise = 1.44, least_rise = 4.0;

// V is looked at where 30 lags make the run: a zigzag of ten periods is smooth over that.
constexpr std::size_t lags_in_run = 30;

// E d² over gamma is what these leave of the correlations at m, 2m, … 5m, from the squares of 1, 5, 10, 10, 5, 1.
constexpr double white = 252.0;
constexpr std::array correlated{-420.0, 240.0, -90.0, 20.0, -2.0};

/// V(m), not less than rounding alone makes it.
class FifthDifferences {
 public:
  FifthDifferences(std::span<const double> values, double digit)
      : values_(values), least_(white * digit * digit / 12.0) {}

  double operator()(std::size_t m) const {
    // mean of the smaller three quarters of the squares: 0.3685 of the variance of normal noise
    constexpr double share = 0.75, of_variance = 0.3685;
    std::vector<double> squares;
    for (std::size_t i = 5 * m; i < values_.size(); ++i) squares.push_back(square_at(i, m));
    const auto kept = static_cast<std::ptrdiff_t>(share * static_cast<double>(squares.size()));
    if (kept == 0) return least_;
    std::nth_element(squares.begin(), squares.begin() + kept, squares.end());
    const double mean = std::accumulate(squares.begin(), squares.begin() + kept, 0.0) / static_cast<double>(kept);
    return std::max(mean / of_variance, least_);
  }

 private:
  double square_at(std::size_t i, std::size_t m) const {
    const auto x = [&](std::size_t k) { return values_[i - k * m]; };
    const double d = x(0) - x(5) - 5.0 * (x(1) - x(4)) + 10.0 * (x(2) - x(3));
    return d * d;
  }

  std::span<const double> values_;
  double least_;
};

/// 1 + 2 Σ rho_k, from V at all k below the first at which nothing is remembered.
double memory_of(const FifthDifferences& V, double gamma, std::size_t none_from) {
  std::vector<double> rho(5 * none_from, 0.0);
  double memory = 1.0;
  for (std::size_t k = none_from - 1; k > 0; --k) {
    // V(k)/gamma = 252 − 420 rho_k + 240 rho_2k − …
    double left = V(k) / gamma - white;
    for (std::size_t j = 1; j < correlated.size(); ++j) left -= correlated[j] * rho[(j + 1) * k];
    rho[k] = std::clamp(left / correlated[0], 0.0, 1.0);
    memory += 2.0 * rho[k];
  }
  return memory;
}

}  // namespace

double SampleNoise::of_mean(std::size_t n) const {
  const double count = static_cast<double>(n);
  double sum = 1.0;
  for (double k = 1.0; k < count && k <= static_cast<double>(reach()); ++k)
    sum += 2.0 * (1.0 - k / count) * correlation(k);
  return deviation * std::sqrt(sum / count);
}

Eigen::Matrix4d SampleNoise::covariance_of_sum(const Eigen::MatrixX4d& P) const {
  Eigen::Matrix4d sum = P.transpose() * P;
  for (Eigen::Index k = 1; k <= std::min(reach(), P.rows() - 1); ++k) {
    const Eigen::Matrix4d apart = P.topRows(P.rows() - k).transpose() * P.bottomRows(P.rows() - k);
    sum += correlation(static_cast<double>(k)) * (apart + apart.transpose());
  }
  return sum;
}

SampleNoise noise_of(std::span<const double> values, double digit) {
  const FifthDifferences V(values, digit);
  const double of_rounding = 1.5 * digit * digit / 12.0;
  double gamma = V(1) / white, last_rise = least_rise;
  std::size_t level_from = 0, none_from = 1;
  for (const std::size_t m : std::array<std::size_t, 11>{1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48}) {
    if (m > 1 && 2 * m * lags_in_run > values.size()) break;
    const double here = V(m), twice = V(2 * m), rise = here > 0.0 ? twice / here : least_rise;
    // behind the level of rounding there may be a higher one
    const bool open = level_from == 0 || (gamma <= of_rounding && twice > level_rise * white * gamma);
    if (open && rise < last_rise) {
      gamma = std::clamp(twice, here, 2.0 * here) / white;
      none_from = 2 * m;
      if (rise <= level_rise) level_from = m;
    }
    last_rise = std::clamp(rise, 1.001 * level_rise, least_rise);
  }
  // a bell of standard deviation w has V within 1.44 of level from m = 2.5 w on
  return {std::sqrt(gamma), memory_of(V, gamma, none_from), none_from > 2 ? 0.2 * static_cast<double>(none_from) : 0.0};
}

}  // namespace swayaw::identification::detail
