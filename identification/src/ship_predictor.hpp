#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "linearized_ship.hpp"

/// Prediction of a ship and of small deviations from her way, over N = 6 states (x, y, psi, u, v, r) or 9 (and
/// unmodelled accelerations). Not installed.
namespace swayaw {

template <int N>
using FilterVector = Eigen::Matrix<double, N, 1>;
template <int N>
using FilterMatrix = Eigen::Matrix<double, N, N>;

template <int N>
ShipState<double> ship_state(const FilterVector<N>& s) {
  return {s[0], s[1], s[2], {s[3], s[4], s[5]}};
}

/// How small deviations grow over a step, Φ, and the share of the imperfection that they gain.
///
/// Rows x … r of Φ are those of 1 with B added in the columns of psi, u, v, r and of the unmodelled accelerations a;
/// the rows of a are `keep`. Random accelerations of size σ add σ² share before the step and as much after it.
template <int N>
struct Transition {
  Eigen::Matrix<double, 6, N - 2> B;
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

inline Controls<double> between(const Controls<double>& a, const Controls<double>& b, double share) {
  const auto mix = [share](double x, double y) { return x + share * (y - x); };
  return {mix(a.delta, b.delta),
          mix(a.rev, b.rev),
          {mix(a.thrust.port, b.thrust.port), mix(a.thrust.starboard, b.thrust.starboard)},
          a.by_thrust};
}

/// Predicts a ship between samples.
template <class Model, int N>
class ShipPredictor {
 public:
  /// @param tau  memory of the unmodelled accelerations [s], or infinity
  ShipPredictor(const Model& model, const Surroundings<double>& around, double tau)
      : ship_(model, around), tau_(tau), longest_(0.02 * model.particulars.L) {}

  /// Into how many steps a time between samples is cut: one is 0.02 ship lengths and a fifth of the memory, or less.
  int steps(double speed, double h) const {
    return std::max(1, static_cast<int>(std::ceil(h * std::max(speed / longest_, 5.0 / tau_))));
  }

  /// Moves a state over h seconds. With f and its derivatives A at the state and the mean of the controls,
  ///
  ///     x⁺ = x + (h + h²A/2! + h³A²/3!) f,   Φ = 1 + h A + h²A²/2!
  ///
  /// the exponential method of Rosenbrock and Euler, of second order; exact to third where f is linear.
  Transition<N> sail(FilterVector<N>& x, const Controls<double>& controls, double h) const {
    Eigen::Matrix<double, 6, N - 2> hA;
    FilterVector<N> gain;
    const auto there = ship_.at(ship_state<N>(x), controls);
    gain.template head<6>() = h * there.rate;
    hA.template leftCols<4>() = h * there.A;
    const double fading = h / tau_;
    if constexpr (N == 9) {
      gain.template segment<3>(3) += h * x.template tail<3>();
      gain.template tail<3>() = -fading * x.template tail<3>();
      hA.template rightCols<3>().setZero();
      hA.template bottomRightCorner<3, 3>().diagonal().setConstant(h);
    }
    FilterVector<N> term = gain;
    for (int order = 2; order <= 3; ++order) {
      FilterVector<N> next;
      next.template head<6>() = hA.lazyProduct(term.template tail<N - 2>()) / order;
      if constexpr (N == 9) next.template tail<3>() = term.template tail<3>() * (-fading / order);
      gain += next;
      term = next;
    }
    x += gain;
    Transition<N> t;
    t.B = hA + 0.5 * hA.template leftCols<4>().lazyProduct(hA.template bottomRows<4>());
    if constexpr (N == 9) t.B.template rightCols<3>() -= (0.5 * fading) * hA.template rightCols<3>();
    t.keep = N == 9 ? std::exp(-fading) : 1.0;
    t.share = N == 9 && std::isfinite(tau_) ? std::tanh(fading) : 0.5 * h;  // tanh keeps the variance of a at σ²
    return t;
  }

 private:
  LinearizedShip<Model> ship_;
  double tau_;
  double longest_;  ///< way made in one step [m]
};

}  // namespace swayaw
