#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "linear_estimates.hpp"
#include "linear_filter.hpp"
#include "linear_run.hpp"

/// Likelihood of recordings under the linear equations. Not installed.
namespace swayaw::inline identification::detail {

/// Places in the vector of parameters. The constants are a1 … c2, or without drift e0, e1, nw0, nw1.
/// Noises and disturbances are logarithms of standard deviations.
enum FitPlace {
  constants,
  rudder_offset = 6,
  yaw_rate_offset,
  drift_offset,
  noise_psi,
  noise_r,
  noise_beta,
  disturbance_beta,
  disturbance_omega,
  places
};

using Parameters = Eigen::Matrix<double, places, 1>;
using Information = Eigen::Matrix<double, places, places>;

/// What is fitted: the runs, whether drift was measured, and which parameters are free.
struct LinearProblem {
  std::vector<LinearRun> runs;
  bool with_drift;
  bool with_disturbances;
  double mean_rate;  ///< U/L [1/s]
  std::vector<int> free;

  int constant_count() const { return with_drift ? 6 : 4; }
};

/// Smallest measurement noise that is believed: 1e-6 rad, 1e-6 U/L.
inline constexpr double least_noise = 1e-6;

template <class S>
LinearModel<S> model_of(const LinearProblem& problem, const Eigen::Matrix<S, places, 1>& p) {
  const auto variance = [&](int place, double floor) { return S(exp(2.0 * p[place]) + floor * floor); };
  const auto growth = [&](int place) { return problem.with_disturbances ? S(exp(2.0 * p[place])) : S(0.0); };
  return {
      .ship = problem.with_drift ? SwayYawCoefficients<S>{p[0], p[1], p[2], p[3], p[4], p[5]}
                                 : yaw_only_ship(p[0], p[1], p[2], p[3]),
      .rudder_offset = p[rudder_offset],
      .yaw_rate_offset = p[yaw_rate_offset],
      .drift_offset = p[drift_offset],
      .var_psi = variance(noise_psi, least_noise),
      .var_r = variance(noise_r, least_noise * problem.mean_rate),
      .var_beta = variance(noise_beta, least_noise),
      .q_beta = growth(disturbance_beta),
      .q_omega = growth(disturbance_omega),
  };
}

/// First heading that was measured; 0 if none was.
double first_heading(const LinearRun& run);

/// Filters all runs. `sample()` before the measurements of each sample.
template <class S, class Seen, class Sample>
void filter_all(const LinearProblem& problem, const Eigen::Matrix<S, places, 1>& p, Seen&& seen, Sample&& sample) {
  const auto model = model_of(problem, p);
  for (const auto& run : problem.runs) {
    LinearFilter<S> filter(model, first_heading(run));
    sample();
    filter_run(filter, run, seen, sample);
  }
}

/// ln of the likelihood, −½ Σ (e²/S + ln S).
double log_likelihood(const LinearProblem& problem, const Parameters& p);

/// Gradient of the log likelihood and its expected curvature.
struct LikelihoodSlope {
  Parameters gradient = Parameters::Zero();
  Information information = Information::Zero();
  std::vector<Parameters> by_sample;  ///< gradient, sample by sample, of one run after the other
};

LikelihoodSlope slope(const LinearProblem& problem, const Parameters& p);

inline Eigen::VectorXd of_free(const LinearProblem& problem, const Parameters& p) { return p(problem.free); }
inline Eigen::MatrixXd of_free(const LinearProblem& problem, const Information& m) {
  return m(problem.free, problem.free);
}

}  // namespace swayaw::identification::detail
