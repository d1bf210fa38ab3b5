#include "module.hpp"
#include "progress.hpp"
#include "record.hpp"
#include "swayaw/identification/index_tuning.hpp"

namespace swayaw::python {

template <>
struct Words<TuningStatus> {
  static std::vector<std::string> list() { return {"converged", "simulation_limit", "interrupted"}; }
};

namespace {

// ---------------------------------------------------------------- what was measured

void add_measured(py::module_& m) {
  Record<MeasuredIndex>(m, "MeasuredIndex", "One measured number of a manoeuvre, SI.")
      .field<&MeasuredIndex::name>("name", "As in the file: \"advance_L\", \"overshoot_deg 2\" for the second peak.")
      .field<&MeasuredIndex::place>("place", "Among the indices of such a manoeuvre.")
      .field<&MeasuredIndex::value>("value", "Of a turn to port that of its mirror image.")
      .field<&MeasuredIndex::deviation>("deviation", "Standard deviation.")
      .field<&MeasuredIndex::si>("si", "SI value of one unit of the file.");
  Record<MeasuredTrial>(m, "MeasuredTrial", "A manoeuvre and its measured indices.")
      .field<&MeasuredTrial::manoeuvre>("manoeuvre", "That was sailed.")
      .field<&MeasuredTrial::indices>("indices", "In the order of the file.")
      .of()
      .def_property_readonly(
          "name", [](const MeasuredTrial& t) { return name_of(t.manoeuvre); }, "\"turn 35 to starboard\"");
  Record<MeasuredIndices>(m, "MeasuredIndices", "Indices of manoeuvres that were measured, and how they were sailed.")
      .field<&MeasuredIndices::speed>("speed", "Of the approach [m/s]; None for the service speed.")
      .field<&MeasuredIndices::rev>("rev", "Shaft speed [1/s]; None for that of self-propulsion.")
      .field<&MeasuredIndices::thrust>("thrust", "Of all propellers, in place of a shaft speed [N].")
      .field<&MeasuredIndices::trials>("trials", "Turns first.");
  m.def("read_indices", &read_indices, py::arg("file"), py::arg("length"),
        "Measured indices of turning circles and zigzags from a file (docs/formats.md).\n\nlength: of the ship [m], "
        "for lengths that the file gives in it. Raises FileError \"FILE:LINE:COLUMN: what is wrong\".");
  m.def(
      "parse_indices",
      [](std::string_view text, double length, const std::filesystem::path& name) {
        return parse_indices(text, name, length);
      },
      py::arg("text"), py::arg("length"), py::arg("name") = "indices",
      "Measured indices from the text of such a file.\n\nlength: of the ship [m]. name: stands for the file in "
      "messages. Raises FileError \"NAME:LINE:COLUMN: what is wrong\".");
}

// ---------------------------------------------------------------- sensitivity

void add_sensitivity(py::module_& m) {
  Record<SimulationCount>(m, "SimulationCount", "Manoeuvres that were sailed.")
      .field<&SimulationCount::turns>("turns", "Turning circles.")
      .field<&SimulationCount::zigzags>("zigzags", "");
  Record<IndexSensitivity>(m, "IndexSensitivity",
                           "What numbers of a ship do to her indices: a row for each index, a column for each number; "
                           "NaN where an index does not exist.")
      .field<&IndexSensitivity::indices>("indices", "Of the ship, SI, in the order of the file.")
      .field<&IndexSensitivity::exact>("exact", "d ln index / d ln number.")
      .field<&IndexSensitivity::ten_per_cent>("ten_per_cent", "Relative change for 10 % more of the number.")
      .field<&IndexSensitivity::simulations>("simulations", "That it took.");
  Record<IndexCombination>(m, "IndexCombination",
                           "A combination of relative changes of the numbers that the indices see as one.")
      .field<&IndexCombination::singular_value>("singular_value", "Of the Jacobian over the tolerances.")
      .field<&IndexCombination::standard_error>("standard_error", "Relative, from the indices alone.")
      .field<&IndexCombination::determined>("determined", "To better than a half, so that its sign is known.")
      .field<&IndexCombination::weights>("weights", "Of the numbers; their squares add up to 1.");
  m.def(
      "tuned_parameters",
      [](const Ship& ship, std::vector<std::string> parameters) {
        return tuned_parameters(ship, {.parameters = std::move(parameters), .prior = {}, .most_change = {}});
      },
      py::arg("ship"), py::arg("parameters") = std::vector<std::string>{},
      "The numbers that `tune` changes, as Parameter.\n\nparameters: by name; unless given those of the hull that are "
      "not 0, but for its resistance. Raises Refusal for one that she does not have."
      "\n\nship: who is tuned.");
  m.def(
      "index_sensitivity",
      [](const Ship& ship, const MeasuredIndices& measured, std::vector<std::string> parameters) {
        const auto numbers =
            tuned_parameters(ship, {.parameters = std::move(parameters), .prior = {}, .most_change = {}});
        return index_sensitivity(ship, measured, numbers);
      },
      py::arg("ship"), py::arg("measured"), py::arg("parameters") = std::vector<std::string>{}, Unlocked(),
      "What numbers of a ship do to the indices that were measured.\n\nmeasured: the manoeuvres and indices. "
      "parameters: columns of the result, those of `tuned_parameters`. Raises Refusal as `tune` does.");
  m.def("determined_combinations", &determined_combinations, py::arg("sensitivity"), py::arg("tolerance"),
        "Combinations of numbers from the best to the worst determined by indices.\n\nsensitivity: d ln index / d ln "
        "number, a row for each index. tolerance: relative standard deviation of each index.");
}

// ---------------------------------------------------------------- tuning

void add_tune(py::module_& m) {
  Record<TuningError>(m, "TuningError", "Σ (1 − I/I_measured)². Source: [Kulbiej2021] section 4.1")
      .field<&TuningError::turns>("turns", "Of turning circles.")
      .field<&TuningError::zigzags>("zigzags", "");
  Record<TunedParameter>(m, "TunedParameter", "A number that was tuned.")
      .field<&TunedParameter::number>("number", "As it was.")
      .field<&TunedParameter::value>("value", "As it is, SI.")
      .field<&TunedParameter::prior>("prior", "Relative standard deviation before; infinity for none.")
      .field<&TunedParameter::deviation>("deviation", "And after.")
      .field<&TunedParameter::told>("told", "Share, in squares, that lies in determined combinations.")
      .field<&TunedParameter::at_bound>("at_bound", "Held by most_change or the range of the ship file.")
      .of()
      .def_property_readonly(
          "name", [](const TunedParameter& p) { return p.number.name; }, "Key of the ship file.")
      .def_property_readonly(
          "before", [](const TunedParameter& p) { return p.number.value / p.number.si; }, "In the unit of the file.")
      .def_property_readonly(
          "after", [](const TunedParameter& p) { return p.value / p.number.si; }, "In the unit of the file.")
      .def_property_readonly("determined", &TunedParameter::determined, "The indices tell it: `told` is 0.5 at least.");
  Record<TunedIndex>(m, "TunedIndex", "An index before and after, SI; NaN where it does not exist.")
      .field<&TunedIndex::trial>("trial", "Place among the measured trials.")
      .field<&TunedIndex::measured>("measured", "What was measured.")
      .field<&TunedIndex::before>("before", "Of the ship as given.")
      .field<&TunedIndex::after>("after", "Of the tuned ship.");
  Record<Tuning>(m, "Tuning", "A ship whose manoeuvres have the indices that were measured.")
      .field<&Tuning::status>("status", "converged, simulation_limit or interrupted.")
      .field<&Tuning::ship>("ship", "With the numbers found.")
      .field<&Tuning::parameters>("parameters", "Before and after.")
      .field<&Tuning::indices>("indices", "Before and after.")
      .field<&Tuning::before>("before", "Error of the ship as given.")
      .field<&Tuning::after>("after", "Error of the tuned ship.")
      .field<&Tuning::simulations>("simulations", "That it took.")
      .field<&Tuning::combinations>("combinations", "That the indices determine, of the ship as she was.")
      .field<&Tuning::decay>("decay", "Of each turn after tuning, per ship length; NaN where none was asked for.");
  m.def(
      "tune",
      [](const Ship& ship, const MeasuredIndices& measured, std::vector<std::string> parameters, Maybe prior,
         Maybe most_change, int most_turns, double least_decay, py::object progress) {
        Listener listener(std::move(progress), "tune");
        TuningOptions options{.parameters = std::move(parameters),
                              .prior = prior,
                              .most_change = most_change,
                              .most_turns = most_turns,
                              .least_decay = least_decay,
                              .watch = {}};
        options.watch = [&](const TuningProgress& p) { return listener.tell(p.simulations, p.error); };
        return listened_to(listener, [&] { return tune(ship, measured, options); });
      },
      py::arg("ship"), py::arg("measured"), py::arg("parameters") = std::vector<std::string>{}, py::kw_only(),
      py::arg("prior") = py::none(), py::arg("most_change") = py::none(),
      py::arg("most_turns") = TuningOptions{}.most_turns, py::arg("least_decay") = TuningOptions{}.least_decay,
      py::arg("progress") = py::none(),
      R"(Coefficients of a ship from measured indices of her manoeuvres: weighted least squares with a prior and exact
derivatives (docs/index_tuning.md). Source: [Kulbiej2021] section 4

measured: of `read_indices`. parameters: that may change, by name; unless given those of the hull that are not 0, but
for its resistance. prior: relative standard deviation of each number; that of the ship's confidence unless given.
most_change: largest relative change. most_turns: turning circles to be sailed at most. least_decay: what a steady turn
must keep, decay of a disturbance per ship length. progress: a function of the manoeuvres sailed (SimulationCount) and
the error of the best ship so far (TuningError); False ends the tuning with her, Ctrl-C raises KeyboardInterrupt.
Without one a notebook has a line that changes, progress=False nothing.

Raises Refusal for a ship in wind, one that does not reach a measured index to begin with or lacks a parameter, or where
a number to change is 0; ValueError if an option is not positive or a rudder angle beyond the ship's largest.)");
}

}  // namespace

void add_tuning(py::module_& m) {
  add_measured(m);
  add_sensitivity(m);
  add_tune(m);
}

}  // namespace swayaw::python
