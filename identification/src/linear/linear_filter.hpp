#pragma once

#include <Eigen/Core>
#include <cmath>
#include <type_traits>

#include "linear_run.hpp"
#include "swayaw/core/dual.hpp"
#include "swayaw/linear/response.hpp"

/// Kalman filter of the sway–yaw equations, generic over double and duals. Not installed.
namespace swayaw::inline identification::detail {

/// Everything a recording is explained by, except the start.
template <class S>
struct LinearModel {
  SwayYawCoefficients<S> ship;
  S rudder_offset, yaw_rate_offset, drift_offset;
  S var_psi, var_r, var_beta;  ///< of the measurements
  S q_beta, q_omega;           ///< growth of variance per ship length
};

/// Response basis in duals through its derivatives by trace and determinant.
template <class S>
class BasisAt {
 public:
  explicit BasisAt(const SwayYawCoefficients<S>& m)
      : tr_(trace(m)), det_(determinant(m)), poles_(poles(base(tr_, 0), base(det_, 1))) {}

  ResponseBasis<S> operator()(double s) const {
    const auto b = response_basis(poles_, Base(s));
    return {lifted(b.h_1), lifted(b.h0), lifted(b.h1), lifted(b.h2), lifted(b.h3)};
  }

 private:
  static constexpr bool plain = std::is_same_v<S, double>;
  using Base = std::conditional_t<plain, double, Dual<2>>;

  static Base base(const S& x, [[maybe_unused]] int k) {
    if constexpr (plain) return x;
    else return Base(x.a, k);
  }

  S lifted(const Base& h) const {
    if constexpr (plain) return h;
    else return S(h.a, h.v[0] * tr_.v + h.v[1] * det_.v);
  }

  S tr_, det_;
  Poles<Base> poles_;
};

/// What the filter expected of a measurement, and how wrong it was.
template <class S>
struct LinearInnovation {
  S error;
  S variance;
};

template <class S>
class LinearFilter {
 public:
  using Vector = Eigen::Matrix<S, 3, 1>;
  using Matrix = Eigen::Matrix<S, 3, 3>;
  enum Index { beta, omega, psi };

  /// Knows nothing of the start but that drift, omega' and the distance from the first heading are of the order of 1 or
  /// less.
  LinearFilter(const LinearModel<S>& model, double first_heading) : model_(model), basis_(model.ship) {
    x_ << S(0.0), S(0.0), S(first_heading);
    P_ = Matrix::Identity();
  }

  /// From one sample to the next, the rudder moving in a straight line.
  void simulate(const LinearSample& from, const LinearSample& to) {
    const double s = to.s - from.s;
    const auto& m = model_.ship;
    const auto b = basis_(s);
    const S zero(0.0), one(1.0);
    Phi_ << b.h_1 - b.h0 * m.b2, b.h0 * m.b1, zero,  //
        b.h0 * m.a2, b.h_1 - b.h0 * m.a1, zero,      //
        b.h1 * m.a2, b.h0 - b.h1 * m.a1, one;
    const S nb0 = m.b1 * m.c2 - m.b2 * m.c1, nw0 = m.a2 * m.c1 - m.a1 * m.c2;
    const S delta = from.delta + model_.rudder_offset;
    const double rate = (to.delta - from.delta) / s;
    const Vector forced(delta * (b.h0 * m.c1 + b.h1 * nb0) + rate * (b.h1 * m.c1 + b.h2 * nb0),
                        delta * (b.h0 * m.c2 + b.h1 * nw0) + rate * (b.h1 * m.c2 + b.h2 * nw0),
                        delta * (b.h1 * m.c2 + b.h2 * nw0) + rate * (b.h2 * m.c2 + b.h3 * nw0));
    x_ = Vector(Phi_ * x_) + forced;
    P_ = Matrix(Matrix(Phi_ * P_) * Phi_.transpose());
    // white disturbances of d(beta)/ds' and d(omega')/ds'; psi integrates omega'
    P_(beta, beta) += model_.q_beta * s;
    P_(omega, omega) += model_.q_omega * s;
    P_(omega, psi) += model_.q_omega * (s * s / 2.0);
    P_(psi, omega) = P_(omega, psi);
    P_(psi, psi) += model_.q_omega * (s * s * s / 3.0);
  }

  /// Measurements of a sample one after the other; `seen(innovation, index)` is told each.
  template <class Seen>
  void measure(const LinearSample& now, Seen&& seen) {
    if (!std::isnan(now.psi)) update(psi, 1.0, S(now.psi), model_.var_psi, seen);
    if (!std::isnan(now.r)) update(omega, now.rate, S(now.r - model_.yaw_rate_offset), model_.var_r, seen);
    if (!std::isnan(now.beta)) update(beta, 1.0, S(now.beta - model_.drift_offset), model_.var_beta, seen);
  }

  const Matrix& transition() const { return Phi_; }
  const Vector& gain() const { return K_; }

 private:
  template <class Seen>
  void update(Index i, double factor, const S& measured, const S& variance, Seen&& seen) {
    const LinearInnovation<S> now{measured - factor * x_[i], factor * factor * P_(i, i) + variance};
    // The plain form does: P ≤ 1 to start with, and measurement variances of 1e-12 are far above its rounding errors of
    // 1e-16.
    K_ = P_.col(i) * (factor / now.variance);
    x_ += K_ * now.error;
    P_ -= Matrix(Vector(K_ * now.variance) * K_.transpose());
    seen(now, i, factor);
  }

  LinearModel<S> model_;
  BasisAt<S> basis_;
  Vector x_, K_;
  Matrix P_, Phi_;
};

/// Filters a whole run. `seen(innovation, index, factor)` after each measurement, `sailed()` after each step.
template <class S, class Seen, class Sailed>
void filter_run(LinearFilter<S>& filter, const LinearRun& run, Seen&& seen, Sailed&& simulated) {
  filter.measure(run.front(), seen);
  for (std::size_t k = 1; k < run.size(); ++k) {
    filter.simulate(run[k - 1], run[k]);
    simulated();
    filter.measure(run[k], seen);
  }
}

}  // namespace swayaw::identification::detail
