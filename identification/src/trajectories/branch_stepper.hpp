#pragma once

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>

#include "swayaw/core/dual.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"
#include "swayaw/nonlinear/models/branch.hpp"
#include "swayaw/nonlinear/simulation/equations_of_motion.hpp"
#include "swayaw/nonlinear/simulation/runge_kutta.hpp"
#include "swayaw/nonlinear/simulation/stepper_state.hpp"

/// Classical Runge–Kutta steps in double or dual numbers, on one branch of the force model at a time. Not installed.
namespace swayaw::inline identification::detail {

/// Controls that change in straight lines over a time.
struct ControlLine {
  Controls<double> begin, end;
  double duration;  ///< [s]

  template <class T>
  Controls<T> at(const T& t) const {
    return between(begin, end, T(t / duration));
  }
};

/// A ship in a scalar, with her effects at work if she has any.
template <template <class> class Model, class S, bool with_effects>
struct ShipIn {
  Model<S> model;  ///< its parameters as effects change them
  Surroundings<S> around;
  std::conditional_t<with_effects, ActingEffects<S>, NoEffects> added{};
  std::conditional_t<with_effects, Instruments<S>, NoEffects> instruments{};
};

/// The same with another scalar.
template <class To, template <class> class Model, class From, bool with_effects>
auto cast(const ShipIn<Model, From, with_effects>& ship) {
  ShipIn<Model, To, with_effects> to{.model = cast<To>(ship.model), .around = cast<To>(ship.around)};
  if constexpr (with_effects) to.added = cast<To>(ship.added), to.instruments = cast<To>(ship.instruments);
  return to;
}

template <class S, std::size_t N>
std::array<double, N> values_of(const std::array<S, N>& s) {
  std::array<double, N> values;
  std::ranges::transform(s, values.begin(), [](const S& x) { return value_of(x); });
  return values;
}

/// Steps of one ship.
template <template <class> class Model, class S, bool with_effects>
class Stepper {
 public:
  using ShipBranch = Branch<double, Model<double>::branch_count>;
  static constexpr std::size_t hidden_states = with_effects ? hidden_count : 0;
  using State = StepperState<S, hidden_states>;

  explicit Stepper(ShipIn<Model, S, with_effects> ship) : ship_(std::move(ship)) {}

  /// From now on the wind blows, and the forces act, as the change says.
  void apply(const Change& change) {
    if constexpr (with_effects) change.apply(ship_.around, ship_.added);
    else change.blow(ship_.around);
  }

  /// The classical Runge–Kutta step. Times may be numbers or duals.
  template <class T>
  State step(const State& s, const ControlLine& line, const T& t, const T& h, const ShipBranch& branch) const {
    const auto with = [&](const Controls<S>& c) {
      return [this, &branch, c](const State& at) { return rates(at, c, branch); };
    };
    return runge_kutta_step(s, h, with(cast<S>(line.at(t))), with(cast<S>(line.at(T(t + 0.5 * h)))),
                            with(cast<S>(line.at(T(t + h)))));
  }

  /// Branch functions at a state.
  auto functions(const State& s, const Controls<S>& c) const {
    const auto motion = visible(s).motion;
    return branch_functions(ship_.model, motion, driven(ship_.added, motion, c));
  }

  /// Rates of the state.
  State rates(const State& s, const Controls<S>& c, const ShipBranch& branch) const {
    const auto& [model, around, added, instruments] = ship_;
    const auto state = visible(s);
    if constexpr (with_effects) {
      const auto hidden = hidden_of(s);
      return joined<hidden_states>(rates_of(model, around, added, state, hidden, c, branch),
                                   hidden_rates(model, added, state.motion, hidden, c));
    } else {
      return rates_of(model, around, state, c, branch);
    }
  }

  const auto& ship() const { return ship_; }

 private:
  ShipIn<Model, S, with_effects> ship_;
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
template <template <class> class Model, class S, bool with_effects>
class BranchStepper {
 public:
  using Plain = Stepper<Model, double, with_effects>;
  using ShipBranch = typename Plain::ShipBranch;
  using State = StepperState<S, Plain::hidden_states>;
  using PlainState = typename Plain::State;

  BranchStepper(const ShipIn<Model, double, with_effects>& ship, ShipIn<Model, S, with_effects> in_scalar)
      : plain_(ship), along_(cast<Dual<1>>(ship)), stepper_(std::move(in_scalar)) {}

  void begin(const State& s, const Controls<double>& c) { branch_ = branch_of(values_of(s), c); }

  void apply(const Change& change) { plain_.apply(change), along_.apply(change), stepper_.apply(change); }

  void advance(State& s, const ControlLine& line, double t, double h) {
    const auto next = stepper_.step(s, line, t, h, branch_);
    if (branch_of(values_of(next), line.at(t + h)) == branch_) s = next;
    else advance_across(s, line, t, h);
  }

  /// Rates of the state now.
  State rates(const State& s, const Controls<double>& c) const { return stepper_.rates(s, cast<S>(c), branch_); }

  const auto& ship() const { return stepper_.ship(); }

 private:
  static constexpr int most_events = 12;  ///< in a step; beyond it the branch is left as it is

  ShipBranch branch_of(const PlainState& s, const Controls<double>& c) const {
    const auto g = plain_.functions(s, c);
    ShipBranch branch{};
    std::ranges::transform(g, branch.begin(), [](double x) { return x > 0.0; });
    return branch;
  }

  void advance_across(State& s, const ControlLine& line, double from, double duration) {
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
  std::optional<BranchEvent> first_event(const PlainState& s, const ControlLine& line, double t, double h) const {
    const auto at_end = branch_of(plain_.step(s, line, t, h, branch_), line.at(t + h));
    std::optional<BranchEvent> first;
    for (std::size_t i = 0; i < branch_.size(); ++i) {
      if (at_end[i] == branch_[i]) continue;
      const double after = root(i, s, line, t, h);
      if (!first || after < first->after) first = BranchEvent{i, after};
    }
    return first;
  }

  double root(std::size_t which, const PlainState& s, const ControlLine& line, double t, double h) const {
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
  S exact(const BranchEvent& event, const State& s, const ControlLine& line, const S& t) const {
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
  double rate_of(std::size_t which, const PlainState& s, const ControlLine& line, double t) const {
    const auto rate = plain_.rates(s, line.at(t), branch_);
    typename Stepper<Model, Dual<1>, with_effects>::State moving;
    for (std::size_t i = 0; i < moving.size(); ++i) {
      moving[i] = Dual<1>(s[i]);
      moving[i].v[0] = rate[i];
    }
    return along_.functions(moving, line.at(Dual<1>(t, 0)))[which].v[0];
  }

  Plain plain_;
  Stepper<Model, Dual<1>, with_effects> along_;
  Stepper<Model, S, with_effects> stepper_;
  ShipBranch branch_{};
};

}  // namespace swayaw::identification::detail
