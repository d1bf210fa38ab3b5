#include "eigen.hpp"
#include "module.hpp"
#include "progress.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/identification/map_fit.hpp"

namespace swayaw::python {
namespace {

/// An unknown with the deviation of its prior, which the library keeps in a matrix for all of them.
struct UnknownValue {
  std::string name;
  double mean = 0.0;
  double deviation = 1.0;
  double low = -HUGE_VAL;
  double high = HUGE_VAL;
  double step = 0.2;
};

void add_noise(py::module_& m) {
  const Noise usual;
  Record<Noise>(m, "Noise", "What no model and no instrument gets right.", Made::by_anyone)
      .optional<&Noise::scale>("scale", "Of the ordinary process noise.")
      .optional<&Noise::apart>("apart", "Each axis has a scale, and the noise a memory of its own.")
      .optional<&Noise::axes>("axes", "Factors on the scale in surge, sway and yaw.")
      .optional<&Noise::memory>("memory", "Of the process noise, over L/U.")
      .optional<&Noise::with_memory>("with_memory", "Errors of positions have one, as receivers have it.")
      .optional<&Noise::walk>("walk", "What the error of a position wanders in L/U, over L.")
      .optional<&Noise::factor>("factor", "On the noise of each channel, in the order of `channels()`.");
  m.def(
      "process_noise", &process_noise, py::arg("ship"), py::arg("noise") = usual,
      "Standard deviation of the accelerations that a model leaves out, PlanarAcceleration: 0.002 U²/L times the scale "
      "in sway, 0.3 of that in surge, 1.5/L of that in yaw.\n\nship: whose length and service speed count. noise: its "
      "scale and axes.");
}

// ---------------------------------------------------------------- the most probable point

/// A ship by a function of Python. What that raises, in whichever thread, is raised when the fit has come back.
class AskedShip {
 public:
  AskedShip(py::function function, const std::vector<UnknownValue>& unknowns)
      : function_(std::move(function)), unknowns_(unknowns) {}

  Ship operator()(const Point& point, std::size_t run) {
    const py::gil_scoped_acquire locked;
    if (trouble_) throw Refusal("the function has failed");
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      py::dict values;
      for (std::size_t i = 0; i < unknowns_.size(); ++i)
        values[py::str(unknowns_[i].name)] = point[static_cast<Eigen::Index>(i)];
      return function_(values, run).cast<Ship>();
    } catch (const Refusal&) {
      throw;
    } catch (...) {
      trouble_ = std::current_exception();
    }
    throw Refusal("the function has failed");
  }

  void rethrow() const {
    if (trouble_) std::rethrow_exception(trouble_);
  }

 private:
  py::function function_;
  const std::vector<UnknownValue>& unknowns_;
  std::exception_ptr trouble_;
};

Eigen::MatrixXd precision_of(const std::vector<UnknownValue>& unknowns) {
  Eigen::VectorXd precision(static_cast<Eigen::Index>(unknowns.size()));
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    if (!(unknowns[i].deviation > 0.0))
      throw std::domain_error(
          fmt::format("deviation of {} must be positive, got {}", unknowns[i].name, unknowns[i].deviation));
    precision[static_cast<Eigen::Index>(i)] = 1.0 / (unknowns[i].deviation * unknowns[i].deviation);
  }
  return precision.asDiagonal();
}

MapFit fitted(const Ship& ship, const std::vector<Recording>& runs, const std::vector<UnknownValue>& unknowns,
              py::function ship_in, std::vector<Channel> channels, const Noise& noise, bool lean, int rounds) {
  if (unknowns.empty()) throw std::domain_error("there must be an unknown");
  AskedShip asked(std::move(ship_in), unknowns);
  std::vector<Unknown> plain;
  for (const auto& u : unknowns)
    plain.push_back({.name = u.name, .mean = u.mean, .low = u.low, .high = u.high, .step = u.step});
  const auto precision = precision_of(unknowns);
  auto result = [&]() -> std::variant<MapFit, std::exception_ptr> {
    const py::gil_scoped_release unlocked;
    try {
      const auto wanted = recorded_channels(runs, motion_channels(), channels);
      const auto prepared = (lean ? lean_runs : prepared_runs)(ship, runs, wanted);
      const EstimationProblem problem{
          .unknowns = plain, .precision = precision, .runs = prepared, .ship_in = std::ref(asked), .scale = ship};
      return fit(problem, problem.mean(), noise, 0, {.rounds = rounds});
    } catch (...) {
      return std::current_exception();
    }
  }();
  asked.rethrow();
  if (const auto* trouble = std::get_if<std::exception_ptr>(&result)) std::rethrow_exception(*trouble);
  return std::get<MapFit>(std::move(result));
}

void add_map_fit(py::module_& m) {
  Record<UnknownValue>(m, "Unknown", "A number to be estimated and what is known of it beforehand.", Made::by_anyone)
      .field<&UnknownValue::name>("name", "By which the function of ships gets it.")
      .optional<&UnknownValue::mean>("mean", "Where nothing is known, and where the search begins.")
      .optional<&UnknownValue::deviation>("deviation", "Standard deviation about the mean beforehand.")
      .optional<&UnknownValue::low>("low", "Bound.")
      .optional<&UnknownValue::high>("high", "Bound.")
      .optional<&UnknownValue::step>("step", "Of differences, over which residuals are about linear.");
  Record<MapFit>(m, "MapFit", "The most probable values of unknowns.")
      .field<&MapFit::point>("point", "In the order of the unknowns.")
      .field<&MapFit::log_evidence>("log_evidence", "By Laplace; differences are what counts.")
      .field<&MapFit::noise>("noise", "That suits it best.")
      .field<&MapFit::covariance>("covariance", "Of the point.")
      .field<&MapFit::information>("information", "Of the runs alone.");
  m.def(
      "map_fit", &fitted, py::arg("ship"), py::arg("runs"), py::arg("unknowns"), py::arg("ship_in"), py::kw_only(),
      py::arg("channels") = std::vector<Channel>{}, py::arg("noise") = Noise{}, py::arg("lean") = false,
      py::arg("rounds") = FitOptions{}.rounds,
      R"(Unknowns of any kind estimated together from recorded runs: the maximum of their posterior under a Kalman filter
that carries what no model gets right, and its evidence (docs/estimation.md).

ship: whose length and speed give units of noise. unknowns: a list of Unknown. ship_in: a function of their values, by
name, and the place of a run, that gives the ship who sailed it; Refusal from it means that no ship can sail like that,
any other exception ends the fit, and so does Ctrl-C. channels: to be compared, all that show the motion unless given.
noise: where the search for it begins. lean: as few samples as tell what they tell. rounds: of gains and noise.

Raises Refusal if a run tells neither rudder nor speed, ValueError for a deviation that is not positive.)");
}

}  // namespace

void add_estimation(py::module_& m) {
  add_noise(m);
  add_map_fit(m);
}

}  // namespace swayaw::python
