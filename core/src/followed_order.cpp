#include "swayaw/core/followed_order.hpp"

#include <algorithm>
#include <cmath>

namespace swayaw::inline core {

std::vector<double> followed_order(const SteeringGear<double>& gear, std::span<const double> times,
                                   std::span<const double> orders) {
  std::vector<double> angles(orders.begin(), orders.end());
  for (std::size_t i = 1; i < angles.size(); ++i)
    angles[i] = RudderMotion<>::ordered(gear, times[i - 1], angles[i - 1], orders[i]).at(times[i]);
  return angles;
}

Recording with_followed_order(Recording run, const SteeringGear<double>& gear) {
  if (run.has(Channel::delta) || !run.has(Channel::delta_order)) return run;
  const Interpolant order(run, Channel::delta_order);
  const auto angles = followed_order(gear, order.times(), order.values());
  const auto orders = run[Channel::delta_order];
  auto known = angles.begin();
  std::vector<double> delta(run.samples(), missing);
  for (std::size_t i = 0; i < delta.size(); ++i)
    if (!std::isnan(orders[i])) delta[i] = *known++;
  run.channels[index_of(Channel::delta)] = std::move(delta);
  return run;
}

}  // namespace swayaw::core
