#include "effect.hpp"
#include "module.hpp"
#include "record.hpp"
#include "swayaw/mismatch/diagnose.hpp"

namespace swayaw::python {

void add_findings(py::module_& m) {
  Record<ParameterEstimate>(m, "ParameterEstimate", "A parameter of an effect with its standard error.")
      .field<&ParameterEstimate::key>("key", "Of ship files, unit in the name.")
      .field<&ParameterEstimate::value>("value", "In that unit.")
      .field<&ParameterEstimate::standard_error>("standard_error", "In that unit.");
  Record<FoundEffect>(m, "FoundEffect", "An effect that the recordings show.")
      .field<&FoundEffect::effect>("effect", "In the mean of the runs, where it differs.")
      .field<&FoundEffect::scope>("scope", "That it differs with: ship where it is the same in all.")
      .field<&FoundEffect::probability>("probability", "")
      .field<&FoundEffect::onset>("onset", "[s]")
      .field<&FoundEffect::end>("end", "[s]")
      .field<&FoundEffect::parameters>("parameters", "With standard errors.")
      .field<&FoundEffect::indistinguishable_from>("indistinguishable_from", "Effects that explain the runs as well.")
      .field<&FoundEffect::depends_on>("depends_on", "Of what has no name, what it goes with, in words.");
  Record<SurroundingsEstimate>(m, "SurroundingsEstimate", "Wind or stream in a part of the runs.")
      .field<&SurroundingsEstimate::scope>("scope", "A group, a run, or \"all\".")
      .field<&SurroundingsEstimate::runs>("runs", "Their names.")
      .field<&SurroundingsEstimate::parameters>("parameters", "With standard errors.")
      .field<&SurroundingsEstimate::cannot_tell>(
          "cannot_tell", "Why they do not tell a direction, or how much wind they would not have shown.");
  Record<Candidate>(m, "Candidate", "An effect that was tried alone.")
      .field<&Candidate::effect>("effect", "Its id.")
      .field<&Candidate::probability>("probability", "")
      .field<&Candidate::log_evidence_gain>("log_evidence_gain", "")
      .field<&Candidate::holdout_log_likelihood_gain>("holdout_log_likelihood_gain", "Of the held-out runs.")
      .field<&Candidate::holdout_gain>("holdout_gain", "Fall of the replay errors of held-out runs.")
      .field<&Candidate::trace>("trace", "Too small to matter, or not told from nothing.")
      .field<&Candidate::too_large>("too_large", "Larger than it can be: something else acts like it.")
      .field<&Candidate::refuted>("refuted", "By runs that were not used.")
      .field<&Candidate::as_form>("as_form", "An error in the form of her forces explains the runs as well.");
  Record<MismatchPlace>(m, "MismatchPlace", "Where force is missing in a run.")
      .field<&MismatchPlace::run>("run", "Its name.")
      .field<&MismatchPlace::quantity>("quantity", "surge_force, sway_force or yaw_moment.")
      .field<&MismatchPlace::from>("begin", "[s]")
      .field<&MismatchPlace::to>("end", "[s]")
      .field<&MismatchPlace::share>("share", "Of all unexplained force of that kind.")
      .field<&MismatchPlace::where>("where", "In words.");
  Record<RunErrors>(m, "RunErrors", "Errors of replays over windows of two ship lengths.")
      .field<&RunErrors::run>("run", "Its name.")
      .field<&RunErrors::before>("before", "Of the ship as given.")
      .field<&RunErrors::refitted>("refitted", "Of her coefficients refitted.")
      .field<&RunErrors::after>("after", "With the effects.");
  Record<BaselineShift>(m, "BaselineShift", "A number of the baseline that is off by more than two of its deviations.")
      .field<&BaselineShift::key>("key", "Of ship files.")
      .field<&BaselineShift::given>("given", "SI")
      .field<&BaselineShift::refitted>("refitted", "SI")
      .field<&BaselineShift::deviations>("deviations", "")
      .field<&BaselineShift::part>("part", "Of the ship: \"rudder\".");
  Record<MovedPart>(m, "MovedPart", "The part of the ship whose coefficients, moved alone, bring her nearest.")
      .field<&MovedPart::part>("part", "\"rudder\"")
      .field<&MovedPart::discrepancy>("discrepancy", "Error of the yaw rate then, over its variation.")
      .field<&MovedPart::most>("most", "Its coefficients that moved most.")
      .field<&MovedPart::rudder_force>("rudder_force", "Of a rudder: its moment over that as given.");
  Record<InstrumentEstimate>(m, "InstrumentEstimate", "An error of an instrument found beside everything else.")
      .field<&InstrumentEstimate::channel>("channel", "\"r\", \"x\" for both coordinates of a position.")
      .field<&InstrumentEstimate::error>("error", "zero, scale, delay, axes, lever_arm_x or lever_arm_y.")
      .field<&InstrumentEstimate::value>("value", "In `unit`.")
      .field<&InstrumentEstimate::standard_error>("standard_error", "In `unit`.")
      .field<&InstrumentEstimate::unit>("unit", "")
      .field<&InstrumentEstimate::is_effect>("is_effect", "Large enough to stand among the effects, too.");
  Record<Discrepancy>(m, "Discrepancy", "Error of the yaw rate over its variation, mean of all runs.")
      .field<&Discrepancy::given>("given", "Of the ship as given.")
      .field<&Discrepancy::refitted>("refitted", "Refitted.")
      .field<&Discrepancy::after>("after", "With the effects.");
  Record<Advice>(m, "Advice", "What to sail next.")
      .field<&Advice::advice>("advice", "A manoeuvre in words.")
      .field<&Advice::separates>("separates", "Effects that it tells apart.");
  Record<DetectableSize>(m, "DetectableSize", "Number of an effect at which these runs would have shown it.")
      .field<&DetectableSize::effect>("effect", "Its id.")
      .field<&DetectableSize::key>("key", "Of ship files, unit in the name.")
      .field<&DetectableSize::value>("value", "In that unit.");
}

}  // namespace swayaw::python
