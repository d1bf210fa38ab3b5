#include "state_slopes.hpp"

#include "swayaw/nonlinear/steady_motion.hpp"

namespace swayaw::inline identification::detail {
namespace {

bool same_actuator(const RudderActuator& a, const RudderActuator& b) {
  return a.width == b.width && a.lag == b.lag && a.rate == b.rate && a.offset == b.offset &&
         a.record_late == b.record_late;
}

bool same_propulsion(const Controls<double>& a, const Controls<double>& b) {
  return a.by_thrust == b.by_thrust && a.rev == b.rev && a.thrust.port == b.thrust.port &&
         a.thrust.starboard == b.thrust.starboard;
}

/// Whether the numbers of two ships tell how the one becomes the other: the same effects act at the same times, and no
/// direction swings round, as that of a stream of no speed.
bool comparable(const ShipNumbers& a, const ShipNumbers& b, double step) {
  constexpr double swing = 100.0;  // rad for a unit of the unknown
  if (a.structure != b.structure || a.values.size() != b.values.size()) return false;
  for (std::size_t i = 0; i < a.angles.size(); ++i)
    if (!(std::abs(a.angles[i] - b.angles[i]) < swing * std::abs(step))) return false;
  return true;
}

std::optional<ShipNumbers> numbers_if_any(const std::optional<Ship>& ship) {
  if (!ship) return std::nullopt;
  try {
    return numbers_of(*ship);
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

/// Between two samples the controls are told by so many means: lean samples are so far apart that one is not enough.
constexpr std::size_t parts_of_step = 3;

/// Mean over a part of the time before sample k, which is 1 long.
/// @param all  means of the parts of the time before each sample but the first
Controls<double> mean_over(std::span<const Controls<double>> all, std::size_t k, double from, double to) {
  const auto parts = all.subspan((k - 1) * parts_of_step, parts_of_step);
  Controls<double> mean{};
  double weight = 0.0;
  for (std::size_t i = 0; i < parts_of_step; ++i) {
    const double begin = static_cast<double>(i) / parts_of_step, end = static_cast<double>(i + 1) / parts_of_step,
                 here = std::min(to, end) - std::max(from, begin);
    if (!(here > 0.0)) continue;
    mean = weight == 0.0 ? parts[i] : between(mean, parts[i], here / (weight + here));  // so far
    weight += here;
  }
  return mean;
}

}  // namespace

double lateness_of(const Ship& ship, std::span<const Channel> channels, SampleTimes times) {
  if (times == SampleTimes::recorded || channels.empty()) return 0.0;
  const auto heading = std::ranges::find(channels, Channel::psi);
  return instruments_of(ship)[heading == channels.end() ? channels.front() : *heading].mean_delay();
}

RunControls::RunControls(const Ship& ship, const Recording& run, const Recording* finer, double how_late)
    : recorded(ship, finer ? *finer : run),
      actuator(rudder_actuator(ship)),
      rudder_record(instruments_of(ship)[Channel::delta]),
      wind_speed_record(instruments_of(ship)[Channel::wind_speed]),
      wind_from_record(instruments_of(ship)[Channel::wind_from]),
      rudder_recorded(run.has(Channel::delta)),
      propulsion_recorded(tells_propulsion(ship, run)),
      lateness(how_late) {
  auto times = run.time;
  for (double& t : times) t -= lateness;
  at_samples = recorded.at(times);
  if (!finer) return;
  std::vector<double> middles;
  for (std::size_t k = 1; k < run.samples(); ++k)
    for (std::size_t i = 0; i < parts_of_step; ++i)
      middles.push_back(run.time[k - 1] - lateness +
                        (static_cast<double>(i) + 0.5) / parts_of_step * (run.time[k] - run.time[k - 1]));
  thirds = recorded.at(middles);
}

Controls<double> RunControls::in_step(const Recording& run, std::size_t k, double from, double to) const {
  const double begin = run.time[k - 1], end = run.time[k], middle = 0.5 * (from + to);
  if (!thirds.empty()) return mean_over(thirds, k, (from - begin) / (end - begin), (to - begin) / (end - begin));
  if (recorded.track()) return recorded.at(middle - lateness);
  return between(at_samples[k - 1], at_samples[k], (middle - begin) / (end - begin));
}

double RunControls::rudder_moves(const Recording& run, std::size_t k, double from, double to) const {
  if (thirds.empty()) return 0.0;
  const auto parts = std::span(thirds).subspan((k - 1) * parts_of_step, parts_of_step);
  constexpr double whole =
      parts_of_step / (parts_of_step - 1.0);  // over from the middle of the first to that of the last
  return whole * (parts.back().delta - parts.front().delta) * (to - from) / (run.time[k] - run.time[k - 1]);
}

std::optional<RunControls> RunControls::differing(const Ship& ship, const Recording& run, const Recording* finer,
                                                  double how_late) const {
  const auto instruments = instruments_of(ship);
  if (!(rudder_recorded && lateness == how_late && same_actuator(actuator, rudder_actuator(ship)) &&
        rudder_record == instruments[Channel::delta] && wind_speed_record == instruments[Channel::wind_speed] &&
        wind_from_record == instruments[Channel::wind_from]))
    return RunControls(ship, run, finer, how_late);
  if (propulsion_recorded) return std::nullopt;
  const auto constant = recorded.propulsion_of(ship, finer ? *finer : run);
  if (same_propulsion(constant, recorded.constant())) return std::nullopt;
  RunControls other = *this;
  other.recorded.propel(constant);
  for (auto* all : {&other.at_samples, &other.thirds})
    for (auto& controls : *all) controls = with_rudder(constant, controls.delta);
  return other;
}

NeighbourDifferences differences_between(const Ship& ship, std::span<const Neighbour> neighbours, const Recording& run,
                                         std::span<const Channel> channels, SampleTimes times,
                                         const RunControls& controls, const Recording* finer) {
  NeighbourDifferences result;
  const auto here = numbers_of(ship);
  result.variable.assign(here.values.size(), false);
  struct Moved {
    Eigen::Index unknown;
    std::size_t number;
    double slope;
  };
  std::vector<Moved> moved;
  const double begin = run.time.front();
  const ChannelObserver observer(instruments_of(ship), surroundings_at(ship, 0.0).current, controls.lateness, begin);
  for (const auto& neighbour : neighbours) {
    const auto unknown = std::ssize(result.found);
    const auto there = numbers_if_any(neighbour.ship);
    result.found.push_back(there && comparable(here, *there, neighbour.step));
    if (!result.found.back()) continue;
    for (std::size_t i = 0; i < here.values.size(); ++i)
      if (const double d = there->values[i] - here.values[i]; d != 0.0 && std::isfinite(d))
        moved.push_back({unknown, i, d / neighbour.step}), result.variable[i] = true;
    const double lateness = lateness_of(*neighbour.ship, channels, times);
    if (auto other = controls.differing(*neighbour.ship, run, finer, lateness))
      result.controls.push_back({unknown, neighbour.step, *std::move(other)});
    const auto current = surroundings_at(*neighbour.ship, 0.0).current;
    if (const ChannelObserver other(instruments_of(*neighbour.ship), current, lateness, begin); observer.differs(other))
      result.observers.push_back({unknown, neighbour.step, other});
  }
  std::vector<Eigen::Index> variable;
  Eigen::Index next = TapedVariables::count;
  for (const bool is : result.variable) variable.push_back(is ? next++ : -1);
  for (const auto& m : moved) result.numbers.push_back({m.unknown, variable[m.number], m.slope});
  return result;
}

}  // namespace swayaw::identification::detail
