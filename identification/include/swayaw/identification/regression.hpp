#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "swayaw/identification/fit_report.hpp"

/// Linear regression y = X b + e for forces: what the data tell about each coefficient, and what they do not.
namespace swayaw::inline identification {

/// Measurements that are linear in unknown coefficients. The rows of a run follow each other in equal steps of time.
struct Design {
  std::vector<std::string> names;       ///< of the coefficients, one for each column
  Eigen::MatrixXd X;                    ///< features, a row for each sample
  Eigen::VectorXd y;                    ///< what is explained
  std::vector<Eigen::Index> runs = {};  ///< first row of each run; empty for one run
  Eigen::VectorXd variance = {};        ///< of each y, up to a common factor; empty where all are equal
};

/// What is assumed of the residuals e.
enum class Residuals {
  independent,     ///< from sample to sample: least squares, weighted where the design has variances
  autoregressive,  ///< e_t = Σ phi_k e_{t−k} + white, within a run: generalised least squares
};

enum class StandardErrors {
  of_model,    ///< as the assumption on the residuals says
  newey_west,  ///< right for large samples though residuals are correlated and of unequal size
};

/// A coefficient that is known before: normal with that mean and standard deviation.
struct Prior {
  std::string name;
  double mean;
  double deviation;
};

/// Σ weight b = sum, exactly.
struct Constraint {
  std::vector<std::pair<std::string, double>> terms;  ///< name, weight
  double sum = 0.0;
};

/// Features that are measured with errors. Least squares takes them for exact and finds coefficients that are too
/// small.
struct FeatureErrors {
  std::vector<Eigen::MatrixXd> covariance;  ///< of (x, y) of a sample, (p + 1)², the last row and column that of y; one
                                            ///< for all samples, or one for each. Empty: features are exact
  bool size_known = true;  ///< else the covariances are right up to a factor: total least squares
};

struct RegressionOptions {
  Residuals residuals = Residuals::independent;
  int order = 1;  ///< of the autoregression
  StandardErrors standard_errors = StandardErrors::of_model;
  double ridge = 0.0;  ///< shrinks as if `ridge` samples had said 0 of each coefficient
  std::vector<Prior> priors = {};
  std::vector<Constraint> constraints = {};
  FeatureErrors feature_errors = {};
  bool variance_known = false;  ///< the variances of the design are the true ones, not up to a factor
};

/// How the equations were solved.
enum class Solver {
  normal_equations,  ///< Cholesky factors of the products of columns, where they are far from collinear
  qr,                ///< orthogonal, with pivots
  svd,               ///< truncated, since some combination is not determined at all
};

/// "normal equations", "QR", "SVD"
std::string_view in_words(Solver solver);

/// A coefficient and what the data tell of it.
struct Coefficient {
  std::string name;
  Estimate estimate;
  double low, high;           ///< 95 % interval, by Student's distribution
  double variance_inflation;  ///< variance over that of the column alone, 1 where it is orthogonal to all others
  double attenuation;  ///< what least squares on the same data finds minus the estimate, where features have errors;
                       ///< else 0
  bool undetermined;   ///< it could be changed so much that its own force were half of all measured force
};

/// A sum Σ weight (b × rms of its column) that the data do not determine, largest weight 1.
struct Combination {
  std::vector<std::pair<std::string, double>> terms;  ///< name, weight; those below a tenth left out
  double standard_error;  ///< over the rms of y; infinite where y does not depend on it at all
};

/// "Y_v - 0.98 Y_r"
std::string in_words(const Combination& combination);

/// Result of a regression.
struct Regression {
  FitStatus status;
  Solver solver;
  std::vector<Coefficient> coefficients;
  Eigen::MatrixXd covariance;             ///< of the coefficients
  Eigen::VectorXd residuals;              ///< y − X b
  double residual_rms;                    ///< of them
  double R2;                              ///< share of the variance of y about its mean that is explained
  double samples;                         ///< effective number, less than the rows where residuals are correlated
  double degrees_of_freedom;              ///< of the intervals
  double condition_number;                ///< of the features, each column scaled to the same size
  std::vector<Combination> undetermined;  ///< worst first
  Eigen::VectorXd autoregression;  ///< phi_1, phi_2, … of the residuals; empty where they are taken as independent
  double error_size;  ///< factor of the covariances of the features that total least squares finds; 1 otherwise
  int iterations;     ///< of autoregression or noise, 1 where there is nothing to iterate

  /// @throws Refusal  if there is no coefficient of that name
  const Coefficient& operator[](std::string_view name) const;
};

/// Correlation of the estimates; not a number where one is not determined.
Eigen::MatrixXd correlation(const Regression& fit);

/// Coefficients of a design.
///
///     b = argmin Σ (y − X b)²/variance + Σ ((b − mean)/deviation)²   on  C b = d
///
/// Errors in features: with Σ the sum of their covariances over the samples, (XᵀX − Σ_xx) b = Xᵀy − Σ_xy; total least
/// squares takes instead of Σ the largest multiple that leaves [X y]ᵀ[X y] positive. Correlated residuals: phi by Yule
/// and Walker from the residuals of all runs, rows made white as Prais and Winsten do, repeated until phi stays.
/// Newey–West errors: Bartlett weights, automatic bandwidth, scores whitened beforehand.
///
/// Source: [Prais1954], [Newey1994], [Andrews1992], [Fuller1987]
///
/// @throws Refusal            if a name is not known, a number is not finite, constraints contradict each other, or
/// there are not more samples
///                            than coefficients
/// @throws std::domain_error  if sizes do not fit, a variance or deviation is not positive, or correlated residuals are
/// asked
///                            for together with errors in features
Regression regress(const Design& design, const RegressionOptions& options = {});

}  // namespace swayaw::identification
