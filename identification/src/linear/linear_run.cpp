#include "linear_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "swayaw/core/motion.hpp"
#include "swayaw/core/refusal.hpp"

namespace swayaw::inline identification::detail {
namespace {

using OverTime = std::function<double(double)>;

/// Speed of midship: given, from u and v, or from log or ground speed.
OverTime speed_over_time(const Recording& run, const LinearFitOptions& options) {
  if (options.U) return [U = require_positive(*options.U, "ship speed U [m/s]")](double) { return U; };
  for (const auto& [forward, sideways] :
       {std::pair{Channel::u, Channel::v}, std::pair{Channel::u_ground, Channel::v_ground}})
    if (run.has(forward) && run.has(sideways))
      return
          [u = Interpolant(run, forward), v = Interpolant(run, sideways)](double t) { return std::hypot(u(t), v(t)); };
  for (const Channel channel :
       {Channel::speed_through_water, Channel::u, Channel::speed_over_ground, Channel::u_ground})
    if (run.has(channel)) return Interpolant(run, channel);
  throw Refusal(fmt::format("{}: no channel tells the speed of the ship, and none was given", run.name));
}

double sample_of(const Recording& run, Channel channel, std::size_t i) {
  const auto values = run[channel];
  return values.empty() ? missing : values[i];
}

}  // namespace

LinearRun linear_run(const Recording& run, const LinearFitOptions& options) {
  const double L = require_positive(options.L, "ship length L [m]");
  const Interpolant rudder(run, Channel::delta);
  const auto speed = speed_over_time(run, options);
  LinearRun result;
  double used = -1e9, before = 0.0;
  for (std::size_t i = 0; i < run.samples(); ++i) {
    const double t = run.time[i];
    if (t < options.from || t > options.to) continue;
    LinearSample now{.s = 0.0, .rate = speed(t) / L, .delta = rudder(t), .psi = missing, .r = missing, .beta = missing};
    if (!(now.rate > 0.0)) throw Refusal(fmt::format("{}: the ship does not move at {:.6g} s", run.name, t));
    // s' = ∫ U/L dt, trapezoidal
    if (!result.empty()) now.s = result.back().s + 0.5 * (result.back().rate + now.rate) * (t - before);
    before = t;
    if (now.s - used >= options.spacing * (1.0 - 1e-9)) {
      used = now.s;
      if (options.use_heading) now.psi = sample_of(run, Channel::psi, i);
      if (options.use_yaw_rate) now.r = sample_of(run, Channel::r, i);
      if (options.use_drift)
        now.beta = drift_angle(PlanarMotion<double>{sample_of(run, Channel::u, i), sample_of(run, Channel::v, i), 0.0});
    }
    result.push_back(now);
  }
  return result;
}

}  // namespace swayaw::identification::detail
