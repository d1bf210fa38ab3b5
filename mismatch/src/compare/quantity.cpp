#include "swayaw/mismatch/quantity.hpp"

#include <cmath>

#include "statistics.hpp"
#include "swayaw/core/angle.hpp"

namespace swayaw::inline mismatch {
using namespace detail;
namespace {

Channel channel_of(const Recording& run, Quantity quantity) {
  switch (quantity) {
    case Quantity::heading: return Channel::psi;
    case Quantity::yaw_rate: return Channel::r;
    case Quantity::position: return Channel::x;
    case Quantity::drift: return Channel::v;
    case Quantity::speed: break;
  }
  return run.has(Channel::u) ? Channel::u : Channel::speed_through_water;
}

std::vector<double> copy_of(std::span<const double> values) { return {values.begin(), values.end()}; }

std::vector<double> drift_of(const Recording& run) {
  std::vector<double> drift(run.samples());
  for (std::size_t i = 0; i < drift.size(); ++i) drift[i] = std::atan2(-run[Channel::v][i], run[Channel::u][i]);
  return drift;
}

std::vector<double> distances(const Recording& a, const Recording& b) {
  std::vector<double> distance(a.samples());
  for (std::size_t i = 0; i < distance.size(); ++i)
    distance[i] = std::hypot(a[Channel::x][i] - b[Channel::x][i], a[Channel::y][i] - b[Channel::y][i]);
  return distance;
}

}  // namespace

std::string_view name_of(Quantity quantity) {
  static constexpr std::array<std::string_view, 5> names{"heading", "yaw_rate", "speed", "drift", "position"};
  return names[static_cast<std::size_t>(quantity)];
}

std::string_view unit_of(Quantity quantity) {
  static constexpr std::array<std::string_view, 5> units{"rad", "rad/s", "m/s", "rad", "m"};
  return units[static_cast<std::size_t>(quantity)];
}

bool tells(const Recording& run, Quantity quantity) {
  if (quantity == Quantity::drift) return run.has(Channel::u) && run.has(Channel::v);
  if (quantity == Quantity::position) return run.has(Channel::x) && run.has(Channel::y);
  return run.has(channel_of(run, quantity));
}

std::vector<double> values_of(const Recording& run, Quantity quantity) {
  return quantity == Quantity::drift ? drift_of(run) : copy_of(run[channel_of(run, quantity)]);
}

std::vector<double> errors_of(const Recording& simulated, const Recording& recorded, Quantity quantity) {
  if (quantity == Quantity::position) return distances(simulated, recorded);
  auto error = values_of(simulated, quantity);
  const auto truth = values_of(recorded, quantity);
  const bool angle = quantity == Quantity::heading || quantity == Quantity::drift;
  for (std::size_t i = 0; i < error.size(); ++i) {
    error[i] -= truth[i];
    if (angle) error[i] = wrapped(error[i]);
  }
  return error;
}

double variation_of(const Recording& run, Quantity quantity) {
  if (quantity == Quantity::position) return std::hypot(deviation(run[Channel::x]), deviation(run[Channel::y]));
  return deviation(values_of(run, quantity));
}

}  // namespace swayaw::mismatch
