#include <fmt/format.h>
#include <swayaw.h>

#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/published_ships.hpp"
#include "swayaw/nonlinear/ship_file.hpp"
#include "swayaw/nonlinear/simulator.hpp"

using namespace swayaw;

/// A ship under way, and what is held for her.
struct swayaw_ship {
  swayaw_ship(const Ship& ship, double speed, const Surroundings<double>& around)
      : simulator(ship, {.speed = speed}), wind(around.wind), current(around.current), windy(around.windy) {}

  Simulator simulator;
  Wind<double> wind;
  Current<double> current;
  PlanarForce<double> added{0.0, 0.0, 0.0};
  double rudder = 0.0;                                     ///< ordered [rad]
  bool windy, by_thrust = simulator.shaft_speed() == 0.0;  ///< whether there is air, and what drives her
};

namespace {

thread_local std::string trouble;

/// What `work` makes; where it throws, `otherwise`, and the trouble is told.
template <class T, class Work>
T guarded(T otherwise, const Work& work) noexcept try {
  trouble.clear();
  return work();
} catch (const std::exception& e) {
  trouble = e.what();
  return otherwise;
}

template <class Pointer>
auto& require(Pointer* pointer, const char* what) {
  if (pointer == nullptr) throw Refusal(fmt::format("{} is NULL", what));
  return *pointer;
}

Ship ship_named(const char* name) {
  const std::filesystem::path file = &require(name, "the name of the ship");
  if (std::filesystem::exists(file) || file.has_parent_path() || file.has_extension()) return read_ship(file);
  return published_ship(name);
}

constexpr auto order = SWAYAW_ORDER, output = SWAYAW_OUTPUT;

struct Row {
  swayaw_quantity told;
  double (*get)(const swayaw_ship&);
  void (*set)(swayaw_ship&, double) = nullptr;
};

auto& part(auto& s, double ShipState<double>::*member) { return s.*member; }
auto& part(auto& s, double PlanarMotion<double>::*member) { return s.motion.*member; }

template <auto Member>
constexpr Row state(const char* name, const char* unit, const char* description) {
  const auto get = [](const swayaw_ship& s) { return part(s.simulator.state(), Member); };
  const auto set = [](swayaw_ship& s, double value) {
    auto now = s.simulator.state();
    part(now, Member) = value;
    s.simulator.set_state(now);
  };
  return {{name, unit, SWAYAW_STATE, description}, get, set};
}

void hold(swayaw_ship& s, const Wind<double>& wind) {
  // still air has a drag that calm without air has not: a direction alone makes no wind
  if (s.windy || wind.speed != 0.0) s.simulator.set_wind(wind), s.windy = true;
  s.wind = wind;
}
void hold(swayaw_ship& s, const Current<double>& current) { s.simulator.set_current(current), s.current = current; }
void hold(swayaw_ship& s, const PlanarForce<double>& added) { s.simulator.set_added_force(added), s.added = added; }

/// A number of what is held together.
template <auto Group, auto Member>
constexpr Row held(const char* name, const char* unit, const char* description) {
  const auto set = [](swayaw_ship& s, double value) {
    auto group = s.*Group;
    group.*Member = value;
    hold(s, group);
  };
  return {{name, unit, SWAYAW_ORDER, description}, [](const swayaw_ship& s) { return s.*Group.*Member; }, set};
}

template <auto Get>
double read(const swayaw_ship& s) {
  return static_cast<double>((s.simulator.*Get)());
}

template <Channel Which>
constexpr Row instrument(const char* name, const char* unit) {
  const auto get = [](const swayaw_ship& s) { return s.simulator.instruments()[index_of(Which)]; };
  return {{name, unit, output, "as the instrument shows it"}, get};
}

template <auto Component>
constexpr Row over_ground(const char* name, const char* description) {
  const auto get = [](const swayaw_ship& s) { return s.simulator.velocity_over_ground().*Component; };
  return {{name, "m/s", output, description}, get};
}

double rudder_order(const swayaw_ship& s) { return s.rudder; }
void order_rudder(swayaw_ship& s, double value) { s.simulator.order_rudder(value), s.rudder = value; }
void set_shaft_speed(swayaw_ship& s, double value) { s.simulator.set_shaft_speed(value), s.by_thrust = false; }
void set_thrust(swayaw_ship& s, double value) { s.simulator.set_thrust(value), s.by_thrust = true; }

using State = ShipState<double>;
using Motion = PlanarMotion<double>;
using Force = PlanarForce<double>;
using Boat = swayaw_ship;

constexpr Row rows[] = {
    {{"time_s", "s", output, "since the beginning"}, read<&Simulator::time>},
    state<&State::x>("x_m", "m", "midship, northward"),
    state<&State::y>("y_m", "m", "midship, eastward"),
    state<&State::psi>("psi_rad", "rad", "heading, clockwise from north, unwrapped"),
    state<&Motion::u>("u_m_s", "m/s", "surge of midship through the water"),
    state<&Motion::v>("v_m_s", "m/s", "sway of midship through the water, positive to starboard"),
    state<&Motion::r>("r_rad_s", "rad/s", "yaw rate, positive to starboard"),
    {{"delta_order_rad", "rad", order, "rudder order, positive to port"}, rudder_order, order_rudder},
    {{"rev_s", "1/s", order, "shaft speed; 0 under a thrust"}, read<&Simulator::shaft_speed>, set_shaft_speed},
    {{"thrust_N", "N", order, "of all propellers; held once it is set"}, read<&Simulator::thrust>, set_thrust},
    held<&Boat::wind, &Wind<double>::speed>("wind_speed_m_s", "m/s", "true wind, beside gusts of the ship file"),
    held<&Boat::wind, &Wind<double>::from>("wind_from_rad", "rad", "where it comes from, clockwise from north"),
    held<&Boat::current, &Current<double>::speed>("current_speed_m_s", "m/s", "current"),
    held<&Boat::current, &Current<double>::to>("current_to_rad", "rad", "where it runs to, clockwise from north"),
    held<&Boat::added, &Force::X>("added_X_N", "N", "force beside all others, forward: tugs, lines, waves"),
    held<&Boat::added, &Force::Y>("added_Y_N", "N", "force beside all others, to starboard"),
    held<&Boat::added, &Force::N>("added_N_N_m", "N.m", "moment beside all others, bow to starboard"),
    {{"delta_rad", "rad", output, "angle of the rudder, positive to port"}, read<&Simulator::rudder>},
    over_ground<&Motion::u>("ug_m_s", "surge of midship over ground"),
    over_ground<&Motion::v>("vg_m_s", "sway of midship over ground"),
    {{"phi_rad", "rad", output, "heel, starboard side down"}, read<&Simulator::heel>},
    {{"validity", "1", output, "0 where the force model holds"}, read<&Simulator::why>},
    instrument<Channel::x>("instruments.x_m", "m"),
    instrument<Channel::y>("instruments.y_m", "m"),
    instrument<Channel::psi>("instruments.psi_rad", "rad"),
    instrument<Channel::speed_through_water>("instruments.stw_m_s", "m/s"),
    instrument<Channel::speed_over_ground>("instruments.sog_m_s", "m/s"),
    instrument<Channel::course_over_ground>("instruments.cog_rad", "rad"),
    instrument<Channel::r>("instruments.r_rad_s", "rad/s"),
    instrument<Channel::delta>("instruments.delta_rad", "rad"),
    instrument<Channel::rev>("instruments.rev_s", "1/s"),
    instrument<Channel::thrust>("instruments.thrust_N", "N"),
    instrument<Channel::phi>("instruments.phi_rad", "rad"),
    instrument<Channel::wind_speed>("instruments.wind_speed_m_s", "m/s"),
    instrument<Channel::wind_from>("instruments.wind_from_rad", "rad"),
};

const Row& row_named(const char* name) {
  const std::string_view wanted = &require(name, "the name of the quantity");
  for (const auto& row : rows)
    if (row.told.name == wanted) return row;
  std::string names;
  for (const auto& row : rows) names.append(" ").append(row.told.name);
  throw Refusal(fmt::format("there is no quantity \"{}\"; there are{}", wanted, names));
}

}  // namespace

const char* swayaw_error() { return trouble.c_str(); }

swayaw_ship* swayaw_open(const char* name, double speed) {
  return guarded<swayaw_ship*>(nullptr, [&] {
    const Ship ship = ship_named(name);
    return new swayaw_ship(ship, speed, visit_acting(ship, [](const auto& acting) { return acting.surroundings; }));
  });
}

void swayaw_close(swayaw_ship* ship) { delete ship; }

int swayaw_step(swayaw_ship* ship, double dt) {
  return guarded(-1, [&] {
    auto& s = require(ship, "the ship");
    s.simulator.step(require_positive(dt, "step [s]"));
    if (s.simulator.why() == SimulatorState::unbounded) throw Refusal(std::string(words_for(s.simulator.why())));
    return 0;
  });
}

const char* swayaw_why(const swayaw_ship* ship) {
  return guarded("", [&] { return words_for(require(ship, "the ship").simulator.why()).data(); });
}

const swayaw_quantity* swayaw_quantity_at(int index) {
  return index >= 0 && index < static_cast<int>(std::size(rows)) ? &rows[index].told : nullptr;
}

int swayaw_get(const swayaw_ship* ship, const char* name, double* value) {
  return guarded(-1, [&] {
    require(value, "the place of the value") = row_named(name).get(require(ship, "the ship"));
    return 0;
  });
}

int swayaw_set(swayaw_ship* ship, const char* name, double value) {
  return guarded(-1, [&] {
    auto& s = require(ship, "the ship");
    const auto& [told, get, set] = row_named(name);
    if (set == nullptr) throw Refusal(fmt::format("{} can be read, not set", told.name));
    const bool held = told.kind == order && get(s) == value && (set != set_thrust || s.by_thrust);
    if (!held) set(s, value);
    return 0;
  });
}

int swayaw_zigzag(const char* name, double speed, double rudder, double heading, int port_first,
                  swayaw_zigzag_indices* indices) {
  return guarded(-1, [&] {
    const Side first = port_first != 0 ? Side::port : Side::starboard;
    const auto at = speed == 0.0 ? std::nullopt : std::optional(speed);
    const auto run = zigzag(ship_named(name), {.rudder = rudder, .heading = heading, .first = first}, {.speed = at});
    auto& told = require(indices, "the place of the indices");
    for (std::size_t i = 0; i < std::size(told.reversal_s); ++i) {
      told.reversal_s[i] = i < run.reversals.size() ? run.reversals[i].time : missing;
      told.overshoot_rad[i] = i < run.reversals.size() ? run.reversals[i].overshoot.value_or(missing) : missing;
    }
    told.period_s = run.period.value_or(missing);
    return 0;
  });
}
