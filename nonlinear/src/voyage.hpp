#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/dense_output_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "swayaw/core/motion.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/controls.hpp"
#include "swayaw/nonlinear/mmg_forces.hpp"

/// Integration of a ship from event to event (docs/simulation.md). Not installed.
namespace swayaw {

/// x, y, psi, u, v, r
using StateVector = std::array<double, 6>;

inline StateVector vector_of(const ShipState<double>& s) { return {s.x, s.y, s.psi, s.motion.u, s.motion.v, s.motion.r}; }

inline ShipState<double> state_of(const StateVector& s) { return {s[0], s[1], s[2], {s[3], s[4], s[5]}}; }

/// A quantity that changes linearly in time.
struct Line {
  double start = 0.0;  ///< [s]
  double value = 0.0;  ///< at start
  double slope = 0.0;  ///< per second

  double at(double time) const { return value + slope * (time - start); }
};

/// Error of a step in units of the tolerance: lengths over L, angles in radians, speeds over U, r over U/L.
class ScaledError {
 public:
  ScaledError() = default;
  ScaledError(double tolerance, double L, double U)
      : weight_{1.0 / L, 1.0 / L, 1.0, 1.0 / U, 1.0 / U, L / U} {
    for (double& w : weight_) w /= tolerance;
  }

  template <class Algebra>
  double error(Algebra&, const StateVector&, const StateVector&, const StateVector& step_error, double) const {
    double worst = 0.0;
    for (std::size_t i = 0; i < step_error.size(); ++i) worst = std::max(worst, std::abs(step_error[i]) * weight_[i]);
    return worst;
  }

 private:
  StateVector weight_{};
};

/// Where the ship is at a time, and her controls.
struct Moment {
  double time;
  ShipState<double> state;
  Controls<double> controls;
};

/// Sails a ship through time with Dormand–Prince steps.
///
/// Controls are linear in time between the calls of `steer` and `turn_shaft`. Within a step the ship stays on
/// one branch of its force model; where a branch function passes zero the step is cut there.
/// Any event time is the root of the dense output, and the state there comes from a step that ends there.
template <class Model>
class Voyage {
 public:
  Voyage(const Model& ship, const Moment& start, double tolerance)
      : ship_(ship),
        time_(start.time),
        state_(vector_of(start.state)),
        rudder_{start.time, start.controls.delta, 0.0},
        shaft_{start.time, start.controls.rev, 0.0},
        time_unit_(ship.particulars.L / std::max(speed(start.state.motion), 0.05 * ship.particulars.U_0)),
        step_(0.02 * time_unit_),
        stepper_(Controlled(ScaledError(tolerance, ship.particulars.L, ship.particulars.L / time_unit_))) {
    const auto g = branch_functions(ship_, start.state.motion);
    for (std::size_t i = 0; i < g.size(); ++i) positive_[i] = g[i] > 0.0;
  }

  double time() const { return time_; }
  ShipState<double> state() const { return state_of(state_); }
  Controls<double> controls() const { return controls_at(time_); }

  /// From now on the rudder moves at that rate [rad/s].
  void steer(double rate) {
    rudder_ = {time_, rudder_.at(time_), rate};
    rudder_arrives_ = never;
    running_ = false;
  }

  /// From now on the rudder moves to that angle, as fast as the steering gear can.
  void order(double angle) {
    const double change = angle - rudder_.at(time_);
    steer(std::copysign(ship_.steering_gear.rate, change));
    rudder_arrives_ = time_ + std::abs(change) / ship_.steering_gear.rate;
    ordered_ = angle;
  }

  /// From now on the shaft speed changes at that rate [1/s^2].
  void turn_shaft(double rate) {
    shaft_ = {time_, shaft_.at(time_), rate};
    running_ = false;
  }

  /// Times at which `samples()` grow as the voyage passes them; in order, none before now.
  void sample_at(std::span<const double> times) { wanted_ = times; }
  std::vector<Moment>& samples() { return samples_; }

  /// Sails to `until`, or to the moment at which `watch(state)` passes zero.
  /// @return whether the watch ended it
  template <class Watch>
  bool sail(double until, Watch&& watch) {
    const auto g = [&](const StateVector& s) { return watch(state_of(s)); };
    double before = g(state_);
    while (time_ < until) {
      if (time_ >= rudder_arrives_) hold_rudder();
      const Stretch stretch = next_stretch(std::min(until, rudder_arrives_));
      const double after = g(stretch.end);
      const bool fired = passes_zero(before, after);
      const double event = fired ? root(stretch, g) : stretch.to;
      const BranchChange change = branch_change(stretch);
      const bool branch_first = change.time < event || (change.time == event && !fired);
      advance(stretch, branch_first ? change.time : event);
      if (branch_first) switch_branch(change);
      else if (fired) return true;
      const double now = g(state_);
      if (passes_zero(before, now)) return true;
      before = now;
    }
    return false;
  }

  void sail(double until) {
    sail(until, [](const ShipState<double>&) { return 1.0; });
  }

 private:
  using Stepper = boost::numeric::odeint::runge_kutta_dopri5<StateVector>;
  using Controlled = boost::numeric::odeint::controlled_runge_kutta<Stepper, ScaledError>;
  using DenseOutput = boost::numeric::odeint::dense_output_runge_kutta<Controlled>;
  static constexpr std::size_t branch_count = 2;

  /// An accepted step, cut at the time limit.
  struct Stretch {
    double from;
    double to;
    StateVector start;
    StateVector end;
    bool whole;  ///< the step ends at `to`
  };

  Controls<double> controls_at(double time) const { return {rudder_.at(time), shaft_.at(time)}; }

  auto rates() const {
    return [this](const StateVector& s, StateVector& rate, double time) {
      const PlanarMotion<double> m{s[3], s[4], s[5]};
      const auto force = forces(ship_, m, controls_at(time), {positive_[0], positive_[1]}).total();
      const auto a = acceleration(ship_, m, force);
      const double c = std::cos(s[2]), sn = std::sin(s[2]);
      rate = {m.u * c - m.v * sn, m.u * sn + m.v * c, m.r, a.u, a.v, a.r};
    };
  }

  struct BranchChange {
    double time;
    std::size_t index;
  };

  static bool passes_zero(double before, double after) {
    return before != 0.0 && (after == 0.0 || std::signbit(before) != std::signbit(after));
  }

  void hold_rudder() {
    rudder_ = {time_, ordered_, 0.0};
    rudder_arrives_ = never;
    running_ = false;
  }

  Stretch next_stretch(double until) {
    if (!running_) stepper_.initialize(state_, time_, std::min(step_, until - time_));
    running_ = true;
    const double from = time_;
    const double tried = stepper_.current_time_step();
    stepper_.do_step(rates());
    const double reached = stepper_.current_time();
    const bool cut_short = tried < step_ && reached - from >= tried;  // by the limit, not by the error
    step_ = cut_short ? std::max(step_, stepper_.current_time_step()) : stepper_.current_time_step();
    if (!cut_short) require_bounded(from);
    if (std::abs(reached - until) <= 1e-13 * time_unit_) return {from, until, state_, stepper_.current_state(), true};
    if (reached < until) return {from, reached, state_, stepper_.current_state(), true};
    return {from, until, state_, dense(until), false};
  }

  /// @throws Refusal  when the motion grows so fast that no step can follow it
  void require_bounded(double time) const {
    const auto& s = stepper_.current_state();
    const bool finite = std::isfinite(s[0] + s[1] + s[2] + s[3] + s[4] + s[5]);
    if (finite && stepper_.current_time_step() > 1e-8 * time_unit_) return;
    throw Refusal(fmt::format("the simulated motion grows without bound at {:.6g} s", time));
  }

  StateVector dense(double time) const {
    StateVector s;
    stepper_.calc_state(time, s);
    return s;
  }

  /// First time at which the ship leaves its branch; never, if it stays.
  BranchChange branch_change(const Stretch& stretch) const {
    BranchChange first{never, 0};
    const auto g0 = branch_functions(ship_, state_of(stretch.start).motion);
    const auto g1 = branch_functions(ship_, state_of(stretch.end).motion);
    for (std::size_t i = 0; i < branch_count; ++i) {
      if (g1[i] == 0.0 || (g1[i] > 0.0) == positive_[i]) continue;
      const bool left_before = g0[i] == 0.0 || (g0[i] > 0.0) != positive_[i];
      if (left_before && last_change_.time == stretch.from && last_change_.index == i) continue;
      const auto g = [&](const StateVector& s) { return branch_functions(ship_, state_of(s).motion)[i]; };
      const double time = left_before ? stretch.from : root(stretch, g);
      if (time < first.time) first = {time, i};
    }
    return first;
  }

  void switch_branch(const BranchChange& change) {
    positive_[change.index] = !positive_[change.index];
    last_change_ = change;
    running_ = false;
  }

  /// Root of g along the stretch, which must change sign on it.
  template <class G>
  double root(const Stretch& stretch, G&& g) const {
    const double g0 = g(stretch.start), g1 = g(stretch.end);
    if (g1 == 0.0) return stretch.to;
    std::uintmax_t iterations = 60;
    const auto tolerance = [this](double a, double b) { return b - a < 1e-13 * time_unit_ + 4e-16 * std::abs(b); };
    const auto bracket = boost::math::tools::toms748_solve([&](double t) { return g(dense(t)); }, stretch.from, stretch.to, g0, g1,
                                                           tolerance, iterations);
    return 0.5 * (bracket.first + bracket.second);
  }

  /// Moves to `to` within the stretch; a cut step is repeated so that it ends there.
  void advance(const Stretch& stretch, double to) {
    take_samples(to);
    const bool whole = to == stretch.to && stretch.whole;
    if (whole) {
      state_ = stretch.end;
    } else if (to > stretch.from) {
      Stepper step;
      step.do_step(rates(), stretch.start, stretch.from, state_, to - stretch.from);
    }
    running_ = whole && stepper_.current_time() == to;
    time_ = to;
  }

  void take_samples(double to) {
    while (!wanted_.empty() && wanted_.front() <= to) {
      const double time = wanted_.front();
      samples_.push_back({time, state_of(dense(time)), controls_at(time)});
      wanted_ = wanted_.subspan(1);
    }
  }

  static constexpr double never = std::numeric_limits<double>::infinity();

  Model ship_;
  double time_;
  StateVector state_;
  Line rudder_;
  Line shaft_;
  double time_unit_;  ///< L/U [s]
  double step_;       ///< step that the error control asks for [s]
  DenseOutput stepper_;
  bool running_ = false;
  std::array<bool, branch_count> positive_{};  ///< the branch
  BranchChange last_change_{-never, 0};
  double rudder_arrives_ = never;  ///< at the ordered angle [s]
  double ordered_ = 0.0;           ///< [rad]
  std::span<const double> wanted_;
  std::vector<Moment> samples_;
};

}  // namespace swayaw
