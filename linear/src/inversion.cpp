#include "swayaw/linear/inversion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "by_logarithm.hpp"
#include "lifted.hpp"
#include "swayaw/core/refusal.hpp"

namespace swayaw::inline linear {
using namespace detail;
namespace {

constexpr std::array<KnownPart, 5> all_known{KnownPart::Y_b, KnownPart::Y_w, KnownPart::N_b, KnownPart::N_w,
                                             KnownPart::c_Ry};

/// The known number of a ship.
template <class S>
S& known_number(LinearParts<S>& ship, KnownPart known) {
  switch (known) {
    case KnownPart::Y_b: return ship.hull.Y_b;
    case KnownPart::Y_w: return ship.hull.Y_w;
    case KnownPart::N_b: return ship.hull.N_b;
    case KnownPart::N_w: return ship.hull.N_w;
    case KnownPart::c_Ry: break;
  }
  return ship.rudder.c_Ry;
}

template <class S>
std::array<S, 5> closed_by_known(const LinearParts<S>& ship) {
  return {ship.hull.Y_b, ship.hull.Y_w, ship.hull.N_b, ship.hull.N_w, ship.rudder.c_Ry};
}

// ---------------------------------------------------------------- indices in duals

using D = Dual<9>;  ///< derivatives by the logarithms of `inversion_inputs`

SteeringIndices<D> varied(const SteeringIndices<double>& i) {
  SteeringIndices<D> d{D(i.T1T2), D(i.T1_plus_T2), D(i.T3b), D(i.T3w), D(i.Kb), D(i.Kw)};
  // d(T1 T2)/d ln(T1) = T1 T2, d(T1 + T2)/d ln(T1) = T1; a complex pair has no T1
  const auto pair = time_constants(transfer_functions(i));
  const double none = std::numeric_limits<double>::quiet_NaN();
  d.T1T2.v[0] = d.T1T2.v[1] = d.T1T2.v[2] = i.T1T2;
  d.T1_plus_T2.v[0] = pair ? pair->T1 : none;
  d.T1_plus_T2.v[1] = pair ? pair->T2 : none;
  d.T1_plus_T2.v[3] = i.T1_plus_T2;
  d.T3b.v[4] = i.T3b;
  d.T3w.v[5] = i.T3w;
  d.Kb.v[6] = i.Kb;
  d.Kw.v[7] = i.Kw;
  return d;
}

/// The coefficients in duals: values as they are, derivatives through the inverse formulas.
SwayYawCoefficients<D> varied(const SwayYawCoefficients<double>& m, const SteeringIndices<double>& i) {
  auto d = coefficients_from(varied(i));
  d.a1.a = m.a1, d.b1.a = m.b1, d.c1.a = m.c1;
  d.a2.a = m.a2, d.b2.a = m.b2, d.c2.a = m.c2;
  for (D* x : {&d.a1, &d.b1, &d.c1, &d.a2, &d.b2, &d.c2}) x->v[8] = 0.0;  // not 0 times an infinite index
  return d;
}

InvertedNumber inverted_number(std::string_view name, const D& x) {
  InvertedNumber number{name, x.a, {}};
  const double none = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t k = 0; k < number.elasticity.size(); ++k)
    number.elasticity[k] = x.a == 0.0 ? none : x.v[static_cast<int>(k)] / x.a;
  return number;
}

std::array<InvertedNumber, 6> numbers(const SwayYawCoefficients<D>& m) {
  return {inverted_number("a1", m.a1), inverted_number("b1", m.b1), inverted_number("c1", m.c1),
          inverted_number("a2", m.a2), inverted_number("b2", m.b2), inverted_number("c2", m.c2)};
}

std::array<InvertedNumber, 7> numbers(const LinearParts<D>& ship) {
  const auto& [h, r] = ship;
  return {inverted_number("a_H", r.a_H),
          inverted_number("c_Ry", r.c_Ry),
          inverted_number("x_R_eff_prime", r.x_Reff),
          inverted_number("Y_b_per_deg", h.Y_b),
          inverted_number("Y_w", h.Y_w),
          inverted_number("N_b_per_deg", h.N_b),
          inverted_number("N_w", h.N_w)};
}

void require_rudder_effect(const SwayYawCoefficients<double>& m) {
  if (m.c1 == 0.0) throw Refusal("c1 is 0: a rudder without sway force tells neither a_H nor x_R_eff_prime");
}

LinearParts<double> require_finite(const LinearParts<double>& ship, KnownPart known) {
  const auto found = closed_by_known(ship);
  if (std::ranges::all_of(found, [](double x) { return std::isfinite(x); })) return ship;
  throw Refusal(fmt::format("{} does not determine c_Ry of this ship: the rudder has no part in it", name_of(known)));
}

// ---------------------------------------------------------------- which number to know

/// Derivatives by the logarithms of a1 … c2 and the known number.
KnownCondition condition_of(const SwayYawCoefficients<double>& m, const LinearParts<double>& formal, KnownPart known) {
  auto ship = lifted<Dual<7>>(formal);
  auto& number = known_number(ship, known);
  number = by_logarithm<7>(number.a, 6);
  KnownCondition condition{known, 0.0, 0.0};
  for (const auto& result : closed_by_known(parts_from(by_logarithms<7>(m), ship, known))) {
    const auto elasticity = (result.v / result.a).eval();
    if (!elasticity.allFinite())
      return {known, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    condition.by_known = std::max(condition.by_known, std::abs(elasticity[6]));
    condition.worst = std::max(condition.worst, elasticity.norm());
  }
  return condition;
}

}  // namespace

std::array<InvertedNumber, 6> inverted_coefficients(const SwayYawCoefficients<double>& m,
                                                    const SteeringIndices<double>& indices) {
  return numbers(varied(m, indices));
}

Inversion inverted(const SwayYawCoefficients<double>& m, const SteeringIndices<double>& indices,
                   const LinearParts<double>& formal, KnownPart known) {
  require_rudder_effect(m);
  const auto coefficients = varied(m, indices);
  auto ship = lifted<D>(formal);
  auto& number = known_number(ship, known);
  number.v[8] = number.a;
  const auto found = parts_from(coefficients, ship, known);
  return {numbers(coefficients), numbers(found), require_finite(parts_from(m, formal, known), known)};
}

std::array<KnownCondition, 5> known_conditions(const SwayYawCoefficients<double>& m,
                                               const LinearParts<double>& formal) {
  std::array<KnownCondition, 5> conditions{};
  for (std::size_t k = 0; k < all_known.size(); ++k) conditions[k] = condition_of(m, formal, all_known[k]);
  return conditions;
}

KnownPart best_known(const std::array<KnownCondition, 5>& conditions) {
  return std::ranges::min_element(conditions, {}, &KnownCondition::worst)->known;
}

std::string_view name_of(KnownPart known) {
  constexpr std::array<std::string_view, 5> names{"Y_b", "Y_w", "N_b", "N_w", "c_Ry"};
  return names[static_cast<std::size_t>(known)];
}

}  // namespace swayaw::linear
