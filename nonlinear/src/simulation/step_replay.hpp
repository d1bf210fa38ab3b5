#pragma once

#include <array>
#include <functional>
#include <span>

#include "dormand_prince.hpp"
#include "swayaw/core/dual.hpp"
#include "swayaw/core/steering_gear.hpp"
#include "swayaw/nonlinear/manoeuvres/manoeuvre_step.hpp"
#include "swayaw/nonlinear/simulation/equations_of_motion.hpp"
#include "swayaw/nonlinear/surroundings/surroundings.hpp"

/// Derivatives of a simulation. Not installed.
namespace swayaw::inline nonlinear::detail {

/// Takes the steps of an EventStepper once more in duals.
///
/// Time is a dual too: an event comes sooner or later with the numbers of the ship, and the step that ends there grows
/// or shrinks by that. The last derivative is by time and serves for that alone; the others are by numbers of the ship.
template <template <class> class Model, int N>
class StepReplay {
 public:
  using S = Dual<N>;
  using Watch = std::function<S(const ShipState<S>&)>;

  StepReplay(const Model<S>& ship, const Current<double>& current, const S& speed, const Controls<S>& propulsion,
             std::span<const ManoeuvreStep> steps)
      : ship_(ship), propulsion_(propulsion), left_(steps), rudder_(RudderMotion<S>::moving(S(0.0), S(0.0), S(0.0))) {
    around_.current = {S(current.speed), S(current.to)};
    state_.fill(S(0.0));
    state_[3] = speed;
  }

  const S& time() const { return time_; }
  ShipState<S> state() const {
    return state_of(StateVector<S>{state_[0], state_[1], state_[2], state_[3], state_[4], state_[5]});
  }

  /// Way made, ∫ U dt [m].
  const S& way() const { return state_[6]; }

  /// Under the last rudder order.
  Controls<S> controls_at(const S& time) const { return with_rudder(propulsion_, rudder_.at(time)); }

  void order(double angle) {
    rudder_ = RudderMotion<S>::ordered(ship_.steering_gear, time_, rudder_.at(time_), S(angle));
  }

  /// Goes on until the watch of the simulation passed zero. @return whether it did
  bool advance(const Watch& watch) {
    while (!left_.empty()) {
      const auto& step = left_.front();
      left_ = left_.subspan(1);
      take(step);
      if (step.end == StepEnd::branch)
        meet([&](const State& s, const S& t) {
          return branch_functions(ship_, motion_of(s), controls_at(t))[step.function];
        });
      if (step.end != StepEnd::watch) continue;
      meet([&](const State& s, const S&) {
        return watch(state_of(StateVector<S>{s[0], s[1], s[2], s[3], s[4], s[5]}));
      });
      return true;
    }
    return false;
  }

 private:
  /// x, y, psi, u, v, r and the way made.
  using State = std::array<S, 7>;
  static constexpr int by_time = N - 1;

  static PlanarMotion<S> motion_of(const State& s) { return {s[3], s[4], s[5]}; }

  void rates(const State& s, State& rate, const S& time) const {
    const ShipState<S> state{s[0], s[1], s[2], motion_of(s)};
    const auto r = rates_of(ship_, around_, state, controls_at(time), branch_);
    rate = {r[0], r[1], r[2], r[3], r[4], r[5], speed(state.motion)};
  }

  void take(const ManoeuvreStep& step) {
    std::copy_n(step.branch.begin(), branch_.size(), branch_.begin());
    const S to = step.end == StepEnd::kink ? rudder_.next_kink(time_) : S(step.to);
    if (step.to > time_.a) state_ = stepped(to - time_);
    time_ = to;
  }

  /// The state a Dormand–Prince step later.
  State stepped(const S& duration) const {
    constexpr auto& a = DormandPrince::a;
    std::array<State, 6> k;
    rates(state_, k[0], time_);
    for (std::size_t stage = 1; stage < k.size(); ++stage)
      rates(along(duration, k, a[stage], stage), k[stage], time_ + DormandPrince::c[stage] * duration);
    return along(duration, k, a[k.size()], k.size());
  }

  State along(const S& duration, const std::array<State, 6>& k, const double (&weight)[6], std::size_t count) const {
    State there = state_;
    for (std::size_t i = 0; i < there.size(); ++i) {
      S sum = weight[0] * k[0][i];
      for (std::size_t j = 1; j < count; ++j) sum += weight[j] * k[j][i];
      there[i] += duration * sum;
    }
    return there;
  }

  /// Moves the end of the last step to where g is 0 for all values of the numbers: dt = −(∂g/∂theta)/(dg/dt).
  void meet(const std::function<S(const State&, const S&)>& g) {
    State rate, moving = state_;
    rates(state_, rate, time_);
    for (std::size_t i = 0; i < moving.size(); ++i) moving[i].v[by_time] = rate[i].a;
    S now = time_;
    now.v[by_time] = 1.0;
    const S value = g(moving, now);
    if (value.v[by_time] == 0.0) return;
    S later(0.0);
    later.v = -value.v / value.v[by_time];
    later.v[by_time] = 0.0;
    time_ += later;
    for (std::size_t i = 0; i < state_.size(); ++i) state_[i] += rate[i].a * later;
  }

  Model<S> ship_;
  Surroundings<S> around_;
  Controls<S> propulsion_;
  std::span<const ManoeuvreStep> left_;
  RudderMotion<S> rudder_;
  Branch<S, Model<S>::branch_count> branch_{};
  S time_ = S(0.0);
  State state_;
};

}  // namespace swayaw::nonlinear::detail
