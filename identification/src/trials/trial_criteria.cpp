#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "swayaw/core/angle.hpp"
#include "trial_run.hpp"

namespace swayaw::inline identification {
namespace {

constexpr std::array<std::string_view, 6> steering_criteria{
    "initial_turning", "first_overshoot_10_10", "second_overshoot_10_10", "first_overshoot_20_20",
    "advance",         "tactical_diameter"};

std::optional<double> bare(const MaybeTold& x) { return x ? std::optional(x->value) : std::nullopt; }

/// The criterion with the standard error of its value.
JudgedCriterion with_error(const Criterion& c, const MaybeTold& told, double unit) {
  JudgedCriterion result{.name = c.name, .side = c.side, .value = {}, .limit = c.limit, .unit = c.unit, .pass = {}};
  if (!told) return result;
  result.value = Told{told->value / unit, told->standard_error / unit};
  result.pass = judged(*result.value, c.limit);
  return result;
}

const MaybeTold& told_by(const TrialResult& trial, std::string_view name) {
  static const MaybeTold nothing;
  if (trial.zigzag) {
    const auto& z = *trial.zigzag;
    if (name == "initial_turning") return z.initial_turning;
    const std::size_t which = name.starts_with("second") ? 1 : 0;
    return which < z.reversals.size() ? z.reversals[which].overshoot : nothing;
  }
  const auto& circle = trial.turn->corrected ? *trial.turn->corrected : trial.turn->recorded;
  if (name == "advance") return circle.advance;
  if (name == "tactical_diameter") return circle.tactical_diameter;
  return circle.initial_turning;
}

std::vector<Criterion> limits_of(const TrialResult& trial, double L, double U, double max_rudder) {
  if (trial.zigzag) {
    Zigzag z{};
    z.approach_speed = U;
    for (const auto& r : trial.zigzag->reversals) z.reversals.push_back({0.0, std::nullopt, bare(r.overshoot)});
    return criteria_of(z, {trial.manoeuvre.rudder, trial.manoeuvre.heading, trial.zigzag->first}, L);
  }
  if (!trial.turn) return {};
  TurningCircle circle{};
  circle.approach_speed = U;
  return criteria_of(circle, TurnOrder{trial.manoeuvre.rudder, trial.turn->side}, L, max_rudder);
}

std::string in_words(const JudgedCriterion& c) { return fmt::format("{} to {}", c.name, name_of(c.side)); }

}  // namespace

std::optional<bool> judged(const Told& value, double limit) {
  if (value.value + 2.0 * value.standard_error <= limit) return true;
  if (value.value - 2.0 * value.standard_error > limit) return false;
  return std::nullopt;
}

std::vector<JudgedCriterion> criteria_of(const TrialResult& trial, double L, double U, double max_rudder) {
  std::vector<JudgedCriterion> result;
  for (const auto& c : limits_of(trial, L, U, max_rudder))
    result.push_back(with_error(c, told_by(trial, c.name), c.unit == "L" ? L : radians(1.0)));
  return result;
}

ImoSummary summary_of(std::span<const TrialResult> trials) {
  ImoSummary summary;
  std::set<std::string_view> told;
  for (const auto& trial : trials) {
    for (const auto& c : trial.imo) {
      if (c.pass) summary.any = true;
      if (c.value) told.insert(c.name);
      if (!c.pass) summary.open.push_back(in_words(c));
      else if (!*c.pass) summary.failed.push_back(in_words(c));
    }
  }
  for (const auto name : steering_criteria)
    if (!told.contains(name)) summary.missing.emplace_back(name);
  return summary;
}

}  // namespace swayaw::identification
