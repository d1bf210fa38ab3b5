#include "residual_noise.hpp"

#include <algorithm>
#include <cmath>

namespace swayaw::inline identification::detail {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Σ_t e_t e_{t+lag} within runs.
double lagged_product(const VectorXd& e, const std::vector<RowRange>& runs, Index lag) {
  double sum = 0.0;
  for (const auto& [first, count] : runs)
    if (count > lag) sum += e.segment(first, count - lag).dot(e.segment(first + lag, count - lag));
  return sum;
}

/// Σ_t g_t g_{t+lag}ᵀ within runs.
MatrixXd lagged_products(const MatrixXd& g, const std::vector<RowRange>& runs, Index lag) {
  MatrixXd sum = MatrixXd::Zero(g.cols(), g.cols());
  for (const auto& [first, count] : runs)
    if (count > lag) sum += g.middleRows(first, count - lag).transpose() * g.middleRows(first + lag, count - lag);
  return sum;
}

/// Lags with a Bartlett weight for a sum of rows: 1.1447 ((s_1/s_0)² n)^(1/3), s_j = Σ |k|^j covariance at lag k up to
/// `look`. Source: [Newey1994] table II
double bandwidth(const VectorXd& f, const std::vector<RowRange>& runs, Index look) {
  double s_0 = lagged_product(f, runs, 0), s_1 = 0.0;
  for (Index k = 1; k <= look; ++k) {
    const double product = lagged_product(f, runs, k);
    s_0 += 2.0 * product;
    s_1 += 2.0 * static_cast<double>(k) * product;
  }
  const double n = static_cast<double>(f.size());
  if (!(s_0 != 0.0)) return 0.0;
  return std::min(1.1447 * std::cbrt(s_1 * s_1 / (s_0 * s_0) * n), 0.5 * n);
}

Index lags_to_look_at(Index rows, double factor) {
  return static_cast<Index>(factor * std::pow(static_cast<double>(rows) / 100.0, 2.0 / 9.0));
}

/// 1 − k/(bandwidth + 1)
double bartlett(Index lag, double width) { return 1.0 - static_cast<double>(lag) / (width + 1.0); }

/// Rows without their first of each run, and where the runs then are.
struct Differenced {
  MatrixXd rows;
  std::vector<RowRange> runs;
};

/// g_t − a g_{t−1}, column by column.
Differenced differenced(const MatrixXd& g, const VectorXd& a, const std::vector<RowRange>& runs) {
  Differenced result{MatrixXd(g.rows() - static_cast<Index>(runs.size()), g.cols()), {}};
  Index row = 0;
  for (const auto& [first, count] : runs) {
    result.runs.push_back({row, count - 1});
    result.rows.middleRows(row, count - 1) =
        g.middleRows(first + 1, count - 1) - g.middleRows(first, count - 1) * a.asDiagonal();
    row += count - 1;
  }
  return result;
}

/// First autocorrelation of each column, kept from 1 as [Andrews1992] advise.
VectorXd first_autocorrelations(const MatrixXd& g, const std::vector<RowRange>& runs) {
  const VectorXd one = lagged_products(g, runs, 1).diagonal(), zero = lagged_products(g, runs, 0).diagonal();
  return (zero.array() > 0.0).select(one.array() / zero.array(), 0.0).cwiseMin(0.97).cwiseMax(-0.97);
}

}  // namespace

double Autoregression::rows_for_one() const {
  const auto& full = of_full_order();
  const double gain = 1.0 - full.sum();
  return variance[0] > 0.0 ? variance[variance.size() - 1] / (gain * gain * variance[0]) : 1.0;
}

Autoregression autoregression_of(const VectorXd& e, const std::vector<RowRange>& runs, Index order) {
  VectorXd c(order + 1);
  for (Index k = 0; k <= order; ++k) c[k] = lagged_product(e, runs, k) / static_cast<double>(e.size());
  Autoregression noise{{VectorXd()}, VectorXd::Constant(order + 1, c[0])};
  for (Index k = 1; k <= order; ++k) {
    const VectorXd last = noise.phi.back();
    const double left = noise.variance[k - 1];
    // reflection: the part of lag k that lower lags do not explain
    const double reflection = left > 0.0 ? (c[k] - last.dot(c.segment(1, k - 1).reverse())) / left : 0.0;
    VectorXd next(k);
    next << last - reflection * last.reverse(), reflection;
    noise.phi.push_back(next);
    noise.variance[k] = left * (1.0 - reflection * reflection);
  }
  return noise;
}

MatrixXd whitened(const Autoregression& noise, const MatrixXd& rows, const std::vector<RowRange>& runs) {
  const Index order = noise.of_full_order().size();
  MatrixXd white = rows;
  for (const auto& [first, count] : runs) {
    for (Index t = 0; t < std::min(order, count); ++t) {
      const auto& phi = noise.phi[static_cast<std::size_t>(t)];
      for (Index k = 1; k <= t; ++k) white.row(first + t) -= phi[k - 1] * rows.row(first + t - k);
      if (noise.variance[order] > 0.0) white.row(first + t) *= std::sqrt(noise.variance[order] / noise.variance[t]);
    }
    for (Index k = 1; k <= order && count > order; ++k)
      white.middleRows(first + order, count - order) -=
          noise.of_full_order()[k - 1] * rows.middleRows(first + order - k, count - order);
  }
  return white;
}

MatrixXd covariance_of_sum(const MatrixXd& scores, const std::vector<RowRange>& runs) {
  const VectorXd a = first_autocorrelations(scores, runs);
  const auto white = differenced(scores, a, runs);
  MatrixXd sum = lagged_products(white.rows, white.runs, 0);
  const VectorXd size = sum.diagonal().cwiseSqrt();
  const VectorXd over = (size.array() > 0.0).select(size.cwiseInverse(), 0.0);
  const double width = bandwidth(white.rows * over, white.runs, lags_to_look_at(white.rows.rows(), 3.0));
  for (Index k = 1; k <= static_cast<Index>(width); ++k) {
    const MatrixXd product = lagged_products(white.rows, white.runs, k);
    sum += bartlett(k, width) * (product + product.transpose());
  }
  const VectorXd colour = (1.0 - a.array()).inverse();
  const double share = static_cast<double>(scores.rows()) / static_cast<double>(white.rows.rows());
  return share * (colour.asDiagonal() * sum * colour.asDiagonal());
}

double effective_samples(const VectorXd& e, const std::vector<RowRange>& runs) {
  const double n = static_cast<double>(e.size()), zero = lagged_product(e, runs, 0);
  if (!(zero > 0.0)) return n;
  const double width = bandwidth(e, runs, lags_to_look_at(e.size(), 4.0));
  double rows_for_one = 1.0;
  for (Index k = 1; k <= static_cast<Index>(width); ++k)
    rows_for_one += 2.0 * bartlett(k, width) * lagged_product(e, runs, k) / zero;
  return std::clamp(n / std::max(rows_for_one, 1.0 / n), 1.0, n);
}

}  // namespace swayaw::identification::detail
