#include "swayaw/nonlinear/replay.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "../instruments/local_fit.hpp"
#include "../instruments/track_velocity.hpp"
#include "../manoeuvres/manoeuvre_run.hpp"
#include "../steady/acting_propulsion.hpp"
#include "swayaw/core/detail/over_ground.hpp"
#include "swayaw/core/followed_order.hpp"
#include "swayaw/nonlinear/effects/acting_in_wind.hpp"
#include "swayaw/nonlinear/models/validity.hpp"

namespace swayaw::inline nonlinear {
using namespace detail;
namespace {

/// L/U [s].
// ---------------------------------------------------------------- recorded state

/// Samples that tell the state at a time.
struct Neighbourhood {
  double time;
  double from;
  double to;
  int degree;
};

/// First time at which the rudder has left its starting angle by a degree.
double rudder_moves(const Recording& run) {
  const Channel rudder = run.has(Channel::delta) ? Channel::delta : Channel::delta_order;
  const Interpolant angle(run, rudder);
  const auto moved = std::ranges::find_if(
      angle.values(), [&](double a) { return std::abs(a - angle.values().front()) > radians(1.0); });
  return moved == angle.values().end() ? run.time.back()
                                       : angle.times()[static_cast<std::size_t>(moved - angle.values().begin())];
}

Neighbourhood neighbourhood(const Recording& run, double time, double time_unit) {
  if (time > run.time.front()) return {time, time - 0.25 * time_unit, time + 0.25 * time_unit, 2};
  return {time, time, std::min(rudder_moves(run), time + 0.5 * time_unit), 1};
}

/// The same for rates of change: a rudder that moves at once, or sparse samples, leave too few of them to tell one.
Neighbourhood rate_neighbourhood(const Recording& run, const Neighbourhood& near, double time_unit) {
  constexpr std::ptrdiff_t enough = 4;
  const auto first = std::ranges::lower_bound(run.time, near.from);
  if (std::ranges::upper_bound(run.time, near.to) - first >= enough) return near;
  const double fourth = run.time.end() - first >= enough ? first[enough - 1] : run.time.back();
  return {near.time, near.from, std::max(near.from + 0.25 * time_unit, fourth), 2};
}

/// The next wider one where samples are missing, of straight lines; nothing where it was the whole run.
/// @param least  width on each side [s]
std::optional<Neighbourhood> across_gap(const Recording& run, const Neighbourhood& near, double least) {
  if (near.from < run.time.front() && near.to > run.time.back()) return std::nullopt;
  const double half = std::max(least, 2.0 * std::max(near.to - near.time, near.time - near.from));
  return Neighbourhood{near.time, near.time - half, near.time + half, 1};
}

std::optional<ValueAndRate> fit(const Recording& run, Channel channel, const Neighbourhood& near) {
  const auto [time, from, to, degree] = near;
  return local_fit(run, channel, time, from, to, degree);
}

std::optional<double> first_value(const Recording& run, const Neighbourhood& near,
                                  std::initializer_list<Channel> channels) {
  for (const Channel channel : channels)
    if (const auto found = fit(run, channel, near)) return found->value;
  return std::nullopt;
}

/// Ground velocity of the water in the axes of a ship that heads psi.
SurgeSway stream_along(const Current<double>& current, double psi) {
  const auto drift = over_ground(current, ShipState<double>{0.0, 0.0, psi, {0.0, 0.0, 0.0}});
  return {drift.u, drift.v};
}

/// Body velocity over ground from speed and course: u = SOG cos(COG − ψ), v = SOG sin(COG − ψ).
std::optional<SurgeSway> velocity_from_course(const Recording& run, const Neighbourhood& near, double psi) {
  const auto speed = run[Channel::speed_over_ground], course = run[Channel::course_over_ground];
  if (speed.empty() || course.empty()) return std::nullopt;
  Recording around;  // components do not jump where the course passes north
  around.time = run.time;
  auto u = around.fill(Channel::u), v = around.fill(Channel::v);
  for (std::size_t i = 0; i < run.samples(); ++i) {
    u[i] = speed[i] * std::cos(course[i] - psi);
    v[i] = speed[i] * std::sin(course[i] - psi);
  }
  const auto ahead = fit(around, Channel::u, near), abeam = fit(around, Channel::v, near);
  if (!ahead || !abeam) return std::nullopt;
  return SurgeSway{ahead->value, abeam->value};
}

/// Surge through the water from the speed over ground, SOG² = (u + u_c)² + (v + v_c)².
double surge_from_speed(double speed_over_ground, double v, const SurgeSway& stream) {
  const double abeam = v + stream.v;
  return std::sqrt(std::max(0.0, speed_over_ground * speed_over_ground - abeam * abeam)) - stream.u;
}

/// Velocity through the water: measured there, else over ground less the current, by the channels in the order of
/// recorded_state. Nothing tells a sway that is not there.
std::optional<SurgeSway> velocity_told(const Recording& run, const Current<double>& current, double psi,
                                       const Neighbourhood& near, const Neighbourhood& wide) {
  const auto stream = stream_along(current, psi);
  auto u = first_value(run, near, {Channel::u, Channel::speed_through_water});
  auto v = first_value(run, near, {Channel::v});
  if (const auto ground = first_value(run, near, {Channel::u_ground}); !u && ground) u = *ground - stream.u;
  if (const auto ground = first_value(run, near, {Channel::v_ground}); !v && ground) v = *ground - stream.v;
  if (u && v) return SurgeSway{*u, *v};
  auto told = velocity_from_track(run, current, near.time, wide.from, wide.to, wide.degree);
  if (!told) {
    const auto course = velocity_from_course(run, near, psi);
    if (course) told = SurgeSway{course->u - stream.u, course->v - stream.v};
  }
  if (told) return SurgeSway{u.value_or(told->u), v.value_or(told->v)};
  const auto speed = first_value(run, near, {Channel::speed_over_ground});
  if (!u && speed) u = surge_from_speed(*speed, v.value_or(0.0), stream);
  if (!u) return std::nullopt;
  return SurgeSway{*u, v.value_or(0.0)};
}

ShipState<double> state_told(const Ship& ship, const Recording& run, double time) {
  const double time_unit = time_unit_of(ship);
  const auto near = neighbourhood(run, time, time_unit);
  const auto wide = rate_neighbourhood(run, near, time_unit);
  const auto psi = fit(run, Channel::psi, near);
  const double heading = psi ? psi->value : Interpolant(run, Channel::psi)(time);
  const auto turning = fit(run, Channel::psi, wide);
  const auto current = surroundings_at(ship, time).current;
  auto velocity = velocity_told(run, current, heading, near, wide);
  for (auto around = across_gap(run, near, time_unit); !velocity && around;
       around = across_gap(run, *around, time_unit))
    velocity = velocity_told(run, current, heading, *around, *around);
  if (!velocity) throw Refusal(fmt::format("{}: no channel tells the speed of the ship at {:.6g} s", run.name, time));
  /// By the samples near the time, else by something else, else across a gap.
  const auto told = [&](Channel channel, std::optional<double> otherwise) {
    if (const auto found = fit(run, channel, near)) return found->value;
    if (otherwise) return *otherwise;
    return run.has(channel) ? Interpolant(run, channel)(time) : 0.0;
  };
  const double r = told(Channel::r, turning ? std::optional(turning->rate) : std::nullopt);
  return {told(Channel::x, {}), told(Channel::y, {}), heading, {velocity->u, velocity->v, r}};
}

/// Whether velocities over ground cannot be taken for those of the moment in her axes: a receiver makes them of its
/// positions, as late as these, in axes of the heading that the compass shows. Either being late by τ makes a drift of
/// r τ, a degree of it in a turn with r' = 0.35 comes of 0.05 L/U; an error of the compass is all drift.
bool tells_false_drift(const Ship& ship, const Instruments<>& instruments) {
  constexpr double late = 0.05;  // [L/U]
  const double askew = radians(1.0);
  const auto &position = instruments[Channel::x], &heading = instruments[Channel::psi];
  const double time_unit = time_unit_of(ship);
  return std::max(std::abs(position.mean_delay()), std::abs(heading.mean_delay())) > late * time_unit ||
         !position.clock.is_good() || !heading.clock.is_good() || std::abs(heading.bias) > askew;
}

std::vector<ShipState<double>> states_told(const Ship& ship, const Recording& run, std::span<const double> times) {
  std::vector<ShipState<double>> states;
  for (const double time : times) states.push_back(state_told(ship, run, time));
  return states;
}

}  // namespace

std::vector<ShipState<double>> recorded_states(const Ship& ship, const Recording& run, std::span<const double> times) {
  const auto instruments = instruments_of(ship);
  if (instruments == Instruments<>{}) return states_told(ship, run, times);
  auto was = as_it_was(run, instruments);
  if (tells_false_drift(ship, instruments) && was.has(Channel::x) && was.has(Channel::y))
    for (const Channel channel : core::detail::velocities_over_ground) was.channels[index_of(channel)].clear();
  return states_told(ship, was, times);
}

ShipState<double> recorded_state(const Ship& ship, const Recording& run, double time) {
  return recorded_states(ship, run, {&time, 1}).front();
}

// ---------------------------------------------------------------- recorded controls

namespace {

/// Recorded rudder angle at the times that its record shows, between its own samples: angles at those of the run,
/// joined by straight lines, cut the corners of an order, and more or less so as the delay changes. Where the record
/// shows no time of the run its first or last line is drawn on.
Interpolant in_time(const Ship& ship, const Recording& run) {
  const Interpolant recorded(run, Channel::delta);
  const auto error = instruments_of(ship)[Channel::delta];
  if (error.is_prompt()) return recorded;
  std::vector<double> time, angle;
  for (std::size_t i = 0; i < recorded.times().size(); ++i) {
    const double at = recorded.times()[i];
    const double shown = at - error.late({at, run.time.front()}) - error.smoothing.mean();
    while (!time.empty() && time.back() >= shown) time.pop_back(), angle.pop_back();  // its clock went back: told anew
    time.push_back(shown), angle.push_back(recorded.values()[i]);
  }
  const auto drawn_on = [&](double to, std::size_t from, std::size_t next) {
    return angle[from] + (to - time[from]) / (time[next] - time[from]) * (angle[next] - angle[from]);
  };
  const double begin = recorded.times().front(), end = recorded.times().back();
  if (const auto last = time.size() - 1; last > 0 && time[last] < end)
    angle.push_back(drawn_on(end, last, last - 1)), time.push_back(end);
  if (time.size() > 1 && time[0] > begin)
    angle.insert(angle.begin(), drawn_on(begin, 0, 1)), time.insert(time.begin(), begin);
  Recording rudder{.name = run.name, .facts = {}, .time = std::move(time), .channels = {}, .extra = {}};
  rudder.channels[index_of(Channel::delta)] = std::move(angle);
  return Interpolant(rudder, Channel::delta);
}

/// Rudder angle as the indicator shows it; an order is followed at the rate of the steering gear.
Interpolant rudder_of(const Ship& ship, const Recording& run) {
  if (run.has(Channel::delta)) return in_time(ship, run);
  if (!run.has(Channel::delta_order)) throw Refusal(fmt::format("{}: no rudder angle", run.name));
  const Interpolant order(run, Channel::delta_order);
  Recording followed;
  followed.name = run.name;
  followed.time.assign(order.times().begin(), order.times().end());
  followed.channels[index_of(Channel::delta)] = followed_order(steering_gear(ship), order.times(), order.values());
  return Interpolant(followed, Channel::delta);
}

/// Ship lengths between two samples, at service speed, beyond which she is not carried on: two days of a ship of 150 m,
/// some seconds of processor time. A clock that leaps by years leaves no run.
constexpr double longest_gap = 1e4;

void require_samples_near(const Recording& run, const Ship& ship) {
  const double longest = longest_gap * time_unit_of(ship);
  const auto gap = std::ranges::adjacent_find(run.time, [&](double a, double b) { return b - a > longest; });
  if (gap == run.time.end()) return;
  throw Refusal(fmt::format(
      "{}: {:.4g} s lie between two samples, from {:.6g} s on, and a ship is carried on for {:.4g} s at most", run.name,
      gap[1] - gap[0], gap[0], longest));
}

/// The first samples of a run: all that tell the start of one without gaps, however late its channels are.
Recording beginning_of(const Recording& run, double time_unit, const Instruments<>& instruments) {
  constexpr double more_than_enough = 4.0;  // [L/U]
  const double begin = run.time.front();
  double delay = 0.0;
  for (std::size_t c = 0; c < channel_count; ++c) {
    const auto& error = instruments[static_cast<Channel>(c)];
    const double by_clock = error.late({begin + more_than_enough * time_unit, begin}) - error.delay;
    delay = std::max(delay, std::abs(error.mean_delay()) + std::abs(by_clock));
  }
  const double end = begin + more_than_enough * time_unit + delay;
  const auto count = std::ranges::upper_bound(run.time, end) - run.time.begin();
  const auto first = [&](const std::vector<double>& all) {
    return std::vector(all.begin(), all.begin() + std::min(count, std::ssize(all)));
  };
  Recording beginning{.name = run.name, .facts = run.facts, .time = first(run.time), .channels = {}, .extra = {}};
  std::ranges::transform(run.channels, beginning.channels.begin(), first);
  return beginning;
}

/// Speed through the water at the start; by all of the run only where its first samples do not tell. A drift that is
/// false, of a course that is late, is nothing to her speed; without it the speed would leap, and her propulsion with
/// it, where a delay passes that of `tells_false_drift` (a sum of squares by 200, in a fit as on board).
double starting_speed(const Ship& ship, const Recording& run, double time_unit, const Instruments<>& instruments) {
  const auto by = [&](const Recording& samples) {
    const bool exact = instruments == Instruments<>{};
    return speed(state_told(ship, exact ? samples : as_it_was(samples, instruments), run.time.front()).motion);
  };
  try {
    return by(beginning_of(run, time_unit, instruments));
  } catch (const Refusal&) {
    return by(run);
  }
}

/// The run itself.
const Recording& within_reach(const Recording& run, const Ship& ship) {
  require_samples_near(run, ship);
  return run;
}

}  // namespace

bool tells_propulsion(const Ship& ship, const Recording& run) {
  return (run.has(Channel::rev) && takes_shaft_speed(ship)) || run.has(Channel::thrust) ||
         std::holds_alternative<AbkowitzShip<double>>(ship.model);
}

std::string assumed_propulsion(const Ship& ship, std::span<const Recording> runs) {
  std::vector<std::string_view> silent;
  for (const auto& run : runs)
    if (!tells_propulsion(ship, run)) silent.push_back(run.name);
  if (silent.empty()) return {};
  constexpr std::size_t most_named = 4;
  const auto named = std::span(silent).first(std::min(most_named, silent.size()));
  const auto others = silent.size() - named.size();
  const bool by_shaft = takes_shaft_speed(ship);
  return fmt::format(
      "no {} recorded in {}{}: {} taken to begin settled, and what carries her there drives her to the end; where she "
      "still gathers or loses way, {}",
      by_shaft ? "shaft speed" : "thrust", fmt::join(named, ", "),
      others > 0 ? fmt::format(" and {} more", others) : "", silent.size() == 1 ? "the run is" : "these runs are",
      by_shaft ? "rev_rpm or thrust_kN is needed, or ordered_rev_s above the columns" : "thrust_kN is needed");
}

RecordedControls::RecordedControls(const Ship& ship, const Recording& run, const ReplayOptions& options)
    : rudder_(rudder_of(ship, within_reach(run, ship))), wind_(recorded_wind(ship, run)), depth_(recorded_depth(run)) {
  const bool recorded = options.shaft == Shaft::recorded;
  if (recorded && run.has(Channel::rev) && takes_shaft_speed(ship)) rev_.emplace(run, Channel::rev);
  else if (recorded && run.has(Channel::thrust)) thrust_.emplace(run, Channel::thrust);
  else if (!std::holds_alternative<AbkowitzShip<double>>(ship.model))  // whose polynomial holds her propulsion
    start_.emplace(ship, run), constant_ = propulsion_of(ship, run);
  const auto& propulsion = rev_ ? rev_ : thrust_;
  const auto propulsion_times = propulsion ? propulsion->times() : std::span<const double>{};
  std::ranges::set_union(rudder_.times(), propulsion_times, std::back_inserter(knots_));
  if (const auto actuator = rudder_actuator(ship); actuator.any())
    track_.emplace(actuator, lines_through(rudder_.times(), rudder_.values()));
}

RecordedControls::Start::Start(const Ship& ship, const Recording& run)
    : instruments(instruments_of(ship)),
      current(surroundings_at(ship, run.time.front()).current),
      time_unit(time_unit_of(ship)),
      speed(starting_speed(ship, run, time_unit, instruments)) {}

bool RecordedControls::Start::is_of(const Ship& ship, double begin) const {
  const auto its = surroundings_at(ship, begin).current;
  return its.speed == current.speed && its.to == current.to && time_unit_of(ship) == time_unit &&
         instruments_of(ship) == instruments;
}

Controls<double> RecordedControls::propulsion_of(const Ship& ship, const Recording& run) const {
  const double begin = run.time.front();
  const bool known = start_ && start_->is_of(ship, begin);
  const double speed = known ? start_->speed : Start(ship, run).speed;
  const auto headings = run[Channel::psi];
  const auto first = std::ranges::find_if(headings, [](double psi) { return !std::isnan(psi); });
  const double psi = first == headings.end() ? 0.0 : *first - instruments_of(ship)[Channel::psi].bias;
  return visit_acting(in_depth(ship, depth_).value_or(ship), [&](const auto& acting) {
    return settled_propulsion(in_wind(acting, wind_).at(begin), speed, psi);
  });
}

std::optional<double> RecordedControls::shaft_astern(double from, double to) const {
  if (!rev_) return std::nullopt;
  for (std::size_t i = 0; i < rev_->times().size(); ++i)
    if (const double time = rev_->times()[i]; from <= time && time <= to && rev_->values()[i] < 0.0) return time;
  return std::nullopt;
}

Controls<double> RecordedControls::at(double time) const { return with_angle(rudder(time), time); }

std::vector<Controls<double>> RecordedControls::at(std::span<const double> times) const {
  const auto angles = track_ ? track_->at(times) : std::vector<double>{};
  std::vector<Controls<double>> controls;
  controls.reserve(times.size());
  for (std::size_t i = 0; i < times.size(); ++i)
    controls.push_back(with_angle(track_ ? angles[i] : rudder_(times[i]), times[i]));
  return controls;
}

Controls<double> RecordedControls::with_angle(double delta, double time) const {
  if (rev_) return {.delta = delta, .rev = (*rev_)(time)};
  if (!thrust_) return with_rudder(constant_, delta);
  const double half = 0.5 * (*thrust_)(time);
  return {.delta = delta, .thrust = {half, half}, .by_thrust = true};
}

// ---------------------------------------------------------------- replay

namespace {

/// Change of the controls per second.
Controls<double> slope(const Controls<double>& from, const Controls<double>& to, double duration) {
  return {(to.delta - from.delta) / duration,
          (to.rev - from.rev) / duration,
          {(to.thrust.port - from.thrust.port) / duration, (to.thrust.starboard - from.thrust.starboard) / duration},
          to.by_thrust};
}

/// Integrates from knot to knot of the recorded controls.
std::vector<Sample> integrate_along(ShipStepper& stepper, const RecordedControls& controls,
                                    std::span<const double> times) {
  const double begin = times.front(), end = times.back();
  stepper.sample_at(times);
  if (controls.track()) {
    stepper.show_along(controls.shown());
    stepper.steer_along(*controls.track());
  }
  auto knot = std::ranges::upper_bound(controls.knots(), begin);
  while (stepper.time() < end) {
    const double next = knot == controls.knots().end() ? end : std::min(end, *knot++);
    if (next <= stepper.time()) continue;
    const auto rate = slope(stepper.controls(), controls.at(next), next - stepper.time());
    if (!controls.track()) stepper.steer(rate.delta);
    stepper.drive(rate);
    stepper.advance(next);
  }
  return stepper.samples();
}

void append(Recording& to, const Recording& from) {
  to.time.insert(to.time.end(), from.time.begin(), from.time.end());
  for (std::size_t c = 0; c < channel_count; ++c)
    to.channels[c].insert(to.channels[c].end(), from.channels[c].begin(), from.channels[c].end());
}

/// Piece by piece from a state that is taken up, in the wind of the piece; instruments know nothing of the one before,
/// but the time on their clocks.
template <class Acting>
Recording pieces_of(const Acting& calm, const RecordedControls& controls, std::span<const ReplayStart> starts,
                    std::span<const double> times, double tolerance) {
  Recording all;
  std::optional<Hidden<double>> remembered;
  for (std::size_t k = 0; k < starts.size(); ++k) {
    const bool last = k + 1 == starts.size();
    const auto to = last ? times.size() : starts[k + 1].sample + 1;
    const auto piece = times.subspan(starts[k].sample, to - starts[k].sample);
    const double begin = piece.front();
    const auto acting = in_wind(calm, wind_between(controls.wind(), begin, piece.back()));
    const auto stepper = make_stepper(
        acting, {begin, starts[k].state, with_rudder(controls.at(begin), controls.shown()(begin))}, tolerance);
    if (remembered) stepper->remember(*remembered);
    auto samples = integrate_along(*stepper, controls, piece);
    if (!last) {
      remembered = samples.back().hidden;
      samples.pop_back();
    }
    append(all, recording_of(samples, acting, times.front()));
  }
  return all;
}

}  // namespace

Recording replay_anew(const Ship& deep, const RecordedControls& controls, std::span<const ReplayStart> starts,
                      std::span<const double> times, const ReplayOptions& options) {
  const auto shallow = in_depth(deep, controls.depth());
  const auto& ship = shallow ? *shallow : deep;
  for (const auto& [sample, state] : starts) require_valid(ship, state.motion, controls.at(times[sample]));
  if (const auto astern = controls.shaft_astern(times.front(), times.back()))
    throw Refusal(
        fmt::format("{}: the recorded shaft turns astern at {:.6g} s", words_for(Validity::shaft_astern), *astern));
  return visit_acting(ship,
                      [&](const auto& calm) { return pieces_of(calm, controls, starts, times, options.tolerance); });
}

Recording replay_from(const Ship& ship, const RecordedControls& controls, const ShipState<double>& start,
                      std::span<const double> times, const ReplayOptions& options) {
  return replay_anew(ship, controls, std::vector{ReplayStart{0, start}}, times, options);
}

Recording replay(const Ship& ship, const Recording& run, const ReplayOptions& options) {
  const RecordedControls controls(ship, run, options);
  auto simulated = replay_from(ship, controls, recorded_state(ship, run, run.time.front()), run.time, options);
  simulated.name = ship.name;
  simulated.facts = run.facts;
  if (!controls.wind().empty())
    for (const auto channel : {Channel::wind_speed, Channel::wind_from})
      simulated.channels[index_of(channel)] = run.channels[index_of(channel)];
  return simulated;
}

}  // namespace swayaw::nonlinear
