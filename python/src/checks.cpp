#include "module.hpp"
#include "record.hpp"
#include "swayaw/identification/data_compatibility.hpp"

namespace swayaw::python {

template <>
struct Words<InstrumentErrorKind>
    : NamedWords<InstrumentErrorKind, static_cast<std::size_t>(InstrumentErrorKind::lever_arm_y) + 1, name_of> {};

namespace {

void add_results(py::module_& m) {
  Record<InstrumentError>(m, "InstrumentError", "One error of one channel of a run.")
      .field<&InstrumentError::channel>("channel", "By its short name.")
      .field<&InstrumentError::kind>("kind",
                                     "unit, sign, order, zero, scale, delay, clock, clock_rate, jump, smoothing, "
                                     "axes, lever_arm_x or lever_arm_y.")
      .field<&InstrumentError::value>("value", "In `unit`; docs/check.md tells the meaning by kind.")
      .field<&InstrumentError::standard_error>("standard_error", "In `unit`.")
      .field<&InstrumentError::told>("told", "Larger than what chance makes of none, and than what matters.")
      .field<&InstrumentError::at>("at", "Of a jump, on the run's clock [s].")
      .field<&InstrumentError::at_standard_error>("at_standard_error", "[s]")
      .field<&InstrumentError::readings>("readings", "What a lateness may be, where several things look alike.")
      .of()
      .def_property_readonly(
          "unit", [](const InstrumentError& e) { return unit_of(e); },
          "\"s\", \"rad\", \"rad/s\", \"m\", \"m/s\" or \"\".")
      .def_property_readonly(
          "is_mistake", [](const InstrumentError& e) { return is_mistake(e.kind); },
          "No number of the run can be believed before it is mended: sign, unit, order.")
      .def_property_readonly(
          "words", [](const InstrumentError& e) { return words_for(e); }, "\"yaw rate: zero 0.031 ± 0.002 deg/s\"")
      .def_property_readonly("remedy", &remedy_for, "What mends a mistake; empty for others.");
  Record<ChannelCharacter>(m, "ChannelCharacter", "What the samples of a channel are like.")
      .field<&ChannelCharacter::channel>("channel", "By its short name.")
      .field<&ChannelCharacter::samples>("samples", "With a value.")
      .field<&ChannelCharacter::step>("step", "Of rounding; 0 if none is seen.")
      .field<&ChannelCharacter::noise>("noise", "Standard deviation of the white part.")
      .field<&ChannelCharacter::interval>("interval", "Mean time between samples that were measured [s].")
      .field<&ChannelCharacter::interpolated>("interpolated", "Samples between fixes are on straight lines.")
      .field<&ChannelCharacter::outliers>("outliers", "Places of single samples far from both neighbours.")
      .field<&ChannelCharacter::measured>("measured", "Places of samples that were really measured.");
  Record<DerivedChannel>(m, "DerivedChannel", "A channel that was not measured.")
      .field<&DerivedChannel::channel>("channel", "By its short name.")
      .field<&DerivedChannel::made_of>("made_of", "What it was made of.");
  Record<RunCheck>(m, "RunCheck", "What kinematics say of the instruments of one run.")
      .field<&RunCheck::run>("run", "Its name.")
      .field<&RunCheck::group>("group", "As Recording.group.")
      .field<&RunCheck::channels>("channels", "What the samples are like.")
      .field<&RunCheck::errors>("errors", "Those that could be told, and those that could not: `told`.")
      .field<&RunCheck::derived>("derived", "Channels that were not measured.")
      .field<&RunCheck::gaps>("gaps", "Begin, end, begin, end … without samples [s].")
      .field<&RunCheck::cannot_tell>("cannot_tell", "What this run has no channels or no motion for.")
      .of()
      .def_property_readonly(
          "told",
          [](const RunCheck& check) {
            auto errors = check.errors;
            std::erase_if(errors, [](const InstrumentError& e) { return !e.told; });
            return errors;
          },
          "The errors that were told.")
      .def_property_readonly(
          "mistake",
          [](const RunCheck& check) {
            const auto* mistake = check.mistake();
            return mistake ? std::optional(*mistake) : std::nullopt;
          },
          "The first that forbids to believe the run, if there is one.");
  Record<GroupCheck>(m, "GroupCheck", "What the runs of a group have in common.")
      .field<&GroupCheck::group>("group", "Its name.")
      .field<&GroupCheck::runs>("runs", "Their names.")
      .field<&GroupCheck::errors>("errors", "Pooled.");
}

}  // namespace

void add_checks(py::module_& m) {
  add_results(m);
  m.def("check", &check_run, py::arg("run"), Unlocked(),
        "Instruments judged by kinematics alone, before any ship is: sign, units, noise, clocks, zeros, scales, axes, "
        "lever arm. Raises Refusal for a run of fewer than 20 samples. Source: [Klein2006] chapter 10"
        "\n\nrun: whose channels are compared with each other.");
  m.def(
      "check_groups", [](const std::vector<RunCheck>& checks) { return grouped(checks); }, py::arg("checks"),
      "Errors that runs with the same instruments have in common, pooled."
      "\n\nchecks: of `check`, one for each run. The result has one GroupCheck for each group.");
  m.def("repaired", &repaired, py::arg("run"), py::arg("check"), Unlocked(),
        "The run without the errors that were told, and without outliers."
        "\n\nrun: that was checked. check: of `check`.");
  m.def("without_outliers", &without_outliers, py::arg("run"), Unlocked(),
        "The run with outliers of the channels that show the motion missing."
        "\n\nrun: a recording, perhaps with wrong fixes of the satellites.");
  m.def("measured_samples", &measured_samples_of, py::arg("run"), py::arg("channel"),
        "Places of the samples of a channel that were really measured."
        "\n\nrun: a recording, perhaps of a logger that repeats old values. channel: by its short name.");
}

}  // namespace swayaw::python
