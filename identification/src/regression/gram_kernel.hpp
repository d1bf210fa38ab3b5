#pragma once

#include <cstddef>

/// Products of columns, one translation unit for each instruction set. Not installed.
///
/// As the kernels of the floors below, these units hold nothing but templates over the instruction set: no function on
/// plain numbers that the linker could take for the rest of the program.
namespace swayaw::inline identification::gram {

/// Columns in, their products out: products[i + count · j] += Σ_t columns[i][t] columns[j][t], for i ≥ j.
struct GramJob {
  const double* const* columns;
  std::size_t count;
  std::size_t rows;  ///< a multiple of 16
  double* products;
};

/// Widest pack of all instruction sets; rows beyond a multiple of it are left to the caller.
inline constexpr std::size_t widest = 16;

using GramKernel = void (*)(const GramJob&);

GramKernel baseline_gram();  ///< null without xsimd, or where it knows no instruction set
GramKernel avx2_gram();      ///< AVX2 and fused multiply-add
GramKernel avx512_gram();    ///< AVX-512 F, CD, DQ and BW

}  // namespace swayaw::identification::gram
