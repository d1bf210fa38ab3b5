#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "linearized_ship.hpp"

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

/// A step of the filter between samples: how small deviations grow over it, and what the step makes of the rates.
///
/// Rows x … r of Φ are those of 1 with B added in the columns of psi, u, v, r and of the unmodelled accelerations a;
/// the rows of a are `keep`. Random accelerations of size σ add σ² share before the step and as much after it.
template <int N>
struct Transition {
  double from, to;  ///< [s]
  Eigen::Matrix<double, 6, N - 2> B;
  Eigen::Matrix<double, 6, N - 2> Psi;  ///< the step is h f + Psi (h f), f the rates of all states
  double keep;
  double share;
};

/// Φ P Φᵀ of a symmetric P.
template <int N>
FilterMatrix<N> carried(const FilterMatrix<N>& P, const Transition<N>& t) {
  Eigen::Matrix<double, 6, N> top = P.template topRows<6>();
  top.noalias() += t.B.lazyProduct(P.template bottomRows<N - 2>());
  FilterMatrix<N> next;
  next.template topLeftCorner<6, 6>() =
      top.template leftCols<6>() + top.template rightCols<N - 2>().lazyProduct(t.B.transpose());
  if constexpr (N == 9) {
    next.template topRightCorner<6, 3>() = t.keep * top.template rightCols<3>();
    next.template bottomLeftCorner<3, 6>() = next.template topRightCorner<6, 3>().transpose();
    next.template bottomRightCorner<3, 3>() = (t.keep * t.keep) * P.template bottomRightCorner<3, 3>();
  }
  return next;
}

/// Φᵀ M Φ of a symmetric M.
template <int N>
FilterMatrix<N> carried_back(const FilterMatrix<N>& M, const Transition<N>& t) {
  FilterMatrix<N> right = M;  // M Φ
  if constexpr (N == 9) right.template rightCols<3>() *= t.keep;
  right.template rightCols<N - 2>().noalias() += M.template leftCols<6>().lazyProduct(t.B);
  FilterMatrix<N> before = right;
  if constexpr (N == 9) before.template bottomRows<3>() *= t.keep;
  before.template bottomRows<N - 2>().noalias() += t.B.transpose().lazyProduct(right.template topRows<6>());
  return before;
}

/// Φᵀ r
template <int N>
FilterVector<N> carried_back(const FilterVector<N>& r, const Transition<N>& t) {
  FilterVector<N> before = r;
  if constexpr (N == 9) before.template tail<3>() *= t.keep;
  before.template tail<N - 2>() += t.B.transpose().lazyProduct(r.template head<6>());
  return before;
}

/// Predicts a ship with effects between samples.
///
/// Hidden states of effects follow the predicted motion; they are no states of the filter and have no covariance.
template <int N>
class ShipPredictor {
 public:
  /// @param tau  memory of the unmodelled accelerations [s], or infinity
  ShipPredictor(const Ship& ship, double tau)
      : ship_(linearized_ship(ship)), tau_(tau), longest_(0.02 * length(ship)) {}

  /// Back to the state at the beginning of a run.
  void restart(const FilterVector<N>& x) {
    if (!ship_->changes().empty()) ship_->restart();
    hidden_ = ship_->steady_hidden(ship_state<N>(x).motion);
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

  /// Into how many steps a time between samples is cut: one is 0.02 ship lengths and a fifth of the memory, or less.
  int steps(double speed, double h) const {
    return std::max(1, static_cast<int>(std::ceil(h * std::max(speed / longest_, 5.0 / tau_))));
  }

  /// Moves a state over a time. With f and its derivatives A at the state and the mean of the controls,
  ///
  ///     x⁺ = x + (h + h²A/2! + h³A²/3!) f,   Φ = 1 + h A + h²A²/2!
  ///
  /// the exponential method of Rosenbrock and Euler, of second order; exact to third where f is linear.
  Transition<N> step(FilterVector<N>& x, const Controls<double>& controls, double from, double to) {
    Transition<N> t{.from = from, .to = to, .B = {}, .Psi = {}, .keep = 1.0, .share = 0.0};
    const double h = to - from, fading = h / tau_;
    const auto state = ship_state<N>(x);
    const auto middle = half_way(state.motion, h);
    LinearizedShip::At there{Eigen::Matrix<double, 6, 1>::Zero(), Eigen::Matrix<double, 6, 4>::Zero()};
    with_changes(from, to, [&](double weight) {
      const auto part = ship_->at(state, middle, controls);
      if (weight == 1.0) there = part;
      else there.rate += weight * part.rate, there.A += weight * part.A;
    });
    Eigen::Matrix<double, 6, N - 2> hA;
    hA.template leftCols<4>() = h * there.A;
    if constexpr (N == 9) {
      hA.template rightCols<3>().setZero();
      hA.template bottomRightCorner<3, 3>().diagonal().setConstant(h);
    }
    t.Psi = 0.5 * hA;
    t.Psi.template leftCols<4>() += hA.template leftCols<4>().lazyProduct(hA.template block<4, 4>(2, 0)) / 6.0;
    if constexpr (N == 9)
      t.Psi.template rightCols<3>() +=
          (hA.template leftCols<4>().lazyProduct(hA.template block<4, 3>(2, 4)) - fading * hA.template rightCols<3>()) /
          6.0;
    t.B = hA + 0.5 * hA.template leftCols<4>().lazyProduct(hA.template bottomRows<4>());
    if constexpr (N == 9) t.B.template rightCols<3>() -= (0.5 * fading) * hA.template rightCols<3>();
    t.keep = N == 9 ? std::exp(-fading) : 1.0;
    // tanh keeps the variance of a at σ²
    t.share = N == 9 && std::isfinite(tau_) ? std::tanh(fading) : 0.5 * h;
    move(x, t, there.rate);
    return t;
  }

  /// Moves another state over the same step, its derivatives as they were for the first: equal for equal states.
  void repeat(FilterVector<N>& x, const Controls<double>& controls, const Transition<N>& t) {
    const auto state = ship_state<N>(x);
    const auto middle = half_way(state.motion, t.to - t.from);
    Eigen::Matrix<double, 6, 1> rate = Eigen::Matrix<double, 6, 1>::Zero();
    with_changes(t.from, t.to, [&](double weight) {
      const auto part = ship_->rates(state, middle, controls);
      rate += weight * Eigen::Map<const Eigen::Matrix<double, 6, 1>>(part.data());
    });
    move(x, t, rate);
  }

 private:
  /// x⁺ = x + h f + Psi (h f), f with the unmodelled accelerations; these fade. Hidden states follow.
  void move(FilterVector<N>& x, const Transition<N>& t, const Eigen::Matrix<double, 6, 1>& rate) {
    const double h = t.to - t.from, fading = h / tau_;
    const auto before = ship_state<N>(x).motion;
    FilterVector<N> hf;
    hf.template head<6>() = h * rate;
    if constexpr (N == 9) {
      hf.template segment<3>(3) += h * x.template tail<3>();
      hf.template tail<3>() = -fading * x.template tail<3>();
      x.template tail<3>() *= 1.0 - fading * (1.0 - fading * (0.5 - fading / 6.0));
    }
    x.template head<6>() += hf.template head<6>() + t.Psi.lazyProduct(hf.template tail<N - 2>());
    if (ship_->hides_states()) hidden_ = followed(before, ship_state<N>(x).motion, h);
  }

  static Hidden<double> moved(Hidden<double> hidden, const Hidden<double>& rate, double t) {
    for (std::size_t i = 0; i < hidden_count; ++i) hidden[i] += t * rate[i];
    return hidden;
  }

  /// Hidden states in the middle of a step.
  Hidden<double> half_way(const PlanarMotion<double>& motion, double h) const {
    if (!ship_->hides_states()) return hidden_;
    return moved(hidden_, ship_->rates_of_hidden(motion, hidden_), 0.5 * h);
  }

  /// Hidden states behind a motion that changes evenly, by the classical Runge–Kutta step.
  Hidden<double> followed(const PlanarMotion<double>& a, const PlanarMotion<double>& b, double h) const {
    const PlanarMotion<double> middle{0.5 * (a.u + b.u), 0.5 * (a.v + b.v), 0.5 * (a.r + b.r)};
    const auto k1 = ship_->rates_of_hidden(a, hidden_);
    const auto k2 = ship_->rates_of_hidden(middle, moved(hidden_, k1, 0.5 * h));
    const auto k3 = ship_->rates_of_hidden(middle, moved(hidden_, k2, 0.5 * h));
    const auto k4 = ship_->rates_of_hidden(b, moved(hidden_, k3, h));
    Hidden<double> mean;
    for (std::size_t i = 0; i < hidden_count; ++i) mean[i] = (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]) / 6.0;
    return moved(hidden_, mean, h);
  }

  /// Calls part(weight) for each part of a time in which the same wind blows and the same forces act.
  template <class Part>
  void with_changes(double from, double to, Part&& part) {
    const auto changes = ship_->changes();
    for (; next_change_ < changes.size() && changes[next_change_].time <= from; ++next_change_)
      ship_->apply(changes[next_change_]);
    double now = from;
    for (; next_change_ < changes.size() && changes[next_change_].time < to; ++next_change_) {
      part((changes[next_change_].time - now) / (to - from));
      now = changes[next_change_].time;
      ship_->apply(changes[next_change_]);
    }
    part(now == from ? 1.0 : (to - now) / (to - from));
  }

  std::unique_ptr<LinearizedShip> ship_;
  Hidden<double> hidden_;
  std::size_t next_change_ = 0;
  double tau_;
  double longest_;  ///< way made in one step [m]
};

}  // namespace swayaw::identification::detail
