#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/refusal.hpp"
#include "trial_run.hpp"

namespace swayaw::inline identification {

std::string_view name_of(TrialKind kind) {
  switch (kind) {
    case TrialKind::zigzag: return "zigzag";
    case TrialKind::turn: return "turn";
    case TrialKind::spiral: return "spiral";
    case TrialKind::steady: return "steady run";
  }
  return {};
}

std::string_view in_words(SpeedSource source) {
  switch (source) {
    case SpeedSource::none: return "not recorded";
    case SpeedSource::given: return "as given";
    case SpeedSource::log: return "ahead through the water";
    case SpeedSource::water: return "through the water";
    case SpeedSource::ground: return "over ground";
    case SpeedSource::positions: return "over ground, from the positions";
  }
  return {};
}

namespace detail {
namespace {

// A rudder that moves less, or a heading that changes less, is helm on a straight course.
constexpr double still_rudder = radians(2.0), straight_heading = radians(5.0);

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// Numbers of a text in their order, without sign.
std::vector<double> numbers_in(const std::string& text) {
  std::vector<double> result;
  for (const char* p = text.c_str(); *p != '\0';) {
    char* end = nullptr;
    if (std::isdigit(static_cast<unsigned char>(*p)) == 0) {
      ++p;
      continue;
    }
    result.push_back(std::strtod(p, &end));
    p = end;
  }
  return result;
}

double range_of(const Samples& s) {
  const auto [low, high] = std::ranges::minmax(s.value);
  return high - low;
}

/// The angle that was meant: a multiple of 5 deg within 15 % of it, else the nearest whole degree.
double to_degree(double angle) {
  const double five = 5.0 * std::round(degrees(angle) / 5.0);
  return radians(std::abs(degrees(angle) - five) < 0.15 * five ? five : std::round(degrees(angle)));
}

/// Median size of the angles held on either side.
double held_rudder(const TrialRun& run) {
  std::vector<double> levels;
  for (const auto& leg : run.legs)
    if (leg.sign != 0.0) levels.push_back(std::abs(leg.level - run.rudder_before));
  if (levels.empty()) return run.largest;
  std::ranges::sort(levels);
  return levels[levels.size() / 2];
}

/// Mean size of the heading off the approach when the rudder begins to go back.
double switch_heading(const TrialRun& run) {
  const auto approach = approach_of(run, {});
  double sum = 0.0, count = 0.0;
  const auto moves = moves_of(run);
  for (std::size_t k = 1; k < moves.size(); ++k) {
    const auto psi = value_at(run.psi, moves[k].start.value);
    if (!psi || run.legs[k].sign * run.legs[k + 1].sign >= 0.0) continue;
    sum += std::abs(psi->value - approach.heading.value);
    count += 1.0;
  }
  return count > 0.0 ? sum / count : 0.0;
}

TrialManoeuvre zigzag_named(const TrialRun& run, const std::vector<double>& numbers) {
  const bool said = numbers.size() >= 2 && numbers[0] > 0.0 && numbers[1] > 0.0;
  const double D = said ? radians(numbers[0]) : to_degree(held_rudder(run)),
               H = said ? radians(numbers[1]) : to_degree(switch_heading(run));
  if (!(H > 0.0 && H < radians(90.0)))
    throw Refusal(
        fmt::format("{}: a zigzag whose heading cannot be told; write # manoeuvre = \"zigzag 10/10\" above the "
                    "header row",
                    run.recording->name));
  return {TrialKind::zigzag, D, H, said, fmt::format("zigzag {:.6g}/{:.6g}", degrees(D), degrees(H))};
}

TrialManoeuvre turn_named(const TrialRun& run, const std::vector<double>& numbers) {
  const bool said = !numbers.empty() && numbers[0] > 0.0 && numbers[0] < 90.0;
  const double D = said ? radians(numbers[0]) : to_degree(held_rudder(run));
  return {TrialKind::turn, D, 0.0, said, fmt::format("turn {:.6g}", degrees(D))};
}

[[noreturn]] void refuse_still(const TrialRun& run, std::string_view what) {
  throw Refusal(fmt::format("{}: the rudder moves by no more than {:.1f} deg: no {} to judge; is it the right column?",
                            run.recording->name, degrees(range_of(run.delta)), what));
}

std::optional<TrialManoeuvre> said(const TrialRun& run) {
  const std::string text = lower(run.recording->facts.manoeuvre);
  const auto has = [&](const char* word) { return text.find(word) != std::string::npos; };
  const bool still = run.largest < still_rudder;
  if (has("zig"))
    return still ? (refuse_still(run, "zigzag"), std::nullopt) : std::optional(zigzag_named(run, numbers_in(text)));
  if (has("spiral")) return TrialManoeuvre{TrialKind::spiral, to_degree(run.largest), 0.0, true, "spiral"};
  if (has("turn") || has("circle") || has("pull"))
    return still ? (refuse_still(run, "turn"), std::nullopt) : std::optional(turn_named(run, numbers_in(text)));
  if (has("straight") || has("steady") || has("speed run"))
    return TrialManoeuvre{TrialKind::steady, 0.0, 0.0, true, "steady run"};
  return std::nullopt;
}

bool reverses(const TrialRun& run) {
  int changes = 0;
  for (std::size_t k = 1; k < run.legs.size(); ++k) changes += run.legs[k].sign * run.legs[k - 1].sign < 0.0;
  return changes >= 2 || (changes == 1 && range_of(run.psi) < radians(90.0));
}

/// How many rudder angles are held, more than 2 deg apart: a zigzag or a turn has three at most.
std::size_t angles_held(const TrialRun& run) {
  std::vector<double> angles;
  for (const auto& step : held_steps(run)) angles.push_back(step.delta);
  std::ranges::sort(angles);
  std::size_t count = angles.empty() ? 0 : 1;
  for (std::size_t i = 1; i < angles.size(); ++i) count += angles[i] - angles[i - 1] > still_rudder ? 1 : 0;
  return count;
}

}  // namespace

TrialManoeuvre manoeuvre_of(const TrialRun& run) {
  if (const auto told = said(run)) return *told;
  if (run.largest < still_rudder || range_of(run.psi) < radians(3.0)) {
    if (range_of(run.psi) < straight_heading) return {TrialKind::steady, 0.0, 0.0, false, "steady run"};
    refuse_still(run, "manoeuvre");
  }
  if (angles_held(run) >= 5) return {TrialKind::spiral, to_degree(run.largest), 0.0, false, "spiral"};
  if (reverses(run)) return zigzag_named(run, {});
  const auto turning = std::ranges::find_if(run.legs, [](const RudderLeg& leg) { return leg.sign != 0.0; });
  if (turning != run.legs.end() && range_of(run.psi) >= radians(90.0)) return turn_named(run, {});
  throw Refusal(
      fmt::format("{}: which manoeuvre this is cannot be told: the heading changes by {:.0f} deg, the rudder "
                  "is put over {} times; write # manoeuvre = \"zigzag 10/10\" or \"turn 35\" above the header row",
                  run.recording->name, degrees(range_of(run.psi)), run.legs.size() - 1));
}

}  // namespace detail
}  // namespace swayaw::identification
