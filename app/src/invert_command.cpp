#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "commands.hpp"
#include "input.hpp"
#include "linear_output.hpp"
#include "swayaw/linear/inversion.hpp"
#include "swayaw/linear/uncertainty.hpp"
#include "terminal.hpp"

namespace swayaw::app {
namespace {

constexpr double near_equal = 0.05;  ///< inverse_distance below which the inverse is warned of

KnownPart known_named(const std::string& name) {
  for (const auto known : {KnownPart::Y_b, KnownPart::Y_w, KnownPart::N_b, KnownPart::N_w})
    if (name_of(known) == name) return known;
  return KnownPart::c_Ry;
}

/// What was asked.
struct Question {
  LinearShip ship;
  std::optional<LinearParts<double>> formal;  ///< where the parameters that do not follow come from
  KnownPart known;
};

/// @throws Refusal
std::optional<LinearParts<double>> formal_parts(const LinearShip& ship, const InvertArguments& a) {
  if (a.parts.empty()) {
    const auto* own = parts(ship);
    if (!own && !a.known.empty())
      throw Refusal("--known needs a ship with [hull] and [rudder] for the other numbers; name one with --parts");
    return own ? std::optional(*own) : std::nullopt;
  }
  const auto other = load_linear_ship(a.parts);
  const auto* given = parts(other);
  if (!given)
    throw Refusal(fmt::format("{}: has no [hull]; --parts needs a ship given by hull and rudder", a.parts.string()));
  return *given;
}

/// How sure the results are when the indices are as sure as [confidence] says.
struct Certainty {
  double separation;  ///< T3b − T3w in standard errors
  CoefficientCovariance coefficients;
  SampledCoefficients sampled;
  std::optional<PartCovariance> parts;
  std::optional<SampledParts> sampled_parts;
  std::optional<std::string> warning;
};

/// Nothing for ships that are not given by indices.
std::optional<Certainty> certainty_of(const Question& q) {
  const auto* i = std::get_if<SteeringIndices<double>>(&q.ship.form);
  if (!i) return std::nullopt;
  const auto covariance = covariance_of(*i, q.ship.confidence);
  Certainty certainty{separation(*i, covariance),
                      coefficient_covariance(*i, covariance),
                      sample_coefficients(*i, covariance),
                      {},
                      {},
                      separation_warning(*i, covariance)};
  if (!q.formal) return certainty;
  certainty.parts = part_covariance(*i, covariance, *q.formal, q.known);
  certainty.sampled_parts = sample_parts(*i, covariance, *q.formal, q.known);
  return certainty;
}

struct Answer {
  SteeringIndices<double> indices;
  std::array<InvertedNumber, 6> coefficients;
  double condition_number;
  std::optional<Inversion> parts;
  std::array<KnownCondition, 5> conditions;  ///< only with parts
  std::optional<Certainty> certainty;
};

Answer answer_of(const Question& q) {
  const auto m = coefficients(q.ship);
  const auto i = indices(q.ship);
  Answer answer{i, inverted_coefficients(m, i), condition_number(m), {}, {}, certainty_of(q)};
  if (q.formal) {
    answer.parts = inverted(m, i, *q.formal, q.known);
    answer.conditions = known_conditions(m, *q.formal);
  }
  return answer;
}

std::vector<std::string> warnings_of(const Answer& answer) {
  std::vector<std::string> warnings;
  if (answer.certainty && answer.certainty->warning) warnings.push_back(*answer.certainty->warning);
  const double distance = inverse_distance(answer.indices);
  if (!(distance < near_equal)) return warnings;
  warnings.push_back(
      fmt::format("T3b and T3w are near each other ({:.2g} of their sum apart): a1, b1, a2 and b2 change by {:.0f} "
                  "times any relative error in them",
                  distance, 0.5 / distance));
  return warnings;
}

// ---------------------------------------------------------------- JSON

Json values_json(std::span<const InvertedNumber> parameters) {
  Json json = Json::object();
  for (const auto& n : parameters) json[std::string(n.name)] = number(n.value);
  return json;
}

void add_elasticities(Json& json, std::span<const InvertedNumber> parameters, std::size_t inputs) {
  for (const auto& n : parameters)
    for (std::size_t k = 0; k < inputs; ++k)
      json[std::string(n.name)][std::string(inversion_inputs[k])] = number(n.elasticity[k]);
}

Json condition_json(const Answer& answer) {
  Json json{{"inverse_distance", number(inverse_distance(answer.indices))},
            {"condition_number", number(answer.condition_number)}};
  if (!answer.parts) return json;
  for (const auto& c : answer.conditions)
    json["known"][std::string(name_of(c.known))] = {{"by_known", number(c.by_known)}, {"worst", number(c.worst)}};
  json["best_known"] = name_of(best_known(answer.conditions));
  return json;
}

Json certainty_json(const Answer& answer) {
  if (!answer.certainty) return nullptr;
  const auto& c = *answer.certainty;
  Json json{{"separation", number(c.separation)}, {"sign_changes", number(c.sampled.crossed)}};
  for (int k = 0; k < 6; ++k) {
    const std::string name(answer.coefficients[static_cast<std::size_t>(k)].name);
    json["standard_error"][name] = number(std::sqrt(c.coefficients(k, k)));
    json["interval_95"][name] = {number(c.sampled.low[k]), number(c.sampled.high[k])};
  }
  if (!c.parts) return json;
  for (int k = 0; k < 7; ++k) {
    const std::string name(answer.parts->parts[static_cast<std::size_t>(k)].name);
    json["standard_error"][name] = number(std::sqrt((*c.parts)(k, k)));
    json["interval_95"][name] = {number(c.sampled_parts->low[k]), number(c.sampled_parts->high[k])};
  }
  return json;
}

Json document_of(const Question& q, const Answer& answer) {
  Json elasticity = Json::object();
  add_elasticities(elasticity, answer.coefficients, inversion_inputs.size() - 1);
  if (answer.parts) add_elasticities(elasticity, answer.parts->parts, inversion_inputs.size());
  return {{"schema", "swayaw.inversion/1"},
          {"ship", q.ship.name},
          {"given", form_words(q.ship)},
          {"coefficients", values_json(answer.coefficients)},
          {"parts", answer.parts ? values_json(answer.parts->parts) : Json(nullptr)},
          {"known", answer.parts ? Json(name_of(q.known)) : Json(nullptr)},
          {"elasticity", std::move(elasticity)},
          {"uncertainty", certainty_json(answer)},
          {"condition", condition_json(answer)},
          {"warnings", warnings_of(answer)}};
}

// ---------------------------------------------------------------- text

/// Three digits of an elasticity in a narrow column.
std::string elasticity_cell(double x) {
  if (!std::isfinite(x)) return "-";
  return fmt::format("{:.{}f}", x, std::abs(x) < 9.995 ? 2 : std::abs(x) < 99.95 ? 1 : 0);
}

/// "T1+T2" of "T1_plus_T2".
std::string heading_of(std::string_view input) {
  constexpr std::string_view plus = "_plus_";
  std::string name(input);
  if (const auto at = name.find(plus); at != std::string::npos) name.replace(at, plus.size(), "+");
  return name;
}

void print_numbers(std::span<const InvertedNumber> parameters, std::size_t inputs) {
  say("  {:<14}{:>10}  change in % per % of\n  {:<14}{:>10}", "", "", "", "value");
  for (std::size_t k = 0; k < inputs; ++k) say("{:>6}", heading_of(inversion_inputs[k]));
  say("\n");
  for (const auto& n : parameters) {
    say("  {:<14}{:>10}", n.name, cell(n.value));
    for (std::size_t k = 0; k < inputs; ++k) say("{:>6}", elasticity_cell(n.elasticity[k]));
    say("\n");
  }
}

void print_certainty(const Answer& answer, const Confidence& confidence) {
  const auto& c = *answer.certainty;
  say("\nWith the indices known to {:g} % ([confidence]; T3b and T3w are {:.1f} standard errors apart)\n",
      100.0 * confidence.coefficients, c.separation);
  say("  {:<14}{:>12}{:>16}{:>28}\n", "", "value", "standard error", "95 % of samples within");
  const auto print_row = [](const InvertedNumber& n, double variance, double low, double high) {
    say("  {:<14}{:>12}{:>16}{:>28}\n", n.name, cell(n.value), cell(std::sqrt(variance)),
        fmt::format("{} to {}", cell(low), cell(high)));
  };
  for (int k = 0; k < 6; ++k)
    print_row(answer.coefficients[static_cast<std::size_t>(k)], c.coefficients(k, k), c.sampled.low[k],
              c.sampled.high[k]);
  if (!c.parts) return;
  for (int k = 0; k < 7; ++k)
    print_row(answer.parts->parts[static_cast<std::size_t>(k)], (*c.parts)(k, k), c.sampled_parts->low[k],
              c.sampled_parts->high[k]);
}

void print_conditions(const Answer& answer) {
  say("\n  which number to know     % per % of it   worst for 1 % in a1 ... c2 and it\n");
  for (const auto& c : answer.conditions)
    say("  {:<14}{:>24}{:>20}\n", name_of(c.known), cell(c.by_known), cell(c.worst));
  say("Best conditioned: {}.\n", name_of(best_known(answer.conditions)));
}

void print_text(const Question& q, const Answer& answer) {
  say("{}: given by {}\n\nCoefficients\n", q.ship.name, form_words(q.ship));
  print_numbers(answer.coefficients, inversion_inputs.size() - 1);
  say("Condition number of the indices by the coefficients: {}\n", cell(answer.condition_number));
  if (answer.parts) {
    say("\nHull and rudder, {} known\n", name_of(q.known));
    print_numbers(answer.parts->parts, inversion_inputs.size());
    print_conditions(answer);
  }
  if (answer.certainty) print_certainty(answer, q.ship.confidence);
}

}  // namespace

void invert(const InvertArguments& a) {
  auto ship = load_linear_ship(a.ship);
  const auto formal = formal_parts(ship, a);
  const Question question{std::move(ship), formal, known_named(a.known)};
  const auto answer = answer_of(question);
  for (const auto& warning : warnings_of(answer)) say_aside("swayaw: {}\n", warning);
  if (a.json) print_document(document_of(question, answer));
  else print_text(question, answer);
}

}  // namespace swayaw::app
