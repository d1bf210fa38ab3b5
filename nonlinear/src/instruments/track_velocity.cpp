#include "track_velocity.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "swayaw/core/detail/matrices.hpp"

namespace swayaw::inline nonlinear::detail {
namespace {

/// ∫ cos ψ, ∫ sin ψ, ∫ t cos ψ, ∫ t sin ψ over time, t from a given time on.
using HeadingIntegrals = Eigen::Vector4d;

/// Simpson's rule over one interval between samples.
HeadingIntegrals integrals(const Interpolant& psi, double origin, double from, double to) {
  const auto at = [&](double time) {
    const double c = std::cos(psi(time)), s = std::sin(psi(time)), t = time - origin;
    return HeadingIntegrals(c, s, t * c, t * s);
  };
  return (to - from) / 6.0 * (at(from) + 4.0 * at(0.5 * (from + to)) + at(to));
}

/// Times at which both coordinates are known.
struct Fixes {
  std::vector<double> time, x, y;
};

Fixes fixes_between(const Recording& run, double from, double to) {
  Fixes fixes;
  const auto x = run[Channel::x], y = run[Channel::y];
  auto i = static_cast<std::size_t>(std::ranges::lower_bound(run.time, from) - run.time.begin());
  for (; i < run.samples() && run.time[i] <= to; ++i) {
    if (!std::isfinite(x[i] + y[i])) continue;
    fixes.time.push_back(run.time[i]);
    fixes.x.push_back(x[i]);
    fixes.y.push_back(y[i]);
  }
  return fixes;
}

/// Coefficients of x_0, y_0, u, v, u̇, v̇ in x and in y.
using Rows = Eigen::Matrix<double, 2, 6>;

Rows rows_of(const HeadingIntegrals& i) {
  Rows rows;
  rows << 1.0, 0.0, i[0], -i[1], i[2], -i[3],  //
      0.0, 1.0, i[1], i[0], i[3], i[2];
  return rows;
}

}  // namespace

std::optional<SurgeSway> velocity_from_track(const Recording& run, const Current<double>& current, double time,
                                             double from, double to, int degree) {
  if (!run.has(Channel::x) || !run.has(Channel::y)) return std::nullopt;
  const auto fixes = fixes_between(run, from, to);
  const auto count = static_cast<int>(fixes.time.size());
  if (count < 2) return std::nullopt;
  const Interpolant psi(run, Channel::psi);
  const Eigen::Vector2d drift(current.speed * std::cos(current.to), current.speed * std::sin(current.to));
  const double scale = std::max(to - from, 1e-9);  // of u̇ and v̇, for a well-scaled matrix
  Eigen::Matrix<double, 6, 6> A = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Vector<double, 6> b = Eigen::Vector<double, 6>::Zero();
  HeadingIntegrals way = integrals(psi, time, time, fixes.time.front());
  for (std::size_t i = 0; i < fixes.time.size(); ++i) {
    if (i > 0) way += integrals(psi, time, fixes.time[i - 1], fixes.time[i]);
    Rows rows = rows_of(way);
    rows.rightCols<2>() /= scale;
    const Eigen::Vector2d place(fixes.x[i] - fixes.x[0], fixes.y[i] - fixes.y[0]);
    A += rows.transpose() * rows;
    b += rows.transpose() * (place - drift * (fixes.time[i] - time));
  }
  const int unknowns = 2 + 2 * std::min(degree, std::max(1, count - 2));
  const Eigen::VectorXd c = core::detail::solve(A.topLeftCorner(unknowns, unknowns), b.head(unknowns));
  return SurgeSway{c[2], c[3]};
}

}  // namespace swayaw::nonlinear::detail
