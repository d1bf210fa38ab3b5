#include "module.hpp"
#include "noise.hpp"
#include "record.hpp"
#include "swayaw/identification/force_fit.hpp"
#include "swayaw/identification/identify.hpp"
#include "swayaw/identification/state_estimate.hpp"
#include "swayaw/nonlinear/writable_ship.hpp"

namespace swayaw::python {

template <>
struct Words<Verdict> : NamedWords<Verdict, 3, in_words> {};
template <>
struct Words<ForceComponent> : NamedWords<ForceComponent, 3, in_words> {};
template <>
struct Words<StraightCourse> {
  static std::vector<std::string> list() { return {"stable", "unstable", "not_told"}; }
};

namespace {

// ---------------------------------------------------------------- states

constexpr std::size_t state_size = 9;

std::array<double, state_size> vector_of_state(const EstimatedState& s) {
  const auto& [x, y, psi, motion] = s.state;
  return {x, y, psi, motion.u, motion.v, motion.r, s.unmodelled.u, s.unmodelled.v, s.unmodelled.r};
}

py::array_t<double> state_matrix(const StateEstimate& estimate) {
  py::array_t<double> result({estimate.states.size(), state_size});
  auto rows = result.mutable_unchecked<2>();
  for (std::size_t i = 0; i < estimate.states.size(); ++i) {
    const auto state = vector_of_state(estimate.states[i]);
    for (std::size_t k = 0; k < state_size; ++k)
      rows(static_cast<py::ssize_t>(i), static_cast<py::ssize_t>(k)) = state[k];
  }
  return result;
}

py::array_t<double> covariances(const StateEstimate& estimate) {
  py::array_t<double> result({estimate.states.size(), state_size, state_size});
  auto all = result.mutable_unchecked<3>();
  for (std::size_t n = 0; n < estimate.states.size(); ++n)
    for (std::size_t i = 0; i < state_size; ++i)
      for (std::size_t k = 0; k < state_size; ++k)
        all(static_cast<py::ssize_t>(n), static_cast<py::ssize_t>(i), static_cast<py::ssize_t>(k)) =
            estimate.states[n].covariance(i, k);
  return result;
}

EstimationOptions estimation_options(std::vector<Channel> channels, const NoiseByChannel& noise,
                                     const std::optional<PlanarAcceleration<double>>& process_noise, bool coloured,
                                     double memory, bool smooth) {
  EstimationOptions options{.channels = std::move(channels), .noise = noise_from(noise), .process_noise = {}};
  if (process_noise) options.process_noise = ProcessNoise{*process_noise};
  options.coloured = coloured, options.memory = memory, options.smooth = smooth;
  return options;
}

void add_states(py::module_& m) {
  Record<ChannelInnovation>(m, "ChannelInnovation",
                            "How well the prediction of a channel from the past agreed with it.")
      .field<&ChannelInnovation::channel>("channel", "By its short name.")
      .field<&ChannelInnovation::noise>("noise", "Standard deviation, known or estimated, SI.")
      .field<&ChannelInnovation::rms>("rms", "Of prediction errors over their expected size: 1 for a right filter.")
      .field<&ChannelInnovation::autocorrelation>("autocorrelation", "Of successive ones: 0 for a right filter.")
      .field<&ChannelInnovation::count>("count", "");
  py::class_<StateEstimate>(m, "StateEstimate", "Where a recorded ship really was, how she moved, and what pushed her.")
      .def_property_readonly_static(
          "names", [](py::handle) { return py::make_tuple("x", "y", "psi", "u", "v", "r", "surge", "sway", "yaw"); },
          "Of the columns: state and unmodelled accelerations, SI.")
      .def_property_readonly(
          "time",
          [](const StateEstimate& e) {
            std::vector<double> time;
            for (const auto& state : e.states) time.push_back(state.time);
            return owned(std::move(time));
          },
          "[s]")
      .def_property_readonly("states", &state_matrix, "numpy.ndarray, a row for each sample, columns as `names`.")
      .def_property_readonly("covariances", &covariances, "numpy.ndarray, samples by 9 by 9.")
      .def_readonly("innovations", &StateEstimate::innovations)
      .def_property_readonly(
          "noise", [](const StateEstimate& e) { return noise_of(e.noise.noise); },
          "Standard deviation by channel, known or estimated, SI.")
      .def_property_readonly(
          "process_noise", [](const StateEstimate& e) { return e.noise.process_noise.size; },
          "Size of the unmodelled accelerations.")
      .def_property_readonly("log_likelihood", [](const StateEstimate& e) { return e.noise.log_likelihood; })
      .def_property_readonly("converged", [](const StateEstimate& e) { return e.noise.converged; })
      .def("recording", &StateEstimate::recording, py::arg("run"),
           "The estimated motion as a recording; rudder and propulsion as in the run it came from.");
  m.def(
      "estimate_states",
      [](const Ship& ship, const Recording& run, std::vector<Channel> channels, const NoiseByChannel& noise,
         const std::optional<PlanarAcceleration<double>>& process_noise, bool coloured, double memory, bool smooth) {
        return estimate_states(ship, run,
                               estimation_options(std::move(channels), noise, process_noise, coloured, memory, smooth));
      },
      py::arg("ship"), py::arg("run"), py::kw_only(), py::arg("channels") = std::vector<Channel>{},
      py::arg("noise") = NoiseByChannel{}, py::arg("process_noise") = py::none(), py::arg("coloured") = true,
      py::arg("memory") = EstimationOptions{}.memory, py::arg("smooth") = true, Unlocked(),
      "States of a recorded ship by an extended Kalman filter with the ship as predictor, and smoother. channels: to "
      "be "
      "used, all that the run has unless given. noise: known standard deviations by channel, SI; process_noise: known "
      "size; what is not known is estimated from the run. memory: of the unmodelled accelerations in ship lengths. "
      "Raises Refusal if the run has no rudder angle, or none of the channels tells position or speed.");
}

// ---------------------------------------------------------------- forces

void add_estimate(py::module_& m) {
  Record<Estimate>(m, "Estimate",
                   "A number with its standard error; NaN, with infinite error, where data do not tell it.")
      .field<&Estimate::value>("value", "")
      .field<&Estimate::standard_error>("standard_error", "")
      .of()
      .def_property_readonly("verdict", &Estimate::verdict, "determined, weakly determined or not determined.")
      .def("__float__", [](const Estimate& e) { return e.value; });
}

void add_force_fit(py::module_& m) {
  Record<Coefficient>(m, "Coefficient", "A coefficient and what the data tell of it.")
      .field<&Coefficient::name>("name", "Key of the ship file.")
      .field<&Coefficient::estimate>("estimate", "In the unit of the ship file.")
      .field<&Coefficient::low>("low", "95 % interval.")
      .field<&Coefficient::high>("high", "95 % interval.")
      .field<&Coefficient::variance_inflation>("variance_inflation", "1 where it is orthogonal to all others.")
      .field<&Coefficient::attenuation>("attenuation", "What errors of the features take of it.")
      .field<&Coefficient::undetermined>("undetermined", "It could change so much that its force were half of all.");
  py::class_<ForceEquation>(m, "ForceEquation", "One of the three force equations and the coefficients in it.")
      .def_readonly("component", &ForceEquation::component, "X, Y or N.")
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
          "Sums that the data do not determine, worst first: \"Y_v - 0.98 Y_r\".")
      .def_property_readonly(
          "bias", [](const ForceEquation& e) { return e.bias; },
          "How far errors of the estimated motion may have moved each coefficient.");
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
  py::class_<ForceFit>(m, "ForceFit", "Coefficients of a ship from the forces that recorded ships must have felt.")
      .def_readonly("ship", &ForceFit::ship, "With the coefficients found.")
      .def_readonly("equations", &ForceFit::equations)
      .def_property_readonly(
          "coefficients",
          [](const ForceFit& fit) {
            py::dict all;
            for (const auto& equation : fit.equations)
              for (const auto& c : equation.fit.coefficients) all[py::str(c.name)] = c;
            return all;
          },
          "Of all equations, by name.")
      .def_readonly("range", &ForceFit::range)
      .def_readonly("states", &ForceFit::states, "Of each run.")
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
      "confidence, count as measurements. Source: [Alexandersson2024] section 3.4");
  m.def("usual_parameters", &usual_parameters, py::arg("ship"),
        "Coefficients that are looked for unless others are named.");
  m.def("in_model", &in_model, py::arg("ship"), py::arg("model"),
        "The ship in another model, \"mmg\", \"pi\" or \"pu\", with the same hull, propeller and steering gear.");
  m.def(
      "writable",
      [](const Ship& found, const Ship& beginning) {
        auto result = writable(found, beginning);
        return std::pair(std::move(result.ship), std::move(result.changed));
      },
      py::arg("found"), py::arg("beginning"),
      "The ship as a file can hold her, and what had to give way for that, in words.");
}

}  // namespace

void add_fits(py::module_& m) {
  add_estimate(m);
  add_states(m);
  add_force_fit(m);
}

}  // namespace swayaw::python
