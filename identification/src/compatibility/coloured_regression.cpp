#include "coloured_regression.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "swayaw/core/detail/matrices.hpp"
#include "swayaw/core/parallel.hpp"

namespace swayaw::inline identification::detail {
namespace {

/// Columns after the Kalman filter of the errors: innovations over their standard deviations.
struct Whitened {
  RowMatrix Xy;
  double log_determinant = 0.0;  ///< of the covariance of the errors
};

/// Kalman filter of the errors (m_0, w_0, m_1, w_1, c, jitter), or of (m_0, w_0) where there is one axis, for all
/// columns at once: their gains are the same.
template <int N>
class ErrorFilter {
 public:
  ErrorFilter(const ErrorModel& e, Eigen::Index columns) : e_(e), X_(States::Zero(N, columns)) {
    P_.setZero();
    for (int i = 0; i < axes; i += 2) P_(i, i) = e.markov * e.markov;
    if constexpr (N == 6) P_(5, 5) = e.jitter * e.jitter;
  }

  /// Over a time step: m decays, w and c walk, the jitter is drawn anew; `bridge` of a gap.
  void predict(double dt, double bridge) {
    if (dt <= 0.0) return;
    const double phi = std::exp(-dt / e_.memory);
    for (int i = 0; i < axes; i += 2) {
      P_.row(i) *= phi;
      P_.col(i) *= phi;
      P_(i, i) += e_.markov * e_.markov * (1.0 - phi * phi);
      P_(i + 1, i + 1) += e_.walk * e_.walk * dt + bridge * bridge;
      X_.row(i) *= phi;
    }
    if constexpr (N == 6) {
      P_(4, 4) += e_.clock * e_.clock * dt;
      P_.row(5).setZero();
      P_.col(5).setZero();
      P_(5, 5) = e_.jitter * e_.jitter;
      X_.row(5).setZero();
    }
  }

  /// One row of [X y], on an axis: its innovations. S = H P Hᵀ + R,  K = P Hᵀ / S,  P⁺ = P − K S Kᵀ
  template <class Row>
  double update(int axis, double speed, Row row) {
    Eigen::Matrix<double, N, 1> PH = P_.col(2 * axis) + P_.col(2 * axis + 1);
    if constexpr (N == 6) PH += speed * (P_.col(4) + P_.col(5));
    const auto along = [&](const auto& states) {
      auto sum = (states.row(2 * axis) + states.row(2 * axis + 1)).eval();
      if constexpr (N == 6) sum += speed * (states.row(4) + states.row(5));
      return sum;
    };
    const double S = along(PH)(0) + e_.white * e_.white;
    row -= along(X_);
    X_.noalias() += (PH / S) * row;
    P_.noalias() -= (PH / S) * PH.transpose();
    return S;
  }

 private:
  using States = Eigen::Matrix<double, N, Eigen::Dynamic>;
  static constexpr int axes = N == 6 ? 4 : 2;
  ErrorModel e_;
  Eigen::Matrix<double, N, N> P_;
  States X_;
};

template <int N>
Whitened whitened_by(const TimeSeries& s, const ErrorModel& errors) {
  Whitened result{s.Xy};
  ErrorFilter<N> filter(errors, s.Xy.cols());
  for (std::size_t k = 0; k < s.time.size(); ++k) {
    auto row = result.Xy.row(static_cast<Eigen::Index>(k));
    filter.predict(k > 0 ? s.time[k] - s.time[k - 1] : 0.0, s.bridge[k]);
    const double S = filter.update(s.axis[k], s.speed[k], row);
    row /= std::sqrt(S);
    result.log_determinant += std::log(S);
  }
  return result;
}

Whitened whitened(const TimeSeries& s, const ErrorModel& errors) {
  return std::ranges::count(s.axis, 1) > 0 ? whitened_by<6>(s, errors) : whitened_by<2>(s, errors);
}

/// A = Xᵀ X + diag(prior)⁻² and b = Xᵀ y of whitened rows, in units in which the diagonal of A is 1.
struct Normal {
  Eigen::MatrixXd A;
  Eigen::VectorXd b;
  Eigen::VectorXd unit;  ///< of beta
  double yy = 0.0;
  double log_determinant = 0.0;  ///< of the errors and of A in units of the prior
};

Normal normal_of(const Whitened& white, const Eigen::VectorXd& prior) {
  const Eigen::Index n = prior.size();
  const Eigen::MatrixXd all = white.Xy.transpose() * white.Xy;
  Normal normal;
  normal.A = all.topLeftCorner(n, n);
  normal.A.diagonal().array() += prior.array().square().inverse();
  normal.unit = normal.A.diagonal().array().rsqrt();
  normal.A = (normal.unit.asDiagonal() * normal.A * normal.unit.asDiagonal()).eval();
  normal.b = normal.unit.cwiseProduct(all.topRightCorner(n, 1));
  normal.yy = all(n, n);
  normal.log_determinant = white.log_determinant + core::detail::log_determinant(normal.A) +
                           2.0 * (prior.array() / normal.unit.array()).log().sum();
  return normal;
}

/// −2 ln of the likelihood of the errors, beta integrated out:  ln det V + ln det A + yᵀ y − bᵀ A⁻¹ b
double deviance(const TimeSeries& series, const Eigen::VectorXd& prior, const ErrorModel& errors) {
  const auto normal = normal_of(whitened(series, errors), prior);
  return normal.log_determinant + normal.yy - normal.b.dot(core::detail::solve_symmetric(normal.A, normal.b));
}

/// The least and the largest that the search may try.
struct Range {
  ErrorModel low, high;
};

Range range_of(const TimeSeries& s, const ErrorModel& start) {
  const double T = s.time.back() - s.time.front(), step = T / static_cast<double>(s.time.size());
  const double none = 1e-3 * std::max({start.white, start.markov, start.walk});
  const auto least = [](double first) { return first > 0.0 ? 1e-4 : 0.0; };  // [s]
  const auto most = [](double first) { return first > 0.0 ? 3.0 : 0.0; };    // [s]
  // a memory of a sample is white noise, one of the whole run a constant
  return {{1e-2 * none, none, 2.0 * step, none, least(start.clock), least(start.jitter)},
          {HUGE_VAL, HUGE_VAL, std::max(0.3 * T, 4.0 * step), HUGE_VAL, most(start.clock), most(start.jitter)}};
}

struct Likeliest {
  ErrorModel errors;
  double deviance;
};

/// Descends the deviance along one number of the error model after the other, in ever smaller factors.
Likeliest likeliest_errors(const TimeSeries& few, const Eigen::VectorXd& prior, const ErrorModel& start) {
  constexpr std::array numbers{&ErrorModel::white,  &ErrorModel::walk,  &ErrorModel::markov,
                               &ErrorModel::memory, &ErrorModel::clock, &ErrorModel::jitter};
  constexpr std::array factors{8.0, 3.0, 1.6, 1.25};  // errors to 12 %: their effect on beta is of second order
  constexpr double worth = 0.1;                       // of deviance
  const auto range = range_of(few, start);
  Likeliest best{start, deviance(few, prior, start)};
  const auto improves = [&](double ErrorModel::*number, double factor) {
    auto next = best.errors;
    next.*number = std::clamp(next.*number * factor, range.low.*number, range.high.*number);
    if (next.*number == best.errors.*number) return false;
    const double there = deviance(few, prior, next);
    if (!(there < best.deviance - worth)) return false;
    best = {next, there};
    return true;
  };
  for (const double factor : factors)
    for (bool moved = true; moved;) {
      moved = false;
      for (const auto number : numbers)
        for (const double step : {factor, 1.0 / factor})
          while (improves(number, step)) moved = true;
    }
  return best;
}

Likeliest likeliest_of(const TimeSeries& series, const Eigen::VectorXd& prior, std::span<const ErrorModel> starts) {
  const auto few = thinned(series);
  std::vector<Likeliest> ends(starts.size());
  in_parallel(starts.size(), 0, [&](std::size_t i) { ends[i] = likeliest_errors(few, prior, starts[i]); });
  return *std::ranges::min_element(ends, {}, &Likeliest::deviance);
}

/// Σ over lags of Bartlett's weight times g_k g_{k+lag}ᵀ and its transpose, in the units of the normal equations.
Eigen::MatrixXd scores_with_memory(const Whitened& white, const Eigen::VectorXd& beta, const Eigen::VectorXd& unit) {
  const Eigen::Index n = beta.size();
  const Eigen::VectorXd e = white.Xy.col(n) - white.Xy.leftCols(n) * beta;
  const RowMatrix g = (white.Xy.leftCols(n) * unit.asDiagonal()).array().colwise() * e.array();
  // Newey and West's plug-in rule for the longest lag
  const auto longest = static_cast<Eigen::Index>(4.0 * std::pow(static_cast<double>(g.rows()) / 100.0, 2.0 / 9.0));
  Eigen::MatrixXd sum = g.transpose() * g;
  for (Eigen::Index lag = 1; lag <= std::min(longest, g.rows() - 1); ++lag) {
    const double weight = 1.0 - static_cast<double>(lag) / static_cast<double>(longest + 1);
    const Eigen::MatrixXd shifted = g.topRows(g.rows() - lag).transpose() * g.bottomRows(g.rows() - lag);
    sum += weight * (shifted + shifted.transpose());
  }
  return sum;
}

/// A covariance with the variances of another where these are larger, correlations kept.
Eigen::MatrixXd enlarged(const Eigen::MatrixXd& C, const Eigen::MatrixXd& other) {
  const Eigen::VectorXd factor = (other.diagonal().array() / C.diagonal().array()).max(1.0).sqrt();
  return factor.asDiagonal() * C * factor.asDiagonal();
}

}  // namespace

TimeSeries thinned(const TimeSeries& s) {
  constexpr std::size_t enough = 600;
  const std::size_t n = 1 + (s.time.size() - 1) / enough;
  std::vector<std::size_t> rows;
  std::array<std::size_t, 2> seen{};
  for (std::size_t k = 0; k < s.time.size(); ++k)
    if (seen[static_cast<std::size_t>(s.axis[k])]++ % n == 0) rows.push_back(k);
  TimeSeries few(rows.size(), s.Xy.cols());
  for (std::size_t i = 0, k = 0; i < rows.size(); ++i) {
    few.time[i] = s.time[rows[i]];
    few.axis[i] = s.axis[rows[i]];
    few.speed[i] = s.speed[rows[i]];
    for (; k <= rows[i]; ++k) few.bridge[i] = std::hypot(few.bridge[i], s.bridge[k]);
    few.Xy.row(static_cast<Eigen::Index>(i)) = s.Xy.row(static_cast<Eigen::Index>(rows[i]));
  }
  return few;
}

ColouredFit coloured_regression(const TimeSeries& series, const Eigen::VectorXd& prior,
                                std::span<const ErrorModel> starts) {
  const auto likeliest = likeliest_of(series, prior, starts);
  const auto white = whitened(series, likeliest.errors);
  const auto normal = normal_of(white, prior);
  const Eigen::MatrixXd C = core::detail::inverse(normal.A);
  const Eigen::VectorXd beta = normal.unit.cwiseProduct(C * normal.b);
  const Eigen::MatrixXd wider = enlarged(C, C * scores_with_memory(white, beta, normal.unit) * C);
  return {beta, normal.unit.asDiagonal() * wider * normal.unit.asDiagonal(), likeliest.errors, likeliest.deviance};
}

Eigen::VectorXd gains_of(const TimeSeries& series, const Eigen::VectorXd& prior, const ErrorModel& errors,
                         const RowMatrix& Z) {
  const Eigen::Index n = prior.size();
  TimeSeries all = series;
  all.Xy.resize(Z.rows(), n + 1 + Z.cols());
  all.Xy << series.Xy, Z;
  const auto white = whitened(all, errors).Xy;
  const auto X = white.leftCols(n), z = white.rightCols(Z.cols());
  const auto y = white.col(n);
  Eigen::MatrixXd A = X.transpose() * X;
  A.diagonal().array() += prior.array().square().inverse();
  const Eigen::VectorXd unit = A.diagonal().array().rsqrt();
  const Eigen::MatrixXd inverse = core::detail::inverse((unit.asDiagonal() * A * unit.asDiagonal()).eval());
  const Eigen::MatrixXd Xz = unit.asDiagonal() * (X.transpose() * z);
  const Eigen::VectorXd beta = inverse * (unit.asDiagonal() * (X.transpose() * y)).eval();
  const Eigen::VectorXd zMy = z.transpose() * y - Xz.transpose() * beta;
  const Eigen::VectorXd zz = z.colwise().squaredNorm().transpose();
  const Eigen::VectorXd zMz = zz - Xz.cwiseProduct(inverse * Xz).colwise().sum().transpose();
  // a column that the others make good tells nothing
  constexpr double own = 1e-6;
  return (zMz.array() > own * zz.array()).select(zMy.array().square() / zMz.array(), 0.0);
}

}  // namespace swayaw::identification::detail
