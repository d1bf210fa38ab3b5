#include "derived_channels.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "run_motion.hpp"
#include "swayaw/core/detail/median.hpp"

namespace swayaw::inline identification::detail {
namespace {

/// Below this share of the noise of a source a difference from it cannot have been measured: two instruments differ by
/// more than the noise of either, one series made of the other by rounding.
constexpr double not_its_own = 0.3;

bool is_constant(std::span<const double> values) {
  const auto at = present(values);
  return std::ranges::all_of(at, [&](std::size_t i) { return values[i] == values[at.front()]; });
}

/// v = c + k r with nothing left but a share of what the noise of r makes in it.
bool is_made_of_yaw_rate(const Recording& run, Channel sway) {
  if (!run.has(Channel::r)) return false;
  const auto v = run[sway], r = run[Channel::r];
  double n = 0.0, sum_r = 0.0, sum_v = 0.0, rr = 0.0, rv = 0.0;
  const auto both = [&](std::size_t i) { return !std::isnan(v[i]) && !std::isnan(r[i]); };
  for (std::size_t i = 0; i < run.samples(); ++i)
    if (both(i)) n += 1.0, sum_r += r[i], sum_v += v[i], rr += r[i] * r[i], rv += r[i] * v[i];
  const double spread = rr - sum_r * sum_r / n;
  if (!(spread > 0.0)) return false;
  const double k = (rv - sum_r * sum_v / n) / spread, c = (sum_v - k * sum_r) / n;
  std::vector<double> left;
  for (std::size_t i = 0; i < run.samples(); ++i)
    if (both(i)) left.push_back(v[i] - c - k * r[i]);
  return core::detail::median_size_of(std::move(left)) < not_its_own * std::abs(k) * white_noise_of(r);
}

/// Difference of positions over time from sample i − back to i + ahead.
struct Difference {
  std::size_t back, ahead;
};

/// u cos psi − v sin psi and u sin psi + v cos psi against slopes of x and y. Of slopes the white noise s of positions
/// makes   √2 s/(t₂ − t₁).
bool is_made_of_positions(const Recording& run, Channel surge, Channel sway) {
  if (!run.has(Channel::x) || !run.has(Channel::y)) return false;
  const auto x = run[Channel::x], y = run[Channel::y], psi = run[Channel::psi], u = run[surge], v = run[sway];
  const double noise = std::min(white_noise_of(x), white_noise_of(y));
  for (const auto& [back, ahead] : std::array{Difference{1, 1}, Difference{1, 0}, Difference{0, 1}}) {
    std::vector<double> left;
    for (std::size_t i = back; i + ahead < run.samples(); ++i) {
      const double h = run.time[i + ahead] - run.time[i - back];
      const double ahead_x = (x[i + ahead] - x[i - back]) / h, ahead_y = (y[i + ahead] - y[i - back]) / h;
      const double off = std::hypot(ahead_x - u[i] * std::cos(psi[i]) + v[i] * std::sin(psi[i]),
                                    ahead_y - u[i] * std::sin(psi[i]) - v[i] * std::cos(psi[i]));
      if (!std::isnan(off)) left.push_back(off * h / std::sqrt(2.0));
    }
    if (!left.empty() && core::detail::median_size_of(std::move(left)) < not_its_own * noise) return true;
  }
  return false;
}

}  // namespace

std::optional<std::string> sway_made_of(const Recording& run, Channel surge, Channel sway) {
  if (!run.has(sway)) return {};
  if (is_constant(run[sway])) return fmt::format("a constant, {:.3g} m/s", run[sway][present(run[sway]).front()]);
  if (is_made_of_yaw_rate(run, sway)) return "the yaw rate";
  if (run.has(surge) && is_made_of_positions(run, surge, sway)) return "the slope of the positions";
  return {};
}

}  // namespace swayaw::identification::detail
