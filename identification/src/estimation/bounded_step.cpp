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

/// A step, and which of its places are held at a bound.
struct Held {
  Vector d;
  std::vector<bool> held;
};

/// Active-set method from a step that keeps to the bounds: on the way to the least over the free places, the first that
/// meets its bound is held.
Held between_bounds(const Matrix& H, const Vector& g, const Vector& low, const Vector& high, Held from) {
  auto& [d, held] = from;
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
  d = d.cwiseMax(low).cwiseMin(high);
  return from;
}

}  // namespace

Vector bounded_step(const Matrix& H, const Vector& g, const Vector& low, const Vector& high, double radius) {
  const auto identity = Matrix::Identity(H.rows(), H.cols());
  const double largest = H.diagonal().maxCoeff();
  const Held at_rest{Vector::Zero(g.size()), std::vector<bool>(static_cast<std::size_t>(g.size()), false)};
  // each damping begins where the last ended: few places are held or released between two
  Held now = at_rest;
  const auto is_within = [&](double mu) {
    if (!now.d.allFinite()) now = at_rest;
    now = between_bounds(H + mu * identity, g, low, high, std::move(now));
    return !(now.d.norm() > radius);
  };
  double above = 1e-12 * largest, below = above;
  if (is_within(above)) return now.d;
  do below = above, above *= 100.0;
  while (!is_within(above) && above < HUGE_VAL);  // it ends where slopes are no numbers, too
  Vector d = now.d;
  for (int i = 0; i < 40 && d.norm() < at_the_edge * radius; ++i) {
    const double mu = std::sqrt(below * above);
    if (is_within(mu)) above = mu, d = now.d;
    else below = mu;
  }
  return d;
}

}  // namespace swayaw::identification::detail
