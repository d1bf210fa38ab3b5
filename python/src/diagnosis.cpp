#include "module.hpp"
#include "progress.hpp"
#include "record.hpp"
#include "swayaw/mismatch/diagnose.hpp"

namespace swayaw::python {

void add_diagnosis(py::module_& m) {
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
