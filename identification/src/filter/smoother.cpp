#include "measurement_update.hpp"

namespace swayaw::inline identification::detail {

template <int N>
void Smoother<N>::step_back(const Transition<N>& t) {
  const Eigen::Matrix<double, 6, N - 2> B = t.B();
  FilterMatrix<N> right = M;  // M Φ
  if constexpr (N == 9) right.template rightCols<3>() *= t.keep;
  right.template rightCols<N - 2>().noalias() += M.template leftCols<6>().lazyProduct(B);
  M = right;
  if constexpr (N == 9) M.template bottomRows<3>() *= t.keep;
  M.template bottomRows<N - 2>().noalias() += B.transpose().lazyProduct(right.template topRows<6>());
  const Eigen::Vector<double, 6> of_motion = r.template head<6>();
  if constexpr (N == 9) r.template tail<3>() *= t.keep;
  r.template tail<N - 2>() += B.transpose().lazyProduct(of_motion);
}

template <int N>
double Smoother<N>::step_back(const Innovation<N>& now, const FilterVector<N>& h) {
  const FilterVector<N> MK = M * now.K;
  const double e_s = now.error / now.variance - now.K.dot(r), D = 1.0 / now.variance + now.K.dot(MK);
  if (const int i = now.state; i >= 0) {
    r[i] += e_s;
    M.row(i) -= MK.transpose();
    M.col(i) -= MK;
    M(i, i) += D;
  } else {
    r += h * e_s;
    M.noalias() += (D * h - MK) * h.transpose();
    M.noalias() -= h * MK.transpose();
  }
  return 0.5 * (e_s * e_s - D);
}

template struct Smoother<6>;
template struct Smoother<9>;

}  // namespace swayaw::identification::detail
