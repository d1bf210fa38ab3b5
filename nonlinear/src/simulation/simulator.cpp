#include "swayaw/nonlinear/simulator.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "held_forces.hpp"
#include "rudder_follower.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"
#include "swayaw/nonlinear/instruments/instruments.hpp"
#include "swayaw/nonlinear/simulation/equations_of_motion.hpp"
#include "swayaw/nonlinear/simulation/runge_kutta.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"
#include "swayaw/nonlinear/surroundings/windage_sources.hpp"

namespace swayaw::inline nonlinear {
using namespace detail;
namespace {

double require_finite(double value, std::string_view quantity) {
  if (std::isfinite(value)) return value;
  throw std::domain_error(fmt::format("{} must be a finite number, got {}", quantity, value));
}

// ---------------------------------------------------------------- rudder

/// Steering gear, play, lag and offset, one after the other.
class RudderChain {
 public:
  RudderChain(const SteeringGear<double>& gear, const RudderActuator& actuator, double angle)
      : gear_(gear),
        actuator_(actuator),
        shown_(RudderMotion<>::moving(0.0, angle, 0.0)),
        play_(actuator.width, angle),
        lag_(actuator.lag, actuator.rate, angle) {}

  void order(double time, double angle) {
    ordered_ = std::clamp(angle, -gear_.max_angle, gear_.max_angle);
    shown_ = RudderMotion<>::ordered(gear_, time, shown_.at(time), ordered_);
  }

  void set(double time, double angle) {
    ordered_ = angle;
    shown_ = RudderMotion<>::moving(time, angle, 0.0);
  }

  /// When the rate of the indicator jumps next.
  double next_kink(double time) const { return shown_.next_kink(time); }

  double ordered() const { return ordered_; }
  double shown(double time) const { return shown_.at(time); }
  double angle(double time) const { return (actuator_.moves() ? lag_.angle() : shown_.at(time)) + actuator_.offset; }

  /// The rudder goes on behind the indicator, whose motion in that time counts as a straight line.
  void follow(double from, double to) {
    if (!actuator_.moves()) return;
    const double x = shown_.at(from);
    const AngleLine line{from, x, (shown_.at(to) - x) / (to - from)};
    if (actuator_.width > 0.0) play_.follow(line, to - from, [&](const AngleLine& part) { take(part, line, to); });
    else lag_.follow(line, to, [](const RudderMotion<>&) {});
  }

 private:
  /// A line behind the play ends where the flank takes the rudder along, or at the end.
  void take(const AngleLine& part, const AngleLine& line, double to) {
    const bool rests = part.rate == 0.0 && line.rate != 0.0;
    const double flank = part.angle + std::copysign(0.5 * actuator_.width, line.rate);
    const double end = rests ? std::min(to, line.time + (flank - line.angle) / line.rate) : to;
    if (end > part.time) lag_.follow(part, end, [](const RudderMotion<>&) {});
  }

  SteeringGear<double> gear_;
  RudderActuator actuator_;
  RudderMotion<> shown_;
  PlayFollower play_;
  LagFollower lag_;
  double ordered_ = 0.0;
};

// ---------------------------------------------------------------- wind

/// Velocity of the air, northward and eastward [m/s].
struct AirVelocity {
  double north = 0.0, east = 0.0;
};

AirVelocity velocity_of(const Wind<double>& wind, bool windy) {
  if (!windy) return {};
  return {-wind.speed * std::cos(wind.from), -wind.speed * std::sin(wind.from)};
}

/// A steady wind, and the gust on top of it.
class GustyWind {
 public:
  GustyWind() = default;
  GustyWind(const Wind<double>& steady, bool windy) : steady_(steady), windy_(windy) {}

  void set(const Wind<double>& steady) { steady_ = steady, windy_ = true; }

  /// The gust of a change, whose wind has the steady one in it that the ship came with.
  AirVelocity gust_of(const Change& change) const {
    const auto all = velocity_of(change.wind, change.windy), mean = velocity_of(steady_, windy_);
    return {all.north - mean.north, all.east - mean.east};
  }

  void blow(const AirVelocity& gust, Surroundings<double>& around) const {
    around.windy = windy_ || gust.north != 0.0 || gust.east != 0.0;
    around.wind = steady_;
    if (gust.north == 0.0 && gust.east == 0.0) return;
    const auto mean = velocity_of(steady_, windy_);
    const double north = mean.north + gust.north, east = mean.east + gust.east;
    around.wind = {std::hypot(north, east), std::atan2(-east, -north)};
  }

 private:
  Wind<double> steady_;
  bool windy_ = false;
};

/// What begins or ends at a time.
struct TimedChange {
  double time;
  AirVelocity gust;
  std::uint32_t acting;  ///< which effects act from then on
};

}  // namespace

std::string_view words_for(SimulatorState state) {
  switch (state) {
    case SimulatorState::valid: return "the force model holds";
    case SimulatorState::little_way: return "the ship has too little way for her force model";
    case SimulatorState::turns_on_the_spot: return "drift or yaw rate are beyond the force model";
    case SimulatorState::too_fast: return "the ship is too fast for her force model";
    case SimulatorState::shaft_astern: return "the shaft turns astern, which counts as stopped";
    case SimulatorState::unbounded: return "the motion grew without bound and was not followed";
  }
  return "";
}

// ---------------------------------------------------------------- one ship, whatever her model

class Simulator::Core {
 public:
  virtual ~Core() = default;
  virtual void step(double dt) = 0;
  virtual void begin(const ShipState<double>& state) = 0;
  virtual void require_drive(bool by_thrust) const = 0;
  virtual double thrust() const = 0;
  virtual double heel() const = 0;
  virtual SimulatorState why() const = 0;
  virtual std::span<const ForcePart<double>> forces() = 0;
  virtual std::array<double, channel_count> instruments() = 0;

  Controls<double> controls() const { return with_rudder(propulsion, rudder.angle(time)); }
  void blow() { wind.blow(gust, around); }

  double time = 0.0;
  ShipState<double> state{};
  Controls<double> propulsion;
  RudderChain rudder;
  Surroundings<double> around;
  GustyWind wind;
  AirVelocity gust;
  PlanarForce<double> given{0.0, 0.0, 0.0};

 protected:
  Core(const Controls<double>& held, const RudderChain& chain, const Surroundings<double>& surroundings)
      : propulsion(held), rudder(chain), around(surroundings), wind(surroundings.wind, surroundings.windy) {}
};

template <class Model>
class Simulator::CoreOf : public Simulator::Core {
 public:
  CoreOf(const ActingShip<Model>& acting, const Controls<double>& held, double speed, double longest_step)
      : Core(held, RudderChain(acting.model.steering_gear, acting.rudder, 0.0), acting.surroundings),
        ship_(acting.model),
        effects_{.effects = acting.added, .any = acting.added.any()},
        instruments_(acting.instruments),
        longest_(longest_step * acting.model.particulars.L / acting.model.particulars.U_0) {
    for (const auto& change : acting.changes) changes_.push_back({change.time, wind.gust_of(change), change.acting});
    pass_changes();
    begin({0.0, 0.0, 0.0, {speed, 0.0, 0.0}});
  }

  void begin(const ShipState<double>& from) override {
    state = from;
    hidden_ = steady_hidden(ship_.model, effects_.effects, held(from.motion, ship_.L(), ship_.U_0()).motion,
                            held(controls()));
    unbounded_ = false;
  }

  void step(double dt) override {
    effects_.given = given;
    const double end = time + dt;
    while (time < end) {
      const double change = next_ < changes_.size() ? changes_[next_].time : end;
      const double edge = std::min({end, change, rudder.next_kink(time)});
      const int count = std::max(1, static_cast<int>(std::ceil((edge - time) / longest_ * (1.0 - 1e-9))));
      const double from = time, h = (edge - from) / count;
      for (int i = 0; i < count; ++i) take_step(from + i * h, i + 1 == count ? edge : from + (i + 1) * h);
      pass_changes();
    }
  }

  void require_drive(bool by_thrust) const override {
    const auto given_one = std::optional(1.0);
    swayaw::require_drive(ShipModel(ship_.model), by_thrust ? std::nullopt : given_one,
                          by_thrust ? given_one : std::nullopt);
  }

  double heel() const override { return shown_by(hidden_, Channel::phi); }

  double thrust() const override {
    const auto c = held(driven(effects_, state.motion, controls()));
    return swayaw::thrust(ship_.model, held(state.motion, ship_.L(), ship_.U_0()).motion, c);
  }

  SimulatorState why() const override {
    if (unbounded_) return SimulatorState::unbounded;
    const auto reason = held(state.motion, ship_.L(), ship_.U_0()).why;
    const auto c = driven(effects_, state.motion, controls());
    if (reason == SimulatorState::valid && !c.by_thrust && c.rev < 0.0) return SimulatorState::shaft_astern;
    return reason;
  }

  std::span<const ForcePart<double>> forces() override {
    const auto c = driven(effects_, state.motion, controls());
    std::size_t count = 0;
    const auto add = [&](std::string_view name, const PlanarForce<double>& force) { parts_[count++] = {name, force}; };
    const auto split = detail::forces(ship_, state.motion, c, held_branch(ship_, state.motion, c));
    for (const auto& part : split.part) add(part.name, part.force);
    if (around.windy) add("wind", wind_load(around, state));
    auto at = state;
    at.motion = held(state.motion, ship_.L(), ship_.U_0()).motion;
    if (effects_.any) for_each_added(ship_.model, effects_.effects, at, hidden_, held(controls()), add);
    add("given", given);
    return {parts_.data(), count};
  }

  std::array<double, channel_count> instruments() override {
    std::array<double, channel_count> shown;
    shown.fill(missing);
    const auto rate = rates(joined(state, hidden_), controls(), held_branch(ship_, state.motion, controls()));
    const ReadingTime reading{.time = time, .begin = 0.0};
    const auto ago = [&](double delay) {
      const PlanarAcceleration<double> acceleration{rate[3], rate[4], rate[5]};
      return kinematics(moved_back(state, around.current, acceleration, delay), around.current,
                        shown_by(hidden_, Channel::phi) - delay * shown_by(hidden_of(rate), Channel::phi));
    };
    for (const auto channel : motion_channels())
      if (channel != Channel::phi || rolls()) shown[index_of(channel)] = observe(channel, instruments_, ago, reading);
    const auto put = [&](Channel channel, double value, double change) {
      const auto& error = instruments_[channel];
      shown[index_of(channel)] = error.reading(value - (error.late(reading) + error.smoothing.mean()) * change);
    };
    put(Channel::delta, rudder.shown(time), shown_rate_), put(Channel::delta_order, rudder.ordered(), 0.0);
    if (takes_shaft_speed(ship_.model) && !propulsion.by_thrust) put(Channel::rev, propulsion.rev, 0.0);
    if constexpr (requires { ship_.model.propeller; }) put(Channel::thrust, thrust(), 0.0);
    put(Channel::wind_speed, around.windy ? around.wind.speed : 0.0, 0.0),
        put(Channel::wind_from, around.wind.from, 0.0);
    return shown;
  }

 private:
  /// x, y, psi, u, v, r, and the hidden states of effects.
  using State = std::array<double, 6 + hidden_count>;
  using ShipBranch = Branch<double, Model::branch_count>;

  static ShipState<double> visible(const State& s) { return {s[0], s[1], s[2], {s[3], s[4], s[5]}}; }

  static Hidden<double> hidden_of(const State& s) {
    Hidden<double> hidden;
    std::copy_n(s.begin() + 6, hidden_count, hidden.begin());
    return hidden;
  }

  static State joined(const ShipState<double>& s, const Hidden<double>& hidden) {
    State state{s.x, s.y, s.psi, s.motion.u, s.motion.v, s.motion.r};
    std::ranges::copy(hidden, state.begin() + 6);
    return state;
  }

  bool rolls() const {
    bool rolls = false;
    for_each_acting(effects_.effects, [&](auto i, const auto&) {
      for (std::size_t k = hidden_place[i.value]; k < hidden_place[i.value + 1]; ++k)
        rolls = rolls || hidden_quantities[k].channel == Channel::phi;
    });
    return rolls;
  }

  State rates(const State& s, const Controls<double>& c, const ShipBranch& branch) const {
    const auto now = visible(s);
    const auto hidden = hidden_of(s);
    const auto rate = rates_of(ship_, around, effects_, now, hidden, c, branch);
    return joined(state_of(rate),
                  effects_.effects.hidden() ? rates_of_hidden(now.motion, hidden, c) : Hidden<double>{});
  }

  Hidden<double> rates_of_hidden(const PlanarMotion<double>& m, const Hidden<double>& hidden,
                                 const Controls<double>& c) const {
    const auto at = held(m, ship_.L(), ship_.U_0()).motion;
    return hidden_rates(effects_.effects, m, hidden,
                        followed_sway_by_rudder(ship_.model, effects_.effects, at, held(c)));
  }

  void take_step(double from, double to) {
    const double h = to - from, middle = from + 0.5 * h, shown = rudder.shown(from);
    const auto c0 = with_rudder(propulsion, rudder.angle(from));
    rudder.follow(from, middle);
    const auto c1 = with_rudder(propulsion, rudder.angle(middle));
    rudder.follow(middle, to);
    const auto c2 = with_rudder(propulsion, rudder.angle(to));
    shown_rate_ = (rudder.shown(to) - shown) / h;
    const auto branch = held_branch(ship_, state.motion, driven(effects_, state.motion, c0));
    const auto with = [&](const Controls<double>& c) { return [&](const State& s) { return rates(s, c, branch); }; };
    const auto next = runge_kutta_step(joined(state, hidden_), h, with(c0), with(c1), with(c2));
    time = to;
    double sum = 0.0;
    for (const double value : next) sum += value;
    unbounded_ = !std::isfinite(sum);
    if (unbounded_) return;
    state = visible(next);
    hidden_ = hidden_of(next);
  }

  void pass_changes() {
    for (; next_ < changes_.size() && changes_[next_].time <= time; ++next_) {
      gust = changes_[next_].gust;
      effects_.effects.acting = changes_[next_].acting;
      effects_.any = effects_.effects.any();
      blow();
    }
  }

  HeldModel<Model> ship_;
  HeldEffects effects_;
  std::vector<TimedChange> changes_;
  std::size_t next_ = 0;
  Instruments<double> instruments_;
  double longest_;  ///< step [s]
  Hidden<double> hidden_;
  bool unbounded_ = false;
  double shown_rate_ = 0.0;  ///< of the indicator in the last step [rad/s]
  std::array<ForcePart<double>, 16> parts_;
};

// ---------------------------------------------------------------- what is seen

Simulator::Simulator(const Ship& ship, const SimulatorOptions& options) {
  const double speed = options.speed == 0.0 ? service_speed(ship) : require_positive(options.speed, "speed [m/s]");
  const double longest = require_positive(options.longest_step, "longest step [L/U]");
  const auto held = propulsion(ship, speed, std::nullopt, std::nullopt);
  visit_acting(ship, [&]<class Model>(const ActingShip<Model>& acting) {
    core_ = std::make_unique<CoreOf<Model>>(acting, held, speed, longest);
  });
}

Simulator::Simulator(Simulator&&) noexcept = default;
Simulator& Simulator::operator=(Simulator&&) noexcept = default;
Simulator::~Simulator() = default;

void Simulator::step(double dt) noexcept {
  if (dt > 0.0 && std::isfinite(dt)) core_->step(dt);
}

void Simulator::order_rudder(double angle) {
  core_->rudder.order(core_->time, require_finite(angle, "rudder order [rad]"));
}

void Simulator::set_rudder(double angle) {
  core_->rudder.set(core_->time, require_finite(angle, "rudder angle [rad]"));
}

void Simulator::set_shaft_speed(double rev) {
  core_->require_drive(false);
  core_->propulsion = {.delta = 0.0, .rev = require_finite(rev, "shaft speed [1/s]")};
}

void Simulator::set_thrust(double thrust) {
  core_->require_drive(true);
  const double half = 0.5 * require_finite(thrust, "thrust [N]");
  core_->propulsion = {.delta = 0.0, .thrust = {half, half}, .by_thrust = true};
}

void Simulator::set_wind(const Wind<double>& wind) {
  require_finite(wind.speed, "wind speed [m/s]"), require_finite(wind.from, "wind direction [rad]");
  if (wind.speed != 0.0 && !feels_wind(core_->around.windage))
    throw Refusal("the ship file does not tell what she shows the wind");
  core_->wind.set(wind);
  core_->blow();
}

void Simulator::set_current(const Current<double>& current) {
  require_finite(current.speed, "current [m/s]"), require_finite(current.to, "direction of the current [rad]");
  core_->around.current = current;
}

void Simulator::set_added_force(const PlanarForce<double>& force) {
  require_finite(force.X + force.Y + force.N, "added force [N, N m]");
  core_->given = force;
}

void Simulator::set_state(const ShipState<double>& state) {
  const auto& m = state.motion;
  require_finite(state.x + state.y + state.psi + m.u + m.v + m.r, "state of the ship");
  core_->begin(state);
}

double Simulator::time() const noexcept { return core_->time; }
const ShipState<double>& Simulator::state() const noexcept { return core_->state; }
PlanarMotion<double> Simulator::velocity_over_ground() const noexcept {
  return over_ground(core_->around.current, core_->state);
}
double Simulator::heel() const noexcept { return core_->heel(); }
double Simulator::rudder() const noexcept { return core_->rudder.angle(core_->time); }
double Simulator::rudder_shown() const noexcept { return core_->rudder.shown(core_->time); }
double Simulator::shaft_speed() const noexcept { return core_->propulsion.rev; }
double Simulator::thrust() const noexcept { return core_->thrust(); }
std::span<const ForcePart<double>> Simulator::forces() const noexcept { return core_->forces(); }
std::array<double, channel_count> Simulator::instruments() const noexcept { return core_->instruments(); }
SimulatorState Simulator::why() const noexcept { return core_->why(); }

}  // namespace swayaw::nonlinear
