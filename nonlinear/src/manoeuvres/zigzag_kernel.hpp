#pragma once

#include <cstddef>

/// What the kernels of the zigzag batch do, one translation unit for each instruction set. Not installed.
///
/// As those of the linear floor, these units hold nothing but templates over the instruction set: no function on plain
/// numbers that the linker could take for the rest of the program.
namespace swayaw::inline nonlinear::mmg_batch {

/// How a ship ended.
enum class Left : unsigned char { complete, time_over, unbounded };

/// Ships in, reversals out, [reversal · rows + row of the ship].
struct ZigzagJob {
  const double* numbers;   ///< of one ship after the other, as for_each_value visits them
  const double* speed;     ///< of approach [m/s]
  const double* rev;       ///< shaft speed [1/s]
  const double* end;       ///< when to stop at the latest [s]
  const std::size_t* row;  ///< of the ship in the results
  std::size_t count;       ///< ships, all with the same selections
  int surge_coupling, engine;
  double rudder, heading, turn, tolerance;
  std::size_t rows, reversals;
  double *time, *peak, *overshoot;
  unsigned char* peaks;  ///< how many overshoots, by row
  Left* left;            ///< by ship
};

using ZigzagKernel = void (*)(const ZigzagJob&);

ZigzagKernel baseline_zigzags();  ///< null without xsimd, or where it knows no instruction set
ZigzagKernel avx2_zigzags();      ///< AVX2 and fused multiply-add
ZigzagKernel avx512_zigzags();    ///< AVX-512 F, CD, DQ and BW

}  // namespace swayaw::nonlinear::mmg_batch
