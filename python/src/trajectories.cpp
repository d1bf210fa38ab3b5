#include "fit_words.hpp"
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
  Record<TrajectoryFit>(m, "TrajectoryFit", "A ship whose simulation runs through recordings.")
      .field<&TrajectoryFit::ship>("ship", "With the fitted parameters.")
      .field<&TrajectoryFit::status>("status", "converged, iteration_limit, stopped or rank_deficient.")
      .field<&TrajectoryFit::parameters>("parameters", "In the order of the question.")
      .field<&TrajectoryFit::covariance>("covariance", "Of the parameters, SI.")
      .field<&TrajectoryFit::correlation>("correlation", "Of the parameters.")
      .field<&TrajectoryFit::condition_number>("condition_number", "Of combinations of the parameters.")
      .field<&TrajectoryFit::best_combination>("best_combination", "Which product of powers is known best.")
      .field<&TrajectoryFit::undetermined>("undetermined", "Relative error of 50 % and more, worst first.")
      .field<&TrajectoryFit::noise>("noise", "Standard deviation by channel, SI.")
      .field<&TrajectoryFit::log_likelihood>("log_likelihood", "Of all runs.")
      .field<&TrajectoryFit::runs>("runs", "In their order.")
      .field<&TrajectoryFit::iterations>("iterations", "")
      .field<&TrajectoryFit::sensitivities>("sensitivities", "How often all runs were sailed with derivatives.");
  m.def(
      "fit_trajectories",
      [](const Ship& ship, const std::vector<Recording>& runs, std::optional<std::vector<std::string>> parameters,
         std::vector<Channel> channels, const NoiseByChannel& noise, bool priors, Maybe robust, double segment,
         int most_iterations, unsigned threads, py::object progress) {
        Listener listener(std::move(progress), "fit_trajectories");
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
      "KeyboardInterrupt. Without one a notebook has a line that changes, progress=False nothing. threads: 0 for one "
      "on each core."
      "\n\nship: where the fit begins. runs: recordings, each with a start that is fitted too. parameters: by name, "
      "the usual ones unless given. channels: to fit to, all that a run has unless given. noise: known standard "
      "deviations by channel, SI, else estimated. priors: the parameters as given, with the ship's confidence, count "
      "as measurements. robust: residuals beyond so many standard deviations count with their size, 1.345. segment: "
      "length of the segments [ship lengths]. most_iterations: at most.\n\nRaises Refusal if there is nothing to fit "
      "or to fit to, or the ship cannot be simulated; ValueError for a noise or segment that is not positive.");
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
  using H = SwayYawTransfer<Estimate>;
  Record<H>(m, "TransferEstimates", "Fitted transfer functions, dimensionless.")
      .field<&H::e0>("e0", "")
      .field<&H::e1>("e1", "")
      .field<&H::nb0>("nb0", "")
      .field<&H::nb1>("nb1", "")
      .field<&H::nw0>("nw0", "")
      .field<&H::nw1>("nw1", "");
  using S = LinearState<Estimate>;
  Record<S>(m, "LinearStateEstimates", "A fitted state.")
      .field<&S::beta>("beta", "[rad]")
      .field<&S::omega>("omega", "rL/U")
      .field<&S::psi>("psi", "[rad]");
  Record<ChannelNoise>(m, "ChannelNoise", "Standard deviations of white measurement noise.")
      .field<&ChannelNoise::psi>("psi", "[rad]")
      .field<&ChannelNoise::r>("r", "[rad/s]")
      .field<&ChannelNoise::beta>("beta", "[rad]");
  Record<Disturbance>(m, "Disturbance", "Random forces, by what an undisturbed state gains in deviation.")
      .field<&Disturbance::beta>("beta", "[rad] per root of a ship length.")
      .field<&Disturbance::omega>("omega", "Of omega', per root of a ship length.");
  Record<LinearFit>(m, "LinearFit", R"(The linear sway–yaw equations that explain recordings.

Where drift was not recorded, only the transfer function of yaw and its indices are determined.)")
      .field<&LinearFit::status>("status", "converged, iteration limit or rank deficient.")
      .field<&LinearFit::scale>("scale", "Length and mean speed.")
      .field<&LinearFit::coefficients>("coefficients", "Of the coupled equations.")
      .field<&LinearFit::transfer>("transfer", "Of drift and yaw.")
      .field<&LinearFit::indices>("indices", "")
      .field<&LinearFit::time_constants>("time_constants", "None when they are a complex pair.")
      .field<&LinearFit::rudder_offset>("rudder_offset", "Recorded angle plus this acts [rad].")
      .field<&LinearFit::yaw_rate_offset>("yaw_rate_offset", "Recorded minus true [rad/s].")
      .field<&LinearFit::drift_offset>("drift_offset", "Recorded minus true [rad].")
      .field<&LinearFit::starts>("starts", "State at the first sample used, of each run.")
      .field<&LinearFit::noise>("noise", "Known or estimated.")
      .field<&LinearFit::disturbance>("disturbance", "Estimated.")
      .field<&LinearFit::one_step>("one_step", "From one measurement to the next.")
      .field<&LinearFit::whole_run>("whole_run", "Of the simulation of the whole run.")
      .field<&LinearFit::covariance>("covariance", "Of a1, b1, c1, a2, b2, c2; NaN without drift.")
      .field<&LinearFit::condition_number>("condition_number", "Of combinations of the constants.")
      .field<&LinearFit::best_combination>("best_combination", "Which product of powers is known best.")
      .field<&LinearFit::worst_combination>("worst_combination", "And which worst.")
      .field<&LinearFit::stable>("stable", "At the estimate.")
      .field<&LinearFit::probability_stable>("probability_stable", "At least; errors taken as normal.")
      .field<&LinearFit::amplitude>("amplitude", "A verdict on stability holds for motions of this size.")
      .field<&LinearFit::samples>("samples", "With a measurement that is used.");
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
      "spacing: least distance of the measurements used, ship lengths."
      "\n\nruns: recordings. use_drift: drift counts where it was recorded. disturbances: random forces act on the "
      "ship, else only the measurements are noisy. rudder_offset: the recorded rudder angle has an unknown zero. "
      "Raises Refusal if a run tells neither heading nor yaw rate, or has fewer than 20 measurements.");
  Record<NomotoZigzag>(m, "NomotoZigzag", "First-order equation T dr/dt + r = K (delta + delta_r), rudder to port.")
      .field<&NomotoZigzag::K>("K", "[1/s], negative for a stable ship.")
      .field<&NomotoZigzag::T>("T", "[s]")
      .field<&NomotoZigzag::delta_r>("delta_r", "Rudder offset [rad].")
      .field<&NomotoZigzag::intervals>("intervals", "Used.")
      .field<&NomotoZigzag::residual>("residual", "Rms of the heading changes left unexplained [rad].");
  m.def("nomoto_zigzag", &nomoto_zigzag_analysis, py::arg("run"), Unlocked(),
        "Nomoto's analysis of a recorded zigzag. Raises Refusal with fewer than three heading peaks."
        "\n\nrun: heading and rudder suffice.");
}

}  // namespace

void add_trajectories(py::module_& m) {
  add_trajectory_fit(m);
  add_linear_fit(m);
}

}  // namespace swayaw::python
