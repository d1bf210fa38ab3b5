#include "fleet/linear_gaussian.hpp"

#include <Eigen/Cholesky>
#include <catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

/// Normal laws joined and eliminated in closed form.
namespace swayaw {
using namespace mismatch::detail;

namespace {

Eigen::MatrixXd random_matrix(Eigen::Index rows, Eigen::Index columns, std::mt19937_64& engine) {
  std::normal_distribution<double> normal;
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(engine); });
}

/// Of fewer measurements than coordinates.
Told random_told(Eigen::Index size, std::mt19937_64& engine) {
  const auto J = random_matrix(size - 1, size, engine);
  return {J.transpose() * J, J.transpose() * random_matrix(size - 1, 1, engine), 0.3};
}

Eigen::MatrixXd beside(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  Eigen::MatrixXd joined(a.rows(), a.cols() + b.cols());
  joined << a, b;
  return joined;
}

}  // namespace

TEST_CASE("what is eliminated first and what is left give the evidence of both together", "[mismatch][second-route]") {
  std::mt19937_64 engine(GENERATE(1u, 2u, 3u));
  const auto told = random_told(5, engine);
  const auto first = random_matrix(5, 3, engine), second = random_matrix(5, 2, engine);
  const Eigen::VectorXd mean = random_matrix(5, 1, engine);
  const auto apart = posterior(blurred(told, first), mean, second),
             together = posterior(told, mean, beside(first, second));
  CHECK(apart.log_evidence == Approx(together.log_evidence).epsilon(1e-10));
}

TEST_CASE("two blurs are one whose covariance is the sum", "[mismatch][second-route]") {
  std::mt19937_64 engine(4);
  const auto told = random_told(4, engine);
  const auto first = random_matrix(4, 4, engine), second = random_matrix(4, 4, engine);
  const Eigen::MatrixXd sum = first * first.transpose() + second * second.transpose();
  const Eigen::MatrixXd root = sum.llt().matrixL();
  const auto twice = blurred(blurred(told, first), second), once = blurred(told, root);
  CHECK((twice.A - once.A).norm() < 1e-9 * once.A.norm());
  CHECK((twice.b - once.b).norm() < 1e-9 * once.b.norm());
  CHECK(twice.c == Approx(once.c).epsilon(1e-9));
}

TEST_CASE("no blur changes nothing, an endless one leaves nothing", "[mismatch][limit]") {
  std::mt19937_64 engine(5);
  const auto told = random_told(4, engine);
  const auto same = blurred(told, Eigen::MatrixXd::Zero(4, 4));
  CHECK(same.A == told.A);
  CHECK(same.b == told.b);
  CHECK(same.c == told.c);
  CHECK(blurred(told, 1e3 * Eigen::MatrixXd::Identity(4, 4)).A.norm() < 1e-5);
}

TEST_CASE("the posterior of one number is that of quadrature", "[mismatch][second-route]") {
  const double A = 2.5, b = -1.2, m = 0.4, sd = 0.7;
  const auto law = posterior({Eigen::MatrixXd::Constant(1, 1, A), Eigen::VectorXd::Constant(1, b), 0.1},
                             Eigen::VectorXd::Constant(1, m), Eigen::MatrixXd::Constant(1, 1, sd));
  double sum = 0.0, first = 0.0, second = 0.0;
  constexpr double step = 1e-3;
  for (double x = -8.0; x < 8.0; x += step) {
    const double n = (x - m) / sd;
    const double density =
        std::exp(-0.5 * A * x * x + b * x + 0.1 - 0.5 * n * n) / (sd * std::sqrt(2.0 * std::numbers::pi)) * step;
    sum += density, first += x * density, second += x * x * density;
  }
  CHECK(law.log_evidence == Approx(std::log(sum)).epsilon(1e-9));
  CHECK(law.mean[0] == Approx(first / sum).epsilon(1e-9));
  CHECK(law.covariance(0, 0) == Approx(second / sum - std::pow(first / sum, 2)).epsilon(1e-9));
}

TEST_CASE("what is told of x tells y through any matrix", "[mismatch][limit]") {
  std::mt19937_64 engine(6);
  const auto told = random_told(4, engine);
  const auto G = random_matrix(4, 3, engine);
  const Eigen::VectorXd y = random_matrix(3, 1, engine), x = G * y;
  const auto of_y = told.of(G);
  const auto value = [](const Told& t, const Eigen::VectorXd& at) {
    return -0.5 * at.dot(t.A * at) + t.b.dot(at) + t.c;
  };
  CHECK(value(of_y, y) == Approx(value(told, x)).epsilon(1e-12));
}

}  // namespace swayaw
