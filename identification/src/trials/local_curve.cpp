#include "local_curve.hpp"

#include <algorithm>
#include <cmath>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/detail/matrices.hpp"

namespace swayaw::inline identification::detail {
namespace {

// Intervals of so many standard errors must have a point in common. Over 240 simulated zigzags and turns of all models
// (trial_intervals_test) 0.7 keeps the true index within two of the stated standard errors in 90 to 99 % of the
// cases, smoothed by the instrument or not; 0.8 in 88 % of the worst index where it is smoothed, 1.5 in 72 %.
constexpr double agreement = 0.7;

// The slope of the widest cubic that agrees is off by more than its noise, since the yaw acceleration jumps where the
// rudder stops: over the same cases by this factor.
constexpr double slope_bias = 2.6;

constexpr std::size_t fewest_samples = 5, most_samples = 400;  // of a cubic

/// Smallest step between two different values, 0 for one value alone.
double smallest_step(std::vector<double> values) {
  std::ranges::sort(values);
  const double nothing = 1e-9 * (values.back() - values.front());
  double step = forever;
  for (std::size_t i = 1; i < values.size(); ++i)
    if (const double d = values[i] - values[i - 1]; d > nothing) step = std::min(step, d);
  return std::isfinite(step) ? step : 0.0;
}

/// Samples first … last − 1.
struct Window {
  std::size_t first, last;
  std::size_t size() const { return last - first; }
};

/// The `count` samples nearest to a time among those of `all`.
Window nearest(const Samples& s, double at, std::size_t count, const Window& all) {
  Window w{std::clamp(s.index_at(at), all.first, all.last), 0};
  w.last = w.first;
  while (w.size() < count) {
    const bool left = w.last == all.last || (w.first > all.first && at - s.time[w.first - 1] < s.time[w.last] - at);
    if (left) --w.first;
    else ++w.last;
  }
  return w;
}

Eigen::Vector4d powers(double z) { return {1.0, z, z * z, z * z * z}; }

/// What rounding to a digit q leaves in a mean over samples spread by sigma: up to q/π exp(−2 π² sigma²/q²), from
/// noise, whose own rounding is q²/12 of it, and from a change of the quantity by ±way over the window.
/// Source: [Widrow2008] section 4
double rounding_left(const Samples& s, double way) {
  const double q = s.digit;
  if (!(q > 0.0)) return 0.0;
  const double spread = std::max(s.noise.deviation * s.noise.deviation - q * q / 12.0, 0.0) + way * way / 3.0;
  return q / (std::sqrt(2.0) * pi) * std::exp(-2.0 * pi * pi * spread / (q * q));
}

/// Variance of what is left of the samples beside a curve: that of the noise, or what there is more, as in waves; for
/// longer where samples are off alike that are a memory of the noise apart, by (1 + rho)/(1 − rho).
double variance_left(const std::vector<double>& off, const SampleNoise& noise, double unknowns) {
  const auto apart = static_cast<std::size_t>(std::lround(noise.memory));
  double squares = 0.0, products = 0.0;
  for (std::size_t i = 0; i < off.size(); ++i) {
    squares += off[i] * off[i];
    if (i >= apart) products += off[i] * off[i - apart];
  }
  const double rho = squares > 0.0 ? std::clamp(products / squares, 0.0, 0.98) : 0.0;
  const double scatter = squares / (static_cast<double>(off.size()) - unknowns) * (1.0 + rho) / (1.0 - rho);
  return std::max(noise.deviation * noise.deviation, scatter);
}

LocalCubic fitted(const Samples& s, double at, const Window& w) {
  const double unit = std::max(at - s.time[w.first], s.time[w.last - 1] - at);
  Eigen::MatrixX4d P(static_cast<Eigen::Index>(w.size()), 4);
  for (std::size_t i = 0; i < w.size(); ++i)
    P.row(static_cast<Eigen::Index>(i)) = powers((s.time[w.first + i] - at) / unit);
  const Eigen::Map<const Eigen::VectorXd> x(s.value.data() + w.first, P.rows());
  // c = (PᵀP)⁻¹ Pᵀ x, cov c = (PᵀP)⁻¹ (Σ rho p pᵀ) (PᵀP)⁻¹ sigma²
  const Eigen::Matrix4d inverse = core::detail::inverse(P.transpose() * P);
  LocalCubic cubic{.centre = at, .unit = unit, .c = inverse * (P.transpose() * x), .covariance = inverse};
  if (s.noise.reach() > 0) cubic.covariance = inverse * s.noise.covariance_of_sum(P) * inverse;
  double variance = s.noise.deviation * s.noise.deviation;
  if (w.size() > 8) {
    const Eigen::VectorXd off = x - P * cubic.c;
    variance = variance_left({off.begin(), off.end()}, s.noise, 4.0);
  }
  cubic.covariance *= variance;
  cubic.rounding = rounding_left(s, cubic.slope(at).value * unit);
  return cubic;
}

Window between(const Samples& s, double from, double to) {
  const auto last = std::ranges::upper_bound(s.time, to);
  const auto end = static_cast<std::size_t>(last - s.time.begin());
  return {std::min(s.index_at(from), end), end};
}

/// w²/2 of the bell that smoothed the samples.
double blur_of(const Samples& s, const LocalCubic& about) {
  if (!(s.noise.bell > 0.0)) return 0.0;
  const auto w = between(s, about.centre - about.unit, about.centre + about.unit);
  const double step = (s.time[w.last - 1] - s.time[w.first]) / static_cast<double>(w.size() - 1);
  return 0.5 * s.noise.bell * s.noise.bell * step * step;
}

/// Intervals that must have a point in common.
struct Agreement {
  double low = -forever, high = forever;

  bool takes(const Told& x) {
    low = std::max(low, x.value - agreement * x.standard_error);
    high = std::min(high, x.value + agreement * x.standard_error);
    return low <= high;
  }
};

std::size_t larger(std::size_t count) { return std::max(count + 1, count * 7 / 5); }

}  // namespace

double together(double a, double b, double c) { return std::sqrt(a * a + b * b + c * c); }

std::size_t Samples::index_at(double t) const {
  return static_cast<std::size_t>(std::ranges::lower_bound(time, t) - time.begin());
}

Samples samples_of(std::vector<double> time, std::vector<double> value) {
  if (value.empty()) return {};
  const double digit = smallest_step(value);
  const auto noise = noise_of(value, digit);
  return {std::move(time), std::move(value), noise, digit};
}

Samples samples_of(const Recording& run, Channel channel) {
  if (!run.has(channel)) return {};
  const Interpolant joined(run, channel);
  return samples_of({joined.times().begin(), joined.times().end()}, {joined.values().begin(), joined.values().end()});
}

Told LocalCubic::value(double t) const {
  const auto p = powers((t - centre) / unit);
  return {c.dot(p), together(std::sqrt(p.dot(covariance * p)), rounding, blur * curvature(t))};
}

Told LocalCubic::slope(double t) const {
  const double z = (t - centre) / unit;
  const Eigen::Vector4d p = Eigen::Vector4d(0.0, 1.0, 2.0 * z, 3.0 * z * z) / unit;
  const double bend = 6.0 * c[3] / (unit * unit * unit);  // d³x/dt³
  return {c.dot(p), together(std::sqrt(p.dot(covariance * p)), rounding / unit, blur * bend)};
}

double LocalCubic::curvature(double t) const { return (2.0 * c[2] + 6.0 * c[3] * (t - centre) / unit) / (unit * unit); }

std::optional<LocalCubic> local_cubic(const Samples& s, double at, double from, double to) {
  const auto all = between(s, from, to);
  if (all.size() < fewest_samples) return std::nullopt;
  auto best = fitted(s, at, nearest(s, at, fewest_samples, all));
  Agreement value, slope;
  value.takes(best.value(at));
  slope.takes(best.slope(at));
  for (std::size_t n = larger(fewest_samples); n <= std::min(most_samples, all.size()); n = larger(n)) {
    const auto wider = fitted(s, at, nearest(s, at, n, all));
    if (!value.takes(wider.value(at)) || !slope.takes(wider.slope(at))) break;
    best = wider;
  }
  best.blur = blur_of(s, best);
  return best;
}

MaybeTold value_at(const Samples& s, double at, double from, double to) {
  const auto cubic = local_cubic(s, at, from, to);
  return cubic ? std::optional(cubic->value(at)) : std::nullopt;
}

MaybeTold level_before(const Samples& s, double from, double to) {
  const auto all = between(s, from, to);
  if (all.size() < 3) return std::nullopt;
  Agreement so_far;
  MaybeTold best;
  double sum = 0.0;
  for (std::size_t n = 1; n <= all.size(); ++n) {
    sum += s.value[all.last - n];
    const Told mean{sum / static_cast<double>(n), std::hypot(s.noise.of_mean(n), rounding_left(s, 0.0))};
    if (n < 3) continue;
    if (!so_far.takes(mean)) break;
    best = mean;
  }
  return best;
}

MaybeTold passage(const Samples& s, double level, double sign, double from, double to) {
  const auto all = between(s, from, to);
  const auto beyond = [&](std::size_t i) { return sign * (s.value[i] - level) >= 0.0; };
  std::size_t i = all.first;
  while (i < all.last && beyond(i)) ++i;
  while (i < all.last && !beyond(i)) ++i;
  if (i >= all.last || i == 0) return std::nullopt;
  const double share = (level - s.value[i - 1]) / (s.value[i] - s.value[i - 1]);
  double t = s.time[i - 1] + share * (s.time[i] - s.time[i - 1]);
  double error = missing;
  for (int k = 0; k < 3; ++k) {
    const auto cubic = local_cubic(s, t);
    if (!cubic) return std::nullopt;
    const auto value = cubic->value(t), slope = cubic->slope(t);
    if (!(sign * slope.value > 0.0)) break;
    t = std::clamp(t + (level - value.value) / slope.value, s.time[i - 1] - cubic->unit, s.time[i] + cubic->unit);
    error = value.standard_error / std::abs(slope.value);
  }
  if (std::isnan(error)) error = s.time[i] - s.time[i - 1];
  return Told{t, error};
}

std::optional<Peak> peak(const Samples& s, double sign, double from, double to) {
  const auto all = between(s, from, to);
  if (all.size() < fewest_samples) return std::nullopt;
  std::size_t top = all.first;
  for (std::size_t i = all.first; i < all.last; ++i)
    if (sign * s.value[i] > sign * s.value[top]) top = i;
  if (top < all.first + 2 || top + 3 > all.last) return std::nullopt;
  double t = s.time[top];
  std::optional<Peak> result;
  for (int k = 0; k < 4; ++k) {
    const auto cubic = local_cubic(s, t);
    if (!cubic) return std::nullopt;
    const double curvature = cubic->curvature(t);
    if (!(sign * curvature < 0.0)) break;
    t = std::clamp(t - cubic->slope(t).value / curvature, t - cubic->unit, t + cubic->unit);
    result = {{t, slope_bias * cubic->slope(t).standard_error / std::abs(cubic->curvature(t))}, cubic->value(t)};
  }
  if (result) return result;
  const double dt = s.time[top + 1] - s.time[top - 1];
  return Peak{{s.time[top], dt}, {s.value[top], s.noise.deviation}};
}

std::optional<Line> line_over(const Samples& s, double from, double to) {
  const auto w = between(s, from, to);
  const double n = static_cast<double>(w.size());
  if (w.size() < 4) return std::nullopt;
  double t = 0.0, x = 0.0, tt = 0.0, tx = 0.0;
  for (std::size_t i = w.first; i < w.last; ++i) t += s.time[i] / n, x += s.value[i] / n;
  for (std::size_t i = w.first; i < w.last; ++i) {
    tt += (s.time[i] - t) * (s.time[i] - t);
    tx += (s.time[i] - t) * (s.value[i] - x);
  }
  const double slope = tx / tt;
  std::vector<double> off;
  for (std::size_t i = w.first; i < w.last; ++i) off.push_back(s.value[i] - x - slope * (s.time[i] - t));
  const double variance = s.noise.memory * variance_left(off, s.noise, 2.0);
  return Line{{x, std::sqrt(variance / n)}, {slope, std::sqrt(variance / tt)}};
}

}  // namespace swayaw::identification::detail
