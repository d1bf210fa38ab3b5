#pragma once

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cstdint>
#include <optional>

#include "swayaw/core/dual.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/models/branch.hpp"
#include "swayaw/nonlinear/simulation/equations_of_motion.hpp"
#include "swayaw/nonlinear/simulation/runge_kutta.hpp"
#include "swayaw/nonlinear/simulation/segment_simulator.hpp"

/// Classical Runge–Kutta steps in double or dual numbers, on one branch of the force model at a time. Not installed.
namespace swayaw::inline nonlinear::detail {

/// Controls that change in straight lines over a time.
struct ControlLine {
  Controls<double> begin, end;
  double duration;  ///< [s]

  template <class T>
  Controls<T> at(const T& t) const {
    return between(begin, end, T(t / duration));
  }
};

template <class S>
StateVector<double> values_of(const StateVector<S>& s) {
  StateVector<double> values;
  std::ranges::transform(s, values.begin(), [](const S& x) { return value_of(x); });
  return values;
}

/// Steps of one ship in surroundings.
template <template <class> class Model, class S>
class Stepper {
 public:
  using ShipBranch = Branch<double, Model<double>::branch_count>;

  Stepper(const Model<S>& ship, const Surroundings<S>& around) : ship_(ship), around_(around) {}

  void blow(const Air& air) {
    around_.wind = {S(air.wind.speed), S(air.wind.from)};
    around_.windy = air.windy;
  }

  /// The classical Runge–Kutta step. Times may be numbers or duals.
  template <class T>
  StateVector<S> step(const StateVector<S>& s, const ControlLine& line, const T& t, const T& h,
                      const ShipBranch& branch) const {
    const auto with = [&](const Controls<S>& c) {
      return [&ship = ship_, &around = around_, &branch, c](const StateVector<S>& at) {
        return rates_of(ship, around, state_of(at), c, branch);
      };
    };
    return runge_kutta_step(s, h, with(cast<S>(line.at(t))), with(cast<S>(line.at(T(t + 0.5 * h)))),
                            with(cast<S>(line.at(T(t + h)))));
  }

  /// Branch functions at a state.
  auto functions(const StateVector<S>& s, const Controls<S>& c) const {
    return branch_functions(ship_, state_of(s).motion, c);
  }

  /// Rates of the state, for the speed of branch functions.
  StateVector<S> rates(const StateVector<S>& s, const Controls<S>& c, const ShipBranch& branch) const {
    return rates_of(ship_, around_, state_of(s), c, branch);
  }

 private:
  Model<S> ship_;
  Surroundings<S> around_;
};

/// Where a branch function passes zero within a step.
struct BranchEvent {
  std::size_t which;
  double after;  ///< seconds from the beginning of the step
};

/// Integrates a state along a control line, from branch to branch.
///
/// A step ends where a branch function g passes zero; with duals the length h of that step is one too,
///
///     g(x(h), θ) = 0   ⟹   dh/dθ = −(dg/dθ)/(dg/dt),
///
/// so that derivatives are those of the simulation also where the force jumps.
template <template <class> class Model, class S>
class BranchStepper {
 public:
  using Plain = Stepper<Model, double>;
  using ShipBranch = typename Plain::ShipBranch;

  BranchStepper(const Model<double>& model, const Model<S>& ship, const Surroundings<double>& around)
      : plain_(model, around), along_(cast<Dual<1>>(model), cast<Dual<1>>(around)), stepper_(ship, cast<S>(around)) {}

  void begin(const StateVector<double>& s, const Controls<double>& c) { branch_ = branch_of(s, c); }

  /// From now on that wind blows.
  void blow(const Air& air) { plain_.blow(air), along_.blow(air), stepper_.blow(air); }

  void advance(StateVector<S>& s, const ControlLine& line, double t, double h) {
    const auto next = stepper_.step(s, line, t, h, branch_);
    if (branch_of(values_of(next), line.at(t + h)) == branch_) s = next;
    else advance_across(s, line, t, h);
  }

 private:
  static constexpr int most_events = 12;  ///< in a step; beyond it the branch is left as it is

  ShipBranch branch_of(const StateVector<double>& s, const Controls<double>& c) const {
    const auto g = plain_.functions(s, c);
    ShipBranch branch{};
    std::ranges::transform(g, branch.begin(), [](double x) { return x > 0.0; });
    return branch;
  }

  void advance_across(StateVector<S>& s, const ControlLine& line, double from, double duration) {
    S t(from), h(duration);
    for (int i = 0; i < most_events; ++i) {
      const auto event = first_event(values_of(s), line, value_of(t), value_of(h));
      if (!event) break;
      const S way = exact(*event, s, line, t);
      s = stepper_.step(s, line, t, way, branch_);
      t = t + way;
      h = h - way;
      branch_[event->which] = !branch_[event->which];
    }
    s = stepper_.step(s, line, t, h, branch_);
  }

  /// The first branch function that passes zero in a step.
  std::optional<BranchEvent> first_event(const StateVector<double>& s, const ControlLine& line, double t,
                                         double h) const {
    const auto at_end = branch_of(plain_.step(s, line, t, h, branch_), line.at(t + h));
    std::optional<BranchEvent> first;
    for (std::size_t i = 0; i < branch_.size(); ++i) {
      if (at_end[i] == branch_[i]) continue;
      const double after = root(i, s, line, t, h);
      if (!first || after < first->after) first = BranchEvent{i, after};
    }
    return first;
  }

  double root(std::size_t which, const StateVector<double>& s, const ControlLine& line, double t, double h) const {
    const auto g = [&](double after) {
      return plain_.functions(plain_.step(s, line, t, after, branch_), line.at(t + after))[which];
    };
    const double g0 = plain_.functions(s, line.at(t))[which], g1 = g(h);
    if ((g0 > 0.0) != branch_[which] || g0 == 0.0) return 0.0;  // has just passed zero
    if (!(g0 * g1 < 0.0)) return h;                             // at the end, or not a number
    std::uintmax_t iterations = 60;
    const auto close = [&](double a, double b) { return b - a < 1e-13 * h; };
    const auto bracket = boost::math::tools::toms748_solve(g, 0.0, h, g0, g1, close, iterations);
    return 0.5 * (bracket.first + bracket.second);
  }

  /// Seconds to the event, with their derivatives. A function that hardly moves gives none.
  S exact(const BranchEvent& event, const StateVector<S>& s, const ControlLine& line, const S& t) const {
    S way(event.after);
    if constexpr (!std::is_same_v<S, double>) {
      const auto there = stepper_.step(s, line, t, way, branch_);
      const S g = stepper_.functions(there, cast<S>(line.at(S(t + way))))[event.which];
      const double speed = rate_of(event.which, values_of(there), line, value_of(t) + event.after);
      if (std::abs(speed) * event.after > 1e-9) way.v = -g.v / speed;
    }
    return way;
  }

  /// dg/dt along the motion.
  double rate_of(std::size_t which, const StateVector<double>& s, const ControlLine& line, double t) const {
    const auto rate = plain_.rates(s, line.at(t), branch_);
    StateVector<Dual<1>> moving;
    for (std::size_t i = 0; i < 6; ++i) {
      moving[i] = Dual<1>(s[i]);
      moving[i].v[0] = rate[i];
    }
    return along_.functions(moving, line.at(Dual<1>(t, 0)))[which].v[0];
  }

  Plain plain_;
  Stepper<Model, Dual<1>> along_;
  Stepper<Model, S> stepper_;
  ShipBranch branch_{};
};

}  // namespace swayaw::nonlinear::detail
