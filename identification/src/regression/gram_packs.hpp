#pragma once

#include <xsimd/xsimd.hpp>

#include "gram_kernel.hpp"

/// Products of columns in packs. Not installed.
namespace swayaw::inline identification::gram {

/// Products of three columns with four: twelve sums, three columns and one more number fit into sixteen registers.
inline constexpr std::size_t few = 3, many = 4;

/// Rows whose columns stay in the second cache while all products are made.
inline constexpr std::size_t rows_at_once = 1024;

template <class Pack>
double sum_of_lanes(const Pack& pack) {
  double lanes[Pack::size], sum = 0.0;
  pack.store_unaligned(lanes);
  for (const double x : lanes) sum += x;
  return sum;
}

/// Adds the products of columns j … j + 2 with columns i … i + 3 over some rows; a column that is not there is the last
/// one.
template <class Arch>
void add_tile(const GramJob& job, std::size_t i, std::size_t j, std::size_t first, std::size_t last) {
  using Pack = xsimd::batch<double, Arch>;
  const std::size_t end = job.count - 1;
  const double *a[few], *b[many];
  for (std::size_t m = 0; m < few; ++m) a[m] = job.columns[j + m < end ? j + m : end];
  for (std::size_t k = 0; k < many; ++k) b[k] = job.columns[i + k < end ? i + k : end];
  Pack sum[few][many];
  for (std::size_t m = 0; m < few; ++m)
    for (std::size_t k = 0; k < many; ++k) sum[m][k] = Pack(0.0);
  for (std::size_t t = first; t < last; t += Pack::size) {
    const Pack a0 = Pack::load_unaligned(a[0] + t), a1 = Pack::load_unaligned(a[1] + t),
               a2 = Pack::load_unaligned(a[2] + t);
    for (std::size_t k = 0; k < many; ++k) {
      const Pack bk = Pack::load_unaligned(b[k] + t);
      sum[0][k] = xsimd::fma(a0, bk, sum[0][k]);
      sum[1][k] = xsimd::fma(a1, bk, sum[1][k]);
      sum[2][k] = xsimd::fma(a2, bk, sum[2][k]);
    }
  }
  for (std::size_t m = 0; m < few && j + m <= end; ++m)
    for (std::size_t k = 0; k < many && i + k <= end; ++k)
      job.products[i + k + job.count * (j + m)] += sum_of_lanes(sum[m][k]);
}

/// All products on and below the diagonal, and a few above it.
template <class Arch>
void gram_packs(const GramJob& job) {
  for (std::size_t first = 0; first < job.rows; first += rows_at_once) {
    const std::size_t last = first + rows_at_once < job.rows ? first + rows_at_once : job.rows;
    for (std::size_t j = 0; j < job.count; j += few)
      for (std::size_t i = j - j % many; i < job.count; i += many) add_tile<Arch>(job, i, j, first, last);
  }
}

}  // namespace swayaw::identification::gram
