#pragma once

#include <cstddef>

/// What the batch kernels do, one translation unit for each instruction set. Not installed.
///
/// These units are compiled for processors that the program may not run on. So they hold nothing but templates over the
/// instruction set: no function on plain numbers that the linker could take for the rest of the program.
namespace swayaw::inline linear::batch {

/// Ships in, reversals out, [reversal · ships + ship].
struct ZigzagJob {
  const double *a1, *b1, *c1, *a2, *b2, *c2;
  double rudder, heading, rate, turn, longest;
  std::size_t ships, reversals;
  double *execute, *peak, *overshoot;
  unsigned char* count;  ///< how many reversals, or `redo`
};

/// What the packs leave to the scalar code: complex or close poles, a pole near 0, a top that decides.
inline constexpr unsigned char redo = 255;

/// Most reversals of a kernel.
inline constexpr std::size_t most_reversals = 16;

/// Zigzags of the ships [first, last).
using ZigzagKernel = void (*)(const ZigzagJob&, std::size_t first, std::size_t last);

ZigzagKernel baseline_zigzags();  ///< null without xsimd, or where it knows no instruction set
ZigzagKernel avx2_zigzags();      ///< AVX2 and fused multiply-add
ZigzagKernel avx512_zigzags();    ///< AVX-512 F, CD, DQ and BW

/// States that are sampled at once.
inline constexpr std::size_t block = 16;

/// What beta, omega, psi and the rudder angle at the first of a block are to (beta, omega, psi) of the block and of the
/// next one's first, [3 · state + number]; `by_turn` is what the turn of the rudder from state to state adds.
struct BlockMap {
  double by_beta[3 * block + 3], by_omega[3 * block + 3], by_psi[3 * block + 3], by_angle[3 * block + 3],
      by_turn[3 * block + 3];
};

/// Blocks that follow each other on a leg.
struct SampleJob {
  double beta, omega, psi, angle;  ///< at the first state; at the end, at the first state thereafter
  double turn;                     ///< of the rudder from state to state
  std::size_t blocks;
  double* states;  ///< beta, omega, psi, beta, …
};

using SampleKernel = void (*)(const BlockMap&, SampleJob&);

SampleKernel baseline_samples();
SampleKernel avx2_samples();  ///< AVX2 and fused multiply-add

/// The kernel for this processor.
SampleKernel best_samples();

}  // namespace swayaw::linear::batch
