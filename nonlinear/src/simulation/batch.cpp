#include "swayaw/nonlinear/simulation/batch.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

#include "../manoeuvres/manoeuvre_run.hpp"
#include "../manoeuvres/zigzag_kernel.hpp"
#include "swayaw/core/parallel.hpp"

namespace swayaw::inline nonlinear {
using namespace detail;
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// Ships that a thread takes at once: so many that lanes seldom wait for the last of them.
constexpr std::size_t ships_at_once = 512;

using mmg_batch::Left;

mmg_batch::ZigzagKernel kernel_of(InstructionSet set) {
  if (set == InstructionSet::best) {
    for (const auto wide : {InstructionSet::avx512, InstructionSet::avx2, InstructionSet::baseline})
      if (available(wide)) return kernel_of(wide);
    return nullptr;
  }
#ifdef SWAYAW_X86_KERNELS
  if (set == InstructionSet::avx512) return mmg_batch::avx512_zigzags();
  if (set == InstructionSet::avx2) return mmg_batch::avx2_zigzags();
#endif
  return set == InstructionSet::baseline ? mmg_batch::baseline_zigzags() : nullptr;
}

ZigzagBatch empty_batch(std::size_t ships, std::size_t reversals) {
  const std::vector<double> cells(ships * reversals, nothing);
  return {.ships = ships,
          .reversals = reversals,
          .time = cells,
          .peak_time = cells,
          .overshoot = cells,
          .count = std::vector<unsigned char>(ships),
          .end = std::vector<ZigzagEnd>(ships)};
}

/// What all ships of a batch are told.
struct Orders {
  std::span<const MmgShip<double>> ships;
  ZigzagOrder order;
  ZigzagBatchOptions options;

  ManoeuvreOptions single() const {
    return {.speed = options.speed,
            .rev = options.rev,
            .duration = options.duration,
            .tolerance = options.tolerance,
            .sampled = false};
  }
};

ManoeuvreOptions with_end(ManoeuvreOptions options, const MmgShip<double>& ship) {
  if (!options.duration) options.duration = 200.0 * ship.particulars.L / options.speed.value_or(ship.particulars.U_0);
  return options;
}

/// One ship after the other.
void run_by_numbers(const Orders& orders, std::span<const std::size_t> rows, ZigzagBatch& batch) {
  for (const std::size_t row : rows) {
    const Ship ship{.name = {}, .model = orders.ships[row], .confidence = {}, .surroundings = {}};
    try {
      const auto reversals = zigzag(ship, orders.order, with_end(orders.single(), orders.ships[row])).reversals;
      for (std::size_t r = 0; r < std::min(reversals.size(), batch.reversals); ++r) {
        batch.time[batch.at(r, row)] = reversals[r].time;
        batch.peak_time[batch.at(r, row)] = reversals[r].peak_time.value_or(nothing);
        batch.overshoot[batch.at(r, row)] = reversals[r].overshoot.value_or(nothing);
        batch.count[row] = static_cast<unsigned char>(batch.count[row] + reversals[r].overshoot.has_value());
      }
      batch.end[row] = batch.count[row] == batch.reversals ? ZigzagEnd::complete : ZigzagEnd::time_over;
    } catch (const Refusal&) {
      batch.end[row] = ZigzagEnd::unbounded;
    }
  }
}

/// What a kernel is told of some ships.
struct Columns {
  std::vector<double> numbers, speed, rev, end;

  void add(const MmgShip<double>& ship, const Plan& plan) {
    for_each_value(ship, [&](double number) { numbers.push_back(number); });
    speed.push_back(plan.speed);
    rev.push_back(plan.propulsion.rev);
    end.push_back(plan.end);
  }
};

ZigzagEnd end_of(Left left) {
  if (left == Left::complete) return ZigzagEnd::complete;
  return left == Left::time_over ? ZigzagEnd::time_over : ZigzagEnd::unbounded;
}

/// Ships that have the same selections.
void run_packs(mmg_batch::ZigzagKernel kernel, const Orders& orders, std::span<const std::size_t> rows,
               ZigzagBatch& batch) {
  Columns columns;
  for (const std::size_t row : rows) columns.add(orders.ships[row], plan(orders.ships[row], orders.single(), 200.0));
  const auto& first = orders.ships[rows.front()];
  std::vector<Left> left(rows.size());
  kernel({.numbers = columns.numbers.data(),
          .speed = columns.speed.data(),
          .rev = columns.rev.data(),
          .end = columns.end.data(),
          .row = rows.data(),
          .count = rows.size(),
          .surge_coupling = first.added_mass.surge_coupling.index,
          .engine = first.engine.kind.index,
          .rudder = orders.order.rudder,
          .heading = orders.order.heading,
          .turn = yaw_sign(orders.order.first),
          .tolerance = orders.options.tolerance,
          .rows = batch.ships,
          .reversals = batch.reversals,
          .time = batch.time.data(),
          .peak = batch.peak_time.data(),
          .overshoot = batch.overshoot.data(),
          .peaks = batch.count.data(),
          .left = left.data()});
  for (std::size_t i = 0; i < rows.size(); ++i) batch.end[rows[i]] = end_of(left[i]);
}

bool propels_herself(const Orders& orders, std::size_t row) {
  try {
    plan(orders.ships[row], orders.single(), 200.0);
    return true;
  } catch (const Refusal&) {
    return false;
  }
}

int selections(const MmgShip<double>& ship) {
  return 2 * ship.added_mass.surge_coupling.index + ship.engine.kind.index;
}

/// The ships that can be simulated, those with the same selections one after the other.
std::vector<std::size_t> run_order(const Orders& orders, ZigzagBatch& batch) {
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < batch.ships; ++row) {
    if (propels_herself(orders, row)) rows.push_back(row);
    else batch.end[row] = ZigzagEnd::no_propulsion;
  }
  std::ranges::stable_sort(rows, {}, [&](std::size_t row) { return selections(orders.ships[row]); });
  return rows;
}

/// Parts of the rows whose ships have the same selections.
std::vector<std::span<const std::size_t>> parts_of(std::span<const std::size_t> rows,
                                                   std::span<const MmgShip<double>> ships) {
  std::vector<std::span<const std::size_t>> parts;
  while (!rows.empty()) {
    std::size_t count = 1;
    while (count < std::min(rows.size(), ships_at_once) && selections(ships[rows[count]]) == selections(ships[rows[0]]))
      ++count;
    parts.push_back(rows.first(count));
    rows = rows.subspan(count);
  }
  return parts;
}

void require_sense(const Orders& orders) {
  for (const auto& ship : orders.ships) require_rudder(orders.order.rudder, ship.steering_gear);
  require_positive(orders.order.heading, "heading angle [rad]");
  require_positive(orders.options.tolerance, "tolerance");
  if (orders.options.reversals < 1 || orders.options.reversals > 255)
    throw std::domain_error("a batch of zigzags holds 1 to 255 reversals");
  if (!available(orders.options.batch.set))
    throw std::domain_error("this processor does not have the instruction set asked for");
}

}  // namespace

std::string_view in_words(ZigzagEnd end) {
  constexpr std::array<std::string_view, 4> words{"all overshoots made", "time over before the last overshoot",
                                                  "the simulated motion grows without bound",
                                                  "no shaft speed propels the ship at the approach speed"};
  return words[static_cast<std::size_t>(end)];
}

ZigzagBatch zigzag_batch(std::span<const MmgShip<double>> ships, const ZigzagOrder& order,
                         const ZigzagBatchOptions& options) {
  const Orders orders{ships, order, options};
  require_sense(orders);
  auto batch = empty_batch(ships.size(), options.reversals);
  const auto rows = run_order(orders, batch);
  const auto parts = parts_of(rows, ships);
  const auto kernel = kernel_of(options.batch.set);
  in_parallel(parts.size(), options.batch.threads, [&](std::size_t part) {
    if (kernel) run_packs(kernel, orders, parts[part], batch);
    else run_by_numbers(orders, parts[part], batch);
  });
  return batch;
}

}  // namespace swayaw::nonlinear
