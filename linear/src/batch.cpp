#include "swayaw/linear/batch.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "batch_kernel.hpp"
#include "swayaw/core/parallel.hpp"
#include "swayaw/core/refusal.hpp"

namespace swayaw::inline linear {
using namespace detail;
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// Ships that a thread takes at once; a multiple of every number of lanes.
constexpr std::size_t ships_at_once = 256;

bool processor_has(InstructionSet set) {
#ifdef SWAYAW_X86_KERNELS
  if (set == InstructionSet::avx2) return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  if (set == InstructionSet::avx512)
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512cd") &&
           __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("fma");
#endif
  return set == InstructionSet::numbers || (set == InstructionSet::baseline && batch::baseline_zigzags());
}

InstructionSet chosen(InstructionSet set) {
  if (set != InstructionSet::best) return set;
  for (const auto wide : {InstructionSet::avx512, InstructionSet::avx2, InstructionSet::baseline})
    if (processor_has(wide)) return wide;
  return InstructionSet::numbers;
}

batch::ZigzagKernel kernel_of(InstructionSet set) {
#ifdef SWAYAW_X86_KERNELS
  if (set == InstructionSet::avx512) return batch::avx512_zigzags();
  if (set == InstructionSet::avx2) return batch::avx2_zigzags();
#endif
  return set == InstructionSet::baseline ? batch::baseline_zigzags() : nullptr;
}

void require_same_length(const ShipColumns& s) {
  for (const auto* column : {&s.b1, &s.c1, &s.a2, &s.b2, &s.c2})
    if (column->size() != s.a1.size()) throw std::domain_error("columns of ship coefficients differ in length");
}

LinearZigzag<double> zigzag_or_none(const SwayYawCoefficients<double>& ship, const LinearZigzagOrder& order) {
  try {
    return linear_zigzag(ship, order);
  } catch (const Refusal&) {
    return {};
  }
}

void sail_by_numbers(const ShipColumns& s, std::size_t ship, const LinearZigzagOrder& order, ZigzagTable& table) {
  const auto zigzag = zigzag_or_none({s.a1[ship], s.b1[ship], s.c1[ship], s.a2[ship], s.b2[ship], s.c2[ship]}, order);
  const std::size_t count = std::min(zigzag.reversals.size(), order.reversals);
  table.count[ship] = static_cast<unsigned char>(count);
  for (std::size_t r = 0; r < count; ++r) {
    const auto& reversal = zigzag.reversals[r];
    table.execute[table.at(r, ship)] = reversal.execute;
    table.peak[table.at(r, ship)] = reversal.peak;
    table.overshoot[table.at(r, ship)] = reversal.overshoot;
  }
}

void make_room(ZigzagTable& table, std::size_t ships, std::size_t reversals) {
  table.ships = ships;
  table.reversals = reversals;
  for (auto* column : {&table.execute, &table.peak, &table.overshoot}) column->resize(ships * reversals);
  table.count.assign(ships, batch::redo);
}

void forget_unreached(ZigzagTable& table, std::size_t ship) {
  for (std::size_t r = table.count[ship]; r < table.reversals; ++r)
    table.execute[table.at(r, ship)] = table.peak[table.at(r, ship)] = table.overshoot[table.at(r, ship)] = nothing;
}

batch::ZigzagJob job_of(const ShipColumns& s, const LinearZigzagOrder& order, ZigzagTable& t) {
  return {.a1 = s.a1.data(),
          .b1 = s.b1.data(),
          .c1 = s.c1.data(),
          .a2 = s.a2.data(),
          .b2 = s.b2.data(),
          .c2 = s.c2.data(),
          .rudder = order.rudder,
          .heading = order.heading,
          .rate = order.rate,
          .turn = yaw_sign(order.first),
          .longest = order.longest,
          .ships = t.ships,
          .reversals = t.reversals,
          .execute = t.execute.data(),
          .peak = t.peak.data(),
          .overshoot = t.overshoot.data(),
          .count = t.count.data()};
}

}  // namespace

batch::SampleKernel batch::best_samples() {
#ifdef SWAYAW_X86_KERNELS
  if (processor_has(InstructionSet::avx2)) return avx2_samples();
#endif
  return baseline_samples();
}

bool available(InstructionSet set) { return processor_has(chosen(set)); }

ZigzagTable zigzag_batch(const ShipColumns& ships, const LinearZigzagOrder& order, const BatchOptions& options) {
  ZigzagTable table;
  zigzag_batch(ships, order, table, options);
  return table;
}

void zigzag_batch(const ShipColumns& ships, const LinearZigzagOrder& order, ZigzagTable& table,
                  const BatchOptions& options) {
  require_same_length(ships);
  require_positive(order.rudder, "rudder angle [rad]");
  require_positive(order.heading, "heading angle [rad]");
  require_positive(order.rate, "rudder rate [rad per ship length]");
  if (order.reversals > batch::most_reversals) throw std::domain_error("a batch of zigzags holds at most 16 reversals");
  if (!available(options.set)) throw std::domain_error("this processor does not have the instruction set asked for");
  const std::size_t count = ships.a1.size();
  make_room(table, count, order.reversals);
  const auto kernel = kernel_of(chosen(options.set));
  const auto job = job_of(ships, order, table);
  std::atomic<std::size_t> by_numbers = 0;
  in_parallel((count + ships_at_once - 1) / ships_at_once, options.threads, [&](std::size_t part) {
    const std::size_t first = part * ships_at_once, last = std::min(first + ships_at_once, count);
    if (kernel) kernel(job, first, last);
    for (std::size_t ship = first; ship < last; ++ship) {
      if (table.count[ship] == batch::redo) {
        sail_by_numbers(ships, ship, order, table);
        ++by_numbers;
      }
      forget_unreached(table, ship);
    }
  });
  table.by_numbers = by_numbers;
}

}  // namespace swayaw::linear
