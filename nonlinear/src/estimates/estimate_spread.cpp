#include "swayaw/nonlinear/estimates/estimate_spread.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/estimates/clarke.hpp"
#include "swayaw/nonlinear/estimates/kijima.hpp"
#include "swayaw/nonlinear/published_ships.hpp"

namespace swayaw::inline nonlinear {
namespace {

constexpr std::string_view yoshimura = "Yoshimura and Masumoto", kijima = "Kijima", clarke = "Clarke", zhou = "Zhou";

/// What the formulas say, by key of the ship file.
class Formulas {
 public:
  void add(std::string_view formula, std::string_view key, double value) {
    values_[std::string(key)].push_back({formula, value});
  }

  template <class Part>
  void add_part(std::string_view formula, const Part& part) {
    for (const auto& p : Part::parameters())
      if (p.key != "R_0") add(formula, p.key, part.*p.member);
  }

  void add_interaction(std::string_view formula, const RudderInteraction<double>& i, bool with_race) {
    add(formula, "t_R", i.t_R);
    add(formula, "a_H", i.a_H);
    add(formula, "x_H_prime", i.x_H);
    add(formula, "l_R_prime", i.l_R);
    add(formula, "gamma_R_negative", i.gamma_R);
    add(formula, "gamma_R_positive", i.gamma_R);
    if (!with_race) return;
    add(formula, "epsilon", i.epsilon);
    add(formula, "kappa", i.kappa);
  }

  std::vector<FormulaValue> of(const std::string& key) const {
    const auto found = values_.find(key);
    return found == values_.end() ? std::vector<FormulaValue>{} : found->second;
  }

 private:
  std::map<std::string, std::vector<FormulaValue>> values_;
};

/// Kijima's epsilon, a parabola of the fullness, falls below this where hulls are finer or fuller than those behind it.
constexpr double least_epsilon = 0.5;

/// Clarke's regression: what is linear in sway and yaw, and two added masses. Surge is not of this source.
void add_clarke(Formulas& formulas, const HullDimensions<double>& hull, double m_x) {
  const auto c = clarke_derivatives(hull);
  const auto linear = mmg_linear_hull(c, hull, m_x);
  const auto added = mmg_added_mass(c, hull, m_x);
  formulas.add(clarke, "Y_v", linear.Y_v);
  formulas.add(clarke, "Y_r", linear.Y_r);
  formulas.add(clarke, "N_v", linear.N_v);
  formulas.add(clarke, "N_r", linear.N_r);
  formulas.add(clarke, "m_y", added.m_y);
  formulas.add(clarke, "J_z", added.J_z);
}

void add_kijima_hull(Formulas& formulas, const HullDimensions<double>& hull, const MmgAddedMass<double>& added) {
  const auto h = kijima_hull(hull, added);
  for (const auto& p : MmgHull<double>::parameters())
    if (p.key.starts_with("Y_") || p.key.starts_with("N_")) formulas.add(kijima, p.key, h.*p.member);
}

Formulas formulas_for(const HullDimensions<double>& hull, const MmgShip<double>& ship) {
  Formulas formulas;
  const auto added = zhou_added_mass(hull);
  const auto steady = yoshimura_masumoto_hull(hull, added, ship.particulars.x_G / hull.L);
  formulas.add_part(zhou, added);
  if (hull.trim == 0.0) formulas.add_part(yoshimura, steady);
  else
    for (const auto& p : MmgHull<double>::parameters())
      if (p.key.starts_with("X_")) formulas.add(yoshimura, p.key, steady.*p.member);
  add_kijima_hull(formulas, hull, added);
  if (hull.trim == 0.0) add_clarke(formulas, hull, added.m_x);
  const auto other = kijima_interaction(hull);
  formulas.add_interaction(yoshimura, yoshimura_masumoto_interaction(hull, ship.propeller.w_P0), true);
  formulas.add_interaction(kijima, other, other.epsilon >= least_epsilon);
  return formulas;
}

/// "kt" for "kt[0]".
std::string key_of(const Parameter& p) { return std::string(p.key.substr(0, p.key.find('['))); }

std::vector<Parameter> coefficients_of_model(const MmgShip<double>& model) {
  auto list = parameters_of(Ship{.name = {}, .model = model, .confidence = {}, .surroundings = {}});
  std::erase_if(list, [](const Parameter& p) { return p.role != Role::coefficient; });
  return list;
}

HullDimensions<double> dimensions_of(const MmgParticulars<double>& p) {
  return {.L = p.L, .B = p.B, .d = p.d, .C_B = p.nabla / (p.L * p.B * p.d)};
}

/// Measured less estimated, of every coefficient, for a ship whose coefficients are known.
std::vector<double> departures(const Ship& ship, HullFormula formula) {
  const auto& model = std::get<MmgShip<double>>(ship.model);
  const auto& p = model.particulars;
  const auto guess = estimated_mmg_ship(
      dimensions_of(p), p.U_0, {.hull = formula, .rho = model.water.rho, .x_G = p.x_G, .k_zz_prime = p.k_zz / p.L});
  const auto measured = coefficients_of_model(model), estimated = coefficients_of_model(guess.ship);
  std::vector<double> result;
  for (std::size_t i = 0; i < measured.size(); ++i) result.push_back(measured[i].value - estimated[i].value);
  return result;
}

double root_mean_square(const std::vector<double>& values) {
  if (values.empty()) return 0.0;
  double sum = 0.0;
  for (const double x : values) sum += x * x;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

bool same(double a, double b) { return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b)); }

/// What other formulas say less the value, each number once.
std::vector<double> other_numbers(const std::vector<FormulaValue>& formulas, double value) {
  std::vector<double> differences;
  for (const auto& f : formulas) {
    const double difference = f.value - value;
    const bool known = std::ranges::any_of(differences, [&](double d) { return same(d + value, f.value); });
    if (!same(f.value, value) && !known) differences.push_back(difference);
  }
  return differences;
}

bool is_given(const std::string& key, const EstimateOptions& o) {
  return (key == "wake_fraction" && o.wake_fraction) || (key == "thrust_deduction" && o.thrust_deduction) ||
         (key == "R_0" && o.resistance);
}

/// A second coefficient under one key, as of the list kt, or x_prime of propeller and rudder: the larger deviations
/// count.
void merge(CoefficientSpread& into, const CoefficientSpread& other) {
  into.between_formulas = std::max(into.between_formulas, other.between_formulas);
  into.from_measured = std::max(into.from_measured, other.from_measured);
}

}  // namespace

std::size_t CoefficientSpread::distinct() const {
  return formulas.empty() ? 0 : 1 + other_numbers(formulas, formulas.front().value).size();
}

double CoefficientSpread::relative() const {
  if (given) return trust_in_published;
  return std::clamp(std::max(between_formulas, from_measured), trust_in_published, least_trust);
}

std::vector<Ship> measured_ships() { return {published_ship("kvlcc2"), published_ship("kcs")}; }

std::vector<CoefficientSpread> estimate_spread(const HullDimensions<double>& hull, const EstimatedShip& estimate,
                                               const EstimateOptions& options, const std::vector<Ship>& measured) {
  const auto formulas = formulas_for(hull, estimate.ship);
  std::vector<std::vector<double>> errors;
  for (const auto& ship : measured) errors.push_back(departures(ship, options.hull));
  std::vector<CoefficientSpread> spread;
  const auto coefficients = coefficients_of_model(estimate.ship);
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    const double value = coefficients[i].value;
    std::vector<double> of_measured;
    for (const auto& list : errors) of_measured.push_back(list[i]);
    CoefficientSpread s{.key = key_of(coefficients[i]),
                        .value = value,
                        .formulas = {},
                        .between_formulas = 0.0,
                        .from_measured = root_mean_square(of_measured) / std::abs(value)};
    s.formulas = formulas.of(s.key);
    s.between_formulas = root_mean_square(other_numbers(s.formulas, value)) / std::abs(value);
    s.given = is_given(s.key, options);
    if (value == 0.0 || (s.formulas.empty() && s.from_measured == 0.0)) continue;
    const auto known = std::ranges::find(spread, s.key, &CoefficientSpread::key);
    if (known == spread.end()) spread.push_back(std::move(s));
    else merge(*known, s);
  }
  return spread;
}

Confidence confidence_of(const std::vector<CoefficientSpread>& spread) {
  Confidence confidence;
  for (const auto& s : spread)
    if (s.relative() != trust_in_published) confidence.named.emplace_back(s.key, s.relative());
  return confidence;
}

}  // namespace swayaw::nonlinear
