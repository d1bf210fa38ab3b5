#include "run_motion.hpp"

#include <algorithm>
#include <boost/math/statistics/linear_regression.hpp>
#include <cmath>

#include "swayaw/core/detail/median.hpp"

namespace swayaw::inline identification::detail {

double usual_step(const std::vector<double>& time) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < time.size(); ++i) steps.push_back(time[i] - time[i - 1]);
  return core::detail::median_of(std::move(steps));
}

double longest_line(const std::vector<double>& time) {
  constexpr double steps = 10.0, seconds = 5.0;
  return std::max(seconds, steps * usual_step(time));
}

std::vector<double> gaps_of(const Recording& run, Channel channel) {
  const double limit = longest_line(run.time);
  const auto values = run[channel];
  std::vector<double> gaps(run.samples(), 0.0);
  double last = run.time.front();
  for (std::size_t i = 0; i < run.samples(); ++i) {
    if (std::isnan(values[i])) continue;
    if (run.time[i] - last > limit) gaps[i] = run.time[i] - last;
    last = run.time[i];
  }
  return gaps;
}

std::vector<std::size_t> present(std::span<const double> values) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isnan(values[i])) places.push_back(i);
  return places;
}

std::vector<double> filled(const Recording& run, Channel channel) {
  const Interpolant known(run, channel);
  const auto times = known.times(), values = known.values();
  std::vector<double> result(run.samples());
  std::size_t k = 0;
  for (std::size_t i = 0; i < run.samples(); ++i) {
    while (k + 1 < times.size() && times[k + 1] <= run.time[i]) ++k;
    const bool between = k + 1 < times.size() && times[k] < run.time[i];
    const double share = between ? (run.time[i] - times[k]) / (times[k + 1] - times[k]) : 0.0;
    result[i] = between ? values[k] + share * (values[k + 1] - values[k]) : values[k];
  }
  return result;
}

std::vector<double> at_times(const std::vector<double>& time, const std::vector<double>& values,
                             const std::vector<double>& at) {
  std::vector<double> result(at.size());
  std::size_t k = 0;
  for (std::size_t i = 0; i < at.size(); ++i) {
    while (k + 2 < time.size() && time[k + 1] <= at[i]) ++k;
    while (k > 0 && time[k] > at[i]) --k;
    const double share = (at[i] - time[k]) / (time[k + 1] - time[k]);  // drawn on beyond the ends
    result[i] = values[k] + share * (values[k + 1] - values[k]);
  }
  return result;
}

std::vector<double> integral(const std::vector<double>& time, const std::vector<double>& f) {
  std::vector<double> sum(f.size(), 0.0);
  for (std::size_t i = 1; i < f.size(); ++i) sum[i] = sum[i - 1] + 0.5 * (f[i] + f[i - 1]) * (time[i] - time[i - 1]);
  return sum;
}

std::vector<double> smooth_integral(const std::vector<double>& time, const std::vector<double>& f,
                                    const std::vector<double>& f_dot) {
  auto sum = integral(time, f);
  double correction = 0.0;
  for (std::size_t i = 1; i < f.size(); ++i) {
    const double h = time[i] - time[i - 1];
    correction += h * h / 12.0 * (f_dot[i] - f_dot[i - 1]);
    sum[i] -= correction;
  }
  return sum;
}

std::vector<double> slope(const std::vector<double>& time, const std::vector<double>& f) {
  std::vector<double> result(f.size(), 0.0);
  for (std::size_t i = 0; i < f.size(); ++i) {
    const std::size_t before = i > 0 ? i - 1 : 0, after = std::min(i + 1, f.size() - 1);
    result[i] = (f[after] - f[before]) / (time[after] - time[before]);
  }
  return result;
}

std::vector<double> yaw_rate(const Recording& run) {
  return run.has(Channel::r) ? filled(run, Channel::r) : slope(run.time, filled(run, Channel::psi));
}

double hard_yaw_rate(const Recording& run) {
  constexpr double least = 1e-6;
  auto r = yaw_rate(run);
  for (double& x : r) x = std::abs(x);
  const auto place = r.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(r.size() - 1));
  std::ranges::nth_element(r, place);
  return std::max(*place, least);
}

namespace {

/// Whether a heading stays on one course.
bool stays(const std::vector<double>& psi) {
  constexpr double little = 0.35;  // [rad]
  const auto [low, high] = std::ranges::minmax(psi);
  return high - low < little;
}

}  // namespace

bool is_straight(const Recording& run) { return stays(filled(run, Channel::psi)); }

bool turns_like_a_zero(const Recording& run, double largest) {
  if (is_straight(run)) return true;
  if (hard_yaw_rate(run) > largest) return false;
  auto psi = filled(run, Channel::psi);
  const auto [start, rate] = boost::math::statistics::simple_ordinary_least_squares(run.time, psi);
  for (std::size_t i = 0; i < psi.size(); ++i) psi[i] -= start + rate * run.time[i];
  return stays(psi);
}

double rms(const std::vector<double>& f) {
  double sum = 0.0;
  for (const double x : f) sum += x * x;
  return f.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(f.size()));
}

}  // namespace swayaw::identification::detail
