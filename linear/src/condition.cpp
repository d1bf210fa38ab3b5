#include <Eigen/Core>
#include <array>
#include <cmath>
#include <limits>

#include "by_logarithm.hpp"
#include "swayaw/core/detail/matrices.hpp"
#include "swayaw/linear/indices.hpp"

namespace swayaw::inline linear {
using namespace detail;

double condition_number(const SwayYawCoefficients<double>& m) {
  const auto i = steering_indices(by_logarithms<6>(m));
  const std::array output{i.T1T2, i.T1_plus_T2, i.T3b, i.T3w, i.Kb, i.Kw};
  Eigen::Matrix<double, 6, 6> jacobian;
  for (int row = 0; row < 6; ++row)
    jacobian.row(row) = output[static_cast<std::size_t>(row)].v.transpose() / output[static_cast<std::size_t>(row)].a;
  if (!jacobian.allFinite()) return std::numeric_limits<double>::infinity();
  const auto singular = core::detail::singular_values(jacobian).size;
  return singular[5] > 0.0 ? singular[0] / singular[5] : std::numeric_limits<double>::infinity();
}

}  // namespace swayaw::linear
