#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "swayaw/core/recording.hpp"
#include "swayaw/mismatch/compare.hpp"
#include "swayaw/mismatch/linear_view.hpp"
#include "swayaw/mismatch/run_picture.hpp"
#include "swayaw/nonlinear/effects.hpp"
#include "swayaw/nonlinear/ship.hpp"

/// What a model left out: where it differs from recordings, which effect explains that, and whether runs that were not
/// used gain by it. docs/diagnose.md describes the method.
namespace swayaw::inline mismatch {

struct DiagnosisOptions {
  double detection = 15.0;  ///< gain in log evidence that an effect must bring
  double further = 20.0;    ///< that a second and third effect must bring
  std::size_t most_effects = 3;
  std::size_t confirmed = 6;  ///< candidates of the screening that are fitted until they converge
  bool pictures = false;      ///< whether the runs are wanted as people look at them
  std::function<bool(std::string_view)> progress =
      {};  ///< told what is going on; false ends the work with what is known
};

enum class DiagnosisVerdict { missing_physics, nothing_missing, unexplained };

/// "missing_physics"
std::string_view name_of(DiagnosisVerdict verdict);

/// A parameter of an effect with its standard error.
struct ParameterEstimate {
  std::string key;
  double value;
  double standard_error;
};

/// An effect that the recordings show.
struct FoundEffect {
  Effect effect;  ///< in the mean of the runs, where it differs
  Scope scope;    ///< that it differs with: group or run; ship where it is the same in all
  double probability;
  std::optional<double> onset;  ///< [s]
  std::optional<double> end;    ///< [s]
  std::vector<ParameterEstimate> parameters;
  std::vector<std::string> indistinguishable_from;  ///< effects that explain the runs as well
  std::string depends_on{};                         ///< of what has no name, what it goes with, in words
};

/// Wind or stream in a part of the runs.
struct SurroundingsEstimate {
  std::string scope;  ///< a group, a run, or "all"
  std::vector<std::string> runs;
  std::vector<ParameterEstimate> parameters;  ///< a direction missing where these runs do not tell it
  std::string cannot_tell{};  ///< why they do not, or how much wind they would not have shown; what would
};

/// An effect that was tried alone.
struct Candidate {
  std::string effect;
  double probability;
  double log_evidence_gain;
  std::optional<double> holdout_log_likelihood_gain{};  ///< of the held-out runs, where they were asked
  std::optional<double> holdout_gain{};  ///< fall of the replay errors of held-out runs over the refitted baseline
  bool trace = false;                    ///< too small to matter, or not told from nothing
  bool too_large = false;                ///< larger than it can be: something else acts like it
  bool refuted = false;                  ///< by runs that were not used
  bool as_form = false;                  ///< an error in the form of her forces explains the runs as well
};

/// Where force is missing in a run.
struct MismatchPlace {
  std::string run;
  std::string quantity;  ///< "surge_force", "sway_force", "yaw_moment"
  double from, to;       ///< [s]
  double share;          ///< of all unexplained force of that kind
  std::string where;
};

/// Errors of replays over windows of two ship lengths, over the variation of each quantity.
struct RunErrors {
  std::string run;
  std::vector<QuantityError> before, refitted, after;
};

/// A number of the baseline that is off by more than two of its deviations.
struct BaselineShift {
  std::string key;
  double given, refitted;  ///< SI
  double deviations;
  std::string part{};  ///< of the ship: "rudder"
};

/// The part of the ship whose coefficients, moved alone, bring her nearest to the recordings.
struct MovedPart {
  std::string part;                      ///< "rudder"
  double discrepancy;                    ///< error of the yaw rate with these moved and all others as given
  std::vector<BaselineShift> most;       ///< its coefficients that moved most, in their deviations; at most two
  std::optional<double> rudder_force{};  ///< of a rudder: its moment at 10 deg straight ahead over that as given
};

/// "18 % less rudder force" of 0.82 times that as given.
std::string rudder_force_words(double over_given);

/// An error of an instrument that was found beside everything else, however small.
struct InstrumentEstimate {
  std::string channel;  ///< "r", "x" for both coordinates of a position
  std::string error;    ///< "zero", "scale", "delay", "axes", "lever_arm_x", "lever_arm_y"
  double value, standard_error;
  std::string unit;
  bool is_effect = false;  ///< large enough to stand among the effects, too
};

/// Error of the yaw rate over its variation, mean of all runs.
struct Discrepancy {
  double given, refitted, after;
};

/// What a force goes with: the motion, alike on both sides or not; what is fixed to the earth; the past; errors of
/// instruments; nothing that is known.
enum class Follows { form, side, earth, past, instruments, nothing };

inline constexpr std::size_t follows_count = 6;

/// "form", "form_asymmetric", "earth_fixed", "delayed", "instruments", "unexplained"
std::string_view name_of(Follows follows);

/// The force that the given ship lacks, split by what it follows.
struct ForceBudget {
  std::string quantity;                     ///< "surge_force", "sway_force", "yaw_moment"
  std::array<double, follows_count> share;  ///< of its mean square, by Follows; they add up to 1
  std::array<double, follows_count> standard_error;
  double size;  ///< its mean square over that of the force on the ship's own hull
};

/// What to sail next.
struct Advice {
  std::string advice;                  ///< a manoeuvre in words
  std::vector<std::string> separates;  ///< effects that it tells apart
};

/// Number of an effect at which these runs would have shown it.
struct DetectableSize {
  std::string effect;
  std::string key;
  double value;
};

struct Diagnosis {
  DiagnosisVerdict verdict{};
  std::string words{};  ///< one sentence
  std::vector<MismatchPlace> location{};
  std::string symmetry{};                ///< what the missing force goes with besides the motion, in words
  std::vector<LinearView> linear{};      ///< zigzags and the refitted ship, by K, T and the drift–yaw loop
  std::vector<FoundEffect> effects{};    ///< most important first
  std::vector<std::string> traces{};     ///< effects too small to matter, in words; the improved ship has them
  std::vector<std::string> as_form{};    ///< effects that an error in the form of her forces explains as well; likewise
  std::vector<std::string> too_large{};  ///< effects that something acts like, larger than they can be; she has none
  std::vector<Candidate> candidates{};   ///< best first
  std::vector<BaselineShift> shifts{};   ///< largest first
  /// Where numbers of the rudder are among the shifts: its moment at 10 deg straight ahead over that as given.
  std::optional<double> rudder_force{};
  std::vector<RunErrors> train{}, holdout{};
  Ship refitted;                                     ///< baseline refitted, without effects
  Ship improved;                                     ///< with the effects found
  std::vector<InstrumentEstimate> instruments{};     ///< told from none; those among the effects first
  std::vector<SurroundingsEstimate> surroundings{};  ///< where wind or stream was found
  std::vector<ForceBudget> budget{};
  std::optional<Discrepancy> discrepancy{};  ///< nothing where no run tells a yaw rate
  std::optional<MovedPart> moved{};          ///< nothing where moving coefficients hardly helps, or no part alone does
  double process_noise = 0.0;                ///< scale of what stays unexplained; 1 is ordinary
  double refitted_process_noise = 0.0;       ///< the same without any effect
  double runs_in_waves = 0.0;                ///< share of the runs used, where instruments are as on board
  double prior_inflation =
      1.0;  ///< factor on what the ship file or the reference runs say the parameters of the baseline are known to
  std::optional<Advice> next{};
  std::vector<DetectableSize> detectable{};
  std::vector<RunPicture> train_pictures{}, holdout_pictures{};  ///< if asked for
  std::vector<std::string> assumed{};                            ///< in place of what the runs do not tell, in words
  std::vector<std::string> troubles{};  ///< steps that failed, in words; everything else is as found
};

/// @param reference  runs in which nothing is hidden; they calibrate the baseline first
/// @param holdout    runs that are not used and say whether the effect is real
///
/// @throws Refusal  if there is no run, or one tells neither rudder nor speed
Diagnosis diagnose(const Ship& ship, std::span<const Recording> runs, std::span<const Recording> reference,
                   std::span<const Recording> holdout, const DiagnosisOptions& options = {});

}  // namespace swayaw::mismatch
