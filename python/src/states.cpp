#include "module.hpp"
#include "noise.hpp"
#include "record.hpp"
#include "swayaw/identification/inverse_dynamics.hpp"
#include "swayaw/identification/state_estimate.hpp"

namespace swayaw::python {
namespace {

constexpr std::size_t state_size = 9;

// ---------------------------------------------------------------- states as arrays

std::array<double, state_size> vector_of_state(const EstimatedState& s) {
  const auto& [x, y, psi, motion] = s.state;
  return {x, y, psi, motion.u, motion.v, motion.r, s.unmodelled.u, s.unmodelled.v, s.unmodelled.r};
}

py::object times(StateEstimate& estimate) {
  std::vector<double> time;
  for (const auto& state : estimate.states) time.push_back(state.time);
  return owned(std::move(time));
}

/// As many states as times; they come first.
void set_times(StateEstimate& estimate, py::handle value) {
  const auto time = numbers_in(value.cast<Array>(), "time");
  estimate.states.resize(time.size());
  for (std::size_t i = 0; i < time.size(); ++i) estimate.states[i].time = time[i];
}

py::object state_matrix(StateEstimate& estimate) {
  py::array_t<double> result({estimate.states.size(), state_size});
  auto rows = result.mutable_unchecked<2>();
  for (std::size_t i = 0; i < estimate.states.size(); ++i) {
    const auto state = vector_of_state(estimate.states[i]);
    for (std::size_t k = 0; k < state_size; ++k)
      rows(static_cast<py::ssize_t>(i), static_cast<py::ssize_t>(k)) = state[k];
  }
  return result;
}

void set_state_matrix(StateEstimate& estimate, py::handle value) {
  const auto rows = rows_in(value.cast<Array>(), "states");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto& s = rows.at(i);
    auto& place = estimate.states.at(i);
    place.state = {s.at(0), s.at(1), s.at(2), {s.at(3), s.at(4), s.at(5)}};
    place.unmodelled = {s.at(6), s.at(7), s.at(8)};
  }
}

py::object covariances(StateEstimate& estimate) {
  py::array_t<double> result({estimate.states.size(), state_size, state_size});
  auto all = result.mutable_unchecked<3>();
  for (std::size_t n = 0; n < estimate.states.size(); ++n)
    for (std::size_t i = 0; i < state_size; ++i)
      for (std::size_t k = 0; k < state_size; ++k)
        all(static_cast<py::ssize_t>(n), static_cast<py::ssize_t>(i), static_cast<py::ssize_t>(k)) =
            estimate.states[n].covariance(i, k);
  return result;
}

void set_covariances(StateEstimate& estimate, py::handle value) {
  const auto all = value.cast<Array>();
  const auto numbers = all.unchecked<3>();
  for (std::size_t n = 0; n < estimate.states.size(); ++n)
    for (std::size_t i = 0; i < state_size; ++i)
      for (std::size_t k = 0; k <= i; ++k)
        estimate.states[n].covariance(i, k) =
            numbers(static_cast<py::ssize_t>(n), static_cast<py::ssize_t>(i), static_cast<py::ssize_t>(k));
}

// ---------------------------------------------------------------- their noise

template <class T>
T& noise_in(T& noise) {
  return noise;
}
NoiseEstimate& noise_in(StateEstimate& estimate) { return estimate.noise; }

/// The fields of a noise estimate, of itself or of what holds it.
template <class T>
void add_noise_fields(Record<T>& record) {
  record
      .template told<[](T& e) -> py::object { return noise_of(noise_in(e).noise); },
                     [](T& e, py::handle value) { noise_in(e).noise = noise_from(value.cast<NoiseByChannel>()); }>(
          "noise", "dict", "Standard deviation by channel, known or estimated, SI.")
      .template told<[](T& e) -> py::object { return py::cast(noise_in(e).process_noise.size); },
                     [](T& e, py::handle value) {
                       noise_in(e).process_noise.size = value.cast<PlanarAcceleration<double>>();
                     }>("process_noise", "swayaw.PlanarAcceleration", "Size of the unmodelled accelerations.")
      .template told<[](T& e) -> py::object { return py::float_(noise_in(e).log_likelihood); },
                     [](T& e, py::handle value) { noise_in(e).log_likelihood = value.cast<double>(); }>(
          "log_likelihood", "float", "Of all runs.")
      .template told<[](T& e) -> py::object { return py::int_(noise_in(e).iterations); },
                     [](T& e, py::handle value) { noise_in(e).iterations = value.cast<int>(); }>(
          "iterations", "int", "Of the estimation of the noise.")
      .template told<[](T& e) -> py::object { return py::bool_(noise_in(e).converged); },
                     [](T& e, py::handle value) { noise_in(e).converged = value.cast<bool>(); }>(
          "converged", "bool", "True where nothing had to be estimated.");
}

EstimationOptions estimation_options(std::vector<Channel> channels, const NoiseByChannel& noise,
                                     const std::optional<PlanarAcceleration<double>>& process_noise, bool coloured,
                                     double memory, bool smooth) {
  EstimationOptions options{.channels = std::move(channels), .noise = noise_from(noise), .process_noise = {}};
  if (process_noise) options.process_noise = ProcessNoise{*process_noise};
  options.coloured = coloured, options.memory = memory, options.smooth = smooth;
  return options;
}

void add_state_estimates(py::module_& m) {
  Record<ChannelInnovation>(m, "ChannelInnovation",
                            "How well the prediction of a channel from the past agreed with it.")
      .field<&ChannelInnovation::channel>("channel", "By its short name.")
      .field<&ChannelInnovation::noise>("noise", "Standard deviation, known or estimated, SI.")
      .field<&ChannelInnovation::rms>("rms", "Of prediction errors over their expected size: 1 for a right filter.")
      .field<&ChannelInnovation::autocorrelation>("autocorrelation", "Of successive ones: 0 for a right filter.")
      .field<&ChannelInnovation::count>("count", "");
  Record<NoiseEstimate> noise_estimate(m, "NoiseEstimate", "Noise that makes recorded runs most likely.");
  add_noise_fields(noise_estimate);
  Record<StateEstimate> estimate(m, "StateEstimate",
                                 "Where a recorded ship really was, how she moved, and what pushed her.");
  estimate.told<&times, &set_times>("time", "numpy.ndarray", "[s]")
      .told<&state_matrix, &set_state_matrix>("states", "numpy.ndarray", "A row for each sample, columns as `names`.")
      .told<&covariances, &set_covariances>("covariances", "numpy.ndarray", "Samples by 9 by 9.")
      .field<&StateEstimate::innovations>("innovations", "By channel.");
  add_noise_fields(estimate);
  estimate.of()
      .def_property_readonly_static(
          "names", [](py::handle) { return py::make_tuple("x", "y", "psi", "u", "v", "r", "surge", "sway", "yaw"); },
          "Of the columns: state and unmodelled accelerations, SI.")
      .def("recording", &StateEstimate::recording, py::arg("run"),
           "The estimated motion as a recording; rudder and propulsion as in `run`, which it came from.");
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
      "Raises Refusal if the run has no rudder angle, or none of the channels tells position or speed."
      "\n\nship: the predictor. run: to be estimated. coloured: the unmodelled accelerations have a memory and are "
      "states; else they are white. smooth: the future of a sample counts too.");
}

// ---------------------------------------------------------------- forces

void add_estimate_noise(py::module_& m) {
  m.def(
      "estimate_noise",
      [](const Ship& ship, const std::vector<Recording>& runs, std::vector<Channel> channels,
         const NoiseByChannel& noise, const std::optional<PlanarAcceleration<double>>& process_noise, bool coloured,
         double memory) {
        return estimate_noise(ship, runs,
                              estimation_options(std::move(channels), noise, process_noise, coloured, memory, true));
      },
      py::arg("ship"), py::arg("runs"), py::kw_only(), py::arg("channels") = std::vector<Channel>{},
      py::arg("noise") = NoiseByChannel{}, py::arg("process_noise") = py::none(), py::arg("coloured") = true,
      py::arg("memory") = EstimationOptions{}.memory, Unlocked(),
      "What is not known of noise and process noise, from several runs at once, for instance calm ones.\n\nship: the "
      "predictor. runs: recordings. channels, noise, process_noise, coloured, memory: as of `estimate_states`, which "
      "takes the result: noise=e.noise, process_noise=e.process_noise.");
}

void add_inverse_dynamics(py::module_& m) {
  Record<EstimatedForce>(m, "EstimatedForce", "A force with its covariance.")
      .field<&EstimatedForce::force>("force", "[N, N, N m]")
      .field<&EstimatedForce::covariance>("covariance", "Of X, Y, N: 3 by 3.");
  Record<InverseDynamics>(m, "InverseDynamics", "Forces that a recorded ship must have felt at one sample.")
      .field<&InverseDynamics::time>("time", "[s]")
      .field<&InverseDynamics::damping>("damping", "Of the water: hull, propeller, rudder and what the model lacks.")
      .field<&InverseDynamics::hull>("hull", "The same without what the model says of propeller and rudder.");
  m.def("inverse_dynamics", &inverse_dynamics, py::arg("ship"), py::arg("run"), py::arg("estimate"), Unlocked(),
        "Forces at each sample of an estimated run, from its motion and what pushed it: damping = M (a + d) less "
        "centrifugal and Coriolis terms and wind (docs/state_estimation.md). Source: [Alexandersson2024] eqs (1)-(3), "
        "(39)-(41)\n\nship: she whom it was estimated with. run: as recorded. estimate: of `estimate_states`. Raises "
        "Refusal if the run has no rudder angle, or another number of samples than the estimate.");
}

}  // namespace

void add_states(py::module_& m) {
  add_state_estimates(m);
  add_estimate_noise(m);
  add_inverse_dynamics(m);
}

}  // namespace swayaw::python
