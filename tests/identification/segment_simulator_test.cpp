#include "swayaw/nonlinear/simulation/segment_simulator.hpp"

#include <catch.hpp>
#include <cmath>

#include "trajectory_recordings.hpp"

/// Derivatives of simulated segments.
namespace swayaw {
namespace {

/// A segment of five ship lengths of a zigzag, read at every sample.
SampledRun sampled_run(const Ship& ship, const Recording& run) {
  SampledRun result{.time = {}, .controls = {}, .steps = {}, .measurements = {}};
  const RecordedControls controls(ship, run);
  const double end = 5.0 * length(ship) / service_speed(ship);
  for (std::size_t k = 0; k < run.samples() && run.time[k] < end; ++k) {
    result.time.push_back(run.time[k]);
    result.controls.push_back(controls.at(run.time[k]));
    if (k > 0) result.steps.push_back(2);
    for (const Channel c : {Channel::x, Channel::y, Channel::psi, Channel::u, Channel::v, Channel::r})
      result.measurements.push_back({k, c, run[c][k]});
    result.measurements.push_back({k, Channel::course_over_ground, run[Channel::psi][k]});
  }
  return result;
}

/// Residuals and end of a response.
Eigen::VectorXd outcome(const SegmentResponse& response) {
  Eigen::VectorXd all(response.residual.size() + 6);
  all << response.residual, Eigen::Map<const Eigen::Vector<double, 6>>(response.end.data());
  return all;
}

RowMatrix slope(const SegmentResponse& response) {
  RowMatrix all(response.residual_slope.rows() + 6, response.residual_slope.cols());
  all << response.residual_slope, response.end_slope;
  return all;
}

}  // namespace

TEMPLATE_TEST_CASE("derivatives of a trajectory by its start and by all coefficients agree with differences",
                   "[identification][second-route]", MmgShip<double>, PiShip<double>, PuShip<double>,
                   AbkowitzShip<double>) {
  test::RandomModels random(20261203);
  for (int i = 0; i < 3; ++i) {
    auto [ship, runs] = test::steerable<TestType>(random, {20.0}, 15.0, 0.05);
    ship.surroundings.current = {0.1 * service_speed(ship), 1.0};
    auto parameters = parameters_of(ship);
    std::erase_if(parameters, [](const Parameter& n) { return n.role != Role::coefficient || n.value == 0.0; });
    const auto simulator = std::visit(
        [&, &ship = ship](const auto& model) { return segment_simulator(model, ship.surroundings, parameters); },
        ship.model);
    const auto run = sampled_run(ship, runs.front());
    const RunSegment segment{&run, 0, run.time.size() - 1, run.measurements};
    const double L = length(ship), U = service_speed(ship);
    std::vector<double> place{0.1 * L, 0.2 * L, 0.3, U, 0.05 * U, -0.1 * U / L}, unit{L, L, 1.0, U, U, U / L};
    for (const auto& n : parameters) {
      place.push_back(n.value);
      unit.push_back(std::abs(n.value));
    }
    const auto at = [&](const std::vector<double>& p, bool slopes) {
      return simulator->simulate(segment, {p[0], p[1], p[2], p[3], p[4], p[5]}, std::span(p).subspan(6), slopes);
    };
    const auto exact = slope(at(place, true));
    CHECK((outcome(at(place, true)) - outcome(at(place, false))).cwiseAbs().maxCoeff() < 1e-9 * L);
    for (std::size_t k = 0; k < place.size(); ++k) {
      const double h = 3e-7 * unit[k], rounding = 1e-13 * L / h;
      auto above = place, below = place;
      above[k] += h;
      below[k] -= h;
      const Eigen::VectorXd difference = (outcome(at(above, false)) - outcome(at(below, false))) / (2.0 * h);
      const Eigen::VectorXd column = exact.col(static_cast<Eigen::Index>(k));
      INFO("unknown " << k << (k < 6 ? "" : " " + parameters[k - 6].name));
      CHECK((difference - column).cwiseAbs().maxCoeff() <= 1e-6 * column.cwiseAbs().maxCoeff() + rounding);
    }
  }
}

}  // namespace swayaw
