#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fair_ship.hpp"
#include "sea_trial.hpp"
#include "swayaw/nonlinear/models/mmg/mmg_ship.hpp"

/// Cases whose truth is known here and hidden from whoever gets the recordings.
namespace swayaw::concealed {

class RandomSource;

enum class Severity { weak, moderate, strong };
std::string_view name_of(Severity severity);

/// A number of what is hidden, by its key in docs/effects.md.
struct LabelNumber {
  std::string key;
  double value;
};

/// What is hidden, as truth.json tells it.
struct Label {
  std::string effect;
  Severity severity;
  std::vector<LabelNumber> parameters;
  std::string channel;                       ///< of a delay
  std::optional<double> detectability = {};  ///< on board: see detectability()
  std::optional<double> replay_gain = {};    ///< on board: see replay_gain()
};

/// Every effect of swayaw that is made here, and the kinds that it does not know, "unknown_…".
std::span<const std::string_view> known_kinds();
std::span<const std::string_view> unknown_kinds();

/// Those of them that are hidden from instruments as on board.
std::span<const std::string_view> on_board_kinds();
std::span<const std::string_view> on_board_unknown_kinds();

/// Hides an effect in a ship. Parameters that replace coefficients are counted from those of the ship file.
/// @throws std::domain_error  for a kind that is not made here
Label conceal(Concealment& hidden, std::string_view kind, Severity severity, const TrueShip& truth,
              const MmgShip<double>& file, RandomSource& random);

/// The same with any size: level 0 is weak, 1 moderate, 2 strong, sizes between and beyond go in equal ratios. The
/// severity of the label is left to the caller.
Label conceal(Concealment& hidden, std::string_view kind, double level, const TrueShip& truth,
              const MmgShip<double>& file, RandomSource& random);

/// What is sailed to find it.
enum class TrialSet {
  all_round,      ///< A: zigzags 10/10 and 20/20 and a turn with 35 deg, on different headings
  one_heading,    ///< B: zigzags on one heading
  four_headings,  ///< C: zigzags on four headings
  passage,        ///< D: small changes of course
};
char letter_of(TrialSet set);

struct CasePlan {
  std::string name;  ///< "017"
  std::string ship_kind;
  std::vector<std::pair<std::string, Severity>> effects;
  double noise = 1.0;
  TrialSet set = TrialSet::all_round;
  bool reference = false;       ///< three calm runs of the same ship are given
  bool wrong_baseline = false;  ///< the ship file is wrong by its confidence
  std::uint64_t seed = 1;
  std::optional<FileForm> on_board = {};  ///< instruments as on board and a file in that form; see on_board_case.hpp
};

/// `clean`, `singles`, `pairs`, `unknown` or `all` (a quarter clean, 55 % singles, 10 % pairs, 10 % unknown); with
/// instruments as on board `on_board_clean`, or `on_board` (60 % singles, 20 % pairs, 20 % unknown). So many cases, or
/// as many as the plan has by itself.
/// @throws std::domain_error  if there is no plan of that name
std::vector<CasePlan> plan_named(std::string_view name, std::size_t count, std::uint64_t seed);

/// Ship file, recordings and label of a case.
struct ConcealedCase {
  CasePlan plan;
  Ship ship;
  std::vector<Recording> train, holdout, reference;
  std::vector<Recording> true_holdout;  ///< the runs held out as instruments without noise would have recorded them
  std::vector<Label> labels;
  nlohmann::ordered_json truth = {};  ///< of truth.json, besides the effects
};
ConcealedCase made(const CasePlan& plan);

/// FOLDER/NAME/{ship.toml, train/, holdout/, reference/, truth.json, truth/}; truth/ has the runs held out without
/// noise.
void write_case(const ConcealedCase& c, const std::filesystem::path& folder);

}  // namespace swayaw::concealed
