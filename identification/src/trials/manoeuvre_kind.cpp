#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/manoeuvres_in.hpp"
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
std::vector<double> numbers_in(std::string_view part) {
  const std::string text(part);
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

[[noreturn]] void refuse_still(const TrialRun& run, std::string_view what) {
  throw Refusal(fmt::format("{}: the rudder moves by no more than {:.1f} deg: no {} to judge; is it the right column?",
                            run.recording->name, degrees(range_of(run.delta)), what));
}

/// What the words of a manoeuvre say: "zigzag 10/10", "turn 35", "pull-out 20", "spiral", "steady run" and the like.
struct Words {
  TrialKind kind;
  std::vector<double> angles;  ///< [deg]

  bool complete() const {
    const auto usual = [](double angle) { return angle > 0.0 && angle < 90.0; };
    const std::size_t needed = kind == TrialKind::zigzag ? 2 : kind == TrialKind::turn ? 1 : 0;
    return angles.size() >= needed && std::all_of(angles.begin(), angles.begin() + static_cast<long>(needed), usual);
  }
};

/// Angles stand behind the word, "turn 35" and "2_turn35_s", or before it, "20 deg turn" and "10/10 zigzag".
Words with_angles(TrialKind kind, std::string_view text, std::size_t word) {
  Words behind{kind, numbers_in(text.substr(word))}, before{kind, numbers_in(text.substr(0, word))};
  return before.complete() && !behind.complete() ? before : behind;
}

std::optional<Words> words_of(const std::string& manoeuvre) {
  const std::string text = lower(manoeuvre);
  const auto has = [&](const char* word) { return text.find(word) != std::string::npos; };
  if (const auto word = text.find("zig"); word != std::string::npos) return with_angles(TrialKind::zigzag, text, word);
  if (has("spiral")) return Words{TrialKind::spiral, {}};
  for (const auto* name : {"turn", "circle", "pull"})
    if (const auto word = text.find(name); word != std::string::npos) return with_angles(TrialKind::turn, text, word);
  if (has("straight") || has("steady") || has("speed run")) return Words{TrialKind::steady, {}};
  return std::nullopt;
}

/// Whether words tell angles. One number may be that of the run: that of a turn counts where the rudder went within
/// half and twice as far.
bool tells_angles(const Words& words, double largest_rudder) {
  if (words.kind != TrialKind::turn || !words.complete()) return words.complete();
  const double share = radians(words.angles.front()) / largest_rudder;
  return 0.5 < share && share < 2.0;
}

/// The manoeuvre that the recording holds, the longest if there are more.
std::optional<Words> found_in(const Recording& run) {
  const auto pieces = manoeuvres_in(run);
  const auto sailed = [](const ManoeuvrePiece& piece) { return piece.execute ? piece.end - *piece.execute : 0.0; };
  const auto longest = std::ranges::max_element(pieces, {}, sailed);
  return longest == pieces.end() ? std::nullopt : words_of(longest->manoeuvre);
}

/// To the whole degree.
double to_degree(double angle) { return radians(std::round(degrees(angle))); }

TrialManoeuvre manoeuvre_named(const TrialRun& run, const Words& words, bool said) {
  const auto angle = [&](std::size_t k) { return words.angles[k]; };
  switch (words.kind) {
    case TrialKind::zigzag:
      return {words.kind, radians(angle(0)), radians(angle(1)), said,
              fmt::format("zigzag {:.6g}/{:.6g}", angle(0), angle(1))};
    case TrialKind::turn: return {words.kind, radians(angle(0)), 0.0, said, fmt::format("turn {:.6g}", angle(0))};
    case TrialKind::spiral: return {words.kind, to_degree(run.largest), 0.0, said, "spiral"};
    case TrialKind::steady: break;
  }
  return {TrialKind::steady, 0.0, 0.0, said, "steady run"};
}

[[noreturn]] void refuse_untold(const TrialRun& run) {
  throw Refusal(
      fmt::format("{}: which manoeuvre this is cannot be told: the heading changes by {:.0f} deg, the rudder "
                  "is put over {} times; write # manoeuvre = \"zigzag 10/10\" or \"turn 35\" above the header row",
                  run.recording->name, degrees(range_of(run.psi)), run.legs.size() - 1));
}

}  // namespace

std::optional<double> zigzag_rudder(const Recording& run) {
  auto words = words_of(run.facts.manoeuvre);
  if (!words || (words->kind == TrialKind::zigzag && !words->complete())) words = found_in(run);
  if (!words || words->kind != TrialKind::zigzag || !words->complete()) return std::nullopt;
  return radians(words->angles[0]);
}

TrialManoeuvre manoeuvre_of(const TrialRun& run) {
  const auto told = words_of(run.recording->facts.manoeuvre);
  const bool steered = !told || told->kind == TrialKind::zigzag || told->kind == TrialKind::turn;
  if (!told && run.largest < still_rudder && range_of(run.psi) < straight_heading)
    return manoeuvre_named(run, {TrialKind::steady, {}}, false);
  if (steered && run.largest < still_rudder) refuse_still(run, told ? name_of(told->kind) : "manoeuvre");
  if (told && tells_angles(*told, run.largest)) return manoeuvre_named(run, *told, true);
  const auto found = found_in(*run.recording);
  if (found && (!told || found->kind == told->kind)) return manoeuvre_named(run, *found, false);
  if (told && told->kind == TrialKind::turn)
    return manoeuvre_named(run, {TrialKind::turn, {degrees(to_degree(run.largest))}}, false);
  refuse_untold(run);
}

}  // namespace detail
}  // namespace swayaw::identification
