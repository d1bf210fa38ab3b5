#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "swayaw/linear/loop.hpp"

/// Many ships at once: over SIMD packs with the instruction set of the processor that runs the program, and over all
/// cores. The results are those of the functions for one ship, whatever the instruction set and the number of threads.
namespace swayaw::inline linear {

enum class InstructionSet {
  best,      ///< the widest that this processor has
  numbers,   ///< no packs, one ship after the other
  baseline,  ///< what every processor of this kind has: SSE2 on x86-64
  avx2,      ///< AVX2 and fused multiply-add
  avx512,    ///< AVX-512 F, CD, DQ and BW
};

/// Whether this processor has it and this library was built with it.
bool available(InstructionSet set);

struct BatchOptions {
  unsigned threads = 0;  ///< 0 for one on each core
  InstructionSet set = InstructionSet::best;
};

/// One coefficient of every ship after the other.
using ShipColumns = SwayYawCoefficients<std::span<const double>>;

/// Reversals of many zigzags; those of a ship that were not reached are not a number.
struct ZigzagTable {
  std::size_t ships = 0;
  std::size_t reversals = 0;         ///< asked for
  std::vector<double> execute;       ///< s' at which the heading reaches H, [reversal · ships + ship]
  std::vector<double> peak;          ///< s' at which the yaw rate passes zero
  std::vector<double> overshoot;     ///< heading beyond H at the peak [rad]
  std::vector<unsigned char> count;  ///< how many reversals each ship made
  std::size_t by_numbers = 0;        ///< ships that the packs left to the scalar code

  std::size_t at(std::size_t reversal, std::size_t ship) const { return reversal * ships + ship; }
};

/// The zigzag of every ship, switches as `linear_zigzag` gives them to 1e-10, less where the heading hardly reaches H.
///
/// The packs follow ships with real poles well apart and away from zero, one ship a lane, and leave the others to the
/// scalar code, together with those for which the signs at the ends of a leg do not settle how often the heading or yaw
/// rate passes its goal. A ship that `linear_zigzag` refuses, since her motion changes too fast, makes no reversal.
///
/// @throws std::domain_error  if the columns differ in length, an angle or the rate is not positive, more than 16
///                            reversals are asked for, or the instruction set is not available
ZigzagTable zigzag_batch(const ShipColumns& ships, const LinearZigzagOrder& order, const BatchOptions& options = {});

/// The same into a table of before, whose memory serves again.
void zigzag_batch(const ShipColumns& ships, const LinearZigzagOrder& order, ZigzagTable& table,
                  const BatchOptions& options = {});

/// States at s' = 0, step, 2 step, … of a zigzag or any legs that follow each other, as many as `states` holds, by the
/// exact map over a step. Beyond the last leg its rudder goes on.
///
/// @throws std::domain_error  if there are no legs, or the step is not positive
void sample_legs(const SwayYawCoefficients<double>& ship, std::span<const Leg<double>> legs, double step,
                 std::span<LinearState<double>> states);

/// Limit cycle and first overshoots of one ship of a map.
struct T3Point {
  double area;                ///< of the loop [rad]
  double beta_max;            ///< largest |beta| [rad]
  double omega_max;           ///< largest |omega'|
  double omega_at_beta_zero;  ///< |omega'| where beta passes zero
  double overshoot1;          ///< first overshoot [rad]
  double overshoot2;          ///< second overshoot [rad]
  double period;              ///< of the limit cycle [ship lengths]
};

/// Loop measures over a grid of T3b and T3w.
struct T3Map {
  std::vector<double> T3b, T3w;
  std::vector<T3Point> points;  ///< [w · T3b.size() + b]; not a number where the ship makes no three reversals

  const T3Point& at(std::size_t b, std::size_t w) const { return points[w * T3b.size() + b]; }
};

/// The measures of `drift_yaw_loop(limit_cycle(…))` for every pair of T3b and T3w, the other indices held.
///
/// With z'' − tr z' + det z = delta both outputs are made of one motion,
///
///     beta = nb0 (z + T3b z'),   omega = nw0 (z + T3w z'),   nb0 = Kb/(T1 T2),   nw0 = Kw/(T1 T2),
///
/// and the zigzag follows from omega. So it is sailed once for each T3w; every T3b shears the same loop, whose area is
/// |nb0 nw0 (T3w − T3b)| times that of the (z, z') loop. Defined for T3b = T3w too, where the loop is a line.
///
/// @throws std::domain_error  if T1 T2, Kb or Kw is 0, or an angle or the rate of the order is not positive
T3Map t3_map(const SteeringIndices<double>& indices, const LinearZigzagOrder& order, std::span<const double> T3b,
             std::span<const double> T3w, unsigned threads = 0);

}  // namespace swayaw::linear
