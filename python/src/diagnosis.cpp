#include "effect.hpp"
#include "module.hpp"
#include "progress.hpp"
#include "record.hpp"
#include "swayaw/mismatch/diagnose.hpp"

namespace swayaw::python {

template <>
struct Words<DiagnosisVerdict> : NamedWords<DiagnosisVerdict, 3, name_of> {};

namespace {

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
  add_result(m);
  m.def(
      "diagnose",
      [](const Ship& ship, const std::vector<Recording>& runs, const std::vector<Recording>& reference,
         const std::vector<Recording>& holdout, py::object progress, std::size_t most_effects, bool pictures) {
        Listener listener(std::move(progress), "diagnose");
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
      "told in words what is going on; False ends the work with what is known. Ctrl-C raises KeyboardInterrupt. "
      "Without one a notebook has a line that changes, progress=False nothing. Other "
      "threads go on meanwhile. Raises Refusal if there is no run, or one tells neither rudder nor speed."
      "\n\nship: the model that is doubted. runs: recordings that are to be explained. most_effects: that may be "
      "found. pictures: whether the result holds series for figures.");
}

}  // namespace swayaw::python
