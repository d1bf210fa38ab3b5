#include "linear_start.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "swayaw/core/detail/matrices.hpp"

namespace swayaw::inline identification::detail {
namespace {

constexpr double grid_step = 0.05;  // ship lengths

/// Drift, yaw rate and rudder on a uniform grid.
struct GridPoint {
  double beta, omega, delta;
};

struct KnownPoints {
  std::vector<double> s, value;

  double operator()(double at) const {
    if (s.empty()) return 0.0;
    const auto after = static_cast<std::size_t>(std::ranges::upper_bound(s, at) - s.begin());
    if (after == 0) return value.front();
    if (after == s.size()) return value.back();
    return value[after - 1] + (value[after] - value[after - 1]) * (at - s[after - 1]) / (s[after] - s[after - 1]);
  }
};

template <class Value>
KnownPoints known_points(const LinearRun& run, Value&& value) {
  KnownPoints result;
  for (const auto& sample : run) {
    const double now = value(sample);
    if (std::isnan(now)) continue;
    result.s.push_back(sample.s);
    result.value.push_back(now);
  }
  return result;
}

/// omega' = d(psi)/ds' between successive samples.
KnownPoints slope_of_heading(const LinearRun& run) {
  const auto psi = known_points(run, [](const LinearSample& x) { return x.psi; });
  KnownPoints slope;
  for (std::size_t i = 1; i < psi.s.size(); ++i) {
    slope.s.push_back(0.5 * (psi.s[i] + psi.s[i - 1]));
    slope.value.push_back((psi.value[i] - psi.value[i - 1]) / (psi.s[i] - psi.s[i - 1]));
  }
  return slope;
}

std::vector<GridPoint> on_grid(const LinearRun& run) {
  const auto beta = known_points(run, [](const LinearSample& x) { return x.beta; });
  const auto delta = known_points(run, [](const LinearSample& x) { return x.delta; });
  auto omega = known_points(run, [](const LinearSample& x) { return x.r / x.rate; });
  if (omega.s.empty()) omega = slope_of_heading(run);
  std::vector<GridPoint> grid;
  for (double s = 0.0; s <= run.back().s; s += grid_step) grid.push_back({beta(s), omega(s), delta(s)});
  return grid;
}

/// ∫ φ^(k) x ds over a piece, k = 0, 1, 2, for each quantity and for 1.
struct PieceIntegrals {
  std::array<double, 3> beta{}, omega{}, delta{};
  double one = 0.0;
};

PieceIntegrals integrals(std::span<const GridPoint> piece) {
  PieceIntegrals sum;
  const double n = static_cast<double>(piece.size() - 1), width = n * grid_step;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const double tau = static_cast<double>(i) / n, p = tau * (1.0 - tau), dp = 1.0 - 2.0 * tau;
    // φ = p³, φ' = 3 p² p', φ'' = 6 p p'² + 3 p² p'', p'' = −2
    const std::array<double, 3> phi{p * p * p, 3.0 * p * p * dp / width,
                                    (6.0 * p * dp * dp - 6.0 * p * p) / (width * width)};
    for (std::size_t k = 0; k < 3; ++k) {
      sum.beta[k] += phi[k] * piece[i].beta;
      sum.omega[k] += phi[k] * piece[i].omega;
      sum.delta[k] += phi[k] * piece[i].delta;
    }
    sum.one += phi[0];
  }
  return sum;
}

std::vector<PieceIntegrals> pieces(const std::vector<LinearRun>& runs, double width) {
  std::vector<PieceIntegrals> result;
  for (const auto& run : runs) {
    const auto grid = on_grid(run);
    const auto points = std::min(grid.size(), static_cast<std::size_t>(width / grid_step) + 1);
    const auto stride = std::max<std::size_t>(1, points / 10);
    for (std::size_t first = 0; first + points <= grid.size(); first += stride)
      result.push_back(integrals(std::span(grid).subspan(first, points)));
  }
  return result;
}

template <int N>
Eigen::Matrix<double, N, 1> regressed(const std::vector<std::pair<Eigen::Matrix<double, N, 1>, double>>& equations) {
  Eigen::MatrixXd A(equations.size(), N);
  Eigen::VectorXd b(equations.size());
  for (std::size_t i = 0; i < equations.size(); ++i) {
    A.row(static_cast<Eigen::Index>(i)) = equations[i].first.transpose();
    b[static_cast<Eigen::Index>(i)] = equations[i].second;
  }
  return core::detail::least_squares(A, b);
}

}  // namespace

SwayYawCoefficients<double> regressed_coefficients(const std::vector<LinearRun>& runs, double width) {
  std::vector<std::pair<Eigen::Vector4d, double>> drift, yaw;
  for (const auto& p : pieces(runs, width)) {
    const Eigen::Vector4d known(p.beta[0], p.omega[0], p.delta[0], p.one);
    drift.emplace_back(known, -p.beta[1]);
    yaw.emplace_back(known, -p.omega[1]);
  }
  const auto first = regressed<4>(drift), second = regressed<4>(yaw);
  return {first[0], first[1], first[2], second[0], second[1], second[2]};
}

SwayYawTransfer<double> regressed_yaw(const std::vector<LinearRun>& runs, double width) {
  // ∫φ'' omega = e1 ∫φ' omega − e0 ∫φ omega − nw1 ∫φ' delta + nw0 ∫φ delta + k ∫φ
  std::vector<std::pair<Eigen::Matrix<double, 5, 1>, double>> equations;
  for (const auto& p : pieces(runs, width))
    equations.emplace_back(Eigen::Matrix<double, 5, 1>{-p.omega[0], p.omega[1], p.delta[0], -p.delta[1], p.one},
                           p.omega[2]);
  const auto x = regressed<5>(equations);
  return {.e0 = x[0], .e1 = x[1], .nb0 = 0.0, .nb1 = 0.0, .nw0 = x[2], .nw1 = x[3]};
}

double noise_of(const std::vector<LinearRun>& runs, double LinearSample::*channel) {
  double largest = 0.0;
  for (const auto& run : runs)
    largest =
        std::max(largest, white_noise_of(known_points(run, [&](const LinearSample& x) { return x.*channel; }).value));
  return largest;
}

}  // namespace swayaw::identification::detail
