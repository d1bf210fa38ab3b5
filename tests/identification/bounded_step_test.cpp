#include "estimation/bounded_step.hpp"

#include <algorithm>
#include <catch.hpp>
#include <cmath>
#include <random>
#include <utility>

namespace swayaw {
using namespace identification::detail;

namespace {

struct Problem {
  Eigen::MatrixXd H;
  Eigen::VectorXd g, low, high;
};

/// A curvature of any rank and of very different sizes; every fourth place may not move.
Problem random_problem(std::mt19937& generator) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> power(-2.0, 2.0), wall(0.0, 2.0);
  const auto n = std::uniform_int_distribution<Eigen::Index>(1, 20)(generator),
             rank = std::uniform_int_distribution<Eigen::Index>(1, n)(generator);
  Eigen::MatrixXd J(rank, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const double size = std::pow(10.0, power(generator));
    for (Eigen::Index i = 0; i < rank; ++i) J(i, k) = size * normal(generator);
  }
  Problem p{J.transpose() * J, Eigen::VectorXd(n), Eigen::VectorXd(n), Eigen::VectorXd(n)};
  const Eigen::VectorXd e = Eigen::VectorXd::NullaryExpr(rank, [&] { return normal(generator); });
  p.g = J.transpose() * e;
  for (Eigen::Index k = 0; k < n; ++k) {
    p.low[k] = -wall(generator), p.high[k] = wall(generator);
    if (generator() % 4 == 0) p.low[k] = p.high[k] = 0.0;
  }
  return p;
}

/// By how much the conditions of Karush, Kuhn and Tucker are missed, over the largest slope at the start: where nothing
/// holds a place its slope is zero, and a bound only holds what pushes against it. The radius pulls by `mu` d.
double missed(const Problem& p, const Eigen::VectorXd& d, double mu) {
  const Eigen::VectorXd slope = p.g + p.H * d + mu * d;
  double most = 0.0;
  for (Eigen::Index k = 0; k < d.size(); ++k) {
    if (p.low[k] == p.high[k]) continue;
    const bool at_low = d[k] <= p.low[k], at_high = d[k] >= p.high[k];
    most = std::max(most, at_low ? -slope[k] : at_high ? slope[k] : std::abs(slope[k]));
  }
  return most / p.g.cwiseAbs().maxCoeff();
}

/// What the radius pulls by: what is left of the slope of the places that nothing else holds.
double pull_of_radius(const Problem& p, const Eigen::VectorXd& d) {
  const Eigen::VectorXd slope = p.g + p.H * d;
  double sum = 0.0, squares = 0.0;
  for (Eigen::Index k = 0; k < d.size(); ++k)
    if (p.low[k] < d[k] && d[k] < p.high[k]) sum -= slope[k] * d[k], squares += d[k] * d[k];
  return squares > 0.0 ? sum / squares : 0.0;
}

}  // namespace

TEST_CASE("a bounded step is the least within bounds and radius", "[identification]") {
  std::mt19937 generator(17);
  int cut = 0;
  for (int i = 0; i < 500; ++i) {
    const auto p = random_problem(generator);
    if (!(p.g.cwiseAbs().maxCoeff() > 0.0)) continue;
    const auto farthest = bounded_step(p.H, p.g, p.low, p.high, 1e6);
    const double radius = std::uniform_real_distribution<double>(0.05, 1.5)(generator) * farthest.norm();
    if (!(radius > 1e-6)) continue;
    const auto d = bounded_step(p.H, p.g, p.low, p.high, radius);
    CAPTURE(i, d.size(), radius, farthest.norm());
    CHECK(missed(p, farthest, 0.0) < 1e-6);
    CHECK((d.array() >= p.low.array()).all());
    CHECK((d.array() <= p.high.array()).all());
    CHECK(d.norm() <= radius * (1.0 + 1e-12));
    if (farthest.norm() <= radius) {
      CHECK((d - farthest).norm() <= 1e-6 * farthest.norm());
      continue;
    }
    ++cut;
    const double mu = pull_of_radius(p, d);
    CHECK(mu >= -1e-6);
    CHECK(missed(p, d, std::max(0.0, mu)) < 1e-6);
    CHECK(d.norm() >= 0.99 * radius);  // a step that is cut need not come nearer
  }
  CHECK(cut > 200);
}

TEST_CASE("a step where slopes are no numbers ends and gains nothing", "[identification]") {
  Eigen::MatrixXd H = Eigen::MatrixXd::Identity(2, 2);
  const Eigen::VectorXd g = Eigen::VectorXd::Ones(2), wall = Eigen::VectorXd::Ones(2);
  for (const auto& [i, k] : {std::pair{0, 0}, {1, 0}, {1, 1}}) {
    H(i, k) = H(k, i) = NAN;
    const auto d = bounded_step(H, g, -wall, wall, 0.5);
    CHECK_FALSE(-d.dot(2.0 * g + H * d) > 0.0);
  }
}

}  // namespace swayaw
