#include <Eigen/Core>
#include <Eigen/SVD>
#include <array>
#include <cmath>
#include <limits>

#include "swayaw/core/dual.hpp"
#include "swayaw/linear/indices.hpp"

namespace swayaw {

double condition_number(const SwayYawCoefficients<double>& m) {
  using D = Dual<6>;
  // derivatives by the logarithms of the coefficients
  const auto variable = [](double value, int i) {
    D x(value);
    x.v[i] = value;
    return x;
  };
  const SwayYawCoefficients<D> input{variable(m.a1, 0), variable(m.b1, 1), variable(m.c1, 2), variable(m.a2, 3), variable(m.b2, 4), variable(m.c2, 5)};
  const auto i = steering_indices(input);
  const std::array output{i.T1T2, i.T1_plus_T2, i.T3b, i.T3w, i.Kb, i.Kw};
  Eigen::Matrix<double, 6, 6> jacobian;
  for (int row = 0; row < 6; ++row) jacobian.row(row) = output[static_cast<std::size_t>(row)].v.transpose() / output[static_cast<std::size_t>(row)].a;
  if (!jacobian.allFinite()) return std::numeric_limits<double>::infinity();
  const auto singular = jacobian.jacobiSvd().singularValues();
  return singular[5] > 0.0 ? singular[0] / singular[5] : std::numeric_limits<double>::infinity();
}

}  // namespace swayaw
