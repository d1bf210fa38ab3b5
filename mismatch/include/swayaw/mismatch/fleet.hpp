#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "swayaw/core/recording.hpp"
#include "swayaw/nonlinear/effects.hpp"
#include "swayaw/nonlinear/ship.hpp"

/// Many ships of one class over months: what the sisters have in common, what each has of her own, and what has changed
/// on her and since when. docs/fleet.md describes the method.
namespace swayaw::inline mismatch {

/// A recording and the ship that made it.
struct FleetRun {
  std::string vessel;
  Recording run;  ///< must tell when it was, by `start_utc`
};

struct FleetOptions {
  /// Gain in log evidence that a change must bring. Of simulated fleets in which nothing changed none gained more than
  /// 0 (docs/results/fleets.md).
  double detection = 4.0;
  std::size_t most_changes = 4;  ///< of one vessel
  std::function<bool(std::size_t done, std::size_t days)> progress =
      {};  ///< told how many days are fitted; false ends the work
};

enum class ChangeShape {
  sudden,   ///< from one day to the next: a rudder that was bent, a log that was replaced
  gradual,  ///< grows evenly to the last day: fouling
};

/// "sudden"
std::string_view name_of(ChangeShape shape);

/// A date with the interval that holds it in 95 of 100 cases, days since 1970-01-01.
struct DateEstimate {
  double likeliest, from, to;
};

/// A parameter on one day of a vessel, all else as she is.
struct DayLevel {
  double day, value, standard_error;
};

/// Something of one vessel that is not as it was.
struct VesselChange {
  Effect effect;  ///< as it is on her last day
  std::string key;
  ChangeShape shape;
  double before, after;   ///< of the parameter, SI: before it began, and on her last day
  double standard_error;  ///< of after − before
  double floors;          ///< |after − before| over the least size that matters
  DateEstimate since;     ///< when it began
  double probability;
  double log_evidence_gain;
  std::vector<DayLevel> days;  ///< of the parameter
};

/// Something in which a vessel differs from her sisters, or, where she has none, from the ship file, from the first
/// day.
struct VesselDifference {
  Effect effect;
  std::string key;
  double sisters, own;  ///< of the parameter, SI
  double standard_error;
  double floors;  ///< |own − sisters| over the least size that matters
};

/// A coefficient of the class.
struct SharedCoefficient {
  std::string key;
  double given, found, standard_error;
  double deviations;  ///< found − given over what the file says of it
};

/// Errors of replays, restarted every two lengths, over the variation of what was recorded: root mean square of all
/// runs, mean over heading, yaw rate, speed and drift.
struct FleetErrors {
  double given;    ///< by the ship file
  double sisters;  ///< with what the class has in common
  double own;      ///< with what the vessel has of her own, and its changes
};

struct VesselReport {
  std::string vessel;
  std::size_t days = 0, runs = 0;
  double first_day = 0.0, last_day = 0.0;  ///< since 1970-01-01
  std::vector<VesselChange> changes;       ///< largest over its floor first
  std::vector<VesselDifference> differences;
  FleetErrors errors{};
  Ship today;  ///< as she is on her last day

  /// The largest of changes and differences over their floors: by this the worst comes first.
  double worst() const;
};

struct FleetDiagnosis {
  std::string words;
  std::vector<VesselReport> vessels;  ///< worst first
  std::vector<SharedCoefficient> shared;
  Ship sisters;                    ///< the ship file with what the class has in common
  double spread = 0.0;             ///< of coefficients between vessels, over their `[confidence]`
  double day_to_day = 0.0;         ///< of the same between days of a vessel
  std::vector<std::string> trace;  ///< changes that are told and too small to matter, in words
  std::vector<std::string> troubles;
};

/// "2026-03-04"
std::string date_text(double day);

/// @param ship  of the class, with its `[confidence]`
/// @throws Refusal  for a run that does not tell its date, and where no day can be fitted
FleetDiagnosis diagnose_fleet(const Ship& ship, std::span<const FleetRun> runs, const FleetOptions& options = {});

}  // namespace swayaw::mismatch
