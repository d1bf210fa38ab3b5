#include "swayaw/identification/inverse_dynamics.hpp"

#include "catch.hpp"
#include "disturbed_runs.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/models/force_breakdown.hpp"
#include "swayaw/nonlinear/replay.hpp"

namespace swayaw {
namespace {

ShipState<double> true_state(const test::DisturbedRun& d, std::size_t k) {
  const auto at = [&](Channel c) { return d.truth[c][k]; };
  return {at(Channel::x), at(Channel::y), at(Channel::psi), {at(Channel::u), at(Channel::v), at(Channel::r)}};
}

Controls<double> true_controls(const Ship& ship, const test::DisturbedRun& d, std::size_t k) {
  return RecordedControls(ship, d.run).at(d.run.time[k]);
}

PlanarForce<double> part(const ForceBreakdown& split, std::string_view name) {
  for (const auto& p : split.parts)
    if (p.name == name) return p.force;
  return {0.0, 0.0, 0.0};
}

/// What pushes the hull in truth: the model's hull, and what disturbs her, M d.
PlanarForce<double> true_hull(const Ship& ship, const test::DisturbedRun& d, std::size_t k) {
  const auto state = true_state(d, k);
  const auto split = force_breakdown(ship, state, true_controls(ship, d, k));
  auto a = split.acceleration;
  const auto& e = d.unmodelled[k];
  a = {a.u + e.u, a.v + e.v, a.r + e.r};
  const auto total = std::visit([&](const auto& model) { return force_of(model, state.motion, a); }, ship.model);
  const auto hull = part(split, "hull");
  return {hull.X + total.X - split.total.X, hull.Y + total.Y - split.total.Y, hull.N + total.N - split.total.N};
}

/// rms of the error over rms of the truth, of Y and N.
struct RelativeError {
  double Y, N;
};

RelativeError hull_error(const Ship& truth, const test::DisturbedRun& d, const std::vector<InverseDynamics>& found) {
  double y = 0.0, n = 0.0, yy = 0.0, nn = 0.0;
  for (std::size_t k = 20; k + 20 < found.size(); ++k) {
    const auto hull = true_hull(truth, d, k);
    y += std::pow(found[k].hull.force.Y - hull.Y, 2), yy += hull.Y * hull.Y;
    n += std::pow(found[k].hull.force.N - hull.N, 2), nn += hull.N * hull.N;
  }
  return {std::sqrt(y / yy), std::sqrt(n / nn)};
}

const test::Sensors perfect{{Channel::x, 1e-6}, {Channel::y, 1e-6}, {Channel::psi, 1e-7}, {Channel::r, 1e-7}};

Ship without_hull(Ship ship) {
  const auto remove = [](auto& model) {
    for (const auto& p : model.hull.parameters()) model.hull.*p.member = 0.0;
  };
  std::visit(remove, ship.model);
  return ship;
}

/// And one of them in wind and current.
std::vector<Ship> ships_of_all_models() {
  std::vector<Ship> all;
  for (const auto name : {"kvlcc2_l7.toml", "wpcc_pi.toml", "wpcc_pu.toml", "mariner.toml"})
    all.push_back(read_ship(test::ships / name));
  all.push_back(test::kvlcc2());
  all.back().surroundings.wind = {.speed = 15.0, .from = 0.8};
  all.back().surroundings.current = {.speed = 1.0, .to = 2.0};
  all.back().surroundings.windy = true;
  return all;
}

/// In her own units: a 160 m ship sails as one of 7 m does.
test::DisturbedOptions in_ship_lengths(const Ship& ship, std::size_t samples, double step) {
  const double unit = time_unit_of(ship);
  return {.samples = samples, .step = step * unit, .swing = 2.5 * unit};
}

TEST_CASE("the force found for an acceleration gives that acceleration, for every model",
          "[identification][round-trip]") {
  for (const auto& ship : ships_of_all_models()) {
    const double L = length(ship), U = service_speed(ship);
    const PlanarMotion<double> motion{0.9 * U, -0.2 * U, 0.4 * U / L};
    const PlanarAcceleration<double> a{0.02 * U * U / L, -0.1 * U * U / L, 0.3 * U * U / (L * L)};
    const auto back = std::visit(
        [&](const auto& model) { return acceleration(model, motion, force_of(model, motion, a)); }, ship.model);
    CHECK_THAT(back.u, WithinRel(a.u, 1e-10));
    CHECK_THAT(back.v, WithinRel(a.v, 1e-10));
    CHECK_THAT(back.r, WithinRel(a.r, 1e-10));
  }
}

TEST_CASE("inverse dynamics of a run without noise returns the forces of the model", "[identification][round-trip]") {
  for (const auto& ship : ships_of_all_models()) {
    const auto d = test::disturbed_run(ship, {}, 1, in_ship_lengths(ship, 200, 0.05), perfect);
    const auto found = inverse_dynamics(
        ship, d.run,
        estimate_states(ship, d.run, {.noise = d.noise, .process_noise = test::ordinary(ship, 1e-4).process_noise}));
    const auto error = hull_error(ship, d, found);
    CHECK(error.Y < 1e-3);
    CHECK(error.N < 1e-3);
  }
}

TEST_CASE("a ship whose hull is removed is told the hull force of the true one", "[identification][round-trip]") {
  for (const auto& truth : ships_of_all_models()) {
    const Ship ship = without_hull(truth);
    const auto d = test::disturbed_run(truth, {}, 1, in_ship_lengths(truth, 400, 0.02), perfect);
    for (const bool coloured : {true, false}) {
      const EstimationOptions options{
          .noise = d.noise, .process_noise = test::ordinary(truth, 0.1).process_noise, .coloured = coloured};
      const auto error = hull_error(truth, d, inverse_dynamics(ship, d.run, estimate_states(ship, d.run, options)));
      CHECK(error.Y < 0.03);
      CHECK(error.N < 0.03);
    }
  }
}

TEST_CASE("95 % bands of hull forces hold the truth", "[identification][second-route]") {
  for (const auto& ship : {test::kvlcc2_l7(), read_ship(test::ships / "wpcc_pi.toml")}) {
    const auto by = test::ordinary(ship);
    double inside[3] = {}, count = 0.0;
    for (unsigned seed = 1; seed <= 20; ++seed) {
      const auto d = test::disturbed_run(ship, by, seed, {.samples = 150});
      const auto found = inverse_dynamics(
          ship, d.run, estimate_states(ship, d.run, {.noise = d.noise, .process_noise = by.process_noise}));
      for (std::size_t k = 10; k + 10 < found.size(); k += 5, ++count) {
        const auto hull = true_hull(ship, d, k);
        const auto& [force, covariance] = found[k].hull;
        const double errors[] = {force.X - hull.X, force.Y - hull.Y, force.N - hull.N};
        for (std::size_t i = 0; i < 3; ++i) inside[i] += std::abs(errors[i]) < 1.96 * std::sqrt(covariance[i][i]);
      }
    }
    for (const double share : inside) {
      CHECK(share / count > 0.90);
      CHECK(share / count < 0.99);
    }
  }
}

TEST_CASE("an estimate of another run is refused", "[identification][refusal]") {
  const Ship ship = test::kvlcc2_l7();
  const auto d = test::disturbed_run(ship, {}, 1, {.samples = 20});
  CHECK_THROWS_WITH(inverse_dynamics(ship, d.run, StateEstimate{}), "noisy: 20 samples, but 0 in the estimate");
}

}  // namespace
}  // namespace swayaw
