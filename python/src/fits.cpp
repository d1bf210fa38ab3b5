#include "fit_words.hpp"
#include "module.hpp"
#include "record.hpp"
#include "swayaw/identification/force_fit.hpp"
#include "swayaw/identification/identify.hpp"
#include "swayaw/nonlinear/writable_ship.hpp"

namespace swayaw::python {

template <>
struct Words<StraightCourse> {
  static std::vector<std::string> list() { return {"stable", "unstable", "not_told"}; }
};

namespace {

// ---------------------------------------------------------------- forces

void add_force_fit(py::module_& m) {
  Record<ForceEquation>(m, "ForceEquation", "One of the three force equations and the coefficients in it.")
      .field<&ForceEquation::component>("component", "X, Y or N.")
      .field<&ForceEquation::fit>("fit", "Of forces over ½ρL²U², moments over ½ρL³U².")
      .field<&ForceEquation::bias>("bias", "How far errors of the estimated motion may have moved each coefficient.")
      .of()
      .def_property_readonly("coefficients", [](const ForceEquation& e) { return e.fit.coefficients; })
      .def_property_readonly(
          "R2", [](const ForceEquation& e) { return e.fit.R2; }, "Share of the variance explained.")
      .def_property_readonly("residual_rms", [](const ForceEquation& e) { return e.fit.residual_rms; })
      .def_property_readonly(
          "samples", [](const ForceEquation& e) { return e.fit.samples; }, "Effective number.")
      .def_property_readonly("condition_number", [](const ForceEquation& e) { return e.fit.condition_number; })
      .def_property_readonly(
          "undetermined",
          [](const ForceEquation& e) {
            std::vector<std::string> words;
            for (const auto& combination : e.fit.undetermined) words.push_back(in_words(combination));
            return words;
          },
          "Sums that the data do not determine, worst first: \"Y_v - 0.98 Y_r\".");
  Record<MotionRange>(m, "MotionRange", "Largest motions in recordings; what is said holds for motions of this size.")
      .field<&MotionRange::drift>("drift", "[rad]")
      .field<&MotionRange::omega>("omega", "|r'|")
      .field<&MotionRange::rudder>("rudder", "[rad]");
  Record<StabilityVerdict>(m, "StabilityVerdict", "Whether the fitted ship keeps a straight course.")
      .field<&StabilityVerdict::straight_course>("straight_course", "stable, unstable or not_told.")
      .field<&StabilityVerdict::e0>("e0", "Stable where positive: 1/(T1' T2').")
      .field<&StabilityVerdict::standard_error>("standard_error", "")
      .field<&StabilityVerdict::range>("range", "")
      .field<&StabilityVerdict::linear_hull>("linear_hull", "The fitted hull has no nonlinear term in sway and yaw.")
      .field<&StabilityVerdict::words>("words", "One sentence.");
  Record<ForceFit>(m, "ForceFit", "Coefficients of a ship from the forces that recorded ships must have felt.")
      .field<&ForceFit::ship>("ship", "With the coefficients found.")
      .field<&ForceFit::equations>("equations", "Those that have a coefficient to be found.")
      .field<&ForceFit::range>("range", "Of the motions.")
      .field<&ForceFit::states>("states", "Of each run.")
      .of()
      .def_property_readonly(
          "coefficients",
          [](const ForceFit& fit) {
            py::dict all;
            for (const auto& equation : fit.equations)
              for (const auto& c : equation.fit.coefficients) all[py::str(c.name)] = c;
            return all;
          },
          "Of all equations, by name.")
      .def_property_readonly("stability", &stability_verdict, "Whether the fitted ship keeps a straight course.");
  m.def(
      "fit_forces",
      [](const Ship& ship, const std::vector<Recording>& runs, std::optional<std::vector<std::string>> parameters,
         std::vector<Channel> channels, bool priors, double ridge) {
        ForceFitOptions options{.parameters = parameters ? std::move(*parameters) : usual_parameters(ship)};
        options.states.channels = std::move(channels);
        options.priors = priors, options.ridge = ridge;
        return fit_forces(ship, runs, options);
      },
      py::arg("ship"), py::arg("runs"), py::arg("parameters") = py::none(), py::kw_only(),
      py::arg("channels") = std::vector<Channel>{}, py::arg("priors") = false, py::arg("ridge") = 0.0, Unlocked(),
      "Coefficients that act linearly, by least squares on the forces of inverse dynamics: F(t) - F_known(t) = Σ "
      "theta_i "
      "∂F/∂theta_i. parameters: by name, the usual ones unless given. priors: the parameters as given, with the ship's "
      "confidence, count as measurements. Source: [Alexandersson2024] section 3.4"
      "\n\nship: whose other numbers are known. runs: recordings. channels: that the estimates of states use, all that "
      "a run has unless given. ridge: shrinks as if so many samples had said 0. Raises Refusal if there is nothing to "
      "find, a number does not exist or does not act linearly, or a run cannot be estimated.");
  m.def("usual_parameters", &usual_parameters, py::arg("ship"),
        "Coefficients that are looked for unless others are named."
        "\n\nship: those of her hull that are not 0, and of a PU ship those of the rudder.");
  m.def("in_model", &in_model, py::arg("ship"), py::arg("model"),
        "The ship in another model, \"mmg\", \"pi\" or \"pu\", with the same hull, propeller and steering gear."
        "\n\nship: of a nonlinear model. model: its name. Raises Refusal where the other model needs numbers that she "
        "does not have.");
  m.def(
      "writable",
      [](const Ship& found, const Ship& beginning) {
        auto result = writable(found, beginning);
        return std::pair(std::move(result.ship), std::move(result.changed));
      },
      py::arg("found"), py::arg("beginning"),
      "The ship as a file can hold her, and what had to give way for that, in words."
      "\n\nfound: as a fit left her. beginning: she whom the fit began with.");
}

// ---------------------------------------------------------------- choice of runs, zigzags

void add_choices(py::module_& m) {
  Record<Resample>(m, "Resample", "Coefficients from some of the runs.")
      .field<&Resample::runs>("runs", "\"all but zz10.csv\", \"zz10.csv alone\", \"rudder 20 deg alone\"")
      .field<&Resample::values>("values", "In the order of the parameters; None where not determined.");
  m.def(
      "resample",
      [](const Ship& ship, const std::vector<Recording>& runs, const ForceFit& fit,
         std::optional<std::vector<std::string>> parameters, bool priors, double ridge) {
        ForceFitOptions options{.parameters = parameters ? std::move(*parameters) : usual_parameters(ship)};
        options.priors = priors, options.ridge = ridge;
        return resample(ship, runs, fit, options);
      },
      py::arg("ship"), py::arg("runs"), py::arg("fit"), py::arg("parameters") = py::none(), py::kw_only(),
      py::arg("priors") = false, py::arg("ridge") = 0.0, Unlocked(),
      "How much coefficients depend on the choice of runs: from all runs, without each, from each alone, and from each "
      "rudder amplitude alone.\n\nship, runs, parameters, priors, ridge: as `fit_forces` was given them. fit: its "
      "result, whose states are taken.");
  m.def("zigzag_order", &zigzag_order, py::arg("run"),
        "Rudder, heading and first side of the zigzag that a run says it is; None for other runs.\n\nrun: its "
        "`manoeuvre` is read.");
  m.def("recorded_overshoots", &recorded_overshoots, py::arg("run"), py::arg("order"),
        "Heading peaks beyond the switch angle in a recorded zigzag as they come [rad].\n\nrun: as recorded. order: a "
        "ZigzagOrder, of `zigzag_order`.");
  m.def("simulated_overshoots", &simulated_overshoots, py::arg("ship"), py::arg("run"), py::arg("order"),
        py::arg("most"), Unlocked(),
        "Overshoots of a ship in the zigzag of a run, from its recorded speed with its mean shaft speed or thrust "
        "[rad].\n\nship: who sails. run, order: the recorded zigzag. most: how many overshoots. None where she cannot "
        "sail it.");
}

}  // namespace

void add_fits(py::module_& m) {
  add_force_fit(m);
  add_choices(m);
}

}  // namespace swayaw::python
