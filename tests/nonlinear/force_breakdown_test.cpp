#include "swayaw/nonlinear/models/force_breakdown.hpp"

#include <algorithm>
#include <catch.hpp>
#include <cmath>
#include <limits>

#include "model_ships.hpp"
#include "random_effects.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"

/// Forces by part beside the samples of a run.
namespace swayaw {
namespace {

std::vector<Ship> ships_of_all_models() {
  return {test::kvlcc2_l7(), test::with_areas(test::pi_ship("wpcc_pi")), test::with_areas(test::wpcc_pu()),
          test::with_areas(test::mariner())};
}

/// A 20/20 zigzag of eight ship lengths, sampled 400 times.
Recording zigzag_run(const Ship& ship) {
  const double duration = 8.0 * time_unit_of(ship);
  return zigzag(ship, {.rudder = radians(20), .heading = radians(20)}, {.duration = duration, .step = duration / 400.0})
      .run;
}

const std::vector<std::string>& cells(const Recording& run, std::string_view column) {
  const auto found = std::ranges::find(run.extra, column, &ExtraColumn::name);
  REQUIRE(found != run.extra.end());
  return found->cells;
}

/// Sum of the columns that begin with that letter, at one sample.
double sum(const Recording& run, char letter, std::size_t i) {
  double total = 0.0;
  for (const auto& column : run.extra)
    if (column.name.front() == letter) total += std::stod(column.cells[i]);
  return total;
}

double slope(const Recording& run, Channel channel, std::size_t i) {
  return (run[channel][i + 1] - run[channel][i - 1]) / (run.time[i + 1] - run.time[i - 1]);
}

/// What the columns at a sample do to the ship.
PlanarAcceleration<double> acceleration_of_columns(const Ship& ship, const Recording& run, std::size_t i) {
  const PlanarMotion<double> motion{run[Channel::u][i], run[Channel::v][i], run[Channel::r][i]};
  const PlanarForce<double> force{sum(run, 'X', i), sum(run, 'Y', i), sum(run, 'N', i)};
  return std::visit([&](const auto& model) { return acceleration(model, motion, force); }, ship.model);
}

/// Largest difference between the acceleration of the columns and that of the recorded motion, over the largest of the
/// latter; samples beside a kink of the rudder left out.
struct Misfit {
  double u = 0.0, v = 0.0, r = 0.0;
};

Misfit misfit(const Ship& ship, const Recording& run) {
  Misfit worst, size;
  for (std::size_t i = 2; i + 2 < run.samples(); ++i) {
    const double bend = slope(run, Channel::delta, i + 1) - slope(run, Channel::delta, i - 1);
    if (std::abs(bend) > 1e-6) continue;
    const auto a = acceleration_of_columns(ship, run, i);
    const double u = slope(run, Channel::u, i), v = slope(run, Channel::v, i), r = slope(run, Channel::r, i);
    worst = {std::max(worst.u, std::abs(a.u - u)), std::max(worst.v, std::abs(a.v - v)),
             std::max(worst.r, std::abs(a.r - r))};
    size = {std::max(size.u, std::abs(u)), std::max(size.v, std::abs(v)), std::max(size.r, std::abs(r))};
  }
  return {worst.u / size.u, worst.v / size.v, worst.r / size.r};
}

TEST_CASE("forces by part along a simulated run make the accelerations of its motion", "[nonlinear][second-route]") {
  for (const auto& ship : ships_of_all_models()) {
    auto run = zigzag_run(ship);
    add_forces(run, ship);
    const auto apart = misfit(ship, run);
    INFO(ship.name);
    CHECK(apart.u < 5e-3);
    CHECK(apart.v < 5e-3);
    CHECK(apart.r < 5e-3);
  }
}

TEST_CASE("what the rudder makes the hull bear stands by itself, in MMG form as in PI form",
          "[nonlinear][second-route]") {
  for (const Ship& ship : {Ship(test::kvlcc2_l7()), test::with_areas(test::pi_ship("wpcc_pi"))}) {
    const double U = service_speed(ship);
    const auto split = force_breakdown(ship, {0.0, 0.0, 0.0, {U, 0.05 * U, -0.1 * U / length(ship)}},
                                       with_rudder(self_propulsion(ship, U), radians(10)));
    const auto part = [&](std::string_view name) {
      return std::ranges::find(split.parts, name, &ForcePart<double>::name)->force;
    };
    const auto rudder = part("rudder"), induced = part("rudder_hull_interaction");
    PlanarForce<double> sum{};
    for (const auto& p : split.parts) sum = sum + p.force;
    CHECK_THAT(sum.Y, WithinRel(split.total.Y, 1e-12));
    CHECK_THAT(sum.N, WithinRel(split.total.N, 1e-12));
    CHECK(induced.Y * rudder.Y > 0.0);
    if (const auto* mmg = std::get_if<MmgShip<double>>(&ship.model)) {
      const double L = length(ship);
      CHECK_THAT(induced.Y, WithinRel(mmg->rudder.a_H * rudder.Y, 1e-12));
      CHECK_THAT(induced.N, WithinRel(mmg->rudder.x_H * L * induced.Y, 1e-12));
      CHECK_THAT(rudder.N, WithinRel(mmg->rudder.x_R * L * rudder.Y, 1e-12));
    }
  }
}

TEST_CASE("forces along a run in wind have the wind as a part", "[nonlinear][second-route]") {
  Ship ship = test::with_areas(test::mmg(test::kvlcc2_l7()));
  ship.surroundings.wind = {3.0, radians(60)};
  ship.surroundings.windy = true;
  auto run = zigzag_run(ship);
  add_forces(run, ship);
  CHECK(std::ranges::any_of(cells(run, "Y_wind_N"), [](const auto& cell) { return std::abs(std::stod(cell)) > 0.0; }));
  const auto apart = misfit(ship, run);
  CHECK(apart.u < 5e-3);
  CHECK(apart.v < 5e-3);
  CHECK(apart.r < 5e-3);
}

TEST_CASE("forces along a run are those of the rudder, not of an indicator that is off", "[nonlinear][second-route]") {
  Ship ship = test::kvlcc2_l7();
  ship.effects = {RudderOffset<>{.offset = radians(2)}};
  auto run = zigzag_run(ship);
  add_forces(run, ship);
  const auto apart = misfit(ship, run);
  CHECK(apart.v < 5e-3);
  CHECK(apart.r < 5e-3);

  // without the offset the same columns are of another rudder angle
  auto misread = run;
  misread.extra.clear();
  add_forces(misread, test::kvlcc2_l7());
  CHECK(misfit(ship, misread).r > 0.02);
}

TEST_CASE("samples without a motion, or beyond the force model, get no forces", "[nonlinear][limit]") {
  const Ship ship = test::kvlcc2_l7();
  auto run = zigzag_run(ship);
  run.channels[index_of(Channel::r)][7] = std::numeric_limits<double>::quiet_NaN();
  run.channels[index_of(Channel::psi)][8] = std::numeric_limits<double>::quiet_NaN();
  run.channels[index_of(Channel::u)][9] = -1.0;  // astern
  add_forces(run, ship);
  const auto& hull = cells(run, "Y_hull_N");
  CHECK(hull.size() == run.samples());
  for (const std::size_t i : {7u, 8u, 9u}) CHECK(hull[i].empty());
  CHECK(std::ranges::count(hull, std::string{}) == 3);
}

TEST_CASE("forces along a run that lacks what they come from are refused in words", "[nonlinear][refusal]") {
  const Ship ship = test::kvlcc2_l7();
  const auto run = zigzag_run(ship);
  const auto refusal_without = [&](std::initializer_list<Channel> channels) -> std::string {
    auto less = run;
    less.name = "run";
    for (const auto channel : channels) less.channels[index_of(channel)].clear();
    try {
      add_forces(less, ship);
      return {};
    } catch (const Refusal& refusal) {
      return refusal.what();
    }
  };
  CHECK(refusal_without({Channel::u}) == "run: forces need u");
  CHECK(refusal_without({Channel::v}) == "run: forces need v");
  CHECK(refusal_without({Channel::r}) == "run: forces need yaw rate");
  CHECK(refusal_without({Channel::delta}) == "run: forces need rudder angle");
  CHECK(refusal_without({Channel::rev, Channel::thrust}) == "run: forces need shaft speed or thrust");
  CHECK(refusal_without({}).empty());
}

}  // namespace
}  // namespace swayaw
