#include "swayaw/identification/segment_simulator.hpp"

#include <catch.hpp>
#include <cmath>

#include "effect_runs.hpp"
#include "swayaw/nonlinear/effects/acting_in_wind.hpp"
#include "trajectory_recordings.hpp"

/// Derivatives of simulated segments.
namespace swayaw {
namespace {

/// A segment of five ship lengths of a zigzag, read at every sample.
SampledRun sampled_run(const Ship& ship, const Recording& run) {
  SampledRun result{.time = {},
                    .controls = {},
                    .steps = {},
                    .measurements = {},
                    .changes = all_changes(ship, recorded_wind(ship, run))};
  const RecordedControls controls(ship, run);
  const double end = 5.0 * time_unit_of(ship);
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
  Eigen::VectorXd all(response.residual.size() + response.end.size());
  all << response.residual, response.end;
  return all;
}

RowMatrix slope(const SegmentResponse& response) {
  RowMatrix all(response.residual_slope.rows() + response.end_slope.rows(), response.residual_slope.cols());
  all << response.residual_slope, response.end_slope;
  return all;
}

/// A place to look at derivatives: states and parameters, and what is a large change of each.
struct Place {
  std::vector<double> value, unit;
  std::size_t states = 6;
};

/// A ship that turns, her motion alone given.
Place place_of(const Ship& ship, const std::vector<Parameter>& parameters) {
  const double L = length(ship), U = service_speed(ship);
  Place place{{0.1 * L, 0.2 * L, 0.3, U, 0.05 * U, -0.1 * U / L}, {L, L, 1.0, U, U, U / L}};
  for (const auto& n : parameters) {
    place.value.push_back(n.value);
    place.unit.push_back(std::abs(n.value));
  }
  return place;
}

/// The same with hidden states given too.
Place with_hidden(Place place, const Ship& ship) {
  std::vector<double> value, unit;
  for (const auto& quantity : hidden_quantities) {
    unit.push_back(quantity.one(length(ship), service_speed(ship)));
    value.push_back(0.02 * unit.back());
  }
  place.value.insert(place.value.begin() + 6, value.begin(), value.end());
  place.unit.insert(place.unit.begin() + 6, unit.begin(), unit.end());
  place.states += hidden_count;
  return place;
}

/// Derivatives of a segment beside differences over a millionth of a large change.
void check_slopes(const SegmentSimulator& simulator, const RunSegment& segment, const Place& place, double L) {
  const auto at = [&](const std::vector<double>& p, bool slopes) {
    const Eigen::VectorXd start = Eigen::Map<const Eigen::VectorXd>(p.data(), static_cast<Eigen::Index>(place.states));
    return simulator.simulate(segment, start, std::span(p).subspan(place.states), slopes);
  };
  const auto exact = slope(at(place.value, true));
  CHECK((outcome(at(place.value, true)) - outcome(at(place.value, false))).cwiseAbs().maxCoeff() < 1e-9 * L);
  for (std::size_t k = 0; k < place.value.size(); ++k) {
    const double h = 3e-7 * place.unit[k], rounding = 1e-13 * L / h;
    auto above = place.value, below = place.value;
    above[k] += h;
    below[k] -= h;
    const Eigen::VectorXd difference = (outcome(at(above, false)) - outcome(at(below, false))) / (2.0 * h);
    const Eigen::VectorXd column = exact.col(static_cast<Eigen::Index>(k));
    INFO("unknown " << k);
    CHECK((difference - column).cwiseAbs().maxCoeff() <= 1e-6 * column.cwiseAbs().maxCoeff() + rounding);
  }
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
    const auto simulator = segment_simulator(ship, parameters);
    const auto run = sampled_run(ship, runs.front());
    const RunSegment segment{&run, 0, run.time.size() - 1, run.measurements};
    check_slopes(*simulator, segment, place_of(ship, parameters), length(ship));
  }
}

TEMPLATE_TEST_CASE("beside every effect, too", "[identification][second-route]", MmgShip<double>, PiShip<double>,
                   PuShip<double>, AbkowitzShip<double>) {
  const auto bare = test::sailing_ship<TestType>();
  test::for_each_effect(bare, 13, [&](std::string_view id, const Ship& ship) {
    INFO(id);
    auto parameters = parameters_of(ship, test::told_parameters<TestType>());
    std::erase_if(parameters, [](const Parameter& n) { return n.value == 0.0; });
    const auto simulator = segment_simulator(ship, parameters);
    const auto run = sampled_run(ship, test::zigzag_of(ship));
    const RunSegment segment{&run, 0, run.time.size() - 1, run.measurements};
    const auto place = place_of(ship, parameters);
    check_slopes(*simulator, segment, place, length(ship));
    if (simulator->states() > 6) check_slopes(*simulator, segment, with_hidden(place, ship), length(ship));
  });
}

TEMPLATE_TEST_CASE("a segment shows what a simulation with any effect recorded", "[identification][second-route]",
                   MmgShip<double>, PiShip<double>, PuShip<double>, AbkowitzShip<double>) {
  const auto bare = test::sailing_ship<TestType>();
  const double L = length(bare), U = service_speed(bare);
  test::for_each_effect(bare, 14, [&](std::string_view id, const Ship& ship) {
    INFO(id);
    const auto recorded = test::zigzag_of(ship);
    const auto run = sampled_run(ship, recorded);
    const auto true_run = as_it_was(recorded, instruments_of(ship));
    Eigen::VectorXd start(6);
    for (Eigen::Index i = 0; const auto c : {Channel::x, Channel::y, Channel::psi, Channel::u, Channel::v, Channel::r})
      start[i++] = true_run[c][0];
    const RunSegment whole{&run, 0, run.time.size() - 1, run.measurements};
    const auto response = segment_simulator(ship, {})->simulate(whole, start, {}, false);
    double worst = 0.0;
    for (std::size_t i = 0; i < run.measurements.size(); ++i)
      if (run.measurements[i].channel != Channel::course_over_ground)
        worst = std::max(worst, std::abs(response.residual[static_cast<Eigen::Index>(i)]) /
                                    unit_of(run.measurements[i].channel, L, U));
    CHECK(worst < 1e-3);
  });
}

}  // namespace swayaw
