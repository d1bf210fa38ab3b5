#include "swayaw/identification/linear_fit.hpp"

#include <array>
#include <catch.hpp>

#include "../linear/random_linear_ships.hpp"
#include "files.hpp"
#include "linear_recordings.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/linear/zigzag.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/ship_file.hpp"

namespace swayaw {
namespace {

using test::listed;
using test::RandomLinearShips;
using test::recorded;
using test::ship_length;
using test::unstable_ship;

void require_same(const SwayYawCoefficients<Estimate>& found, const SwayYawCoefficients<double>& truth,
                  double tolerance) {
  for (std::size_t i = 0; i < 6; ++i) {
    INFO("constant " << i);
    REQUIRE_THAT(listed(found)[i].value, WithinAbs(listed(truth)[i], tolerance));
  }
}

/// How often the 95 % interval of each constant holds the truth.
std::array<double, 6> coverage(const SwayYawCoefficients<double>& ship, test::RecordedZigzag wish,
                               const LinearFitOptions& options, unsigned runs) {
  std::array<double, 6> inside{};
  for (unsigned k = 0; k < runs; ++k) {
    wish.seed = k + 1;
    const auto found = listed(fit_linear(recorded(ship, wish), options).coefficients);
    for (std::size_t i = 0; i < 6; ++i)
      inside[i] +=
          (std::abs(found[i].value - listed(ship)[i]) < 1.96 * found[i].standard_error) / static_cast<double>(runs);
  }
  return inside;
}

TEST_CASE("without noise the six constants of any ship come back", "[identification][round-trip]") {
  int unstable = 0;
  for (const auto& [ship, run] : test::random_zigzags(40)) {
    const auto fit = fit_linear(run, {.L = ship_length});
    unstable += !is_stable(ship);
    require_same(fit.coefficients, ship, 1e-6);
    REQUIRE(fit.stable == is_stable(ship));
    REQUIRE_THAT(fit.rudder_offset.value, WithinAbs(0.005, 1e-8));
    REQUIRE_THAT(fit.starts[0].beta.value, WithinAbs(0.01, 1e-6));
    REQUIRE_THAT(fit.starts[0].omega.value, WithinAbs(-0.03, 1e-6));
    REQUIRE_THAT(fit.starts[0].psi.value, WithinAbs(0.02, 1e-6));
    REQUIRE(fit.whole_run.psi < 1e-6);
  }
  CHECK(unstable >= 10);
}

TEST_CASE("irregular time, lost samples and falling speed do no harm", "[identification][round-trip]") {
  for (const auto& ship : {RandomLinearShips::tanker(), unstable_ship()}) {
    auto run = recorded(ship, {.rudder_offset = 0.004, .speed_loss = 0.4, .irregular = 0.8});
    for (std::size_t i = 0; i < run.samples(); i += 7)
      run.fill(Channel::psi)[i] = run.fill(Channel::r)[(3 * i) % run.samples()] = missing;
    require_same(fit_linear(run, {.L = ship_length}).coefficients, ship, 1e-6);
  }
}

TEST_CASE("several recordings give one ship, each with its own start", "[identification][round-trip]") {
  const auto ship = unstable_ship();
  const std::vector<Recording> runs{
      recorded(ship, {.lengths = 8.0, .start = {0.01, 0.0, 0.0}, .rudder_offset = 0.01}),
      recorded(ship, {.heading = radians(5), .lengths = 9.0, .start = {-0.02, 0.1, 3.0}, .rudder_offset = 0.01})};
  const auto fit = fit_linear(runs, {.L = ship_length});
  require_same(fit.coefficients, ship, 1e-6);
  REQUIRE(fit.starts.size() == 2);
  CHECK(fit.samples ==
        fit_linear(runs[0], {.L = ship_length}).samples + fit_linear(runs[1], {.L = ship_length}).samples);
  CHECK_THAT(fit.starts[1].psi.value, WithinAbs(3.0, 1e-6));
  CHECK_THAT(fit.starts[1].omega.value, WithinAbs(0.1, 1e-6));
}

TEST_CASE("unknown zeros of gyro and drift are found", "[identification][round-trip]") {
  auto run = recorded(RandomLinearShips::tanker(), {.rudder_offset = -0.01});
  for (double& r : run.fill(Channel::r)) r += 2e-4;
  for (std::size_t i = 0; i < run.samples(); ++i) {
    const double beta = std::atan2(-run[Channel::v][i], run[Channel::u][i]) + 0.02;
    run.fill(Channel::u)[i] = test::ship_speed * std::cos(beta);
    run.fill(Channel::v)[i] = -test::ship_speed * std::sin(beta);
  }
  const auto fit = fit_linear(run, {.L = ship_length, .yaw_rate_offset = true, .drift_offset = true});
  require_same(fit.coefficients, RandomLinearShips::tanker(), 1e-6);
  CHECK_THAT(fit.yaw_rate_offset.value, WithinAbs(2e-4, 1e-9));
  CHECK_THAT(fit.drift_offset.value, WithinAbs(0.02, 1e-7));
  CHECK_THAT(fit.rudder_offset.value, WithinAbs(-0.01, 1e-7));
}

TEST_CASE("a mirrored recording gives the same ship", "[identification][symmetry]") {
  auto run = recorded(RandomLinearShips::tanker(), {.rudder_offset = 0.01, .noise = 0.003});
  const auto fit = fit_linear(run, {.L = ship_length});
  for (const Channel channel : {Channel::psi, Channel::r, Channel::v, Channel::delta})
    for (double& x : run.fill(channel)) x = -x;
  const auto mirrored = fit_linear(run, {.L = ship_length});
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK_THAT(listed(mirrored.coefficients)[i].value, WithinRel(listed(fit.coefficients)[i].value, 1e-6));
    CHECK_THAT(listed(mirrored.coefficients)[i].standard_error,
               WithinRel(listed(fit.coefficients)[i].standard_error, 1e-3));
  }
  CHECK_THAT(mirrored.rudder_offset.value, WithinAbs(-fit.rudder_offset.value, 1e-7));
}

TEST_CASE("heading and yaw rate alone determine yaw and nothing of drift", "[identification][limit]") {
  for (const auto& ship : {RandomLinearShips::tanker(), unstable_ship()}) {
    const auto run = recorded(ship, {.noise = 1e-4, .drift = false});
    const auto fit = fit_linear(run, {.L = ship_length, .spacing = 0.0});
    const auto truth = steering_indices(ship);
    const auto h = transfer_functions(ship);
    CHECK(fit.indices.Kw.verdict() == Verdict::determined);
    CHECK(fit.indices.T3w.verdict() == Verdict::determined);
    REQUIRE(fit.time_constants);
    CHECK(fit.time_constants->T1.verdict() == Verdict::determined);
    CHECK_THAT(fit.indices.Kw.value, WithinAbs(truth.Kw, 4.0 * fit.indices.Kw.standard_error));
    CHECK_THAT(fit.indices.T3w.value, WithinAbs(truth.T3w, 4.0 * fit.indices.T3w.standard_error));
    CHECK_THAT(fit.transfer.e0.value, WithinAbs(h.e0, 4.0 * fit.transfer.e0.standard_error));
    CHECK_THAT(fit.transfer.e1.value, WithinAbs(h.e1, 4.0 * fit.transfer.e1.standard_error));
    CHECK(fit.indices.Kb.verdict() == Verdict::not_determined);
    CHECK(fit.indices.T3b.verdict() == Verdict::not_determined);
    for (const auto& constant : listed(fit.coefficients)) CHECK(constant.verdict() == Verdict::not_determined);
    CHECK(fit.stable == is_stable(ship));
  }
}

TEST_CASE("a first-order ship leaves her second time constant undetermined", "[identification][limit]") {
  // T3w = T2: a pole and a zero cancel, and nothing of T2 shows in yaw
  const auto ship = first_order_ship(-1.5, 3.0);
  const auto fit = fit_linear(recorded(ship, {.noise = 0.002, .drift = false}), {.L = ship_length, .spacing = 0.0});
  CHECK(fit.indices.T3w.verdict() != Verdict::determined);
  CHECK(fit.condition_number > 100.0);
}

TEST_CASE("95 % intervals hold the truth in 90 to 99 % of noisy zigzags", "[identification][second-route]") {
  const test::RecordedZigzag wish{.step = 0.14, .rudder_offset = 0.01, .noise = 0.003};
  const auto stable = coverage(RandomLinearShips::tanker(), wish, {.L = ship_length, .spacing = 0.0}, 120);
  const auto unstable = coverage(unstable_ship(), wish, {.L = ship_length, .spacing = 0.0}, 120);
  for (std::size_t i = 0; i < 6; ++i) {
    INFO("constant " << i << ", stable " << stable[i] << ", unstable " << unstable[i]);
    CHECK(stable[i] >= 0.88);
    CHECK(unstable[i] >= 0.88);
    CHECK(0.5 * (stable[i] + unstable[i]) >= 0.90);
    CHECK(0.5 * (stable[i] + unstable[i]) <= 0.99);
  }
}

TEST_CASE("intervals hold under random forces, and do not if these are taken for noise",
          "[identification][second-route]") {
  const test::RecordedZigzag wish{.step = 0.14, .noise = 0.002, .disturbance = 0.005};
  for (const auto& ship : {RandomLinearShips::tanker(), unstable_ship()}) {
    const auto with = coverage(ship, wish, {.L = ship_length, .spacing = 0.0}, 60);
    const auto without = coverage(ship, wish, {.L = ship_length, .spacing = 0.0, .disturbances = false}, 60);
    for (std::size_t i = 0; i < 6; ++i) {
      INFO("constant " << i << ", with disturbances " << with[i] << ", without " << without[i]);
      CHECK(with[i] >= 0.85);
      CHECK(without[i] < with[i]);
    }
  }
}

TEST_CASE("standard errors hold for correlated noise when measurements are as far apart",
          "[identification][second-route]") {
  const test::RecordedZigzag wish{.step = 0.14, .noise = 0.003, .correlation = 0.5};
  for (const auto& ship : {RandomLinearShips::tanker(), unstable_ship()}) {
    const auto inside = coverage(ship, wish, {.L = ship_length, .spacing = 0.5}, 60);
    for (std::size_t i = 0; i < 6; ++i) {
      INFO("constant " << i << ", " << inside[i]);
      CHECK(inside[i] >= 0.88);
    }
  }
}

TEST_CASE("the verdict on stability carries its probability", "[identification][limit]") {
  const test::RecordedZigzag wish{.noise = 0.003};
  const auto stable = fit_linear(recorded(RandomLinearShips::tanker(), wish), {.L = ship_length});
  CHECK(stable.stable);
  CHECK(stable.probability_stable > 0.99);
  const auto unstable = fit_linear(recorded(unstable_ship(), wish), {.L = ship_length});
  CHECK_FALSE(unstable.stable);
  CHECK(unstable.probability_stable < 0.01);
  CHECK_THAT(unstable.amplitude.rudder, WithinRel(radians(10), 1e-9));
}

TEST_CASE("a large zigzag of an unstable nonlinear ship looks stable", "[identification][limit]") {
  const Ship ship = read_ship(test::ships / "kvlcc2_l7.toml");
  const auto fitted = [&](double angle) {
    const auto run = zigzag(ship, {.rudder = radians(angle), .heading = radians(angle)}, {.duration = 150.0}).run;
    return fit_linear(run, {.L = length(ship)});
  };
  const auto small = fitted(0.5), middle = fitted(10.0), large = fitted(20.0);
  CHECK_FALSE(small.stable);
  CHECK(middle.stable);
  CHECK(large.stable);
  CHECK(small.transfer.e0.value < middle.transfer.e0.value);
  CHECK(middle.transfer.e0.value < large.transfer.e0.value);
  CHECK(small.amplitude.omega < middle.amplitude.omega);
}

TEST_CASE("only samples that are used are counted", "[identification][limit]") {
  const auto run = recorded(RandomLinearShips::tanker(), {.noise = 0.003});  // a sample every 0.07 lengths
  CHECK(fit_linear(run, {.L = ship_length, .spacing = 0.0}).samples == run.samples());
  CHECK(fit_linear(run, {.L = ship_length, .spacing = 0.14}).samples == (run.samples() + 1) / 2);
}

TEST_CASE("known noise is used as given", "[identification][limit]") {
  const auto run = recorded(RandomLinearShips::tanker(), {.noise = 0.003});
  const ChannelNoise noise{.psi = 0.003, .r = 0.0009 * test::ship_speed / ship_length, .beta = 0.003};
  const auto estimated = fit_linear(run, {.L = ship_length, .spacing = 0.0}),
             known = fit_linear(run, {.L = ship_length, .spacing = 0.0, .noise = noise});
  CHECK_THAT(known.noise.psi, WithinRel(0.003, 1e-5));
  CHECK_THAT(estimated.noise.psi, WithinRel(0.003, 0.1));
  CHECK_THAT(estimated.noise.beta, WithinRel(0.003, 0.1));
  CHECK_THAT(estimated.noise.r, WithinRel(noise.r, 0.1));
  CHECK_THAT(known.coefficients.a2.value,
             WithinAbs(estimated.coefficients.a2.value, estimated.coefficients.a2.standard_error));
}

TEST_CASE("what cannot be fitted is refused in words", "[identification][refusal]") {
  auto run = recorded(RandomLinearShips::tanker(), {});
  CHECK_THROWS_WITH(fit_linear(run, {.L = 0.0}), ContainsSubstring("ship length L [m] must be positive"));
  CHECK_THROWS_WITH(fit_linear(run, {.L = 100.0, .noise = ChannelNoise{.psi = -0.001, .r = 0.001, .beta = 0.001}}),
                    ContainsSubstring("known noise must be positive"));
  CHECK_THROWS_WITH(fit_linear(run, {.L = 100.0, .from = 1e6}), ContainsSubstring("no samples in the interval"));
  CHECK_THROWS_WITH(fit_linear(run, {.L = 100.0, .use_heading = false, .use_yaw_rate = false}),
                    ContainsSubstring("neither heading nor yaw rate"));
  CHECK_THROWS_WITH(fit_linear(run, {.L = 100.0, .to = 3.0}), ContainsSubstring("fewer than 20 measurements"));
  run.channels[index_of(Channel::u)].clear();
  CHECK_THROWS_WITH(fit_linear(run, {.L = 100.0}), ContainsSubstring("no channel tells the speed"));
  CHECK_NOTHROW(fit_linear(run, {.L = 100.0, .U = 7.0}));
  run.channels[index_of(Channel::delta)].clear();
  CHECK_THROWS_AS(fit_linear(run, {.L = 100.0, .U = 7.0}), Refusal);
}

}  // namespace
}  // namespace swayaw
