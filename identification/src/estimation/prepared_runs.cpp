#include "prepared_runs.hpp"

#include <algorithm>
#include <cmath>

#include "../compatibility/channel_character.hpp"
#include "../filter/run_filter.hpp"
#include "swayaw/core/detail/over_ground.hpp"
#include "swayaw/nonlinear/replay.hpp"

namespace swayaw::inline identification {
using namespace detail;
namespace {

/// The least that is believed of an instrument, whatever the smoothness of its record: of positions over L, of other
/// channels over their unit.
double least_noise(Channel channel, double L, double U) {
  return (dimension_of(channel) == Dimension::length ? 1e-4 : 2e-4) * unit_of(channel, L, U);
}

/// Standard deviation of the error by which a channel is rounded: q/√12 of a step q, counted once for all samples in a
/// row that repeat a value, for they all err alike.
double rounding_of(std::span<const double> values, double step) {
  if (!(step > 0.0)) return 0.0;
  constexpr double longest = 10.0;  // samples that repeat a value on a straight course say little more
  double samples = 0.0, changes = 1.0, last = missing;
  for (const double x : values) {
    if (std::isnan(x)) continue;
    ++samples;
    if (!std::isnan(last) && std::abs(x - last) > 0.5 * step) ++changes;
    last = x;
  }
  return step / std::sqrt(12.0) * std::sqrt(std::min(longest, samples / changes));
}

double root_mean_square(std::span<const double> values) {
  double squares = 0.0, count = 0.0;
  for (const double x : values)
    if (!std::isnan(x)) squares += x * x, ++count;
  return count > 0.0 ? std::sqrt(squares / count) : 0.0;
}

/// Where a run starts, by its positions alone where velocities over ground are left out beside them: these may be in
/// other axes than those of the recorded heading, and a start that the track contradicts hid a compass off by 4.2 deg.
ShipState<double> start_of(const Ship& ship, const Recording& run, std::span<const Channel> channels) {
  const auto used = [&](Channel c) { return run.has(c) && std::ranges::count(channels, c) > 0; };
  if (!used(Channel::x) || !used(Channel::y)) return recorded_state(ship, run, run.time.front());
  auto told = run;
  for (const Channel c : core::detail::velocities_over_ground)
    if (!used(c)) told.channels[index_of(c)].clear();
  return recorded_state(ship, told, run.time.front());
}

PreparedRun prepared(const Ship& ship, const Recording& run, std::span<const Channel> channels) {
  const double L = length(ship), U = service_speed(ship);
  std::vector<ChannelCharacter> characters;
  for (const auto channel : channels)
    if (run.has(channel)) characters.push_back(character_of(run, channel));
  PreparedRun result{.run = std::make_shared<const Recording>(measured_samples(run, characters)),
                     .channels = {},
                     .start = start_of(ship, run, channels),
                     .measurements = 0,
                     .longest_step = usual_longest_step,
                     .heel = root_mean_square(run[Channel::phi])};
  for (const auto& c : characters) {
    const auto values = (*result.run)[c.channel];
    result.channels.push_back(c.channel);
    result.deviation[index_of(c.channel)] =
        std::max({least_noise(c.channel, L, U), c.noise, rounding_of(values, c.step)});
    result.measurements += std::ranges::count_if(values, [](double x) { return !std::isnan(x); });
  }
  return result;
}

}  // namespace

std::vector<PreparedRun> detail::runs_with_all_samples(const Ship& ship, std::span<const Recording> runs,
                                                       std::span<const Channel> channels) {
  std::vector<PreparedRun> result;
  for (const auto& run : runs) result.push_back(prepared(ship, run, channels));
  return result;
}

void detail::thin_heel(PreparedRun& run, double time_unit) {
  if (std::ranges::count(run.channels, Channel::phi) == 0) return;
  constexpr double apart = 4.0;  // time units
  auto fewer = *run.run;
  double next = fewer.time.front();
  for (std::size_t k = 0; k < fewer.samples(); ++k) {
    double& phi = fewer.channels[index_of(Channel::phi)][k];
    if (std::isnan(phi)) continue;
    if (fewer.time[k] < next) phi = missing, --run.measurements;
    else next = fewer.time[k] + apart * time_unit;
  }
  run.run = std::make_shared<const Recording>(std::move(fewer));
}

std::vector<PreparedRun> prepared_runs(const Ship& ship, std::span<const Recording> runs,
                                       std::span<const Channel> channels) {
  auto result = runs_with_all_samples(ship, runs, channels);
  for (auto& run : result) thin_heel(run, time_unit_of(ship));
  return result;
}

}  // namespace swayaw::identification
