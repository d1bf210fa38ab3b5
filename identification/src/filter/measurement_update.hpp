#pragma once

#include "channel_observer.hpp"
#include "ship_predictor.hpp"

/// What a measurement does to an estimate of the state, and what the future of a sample tells of it. Not installed.
namespace swayaw::inline identification::detail {

// ---------------------------------------------------------------- forward

/// Mean and covariance of the state.
template <int N>
struct Gaussian {
  FilterVector<N> mean;
  FilterMatrix<N> P;
};

/// What a measurement told: error e and variance S of its prediction, and the gain K.
template <int N>
struct Innovation {
  int state;  ///< that the channel shows alone, or −1
  double error;
  double variance;
  FilterVector<N> K;
};

/// By what factor the variance S of the prediction of a measurement is widened where its error e is more than so many
/// standard deviations c:
///
///     S' = S |e|/(c √S)   for   |e| > c √S
///
/// so that the squared error over it grows as |e| and not as e²: the likelihood of an outlier falls as that of Laplace,
/// and the gain of the filter with it. Source: [Huber1981]
inline double widening_of(double error, double S, double c) {
  if (error * error <= c * c * S) return 1.0;  // most are none, and roots take long
  return std::max(1.0, std::abs(error) / (c * std::sqrt(S)));
}

/// The same factor of an innovation, whose variance S' is the widened one: e²/(c² S').
template <int N>
double widening_of(const Innovation<N>& now, double c) {
  return std::max(1.0, now.error * now.error / (c * c * now.variance));
}

/// Measurement update by a channel that shows one state alone.
///
///     S = h P hᵀ + R,   K = P hᵀ/S,   x⁺ = x + K e,   P⁺ = P − K S Kᵀ
///
/// of one scalar, P⁺ is symmetric by construction, and positive since R is not below rounding of h P hᵀ.
/// @param outlying  standard deviations beyond which a measurement is an outlier
template <int N>
Innovation<N> updated(Gaussian<N>& estimate, Channel channel, int state, double measured, double R,
                      double outlying = HUGE_VAL) {
  const double error = compared(channel, measured, estimate.mean[state]), S_0 = estimate.P(state, state) + R,
               S = S_0 * widening_of(error, S_0, outlying);
  const Innovation<N> innovation{.state = state, .error = error, .variance = S, .K = estimate.P.col(state) / S};
  estimate.mean += innovation.K * error;
  estimate.P.noalias() -= (S * innovation.K) * innovation.K.transpose();
  return innovation;
}

/// The same for any channel, linearized again where the first update leads, unless it is linear.
/// @param expected  double expected(const FilterVector<N>& x, FilterVector<N>& slope)
template <int N, class Expected>
Innovation<N> updated(Gaussian<N>& estimate, Channel channel, Expected&& expected, bool linear, double measured,
                      double R, FilterVector<N>& slope, double outlying = HUGE_VAL) {
  Innovation<N> innovation{.state = -1};
  FilterVector<N> x = estimate.mean;
  for (int pass = 0; pass < (linear ? 1 : 2); ++pass) {
    const double h = expected(x, slope);
    const FilterVector<N> Ph = estimate.P * slope;
    innovation.error = compared(channel, measured, h) - slope.dot(estimate.mean - x);
    const double S = slope.dot(Ph) + R;
    innovation.variance = S * widening_of(innovation.error, S, outlying);
    innovation.K = Ph / innovation.variance;
    x = estimate.mean + innovation.K * innovation.error;
  }
  estimate.mean = x;
  estimate.P.noalias() -= (innovation.variance * innovation.K) * innovation.K.transpose();
  return innovation;
}

// ---------------------------------------------------------------- backward

/// What the future tells of a sample: the smoothed state is x + P r, its covariance P − P M P.
///
/// The form of Rauch, Tung and Striebel's smoother that inverts no covariance, so that a ship without any process noise
/// is nothing special. Sources: [Rauch1965], [DeJong1989]
template <int N>
struct Smoother {
  FilterVector<N> r = FilterVector<N>::Zero();
  FilterMatrix<N> M = FilterMatrix<N>::Zero();

  /// ∂(log likelihood)/∂q of a variance q that state i gains here.
  double slope(int i) const { return 0.5 * (r[i] * r[i] - M(i, i)); }

  /// The same of what moves all states by g.
  double slope(const FilterVector<N>& g) const { return 0.5 * (std::pow(r.dot(g), 2) - g.dot(M * g)); }

  /// Before a step: Φᵀ M Φ and Φᵀ r.
  void step_back(const Transition<N>& t);

  /// Before a measurement. With the smoothed error e_s of the measurement over its variance R, and its variance D,
  ///
  ///     e_s = e/S − Kᵀr,   D = 1/S + KᵀMK,   r⁻ = r + hᵀe_s,   M⁻ = (1 − Kh)ᵀ M (1 − Kh) + hᵀh/S
  ///
  /// @param h  slope of a channel that shows no state alone
  /// @return ½ (e_s² − D), the slope of the log likelihood by R. Source: [Koopman1992]
  double step_back(const Innovation<N>& now, const FilterVector<N>& h);
};

}  // namespace swayaw::identification::detail
