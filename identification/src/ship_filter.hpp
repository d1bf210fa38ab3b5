#pragma once

#include <optional>

#include "measurement.hpp"
#include "ship_predictor.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/recording.hpp"

/// What a measurement does to the belief about a ship, and what the future of a sample tells of it. Not installed.
namespace swayaw {

// ---------------------------------------------------------------- channels

/// The state that a channel shows alone, or −1.
inline int plain_state(Channel channel) {
  switch (channel) {
    case Channel::x: return 0;
    case Channel::y: return 1;
    case Channel::psi: return 2;
    case Channel::u:
    case Channel::speed_through_water: return 3;
    case Channel::v: return 4;
    case Channel::r: return 5;
    default: return -1;
  }
}

// ---------------------------------------------------------------- forward

/// Estimate with its covariance.
template <int N>
struct Belief {
  FilterVector<N> mean;
  FilterMatrix<N> P;
};

/// What a measurement told: error e and variance S of its prediction, and the gain K.
template <int N>
struct Sighting {
  Channel channel;
  double error;
  double variance;
  FilterVector<N> K;
};

/// h of a channel that shows no state alone, by psi, u, v, r.
using ChannelSlope = Eigen::Vector4d;

/// The error of a prediction; directions less than half a turn apart.
inline double compared(Channel channel, double measured, double predicted) {
  const double error = measured - predicted;
  return is_direction(channel) && std::abs(error) > pi ? wrapped(error) : error;
}

/// Takes in one measurement.
///
///     S = h P hᵀ + R,   K = P hᵀ/S,   x⁺ = x + K e,   P⁺ = P − K S Kᵀ
///
/// of one scalar, P⁺ is symmetric by construction, and positive since R is not below rounding of h P hᵀ.
template <int N>
Sighting<N> taken_in(Belief<N>& belief, Channel channel, int state, double measured, double R) {
  const double error = compared(channel, measured, belief.mean[state]), S = belief.P(state, state) + R;
  const Sighting<N> seen{.channel = channel, .error = error, .variance = S, .K = belief.P.col(state) / S};
  belief.mean += seen.K * error;
  belief.P.noalias() -= (S * seen.K) * seen.K.transpose();
  return seen;
}

/// The same for a nonlinear channel, linearized again where the first update leads.
template <int N>
Sighting<N> taken_in(Belief<N>& belief, Channel channel, const Current<double>& current, double measured, double R,
                     ChannelSlope& slope) {
  using D = Dual<4>;
  Sighting<N> seen{.channel = channel};
  FilterVector<N> x = belief.mean;
  for (int pass = 0; pass < 2; ++pass) {
    const D h = shown(channel, in_duals(ship_state<N>(x)), Current<D>{D(current.speed), D(current.to)});
    slope = h.v;
    const FilterVector<N> Ph = belief.P.template middleCols<4>(2) * h.v;
    seen.variance = h.v.dot(Ph.template segment<4>(2)) + R;
    seen.K = Ph / seen.variance;
    seen.error = compared(channel, measured, h.a) - h.v.dot((belief.mean - x).template segment<4>(2));
    x = belief.mean + seen.K * seen.error;
  }
  belief.mean = x;
  belief.P.noalias() -= (seen.variance * seen.K) * seen.K.transpose();
  return seen;
}

// ---------------------------------------------------------------- backward

/// What the future tells of a moment: the smoothed state is x + P r, its covariance P − P M P.
///
/// The form of Rauch, Tung and Striebel's smoother that inverts no covariance, so that a ship without any imperfection
/// is nothing special. Sources: [Rauch1965], [DeJong1989]
template <int N>
struct Future {
  FilterVector<N> r = FilterVector<N>::Zero();
  FilterMatrix<N> M = FilterMatrix<N>::Zero();

  /// ∂(log likelihood)/∂q of a variance q that state i gains here.
  double slope(int i) const { return 0.5 * (r[i] * r[i] - M(i, i)); }

  /// Before a step.
  void step_back(const Transition<N>& t) {
    r = carried_back<N>(r, t);
    M = carried_back<N>(M, t);
  }

  /// Before a measurement. With the smoothed error e_s of the measurement over its variance R, and its variance D,
  ///
  ///     e_s = e/S − Kᵀr,   D = 1/S + KᵀMK,   r⁻ = r + hᵀe_s,   M⁻ = (1 − Kh)ᵀ M (1 − Kh) + hᵀh/S
  ///
  /// @return ½ (e_s² − D), the slope of the log likelihood by R. Source: [Koopman1992]
  double step_back(const Sighting<N>& seen, const ChannelSlope& h) {
    const FilterVector<N> MK = M * seen.K;
    const double e_s = seen.error / seen.variance - seen.K.dot(r), D = 1.0 / seen.variance + seen.K.dot(MK);
    if (const int i = plain_state(seen.channel); i >= 0) {
      r[i] += e_s;
      M.row(i) -= MK.transpose();
      M.col(i) -= MK;
      M(i, i) += D;
    } else {
      r.template segment<4>(2) += h * e_s;
      M.template middleRows<4>(2) -= h * MK.transpose();
      M.template middleCols<4>(2) -= MK * h.transpose();
      M.template block<4, 4>(2, 2) += D * h * h.transpose();
    }
    return 0.5 * (e_s * e_s - D);
  }
};

}  // namespace swayaw
