#include <algorithm>
#include <cmath>

#include "swayaw/identification/map_fit.hpp"
#include "swayaw/nonlinear/replay.hpp"

namespace swayaw::inline identification {
namespace {

/// The least that is believed of an instrument, whatever the smoothness of its record: of positions over L, of other
/// channels over their unit.
double least_noise(Channel channel, double L, double U) {
  return (dimension_of(channel) == Dimension::length ? 1e-4 : 2e-4) * unit_of(channel, L, U);
}

PreparedRun prepared(const Ship& ship, const Recording& run, std::span<const Channel> channels) {
  const double L = length(ship), U = service_speed(ship);
  PreparedRun result{
      .run = &run, .channels = {}, .start = recorded_state(ship, run, run.time.front()), .measurements = 0};
  for (const auto channel : channels) {
    if (!run.has(channel)) continue;
    result.channels.push_back(channel);
    result.deviation[index_of(channel)] = std::max(least_noise(channel, L, U), white_noise_of(run[channel]));
    result.measurements += std::ranges::count_if(run[channel], [](double x) { return !std::isnan(x); });
  }
  return result;
}

}  // namespace

std::vector<PreparedRun> prepared_runs(const Ship& ship, std::span<const Recording> runs,
                                       std::span<const Channel> channels) {
  std::vector<PreparedRun> result;
  for (const auto& run : runs) result.push_back(prepared(ship, run, channels));
  return result;
}

}  // namespace swayaw::identification
