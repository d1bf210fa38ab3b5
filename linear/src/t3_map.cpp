#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "leg_functions.hpp"
#include "swayaw/core/parallel.hpp"
#include "swayaw/linear/batch.hpp"

namespace swayaw::inline linear {
using namespace detail;
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr T3Point no_point{nothing, nothing, nothing, nothing, nothing, nothing, nothing};

/// z and z' at the start of a leg, z'' − tr z' + det z = delta.
struct CommonLeg {
  double z, z_rate;
  RudderLine<double> rudder;
  double length;
};

/// The limit cycle of all ships with one T3w.
struct Row {
  SwayYawTransfer<double> yaw;  ///< nb0 and nb1 as of the helper below
  LimitCycle cycle;
  double common_area = 0.0;  ///< of the (z, z') loop
  double omega_max = 0.0;
  std::vector<CommonLeg> half;  ///< from one reversal to the next
};

/// Beside omega = nw0 z + nw1 z' the helper nw0 z' − nw1 z in the place of beta: z and z' follow from both without
/// loss.
SwayYawTransfer<double> with_helper(SwayYawTransfer<double> h) {
  h.nb0 = -h.nw1;
  h.nb1 = h.nw0;
  return h;
}

CommonLeg common_leg(const SwayYawTransfer<double>& h, const Leg<double>& leg) {
  const double over = 1.0 / (h.nw0 * h.nw0 + h.nw1 * h.nw1);
  return {.z = (h.nw0 * leg.start.omega - h.nw1 * leg.start.beta) * over,
          .z_rate = (h.nw0 * leg.start.beta + h.nw1 * leg.start.omega) * over,
          .rudder = leg.rudder,
          .length = leg.length};
}

Row row_of(SteeringIndices<double> indices, const LinearZigzagOrder& order, double T3w) {
  indices.T3w = T3w;
  const auto h = with_helper(transfer_functions(indices));
  const auto ship = coefficients_from(h);
  Row row{.yaw = h, .cycle = limit_cycle(ship, order), .half = {}};
  const auto loop = drift_yaw_loop(ship, row.cycle.zigzag);
  if (!loop) return row;
  row.common_area = loop->area / (h.nw0 * h.nw0 + h.nw1 * h.nw1);
  row.omega_max = loop->omega_max;
  const auto& [reversals, legs] = row.cycle.zigzag;
  for (std::size_t i = reversals[reversals.size() - 2].leg; i < reversals.back().leg; ++i)
    row.half.push_back(common_leg(h, legs[i]));
  return row;
}

/// The ship whose states are z' in the place of beta and b = z + T3b z' in that of omega:
///
///     dz'/ds = (tr + det T3b) z' − det b + delta,   db/ds = (1 + tr T3b + det T3b²) z' − det T3b b + T3b delta
LegShip drift_ship(double tr, double det, double T3b) {
  return LegShip(LinearResponse<double>(
      {.a1 = tr + det * T3b, .b1 = -det, .c1 = 1.0, .a2 = 1.0 + (tr + det * T3b) * T3b, .b2 = -det * T3b, .c2 = T3b}));
}

/// Largest |b| and |z'| where b passes zero.
struct DriftExtremes {
  double b_max = 0.0;
  double z_rate_at_zero = 0.0;

  void take_top(const LinearState<double>& x) { b_max = std::max(b_max, std::abs(x.omega)); }
  void take_zero(const LinearState<double>& x) { z_rate_at_zero = std::max(z_rate_at_zero, std::abs(x.beta)); }
};

DriftExtremes drift_extremes(const Row& row, double T3b) {
  const LegShip ship = drift_ship(-row.yaw.e1, row.yaw.e0, T3b);
  DriftExtremes result;
  for (const auto& [z, z_rate, rudder, length] : row.half) {
    const LinearState<double> start{.beta = z_rate, .omega = z + T3b * z_rate, .psi = 0.0};
    result.take_top(start);
    for_each_zero(ship, start, rudder, length, 1, [&](const LinearState<double>& x, double) { result.take_zero(x); });
    for_each_zero(ship, start, rudder, length, 2, [&](const LinearState<double>& x, double) { result.take_top(x); });
  }
  return result;
}

T3Point settled_point(const SteeringIndices<double>& indices, const Row& row, double T3b, double T3w) {
  const double nb0 = indices.Kb / indices.T1T2, nw0 = row.yaw.nw0;
  const auto extremes = drift_extremes(row, T3b);
  const auto& reversals = row.cycle.zigzag.reversals;
  return {.area = std::abs(nb0 * nw0 * (T3w - T3b)) * row.common_area,
          .beta_max = std::abs(nb0) * extremes.b_max,
          .omega_max = row.omega_max,
          .omega_at_beta_zero = std::abs(nw0 * (T3w - T3b)) * extremes.z_rate_at_zero,
          .overshoot1 = reversals[0].overshoot,
          .overshoot2 = reversals[1].overshoot,
          .period = row.cycle.zigzag.period().value()};
}

/// Where the zigzag goes on changing: the last cycle of this very ship.
T3Point unsettled_point(SteeringIndices<double> indices, const LinearZigzagOrder& order, double T3b, double T3w) {
  indices.T3b = T3b;
  indices.T3w = T3w;
  if (inverse_distance(indices) == 0.0) return no_point;
  const auto ship = coefficients_from(indices);
  const auto zigzag = limit_cycle(ship, order).zigzag;
  const auto loop = drift_yaw_loop(ship, zigzag);
  if (!loop) return no_point;
  return {loop->area,
          loop->beta_max,
          loop->omega_max,
          loop->omega_at_beta_zero,
          zigzag.reversals[0].overshoot,
          zigzag.reversals[1].overshoot,
          zigzag.period().value()};
}

void require_nonzero(double value, const char* what) {
  if (value == 0.0) throw std::domain_error(std::string(what) + " must not be zero");
}

}  // namespace

T3Map t3_map(const SteeringIndices<double>& indices, const LinearZigzagOrder& order, std::span<const double> T3b,
             std::span<const double> T3w, unsigned threads) {
  require_nonzero(indices.T1T2, "T1 T2");
  require_nonzero(indices.Kb, "gain Kb");
  require_nonzero(indices.Kw, "gain Kw");
  T3Map map{
      {T3b.begin(), T3b.end()}, {T3w.begin(), T3w.end()}, std::vector<T3Point>(T3b.size() * T3w.size(), no_point)};
  in_parallel(T3w.size(), threads, [&](std::size_t w) {
    const Row row = row_of(indices, order, T3w[w]);
    if (row.half.empty()) return;
    for (std::size_t b = 0; b < T3b.size(); ++b)
      map.points[w * T3b.size() + b] = row.cycle.settled ? settled_point(indices, row, T3b[b], T3w[w])
                                                         : unsettled_point(indices, order, T3b[b], T3w[w]);
  });
  return map;
}

}  // namespace swayaw::linear
