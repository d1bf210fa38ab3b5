#include <fmt/format.h>

#include "effect.hpp"
#include "module.hpp"
#include "progress.hpp"
#include "record.hpp"
#include "swayaw/core/run_remark.hpp"
#include "swayaw/mismatch/fleet.hpp"

namespace swayaw::python {

template <>
struct Words<ChangeShape> : NamedWords<ChangeShape, 2, name_of> {};

namespace {

void add_values(py::module_& m) {
  Record<FleetRun>(m, "FleetRun", "A recording and the ship that made it.", Made::by_anyone)
      .field<&FleetRun::vessel>("vessel", "Her name.")
      .field<&FleetRun::run>("run", "Must tell when it was, by its key start_utc.");
  Record<DateEstimate>(m, "DateEstimate", "A date with the interval that holds it in 95 of 100 cases.")
      .field<&DateEstimate::likeliest>("likeliest", "Days since 1970-01-01.")
      .field<&DateEstimate::from>("begin", "Days since 1970-01-01.")
      .field<&DateEstimate::to>("end", "Days since 1970-01-01.");
  Record<DayLevel>(m, "DayLevel", "A parameter on one day of a vessel, all else as she is.")
      .field<&DayLevel::day>("day", "Days since 1970-01-01.")
      .field<&DayLevel::value>("value", "SI")
      .field<&DayLevel::standard_error>("standard_error", "SI, with the scatter between days.");
  Record<VesselChange>(m, "VesselChange", "Something of one vessel that is not as it was.")
      .field<&VesselChange::effect>("effect", "As it is on her last day.")
      .field<&VesselChange::key>("key", "Of its parameter.")
      .field<&VesselChange::shape>("shape", "")
      .field<&VesselChange::before>("before", "The parameter before it began, SI.")
      .field<&VesselChange::after>("after", "The parameter on her last day, SI.")
      .field<&VesselChange::standard_error>("standard_error", "Of after − before.")
      .field<&VesselChange::floors>("floors", "|after − before| over the least size that matters.")
      .field<&VesselChange::since>("since", "When it began.")
      .field<&VesselChange::probability>("probability", "Against others in its place, and against none.")
      .field<&VesselChange::log_evidence_gain>("log_evidence_gain", "")
      .field<&VesselChange::days>("days", "The parameter day by day.");
  Record<VesselDifference>(m, "VesselDifference", "In what a vessel differs from her sisters from the first day on.")
      .field<&VesselDifference::effect>("effect", "")
      .field<&VesselDifference::key>("key", "Of its parameter.")
      .field<&VesselDifference::sisters>("sisters", "SI")
      .field<&VesselDifference::own>("own", "SI")
      .field<&VesselDifference::standard_error>("standard_error", "Of own − sisters.")
      .field<&VesselDifference::floors>("floors", "|own − sisters| over the least size that matters.");
  Record<SharedCoefficient>(m, "SharedCoefficient", "A coefficient of the class.")
      .field<&SharedCoefficient::key>("key", "Of ship files.")
      .field<&SharedCoefficient::given>("given", "SI")
      .field<&SharedCoefficient::found>("found", "SI")
      .field<&SharedCoefficient::standard_error>("standard_error", "SI")
      .field<&SharedCoefficient::deviations>("deviations", "found − given over what the file says of it.");
  Record<FleetErrors>(m, "FleetErrors", "Errors of replays over the variation of what was recorded.")
      .field<&FleetErrors::given>("given", "By the ship file.")
      .field<&FleetErrors::sisters>("sisters", "With what the class has in common.")
      .field<&FleetErrors::own>("own", "With what the vessel has of her own, and its changes.");
  Record<VesselReport>(m, "VesselReport", "What was found of one vessel.")
      .field<&VesselReport::vessel>("vessel", "Her name.")
      .field<&VesselReport::days>("days", "That were fitted.")
      .field<&VesselReport::runs>("runs", "")
      .field<&VesselReport::first_day>("first_day", "Days since 1970-01-01.")
      .field<&VesselReport::last_day>("last_day", "Days since 1970-01-01.")
      .field<&VesselReport::changes>("changes", "Largest over its floor first.")
      .field<&VesselReport::differences>("differences", "From her sisters, or from the ship file.")
      .field<&VesselReport::errors>("errors", "")
      .field<&VesselReport::today>("today", "As she is on her last day.");
  Record<FleetDiagnosis>(m, "FleetDiagnosis", "What sisters have in common, and what changed on which of them.")
      .field<&FleetDiagnosis::words>("words", "")
      .field<&FleetDiagnosis::vessels>("vessels", "Worst first.")
      .field<&FleetDiagnosis::shared>("shared", "Coefficients of the class.")
      .field<&FleetDiagnosis::sisters>("sisters", "The ship file with what the class has in common.")
      .field<&FleetDiagnosis::spread>("spread", "Of coefficients between vessels, over their confidence.")
      .field<&FleetDiagnosis::day_to_day>("day_to_day", "The same between days of a vessel.")
      .field<&FleetDiagnosis::trace>("trace", "Changes too small to matter, in words.")
      .field<&FleetDiagnosis::troubles>("troubles", "");
}

}  // namespace

void add_fleets(py::module_& m) {
  add_values(m);
  m.def("remark_of", &remark_of, py::arg("run"), py::arg("key"),
        "The text of a run key that the samples do not hang on, without quotes; empty if the run has none.\n\nrun: a "
        "recording. key: as above the columns of its file, \"vessel\".");
  m.def("start_utc", &start_utc, py::arg("run"),
        "Seconds since 1970 UTC at which the time of a run is 0, by its key start_utc; None where it has none.\n\n"
        "run: a recording.");
  m.def("date_text", &date_text, py::arg("day"),
        "\"2026-03-04\", of days since 1970-01-01.\n\nday: with a fraction or without.");
  const FleetOptions usual;
  m.def(
      "diagnose_fleet",
      [](const Ship& ship, const std::vector<FleetRun>& runs, py::object progress, double detection,
         std::size_t most_changes) {
        Listener listener(std::move(progress), "fleet");
        FleetOptions options{.detection = detection, .most_changes = most_changes};
        options.progress = [&](std::size_t done, std::size_t days) {
          return listener.tell(fmt::format("{} of {} days", done, days));
        };
        return listened_to(listener, [&] { return diagnose_fleet(ship, runs, options); });
      },
      py::arg("ship"), py::arg("runs"), py::kw_only(), py::arg("progress") = py::none(),
      py::arg("detection") = usual.detection, py::arg("most_changes") = usual.most_changes,
      "What sister ships have in common, in what each differs, and what has changed on which of them, by how much and "
      "since when (docs/fleet.md).\n\nship: of the class, with its confidence. runs: of all vessels, each with the key "
      "start_utc. progress: a function that is told in words how far it is; False ends the work. detection: gain in "
      "log "
      "evidence that a change must bring. most_changes: of one vessel. Raises Refusal for a run that does not tell its "
      "date, and where no day can be fitted.");
}

}  // namespace swayaw::python
