#include "swayaw/identification/captive.hpp"

#include "fit_words.hpp"
#include "module.hpp"
#include "record.hpp"

namespace swayaw::python {

template <>
struct Words<HullTerms> {
  static std::vector<std::string> list() { return {"linear", "cubic"}; }
};

namespace {

void add_points(py::module_& m) {
  Record<CaptiveMoment>(m, "CaptiveMoment", "A moment of a captive test.", Made::by_anyone)
      .field<&CaptiveMoment::motion>("motion", "That the carriage imposes.")
      .optional<&CaptiveMoment::acceleration>("acceleration", "Likewise.")
      .optional<&CaptiveMoment::controls>("controls", "Rudder and propulsion.")
      .optional<&CaptiveMoment::weight>("weight", "Forces of a test are Σ weight × force over its moments.");
  Record<CaptivePoint>(m, "CaptivePoint", "One measurement of a captive test.", Made::by_anyone)
      .field<&CaptivePoint::run>("run", "Its name.")
      .field<&CaptivePoint::tests>("tests", "Kinds of test it belongs to: \"static_drift\", \"pure_yaw:velocity\".")
      .field<&CaptivePoint::moments>("moments", "One for a steady test, a cycle for a Fourier coefficient.")
      .field<&CaptivePoint::measured>("measured", "About midship [N, N m]; NaN where it was not measured.")
      .optional<&CaptivePoint::with_inertia>("with_inertia", "The force that accelerates the model is still in it.");
  Record<CaptiveSelection>(m, "CaptiveSelection", "Which points of captive tests.", Made::by_anyone)
      .optional<&CaptiveSelection::tests>("tests", "Of one of these kinds; empty for every kind.")
      .optional<&CaptiveSelection::max_drift>("max_drift", "[rad]")
      .optional<&CaptiveSelection::max_rudder>("max_rudder", "[rad]")
      .optional<&CaptiveSelection::min_rudder>("min_rudder", "[rad]")
      .optional<&CaptiveSelection::min_speed>("min_speed", "[m/s]")
      .optional<&CaptiveSelection::without_runs>("without_runs", "Names.");
  m.def(
      "read_captive",
      [](const std::filesystem::path& file, double length, double density, Maybe towed_length, Maybe towed_density,
         std::string test, Maybe thrust_prime) {
        return read_captive(file, {.L = length,
                                   .rho = density,
                                   .towed_L = towed_length,
                                   .towed_rho = towed_density,
                                   .test = std::move(test),
                                   .thrust_prime = thrust_prime});
      },
      py::arg("file"), py::arg("length"), py::kw_only(), py::arg("density") = CaptiveFile{.L = 1.0}.rho,
      py::arg("towed_length") = py::none(), py::arg("towed_density") = py::none(), py::arg("test") = "",
      py::arg("thrust_prime") = py::none(), Unlocked(),
      "Points of captive tests from a table with a header, units in the names of its columns (docs/captive_tests.md)."
      "\n\nlength: of the ship [m]; density: of her water [kg/m³]. towed_length, towed_density: of the model in the "
      "tank, where it was another. test: kind of all tests, where the file does not say. thrust_prime: T/(½ρL²U²), "
      "likewise. Raises FileError that names the column that is missing, or the cell that is no number.");
  m.def(
      "selected",
      [](const std::vector<CaptivePoint>& points, const CaptiveSelection& s) { return selected(points, s); },
      py::arg("points"), py::arg("selection"),
      "Those of captive points that a selection takes.\n\npoints: of `read_captive`. selection: a CaptiveSelection.");
}

void add_errors(py::module_& m) {
  Record<CaptiveError>(m, "CaptiveError", "Model less measurement, as primes over ½ρL²U² and ½ρL³U²; NaN without any.")
      .field<&CaptiveError::points>("points", "How many.")
      .field<&CaptiveError::rms>("rms", "Of model less measured.")
      .field<&CaptiveError::measured>("measured", "Rms of what was measured.")
      .of()
      .def_property_readonly("relative", &CaptiveError::relative, "rms of the error over that of the measurement.");
  m.def(
      "captive_force", &captive_force, py::arg("ship"), py::arg("point"),
      "Force that a captive test would measure of a ship, PlanarForce [N, N m].\n\nship: any of a nonlinear model. "
      "point: motion, controls and acceleration; less what accelerates the entrained water, and less what accelerates "
      "the ship herself where that is in the measurement.");
  m.def(
      "captive_error",
      [](const Ship& ship, const std::vector<CaptivePoint>& points, const CaptiveSelection& selection) {
        return captive_error(ship, points, selection);
      },
      py::arg("ship"), py::arg("points"), py::arg("selection") = CaptiveSelection{}, Unlocked(),
      "How far a ship is off captive tests.\n\nship: any of a nonlinear model. points: of `read_captive`. selection: "
      "which of them count, all unless given.");
}

void add_fit(py::module_& m) {
  Record<CaptiveStep>(m, "CaptiveStep", "Some coefficients from some captive tests.", Made::by_anyone)
      .field<&CaptiveStep::points>("points", "Which, a CaptiveSelection.")
      .field<&CaptiveStep::component>("component", "X, Y or N.")
      .field<&CaptiveStep::coefficients>("coefficients", "Keys of the ship file.");
  Record<CaptivePlan>(m, "CaptivePlan", "Steps in their order: what one has found is known to the next.",
                      Made::by_anyone)
      .field<&CaptivePlan::steps>("steps", "In their order.")
      .optional<&CaptivePlan::validation>("validation", "Points that no step may use.");
  Record<CaptiveStepReport>(m, "CaptiveStepReport", "What a step found.")
      .field<&CaptiveStepReport::step>("step", "As planned.")
      .field<&CaptiveStepReport::points>("points", "How many it used.")
      .field<&CaptiveStepReport::fit>("fit", "Of primes; coefficients in SI or as the primes they are.")
      .field<&CaptiveStepReport::validation>("validation", "Of the ship with what is found so far.");
  Record<CaptiveFit>(m, "CaptiveFit", "A ship from captive tests.")
      .field<&CaptiveFit::ship>("ship", "With the coefficients found.")
      .field<&CaptiveFit::steps>("steps", "In their order.")
      .field<&CaptiveFit::validation>("validation", "After the last step.");
  m.def(
      "captive_plan",
      [](const Ship& ship, const std::vector<CaptivePoint>& points, HullTerms terms, double max_drift) {
        return captive_plan(ship, points, terms, max_drift);
      },
      py::arg("ship"), py::arg("points"), py::arg("terms") = HullTerms::linear,
      py::arg("max_drift") = CaptiveSelection{}.max_drift,
      "The steps of Alexandersson et al. 2024, table 3, and like ones for yawing, cubic terms and added mass: those "
      "whose coefficients the model has and whose tests are among the points (docs/captive_tests.md).\n\nship: whose "
      "coefficients are looked for. points: of `read_captive`. terms: of the hull, \"linear\" or \"cubic\". max_drift: "
      "of the points that are used [rad].");
  m.def(
      "fit_captive",
      [](const Ship& ship, const std::vector<CaptivePoint>& points, const CaptivePlan& plan, double ridge) {
        RegressionOptions options;
        options.ridge = ridge;
        return fit_captive(ship, points, plan, options);
      },
      py::arg("ship"), py::arg("points"), py::arg("plan"), py::kw_only(), py::arg("ridge") = 0.0, Unlocked(),
      "Coefficients from captive tests, step by step; standard errors take what earlier steps found for exact. Source: "
      "[Alexandersson2024] section 3.1, tables 2, 3\n\nship: whose other numbers are known. points: of `read_captive`. "
      "plan: a CaptivePlan, of `captive_plan` or your own. ridge: shrinks as if so many points had said 0. Raises "
      "Refusal "
      "if the model lacks a coefficient, its force is not linear in the coefficients of a step, points are both fitted "
      "and kept for validation, or a step has too few points.");
}

}  // namespace

void add_captive(py::module_& m) {
  add_points(m);
  add_errors(m);
  add_fit(m);
}

}  // namespace swayaw::python
