#include "bounded_step.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <vector>

namespace swayaw {
namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

/// The least of the quadratic over the free places, the others held.
Vector over_free(const Matrix& H, const Vector& g, const Vector& held, const std::vector<Eigen::Index>& free) {
  Vector d = held;
  if (free.empty()) return d;
  for (const auto i : free) d[i] = 0.0;
  const Vector slope = g + H * d;
  d(free) = -H(free, free).ldlt().solve(Vector(slope(free)));
  return d;
}

/// How far one may go from `from` towards `to` between the bounds, and which place stops one; -1 for none.
struct Stop {
  double share;
  Eigen::Index place;
};

Stop stop_on_way(const Vector& from, const Vector& to, const Vector& low, const Vector& high) {
  Stop stop{1.0, -1};
  for (Eigen::Index i = 0; i < from.size(); ++i) {
    const double change = to[i] - from[i];
    const double wall = change > 0.0 ? high[i] : low[i];
    if (change == 0.0 || (to[i] - wall) * change <= 0.0) continue;
    const double share = (wall - from[i]) / change;
    if (share < stop.share) stop = {share, i};
  }
  return stop;
}

/// The held place that the slope pulls inwards most; -1 for none.
Eigen::Index to_release(const Vector& slope, const Vector& d, const Vector& low, const Vector& high,
                        const std::vector<bool>& is_free) {
  Eigen::Index worst = -1;
  double strongest = 1e-12 * slope.cwiseAbs().maxCoeff();
  for (Eigen::Index i = 0; i < d.size(); ++i) {
    if (is_free[static_cast<std::size_t>(i)] || low[i] == high[i]) continue;
    const double pull = d[i] >= high[i] ? slope[i] : -slope[i];
    if (pull > strongest) strongest = pull, worst = i;
  }
  return worst;
}

/// Active-set method from d = 0.
Vector between_bounds(const Matrix& H, const Vector& g, const Vector& low, const Vector& high) {
  Vector d = Vector::Zero(g.size());
  std::vector<bool> is_free(static_cast<std::size_t>(g.size()), true);
  for (int change = 0; change < 20 * static_cast<int>(g.size()); ++change) {
    std::vector<Eigen::Index> free;
    for (Eigen::Index i = 0; i < g.size(); ++i)
      if (is_free[static_cast<std::size_t>(i)]) free.push_back(i);
    const Vector target = over_free(H, g, d, free);
    const Stop stop = stop_on_way(d, target, low, high);
    d += stop.share * (target - d);
    if (stop.place >= 0) {
      is_free[static_cast<std::size_t>(stop.place)] = false;
      d[stop.place] = target[stop.place] > d[stop.place] ? high[stop.place] : low[stop.place];
      continue;
    }
    const auto released = to_release(g + H * d, d, low, high, is_free);
    if (released < 0) break;
    is_free[static_cast<std::size_t>(released)] = true;
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
  for (int i = 0; i < 40; ++i) {
    const double mu = std::sqrt(below * above);
    const Vector at = damped(mu);
    (at.norm() > radius ? below : above) = mu;
    if (at.norm() <= radius) d = at;
  }
  return d;
}

}  // namespace swayaw
