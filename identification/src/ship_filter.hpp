#pragma once

#include <Eigen/Core>
#include <cmath>
#include <optional>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/dual.hpp"
#include "swayaw/core/recording.hpp"
#include "swayaw/nonlinear/surroundings.hpp"

/// Extended Kalman filter of a ship, over N = 6 states (x, y, psi, u, v, r) or 9 (and unmodelled accelerations). Not installed.
namespace swayaw {

template <int N>
using FilterVector = Eigen::Matrix<double, N, 1>;
template <int N>
using FilterMatrix = Eigen::Matrix<double, N, N>;

template <int N>
ShipState<double> ship_state(const FilterVector<N>& s) {
  return {s[0], s[1], s[2], {s[3], s[4], s[5]}};
}

/// Growth of the state and of small deviations over a step.
template <int N>
struct Step {
  FilterVector<N> state;
  FilterMatrix<N> Phi;
};

/// Random accelerations that the filter allows for, with their memory.
struct FilterNoise {
  PlanarAcceleration<double> size;  ///< of Imperfection
  double tau;                       ///< [s]
};

/// Predicts a ship between samples.
template <class Model, int N>
class ShipPredictor {
 public:
  ShipPredictor(const Model& model, const Surroundings<double>& around, double tau)
      : ship_(model), dual_(cast<D>(model)), around_(around), dual_around_(in_duals(around)), tau_(tau), longest_(0.04 * model.particulars.L) {}

  /// Over h seconds, with controls that go in a straight line from `begin` to `end`: the classical Runge–Kutta step for the
  /// state; for deviations Φ = I + A h + ½ A² h², with A at the middle of the step.
  Step<N> over(const FilterVector<N>& s, const Controls<double>& begin, const Controls<double>& end, double h) const {
    const Controls<double> middle = between(begin, end, 0.5);
    const FilterVector<N> k1 = rates(s, begin);
    const FilterVector<N> half = s + 0.5 * h * k1;
    FilterMatrix<N> A = FilterMatrix<N>::Zero();
    const FilterVector<N> k2 = rates(half, middle, &A);
    const FilterVector<N> k3 = rates(s + 0.5 * h * k2, middle);
    const FilterVector<N> k4 = rates(s + h * k3, end);
    const FilterMatrix<N> Ah = A * h;
    return {s + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4), FilterMatrix<N>::Identity() + Ah + 0.5 * Ah * Ah};
  }

  /// Into how many steps a time between samples is cut.
  int steps(double speed, double h) const { return std::max(1, static_cast<int>(std::ceil(h * std::max(speed, 1e-3) / longest_))); }

  static Controls<double> between(const Controls<double>& a, const Controls<double>& b, double share) {
    const auto mix = [&](double x, double y) { return x + share * (y - x); };
    return {mix(a.delta, b.delta), mix(a.rev, b.rev), {mix(a.thrust.port, b.thrust.port), mix(a.thrust.starboard, b.thrust.starboard)}, a.by_thrust};
  }

 private:
  using D = Dual<4>;  // of psi, u, v, r

  static Surroundings<D> in_duals(const Surroundings<double>& around) {
    return {.windage = cast_part<D>(around.windage), .wind = {D(around.wind.speed), D(around.wind.from)},
            .current = {D(around.current.speed), D(around.current.to)}, .windy = around.windy};
  }

  static void add_unmodelled(const FilterVector<N>& s, FilterVector<N>& rate, double tau) {
    if constexpr (N == 9) {
      rate.template segment<3>(3) += s.template segment<3>(6);
      rate.template segment<3>(6) = -s.template segment<3>(6) / tau;
    }
  }

  FilterVector<N> rates(const FilterVector<N>& s, const Controls<double>& c) const {
    const auto state = ship_state<N>(s);
    const auto r = rates_of(ship_, around_, state, c, branch_at(ship_, state.motion, c));
    FilterVector<N> rate = FilterVector<N>::Zero();
    for (int i = 0; i < 6; ++i) rate[i] = r[static_cast<std::size_t>(i)];
    add_unmodelled(s, rate, tau_);
    return rate;
  }

  /// The same, and its derivatives by the state.
  FilterVector<N> rates(const FilterVector<N>& s, const Controls<double>& c, FilterMatrix<N>* A) const {
    const ShipState<D> state{D(s[0]), D(s[1]), D(s[2], 0), {D(s[3], 1), D(s[4], 2), D(s[5], 3)}};
    const auto controls = cast<D>(c);
    const auto r = rates_of(dual_, dual_around_, state, controls, branch_at(dual_, state.motion, controls));
    FilterVector<N> rate = FilterVector<N>::Zero();
    for (int i = 0; i < 6; ++i) {
      rate[i] = r[static_cast<std::size_t>(i)].a;
      A->template block<1, 4>(i, 2) = r[static_cast<std::size_t>(i)].v.transpose();
    }
    if constexpr (N == 9) {
      A->template block<3, 3>(3, 6).setIdentity();
      A->template block<3, 3>(6, 6).diagonal().setConstant(-1.0 / tau_);
    }
    add_unmodelled(s, rate, tau_);
    return rate;
  }

  Model ship_;
  decltype(cast<D>(std::declval<Model>())) dual_;
  Surroundings<double> around_;
  Surroundings<D> dual_around_;
  double tau_;      ///< memory of the unmodelled accelerations [s]
  double longest_;  ///< way made in one step [m]
};

/// Covariance that random accelerations add over h seconds.
template <int N>
FilterMatrix<N> noise_over(const FilterNoise& noise, double h) {
  const double size[3] = {noise.size.u, noise.size.v, noise.size.r};
  FilterMatrix<N> Q = FilterMatrix<N>::Zero();
  for (int i = 0; i < 3; ++i) {
    if constexpr (N == 9) Q(6 + i, 6 + i) = size[i] * size[i] * -std::expm1(-2.0 * h / noise.tau);
    else Q(3 + i, 3 + i) = size[i] * size[i] * h;
  }
  return Q;
}

// ---------------------------------------------------------------- measurements

/// What a channel shows of a state, and how it changes with it.
template <int N>
struct Expected {
  double value;
  FilterVector<N> row;
};

/// A channel as a function of state and current, for double and dual.
template <class S>
S shown(Channel channel, const ShipState<S>& s, const Current<S>& current) {
  switch (channel) {
    case Channel::x: return s.x;
    case Channel::y: return s.y;
    case Channel::psi: return s.psi;
    case Channel::r: return s.motion.r;
    case Channel::v: return s.motion.v;
    default: break;
  }
  if (channel == Channel::u || channel == Channel::speed_through_water) return s.motion.u;
  const auto ground = over_ground(current, s);
  if (channel == Channel::u_ground) return ground.u;
  if (channel == Channel::v_ground) return ground.v;
  if (channel == Channel::speed_over_ground) return speed(ground);
  return s.psi + atan2(ground.v, ground.u);  // course over ground
}

inline bool is_direction(Channel channel) { return channel == Channel::psi || channel == Channel::course_over_ground; }

/// The state that a channel shows alone, if it does.
inline std::optional<int> plain_state(Channel channel) {
  switch (channel) {
    case Channel::x: return 0;
    case Channel::y: return 1;
    case Channel::psi: return 2;
    case Channel::u: case Channel::speed_through_water: return 3;
    case Channel::v: return 4;
    case Channel::r: return 5;
    default: return std::nullopt;
  }
}

template <int N>
Expected<N> expected(Channel channel, const FilterVector<N>& s, const Current<double>& current) {
  Expected<N> e{0.0, FilterVector<N>::Zero()};
  if (const auto i = plain_state(channel)) {
    e.value = s[*i];
    e.row[*i] = 1.0;
    return e;
  }
  using D = Dual<4>;
  const ShipState<D> state{D(s[0]), D(s[1]), D(s[2], 0), {D(s[3], 1), D(s[4], 2), D(s[5], 3)}};
  const auto value = shown(channel, state, Current<D>{D(current.speed), D(current.to)});
  e.value = value.a;
  e.row.template segment<4>(2) = value.v;
  return e;
}

/// Prediction error of a measurement and its expected variance.
struct Innovation {
  double error;
  double variance;
};

/// Estimate with its covariance.
template <int N>
struct Belief {
  FilterVector<N> mean;
  FilterMatrix<N> P;
};

/// Takes in one measurement. Nonlinear channels are linearized twice, the second time where the first update leads.
///
///     S = h P hᵀ + R,   K = P hᵀ/S,   P⁺ = (I − K h) P (I − K h)ᵀ + K R Kᵀ, Joseph's form
template <int N>
Innovation take_in(Belief<N>& belief, Channel channel, double measured, double variance, const Current<double>& current) {
  const FilterVector<N> before = belief.mean;
  Innovation first{};
  const int passes = plain_state(channel) ? 1 : 2;
  FilterVector<N> K, Ph;
  for (int pass = 0; pass < passes; ++pass) {
    const auto e = expected<N>(channel, belief.mean, current);
    Ph = belief.P * e.row;
    const double S = e.row.dot(Ph) + variance;
    K = Ph / S;
    double error = measured - e.value - e.row.dot(before - belief.mean);
    if (is_direction(channel)) error = wrapped(error);
    if (pass == 0) first = {error, S};
    belief.mean = before + K * error;
    if (pass + 1 < passes) continue;
    const FilterMatrix<N> KPh = K * Ph.transpose();
    belief.P += K * S * K.transpose() - KPh - KPh.transpose();
  }
  return first;
}

}  // namespace swayaw
