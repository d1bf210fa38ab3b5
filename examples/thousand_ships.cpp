// What a thousand ships do that a ship file might mean: its hull derivatives drawn as well as they are known, all
// zigzags in SIMD packs, then some of the same ships one by one.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>

#include "swayaw/core/angle.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/ship_file.hpp"
#include "swayaw/nonlinear/simulation/batch.hpp"

namespace {

using namespace swayaw;

constexpr std::size_t count = 1000, compared = 50;
constexpr ZigzagOrder order{.rudder = radians(10), .heading = radians(10), .first = Side::starboard};
constexpr double duration = 1000.0;  // [s]

/// Each coefficient of the hull by its deviation before any data, within its range.
std::vector<MmgShip<double>> drawn(const Ship& ship, unsigned seed) {
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal;
  const auto coefficients = coefficients_of(ship, "hull");
  std::vector<MmgShip<double>> fleet(count, std::get<MmgShip<double>>(ship.model));
  for (auto& model : fleet) {
    std::vector<double> values;
    for (const auto& c : coefficients)
      values.push_back(std::clamp(c.value + c.deviation * normal(engine), c.range.low, c.range.high));
    set_values<MmgShip<double>, double>(model, coefficients, values);
  }
  return fleet;
}

double quantile(std::vector<double> values, double share) {
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1) + 0.5);
  std::ranges::nth_element(values, place);
  return *place;
}

void print_overshoots(const ZigzagBatch& batch, std::size_t reversal) {
  std::vector<double> reached;
  for (std::size_t i = 0; i < batch.ships; ++i)
    if (const double x = batch.overshoot[batch.at(reversal, i)]; std::isfinite(x)) reached.push_back(degrees(x));
  fmt::print("overshoot {}: of {} ships {} have one, in deg", reversal + 1, batch.ships, reached.size());
  for (const double share : {0.05, 0.25, 0.5, 0.75, 0.95})
    if (!reached.empty()) fmt::print("   {:.0f} % {:6.2f}", 100.0 * share, quantile(reached, share));
  fmt::print("\n");
}

/// Seconds of the clock that `work` takes.
template <class Work>
double seconds(const Work& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

int main(int, char** arguments) {
  const Ship ship = read_ship(arguments[1]);
  const auto fleet = drawn(ship, 1);

  ZigzagBatch batch;
  const ZigzagBatchOptions options{.reversals = 2, .duration = duration, .batch = {.threads = 1}};
  const double in_packs = seconds([&] { batch = zigzag_batch(fleet, order, options); });
  for (std::size_t reversal = 0; reversal < batch.reversals; ++reversal) print_overshoots(batch, reversal);

  // the same ships one by one, to the same tolerance, until the same overshoot
  double apart = 0.0;
  const double one_by_one = seconds([&] {
    for (std::size_t i = 0; i < compared; ++i) {
      Ship other = ship;
      other.model = fleet[i];
      const auto alone = zigzag(other, order, {.duration = duration, .tolerance = 1e-7, .sampled = false});
      for (std::size_t r = 0; r < std::min(batch.reversals, alone.reversals.size()); ++r)
        if (const auto overshoot = alone.reversals[r].overshoot)
          apart = std::max(apart, std::abs(*overshoot - batch.overshoot[batch.at(r, i)]));
    }
  });
  const double pack_rate = count / in_packs, single_rate = compared / one_by_one;
  fmt::print("on one core {:.0f} ships a second in packs, {:.0f} one by one; overshoots at most {:.1g} deg apart\n",
             pack_rate, single_rate, degrees(apart));
  if (!(apart < radians(1e-3))) return 1;
}
