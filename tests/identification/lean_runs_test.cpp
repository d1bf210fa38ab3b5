#include <algorithm>
#include <catch.hpp>
#include <cmath>
#include <random>

#include "random_ships.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/identification/map_fit.hpp"
#include "trajectory_recordings.hpp"

/// Runs of few samples, and noise with a memory, against laws.
namespace swayaw {
namespace {

/// A tanker of 320 m on a slow curve whose channels are quadratics of time, recorded at a rate.
struct Curve {
  Ship ship = test::kvlcc2();
  double unit = time_unit_of(ship);

  static double position(double t) { return 7.0 * t - 1e-3 * t * t; }
  static double yaw_rate(double t) { return 2e-3 + 3e-6 * t - 4e-9 * t * t; }

  template <class Error>
  Recording recorded(double rate, double duration, Error&& error) const {
    Recording run{.name = "curve.csv", .facts = {}, .time = {}, .channels = {}, .extra = {}};
    const auto n = static_cast<std::size_t>(duration * rate) + 1;
    for (std::size_t k = 0; k < n; ++k) run.time.push_back(static_cast<double>(k) / rate);
    for (const auto channel : {Channel::x, Channel::y, Channel::psi, Channel::u, Channel::r, Channel::delta}) {
      const auto values = run.fill(channel);
      for (std::size_t k = 0; k < n; ++k) {
        const double t = run.time[k];
        values[k] = channel == Channel::x   ? position(t) + error(channel, t)
                    : channel == Channel::r ? yaw_rate(t) + error(channel, t)
                    : channel == Channel::u ? 7.0
                                            : 0.0;
      }
    }
    return run;
  }
};

constexpr std::array seen{Channel::x, Channel::y, Channel::psi, Channel::u, Channel::r};

std::vector<double> there(const PreparedRun& run, Channel channel, auto&& truth) {
  std::vector<double> errors;
  for (std::size_t k = 0; k < run.run->samples(); ++k)
    if (const double value = (*run.run)[channel][k]; !std::isnan(value))
      errors.push_back(value - truth(run.run->time[k]));
  return errors;
}

double rms(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double x : values) sum += x * x;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

}  // namespace

TEST_CASE("few samples of a curve that is a parabola are its values", "[identification][limit]") {
  const Curve curve;
  const std::vector runs{curve.recorded(2.0, 900.0, [](Channel, double) { return 0.0; })};
  const auto lean = lean_runs(curve.ship, runs, seen).front();
  const auto x = there(lean, Channel::x, Curve::position), r = there(lean, Channel::r, Curve::yaw_rate);
  CHECK(x.size() > 100);
  CHECK(rms(x) < 1e-6);
  CHECK(rms(r) < 1e-12);
}

TEST_CASE("where positions are recorded a run starts as they say, whatever axes the velocity over ground is in",
          "[identification][limit]") {
  const Curve curve;
  constexpr double askew = radians(4.0);  // of the compass
  auto run = curve.recorded(2.0, 900.0, [](Channel, double) { return 0.0; });
  run.channels[index_of(Channel::u)].clear();
  for (std::size_t k = 0; k < run.samples(); ++k) run.fill(Channel::psi)[k] += askew;
  auto with_log = run;  // along the axes of the ship, where she does not drift
  for (std::size_t k = 0; k < run.samples(); ++k)
    with_log.fill(Channel::u_ground)[k] = 7.0, with_log.fill(Channel::v_ground)[k] = 0.0;
  constexpr std::array all{Channel::x, Channel::y, Channel::psi, Channel::u_ground, Channel::v_ground};
  const auto start = [&](const Recording& of, std::span<const Channel> channels) {
    return lean_runs(curve.ship, {&of, 1}, channels).front().start.motion;
  };
  const auto by_track = start(run, seen), beside_log = start(with_log, all);
  CHECK(std::abs(by_track.v + 7.0 * std::sin(askew)) < 0.01);
  CHECK(beside_log.u == by_track.u);
  CHECK(beside_log.v == by_track.v);
  CHECK(std::abs(start(with_log, std::span(all).subspan(2)).v) < 1e-6);  // positions are not used
}

TEST_CASE("few samples have the noise that is said, and their number does not hang on the rate of the file",
          "[identification][limit]") {
  const Curve curve;
  std::vector<std::size_t> numbers;
  for (const double rate : {1.0, 4.0, 10.0}) {
    std::mt19937_64 engine(4);
    std::normal_distribution<double> normal;
    const std::vector runs{curve.recorded(
        rate, 1500.0, [&](Channel channel, double) { return normal(engine) * (channel == Channel::x ? 0.5 : 2e-4); })};
    const auto lean = lean_runs(curve.ship, runs, seen).front();
    const auto x = there(lean, Channel::x, Curve::position), r = there(lean, Channel::r, Curve::yaw_rate);
    INFO(rate);
    CHECK(std::abs(rms(x) / lean.deviation[index_of(Channel::x)] - 1.0) < 0.2);
    CHECK(std::abs(rms(r) / lean.deviation[index_of(Channel::r)] - 1.0) < 0.2);
    numbers.push_back(x.size());
    CHECK(static_cast<double>(lean.run->samples()) < 1.6 * 20.0 * 1500.0 / curve.unit);
  }
  CHECK(static_cast<double>(std::ranges::max(numbers)) < 1.15 * static_cast<double>(std::ranges::min(numbers)));
}

TEST_CASE("values near the ends of a run are as sure as those in its middle", "[identification][limit]") {
  const Curve curve;
  std::mt19937_64 engine(5);
  std::normal_distribution<double> normal(0.0, 1e-4);
  double squares = 0.0, count = 0.0;
  for (int k = 0; k < 40; ++k) {
    const std::vector runs{curve.recorded(2.0, 300.0, [&](Channel, double) { return normal(engine); })};
    const auto lean = lean_runs(curve.ship, runs, seen).front();
    const auto errors = there(lean, Channel::r, Curve::yaw_rate);
    const double said = lean.deviation[index_of(Channel::r)];
    for (const double e : {errors.front(), errors.back()}) squares += std::pow(e / said, 2), ++count;
  }
  CHECK(std::sqrt(squares / count) < 1.25);
}

TEST_CASE("a channel with values in every other row keeps as many as one with values in all, and none in a gap",
          "[identification][limit]") {
  const Curve curve;
  std::mt19937_64 engine(9);
  std::normal_distribution<double> normal;
  auto run = curve.recorded(2.0, 900.0, [&](Channel, double) { return 0.3 * normal(engine); });
  const auto full = there(lean_runs(curve.ship, std::span(&run, 1), seen).front(), Channel::x, Curve::position);
  constexpr double gap_from = 300.0, gap_to = 360.0;
  const auto x = run.fill(Channel::x);
  for (std::size_t k = 0; k < x.size(); ++k)
    if (k % 2 == 1 || (run.time[k] > gap_from && run.time[k] < gap_to)) x[k] = missing;
  const auto lean = lean_runs(curve.ship, std::span(&run, 1), seen).front();
  const auto half = there(lean, Channel::x, Curve::position);
  CHECK(static_cast<double>(half.size()) > 0.85 * static_cast<double>(full.size()));
  CHECK(rms(half) < 1.3 * lean.deviation[index_of(Channel::x)]);
  for (std::size_t k = 0; k < lean.run->samples(); ++k)
    if (const double t = lean.run->time[k]; t > gap_from + 1.5 && t < gap_to - 1.5)
      CHECK(std::isnan((*lean.run)[Channel::x][k]));
}

TEST_CASE("thinned runs leave slow recordings as they are, and of fast ones keep what they tell",
          "[identification][limit]") {
  const Curve curve;
  for (const double rate : {0.5, 10.0}) {
    INFO(rate << " samples a second");
    std::mt19937_64 engine(2);
    std::normal_distribution<double> normal;
    const std::vector runs{curve.recorded(
        rate, 900.0, [&](Channel c, double) { return (c == Channel::x ? 0.5 : 1e-4) * normal(engine); })};
    const auto whole = prepared_runs(curve.ship, runs, seen).front(),
               thin = thinned_runs(curve.ship, runs, seen).front();
    const double rows = static_cast<double>(thin.run->samples()) * curve.unit / 900.0;
    if (rate * curve.unit < 48.0) CHECK(thin.run->samples() == whole.run->samples());
    else CHECK((rows > 20.0 && rows < 30.0));
    const auto errors = there(thin, Channel::x, Curve::position);
    CHECK(std::abs(rms(errors) / thin.deviation[index_of(Channel::x)] - 1.0) < 0.25);
    // as much is told: the variance of the mean stays
    const auto told = [](const PreparedRun& run, std::size_t samples) {
      return static_cast<double>(samples) / std::pow(run.deviation[index_of(Channel::x)], 2);
    };
    const auto all = there(whole, Channel::x, Curve::position);
    CHECK(std::abs(told(thin, errors.size()) / told(whole, all.size()) - 1.0) < 0.6);
  }
}

TEST_CASE("a recording of nanoseconds keeps two rows", "[identification][limit]") {
  const Curve curve;
  const auto none = [](Channel, double) { return 0.0; };
  const std::array runs{curve.recorded(1e9, 6e-8, none)};
  REQUIRE(runs.front().samples() > 10);
  for (const auto& few : {thinned_runs(curve.ship, runs, seen), lean_runs(curve.ship, runs, seen)}) {
    REQUIRE(few.size() == 1);
    CHECK(few.front().run->time == std::vector{runs.front().time.front(), runs.front().time.back()});
  }
}

TEST_CASE("waves that move a ship are left out of samples, also where she meets them more and less often",
          "[identification][limit]") {
  const Curve curve;
  const double size = 1e-3;
  for (const double change : {0.0, 0.25}) {
    const auto period = [&](double t) { return 0.3 * curve.unit * (1.0 + change * std::sin(2.0 * pi * t / 700.0)); };
    std::vector<double> phase{0.0};
    for (double t = 0.0; t < 1500.0; t += 1.0) phase.push_back(phase.back() + 2.0 * pi / period(t + 0.5));
    const std::vector runs{curve.recorded(1.0, 1500.0, [&](Channel channel, double t) {
      return channel == Channel::r ? size * std::sin(phase[static_cast<std::size_t>(t)]) : 0.0;
    })};
    const auto lean = lean_runs(curve.ship, runs, seen).front();
    const auto r = there(lean, Channel::r, Curve::yaw_rate);
    CHECK(rms(r) < (change == 0.0 ? 0.02 : 0.1) * size);
    CHECK(rms(there(lean, Channel::x, Curve::position)) < 1e-6 * length(curve.ship));
    CHECK(static_cast<double>(r.size()) < 1500.0 / (0.6 * 0.3 * curve.unit));
    CHECK_THAT(WaveMotion(runs.front(), curve.unit).size_in(runs.front()[Channel::r]),
               WithinRel(size / std::sqrt(2.0), 0.05));
    CHECK(WaveMotion(runs.front(), curve.unit).size_in(runs.front()[Channel::u]) < 1e-9);
  }
}

TEST_CASE("waves too long to be left out leave samples most of a period apart, whose noise is theirs",
          "[identification][limit]") {
  const Curve curve;
  const double size = 1e-3;
  for (const double period : {0.55 * curve.unit, 0.75 * curve.unit, 0.9 * curve.unit}) {
    INFO("period over L/U " << period / curve.unit);
    const std::vector runs{curve.recorded(1.0, 1500.0, [&](Channel channel, double t) {
      return channel == Channel::r ? size * std::sin(2.0 * pi * t / period + 0.3 * std::sin(0.01 * t)) : 0.0;
    })};
    const auto lean = lean_runs(curve.ship, runs, seen).front();
    const auto r = there(lean, Channel::r, Curve::yaw_rate);
    CHECK(static_cast<double>(r.size()) < 1500.0 / (0.7 * period));
    CHECK(lean.deviation[index_of(Channel::r)] > 0.5 * size);
    CHECK(lean.deviation[index_of(Channel::r)] < 1.6 * size);
    const WaveMotion waves(runs.front(), curve.unit);
    CHECK(waves.size_in(runs.front()[Channel::r]) > 0.4 * size);
    CHECK(waves.size_in(runs.front()[Channel::r]) < 0.9 * size);
  }
}

TEST_CASE("what a smoothed gyro shows beside the motion is no sea", "[identification][limit]") {
  const Curve curve;
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<double> white(1510);
    for (double& x : white) x = 2e-5 * normal(random);
    const std::vector runs{curve.recorded(1.0, 1500.0, [&](Channel channel, double t) {
      double sum = 0.0;
      for (int k = -4; k <= 4; ++k)  // a Gaussian of 1.3 s
        sum += std::exp(-0.5 * std::pow(k / 1.3, 2)) * white[static_cast<std::size_t>(static_cast<int>(t) + 4 + k)];
      return channel == Channel::r ? sum : 0.0;
    })};
    CHECK(WaveMotion(runs.front(), curve.unit).size_in(runs.front()[Channel::r]) == 0.0);
  }
}

TEST_CASE("between the few samples of a run the rudder is that of all", "[identification][law]") {
  const auto ship = test::kvlcc2();
  const auto runs = lean_runs(ship, test::zigzags(ship, {20.0, -10.0}, 25.0, 0.02), seen);
  auto straight = runs;  // lines between the few
  for (auto& run : straight) {
    REQUIRE(run.finer_controls);
    REQUIRE(run.finer_controls->samples() > 2 * run.run->samples());
    run.finer_controls.reset();
  }
  const auto log_likelihood_of = [&](const std::vector<PreparedRun>& some) {
    const EstimationProblem problem{.unknowns = {},
                                    .precision = {},
                                    .runs = some,
                                    .ship_in = [&](const Point&, std::size_t) { return ship; },
                                    .scale = ship};
    return log_likelihood(problem, {}, Noise{});
  };
  CHECK(log_likelihood_of(runs) > log_likelihood_of(straight) + 10.0);
}

namespace {

EstimationProblem as_she_is(const Ship& ship, std::span<const PreparedRun> runs) {
  return {.unknowns = {},
          .precision = {},
          .runs = runs,
          .ship_in = [&ship](const Point&, std::size_t) { return ship; },
          .scale = ship};
}

void shake(Recording& run, Channel channel, double size, unsigned seed) {
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal(0.0, size);
  for (double& x : run.fill(channel)) x += normal(engine);
}

}  // namespace

// Samples are counted by the heading, or where it is not compared by the first channel. The likelihood went by up to 20
// with it where accelerations towards readings did not go with the state, and by 8 where the rudder stood at its mean
// all the time from one sample to the next.
TEST_CASE("the likelihood of few samples does not go by the channel by which they are counted",
          "[identification][symmetry]") {
  test::RandomModels models(47);
  for (unsigned seed = 1; seed <= 3; ++seed) {
    auto [ship, runs] = test::steerable<MmgShip<double>>(models, {20.0, -10.0}, 15.0, 0.02, 1e-8);
    const double unit = time_unit_of(ship), interval = runs.front().time[1] - runs.front().time[0];
    for (const int late : {-2, -1, 1, 2}) {  // samples, of six from one of the few to the next
      auto recorded = runs;
      for (auto& run : recorded) {
        auto& r = run.channels[index_of(Channel::r)];
        const auto was = r;
        for (int i = 0, last = static_cast<int>(r.size()) - 1; i <= last; ++i)
          r[static_cast<std::size_t>(i)] = was[static_cast<std::size_t>(std::clamp(i - late, 0, last))];
        shake(run, Channel::r, 0.001 / unit, seed);
      }
      ship.effects = {ChannelDelay<>{Channel::r, late * interval}};
      const auto counted_by = [&, &ship = ship](Channel first) {
        std::vector channels{Channel::x, Channel::y, Channel::r, Channel::u};
        std::stable_partition(channels.begin(), channels.end(), [&](Channel c) { return c == first; });
        const auto prepared = lean_runs(ship, recorded, channels);
        return log_likelihood(as_she_is(ship, prepared), Point(), Noise{});
      };
      CAPTURE(seed, late);
      CHECK_THAT(counted_by(Channel::r), WithinAbs(counted_by(Channel::x), 5.0));
    }
  }
}

TEST_CASE("a value that is rounded, and repeated on a straight course, counts once", "[identification][limit]") {
  const Curve curve;
  const double step = radians(0.5);
  auto run = curve.recorded(1.0, 300.0, [](Channel, double) { return 0.0; });
  const auto psi = run.fill(Channel::psi);
  for (std::size_t k = 0; k < psi.size(); ++k) psi[k] = step * std::round(0.3 * std::sin(run.time[k] / 40.0) / step);
  const auto prepared = prepared_runs(curve.ship, {&run, 1}, seen).front();
  CHECK(prepared.deviation[index_of(Channel::psi)] >= step / std::sqrt(12.0));
}

TEST_CASE("of a recorded heel one value in four lengths at service speed is kept, at any rate, and its size",
          "[identification][law]") {
  const Curve curve;
  const double apart = 4.0 * curve.unit;
  constexpr std::array with_heel{Channel::x, Channel::y, Channel::psi, Channel::u, Channel::r, Channel::phi};
  for (const double rate : {0.1, 1.0, 10.0}) {
    auto run = curve.recorded(rate, 600.0, [](Channel, double) { return 0.0; });
    std::ranges::fill(run.fill(Channel::phi), radians(3.0));
    for (const auto& prepared :
         {prepared_runs(curve.ship, {&run, 1}, with_heel), lean_runs(curve.ship, {&run, 1}, with_heel)}) {
      const auto& kept = *prepared.front().run;
      CHECK_THAT(prepared.front().heel, WithinAbs(radians(3.0), 1e-12));
      double last = -apart, count = 0.0;
      for (std::size_t k = 0; k < kept.samples(); ++k) {
        if (std::isnan(kept[Channel::phi][k])) continue;
        CHECK(kept.time[k] - last >= apart);
        last = kept.time[k], ++count;
      }
      INFO("at " << rate << " Hz, one in " << apart << " s");
      CHECK(count >= std::floor(600.0 / (apart + 1.0 / rate)));
    }
  }
}

}  // namespace swayaw
