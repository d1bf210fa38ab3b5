#pragma once

#include <Eigen/Core>
#include <random>
#include <string>

#include "swayaw/identification/regression.hpp"

/// Seeded regressions with known truth.
namespace swayaw::test {

struct KnownDesign {
  Design design;
  Eigen::VectorXd truth;
};

class RandomDesigns {
 public:
  explicit RandomDesigns(unsigned seed) : engine_(seed) {}

  double normal() { return normal_(engine_); }
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }

  Eigen::VectorXd normals(Eigen::Index n) {
    return Eigen::VectorXd::NullaryExpr(n, [&] { return normal(); });
  }

  /// e_t = phi e_{t−1} + white noise, of variance 1, from its stationary start.
  Eigen::VectorXd correlated(Eigen::Index n, double phi) {
    Eigen::VectorXd e = normals(n);
    for (Eigen::Index t = 1; t < n; ++t) e[t] = phi * e[t - 1] + std::sqrt(1.0 - phi * phi) * e[t];
    return e;
  }

  /// Columns of sizes over six decades, correlated with each other and in time, without noise.
  KnownDesign design(Eigen::Index n, Eigen::Index p) {
    KnownDesign known;
    Design& d = known.design;
    d.X = Eigen::MatrixXd(n, p);
    for (Eigen::Index j = 0; j < p; ++j) {
      d.names.emplace_back("b").append(std::to_string(j));
      d.X.col(j) = correlated(n, 0.7);
      if (j > 0) d.X.col(j) += 0.5 * d.X.col(j - 1);
    }
    known.truth = normals(p);
    d.y = d.X * known.truth;
    for (Eigen::Index j = 0; j < p; ++j) {
      const double size = std::pow(10.0, uniform(-3.0, 3.0));
      d.X.col(j) *= size;
      known.truth[j] /= size;
    }
    return known;
  }

 private:
  std::mt19937_64 engine_;
  std::normal_distribution<double> normal_;
};

/// The estimates as a vector.
inline Eigen::VectorXd values(const Regression& fit) {
  Eigen::VectorXd b(static_cast<Eigen::Index>(fit.coefficients.size()));
  for (Eigen::Index j = 0; j < b.size(); ++j) b[j] = fit.coefficients[static_cast<std::size_t>(j)].estimate.value;
  return b;
}

/// Largest difference of the coefficients, each as a share of itself.
inline double difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return ((a - b).array() / b.array()).abs().maxCoeff();
}

/// Share of intervals that hold the truth, over many noises.
class Coverage {
 public:
  void add(const Regression& fit, const Eigen::VectorXd& truth) {
    for (Eigen::Index j = 0; j < truth.size(); ++j, ++intervals_) {
      const auto& c = fit.coefficients[static_cast<std::size_t>(j)];
      inside_ += c.low <= truth[j] && truth[j] <= c.high;
    }
  }
  double share() const { return static_cast<double>(inside_) / intervals_; }

 private:
  int inside_ = 0, intervals_ = 0;
};

}  // namespace swayaw::test
