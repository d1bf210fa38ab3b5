#include "identify_linear.hpp"

#include <algorithm>
#include <cmath>

#include "checked_runs.hpp"
#include "identify_linear_page.hpp"
#include "input.hpp"
#include "json.hpp"
#include "page_writing.hpp"
#include "swayaw/core/followed_order.hpp"
#include "swayaw/core/version.hpp"
#include "swayaw/identification/linear_fit.hpp"
#include "terminal.hpp"

namespace swayaw::app {
namespace {

struct Particulars {
  std::string name;
  LinearParticulars<double> particulars;
  SteeringGear<double> gear;
  std::optional<SwayYawCoefficients<double>> before;  ///< nothing where the ship file does not tell them
};

/// Of a ship of forces at her service speed; nothing where she cannot sail it.
std::optional<SwayYawCoefficients<double>> coefficients_of(const AnyShip& any) {
  try {
    const auto* linear = std::get_if<LinearShip>(&any);
    if (linear != nullptr) return has_coefficients(*linear) ? std::optional(coefficients(*linear)) : std::nullopt;
    const auto& ship = std::get<Ship>(any);
    return coefficients(linear_ship(ship, linearize(ship, straight_course(ship, service_speed(ship)))));
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

Particulars particulars_of(const AnyShip& any) {
  if (const auto* linear = std::get_if<LinearShip>(&any))
    return {linear->name, linear->particulars, linear->steering_gear, coefficients_of(any)};
  const auto& ship = std::get<Ship>(any);
  return {ship.name, {length(ship), service_speed(ship)}, steering_gear(ship), coefficients_of(any)};
}

std::vector<LinearRow> rows_of(const LinearFit& fit) {
  const auto& m = fit.coefficients;
  const auto& i = fit.indices;
  return {{"a1", m.a1},   {"b1", m.b1},   {"c1", m.c1},     {"a2", m.a2},
          {"b2", m.b2},   {"c2", m.c2},   {"T1T2", i.T1T2}, {"T1_plus_T2", i.T1_plus_T2},
          {"T3b", i.T3b}, {"T3w", i.T3w}, {"Kb", i.Kb},     {"Kw", i.Kw}};
}

/// Verdict for motions of that size only.
std::string verdict_of(const LinearFit& fit) {
  const auto range = fmt::format("for motions up to r' = {:.2f}", fit.amplitude.omega);
  if (fit.stable && fit.probability_stable > 0.975) return "stable on a straight course, " + range;
  if (!fit.stable && fit.probability_stable < 0.025) return "unstable on a straight course, " + range;
  return fmt::format("stability not told (probability of stable {:.2f}), {}", fit.probability_stable, range);
}

LinearShip ship_of(const LinearFit& fit, const Particulars& p) {
  const auto& m = fit.coefficients;
  LinearShip ship{
      .name = p.name,
      .particulars = p.particulars,
      .steering_gear = p.gear,
      .form = SwayYawCoefficients<double>{m.a1.value, m.b1.value, m.c1.value, m.a2.value, m.b2.value, m.c2.value},
      .confidence = {}};
  for (const auto& row : rows_of(fit)) {
    if (ship.confidence.named.size() == 6) break;
    ship.confidence.named.emplace_back(row.name,
                                       std::min(10.0, row.estimate.standard_error / std::abs(row.estimate.value)));
  }
  return ship;
}

Json document_of(const LinearFit& fit, const Particulars& p, const std::vector<Recording>& runs) {
  Json coefficients = Json::array(), names = Json::array();
  for (const auto& row : rows_of(fit))
    coefficients.push_back({{"name", row.name},
                            {"value", number(row.estimate.value)},
                            {"standard_error", number(row.estimate.standard_error)},
                            {"verdict", in_words(row.estimate.verdict())}});
  for (const auto& run : runs) names.push_back(run.name);
  return {
      {"schema", "swayaw.identification/1"},
      {"version", version()},
      {"ship", p.name},
      {"model", "linear"},
      {"runs", std::move(names)},
      {"method", "prediction errors"},
      {"coefficients", std::move(coefficients)},
      {"condition_number", number(fit.condition_number)},
      {"stability",
       {{"stable", fit.stable}, {"probability_stable", number(fit.probability_stable)}, {"words", verdict_of(fit)}}}};
}

}  // namespace

void identify_linear(const IdentifyArguments& a) {
  const auto p = particulars_of(load_ship(a.ship));
  if (!a.holdout.empty())
    say_aside("swayaw: --holdout has no use with --model linear, whose standard errors hold by themselves\n");
  auto runs = checked_runs(a.runs, a.reading);
  for (auto& run : runs) run = with_followed_order(std::move(run), p.gear);
  for (const auto& run : runs)
    if (run.has(Channel::wind_speed))
      say_aside("swayaw: {}: the measured wind is not used: a linear ship has no place for it\n", run.name);
  const auto fit = fit_linear(runs, {.L = p.particulars.L});
  if (!std::isfinite(fit.coefficients.a1.value))
    throw Refusal(
        "the runs do not tell drift (u and v), without which only the yaw equation shows; a linear ship file needs "
        "both");
  if (!a.out.empty())
    write_linear_ship(a.out, ship_of(fit, p),
                      fmt::format("Identified by swayaw {}: {}.\n[confidence] holds the relative standard errors.",
                                  version(), verdict_of(fit)));
  if (a.json) print_document(document_of(fit, p, runs));
  else {
    say("{}\n  {:<12}{:>12}{:>12}\n", p.name, "", "found", "std error");
    for (const auto& [name, e] : rows_of(fit))
      say("  {:<12}{:>12.5g}{:>12.2g}  {}\n", name, e.value, e.standard_error, in_words(e.verdict()));
    say("{}\n", verdict_of(fit));
  }
  if (a.report.wanted())
    write_page(a.report.file,
               html(linear_page({p.name, fit, rows_of(fit), p.before, p.particulars.L, verdict_of(fit)}, runs, a)));
  if (!a.out.empty()) say_aside("swayaw: ship file written to {}\n", a.out.string());
}

}  // namespace swayaw::app
