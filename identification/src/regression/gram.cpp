#include "gram.hpp"

#include <vector>

#include "gram_kernel.hpp"
#include "swayaw/linear/batch.hpp"

namespace swayaw::inline identification::detail {
namespace {

gram::GramKernel best_kernel() {
#ifdef SWAYAW_X86_KERNELS
  if (available(InstructionSet::avx512)) return gram::avx512_gram();
  if (available(InstructionSet::avx2)) return gram::avx2_gram();
#endif
  return gram::baseline_gram();
}

}  // namespace

Eigen::MatrixXd gram_of(const Eigen::MatrixXd& X, const Eigen::VectorXd& y) {
  static const auto kernel = best_kernel();
  const Eigen::Index n = X.rows(), p = X.cols();
  const Eigen::Index packed = kernel ? n - n % static_cast<Eigen::Index>(gram::widest) : 0, rest = n - packed;
  Eigen::MatrixXd products = Eigen::MatrixXd::Zero(p + 1, p + 1);
  if (packed > 0) {
    std::vector<const double*> columns;
    for (Eigen::Index j = 0; j < p; ++j) columns.push_back(X.col(j).data());
    columns.push_back(y.data());
    kernel({columns.data(), columns.size(), static_cast<std::size_t>(packed), products.data()});
  }
  products.topLeftCorner(p, p).triangularView<Eigen::Lower>() += X.bottomRows(rest).transpose() * X.bottomRows(rest);
  products.row(p).head(p) += y.tail(rest).transpose() * X.bottomRows(rest);
  products(p, p) += y.tail(rest).squaredNorm();
  products.triangularView<Eigen::StrictlyUpper>() = products.transpose();
  return products;
}

}  // namespace swayaw::identification::detail
