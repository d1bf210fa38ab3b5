#include "swayaw/linear/frequency_response.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "swayaw/core/refusal.hpp"

namespace swayaw::inline linear {
namespace {

/// Largest root of x² + b x + c, if real.
std::optional<double> largest_root(double b, double c) {
  const double discriminant = b * b - 4.0 * c;
  if (discriminant < 0.0) return std::nullopt;
  // larger magnitude first to avoid cancellation
  const double far = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
  return far == 0.0 ? 0.0 : std::max(far, c / far);
}

/// Root of an increasing or decreasing function between two places with opposite signs, to the last digit.
template <class F>
double root_between(const F& f, double low, double high) {
  const bool rising = f(high) > 0.0;
  for (int i = 0; i < 2000; ++i) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) break;
    ((f(middle) > 0.0) == rising ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

/// Largest positive root of x³ + a x² + b x − c for c > 0: there is one, since the value at 0 is negative.
double largest_root(double a, double b, double c) {
  const auto f = [&](double x) { return ((x + a) * x + b) * x - c; };
  const double above_all = 1.0 + std::max({std::abs(a), std::abs(b), c});  // Cauchy's bound
  const double discriminant = a * a - 3.0 * b;
  if (discriminant <= 0.0) return root_between(f, 0.0, above_all);
  // 3 x² + 2 a x + b = 0 at the turning points
  const double maximum = (-a - std::sqrt(discriminant)) / 3.0, minimum = (-a + std::sqrt(discriminant)) / 3.0;
  if (minimum <= 0.0) return root_between(f, 0.0, above_all);
  if (f(minimum) <= 0.0) return root_between(f, minimum, above_all);
  return root_between(f, 0.0, maximum);
}

}  // namespace

std::vector<BodePoint> bode(const RudderTransfer<double>& t, const std::vector<double>& frequencies,
                            const PrimeScale& scale) {
  const double rate = require_positive(scale.U, "speed U [m/s]") / require_positive(scale.L, "length L [m]");
  std::vector<BodePoint> points;
  points.reserve(frequencies.size());
  for (const double nu : frequencies) {
    require_positive(nu, "frequency [rad per ship length]");
    points.push_back({.frequency = nu, .frequency_rad_s = nu * rate, .gain = gain(t, nu), .phase = phase(t, nu)});
  }
  return points;
}

std::vector<double> logarithmic_frequencies(double low, double high, std::size_t count) {
  require_positive(low, "lowest frequency");
  require_positive(high, "highest frequency");
  if (count < 2) throw std::domain_error("a range needs at least 2 frequencies");
  std::vector<double> all(count);
  for (std::size_t i = 0; i < count; ++i)
    all[i] = low * std::pow(high / low, static_cast<double>(i) / static_cast<double>(count - 1));
  return all;
}

std::optional<double> highest_frequency_with_gain(const RudderTransfer<double>& t, double gain) {
  const double over = 1.0 / (require_positive(gain, "gain") * gain);
  const double b = t.e1 * t.e1 - 2.0 * t.e0, c = t.e0 * t.e0;
  const double n0 = t.n0 * t.n0 * over, n1 = t.n1 * t.n1 * over;
  // x² + (b − n1) x + (c − n0) = 0, or x³ + b x² + (c − n1) x − n0 = 0
  const auto x = t.integrals == 0 ? largest_root(b - n1, c - n0)
                 : n0 > 0.0       ? largest_root(b, c - n1, n0)
                                  : largest_root(b, c - n1);
  if (!x || *x <= 0.0) return std::nullopt;
  return std::sqrt(*x);
}

std::optional<double> bandwidth(const RudderTransfer<double>& t) {
  if (t.integrals != 0 || t.e0 == 0.0 || t.n0 == 0.0) return std::nullopt;
  return highest_frequency_with_gain(t, std::abs(t.n0 / t.e0) / std::sqrt(2.0));
}

std::optional<Crossover> crossover(const SwayYawTransfer<double>& h, double k) {
  const auto heading = rudder_to_heading(h);
  const auto nu = highest_frequency_with_gain(heading, 1.0 / require_positive(k, "rudder angle per heading error"));
  if (!nu) return std::nullopt;
  // the loop is −k psi/delta, its phase is π more than that of psi/delta, and π more is the margin
  return Crossover{.frequency = *nu, .phase_margin = wrapped(phase(heading, *nu))};
}

}  // namespace swayaw::linear
