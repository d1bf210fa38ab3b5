#include "swayaw/linear/loop.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "leg_functions.hpp"
#include "swayaw/core/dual.hpp"

namespace swayaw::inline linear {
using namespace detail;
namespace {

/// Legs of the last full cycle.
struct Cycle {
  std::size_t first;
  std::size_t last;  ///< one past the end
};

template <class S>
std::optional<Cycle> last_cycle(const LinearZigzag<S>& zigzag) {
  const auto& r = zigzag.reversals;
  if (r.size() < 3) return std::nullopt;
  return Cycle{r[r.size() - 3].leg, r.back().leg};
}

// ---------------------------------------------------------------- integrals along the loop

/// Ten-point Gauss–Legendre rule on [0, 1].
struct Node {
  double place;
  double weight;
};

constexpr std::array<Node, 10> nodes = [] {
  constexpr double x[] = {0.14887433898163122, 0.43339539412924719, 0.67940956829902441, 0.86506336668898451,
                          0.97390652851717172};
  constexpr double w[] = {0.29552422471475287, 0.26926671930999636, 0.21908636251598204, 0.14945134915058059,
                          0.06667134430868814};
  std::array<Node, 10> rule{};
  for (std::size_t i = 0; i < 5; ++i) {
    rule[2 * i] = {0.5 * (1.0 - x[i]), 0.5 * w[i]};
    rule[2 * i + 1] = {0.5 * (1.0 + x[i]), 0.5 * w[i]};
  }
  return rule;
}();

/// Line integrals that give area, centroid and area moments by Green's theorem, and the distance from a line.
template <class S>
struct LoopIntegrals {
  S area{0.0};         ///< ∮ beta d(omega)
  S beta{0.0};         ///< ∮ ½ beta² d(omega)
  S omega{0.0};        ///< −∮ ½ omega² d(beta)
  S beta_beta{0.0};    ///< ∮ ⅓ beta³ d(omega)
  S omega_omega{0.0};  ///< −∮ ⅓ omega³ d(beta)
  S beta_omega{0.0};   ///< ∮ ½ beta² omega d(omega)
  S off_line{0.0};     ///< ∫ (omega − slope beta)² ds
  S time{0.0};

  void add(const S& b, const S& w, const S& db, const S& dw) {
    area += b * dw;
    beta += 0.5 * b * b * dw;
    omega += -0.5 * w * w * db;
    beta_beta += (1.0 / 3.0) * b * b * b * dw;
    omega_omega += (-1.0 / 3.0) * w * w * w * db;
    beta_omega += 0.5 * b * b * w * dw;
  }
};

/// Adds the part of a leg in which no mode is quicker than `pole` [per ship length].
///
/// The rates obey x'' = A x' + c rho: from their values at the start, not as A x + c delta, whose large terms would
/// cancel where T2 is very small.
template <class S>
void add_part(LoopIntegrals<S>& sum, const LinearResponse<S>& ship, const Leg<S>& leg, const S& slope, const S& from,
              const S& length, double pole) {
  const auto first = rates(ship.m, leg.start, leg.rudder.value);
  const int pieces = std::max(1, static_cast<int>(std::ceil(pole * value_of(length) / 2.0)));
  for (int piece = 0; piece < pieces; ++piece) {
    for (const auto& [place, weight] : nodes) {
      const S s = from + length * ((piece + place) / pieces), ds = length * (weight / pieces);
      const auto basis = response_basis(ship.p, s);
      const auto x = state_after(ship, leg.start, leg.rudder, basis);
      const auto rate = state_after(ship, {first.beta, first.omega, S(0.0)}, {leg.rudder.rate, S(0.0)}, basis);
      sum.add(x.beta, x.omega, rate.beta * ds, rate.omega * ds);
      const S off = x.omega - slope * x.beta;
      sum.off_line += off * off * ds;
    }
  }
}

/// Adds a leg: until a fast mode has died out, exp(−40) of it left, and thereafter.
template <class S>
void add_leg(LoopIntegrals<S>& sum, const LinearResponse<S>& ship, const Leg<S>& leg, const S& slope) {
  const auto& p = ship.p;
  const double fading = 40.0 / p.size;
  if (p.apart && value_of(p.fast) < 0.0 && fading < value_of(leg.length)) {
    add_part(sum, ship, leg, slope, S(0.0), S(fading), p.size);
    add_part(sum, ship, leg, slope, S(fading), S(leg.length - fading), std::abs(value_of(p.slow)));
  } else {
    add_part(sum, ship, leg, slope, S(0.0), leg.length, p.size);
  }
  sum.time += leg.length;
}

/// The straight line from the end of the loop to its start.
template <class S>
void add_chord(LoopIntegrals<S>& sum, const LinearState<S>& end, const LinearState<S>& start) {
  const S db = start.beta - end.beta, dw = start.omega - end.omega;
  for (const auto& [place, weight] : nodes)
    sum.add(end.beta + db * place, end.omega + dw * place, db * weight, dw * weight);
}

template <class S>
void set_ellipse(LoopMeasures<S>& m, const LoopIntegrals<S>& sum) {
  const double sign = value_of(sum.area) < 0.0 ? -1.0 : 1.0;
  const S area = sum.area * sign;
  const S b = sum.beta * sign / area, w = sum.omega * sign / area;  // centroid
  const S bb = sum.beta_beta * sign / area - b * b, ww = sum.omega_omega * sign / area - w * w,
          bw = sum.beta_omega * sign / area - b * w;
  const S mean = 0.5 * (bb + ww), half = sqrt(0.25 * (bb - ww) * (bb - ww) + bw * bw);
  m.area = area;
  m.length = 4.0 * sqrt(mean + half);
  m.width = 4.0 * sqrt(positive_part(S(mean - half)));
  m.inclination = 0.5 * atan2(2.0 * bw, bb - ww);
}

// ---------------------------------------------------------------- extremes

/// Beta and omega exchanged, so that what is known of omega serves for beta.
LinearResponse<double> exchanged(const SwayYawCoefficients<double>& m) {
  return LinearResponse<double>({m.b2, m.a2, m.c2, m.b1, m.a1, m.c1});
}

LinearState<double> exchanged(const LinearState<double>& x) { return {x.omega, x.beta, 0.0}; }

/// Places on a leg.
struct Places {
  std::vector<double> beta_zero, beta_top, omega_zero, omega_top;
};

std::vector<double> all_zeros(const LegShip& ship, const LinearState<double>& start, const RudderLine<double>& rudder,
                              double length, int level) {
  std::vector<double> zeros;
  for_each_zero(ship, start, rudder, length, level, [&](const LinearState<double>&, double s) { zeros.push_back(s); });
  return zeros;
}

Places places_on(const SwayYawCoefficients<double>& m, const Leg<double>& leg) {
  const LegShip ship(LinearResponse<double>{m}), swapped(exchanged(m));
  const auto start = exchanged(leg.start);
  return {.beta_zero = all_zeros(swapped, start, leg.rudder, leg.length, 1),
          .beta_top = all_zeros(swapped, start, leg.rudder, leg.length, 2),
          .omega_zero = all_zeros(ship, leg.start, leg.rudder, leg.length, 1),
          .omega_top = all_zeros(ship, leg.start, leg.rudder, leg.length, 2)};
}

template <class S>
S size(const S& x) {
  return value_of(x) < 0.0 ? S(-x) : x;
}

template <class S>
void take_larger(S& largest, const S& candidate) {
  if (value_of(size(candidate)) > value_of(largest)) largest = size(candidate);
}

/// Largest values and crossings on a leg whose places are known in numbers. A crossing moves with the coefficients: one
/// Newton step in S. At a top the derivative is zero, so a place that stays does no harm.
template <class S>
void add_extremes(LoopMeasures<S>& m, const LinearResponse<S>& ship, const Leg<S>& leg, const Places& places) {
  const auto at = [&](const S& s) { return state_after(ship, leg.start, leg.rudder, s); };
  const auto rate_at = [&](const LinearState<S>& x, const S& s) {
    return rates(ship.m, x, S(leg.rudder.value + leg.rudder.rate * s));
  };
  for (const auto& x : {leg.start, at(leg.length)}) {
    take_larger(m.beta_max, x.beta);
    take_larger(m.omega_max, x.omega);
  }
  for (const double s : places.beta_top) take_larger(m.beta_max, at(S(s)).beta);
  for (const double s : places.omega_top) take_larger(m.omega_max, at(S(s)).omega);
  for (const double place : places.beta_zero) {
    const auto x = at(S(place));
    const S s = place - x.beta / value_of(rate_at(x, S(place)).beta);
    take_larger(m.omega_at_beta_zero, at(s).omega);
  }
  for (const double place : places.omega_zero) {
    const auto x = at(S(place));
    const S s = place - x.omega / value_of(rate_at(x, S(place)).omega);
    take_larger(m.beta_at_omega_zero, at(s).beta);
  }
}

/// @param numbers  the zigzag in numbers, whose legs tell where to look
template <class S>
LoopMeasures<S> measures(const SwayYawCoefficients<S>& m, const LinearZigzag<S>& zigzag,
                         const SwayYawCoefficients<double>& numbers_of_m, const LinearZigzag<double>& numbers) {
  const LinearResponse<S> ship(m);
  const auto cycle = last_cycle(numbers).value();
  const S slope = ship.h.nw0 / ship.h.nb0;  // Kw/Kb
  LoopIntegrals<S> sum;
  LoopMeasures<S> result{S(0.0), S(0.0), S(0.0), S(0.0), S(0.0), S(0.0), S(0.0), S(0.0), S(0.0)};
  for (std::size_t i = cycle.first; i < cycle.last; ++i) {
    add_leg(sum, ship, zigzag.legs[i], slope);
    add_extremes(result, ship, zigzag.legs[i], places_on(numbers_of_m, numbers.legs[i]));
  }
  const auto& last = zigzag.legs[cycle.last - 1];
  add_chord(sum, state_after(ship, last.start, last.rudder, last.length), zigzag.legs[cycle.first].start);
  set_ellipse(result, sum);
  result.distance_from_line = sqrt(sum.off_line / sum.time / (1.0 + slope * slope));
  return result;
}

template <class Get>
LoopMeasures<double> part_of(const LoopMeasures<Dual<2>>& m, Get&& get) {
  return {get(m.area),
          get(m.length),
          get(m.width),
          get(m.inclination),
          get(m.beta_max),
          get(m.omega_max),
          get(m.omega_at_beta_zero),
          get(m.beta_at_omega_zero),
          get(m.distance_from_line)};
}

}  // namespace

std::optional<LoopMeasures<double>> drift_yaw_loop(const SwayYawCoefficients<double>& ship,
                                                   const LinearZigzag<double>& zigzag) {
  if (!last_cycle(zigzag)) return std::nullopt;
  return measures(ship, zigzag, ship, zigzag);
}

LimitCycle limit_cycle(const SwayYawCoefficients<double>& ship, LinearZigzagOrder order,
                       std::size_t longest_reversals) {
  LimitCycle result{{}, false};
  order.longest = std::max(order.longest, 1e5);
  for (order.reversals = std::min<std::size_t>(longest_reversals, 40);;
       order.reversals = std::min(2 * order.reversals, longest_reversals)) {
    result.zigzag = linear_zigzag(ship, order);
    const auto& r = result.zigzag.reversals;
    if (r.size() < 3) return result;
    const auto &a = result.zigzag.legs[r[r.size() - 2].leg].start, &b = result.zigzag.legs[r.back().leg].start;
    const double scale = std::abs(b.beta) + std::abs(b.omega);
    result.settled = std::abs(a.beta + b.beta) + std::abs(a.omega + b.omega) < 1e-12 * scale;
    if (result.settled || r.size() < order.reversals || order.reversals == longest_reversals) return result;
  }
}

std::optional<LoopSensitivity> loop_sensitivity(const SteeringIndices<double>& i, const LinearZigzagOrder& order) {
  if (inverse_distance(i) == 0.0) throw std::domain_error("T3b and T3w are equal: no ship has these indices");
  using D = Dual<2>;
  const auto numbers = coefficients_from(i);
  const auto cycle = limit_cycle(numbers, order);
  if (!last_cycle(cycle.zigzag)) return std::nullopt;
  const SteeringIndices<D> varied{D(i.T1T2), D(i.T1_plus_T2), D(i.T3b, 0), D(i.T3w, 1), D(i.Kb), D(i.Kw)};
  const auto ship = coefficients_from(varied);
  const auto zigzag = carried_through(cycle.zigzag, ship, order);
  const auto loop = measures(ship, zigzag, numbers, cycle.zigzag);
  LoopSensitivity result{.value = part_of(loop, [](const D& x) { return x.a; }),
                         .by_T3b = part_of(loop, [](const D& x) { return x.v[0]; }),
                         .by_T3w = part_of(loop, [](const D& x) { return x.v[1]; }),
                         .settled = cycle.settled};
  for (const auto& r : zigzag.reversals) {
    result.overshoot.push_back(r.overshoot.a);
    result.overshoot_by_T3b.push_back(r.overshoot.v[0]);
    result.overshoot_by_T3w.push_back(r.overshoot.v[1]);
  }
  const D period = zigzag.period().value();
  result.period = period.a;
  result.period_by_T3b = period.v[0];
  result.period_by_T3w = period.v[1];
  return result;
}

}  // namespace swayaw::linear
