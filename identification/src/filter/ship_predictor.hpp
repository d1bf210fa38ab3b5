#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "linearized_ship.hpp"
#include "taped_ship.hpp"

/// Prediction of a ship and of small deviations from her way, over N = 6 states (x, y, psi, u, v, r) or 9 (and
/// unmodelled accelerations). Not installed.
namespace swayaw::inline identification::detail {

template <int N>
using FilterVector = Eigen::Matrix<double, N, 1>;
template <int N>
using FilterMatrix = Eigen::Matrix<double, N, N>;

template <int N>
ShipState<double> ship_state(const FilterVector<N>& s) {
  return {s[0], s[1], s[2], {s[3], s[4], s[5]}};
}

/// When in a step the random accelerations change. At its ends, half before it and half after, where steps are so short
/// that no reading shows a time within one; white ones always, which are told as their means from one sample to the
/// next. Else half way, so that a sample has the accelerations of all times that are nearer to it than to others, and
/// readings of these times see them: a likelihood does not go by the sample that they are seen from. (With changes at
/// the ends the likelihood of six runs of a simulated ship with three seconds between samples went by 80 a second with
/// the times of the samples, and with it what delays of channels gained. With two changes, at the points of Gauss, it
/// goes by less than half as much where the process noise is twenty times the ordinary, and alike where it is ordinary;
/// but headings and yaw rates may disagree then, and in a case as on board such noise took the place of a tug.)
enum class Changes { at_ends, half_way };

/// A step of h seconds between samples, kept for the way back and for other states.
///
/// Random accelerations of size σ change by a variance of σ² share before it and after it, or half way.
template <int N>
struct Transition {
  Eigen::Matrix<double, 6, 4> hA;  ///< h times the derivatives of the rates of x … r by psi, u, v, r
  double h;                        ///< [s]
  double fading;                   ///< h/τ of the unmodelled accelerations a
  double keep;                     ///< what is left of a: the rows of a in Φ
  Changes changes;
  double share;
  double moves;               ///< Δδ, by how much the rudder turns in the step [rad]
  Eigen::Vector3d by_rudder;  ///< derivatives of the accelerations by its angle, or 0 where nobody asked

  /// What is left over a step of a that fades, exp(−h/τ) to third order.
  double faded() const { return 1.0 - fading * (1.0 - fading * (0.5 - fading / 6.0)); }

  /// −h²/12 A f_δ Δδ: what the rudder, turning in the step, adds to x … r.
  Eigen::Matrix<double, 6, 1> turned() const { return (-h / 12.0 * moves) * hA.template rightCols<3>() * by_rudder; }

  /// What small deviations of psi, u, v, r and a add to those of x … r: Φ = 1 + h A + h²A²/2! in these rows and
  /// columns, less 1.
  Eigen::Matrix<double, 6, N - 2> B() const {
    Eigen::Matrix<double, 6, N - 2> B;
    B.template leftCols<4>() = hA + 0.5 * hA.lazyProduct(hA.template bottomRows<4>());
    if constexpr (N == 9) {
      B.template rightCols<3>() = (0.5 * h) * hA.template rightCols<3>();
      B.template bottomRightCorner<3, 3>().diagonal().array() += h * (1.0 - 0.5 * fading);
    }
    return B;
  }

  /// What a change of the random accelerations half way makes of all states at the end of the step.
  Eigen::Matrix<double, 9, 3> by_change() const requires(N == 9) {
    Eigen::Matrix<double, 9, 3> G;
    G.template topRows<6>() = (h / 8.0) * hA.template rightCols<3>();
    G.template middleRows<3>(3).diagonal().array() += 0.5 * h * (1.0 - 0.25 * fading);
    G.template bottomRows<3>() = std::sqrt(keep) * Eigen::Matrix3d::Identity();
    return G;
  }

  /// (h²A/2! + h³A²/3!) f of x … r, from h f of all states.
  Eigen::Matrix<double, 6, 1> curved(const FilterVector<N>& hf) const {
    Eigen::Matrix<double, 6, 1> first = hA * hf.template segment<4>(2);
    if constexpr (N == 9) first.template tail<3>() += h * hf.template tail<3>();
    Eigen::Matrix<double, 6, 1> second = hA * first.template tail<4>();
    if constexpr (N == 9) second.template tail<3>() -= (fading * h) * hf.template tail<3>();
    return first / 2.0 + second / 6.0;
  }
};

/// Φ P Φᵀ of a symmetric P.
template <int N>
FilterMatrix<N> carried(const FilterMatrix<N>& P, const Transition<N>& t) {
  const Eigen::Matrix<double, 6, N - 2> B = t.B();
  Eigen::Matrix<double, 6, N> top = P.template topRows<6>();
  top.noalias() += B.lazyProduct(P.template bottomRows<N - 2>());
  FilterMatrix<N> next;
  next.template topLeftCorner<6, 6>() =
      top.template leftCols<6>() + top.template rightCols<N - 2>().lazyProduct(B.transpose());
  if constexpr (N == 9) {
    next.template topRightCorner<6, 3>() = t.keep * top.template rightCols<3>();
    next.template bottomLeftCorner<3, 6>() = next.template topRightCorner<6, 3>().transpose();
    next.template bottomRightCorner<3, 3>() = (t.keep * t.keep) * P.template bottomRightCorner<3, 3>();
  }
  return next;
}

/// Derivatives over a step by the variables of a taped ship.
struct StepSlopes {
  TapedShip::Slopes rates;                             ///< of x … r
  std::array<TapedShip::HiddenSlopes, 4> hidden = {};  ///< of the rates of hidden states in the four stages of their
                                                       ///< way, if any
  TapedShip::RowSlopes by_rudder = {};                 ///< of the force of the rudder where hidden states follow it
};

/// Predicts a ship with effects between samples.
///
/// Hidden states of effects follow the predicted motion; they are no states of the filter and have no covariance.
template <int N>
class ShipPredictor {
 public:
  /// @param wind  recorded
  /// @param tau  memory of the unmodelled accelerations [s], or infinity
  /// @param longest_step  in ship lengths of way
  /// @param changes       of accelerations with a memory
  ShipPredictor(const Ship& ship, std::span<const WindPiece> wind, double tau, double longest_step, Changes changes)
      : ship_(linearized_ship(ship, wind)),
        tau_(tau),
        longest_((ship_->hides_states() ? std::min(longest_step, beside_hidden) : longest_step) * length(ship)),
        changes_(changes) {}

  /// Back to the state and the controls at the beginning of a run.
  void restart(const FilterVector<N>& x, const Controls<double>& controls) {
    if (!ship_->changes().empty()) {
      ship_->restart();
      if (taped_) taped_->restart();
    }
    hidden_ = ship_->steady_hidden(ship_state<N>(x).motion, controls);
    next_change_ = 0;
  }

  const Current<double>& current() const { return ship_->current(); }
  double tau() const { return tau_; }
  void set_tau(double tau) { tau_ = tau; }
  const Hidden<double>& hidden() const { return hidden_; }

  /// Rates of the ship now, unmodelled accelerations left out.
  StateVector<double> rates(const FilterVector<N>& x, const Controls<double>& controls) const {
    return ship_->rates(ship_state<N>(x), hidden_, controls);
  }

  /// From the next restart on, slopes can be asked for by these numbers of the ship.
  void tape(const Ship& ship, const std::vector<bool>& variable) { taped_ = taped_ship(ship, variable); }

  bool hides_states() const { return ship_->hides_states(); }

  /// What led to the end of a step: accelerations of the model at its beginning with the rudder at its mean angle in
  /// it, and what psi, u, v, r moved by.
  struct Arrival {
    Eigen::Vector3d acceleration;
    Eigen::Vector4d moved;
    double rudder;  ///< [rad]

    /// Accelerations at the end, by the curve of the step. @param A  their derivatives by psi, u, v, r
    Eigen::Vector3d acceleration_there(const Eigen::Matrix<double, 3, 4>& A) const { return acceleration + A * moved; }
  };
  const Arrival& arrival() const { return arrival_; }

  /// Derivatives of rates().
  void slopes(const FilterVector<N>& x, const Controls<double>& controls, TapedShip::Slopes& slopes) const {
    taped_->at(ship_state<N>(x), hidden_, controls, slopes);
  }

  /// Derivatives of the hidden states in which a run begins.
  void slopes_of_hidden(const FilterVector<N>& x, const Controls<double>& controls,
                        TapedShip::HiddenSlopes& slopes) const {
    taped_->of_steady_hidden(ship_state<N>(x).motion, controls, slopes);
  }

  /// Into how many steps a time between samples is cut: one is as long as allowed and a fifth of the memory, or less.
  int steps(double speed, double h) const {
    return std::max(1, static_cast<int>(std::ceil(h * std::max(speed / longest_, 5.0 / tau_))));
  }

  /// Moves a state over a time. With f and its derivatives A at the state and the mean of the controls,
  ///
  ///     x⁺ = x + (h + h²A/2! + h³A²/3!) f,   Φ = 1 + h A + h²A²/2!
  ///
  /// the exponential method of Rosenbrock and Euler, of second order; exact to third where f is linear. A rudder that
  /// moves by Δδ in the step, evenly, adds
  ///
  ///     −h²/12 A f_δ Δδ
  ///
  /// for what it does late has less time to turn her. A rudder at its mean all the time makes headings and yaw rates
  /// disagree: by 100 in log likelihood of six runs of a simulated ship, in steps of an eighth of L/U.
  /// @param moves      Δδ [rad]
  /// @param by_rudder  whether the derivatives by the rudder angle are needed, however little it moves
  Transition<N> step(FilterVector<N>& x, const Controls<double>& controls, double moves, bool by_rudder, double from,
                     double to) {
    const double h = to - from, fading = h / tau_;
    const auto state = ship_state<N>(x);
    const double by_lift = sway_by_rudder(state.motion, controls);
    const auto middle = half_way(state.motion, by_lift, h);
    LinearizedShip::At there;
    bool first = true;
    with_changes(from, to, [&](double weight) {
      const auto part = ship_->at(state, middle, controls);
      if (std::exchange(first, false)) there = {weight * part.rate, weight * part.A};
      else there.rate += weight * part.rate, there.A += weight * part.A;
    });
    Transition<N> t{.hA = h * there.A,
                    .h = h,
                    .fading = fading,
                    .keep = N == 9 ? std::exp(-fading) : 1.0,
                    .changes = changes_,
                    .share = share_of(fading, h),
                    .moves = moves,
                    .by_rudder = Eigen::Vector3d::Zero()};
    if (moves != 0.0 || by_rudder) {
      // rad: over less, rounding is left of a difference; over more than this the lift is straight, too
      constexpr double least = 1e-4;
      const double reach = std::abs(moves) > least ? moves : least;
      auto further = controls;
      further.delta += reach;
      const auto then = ship_->rates(state, middle, further);
      t.by_rudder << then[3] - there.rate[3], then[4] - there.rate[4], then[5] - there.rate[5];
      t.by_rudder /= reach;
    }
    move(x, controls, by_lift, t, there.rate);
    return t;
  }

  /// Moves another state over the same step, its derivatives as they were for the first: equal for equal states.
  void repeat(FilterVector<N>& x, const Controls<double>& controls, double from, double to, const Transition<N>& t) {
    const auto state = ship_state<N>(x);
    const double by_rudder = sway_by_rudder(state.motion, controls);
    const auto middle = half_way(state.motion, by_rudder, t.h);
    Eigen::Matrix<double, 6, 1> rate = Eigen::Matrix<double, 6, 1>::Zero();
    with_changes(from, to, [&](double weight) {
      const auto part = ship_->rates(state, middle, controls);
      rate += weight * Eigen::Map<const Eigen::Matrix<double, 6, 1>>(part.data());
    });
    move(x, controls, by_rudder, t, rate);
  }

  /// The same with the derivatives of the rates by the variables of the taped ship.
  void repeat(FilterVector<N>& x, const Controls<double>& controls, double from, double to, const Transition<N>& t,
              StepSlopes& slopes) {
    const auto state = ship_state<N>(x);
    const auto hidden = hidden_;
    const double by_rudder = sway_by_rudder(state.motion, controls);
    const auto middle = half_way(state.motion, by_rudder, t.h);
    Eigen::Matrix<double, 6, 1> rate = Eigen::Matrix<double, 6, 1>::Zero();
    TapedShip::Slopes of_part;
    bool first = true;
    with_changes(from, to, [&](double weight) {
      const auto part = ship_->rates(state, middle, controls);
      rate += weight * Eigen::Map<const Eigen::Matrix<double, 6, 1>>(part.data());
      taped_->at(state, middle, controls, of_part);
      if (std::exchange(first, false)) slopes.rates = weight * of_part;
      else slopes.rates += weight * of_part;
    });
    move(x, controls, by_rudder, t, rate);
    if (!ship_->hides_states()) return;
    const auto stages = stages_of(hidden, state.motion, ship_state<N>(x).motion, by_rudder, t.h);
    for (std::size_t i = 0; i < stages.size(); ++i)
      taped_->of_hidden(stages[i].motion, stages[i].hidden, by_rudder, slopes.hidden[i]);
    if (ship_->may_follow_rudder()) taped_->of_rudder(state.motion, controls, slopes.by_rudder);
  }

 private:
  /// That keeps the variance of accelerations that fade at σ².
  double share_of(double fading, double h) const {
    const bool fades = N == 9 && std::isfinite(tau_);
    if (changes_ == Changes::half_way) return fades ? 2.0 * std::sinh(fading) : h;
    return fades ? std::tanh(fading) : 0.5 * h;
  }

  /// x⁺ = x + h f + what curves it, f with the unmodelled accelerations; these fade. Hidden states follow.
  void move(FilterVector<N>& x, const Controls<double>& controls, double by_rudder, const Transition<N>& t,
            const Eigen::Matrix<double, 6, 1>& rate) {
    const double h = t.h, fading = t.fading;
    const auto before = ship_state<N>(x).motion;
    const Eigen::Vector4d start = x.template segment<4>(2);
    FilterVector<N> hf;
    hf.template head<6>() = h * rate;
    if constexpr (N == 9) {
      hf.template segment<3>(3) += h * x.template tail<3>();
      hf.template tail<3>() = -fading * x.template tail<3>();
      x.template tail<3>() *= t.faded();
    }
    x.template head<6>() += hf.template head<6>() + t.curved(hf);
    if (t.moves != 0.0) x.template head<6>() += t.turned();
    arrival_ = {rate.template tail<3>(), x.template segment<4>(2) - start, controls.delta};
    if (ship_->hides_states()) hidden_ = followed(before, ship_state<N>(x).motion, by_rudder, h);
  }

  static Hidden<double> moved(Hidden<double> hidden, const Hidden<double>& rate, double t) {
    for (std::size_t i = 0; i < hidden_count; ++i) hidden[i] += t * rate[i];
    return hidden;
  }

  /// As at the beginning of a step, over all of it: it changes little while she makes so little way.
  double sway_by_rudder(const PlanarMotion<double>& motion, const Controls<double>& controls) const {
    return ship_->may_follow_rudder() ? ship_->sway_by_rudder(motion, controls) : 0.0;
  }

  /// Hidden states in the middle of a step.
  Hidden<double> half_way(const PlanarMotion<double>& motion, double by_rudder, double h) const {
    if (!ship_->hides_states()) return hidden_;
    return moved(hidden_, ship_->rates_of_hidden(motion, hidden_, by_rudder), 0.5 * h);
  }

  /// Where the classical Runge–Kutta step asks for the rates of hidden states.
  struct Stage {
    PlanarMotion<double> motion;
    Hidden<double> hidden, rate;
  };

  /// Of hidden states behind a motion that changes evenly from a to b.
  std::array<Stage, 4> stages_of(const Hidden<double>& hidden, const PlanarMotion<double>& a,
                                 const PlanarMotion<double>& b, double by_rudder, double h) const {
    const PlanarMotion<double> middle{0.5 * (a.u + b.u), 0.5 * (a.v + b.v), 0.5 * (a.r + b.r)};
    const auto stage = [&](const PlanarMotion<double>& motion, const Hidden<double>& there) {
      return Stage{motion, there, ship_->rates_of_hidden(motion, there, by_rudder)};
    };
    const auto first = stage(a, hidden), second = stage(middle, moved(hidden, first.rate, 0.5 * h)),
               third = stage(middle, moved(hidden, second.rate, 0.5 * h));
    return {first, second, third, stage(b, moved(hidden, third.rate, h))};
  }

  Hidden<double> followed(const PlanarMotion<double>& a, const PlanarMotion<double>& b, double by_rudder,
                          double h) const {
    const auto stages = stages_of(hidden_, a, b, by_rudder, h);
    Hidden<double> mean;
    for (std::size_t i = 0; i < hidden_count; ++i)
      mean[i] = (stages[0].rate[i] + 2.0 * (stages[1].rate[i] + stages[2].rate[i]) + stages[3].rate[i]) / 6.0;
    return moved(hidden_, mean, h);
  }

  void apply_next() {
    ship_->apply(ship_->changes()[next_change_]);
    if (taped_) taped_->apply(next_change_);
  }

  /// Calls part(weight) for each part of a time in which the same wind blows and the same forces act.
  template <class Part>
  void with_changes(double from, double to, Part&& part) {
    const auto changes = ship_->changes();
    for (; next_change_ < changes.size() && changes[next_change_].time <= from; ++next_change_) apply_next();
    double now = from;
    for (; next_change_ < changes.size() && changes[next_change_].time < to; ++next_change_) {
      part((changes[next_change_].time - now) / (to - from));
      now = changes[next_change_].time;
      apply_next();
    }
    part(now == from ? 1.0 : (to - now) / (to - from));
  }

  /// Ship lengths of way in a step beside hidden states, which are carried explicitly: with steps of 0.125 the heel of
  /// a simulated container ship grew without bound.
  static constexpr double beside_hidden = 0.05;

  std::unique_ptr<LinearizedShip> ship_;
  std::unique_ptr<TapedShip> taped_{};
  Hidden<double> hidden_;
  Arrival arrival_{};
  std::size_t next_change_ = 0;
  double tau_;
  double longest_;  ///< way made in one step [m]
  Changes changes_;
};

}  // namespace swayaw::identification::detail
