#include "swayaw/nonlinear/surroundings/periodic_curve.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace swayaw::inline nonlinear {
namespace {

using Column = std::vector<double>;

/// lower_i x_(i−1) + diagonal_i x_i + upper_i x_(i+1) = right_i, diagonally dominant.
struct Tridiagonal {
  Column lower, diagonal, upper;
};

/// Thomas algorithm; lower_0 and upper_(n−1) are not read.
Column solved(Tridiagonal m, Column right) {
  const std::size_t n = right.size();
  for (std::size_t i = 1; i < n; ++i) {
    const double factor = m.lower[i] / m.diagonal[i - 1];
    m.diagonal[i] -= factor * m.upper[i - 1];
    right[i] -= factor * right[i - 1];
  }
  right[n - 1] /= m.diagonal[n - 1];
  for (std::size_t i = n - 1; i-- > 0;) right[i] = (right[i] - m.upper[i] * right[i + 1]) / m.diagonal[i];
  return right;
}

/// The same with indices modulo n: lower_0 multiplies x_(n−1), upper_(n−1) multiplies x_0.
///
/// The corners are taken out as a product p qᵀ, A = T + p qᵀ, and by Sherman and Morrison
///
///     x = y − z (q·y)/(1 + q·z),   T y = right,   T z = p
Column solved_cyclic(Tridiagonal m, const Column& right) {
  const std::size_t last = right.size() - 1;
  const double pivot = -m.diagonal[0];
  const double corner = m.lower[0] / pivot;  // q = (1, 0, …, 0, corner)
  Column p(right.size(), 0.0);
  p[0] = pivot;
  p[last] = m.upper[last];
  m.diagonal[0] -= pivot;
  m.diagonal[last] -= corner * m.upper[last];
  Column y = solved(m, right);
  const Column z = solved(m, p);
  const double scale = (y[0] + corner * y[last]) / (1.0 + z[0] + corner * z[last]);
  for (std::size_t i = 0; i <= last; ++i) y[i] -= scale * z[i];
  return y;
}

void require_nodes(std::span<const double> angle, std::size_t values) {
  if (angle.size() != values)
    throw std::domain_error(
        fmt::format("a curve needs one value for each angle, got {} values and {} angles", values, angle.size()));
  if (angle.size() < 3)
    throw std::domain_error(fmt::format("a periodic curve needs three different angles, got {}", angle.size()));
  const bool increase = std::ranges::adjacent_find(angle, [](double a, double b) { return !(a < b); }) == angle.end();
  if (!increase || !(angle.front() >= -pi) || !(angle.back() < pi))
    throw std::domain_error("angles of a periodic curve must increase in [-pi, pi)");
}

}  // namespace

PeriodicSpline periodic_spline(std::span<const double> angle, std::span<const double> value) {
  require_nodes(angle, value.size());
  const std::size_t n = angle.size();
  const auto next = [n](std::size_t i) { return (i + 1) % n; };
  Column h(n), slope(n);  // from node i to the next
  for (std::size_t i = 0; i < n; ++i) {
    h[i] = angle[next(i)] - angle[i] + (i + 1 == n ? 2.0 * pi : 0.0);
    slope[i] = (value[next(i)] - value[i]) / h[i];
  }
  Tridiagonal m{Column(n), Column(n), h};
  Column right(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t before = (i + n - 1) % n;
    m.lower[i] = h[before];
    m.diagonal[i] = 2.0 * (h[before] + h[i]);
    right[i] = 6.0 * (slope[i] - slope[before]);
  }
  const Column M = solved_cyclic(m, right);
  PeriodicSpline spline;
  for (std::size_t i = 0; i < n; ++i) {
    // f_i + t ((f_(i+1) − f_i)/h − h (2 M_i + M_(i+1))/6) + t² M_i/2 + t³ (M_(i+1) − M_i)/(6h)
    const double M_0 = M[i], M_1 = M[next(i)];
    spline.pieces.push_back(
        {angle[i], {value[i], slope[i] - h[i] * (2.0 * M_0 + M_1) / 6.0, 0.5 * M_0, (M_1 - M_0) / (6.0 * h[i])}});
  }
  return spline;
}

}  // namespace swayaw::nonlinear
