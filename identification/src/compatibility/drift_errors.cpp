#include <algorithm>
#include <cmath>

#include "coloured_regression.hpp"
#include "relations.hpp"
#include "run_motion.hpp"

namespace swayaw::inline identification::detail {
namespace {

enum Column : Eigen::Index { axes, lever, current_x, current_y, columns };

/// Samples where the ship turns little beside what she can, and has for a while: her sway is settled.
std::vector<std::size_t> on_straight_courses(const Recording& run, const std::vector<double>& r) {
  constexpr double little = 0.15;  // of the hard yaw rate
  constexpr double settled = 0.3;  // [rad] that she would have turned meanwhile
  const double hard = hard_yaw_rate(run);
  const bool all = is_straight(run);
  std::vector<std::size_t> straight;
  double since = run.time.front();
  for (std::size_t i = 0; i < r.size(); ++i) {
    if (std::abs(r[i]) > little * hard) since = run.time[i];
    if (all || (run.time[i] - since) * hard > settled) straight.push_back(i);
  }
  return straight;
}

}  // namespace

std::optional<InstrumentError> drift_on_straight_courses(const Recording& run, Channel surge) {
  constexpr double stream = 0.05;  // over the speed: a tide of half a knot on ten
  const bool ground = surge == Channel::u_ground;
  const Channel sway = ground ? Channel::v_ground : Channel::v;
  if (!run.has(sway)) return {};
  const auto psi = filled(run, Channel::psi), u = filled(run, surge), v = filled(run, sway);
  const auto r = yaw_rate(run);
  const auto straight = on_straight_courses(run, r);
  constexpr std::size_t least = 30;
  if (straight.size() < least) return {};
  TimeSeries s(straight.size(), columns + 1);
  for (std::size_t k = 0; k < straight.size(); ++k) {
    const std::size_t i = straight[k];
    s.time[k] = run.time[i];
    s.Xy.row(static_cast<Eigen::Index>(k)) << -u[i], r[i], -std::sin(psi[i]), std::cos(psi[i]), v[i];
  }
  const double U = rms(u), radius = U / std::max(rms(r), 1e-4);
  const double noise = std::max(white_noise_of(v), 1e-4 * U), current = ground ? stream * U : 1e-3 * U;
  const InstrumentPriors p;
  const Eigen::Vector<double, columns> prior{p.axes, p.lever * radius, current, current};
  const ErrorModel guess{noise, std::max(noise, 0.02 * U), 20.0, 1e-3 * noise};
  const auto fit = coloured_regression(s, prior, {&guess, 1});
  return InstrumentError{sway, InstrumentErrorKind::axes, fit.beta[axes], std::sqrt(fit.covariance(axes, axes))};
}

}  // namespace swayaw::identification::detail
