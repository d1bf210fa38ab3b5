#include "effect.hpp"
#include "module.hpp"
#include "record.hpp"
#include "swayaw/mismatch/diagnose.hpp"

namespace swayaw::python {

template <>
struct Words<DiagnosisVerdict> : NamedWords<DiagnosisVerdict, 3, name_of> {};

void add_diagnosis_result(py::module_& m) {
  Record<Diagnosis>(m, "Diagnosis", "What a model left out, and the proof.")
      .field<&Diagnosis::verdict>("verdict", "missing_physics, nothing_missing or unexplained.")
      .field<&Diagnosis::words>("words", "One sentence.")
      .field<&Diagnosis::location>("location", "Where force is missing.")
      .field<&Diagnosis::symmetry>("symmetry", "What the missing force goes with besides the motion, in words.")
      .field<&Diagnosis::linear>("linear", "Zigzags and the refitted ship, by K, T and the drift–yaw loop.")
      .field<&Diagnosis::effects>("effects", "Most important first.")
      .field<&Diagnosis::traces>("traces", "Effects too small to matter, in words.")
      .field<&Diagnosis::as_form>("as_form", "Effects that an error in the form of her forces explains as well.")
      .field<&Diagnosis::too_large>("too_large", "Effects that something acts like, larger than they can be.")
      .field<&Diagnosis::candidates>("candidates", "Best first.")
      .field<&Diagnosis::shifts>("shifts", "Largest first.")
      .field<&Diagnosis::rudder_force>("rudder_force", "Over that as given, where its numbers are among the shifts.")
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
      .field<&Diagnosis::runs_in_waves>("runs_in_waves", "Share of the runs used that waves move.")
      .field<&Diagnosis::refitted_process_noise>("refitted_process_noise", "The same without any effect.")
      .field<&Diagnosis::prior_inflation>("prior_inflation", "Factor on what the baseline is known to.")
      .field<&Diagnosis::next>("next_manoeuvre", "What to sail next.")
      .field<&Diagnosis::detectable>("detectable", "Smallest sizes that these runs would have shown.")
      .field<&Diagnosis::train_pictures>("train_pictures", "If asked for.")
      .field<&Diagnosis::holdout_pictures>("holdout_pictures", "If asked for.")
      .field<&Diagnosis::assumed>("assumed", "In place of what the runs do not tell, in words.")
      .field<&Diagnosis::troubles>("troubles", "Steps that failed, in words.");
}

}  // namespace swayaw::python
