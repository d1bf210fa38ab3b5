#include "swayaw/mismatch/run_picture.hpp"

#include <catch.hpp>
#include <cmath>
#include <random>

#include "random_ships.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/replay.hpp"

/// A model tank ship with a side force at her propeller that the model does not know.
namespace swayaw {
namespace {

constexpr double side_force = 10.0;  ///< [N], some eight times what an adequate model leaves out
const Noise noise = [] {
  Noise n;
  n.scale = 8.0;
  return n;
}();

Ship with_side_force(const Ship& ship, double force) {
  return with_effect(ship, PropellerSideForce<double>{.share = 0.0, .constant = force});
}

/// White noise of a tank's instruments on every channel of the motion; the sway velocity is not measured.
Recording measured(Recording run, unsigned seed) {
  std::mt19937_64 engine(seed);
  for (const auto& [channel, deviation] : {std::pair{Channel::x, 5e-3},
                                           {Channel::y, 5e-3},
                                           {Channel::psi, 1e-3},
                                           {Channel::r, 3e-4},
                                           {Channel::u, 3e-3}}) {
    std::normal_distribution error(0.0, deviation);
    for (double& sample : run.fill(channel)) sample += error(engine);
  }
  run.channels[index_of(Channel::v)].clear();
  return run;
}

Recording zigzag_run(const Ship& ship, double step = 0.2) {
  return measured(zigzag(ship, {.rudder = radians(20), .heading = radians(20)}, {.duration = 120.0, .step = step}).run,
                  1);
}

/// Of all samples but those of the first and last ship length.
template <class Get>
std::vector<double> inside(const Ship& ship, const Recording& run, const std::vector<MissingForce>& forces, Get&& get) {
  const double T = time_unit_of(ship);
  std::vector<double> values;
  for (std::size_t k = 0; k < run.samples(); ++k)
    if (run.time[k] > run.time.front() + T && run.time[k] < run.time.back() - T) values.push_back(get(forces[k]));
  return values;
}

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double x : values) sum += x;
  return sum / static_cast<double>(values.size());
}

TEST_CASE("the missing force is the side force that the model does not know", "[mismatch][second-route]") {
  const Ship ship = test::kvlcc2_l7(), real = with_side_force(ship, side_force);
  const double lever = test::mmg(ship).propeller.x_P * length(ship);  // N = x_P Y
  const auto run = zigzag_run(real);
  const auto missing = missing_force(ship, run, noise);
  REQUIRE(missing.size() == run.samples());
  const auto of = [&](auto&& get) { return inside(ship, run, missing, get); };
  CHECK_THAT(mean(of([](const MissingForce& f) { return f.force.Y; })), WithinRel(side_force, 0.1));
  CHECK_THAT(mean(of([](const MissingForce& f) { return f.force.N; })), WithinRel(lever * side_force, 0.05));
  CHECK_THAT(mean(of([](const MissingForce& f) { return f.force.X; })), WithinAbs(0.0, 0.05 * side_force));
  // its bands of two standard deviations hold it nearly always, and leave 0 outside
  CHECK(mean(of([](const MissingForce& f) { return std::abs(f.force.N) > 2.0 * f.force_deviation.N ? 1.0 : 0.0; })) >
        0.9);
  CHECK(mean(of([](const MissingForce& f) {
          return std::abs(f.force.Y - side_force) < 2.0 * f.force_deviation.Y ? 1.0 : 0.0;
        })) > 0.9);
  CHECK(mean(of([&](const MissingForce& f) {
          return std::abs(f.force.N - lever * side_force) < 2.0 * f.force_deviation.N ? 1.0 : 0.0;
        })) > 0.9);
}

TEST_CASE("no force is missing once the ship has it", "[mismatch][limit]") {
  const Ship ship = test::kvlcc2_l7(), real = with_side_force(ship, side_force);
  const auto run = zigzag_run(real);
  const auto missing = missing_force(real, run, noise);
  const auto of = [&](auto&& get) { return inside(ship, run, missing, get); };
  CHECK_THAT(mean(of([](const MissingForce& f) { return f.force.Y; })), WithinAbs(0.0, 0.05 * side_force));
  CHECK_THAT(mean(of([](const MissingForce& f) { return f.force.N; })),
             WithinAbs(0.0, 0.05 * side_force * 0.5 * length(ship)));
  CHECK(mean(of([](const MissingForce& f) { return std::abs(f.force.Y) < 2.0 * f.force_deviation.Y ? 1.0 : 0.0; })) >
        0.9);
}

TEST_CASE("the missing force is mass with added mass times the missing acceleration", "[mismatch][second-route]") {
  const Ship ship = test::kvlcc2_l7();
  const auto& model = test::mmg(ship);
  const auto& p = model.particulars;
  // m + m_x and m + m_y of the MMG model; m x_G couples sway and yaw
  const double m = model.water.rho * p.nabla, unit = 0.5 * model.water.rho * p.L * p.L * p.d;
  for (const auto& f : missing_force(ship, zigzag_run(with_side_force(ship, side_force)), noise)) {
    const auto& a = f.acceleration;
    CHECK_THAT(f.force.X, WithinRel((m + unit * model.added_mass.m_x) * a.u, 1e-9));
    CHECK_THAT(f.force.Y,
               WithinRel((m + unit * model.added_mass.m_y) * a.v + m * p.x_G * a.r, 1e-9) || WithinAbs(0.0, 1e-9));
    CHECK_THAT(f.force_deviation.X, WithinRel((m + unit * model.added_mass.m_x) * f.acceleration_deviation.u, 1e-9));
  }
}

TEST_CASE("a force is seen when it begins, not later", "[mismatch][limit]") {
  const Ship ship = test::kvlcc2_l7();
  const double T = time_unit_of(ship), onset = 60.0;
  auto run = zigzag(ship, {.rudder = radians(20), .heading = radians(20)}, {.duration = 120.0, .step = 0.2}).run;
  // from the onset on the ship with the force goes on where the other one was
  const auto k = static_cast<std::size_t>(std::ranges::lower_bound(run.time, onset) - run.time.begin());
  const auto at = [&](Channel c) { return run[c][k]; };
  const ShipState<double> start{
      at(Channel::x), at(Channel::y), at(Channel::psi), {at(Channel::u), at(Channel::v), at(Channel::r)}};
  const auto rest = replay_from(with_side_force(ship, side_force), RecordedControls(ship, run), start,
                                std::span(run.time).subspan(k));
  for (const auto channel : {Channel::x, Channel::y, Channel::psi, Channel::u, Channel::v, Channel::r})
    std::ranges::copy(rest[channel], run.fill(channel).begin() + static_cast<std::ptrdiff_t>(k));
  run = measured(std::move(run), 2);
  const auto missing = missing_force(ship, run, noise);
  const double half = 0.5 * test::mmg(ship).propeller.x_P * length(ship) * side_force;  // of the yaw moment
  const auto passed =
      std::ranges::find_if(missing, [&](const MissingForce& f) { return f.force.N < half; }) - missing.begin();
  CHECK_THAT(run.time[static_cast<std::size_t>(passed)], WithinAbs(onset, 0.15 * T));
}

TEST_CASE("in a gap of the recording the missing force is less certain", "[mismatch][limit]") {
  const Ship ship = test::kvlcc2_l7();
  auto run = zigzag_run(with_side_force(ship, side_force));
  for (const auto channel : {Channel::x, Channel::y, Channel::psi, Channel::u, Channel::r})
    for (std::size_t k = 250; k < 350; ++k) run.fill(channel)[k] = missing;
  const auto forces = missing_force(ship, run, noise);
  CHECK(forces[300].force_deviation.N > 2.0 * forces[150].force_deviation.N);
  for (const auto& f : forces)
    CHECK((std::isfinite(f.force.X) && std::isfinite(f.force.Y) && std::isfinite(f.force.N)));
}

TEST_CASE("a picture holds at most 500 points from the first sample to the last", "[mismatch][limit]") {
  const Ship ship = test::kvlcc2_l7(), real = with_side_force(ship, side_force);
  auto run = zigzag_run(real, 0.1);
  // the position is measured at every other sample, between those that would be kept
  for (std::size_t k = 0; k < run.samples(); k += 2) run.fill(Channel::x)[k] = run.fill(Channel::y)[k] = missing;
  const auto picture = run_picture(ship, ship, real, run, noise);
  const auto points = picture.recorded.samples();
  CHECK(points <= 500);
  CHECK(picture.recorded.time.front() == run.time.front());
  CHECK(picture.recorded.time.back() == run.time.back());
  CHECK(picture.recorded.has(Channel::x));
  CHECK(picture.missing_before.size() == points);
  CHECK(picture.missing_after.size() == points);
  REQUIRE((picture.given && picture.refitted && picture.after));
  for (const auto* replayed : {&*picture.given, &*picture.refitted, &*picture.after})
    CHECK(replayed->time == picture.recorded.time);
}

TEST_CASE("beside errors that remember a picture shows the same force", "[mismatch][second-route]") {
  const Ship ship = test::kvlcc2_l7(), real = with_side_force(ship, side_force);
  const auto run = zigzag_run(real, 0.1);
  auto on_board = Noise::on_board();
  on_board.scale = noise.scale;
  const auto mean_force = [&](const Noise& with) {
    const auto picture = run_picture(ship, ship, real, run, with);
    CHECK(picture.missing_before.size() == picture.recorded.samples());
    double sum = 0.0;
    for (const auto& f : picture.missing_before) sum += f.force.Y;
    return sum / static_cast<double>(picture.missing_before.size());
  };
  CHECK_THAT(mean_force(noise), WithinRel(side_force, 0.1));
  CHECK_THAT(mean_force(on_board), WithinRel(side_force, 0.1));
}

TEST_CASE("a run that tells no speed has a picture without forces and replays", "[mismatch][refusal]") {
  const Ship ship = test::kvlcc2_l7();
  auto run = zigzag_run(ship);
  for (const auto channel : {Channel::x, Channel::y, Channel::u}) run.channels[index_of(channel)].clear();
  CHECK_THROWS_AS(missing_force(ship, run, noise), Refusal);
  const auto picture = run_picture(ship, ship, ship, run, noise);
  CHECK(picture.missing_before.empty());
  CHECK_FALSE(picture.after);
  CHECK(picture.recorded.has(Channel::psi));
}

}  // namespace
}  // namespace swayaw
