#include "swayaw/nonlinear/instruments/instruments.hpp"

#include <algorithm>
#include <catch.hpp>
#include <cmath>
#include <complex>
#include <random>

#include "swayaw/core/dual.hpp"

namespace swayaw {
namespace {

/// Seeded motions of a ship in a stream, every number of them different from 0.
class RandomSights {
 public:
  explicit RandomSights(unsigned seed) : engine_(seed) {}

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }

  ShipState<double> state() {
    return {
        uniform(-500, 500), uniform(-500, 500), uniform(-3, 3), {uniform(2, 8), uniform(-1, 1), uniform(-0.02, 0.02)}};
  }

  Current<double> current() { return {uniform(0.1, 1.0), uniform(-3, 3)}; }

  Instruments<double> instruments() {
    Instruments<double> result;
    for (auto& error : result.channels) error = {uniform(0.9, 1.1), uniform(-0.1, 0.1), uniform(-2, 2)};
    result.antenna_x = uniform(-50, 50);
    result.antenna_y = uniform(-10, 10);
    result.velocity_axes = uniform(-0.2, 0.2);
    return result;
  }

 private:
  std::mt19937_64 engine_;
};

TEST_CASE("an instrument shows scale times the truth of a while ago plus a bias", "[nonlinear][second-route]") {
  RandomSights random(1);
  for (int i = 0; i < 50; ++i) {
    const auto s = random.state();
    const auto current = random.current();
    auto instruments = random.instruments();
    const double x = instruments.antenna_x, y = instruments.antenna_y, phi = random.uniform(-0.3, 0.3);
    // velocity to the north and the east of a point of the turning ship
    const double c = std::cos(s.psi), sine = std::sin(s.psi);
    const double forward = s.motion.u - s.motion.r * y, sideways = s.motion.v + s.motion.r * x;
    const double north = forward * c - sideways * sine + current.speed * std::cos(current.to);
    const double east = forward * sine + sideways * c + current.speed * std::sin(current.to);
    const double by = instruments.velocity_axes, axes = s.psi + by;
    const std::pair<Channel, double> expected[] = {{Channel::x, s.x + x * c - y * sine},
                                                   {Channel::y, s.y + x * sine + y * c},
                                                   {Channel::psi, s.psi},
                                                   {Channel::u, s.motion.u * std::cos(by) + s.motion.v * std::sin(by)},
                                                   {Channel::speed_through_water, s.motion.u},
                                                   {Channel::v, s.motion.v * std::cos(by) - s.motion.u * std::sin(by)},
                                                   {Channel::r, s.motion.r},
                                                   {Channel::u_ground, north * std::cos(axes) + east * std::sin(axes)},
                                                   {Channel::v_ground, east * std::cos(axes) - north * std::sin(axes)},
                                                   {Channel::speed_over_ground, std::hypot(north, east)},
                                                   {Channel::course_over_ground, std::atan2(east, north)},
                                                   {Channel::phi, phi}};
    CHECK(std::size(expected) == motion_channels().size());
    for (const auto& [channel, truth] : expected) {
      INFO(short_name(channel));
      const auto& error = instruments[channel];
      double asked = 0.0;
      const double shown = observe(channel, instruments, [&](double delay) {
        asked = delay;
        return kinematics(s, current, phi);
      });
      CHECK(asked == error.delay);
      const double off = shown - (error.scale * truth + error.bias);
      CHECK((is_direction(channel) ? wrapped(off / error.scale) : off) == Approx(0.0).margin(1e-9));
    }
  }
}

TEST_CASE("what instruments show changes with the state as their derivatives say", "[nonlinear][second-route]") {
  using D = Dual<6>;
  RandomSights random(2);
  const auto state_with = [](const ShipState<double>& s, int i, double h) {
    auto moved = vector_of(s);
    moved[static_cast<std::size_t>(i)] += h;
    return state_of(moved);
  };
  for (int k = 0; k < 20; ++k) {
    const auto s = random.state();
    const auto current = random.current();
    const auto instruments = random.instruments();
    const auto in_duals = cast<D>(instruments);
    const ShipState<D> dual{D(s.x, 0), D(s.y, 1), D(s.psi, 2), {D(s.motion.u, 3), D(s.motion.v, 4), D(s.motion.r, 5)}};
    const Current<D> dual_current{D(current.speed), D(current.to)};
    for (const auto channel : motion_channels()) {
      const auto shown = [&](const ShipState<double>& at) {
        return observe(channel, instruments, [&](double) { return kinematics(at, current, 0.1); });
      };
      const D exact = observe(channel, in_duals, [&](const D&) { return kinematics(dual, dual_current, D(0.1)); });
      CHECK(exact.a == Approx(shown(s)));
      for (int i = 0; i < 6; ++i) {
        constexpr double h = 1e-6;
        const double slope = (shown(state_with(s, i, h)) - shown(state_with(s, i, -h))) / (2.0 * h);
        CHECK(exact.v[i] == Approx(slope).margin(1e-6 * (1.0 + std::abs(slope))));
      }
    }
  }
}

/// A run of samples 0.5 s apart, every channel of motion recorded by perfect instruments.
Recording true_run(RandomSights& random) {
  Recording run;
  for (int i = 0; i < 40; ++i) run.time.push_back(0.5 * i);
  const auto s = random.state();
  const auto current = random.current();
  for (const auto channel : motion_channels()) run.fill(channel);
  for (std::size_t i = 0; i < run.samples(); ++i) {
    const double t = run.time[i];
    const ShipState<double> now{
        s.x + 5.0 * t, s.y + 0.1 * t * t, s.psi + s.motion.r * t, {s.motion.u - 0.01 * t, s.motion.v, s.motion.r}};
    for (const auto channel : motion_channels())
      run.channels[index_of(channel)][i] = observe(channel, kinematics(now, current, 0.05 * std::sin(t)));
  }
  return run;
}

TEST_CASE("a whole run is recorded as its samples are observed", "[nonlinear][second-route]") {
  RandomSights random(3);
  for (int k = 0; k < 10; ++k) {
    const auto truth = true_run(random);
    auto instruments = random.instruments();
    for (auto& error : instruments.channels) error.delay = 0.0;
    const auto recorded = as_recorded(truth, instruments);
    for (std::size_t i = 0; i < truth.samples(); ++i) {
      const auto value = [&](Channel c) { return truth[c][i]; };
      const Kinematics<double> now{{value(Channel::x),
                                    value(Channel::y),
                                    value(Channel::psi),
                                    {value(Channel::u), value(Channel::v), value(Channel::r)}},
                                   {value(Channel::u_ground), value(Channel::v_ground), 0.0},
                                   value(Channel::phi)};
      for (const auto channel : motion_channels()) {
        INFO(short_name(channel));
        const double off = recorded[channel][i] - observe(channel, instruments, [&](double) { return now; });
        CHECK((is_direction(channel) ? wrapped(off / instruments[channel].scale) : off) == Approx(0.0).margin(1e-9));
      }
    }
  }
}

TEST_CASE("a late channel shows what was true a while ago", "[nonlinear][limit]") {
  RandomSights random(4);
  const auto truth = true_run(random);
  for (const auto channel : motion_channels()) {
    Instruments<double> late;
    late[channel].delay = 1.0;  // two samples
    const auto recorded = as_recorded(truth, late);
    for (std::size_t i = 2; i < truth.samples(); ++i)
      CHECK(recorded[channel][i] == Approx(truth[channel][i - 2]).margin(1e-9));
    const auto back = as_it_was(recorded, late);
    for (std::size_t i = 2; i + 2 < truth.samples(); ++i)
      CHECK(back[channel][i] == Approx(truth[channel][i]).margin(1e-9));
  }
}

TEST_CASE("a clock that runs and jumps shows what was true by so much longer ago", "[nonlinear][second-route]") {
  RandomSights random(7);
  const auto truth = true_run(random);
  const double begin = truth.time.front(), jump = 8.25;
  const std::vector<Effect> effects{ClockDrift<>{.channel = Channel::psi, .rate = 0.02},
                                    ClockDrift<>{.channel = Channel::psi, .rate = 0.0, .at = jump, .by = 1.5},
                                    ClockDrift<>{.channel = Channel::x, .rate = -0.01}};
  const auto instruments = instruments_of(std::span<const Effect>(effects));
  const auto recorded = as_recorded(truth, instruments);
  for (std::size_t i = 0; i < truth.samples(); ++i) {
    const double t = truth.time[i], late = 0.02 * (t - begin) + (t >= jump ? 1.5 : 0.0);
    CHECK(instruments[Channel::psi].late({t, begin}) == Approx(late));
    const double rate = truth[Channel::r].front();  // a steady turn
    CHECK(recorded[Channel::psi][i] == Approx(truth[Channel::psi][i] - rate * late).margin(1e-9));
    CHECK(recorded[Channel::r][i] == truth[Channel::r][i]);
  }
  CHECK(instruments[Channel::y].clock == instruments[Channel::x].clock);
  const auto back = as_it_was(recorded, instruments);
  for (std::size_t i = 4; i + 8 < truth.samples(); ++i)
    for (const auto channel : {Channel::psi, Channel::x, Channel::y})
      CHECK(back[channel][i] == Approx(truth[channel][i]).margin(2e-2));  // straight lines between samples
}

// Exact answers to exp(i ω t): 1/(1 + i ω T) of the lag, sin(ωT/2)/(ωT/2) of the mean.
TEST_CASE("two looks do to a slow motion what a filter does", "[nonlinear][second-route]") {
  const auto gain = [](const ChannelSmoothing<double>& smoothing, double omega) {
    std::complex<double> sum;
    for (const auto& look : smoothing.looks()) sum += look.weight * std::polar(1.0, -omega * look.delay);
    return sum;
  };
  using namespace std::complex_literals;
  for (const double time : {0.3, 1.0, 4.0})
    for (const double turn : {0.05, 0.1, 0.2}) {  // ω T
      const auto lag = 1.0 / (1.0 + 1.0i * turn);
      CHECK(std::abs(gain({time, 1.0}, turn / time) - lag) < std::pow(turn, 4));
      const std::complex<double> mean = std::sin(0.5 * turn) / (0.5 * turn);
      CHECK(std::abs(gain({time, 0.0}, turn / time) - mean) < 0.001 * std::pow(turn, 4));
    }
  CHECK(gain({0.0, 1.0}, 1.0) == 1.0);
}

TEST_CASE("a run that was smoothed is what a filter makes of it", "[nonlinear][second-route]") {
  constexpr double step = 0.05, omega = 0.2, T = 1.0;
  Recording run;
  for (int i = 0; i < 2000; ++i) run.time.push_back(step * i);
  auto r = run.fill(Channel::r);
  for (std::size_t i = 0; i < run.samples(); ++i) r[i] = std::sin(omega * run.time[i]);
  const auto smoothed = [&](double causal) {
    const std::vector<Effect> filter{ChannelFilter<>{.channel = Channel::r, .time = T, .causal = causal}};
    return as_recorded(run, instruments_of(std::span<const Effect>(filter)));
  };
  const auto lag = smoothed(1.0), mean = smoothed(0.0);
  double y = -omega * T / (1.0 + omega * omega * T * T);  // the steady answer
  for (std::size_t i = 1; i < run.samples(); ++i) {
    const double in = 0.5 * (r[i] + r[i - 1]);  // T dy/dt + y = r
    y += (in - y) * (1.0 - std::exp(-step / T));
    double sum = 0.0;
    constexpr int half = 10;
    const bool within = i >= half && i + half < run.samples();
    for (int k = -half; k <= half && within; ++k)
      sum += r[i + static_cast<std::size_t>(k)] * (std::abs(k) == half ? 0.5 : 1.0) / (2.0 * half);
    if (i > 100) CHECK(lag[Channel::r][i] == Approx(y).margin(2e-3));
    if (within) CHECK(mean[Channel::r][i] == Approx(sum).margin(2e-4));
  }
}

TEST_CASE("a gyro with a zero and a factor shows factor times yaw rate plus zero", "[nonlinear][second-route]") {
  RandomSights random(6);
  const std::vector<Effect> gyro{GyroScale<>{1.02}, GyroBias<>{0.001}};
  const auto truth = true_run(random);
  const auto recorded = as_recorded(truth, instruments_of(std::span<const Effect>(gyro)));
  for (std::size_t i = 0; i < truth.samples(); ++i) {
    CHECK(recorded[Channel::r][i] == Approx(1.02 * truth[Channel::r][i] + 0.001));
    CHECK(recorded[Channel::psi][i] == truth[Channel::psi][i]);
  }
}

TEST_CASE("a run put right again is the run", "[nonlinear][round-trip]") {
  RandomSights random(5);
  for (int k = 0; k < 10; ++k) {
    const auto truth = true_run(random);
    auto instruments = random.instruments();
    for (auto& error : instruments.channels) error.delay = 0.0;
    const auto back = as_it_was(as_recorded(truth, instruments), instruments);
    for (const auto channel : motion_channels())
      for (std::size_t i = 0; i < truth.samples(); ++i) {
        const double off = back[channel][i] - truth[channel][i];
        CHECK((is_direction(channel) ? wrapped(off) : off) == Approx(0.0).margin(1e-9));
      }
  }
}

}  // namespace
}  // namespace swayaw
