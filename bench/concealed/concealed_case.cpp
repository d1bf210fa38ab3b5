#include "concealed_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "on_board_case.hpp"
#include "random_source.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/recording_csv.hpp"
#include "swayaw/nonlinear/ship_file.hpp"

namespace swayaw::concealed {
namespace {

constexpr double confidence = 0.02;  ///< that ship files state: coefficients of a model that was fitted with care

constexpr std::array severities{Severity::weak, Severity::moderate, Severity::strong};

std::vector<Manoeuvre> manoeuvres(TrialSet set, double heading) {
  switch (set) {
    case TrialSet::all_round:
      return {zigzag(10, 10, false, heading), zigzag(20, 20, true, heading + 1.9), turn(35, false, heading + 3.7)};
    case TrialSet::one_heading:
      return {zigzag(10, 10, false, heading), zigzag(20, 20, true, heading), zigzag(15, 15, false, heading)};
    case TrialSet::four_headings:
      return {zigzag(10, 10, false, heading), zigzag(20, 20, true, heading + 0.5 * pi),
              zigzag(10, 10, true, heading + pi), zigzag(20, 20, false, heading + 1.5 * pi)};
    case TrialSet::passage: {
      auto there = passage(heading, radians(10.0)), back = passage(heading + 2.5, radians(-8.0));
      back.name = "passage_back";
      return {there, back};
    }
  }
  return {};
}

std::vector<Recording> simulated(const TrueShip& truth, const Concealment& hidden, const std::vector<Manoeuvre>& runs,
                                 double noise, std::uint64_t seed) {
  std::vector<Recording> result;
  for (const auto& m : runs)
    result.push_back(simulate(truth, hidden, m, {.noise = noise, .seed = seed_of(seed, result.size())}));
  return result;
}

/// What the plans have in common: ship, noise, set, reference and baseline go round.
CasePlan plan_of(std::size_t index, std::uint64_t seed, std::vector<std::pair<std::string, Severity>> effects) {
  RandomSource random(seed_of(seed, index));
  constexpr std::array noises{1.0, 1.0, 3.0, 10.0};
  constexpr std::array sets{TrialSet::all_round,     TrialSet::all_round,     TrialSet::one_heading,
                            TrialSet::four_headings, TrialSet::four_headings, TrialSet::passage};
  CasePlan plan{.name = fmt::format("{:03}", index + 1),
                .ship_kind = std::string(ship_kinds()[index % 3]),
                .effects = std::move(effects),
                .seed = random.bits()};
  plan.noise = noises[random.below(noises.size())];
  plan.set = sets[random.below(sets.size())];
  plan.reference = random.below(2) == 0;
  plan.wrong_baseline = random.below(2) == 0;
  return plan;
}

using Effects = std::vector<std::pair<std::string, Severity>>;

Effects single(std::size_t i, std::span<const std::string_view> kinds) {
  return {{std::string(kinds[i % kinds.size()]), severities[2 - i / kinds.size() % 3]}};
}

Effects pair(RandomSource& random) {
  const auto kinds = known_kinds();
  const std::size_t a = random.below(kinds.size()), b = (a + 1 + random.below(kinds.size() - 1)) % kinds.size();
  const auto severity = [&] { return random.below(2) ? Severity::strong : Severity::moderate; };
  return {{std::string(kinds[a]), severity()}, {std::string(kinds[b]), severity()}};
}

}  // namespace

char letter_of(TrialSet set) { return "ABCD"[static_cast<std::size_t>(set)]; }

std::vector<CasePlan> plan_named(std::string_view name, std::size_t count, std::uint64_t seed) {
  const std::size_t singles = 3 * known_kinds().size(), unknowns = 3 * unknown_kinds().size();
  RandomSource random(seed_of(seed, 0xfa12));
  std::size_t alone = 0;
  const auto of_mix = [&](std::size_t i) -> Effects {
    const std::size_t place = i % 20;  // 5 clean, 11 singles, 2 pairs, 2 unknown, spread out
    if (place % 4 == 0) return {};
    if (place == 7 || place == 17) return pair(random);
    if (place == 3 || place == 13) return single((i / 20) * 2 + place / 13, unknown_kinds());
    return single(alone++, known_kinds());
  };
  std::vector<CasePlan> plans;
  const auto add = [&](std::size_t usual, auto effects) {
    for (std::size_t i = 0; i < (count > 0 ? count : usual); ++i) plans.push_back(plan_of(i, seed, effects(i)));
  };
  if (name == "clean") add(200, [](std::size_t) { return Effects{}; });
  else if (name == "singles") add(singles, [](std::size_t i) { return single(i, known_kinds()); });
  else if (name == "pairs") add(40, [&](std::size_t) { return pair(random); });
  else if (name == "unknown") add(unknowns, [](std::size_t i) { return single(i, unknown_kinds()); });
  else if (name == "all") add(200, of_mix);
  else if (name == "on_board_clean" || name == "on_board") return on_board_plans(name == "on_board", count, seed);
  else
    throw std::domain_error(fmt::format(
        "no plan \"{}\"; there are clean, singles, pairs, unknown, all, on_board_clean and on_board", name));
  return plans;
}

ConcealedCase made(const CasePlan& plan) {
  if (plan.on_board) return made_on_board(plan);
  RandomSource random(plan.seed);
  const auto truth = true_ship(plan.ship_kind, random.bits());
  const auto fair = fair_ship(truth, confidence);
  ConcealedCase c{
      .plan = plan, .ship = fair.ship, .train = {}, .holdout = {}, .reference = {}, .true_holdout = {}, .labels = {}};
  c.ship.name = fmt::format("{} {}", plan.ship_kind, plan.name);
  Concealment hidden;
  for (const auto& [kind, severity] : plan.effects)
    c.labels.push_back(conceal(hidden, kind, severity, truth, std::get<MmgShip<double>>(fair.ship.model), random));
  if (plan.wrong_baseline) c.ship = slightly_wrong(c.ship, random.bits());
  const double heading = random.uniform(0.0, 2.0 * pi);
  c.train = simulated(truth, hidden, manoeuvres(plan.set, heading), plan.noise, random.bits());
  const std::vector<Manoeuvre> held_out{zigzag(20, 10, true, heading + 1.0), turn(25, true, heading + 2.0)};
  const auto weather = random.bits();
  c.holdout = simulated(truth, hidden, held_out, plan.noise, weather);
  c.true_holdout = simulated(truth, hidden, held_out, 0.0, weather);
  if (plan.reference)
    c.reference = simulated(
        truth, {}, {zigzag(15, 10, true, heading), turn(30, true, heading + 2.2), zigzag(20, 15, false, heading + 4.4)},
        plan.noise, random.bits());
  c.truth = {{"ship", c.plan.ship_kind},
             {"noise", c.plan.noise},
             {"set", std::string(1, letter_of(c.plan.set))},
             {"reference", c.plan.reference},
             {"baseline_error", c.plan.wrong_baseline ? confidence : 0.0},
             {"seed", c.plan.seed}};
  return c;
}

void write_case(const ConcealedCase& c, const std::filesystem::path& folder) {
  using Json = nlohmann::ordered_json;
  const auto home = folder / c.plan.name;
  Json effects = Json::array();
  for (const auto& label : c.labels) {
    Json parameters = Json::object();
    for (const auto& n : label.parameters) parameters[n.key] = n.value;
    if (!label.channel.empty()) parameters["channel"] = label.channel;
    effects.push_back(
        {{"effect", label.effect}, {"level", name_of(label.severity)}, {"parameters", std::move(parameters)}});
    if (label.detectability) effects.back()["detectability"] = *label.detectability;
    if (label.replay_gain) effects.back()["replay_gain"] = *label.replay_gain;
  }
  Json truth{{"effects", effects}};
  truth.update(c.truth);
  const auto write_runs = [&](const char* part, const std::vector<Recording>& runs) {
    if (!runs.empty()) std::filesystem::create_directories(home / part);
    for (const auto& run : runs) write_recording(run, home / part / (run.name + ".csv"));
  };
  std::filesystem::create_directories(home);
  write_ship(home / "ship.toml", c.ship);
  write_runs("train", c.train), write_runs("holdout", c.holdout), write_runs("reference", c.reference),
      write_runs("truth", c.true_holdout);
  write_text(home / "truth.json", truth.dump(1) + "\n");
}

}  // namespace swayaw::concealed
