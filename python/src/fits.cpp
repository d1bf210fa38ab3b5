#include "module.hpp"
#include "progress.hpp"
#include "record.hpp"
#include "swayaw/identification/force_fit.hpp"
#include "swayaw/identification/identify.hpp"
#include "swayaw/identification/linear_fit.hpp"
#include "swayaw/identification/nomoto_zigzag.hpp"
#include "swayaw/identification/state_estimate.hpp"
#include "swayaw/identification/trajectory_fit.hpp"
#include "swayaw/nonlinear/writable_ship.hpp"

namespace swayaw::python {

template <>
struct Words<Verdict> : NamedWords<Verdict, 3, in_words> {};
template <>
struct Words<FitStatus> : NamedWords<FitStatus, 3, in_words> {};
template <>
struct Words<ForceComponent> : NamedWords<ForceComponent, 3, in_words> {};
template <>
struct Words<StraightCourse> {
  static std::vector<std::string> list() { return {"stable", "unstable", "not_told"}; }
};
template <>
struct Words<TrajectoryFitStatus> {
  static std::vector<std::string> list() { return {"converged", "iteration_limit", "stopped", "rank_deficient"}; }
};

namespace {

// ---------------------------------------------------------------- noise by channel

using NoiseByChannel = std::map<std::string, double>;

MeasurementNoise noise_from(const NoiseByChannel& given) {
  MeasurementNoise noise{};
  for (const auto& [name, deviation] : given) noise[index_of(named<Channel>(name))] = deviation;
  return noise;
}

py::dict noise_of(const MeasurementNoise& noise) {
  py::dict result;
  for (std::size_t i = 0; i < channel_count; ++i)
    if (noise[i]) result[py::str(short_name(static_cast<Channel>(i)))] = *noise[i];
  return result;
}

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

// ---------------------------------------------------------------- trajectories

py::dict parameters_told(const TrajectoryProgress& p, const std::vector<std::string>& names) {
  py::dict values;
  for (std::size_t i = 0; i < names.size() && i < p.values.size(); ++i) values[py::str(names[i])] = p.values[i];
  return values;
}

void add_trajectory_fit(py::module_& m) {
  Record<FittedParameter>(m, "FittedParameter", "A parameter before and after a fit, SI.")
      .field<&FittedParameter::name>("name", "Key of the ship file.")
      .field<&FittedParameter::before>("before", "In the ship that was given.")
      .field<&FittedParameter::estimate>("estimate", "")
      .field<&FittedParameter::at_bound>("at_bound", "The value is the last one that her model accepts.");
  Record<ChannelResiduals>(m, "ChannelResiduals", "What a run leaves unexplained in a channel, SI.")
      .field<&ChannelResiduals::channel>("channel", "By its short name.")
      .field<&ChannelResiduals::count>("count", "")
      .field<&ChannelResiduals::before>("before", "Rms with the ship that was given.")
      .field<&ChannelResiduals::after>("after", "Rms with the fitted ship.")
      .field<&ChannelResiduals::autocorrelation>("autocorrelation", "Near 0 where the model and the noise are right.")
      .field<&ChannelResiduals::effective_count>("effective_count", "");
  Record<FittedRun>(m, "FittedRun", "A run of a trajectory fit.")
      .field<&FittedRun::name>("name", "")
      .field<&FittedRun::start>("start", "Fitted, at the first sample.")
      .field<&FittedRun::channels>("channels", "");
  py::class_<TrajectoryFit>(m, "TrajectoryFit", "A ship whose simulation runs through recordings.")
      .def_readonly("ship", &TrajectoryFit::ship, "With the fitted parameters.")
      .def_readonly("status", &TrajectoryFit::status, "converged, iteration_limit, stopped or rank_deficient.")
      .def_readonly("parameters", &TrajectoryFit::parameters, "In the order of the question.")
      .def_property_readonly(
          "covariance", [](const TrajectoryFit& f) { return matrix(f.covariance); },
          "Of the parameters, SI: numpy.ndarray.")
      .def_property_readonly(
          "correlation", [](const TrajectoryFit& f) { return matrix(f.correlation); }, "numpy.ndarray")
      .def_readonly("condition_number", &TrajectoryFit::condition_number)
      .def_readonly("best_combination", &TrajectoryFit::best_combination,
                    "Which product of powers is known best: \"|Y_v|^0.71 |N_v|^-0.70 to 0.4 %\".")
      .def_readonly("undetermined", &TrajectoryFit::undetermined, "Relative error of 50 % and more, worst first.")
      .def_property_readonly(
          "noise", [](const TrajectoryFit& f) { return noise_of(f.noise); }, "By channel, SI.")
      .def_readonly("log_likelihood", &TrajectoryFit::log_likelihood)
      .def_readonly("runs", &TrajectoryFit::runs)
      .def_readonly("iterations", &TrajectoryFit::iterations);
  m.def(
      "fit_trajectories",
      [](const Ship& ship, const std::vector<Recording>& runs, std::optional<std::vector<std::string>> parameters,
         std::vector<Channel> channels, const NoiseByChannel& noise, bool priors, Maybe robust, double segment,
         int most_iterations, unsigned threads, py::object progress) {
        Listener listener(std::move(progress));
        TrajectoryFitOptions options{.parameters = parameters ? std::move(*parameters) : usual_parameters(ship),
                                     .channels = std::move(channels),
                                     .noise = noise_from(noise),
                                     .segment = segment,
                                     .priors = priors,
                                     .robust = robust,
                                     .most_iterations = most_iterations,
                                     .threads = threads};
        options.progress = [&](const TrajectoryProgress& p) {
          const py::gil_scoped_acquire locked;
          return listener.tell(p.iteration, p.log_likelihood, p.change, parameters_told(p, options.parameters));
        };
        return listened_to(listener, [&] { return fit_trajectories(ship, runs, options); });
      },
      py::arg("ship"), py::arg("runs"), py::arg("parameters") = py::none(), py::kw_only(),
      py::arg("channels") = std::vector<Channel>{}, py::arg("noise") = NoiseByChannel{}, py::arg("priors") = false,
      py::arg("robust") = py::none(), py::arg("segment") = 0.5, py::arg("most_iterations") = 100,
      py::arg("threads") = 0U, py::arg("progress") = py::none(),
      "Parameters of a ship fitted to recordings by multiple shooting, maximum likelihood of white measurement noise, "
      "with exact derivatives (docs/trajectory_fit.md).\n\nprogress: a function of iteration, log likelihood, relative "
      "change and a dictionary of the parameters (SI); False ends the fit with the best so far. Ctrl-C raises "
      "KeyboardInterrupt. threads: 0 for one on each core.");
}

// ---------------------------------------------------------------- linear

void add_linear_fit(py::module_& m) {
  using C = SwayYawCoefficients<Estimate>;
  Record<C>(m, "CoefficientEstimates", "Fitted coefficients of the coupled equations, dimensionless.")
      .field<&C::a1>("a1", "")
      .field<&C::b1>("b1", "")
      .field<&C::c1>("c1", "")
      .field<&C::a2>("a2", "")
      .field<&C::b2>("b2", "")
      .field<&C::c2>("c2", "");
  using I = SteeringIndices<Estimate>;
  Record<I>(m, "IndexEstimates", "Fitted steering indices, dimensionless.")
      .field<&I::T1T2>("T1T2", "")
      .field<&I::T1_plus_T2>("T1_plus_T2", "")
      .field<&I::T3b>("T3b", "")
      .field<&I::T3w>("T3w", "")
      .field<&I::Kb>("Kb", "")
      .field<&I::Kw>("Kw", "");
  using T = TimeConstants<Estimate>;
  Record<T>(m, "TimeConstantEstimates", "Fitted T1 and T2, dimensionless.")
      .field<&T::T1>("T1", "")
      .field<&T::T2>("T2", "");
  Record<LinearResiduals>(m, "LinearResiduals", "Rms of what the fit leaves unexplained; NaN for a channel not used.")
      .field<&LinearResiduals::psi>("psi", "[rad]")
      .field<&LinearResiduals::r>("r", "[rad/s]")
      .field<&LinearResiduals::beta>("beta", "[rad]");
  Record<LinearAmplitude>(m, "LinearAmplitude", "Largest motions among the samples used.")
      .field<&LinearAmplitude::rudder>("rudder", "[rad]")
      .field<&LinearAmplitude::drift>("drift", "[rad]; NaN without drift.")
      .field<&LinearAmplitude::omega>("omega", "rL/U");
  py::class_<LinearFit>(m, "LinearFit", R"(The linear sway–yaw equations that explain recordings.

Where drift was not recorded, only the transfer function of yaw and its indices are determined.)")
      .def_readonly("status", &LinearFit::status)
      .def_readonly("scale", &LinearFit::scale, "Length and mean speed.")
      .def_readonly("coefficients", &LinearFit::coefficients)
      .def_readonly("indices", &LinearFit::indices)
      .def_readonly("time_constants", &LinearFit::time_constants, "None when they are a complex pair.")
      .def_readonly("rudder_offset", &LinearFit::rudder_offset, "Recorded angle plus this acts [rad].")
      .def_readonly("one_step", &LinearFit::one_step, "From one measurement to the next.")
      .def_readonly("whole_run", &LinearFit::whole_run, "Of the simulation of the whole run.")
      .def_property_readonly(
          "covariance", [](const LinearFit& f) { return matrix(f.covariance); },
          "Of a1, b1, c1, a2, b2, c2: numpy.ndarray.")
      .def_readonly("condition_number", &LinearFit::condition_number)
      .def_readonly("best_combination", &LinearFit::best_combination)
      .def_readonly("worst_combination", &LinearFit::worst_combination)
      .def_readonly("stable", &LinearFit::stable)
      .def_readonly("probability_stable", &LinearFit::probability_stable)
      .def_readonly("amplitude", &LinearFit::amplitude, "A verdict on stability holds for motions of this size.")
      .def_readonly("samples", &LinearFit::samples);
  m.def(
      "fit_linear",
      [](const std::vector<Recording>& runs, double L, Maybe U, bool use_drift, bool disturbances, bool rudder_offset,
         double spacing) {
        return fit_linear(runs, {.L = L,
                                 .U = U,
                                 .use_drift = use_drift,
                                 .spacing = spacing,
                                 .disturbances = disturbances,
                                 .rudder_offset = rudder_offset});
      },
      py::arg("runs"), py::arg("length"), py::kw_only(), py::arg("speed") = py::none(), py::arg("use_drift") = true,
      py::arg("disturbances") = true, py::arg("rudder_offset") = true, py::arg("spacing") = 0.1, Unlocked(),
      "Both second-order equations fitted to recordings of any ship of that length [m], stable or not: maximum "
      "likelihood of the one-step prediction errors of a Kalman filter. speed [m/s]: constant, else as recorded. "
      "spacing: least distance of the measurements used, ship lengths.");
  Record<NomotoZigzag>(m, "NomotoZigzag", "First-order equation T dr/dt + r = K (delta + delta_r), rudder to port.")
      .field<&NomotoZigzag::K>("K", "[1/s], negative for a stable ship.")
      .field<&NomotoZigzag::T>("T", "[s]")
      .field<&NomotoZigzag::delta_r>("delta_r", "Rudder offset [rad].")
      .field<&NomotoZigzag::intervals>("intervals", "Used.")
      .field<&NomotoZigzag::residual>("residual", "Rms of the heading changes left unexplained [rad].");
  m.def("nomoto_zigzag", &nomoto_zigzag_analysis, py::arg("run"), Unlocked(),
        "Nomoto's analysis of a recorded zigzag. Raises Refusal with fewer than three heading peaks.");
}

}  // namespace

void add_fits(py::module_& m) {
  add_estimate(m);
  add_states(m);
  add_force_fit(m);
  add_trajectory_fit(m);
  add_linear_fit(m);
}

}  // namespace swayaw::python
