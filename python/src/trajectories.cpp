#include "module.hpp"
#include "noise.hpp"
#include "progress.hpp"
#include "record.hpp"
#include "swayaw/identification/identify.hpp"
#include "swayaw/identification/linear_fit.hpp"
#include "swayaw/identification/nomoto_zigzag.hpp"
#include "swayaw/identification/trajectory_fit.hpp"

namespace swayaw::python {

template <>
struct Words<FitStatus> : NamedWords<FitStatus, 3, in_words> {};
template <>
struct Words<TrajectoryFitStatus> {
  static std::vector<std::string> list() { return {"converged", "iteration_limit", "stopped", "rank_deficient"}; }
};

namespace {

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

void add_trajectories(py::module_& m) {
  add_trajectory_fit(m);
  add_linear_fit(m);
}

}  // namespace swayaw::python
