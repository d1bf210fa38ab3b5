#include "swayaw/core/steering_gear.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "catch.hpp"
#include "swayaw/core/followed_order.hpp"

namespace swayaw {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// d(delta)/dt as the steering gear is defined.
double rate_of(const SteeringGear<double>& gear, double angle, double order) {
  const double error = order - angle;
  if (std::abs(error) <= gear.dead_band) return 0.0;
  const double wanted = gear.lag > 0.0 ? error / gear.lag : std::copysign(never, error);
  return std::clamp(wanted, -gear.rate, gear.rate);
}

TEST_CASE("the closed-form rudder motion obeys the steering gear's equation at every time", "[core][second-route]") {
  std::mt19937_64 engine(3);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  };
  for (int i = 0; i < 2000; ++i) {
    const SteeringGear<double> gear{.rate = uniform(0.02, 0.1),
                                    .max_angle = 0.6,
                                    .lag = i % 3 == 0 ? 0.0 : uniform(0.1, 5.0),
                                    .dead_band = i % 2 == 0 ? 0.0 : uniform(0.001, 0.03)};
    const double from = uniform(-0.6, 0.6), order = uniform(-0.6, 0.6), start = uniform(-10.0, 10.0);
    const auto motion = RudderMotion<>::ordered(gear, start, from, order);
    CHECK(motion.at(start) == Approx(from).margin(1e-14));
    double kinks[2] = {motion.next_kink(start), never};
    kinks[1] = motion.next_kink(kinks[0]);
    for (int k = 0; k < 20; ++k) {
      const double time = start + uniform(0.0, 40.0), h = 1e-5;
      if (std::abs(time - kinks[0]) < 2 * h || std::abs(time - kinks[1]) < 2 * h) continue;
      const double rate = (motion.at(time + h) - motion.at(time - h)) / (2 * h);
      if (gear.lag == 0.0 && std::abs(motion.at(time) - order) <= gear.dead_band + 1e-12) CHECK(std::abs(rate) < 1e-9);
      else if (std::abs(std::abs(order - motion.at(time)) - gear.dead_band) > 1e-12)
        CHECK(rate == Approx(rate_of(gear, motion.at(time), order)).margin(1e-9));
    }
  }
}

TEST_CASE("without lag the rudder keeps its rate until it arrives exactly", "[core][limit]") {
  const SteeringGear<double> gear{.rate = 0.04, .max_angle = 0.6};
  const auto motion = RudderMotion<>::ordered(gear, 1.0, 0.1, -0.1);
  CHECK(motion.at(3.5) == Approx(0.0).margin(1e-15));
  CHECK(motion.next_kink(1.0) == Approx(6.0));
  CHECK(motion.at(6.0 + 1e-9) == -0.1);
  CHECK(motion.at(100.0) == -0.1);
  CHECK(motion.next_kink(6.0) == never);
}

TEST_CASE("a change within the dead band moves nothing, a larger one stops short by the band", "[core][limit]") {
  const SteeringGear<double> gear{.rate = 0.04, .max_angle = 0.6, .lag = 1.0, .dead_band = 0.02};
  CHECK(RudderMotion<>::ordered(gear, 0.0, 0.1, 0.119).at(50.0) == 0.1);
  CHECK(RudderMotion<>::ordered(gear, 0.0, 0.1, 0.3).at(50.0) == Approx(0.28));
  CHECK(RudderMotion<>::ordered(gear, 0.0, 0.1, -0.3).at(50.0) == Approx(-0.28));
}

TEST_CASE("a rudder of which the order was recorded follows it as the steering gear's equation says",
          "[core][second-route]") {
  std::mt19937_64 engine(5);
  for (const auto& gear : {SteeringGear<double>{.rate = 0.05, .max_angle = 0.6, .lag = 0.0, .dead_band = 0.0},
                           SteeringGear<double>{.rate = 0.08, .max_angle = 0.6, .lag = 1.5, .dead_band = 0.01}}) {
    Recording run;
    for (int i = 0; i < 200; ++i) run.time.push_back(0.5 * i);
    auto orders = run.fill(Channel::delta_order);
    for (std::size_t i = 0; i < orders.size(); ++i)
      orders[i] = i % 40 == 0 ? std::uniform_real_distribution(-0.5, 0.5)(engine) : orders[i - 1];
    orders[77] = missing;
    const auto followed = with_followed_order(run, gear);
    double angle = orders[0];
    constexpr int substeps = 2000;
    for (std::size_t i = 1; i < orders.size(); ++i) {
      // the order between two samples is that of the second
      const double order = std::isnan(orders[i]) ? orders[i + 1] : orders[i];
      for (int k = 0; k < substeps; ++k) {
        const double dt = 0.5 / substeps, step = rate_of(gear, angle, order) * dt;
        angle += std::abs(step) > std::abs(order - angle) ? order - angle : step;
      }
      if (std::isnan(orders[i])) CHECK(std::isnan(followed[Channel::delta][i]));
      else CHECK_THAT(followed[Channel::delta][i], WithinAbs(angle, 1e-4));
    }
    std::ranges::fill(run.fill(Channel::delta), 0.1);
    CHECK(std::ranges::equal(with_followed_order(run, gear)[Channel::delta], run[Channel::delta]));
  }
}

}  // namespace
}  // namespace swayaw
