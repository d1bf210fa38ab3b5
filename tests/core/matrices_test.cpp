#include "swayaw/core/detail/matrices.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace swayaw;
using namespace swayaw::core::detail;

// On other blocks of sums, as large as the caches of another machine, a diagnosis may end in another valley.
TEST_CASE("products of matrices are summed in the same order on every machine", "[matrices]") {
  constexpr std::ptrdiff_t KiB = 1024;
  CHECK(Eigen::l1CacheSize() == 32 * KiB);
  CHECK(Eigen::l2CacheSize() == 1024 * KiB);
  CHECK(Eigen::l3CacheSize() == 32 * 1024 * KiB);

  const Eigen::MatrixXd A = Eigen::MatrixXd::NullaryExpr(
      3001, 83, [](Eigen::Index i, Eigen::Index k) { return std::sin(static_cast<double>(7 * i + 11 * k)); });
  const Eigen::MatrixXd information = gram(A);
  for (const Eigen::Index i : {0, 40, 82})
    for (const Eigen::Index k : {0, 41, 82}) CHECK(information(i, k) == Approx(A.col(i).dot(A.col(k))).margin(1e-9));
  CHECK((information - information.transpose()).isZero(0.0));
}
