#include "bounded_step.hpp"

#include <cmath>
#include <vector>

#include "swayaw/core/detail/matrices.hpp"

namespace swayaw::inline identification::detail {
namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

constexpr double at_the_edge = 0.99;  ///< of the radius: a step that is cut by it need not come nearer

/// The held place that the slope pulls inwards most; −1 for none.
Eigen::Index to_release(const Vector& slope, const Vector& d, const Vector& low, const Vector& high,
                        const std::vector<bool>& held) {
  Eigen::Index worst = -1;
  double strongest = 1e-12 * slope.cwiseAbs().maxCoeff();
  for (Eigen::Index i = 0; i < d.size(); ++i) {
    if (!held[static_cast<std::size_t>(i)] || low[i] == high[i]) continue;
    const double pull = d[i] >= high[i] ? slope[i] : -slope[i];
    if (pull > strongest) strongest = pull, worst = i;
  }
  return worst;
}

/// Active-set method from d = 0: on the way to the least over the free places, the first that meets its bound is held.
Vector between_bounds(const Matrix& H, const Vector& g, const Vector& low, const Vector& high) {
  Vector d = Vector::Zero(g.size());
  std::vector<bool> held(static_cast<std::size_t>(g.size()), false);
  for (int change = 0; change < 20 * static_cast<int>(g.size()); ++change) {
    std::vector<Eigen::Index> free;
    for (Eigen::Index i = 0; i < g.size(); ++i)
      if (!held[static_cast<std::size_t>(i)]) free.push_back(i);
    const Vector slope = g + H * d;
    Vector way = Vector::Zero(g.size());
    if (!free.empty()) way(free) = -core::detail::solve_symmetric(H(free, free), slope(free));
    double share = 1.0;
    Eigen::Index stop = -1;
    for (const auto i : free)
      if (const double wall = way[i] > 0.0 ? high[i] : low[i]; (d[i] + way[i] - wall) * way[i] > 0.0)
        if (const double here = (wall - d[i]) / way[i]; here < share) share = here, stop = i;
    d += share * way;
    if (stop < 0) stop = to_release(g + H * d, d, low, high, held);
    else d[stop] = way[stop] > 0.0 ? high[stop] : low[stop];
    if (stop < 0) break;
    held[static_cast<std::size_t>(stop)] = !held[static_cast<std::size_t>(stop)];
  }
  return d.cwiseMax(low).cwiseMin(high);
}

}  // namespace

Vector bounded_step(const Matrix& H, const Vector& g, const Vector& low, const Vector& high, double radius) {
  const auto identity = Matrix::Identity(H.rows(), H.cols());
  const double largest = H.diagonal().maxCoeff();
  const auto damped = [&](double mu) { return between_bounds(H + mu * identity, g, low, high); };
  double below = 1e-12 * largest;
  Vector d = damped(below);
  if (d.norm() <= radius) return d;
  double above = below;
  while ((d = damped(above)).norm() > radius) above *= 100.0;
  for (int i = 0; i < 40 && d.norm() < at_the_edge * radius; ++i) {
    const double mu = std::sqrt(below * above);
    Vector at = damped(mu);
    const bool within = at.norm() <= radius;
    (within ? above : below) = mu;
    if (within) d = std::move(at);
  }
  return d;
}

}  // namespace swayaw::identification::detail
