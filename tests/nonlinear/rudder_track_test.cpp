#include "swayaw/nonlinear/simulation/rudder_track.hpp"

#include <catch.hpp>
#include <cmath>
#include <random>

namespace swayaw {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

std::vector<AngleLine> lines(const std::vector<double>& time, const std::vector<double>& angle) {
  return lines_through(time, angle);
}

/// The same by small steps.
std::vector<double> by_steps(std::span<const AngleLine> recorded, const RudderActuator& a,
                             std::span<const double> times) {
  std::vector<double> result;
  const double step = 2e-5;
  double y = recorded.front().angle, played = y, now = recorded.front().time;
  for (const double time : times) {
    while (now < time - 0.5 * step) {
      now += step;
      const double x = angle_at(recorded, now);
      played = std::clamp(played, x - 0.5 * a.width, x + 0.5 * a.width);
      const double wanted = a.lag > 0.0 ? (played - y) / a.lag : (played - y) / step;
      y += step * std::clamp(wanted, -a.rate, a.rate);
    }
    result.push_back(y + a.offset);
  }
  return result;
}

TEST_CASE("a lagging rudder answers a step as an exponential", "[nonlinear][published]") {
  const RudderActuator lag{.lag = 2.5};
  const double order = 0.3;
  const auto step = lines({0.0, 1.0, 1.0 + 1e-9, 20.0}, {0.0, 0.0, order, order});
  const RudderTrack rudder(lag, step);
  for (const double t : {1.5, 2.0, 4.0, 10.0, 25.0})
    CHECK_THAT(rudder.at(t), WithinAbs(order * (1.0 - std::exp(-(t - 1.0) / lag.lag)), 1e-8));
}

TEST_CASE("a lagging rudder answers a ramp a lag late", "[nonlinear][limit]") {
  const RudderTrack rudder({.lag = 0.7}, lines({0.0, 100.0}, {0.0, 1.0}));
  CHECK_THAT(rudder.at(50.0), WithinAbs(0.5 - 0.01 * 0.7, 1e-12));
}

TEST_CASE("a slow rudder keeps its rate until it has caught up", "[nonlinear][limit]") {
  const RudderTrack rudder({.rate = 0.05}, lines({0.0, 1.0, 30.0}, {0.0, 0.4, 0.4}));
  CHECK_THAT(rudder.at(4.0), WithinAbs(0.2, 1e-12));
  CHECK_THAT(rudder.at(8.0), WithinAbs(0.4, 1e-12));
  CHECK_THAT(rudder.at(20.0), WithinAbs(0.4, 1e-12));
}

TEST_CASE("a rudder on a clock of many seconds moves in as many pieces as on one that begins at 0",
          "[nonlinear][limit]") {
  const std::vector<double> angle{0.0, 0.3, -0.2, -0.2, 0.25};
  const auto pieces = [&](double begin) {
    std::vector<double> time{begin};
    while (time.size() < angle.size()) time.push_back(time.back() + 3.1);
    return behind_lag(lines(time, angle), 0.5, 0.05, 0.0);
  };
  const auto now = pieces(0.0), since_1970 = pieces(1.7e9);
  REQUIRE(since_1970.size() == now.size());
  for (std::size_t i = 0; i < now.size(); ++i)
    CHECK_THAT(since_1970[i].start() - 1.7e9, WithinAbs(now[i].start(), 1e-5));
}

TEST_CASE("behind a play the rudder rests until the angle has come the width back", "[nonlinear][limit]") {
  const RudderTrack rudder({.width = 0.1}, lines({0.0, 10.0, 20.0}, {0.0, 1.0, 0.0}));
  CHECK_THAT(rudder.at(0.4), WithinAbs(0.0, 1e-12));
  CHECK_THAT(rudder.at(5.0), WithinAbs(0.45, 1e-12));
  CHECK_THAT(rudder.at(10.9), WithinAbs(0.95, 1e-12));
  CHECK_THAT(rudder.at(15.0), WithinAbs(0.55, 1e-12));
}

TEST_CASE("without play, lag and rate the rudder is where it is shown, off by the offset", "[nonlinear][limit]") {
  const auto shown = lines({0.0, 1.0, 2.5, 4.0}, {0.1, -0.2, 0.3, 0.0});
  const RudderTrack rudder({.offset = 0.02}, shown);
  for (double t = 0.0; t < 5.0; t += 0.1) CHECK_THAT(rudder.at(t), WithinAbs(angle_at(shown, t) + 0.02, 1e-14));
}

TEST_CASE("the closed form of play, lag, rate and offset is what small steps give", "[nonlinear][second-route]") {
  std::mt19937 engine(5);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  };
  for (int i = 0; i < 12; ++i) {
    std::vector<double> time{0.0}, angle{uniform(-0.3, 0.3)}, at;
    for (int k = 0; k < 8; ++k) {
      time.push_back(time.back() + uniform(0.2, 2.0));
      angle.push_back(uniform(0.0, 1.0) < 0.3 ? angle.back() : uniform(-0.6, 0.6));
    }
    for (double t = 0.1; t < time.back(); t += 0.1) at.push_back(t);
    const RudderActuator a{.width = i % 3 == 0 ? 0.0 : uniform(0.0, 0.1),
                           .lag = i % 4 == 1 ? 0.0 : uniform(0.1, 1.5),
                           .rate = i % 2 ? uniform(0.1, 0.4) : never,
                           .offset = uniform(-0.05, 0.05)};
    if (a.lag == 0.0 && a.rate == never && a.width == 0.0) continue;
    const auto recorded = lines(time, angle);
    const RudderTrack rudder(a, recorded);
    const auto stepped = by_steps(recorded, a, at);
    INFO(i << " lag " << a.lag << " rate " << a.rate << " width " << a.width);
    for (std::size_t k = 0; k < at.size(); ++k) REQUIRE_THAT(rudder.at(at[k]), WithinAbs(stepped[k], 3e-4));
  }
}

TEST_CASE("a track that goes on from another has no jump", "[nonlinear][limit]") {
  const RudderActuator a{.width = 0.05, .lag = 1.0, .rate = 0.2, .offset = 0.01};
  const RudderTrack first(a, lines({0.0, 2.0, 10.0}, {0.0, 0.4, 0.4}));
  const RudderTrack second(a, lines({3.0, 5.0, 10.0}, {0.4, -0.2, -0.2}), first);
  CHECK_THAT(second.at(3.0), WithinAbs(first.at(3.0), 1e-14));
  CHECK_THAT(second.at(3.0 + 1e-7), WithinAbs(first.at(3.0), 1e-6));
  CHECK_THAT(second.at(40.0), WithinAbs(-0.2 + 0.025 + 0.01, 1e-9));
}

TEST_CASE("a steering gear with a lag is drawn by chords to a millionth of a radian", "[nonlinear][second-route]") {
  const SteeringGear<> gear{.rate = 0.1, .max_angle = 0.6, .lag = 2.0, .dead_band = 0.0};
  const auto motion = RudderMotion<>::ordered(gear, 1.0, -0.1, 0.5);
  const auto drawn = lines_of(motion, 1.0);
  for (double t = 1.0; t < 40.0; t += 0.013) REQUIRE_THAT(angle_at(drawn, t), WithinAbs(motion.at(t), 2e-6));
}

TEST_CASE("angles at times in order are those at each time", "[nonlinear][second-route]") {
  const RudderTrack rudder({.width = 0.03, .lag = 0.8, .rate = 0.1, .offset = -0.02},
                           lines({2.0, 4.0, 9.0, 12.0}, {0.1, 0.4, -0.3, -0.3}));
  std::vector<double> times{0.0, 2.0, 2.0};  // before the first line, and twice the same
  for (double t = 2.1; t < 30.0; t += 0.37) times.push_back(t);
  const auto angles = rudder.at(times);
  REQUIRE(angles.size() == times.size());
  for (std::size_t i = 0; i < times.size(); ++i) CHECK(angles[i] == rudder.at(times[i]));
}

}  // namespace
}  // namespace swayaw
