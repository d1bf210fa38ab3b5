#include "effect.hpp"
#include "module.hpp"
#include "progress.hpp"
#include "record.hpp"
#include "swayaw/mismatch/diagnose.hpp"

namespace swayaw::python {

template <>
struct Words<DiagnosisVerdict> : NamedWords<DiagnosisVerdict, 3, name_of> {};

namespace {

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
      .field<&FoundEffect::indistinguishable_from>("indistinguishable_from", "Effects that explain the runs as well.");
  Record<SurroundingsEstimate>(m, "SurroundingsEstimate", "Wind or stream in a part of the runs.")
      .field<&SurroundingsEstimate::scope>("scope", "A group, a run, or \"all\".")
      .field<&SurroundingsEstimate::runs>("runs", "Their names.")
      .field<&SurroundingsEstimate::parameters>("parameters", "With standard errors.")
      .field<&SurroundingsEstimate::cannot_tell>("cannot_tell", "Why they do not tell a direction.");
  Record<Candidate>(m, "Candidate", "An effect that was tried alone.")
      .field<&Candidate::effect>("effect", "Its id.")
      .field<&Candidate::probability>("probability", "")
      .field<&Candidate::log_evidence_gain>("log_evidence_gain", "")
      .field<&Candidate::holdout_log_likelihood_gain>("holdout_log_likelihood_gain", "Of the held-out runs.")
      .field<&Candidate::holdout_gain>("holdout_gain", "Fall of the replay errors of held-out runs.")
      .field<&Candidate::trace>("trace", "Too small to matter, or not told from nothing.")
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
      .field<&InstrumentEstimate::error>("error", "zero, scale or delay.")
      .field<&InstrumentEstimate::value>("value", "In `unit`.")
      .field<&InstrumentEstimate::standard_error>("standard_error", "In `unit`.")
      .field<&InstrumentEstimate::unit>("unit", "");
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

/// A number for each of what a force may follow, by name.
py::dict by_cause(const std::array<double, follows_count>& numbers) {
  py::dict result;
  for (std::size_t i = 0; i < follows_count; ++i) result[py::str(name_of(static_cast<Follows>(i)))] = numbers[i];
  return result;
}

void add_budget(py::module_& m) {
  Record<ForceBudget>(m, "ForceBudget", "The force that the given ship lacks, split by what it follows.")
      .field<&ForceBudget::quantity>("quantity", "surge_force, sway_force or yaw_moment.")
      .field<&ForceBudget::share>("share", "Of its mean square; they add up to 1. `shares` has the names.")
      .field<&ForceBudget::standard_error>("standard_error", "In the same order.")
      .field<&ForceBudget::size>("size", "Its mean square over that of the force on the ship's own hull.")
      .of()
      .def_property_readonly(
          "shares", [](const ForceBudget& b) { return by_cause(b.share); },
          "By form, form_asymmetric, earth_fixed, delayed, instruments, unexplained.")
      .def_property_readonly("standard_errors", [](const ForceBudget& b) { return by_cause(b.standard_error); });
  Record<ZigzagView>(m, "ZigzagView", "A zigzag by Nomoto's first-order equation and its drift–yaw loop.")
      .field<&ZigzagView::K>("K", "K L/U, rudder positive to port.")
      .field<&ZigzagView::T>("T", "T U/L.")
      .field<&ZigzagView::delta_r>("delta_r", "Rudder offset beside the recorded angle [rad].")
      .field<&ZigzagView::loop_area>("loop_area", "∮ beta d(r') over one period; NaN without sway velocity.");
  Record<LinearView>(m, "LinearView", "A recorded zigzag and the refitted ship's, by K, T and the loop.")
      .field<&LinearView::run>("run", "Its name.")
      .field<&LinearView::amplitude>("amplitude", "Largest rudder angle [rad].")
      .field<&LinearView::recorded>("recorded", "")
      .field<&LinearView::model>("model", "");
}

void add_result(py::module_& m) {
  Record<Diagnosis>(m, "Diagnosis", "What a model left out, and the proof.")
      .field<&Diagnosis::verdict>("verdict", "missing_physics, nothing_missing or unexplained.")
      .field<&Diagnosis::words>("words", "One sentence.")
      .field<&Diagnosis::location>("location", "Where force is missing.")
      .field<&Diagnosis::symmetry>("symmetry", "What the missing force goes with besides the motion, in words.")
      .field<&Diagnosis::linear>("linear", "Zigzags and the refitted ship, by K, T and the drift–yaw loop.")
      .field<&Diagnosis::effects>("effects", "Most important first.")
      .field<&Diagnosis::traces>("traces", "Effects too small to matter, in words.")
      .field<&Diagnosis::as_form>("as_form", "Effects that an error in the form of her forces explains as well.")
      .field<&Diagnosis::candidates>("candidates", "Best first.")
      .field<&Diagnosis::shifts>("shifts", "Largest first.")
      .field<&Diagnosis::train>("train", "Errors in the runs that were used.")
      .field<&Diagnosis::holdout>("holdout", "Errors in those held out.")
      .field<&Diagnosis::refitted>("refitted", "Baseline refitted, without effects.")
      .field<&Diagnosis::improved>("improved", "The ship with the effects found.")
      .field<&Diagnosis::instruments>("instruments", "Told from none, beside the effects.")
      .field<&Diagnosis::surroundings>("surroundings", "Where wind or stream was found.")
      .field<&Diagnosis::budget>("budget", "Shares by what they follow.")
      .field<&Diagnosis::discrepancy>("discrepancy", "None where no run tells a yaw rate.")
      .field<&Diagnosis::moved>("moved", "None where no part alone helps.")
      .field<&Diagnosis::process_noise>("process_noise", "Scale of what stays unexplained; 1 is ordinary.")
      .field<&Diagnosis::refitted_process_noise>("refitted_process_noise", "The same without any effect.")
      .field<&Diagnosis::prior_inflation>("prior_inflation", "Factor on what the baseline is known to.")
      .field<&Diagnosis::next>("next_manoeuvre", "What to sail next.")
      .field<&Diagnosis::detectable>("detectable", "Smallest sizes that these runs would have shown.")
      .field<&Diagnosis::train_pictures>("train_pictures", "If asked for.")
      .field<&Diagnosis::holdout_pictures>("holdout_pictures", "If asked for.")
      .field<&Diagnosis::troubles>("troubles", "Steps that failed, in words.");
}

}  // namespace

void add_diagnosis(py::module_& m) {
  add_findings(m);
  add_budget(m);
  add_result(m);
  m.def(
      "diagnose",
      [](const Ship& ship, const std::vector<Recording>& runs, const std::vector<Recording>& reference,
         const std::vector<Recording>& holdout, py::object progress, std::size_t most_effects, bool pictures) {
        Listener listener(std::move(progress));
        DiagnosisOptions options{.most_effects = most_effects, .pictures = pictures};
        options.progress = [&](std::string_view what) { return listener.tell(what); };
        return listened_to(listener, [&] { return diagnose(ship, runs, reference, holdout, options); });
      },
      py::arg("ship"), py::arg("runs"), py::kw_only(), py::arg("reference") = std::vector<Recording>{},
      py::arg("holdout") = std::vector<Recording>{}, py::arg("progress") = py::none(),
      py::arg("most_effects") = DiagnosisOptions{}.most_effects, py::arg("pictures") = false,
      "What a model left out: where it differs from recordings, which effect explains that, and whether runs that were "
      "not used gain by it (docs/diagnose.md).\n\nreference: runs in which nothing is hidden; they calibrate the "
      "baseline first. holdout: runs that are not used and say whether the effect is real. progress: a function that "
      "is "
      "told in words what is going on; False ends the work with what is known. Ctrl-C raises KeyboardInterrupt. Other "
      "threads go on meanwhile. Raises Refusal if there is no run, or one tells neither rudder nor speed.");
}

}  // namespace swayaw::python
