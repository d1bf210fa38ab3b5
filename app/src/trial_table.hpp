#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "json.hpp"
#include "swayaw/identification/trial.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"

/// What `swayaw trial` shows of a judged run: as JSON, and as rows for text and page.
namespace swayaw::app {

/// Ships for which the criteria of MSC.137(76) are made are at least so long [m].
inline constexpr double shortest_ship_of_criteria = 100.0;

/// The same manoeuvre of a ship, at the approach speed of the recording, or at the only one that she has.
struct SimulatedTrial {
  std::optional<Zigzag> zigzag;
  std::optional<TurningCircle> turn;
  Json json;  ///< as `simulate --json` prints it; null without a ship
};

/// The only speed at which a ship is propelled, if she has but one [m/s]: an Abkowitz ship that of her polynomial.
std::optional<double> only_speed(const Ship& ship);

/// " at 16.7 kn, the only speed of an abkowitz ship".
std::string at_only_speed(std::string_view speed);

/// Says at which speed a ship makes the manoeuvre of a recording, where that is not the recorded one.
void say_other_speed(const Ship& ship, const TrialResult& trial);

/// The manoeuvre of a recording as the ship sails it; nothing but a null where she cannot.
SimulatedTrial simulated_trial(const Ship& ship, const TrialResult& trial);

/// A recording with what was told of it.
struct JudgedRun {
  Recording recording;
  TrialResult trial;
  SimulatedTrial simulated;
};

/// One number of a run in the unit that people read.
struct TrialRow {
  std::string name, unit;
  MaybeTold recorded;   ///< of the track as recorded where lengths are corrected
  MaybeTold corrected;  ///< without the drift of the track
  std::optional<double> simulated;
  std::optional<double> in_lengths;  ///< of the best told length, over L
};

std::vector<TrialRow> rows_of(const TrialResult& trial, const SimulatedTrial& simulated,
                              const std::optional<double>& L);

/// {"value": …, "standard_error": …}; null where it is not told.
Json told_json(const MaybeTold& told, double unit = 1.0);

Json trial_json(const TrialResult& trial, const SimulatedTrial& simulated);

Json rows_json(const std::vector<TrialRow>& rows);

/// "8.23 ± 0.05", to the second digit of the standard error.
std::string shown(const Told& told);

/// "pass", "fail", "cannot tell", "not reached".
std::string_view verdict_of(const JudgedCriterion& criterion);

/// One sentence on the criteria of all runs.
std::string in_words(const ImoSummary& summary);

}  // namespace swayaw::app
