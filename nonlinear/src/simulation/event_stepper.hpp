#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/dense_output_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/util/odeint_error.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ship_stepper.hpp"
#include "swayaw/core/motion.hpp"
#include "swayaw/core/recording.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/core/steering_gear.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"
#include "swayaw/nonlinear/manoeuvres/manoeuvre_step.hpp"
#include "swayaw/nonlinear/models/branch.hpp"
#include "swayaw/nonlinear/models/models.hpp"
#include "swayaw/nonlinear/simulation/equations_of_motion.hpp"
#include "swayaw/nonlinear/simulation/rudder_track.hpp"
#include "swayaw/nonlinear/simulation/stepper_state.hpp"
#include "swayaw/nonlinear/surroundings/surroundings.hpp"

/// Integration of a ship from event to event (docs/simulation.md). Not installed.
namespace swayaw::inline nonlinear::detail {

/// Propulsion that changes linearly in time.
struct PropulsionLine {
  double start = 0.0;         ///< [s]
  Controls<double> value;     ///< at start; its rudder angle is not used
  Controls<double> slope{0};  ///< per second

  Controls<double> at(double time, double delta) const {
    const double t = time - start;
    return {delta,
            value.rev + slope.rev * t,
            {value.thrust.port + slope.thrust.port * t, value.thrust.starboard + slope.thrust.starboard * t},
            value.by_thrust};
  }
};

/// Error of a step in units of the tolerance: lengths over L, angles in radians, speeds over U, rates over U/L.
template <std::size_t HiddenStates>
class ScaledError {
 public:
  using State = StepperState<double, HiddenStates>;

  ScaledError() = default;
  ScaledError(double tolerance, double L, double U) {
    const std::array of_motion{1.0 / L, 1.0 / L, 1.0, 1.0 / U, 1.0 / U, L / U};
    for (std::size_t i = 0; i < weight_.size(); ++i)
      weight_[i] = (i < 6 ? of_motion[i] : 1.0 / hidden_quantities[i - 6].one(L, U)) / tolerance;
  }

  /// Infinite where it is not a number: a step that went beyond where the forces are known is repeated, shorter.
  template <class Algebra>
  double error(Algebra&, const State&, const State&, const State& step_error, double) const {
    double worst = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < step_error.size(); ++i) {
      const double error = std::abs(step_error[i]) * weight_[i];
      worst = std::max(worst, error);
      sum += error;
    }
    return std::isfinite(sum) ? worst : std::numeric_limits<double>::infinity();
  }

 private:
  State weight_{};
};

/// Moves a ship through time with Dormand–Prince steps.
///
/// The rudder follows `steer` or `order`, the propulsion is linear in time between calls of `drive`. Within a step the
/// ship stays on one branch of its force model; where a branch function passes zero, or the rudder rate jumps, the step
/// ends. Any event time is the root of the dense output, and the state there comes from a step that ends there. Where
/// the wind changes, the step ends too.
///
/// A ship whose effects have hidden states needs HiddenStates = hidden_count. Compiled once for each model
/// (event_stepper_mmg.cpp and so on); all else asks for a ShipStepper.
template <class Model, std::size_t HiddenStates = 0>
class EventStepper final : public ShipStepper {
 public:
  using State = StepperState<double, HiddenStates>;

  /// @param start  the rudder as the indicator shows it
  EventStepper(const ActingShip<Model>& acting, const Sample& start, double tolerance)
      : ship_(acting.model),
        surroundings_(acting.surroundings),
        changes_(acting.changes),
        added_(acting.added),
        with_added_(acting.added.any() || std::ranges::any_of(acting.changes, &Change::acting)),
        actuator_(acting.rudder),
        time_(start.time),
        state_(joined<HiddenStates>(vector_of(start.state),
                                    steady_hidden(acting.model, acting.added, start.state.motion, start.controls))),
        rudder_(RudderMotion<>::moving(start.time, start.controls.delta, 0.0)),
        propulsion_{start.time, start.controls},
        time_unit_(ship_.particulars.L / std::max(speed(start.state.motion), 0.05 * ship_.particulars.U_0)),
        step_(0.02 * time_unit_),
        integrator_(Controlled(Error(tolerance, ship_.particulars.L, ship_.particulars.L / time_unit_))) {
    pass_changes();
    if (actuator_.any()) {
      shown_ = rudder_;
      const AngleLine still{start.time, start.controls.delta, 0.0};
      track_ = RudderTrack(actuator_, std::span(&still, 1));
      next_motion_ = motions().size();
      rudder_ = rudder_.shifted(actuator_.offset);
    }
    branch_ = branch_at(ship_, start.state.motion, driven(added_, start.state.motion, controls()));
  }

  double time() const override { return time_; }
  ShipState<double> state() const override { return visible(state_); }
  Controls<double> controls() const override { return controls_at(time_); }

  double shown() const override { return shown_at(time_); }

  StateVector<double> rates_now() const override {
    State rate;
    rates()(state_, rate, time_);
    return {rate[0], rate[1], rate[2], rate[3], rate[4], rate[5]};
  }

  void steer(double rate) override { show(RudderMotion<>::moving(time_, shown(), rate)); }

  void order(double angle) override { show(RudderMotion<>::ordered(ship_.steering_gear, time_, shown(), angle)); }

  void steer_along(const RudderTrack& track) override {
    track_ = track;
    next_motion_ = 0;
    while (next_motion_ < motions().size() && motions()[next_motion_].start() <= time_) ++next_motion_;
    follow(motions()[std::max<std::size_t>(next_motion_, 1) - 1]);
  }

  void show_along(const Interpolant& angle) override { shown_along_ = &angle; }

  void remember(const Hidden<double>& hidden) override {
    state_ = joined<HiddenStates>(vector_of(visible(state_)), hidden);
    running_ = false;
  }

  void drive(const Controls<double>& rate) override {
    propulsion_ = {time_, controls(), rate};
    running_ = false;
  }

  using ShipStepper::advance;

  bool advance(double until, const Watch& watch) override {
    const auto g = [&](const State& s, double) { return watch(visible(s)); };
    double before = g(state_, time_);
    while (time_ < until) {
      const Stretch stretch = next_stretch(std::min({until, rudder_kink_, next_change_}));
      const double after = g(stretch.end, stretch.to);
      const bool fired = passes_zero(before, after);
      const double event = fired ? root(stretch, g) : stretch.to;
      const BranchChange change = branch_change(stretch);
      const bool branch_first = change.time < event || (change.time == event && !fired);
      move_to(stretch, branch_first ? change.time : event);
      note(branch_first            ? StepEnd::branch
           : fired                 ? StepEnd::watch
           : time_ >= rudder_kink_ ? StepEnd::kink
                                   : StepEnd::none,
           change.index);
      if (time_ >= rudder_kink_) pass_rudder_kink();
      if (time_ >= next_change_) pass_changes();
      if (branch_first) switch_branch(change);
      else if (fired) return true;
      const double now = g(state_, time_);
      if (passes_zero(before, now)) return note_watch();
      before = now;
    }
    return false;
  }

 private:
  using Error = ScaledError<HiddenStates>;
  using DormandPrince = boost::numeric::odeint::runge_kutta_dopri5<State>;
  using Controlled = boost::numeric::odeint::controlled_runge_kutta<DormandPrince, Error>;
  using DenseOutput = boost::numeric::odeint::dense_output_runge_kutta<Controlled>;

  /// An accepted step, cut at the time limit.
  struct Stretch {
    double from;
    double to;
    State start;
    State end;
    bool whole;  ///< the step ends at `to`
  };

  Controls<double> controls_at(double time) const { return propulsion_.at(time, rudder_.at(time)); }

  double shown_at(double time) const {
    if (shown_along_) return (*shown_along_)(time);
    return actuator_.any() ? shown_.at(time) : rudder_.at(time);
  }

  auto rates() const {
    return [this](const State& s, State& rate, double time) {
      if constexpr (HiddenStates > 0) rate = rates_with_hidden(s, time);
      else if (with_added_)
        rate = rates_of(ship_, surroundings_, added_, visible(s), Hidden<double>{}, controls_at(time), branch_);
      else rate = rates_without_effects(s, time);
    };
  }

  /// Inlined as a whole: most simulations spend their time here.
  [[gnu::flatten]] State rates_without_effects(const State& s, double time) const requires(HiddenStates == 0) {
    return rates_of(ship_, surroundings_, visible(s), controls_at(time), branch_);
  }

  State rates_with_hidden(const State& s, double time) const {
    const auto state = visible(s);
    const auto hidden = hidden_of(s);
    const auto r = rates_of(ship_, surroundings_, added_, state, hidden, controls_at(time), branch_);
    return joined<HiddenStates>(r, hidden_rates(ship_, added_, state.motion, hidden, controls_at(time)));
  }

  /// What the indicator shows from now on, and the rudder behind it.
  void show(const RudderMotion<>& motion) {
    if (!actuator_.any()) return follow(motion);
    shown_ = motion;
    if (!actuator_.moves()) return follow(motion.shifted(actuator_.offset));
    const auto lines = lines_of(motion, time_);
    steer_along(RudderTrack(actuator_, lines, track_));
  }

  std::span<const RudderMotion<>> motions() const { return track_.motions(); }

  double next_motion() const { return next_motion_ < motions().size() ? motions()[next_motion_].start() : never; }

  void follow(const RudderMotion<>& motion) {
    rudder_ = motion;
    rudder_kink_ = std::min(rudder_.next_kink(time_), next_motion());
    running_ = false;
  }

  /// Wind and forces as they are from now on.
  void pass_changes() {
    while (next_ < changes_.size() && changes_[next_].time <= time_) {
      changes_[next_++].apply(surroundings_, added_);
      running_ = false;
    }
    next_change_ = next_ < changes_.size() ? changes_[next_].time : never;
  }

  struct BranchChange {
    double time;
    std::size_t index;
  };

  static bool passes_zero(double before, double after) {
    return before != 0.0 && (after == 0.0 || std::signbit(before) != std::signbit(after));
  }

  void pass_rudder_kink() {
    while (time_ >= next_motion()) follow(motions()[next_motion_++]);
    rudder_kink_ = std::min(rudder_.next_kink(time_), next_motion());
    running_ = false;
  }

  void note(StepEnd end, std::size_t function) {
    static_assert(Model::branch_count <= most_branches);
    if (!traced_) return;
    ManoeuvreStep step{.to = time_, .end = end, .branch = {}, .function = function};
    std::ranges::copy(branch_, step.branch.begin());
    steps_.push_back(step);
  }

  /// The watch was at zero where something else ended the step. @return true
  bool note_watch() {
    if (traced_) steps_.back().end = StepEnd::watch;
    return true;
  }

  Stretch next_stretch(double until) {
    if (!running_) integrator_.initialize(state_, time_, std::min(step_, until - time_));
    running_ = true;
    const double from = time_;
    const double tried = integrator_.current_time_step();
    do_step(from);
    const double reached = integrator_.current_time();
    const double rounding = 4e-16 * std::abs(reached);
    const bool cut_short = tried < step_ && reached - from >= tried - rounding;  // by the limit, not by the error
    step_ = cut_short ? std::max(step_, integrator_.current_time_step()) : integrator_.current_time_step();
    if (!cut_short) require_bounded(from);
    if (std::abs(reached - until) <= 1e-13 * time_unit_)
      return {from, until, state_, integrator_.current_state(), true};
    if (reached < until) return {from, reached, state_, integrator_.current_state(), true};
    return {from, until, state_, dense(until), false};
  }

  /// @throws Refusal  when no step is short enough, or steps are so short that the run would hardly end
  void do_step(double time) {
    if (time - counted_from_ > time_unit_) counted_from_ = time, steps_taken_ = 0;
    if (++steps_taken_ > most_steps_per_length)
      throw Refusal(
          fmt::format("the simulation cannot go on at {:.6g} s: her motion changes within {:.2g} s, which is no "
                      "motion of a ship, by {}",
                      time, integrator_.current_time_step(), largest_part()));
    try {
      integrator_.do_step(rates());
    } catch (const boost::numeric::odeint::odeint_error&) {  // five hundred shorter steps are none either
      require_way(time);
      refuse_unbounded(time);
    }
  }

  /// @throws Refusal  when the ship comes to a stop, or her motion grows so fast, that no step can follow it
  void require_bounded(double time) const {
    const auto& s = integrator_.current_state();
    const bool finite = std::isfinite(std::accumulate(s.begin(), s.end(), 0.0));
    if (finite && integrator_.current_time_step() > 1e-8 * time_unit_) return;
    require_way(time);
    refuse_unbounded(time);
  }

  [[noreturn]] void refuse_unbounded(double time) const {
    throw Refusal(fmt::format("the simulated motion grows without bound at {:.6g} s, by {}", time, largest_part()));
  }

  /// The part of the force, in words, that accelerates the ship most at the last motion that was finite; one that is
  /// not finite itself before all others.
  std::string largest_part() const {
    const auto state = visible(state_);
    const auto now = controls_at(time_);
    std::string_view name = "nothing";
    PlanarForce<double> largest{0.0, 0.0, 0.0};
    double most = -1.0;
    const auto look = [&](std::string_view part, const PlanarForce<double>& f) {
      const double size = std::abs(f.X) + std::abs(f.Y) + std::abs(f.N) / ship_.particulars.L;
      const double rank = std::isfinite(size) ? size : std::numeric_limits<double>::infinity();
      if (rank > most) name = part, largest = f, most = rank;
    };
    const auto split = forces(ship_, state.motion, driven(added_, state.motion, now));
    for (const auto& [part, force] : split.parts()) look(part, force);
    for_each_added(ship_, added_, state, steady_hidden(ship_, added_, state.motion, now), now, look);
    return fmt::format("{} with X = {:.2g} N, Y = {:.2g} N, N = {:.2g} N m", name, largest.X, largest.Y, largest.N);
  }

  /// The steps end where u would pass zero.
  /// @throws Refusal  when the little way that the ship has is about to end
  void require_way(double time) const {
    State rate;
    rates()(state_, rate, time);
    const double u = state_[3], approach = ship_.particulars.L / time_unit_;
    const double left = u / -rate[3];  // until u = 0, at that deceleration
    const bool stops = u <= 0.1 * approach && left >= 0.0 && left <= 0.1 * time_unit_;
    if (!stops) return;
    throw Refusal(
        fmt::format("the ship loses her way at {:.4g} s, adrift with u = {:.2g}, v = {:.2g} m/s: the model holds for "
                    "way ahead only",
                    time + left, u, state_[4]));
  }

  State dense(double time) const {
    State s;
    integrator_.calc_state(time, s);
    return s;
  }

  auto branch_functions_at(const State& s, double time) const {
    const auto m = visible(s).motion;
    return branch_functions(ship_, m, driven(added_, m, controls_at(time)));
  }

  /// First time at which the ship leaves its branch; never, if it stays.
  BranchChange branch_change(const Stretch& stretch) const {
    BranchChange first{never, 0};
    const auto after = branch_functions_at(stretch.end, stretch.to);
    for (std::size_t i = 0; i < after.size(); ++i) {
      if (after[i] == 0.0 || (after[i] > 0.0) == branch_[i]) continue;
      const double before = branch_functions_at(stretch.start, stretch.from)[i];
      const bool left_before = before == 0.0 || (before > 0.0) != branch_[i];
      if (left_before && last_change_.time == stretch.from && last_change_.index == i) continue;
      const auto g = [&](const State& s, double time) { return branch_functions_at(s, time)[i]; };
      const double time = left_before ? stretch.from : root(stretch, g);
      if (time < first.time) first = {time, i};
    }
    return first;
  }

  void switch_branch(const BranchChange& change) {
    branch_[change.index] = !branch_[change.index];
    last_change_ = change;
    running_ = false;
  }

  /// Root of g along the stretch, which must change sign on it.
  /// @throws Refusal  where g is no number: the motion has outgrown it
  template <class G>
  double root(const Stretch& stretch, G&& g) const {
    const double g0 = g(stretch.start, stretch.from), g1 = g(stretch.end, stretch.to);
    if (g1 == 0.0) return stretch.to;
    if (!std::isfinite(g0) || !std::isfinite(g1)) refuse_unbounded(stretch.from);
    std::uintmax_t iterations = 60;
    const auto tolerance = [this](double a, double b) { return b - a < 1e-13 * time_unit_ + 4e-16 * std::abs(b); };
    const auto bracket = boost::math::tools::toms748_solve([&](double t) { return g(dense(t), t); }, stretch.from,
                                                           stretch.to, g0, g1, tolerance, iterations);
    return 0.5 * (bracket.first + bracket.second);
  }

  /// Moves to `to` within the stretch; a cut step is repeated so that it ends there.
  void move_to(const Stretch& stretch, double to) {
    take_samples(to);
    const bool whole = to == stretch.to && stretch.whole;
    if (whole) {
      state_ = stretch.end;
    } else if (to > stretch.from) {
      DormandPrince step;
      step.do_step(rates(), stretch.start, stretch.from, state_, to - stretch.from);
    }
    running_ = whole && integrator_.current_time() == to;
    time_ = to;
  }

  void take_samples(double to) {
    while (!wanted_.empty() && wanted_.front() <= to) {
      const double time = wanted_.front();
      const auto s = dense(time);
      samples_.push_back({time, visible(s), controls_at(time), shown_at(time), hidden_of(s)});
      wanted_ = wanted_.subspan(1);
    }
  }

  static constexpr double never = std::numeric_limits<double>::infinity();

  /// Steps in the time of a ship length. A zigzag takes some five with an error of 1e-9, a rudder recorded at 100 Hz on
  /// a ship of 300 m 4000; a ship of which so many lead nowhere is refused within seconds.
  static constexpr std::size_t most_steps_per_length = 20'000;

  Model ship_;
  Surroundings<double> surroundings_;
  std::vector<Change> changes_;
  std::size_t next_ = 0;  ///< of them
  ActingEffects<double> added_;
  bool with_added_;
  RudderActuator actuator_;
  double time_;
  State state_;
  RudderMotion<> rudder_;
  PropulsionLine propulsion_;
  double time_unit_;  ///< L/U [s]
  double step_;       ///< step that the error control asks for [s]
  DenseOutput integrator_;
  bool running_ = false;
  Branch<double, Model::branch_count> branch_{};
  BranchChange last_change_{-never, 0};
  double rudder_kink_ = never;  ///< when the rudder rate jumps next [s]
  double next_change_ = never;  ///< when the wind or a force changes next [s]
  RudderMotion<> shown_;        ///< of the indicator, where the rudder is not as it shows
  const Interpolant* shown_along_ = nullptr;
  RudderTrack track_;
  std::size_t next_motion_ = 0;
  double counted_from_ = -never;  ///< when steps were counted anew [s]
  std::size_t steps_taken_ = 0;
};

template <class Model>
std::unique_ptr<ShipStepper> make_stepper(const ActingShip<Model>& acting, const Sample& start, double tolerance) {
  const auto hides = [&](const Change& change) { return ActingEffects<>{.acting = change.acting}.hidden(); };
  if (acting.added.hidden() || std::ranges::any_of(acting.changes, hides))
    return std::make_unique<EventStepper<Model, hidden_count>>(acting, start, tolerance);
  return std::make_unique<EventStepper<Model>>(acting, start, tolerance);
}

}  // namespace swayaw::nonlinear::detail
