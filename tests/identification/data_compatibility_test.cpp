#include "swayaw/identification/data_compatibility.hpp"

#include <algorithm>
#include <array>
#include <catch.hpp>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <random>
#include <vector>

#include "faulty_runs.hpp"
#include "swayaw/core/recording_csv.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/instruments/instruments.hpp"

namespace swayaw {
namespace {

using Kind = InstrumentErrorKind;
using test::Faults;
using test::FaultyRuns;

const InstrumentError* found(const RunCheck& check, Channel channel, Kind kind) {
  for (const auto& e : check.errors)
    if (e.channel == channel && e.kind == kind) return &e;
  return nullptr;
}

// ---------------------------------------------------------------- clean runs

TEST_CASE("good instruments show no error in 98 of 100 runs", "[identification][law]") {
  FaultyRuns runs(1);
  int invented = 0;
  for (int i = 0; i < 300; ++i) {
    const auto check = check_run(runs.recorded(runs.truth(), {}));
    const auto told = std::ranges::find_if(check.errors, &InstrumentError::told);
    if (told == check.errors.end()) continue;
    UNSCOPED_INFO(i << ": " << words_for(*told));
    ++invented;
  }
  CHECK(invented <= 6);
}

// ---------------------------------------------------------------- faults

struct Sought {
  Channel channel;
  Kind kind;
  double truth;
};

TEST_CASE("faults lie within their 95 % intervals in 90 to 99 of 100 runs", "[identification][law]") {
  FaultyRuns runs(2);
  std::map<std::string, std::pair<int, int>> inside;  // of all
  const auto perhaps = [&](double low, double high) { return runs.one_in(2) ? runs.either_sign(low, high) : 0.0; };
  for (int i = 0; i < 300; ++i) {
    const auto truth = runs.truth();
    const double T = runs.L() / runs.U();
    const Faults f{.gyro_zero = perhaps(0.01, 0.05) / T,
                   .gyro_scale = perhaps(0.01, 0.05),
                   .log_scale = perhaps(0.01, 0.05),
                   .late = perhaps(0.02, 0.2) * T,
                   .gyro_late = perhaps(0.01, 0.05) * T,
                   .turned = perhaps(radians(0.5), radians(3.0))};
    const auto check = check_run(runs.recorded(truth, f));
    for (const auto& [channel, kind, value] :
         {Sought{Channel::r, Kind::zero, f.gyro_zero}, Sought{Channel::r, Kind::scale, f.gyro_scale},
          Sought{Channel::u, Kind::scale, f.log_scale}, Sought{Channel::r, Kind::delay, f.gyro_late},
          Sought{Channel::u, Kind::axes, f.turned}, Sought{Channel::x, Kind::delay, f.late}}) {
      const auto* e = found(check, channel, kind);
      if (!e) continue;
      auto& [in, all] = inside[std::string(short_name(channel)) + " " + std::string(name_of(kind))];
      ++all;
      in += std::abs(e->value - value) < 1.96 * e->standard_error;
    }
  }
  CHECK(inside.size() == 6);
  for (const auto& [name, counts] : inside) {
    INFO(name << " " << counts.first << " of " << counts.second);
    CHECK(counts.second >= 100);
    CHECK(counts.first >= 0.90 * counts.second);
  }
}

// A log on a straight course and the track beside it tell turned axes by different laws; they said different sides.
TEST_CASE("drift on straight courses shows axes turned to the side to which the instrument turns them",
          "[identification][second-route]") {
  std::mt19937_64 engine(5);
  std::normal_distribution<double> normal;
  for (const double eps : {radians(2.0), radians(-3.0)}) {
    Recording run;
    for (int i = 0; i < 400; ++i) run.time.push_back(i);
    for (const auto channel : {Channel::psi, Channel::u, Channel::v, Channel::r, Channel::delta}) run.fill(channel);
    for (std::size_t i = 0; i < run.samples(); ++i) {
      const auto of = [&](Channel c) -> double& { return run.channels[index_of(c)][i]; };
      of(Channel::psi) = 0.7 + 0.01 * std::sin(0.05 * run.time[i]),
      of(Channel::r) = 5e-4 * std::cos(0.05 * run.time[i]);
      of(Channel::u) = 5.0 + 0.01 * normal(engine), of(Channel::v) = 0.01 * normal(engine), of(Channel::delta) = 0.0;
    }
    Instruments<double> askew;
    askew.velocity_axes = eps;
    const auto check = check_run(as_recorded(run, askew));
    const auto found = std::ranges::find_if(
        check.errors, [](const InstrumentError& e) { return e.kind == Kind::axes && e.channel == Channel::v; });
    REQUIRE(found != check.errors.end());
    CHECK(std::abs(found->value - eps) < 3.0 * found->standard_error);
    CHECK(std::abs(found->value - eps) < radians(0.5));
  }
}

// ---------------------------------------------------------------- clocks

/// None, one or two jumps of a second to 20 s (on models to half of L/U), apart from each other and from the ends.
std::vector<test::Jump> some_jumps(FaultyRuns& runs, const Recording& truth) {
  const double most = std::min(20.0, 0.5 * runs.L() / runs.U()), T = truth.time.back() - truth.time.front();
  std::vector<test::Jump> jumps;
  const int n = runs.one_in(3) ? 0 : runs.one_in(2) ? 1 : 2;
  for (int j = 0; j < n; ++j) {
    const double middle = n == 1 ? 0.5 : j == 0 ? 0.35 : 0.65;
    jumps.push_back({truth.time.front() + T * (middle + runs.uniform(-0.1, 0.1)), runs.either_sign(1.0, most)});
  }
  return jumps;
}

TEST_CASE("jumps of a clock are found where and as large as they are, and none is invented", "[identification][law]") {
  FaultyRuns runs(8);
  int jumps = 0, found_jumps = 0, size_inside = 0, time_inside = 0, invented = 0, left = 0, runs_with = 0;
  for (int i = 0; i < 120; ++i) {
    const auto truth = runs.truth();
    Faults f{.log_scale = runs.one_in(2) ? runs.either_sign(0.01, 0.03) : 0.0,
             .late = runs.one_in(2) ? runs.either_sign(0.02, 0.1) * runs.L() / runs.U() : 0.0,
             .jumps = some_jumps(runs, truth)};
    const auto run = runs.recorded(truth, f);
    const auto check = check_run(run);
    std::size_t told = 0;
    for (const auto& e : check.errors) told += e.kind == Kind::jump && e.told;
    invented += told > f.jumps.size();
    for (const auto& jump : f.jumps) {
      const InstrumentError* nearest = nullptr;
      for (const auto& e : check.errors)
        if (e.kind == Kind::jump && (!nearest || std::abs(e.at - jump.at) < std::abs(nearest->at - jump.at)))
          nearest = &e;
      ++jumps;
      const bool seen = nearest && nearest->told && std::abs(nearest->at - jump.at) < 0.1 * runs.L() / runs.U();
      found_jumps += seen;
      if (!seen) {
        UNSCOPED_INFO(i << " not found: " << jump.by << " s at " << jump.at << " of " << f.jumps.size());
        continue;
      }
      size_inside += std::abs(nearest->value - jump.by) < 1.96 * nearest->standard_error;
      time_inside += std::abs(nearest->at - jump.at) < 1.96 * nearest->at_standard_error;
    }
    if (f.jumps.empty()) continue;
    ++runs_with;
    const auto again = check_run(repaired(run, check));
    left += std::ranges::any_of(again.errors, [](const auto& e) { return e.kind == Kind::jump && e.told; });
  }
  CAPTURE(jumps, found_jumps, size_inside, time_inside, invented, runs_with, left);
  CHECK(jumps > 100);
  CHECK(found_jumps >= 0.98 * jumps);
  CHECK(size_inside >= 0.90 * found_jumps);
  CHECK(time_inside >= 0.90 * found_jumps);
  CHECK(invented <= 2);
  CHECK(left <= 0.02 * runs_with);
}

TEST_CASE("jumps of a clock are found without sway, too, known to the drift of the ship", "[identification][law]") {
  FaultyRuns runs(11);
  int jumps = 0, told = 0, inside = 0;
  for (int i = 0; i < 40; ++i) {
    const auto truth = runs.truth();
    const Faults f{.jumps = some_jumps(runs, truth)};
    auto run = runs.recorded(truth, f);
    FaultyRuns::of(run, Channel::v).clear();
    const auto check = check_run(run);
    std::size_t k = 0;
    for (const auto& e : check.errors) {
      if (e.kind != Kind::jump || !e.told) continue;
      ++told;
      REQUIRE(k < f.jumps.size());  // none is invented
      while (k + 1 < f.jumps.size() && std::abs(e.at - f.jumps[k + 1].at) < std::abs(e.at - f.jumps[k].at)) ++k;
      inside += std::abs(e.value - f.jumps[k++].by) < 1.96 * e.standard_error;
    }
    jumps += static_cast<int>(f.jumps.size());
  }
  CAPTURE(jumps, told, inside);
  CHECK(jumps > 30);
  CHECK(told >= 0.95 * jumps);
  CHECK(inside >= 0.9 * told);
}

bool may_be(const InstrumentError& e, std::string_view reading) { return std::ranges::count(e.readings, reading) > 0; }

TEST_CASE("a filter of the yaw rate is late by its mean delay, and its kind is among those that are said",
          "[identification][law]") {
  struct Filter {
    std::string_view name;
    double share;  ///< of the window's variance in the square of the delay
    std::function<void(Recording&, Faults&, double)> put_on;
  };
  const std::array filters{
      Filter{"delay", 0.0, [](Recording&, Faults& f, double tau) { f.gyro_late = tau; }},
      Filter{"one-sided mean", 1.0 / 3.0,
             [](Recording& run, Faults&, double tau) { test::mean_of_the_last(run, Channel::r, 2.0 * tau); }},
      Filter{"first-order lag", 1.0, [](Recording& run, Faults&, double tau) { test::lag(run, Channel::r, tau); }}};
  for (const auto& filter : filters) {
    FaultyRuns runs(20);
    int inside = 0, said = 0, excluded = 0;
    for (int i = 0; i < 60; ++i) {
      auto truth = runs.truth();
      Faults f;
      const double tau = runs.uniform(0.02, 0.06) * runs.L() / runs.U();
      filter.put_on(truth, f, tau);
      const auto check = check_run(runs.recorded(truth, f));
      const auto* delay = found(check, Channel::r, Kind::delay);
      REQUIRE(delay);
      inside += std::abs(delay->value - tau) < 1.96 * delay->standard_error;
      said += may_be(*delay, filter.name);
      excluded += delay->readings.size() < 3;
      if (const auto* window = found(check, Channel::r, Kind::smoothing); window && window->told)
        CHECK(std::abs(window->value - std::sqrt(filter.share) * tau) < 4.0 * window->standard_error);
    }
    CAPTURE(filter.name, inside, said, excluded);
    CHECK(inside >= 54);
    CHECK(said >= 57);
  }
}

// What the effects of a ship file do to her instruments, by kinematics alone.
TEST_CASE("a clock and a filter of a ship file are told from the run that was simulated with them",
          "[identification][second-route]") {
  auto ship = read_ship(test::ships / "kvlcc2_l7.toml");
  constexpr double rate = 0.004, jump = 60.0, later = 3.0, lag = 0.5;
  ship.effects = {ClockDrift<>{.channel = Channel::x, .rate = rate},
                  ClockDrift<>{.channel = Channel::x, .at = jump, .by = later},
                  ChannelFilter<>{.channel = Channel::r, .time = lag}};
  const auto check = check_run(zigzag(ship, {.rudder = radians(20), .heading = radians(20)}, {.step = 0.1}).run);
  const auto told = [&](Channel channel, Kind kind) {
    const auto* error = found(check, channel, kind);
    REQUIRE(error);
    CHECK(error->told);
    return *error;
  };
  CHECK(std::abs(told(Channel::x, Kind::clock_rate).value - rate) < 0.01 * rate);
  const auto leap = told(Channel::x, Kind::jump);
  CHECK(std::abs(leap.value - later) < 0.01 * later);
  CHECK(std::abs(leap.at - jump) < 0.2);
  const auto late = told(Channel::r, Kind::delay);
  CHECK(std::abs(late.value - lag) < 0.01 * lag);
  CHECK(std::ranges::count(late.readings, "first-order lag") == 1);
  CHECK(std::abs(told(Channel::r, Kind::smoothing).value - lag) < 0.05 * lag);
}

TEST_CASE("a lag of the velocities is said to be one, or to look like what was told", "[identification][law]") {
  FaultyRuns runs(21);
  int told = 0, said = 0;
  for (int i = 0; i < 100; ++i) {
    auto truth = runs.truth();
    const double tau = runs.uniform(0.02, 0.06) * runs.L() / runs.U();
    for (const Channel c : {Channel::u, Channel::v}) test::lag(truth, c, tau);
    const auto check = check_run(runs.recorded(truth, {}));
    for (const auto& e : check.errors) {
      if (!e.told || e.kind != Kind::delay || e.channel == Channel::r) continue;
      ++told;
      said += may_be(e, "velocities late or filtered");
    }
  }
  CAPTURE(told, said);
  CHECK(told >= 25);
  CHECK(said >= 0.9 * told);
}

// ---------------------------------------------------------------- mistakes

void scale(Recording& run, const std::vector<Channel>& channels, double factor) {
  for (const Channel c : channels)
    for (double& value : run.channels[index_of(c)]) value *= factor;
}

TEST_CASE("a mistake of the user is the one that is told, and nothing is told of a run without one",
          "[identification][law]") {
  struct Mistake {
    Channel channel;
    Kind kind;
    std::vector<Channel> channels;
    double factor;
  };
  const double knot = 1852.0 / 3600.0;
  const std::vector<Mistake> mistakes{
      Mistake{Channel::delta, Kind::sign, {Channel::delta}, -1.0},
      Mistake{Channel::delta, Kind::unit, {Channel::delta}, degrees(1.0)},
      Mistake{Channel::delta, Kind::unit, {Channel::delta}, radians(1.0)},
      Mistake{Channel::r, Kind::unit, {Channel::r}, degrees(1.0)},
      Mistake{Channel::r, Kind::unit, {Channel::r}, 60.0 * degrees(1.0)},
      Mistake{Channel::r, Kind::sign, {Channel::r}, -1.0},
      Mistake{Channel::psi, Kind::unit, {Channel::psi}, degrees(1.0)},
      Mistake{Channel::u, Kind::unit, {Channel::u, Channel::v}, 1.0 / knot},
      Mistake{Channel::u, Kind::unit, {Channel::u, Channel::v}, knot},
      Mistake{Channel::y, Kind::sign, {Channel::y}, -1.0},
      Mistake{Channel::v, Kind::sign, {Channel::v}, -1.0},
  };
  FaultyRuns runs(3);
  for (int i = 0; i < 20; ++i) {
    const auto run = runs.recorded(runs.truth(), {});
    CHECK(check_run(run).mistake() == nullptr);
    for (const auto& m : mistakes) {
      auto wrong = run;
      scale(wrong, m.channels, m.factor);
      const auto check = check_run(wrong);
      INFO(i << " " << short_name(m.channel) << " " << name_of(m.kind) << " " << m.factor);
      REQUIRE(check.mistake());
      CHECK(short_name(check.mistake()->channel) == short_name(m.channel));
      CHECK(name_of(check.mistake()->kind) == name_of(m.kind));
      if (m.kind == Kind::unit) CHECK(std::abs(check.mistake()->value / m.factor - 1.0) < 1e-9);
      CHECK(!remedy_for(*check.mistake()).empty());
    }
  }
}

TEST_CASE("an order that is called an angle is told, a rudder that moves is not", "[identification][law]") {
  FaultyRuns runs(4);
  for (int i = 0; i < 20; ++i) {
    auto run = runs.recorded(runs.truth(), {});
    CHECK(!found(check_run(run), Channel::delta, Kind::order));
    if (run.has(Channel::delta_order)) {
      run.channels[index_of(Channel::delta)] = run.channels[index_of(Channel::delta_order)];
      const auto [low, high] = std::ranges::minmax(run[Channel::delta]);
      if (high > low) CHECK(found(check_run(run), Channel::delta, Kind::order));
    }
  }
}

// ---------------------------------------------------------------- repair

TEST_CASE("a repaired run shows the errors no more that were repaired", "[identification][round-trip]") {
  FaultyRuns runs(5);
  int left = 0;
  for (int i = 0; i < 50; ++i) {
    const auto truth = runs.truth();
    const double T = runs.L() / runs.U();
    const auto run =
        runs.recorded(truth, {.gyro_zero = 0.03 / T, .gyro_scale = 0.04, .log_scale = -0.03, .late = 0.1 * T});
    const auto again = check_run(repaired(run, check_run(run)));
    for (const auto& e : again.errors) left += e.told && (e.kind == Kind::zero || e.kind == Kind::scale);
  }
  CHECK(left <= 3);  // of 150
}

/// A check that told one error.
RunCheck told(Channel channel, Kind kind, double value, double at = 0.0) {
  return {.errors = {{channel, kind, value, 0.01 * std::abs(value), true, at}}};
}

TEST_CASE("a repaired clock shows what was true at each time, and nothing where nothing was measured",
          "[identification][round-trip]") {
  FaultyRuns runs(12);
  for (int i = 0; i < 20; ++i) {
    const auto truth = runs.truth();
    const double middle = 0.5 * (truth.time.front() + truth.time.back());
    // fixes joined by straight lines twice: by the test and by the repair
    const double sharp = 2.0 * runs.U() * runs.U() / runs.L(), step = truth.time[1] - truth.time[0];
    for (const auto& check : {told(Channel::x, Kind::delay, runs.either_sign(0.1, 1.0) * runs.L() / runs.U()),
                              told(Channel::x, Kind::jump, runs.either_sign(0.1, 1.0) * runs.L() / runs.U(), middle)}) {
      const auto& e = check.errors[0];
      auto late = truth;
      for (const Channel c : {Channel::x, Channel::y}) {
        const Interpolant then(truth, c);
        for (std::size_t k = 0; k < late.samples(); ++k) {
          const double at = late.time[k] - (e.kind == Kind::delay || late.time[k] > e.at ? e.value : 0.0);
          const bool known = at >= truth.time.front() && at <= truth.time.back();
          FaultyRuns::of(late, c)[k] = known ? then(at) : missing;
        }
      }
      const auto again = repaired(late, check);
      std::size_t there = 0;
      for (std::size_t k = 0; k < truth.samples(); ++k) {
        if (std::isnan(again[Channel::x][k])) continue;
        ++there;
        // what the clock leapt over is one straight line, if it is short
        const bool leapt = e.kind == Kind::jump && truth.time[k] > e.at - step && truth.time[k] < e.at - e.value + step;
        const double bend = sharp * std::pow(leapt ? std::abs(e.value) + step : step, 2);
        CHECK(std::abs(again[Channel::x][k] - truth[Channel::x][k]) < bend);
        CHECK(std::abs(again[Channel::y][k] - truth[Channel::y][k]) < bend);
      }
      CHECK(there < truth.samples());
      CHECK(there > truth.samples() / 2);
    }
  }
}

TEST_CASE("an antenna is taken off the positions; velocities over ground that it was told by stay",
          "[identification][round-trip]") {
  FaultyRuns runs(13);
  const auto truth = runs.truth();
  const double l = 0.3 * runs.L();
  auto recorded = truth;
  for (std::size_t i = 0; i < truth.samples(); ++i) {
    FaultyRuns::of(recorded, Channel::x)[i] += l * std::cos(truth[Channel::psi][i]);
    FaultyRuns::of(recorded, Channel::y)[i] += l * std::sin(truth[Channel::psi][i]);
  }
  auto with_ground = recorded;
  for (const auto& [ground, water] :
       {std::pair(Channel::u_ground, Channel::u), std::pair(Channel::v_ground, Channel::v)})
    with_ground.channels[index_of(ground)] = truth.channels[index_of(water)];
  const auto again = repaired(with_ground, told(Channel::x, Kind::lever_arm_x, l));
  for (std::size_t i = 0; i < truth.samples(); ++i) {
    CHECK(std::abs(again[Channel::x][i] - truth[Channel::x][i]) < 1e-9 * runs.L() * 100.0);
    CHECK(std::abs(again[Channel::y][i] - truth[Channel::y][i]) < 1e-9 * runs.L() * 100.0);
    CHECK(again[Channel::u_ground][i] == truth[Channel::u][i]);
    CHECK(again[Channel::v_ground][i] == truth[Channel::v][i]);
  }
}

// ---------------------------------------------------------------- samples

TEST_CASE("rounding, fixes joined by straight lines, and an outlier are seen", "[identification][law]") {
  Recording run;
  for (int i = 0; i < 600; ++i) run.time.push_back(0.1 * i);
  const auto x = run.fill(Channel::x), psi = run.fill(Channel::psi), delta = run.fill(Channel::delta);
  const auto fix = [](int second) { return 5.0 * second + 20.0 * std::sin(0.1 * second); };
  for (int i = 0; i < 600; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double share = 0.1 * (i % 10);
    x[at] = (1.0 - share) * fix(i / 10) + share * fix(i / 10 + 1);
    psi[at] = radians(0.5 * std::round(degrees(std::sin(0.02 * i)) / 0.5));
    delta[at] = 0.1 * std::sin(0.1 * i);
  }
  delta[333] += 0.5;
  const auto check = check_run(run);
  const auto of = [&](Channel c) { return *std::ranges::find(check.channels, c, &ChannelCharacter::channel); };
  CHECK(of(Channel::x).interpolated);
  CHECK(std::abs(of(Channel::x).interval - 1.0) < 0.1);
  CHECK(std::abs(of(Channel::psi).step - radians(0.5)) < 1e-9);
  CHECK_FALSE(of(Channel::psi).interpolated);
  CHECK(of(Channel::delta).outliers == std::vector<std::size_t>{333});
}

TEST_CASE("the samples that were measured are the fixes, and none that is missing or an outlier",
          "[identification][law]") {
  std::mt19937 engine(7);
  std::normal_distribution<> noise(0.0, 0.2);
  for (int k = 0; k < 20; ++k) {
    const std::size_t every = std::uniform_int_distribution<std::size_t>(2, 20)(engine), n = 60 * every + 1;
    Recording run;
    for (std::size_t i = 0; i < n; ++i) run.time.push_back(0.1 * static_cast<double>(i));
    const auto x = run.fill(Channel::x), y = run.fill(Channel::y);
    std::vector<double> fix;
    for (std::size_t j = 0; j <= 61; ++j) fix.push_back(5.0 * static_cast<double>(j) + noise(engine));
    fix[20] += 20.0;  // a wrong one
    std::vector<std::size_t> fixes, samples;
    for (std::size_t i = 0; i < n; ++i) {
      const double share = static_cast<double>(i % every) / static_cast<double>(every);
      x[i] = (1.0 - share) * fix[i / every] + share * fix[i / every + 1];
      y[i] = run.time[i] + noise(engine);
      if (i % every == 0 && i != 20 * every) fixes.push_back(i);
      samples.push_back(i);
    }
    INFO("fixes every " << every << " samples");
    CHECK(measured_samples_of(run, Channel::x) == fixes);
    CHECK(measured_samples_of(run, Channel::y) == samples);
    CHECK(measured_samples_of(run, Channel::psi).empty());
    // a sample between two fixes and one of the noisy channel are far off, and one is missing
    x[30 * every + every / 2] += 20.0;
    y[40 * every] += 20.0;
    y[17] = missing;
    std::erase(fixes, 30 * every + every / 2);
    std::erase(samples, 40 * every);
    std::erase(samples, 17U);
    CHECK(measured_samples_of(run, Channel::x) == fixes);
    CHECK(measured_samples_of(run, Channel::y) == samples);
  }
}

// A logger writes positions at times of its own, between fixes: a wrong one shows in two samples.
TEST_CASE("a wrong fix between two samples is an outlier in both, and a jump is none", "[identification][law]") {
  std::mt19937 engine(8);
  std::normal_distribution<> noise(0.0, 0.05);
  std::uniform_real_distribution<> uniform;
  for (int k = 0; k < 20; ++k) {
    const double shift = 0.2 + 0.6 * uniform(engine), wrong = uniform(engine) < 0.5 ? 25.0 : -25.0;
    std::vector<double> fix;
    for (int j = 0; j <= 301; ++j) fix.push_back(8.0 * j + 100.0 * std::sin(0.02 * j) + noise(engine));
    fix[120] += wrong;
    for (std::size_t j = 200; j < fix.size(); ++j) fix[j] += wrong;  // from here on elsewhere
    Recording run;
    const auto at = [&](std::size_t i) { return (1.0 - shift) * fix[i] + shift * fix[i + 1]; };
    for (std::size_t i = 0; i < 300; ++i) run.time.push_back(static_cast<double>(i));
    const auto x = run.fill(Channel::x), u = run.fill(Channel::u);
    for (std::size_t i = 0; i < 300; ++i) x[i] = at(i), u[i] = 8.0;
    INFO("fixes " << shift << " s after the samples");
    const auto clean = without_outliers(run);
    for (std::size_t i = 0; i < 300; ++i) CHECK(std::isnan(clean[Channel::x][i]) == (i == 119 || i == 120));
    CHECK(std::ranges::equal(clean[Channel::u], run[Channel::u]));
  }
}

// Tenths of a degree are no round numbers in radians of six decimals.
TEST_CASE("rounding is seen behind that of the file, and steps of what is rounded are no outliers",
          "[identification][law]") {
  Recording run;
  for (int i = 0; i < 900; ++i) run.time.push_back(0.5 * i);
  const auto psi = run.fill(Channel::psi), delta = run.fill(Channel::delta);
  for (std::size_t i = 0; i < 900; ++i) {
    const double t = run.time[i];
    const auto written = [](double degrees) {
      return 1e-6 * std::round(1e6 * radians(0.1 * std::round(10.0 * degrees)));
    };
    psi[i] = written(-60.0 - 0.9 * t - 3.0 * std::sin(0.05 * t));
    delta[i] = written(std::fmod(t, 90.0) < 10.0 ? 35.0 + 0.3 * std::sin(40.0 * t) : 35.0);  // held, and moved at times
  }
  const auto check = check_run(run);
  for (const auto channel : {Channel::psi, Channel::delta}) {
    const auto c = *std::ranges::find(check.channels, channel, &ChannelCharacter::channel);
    INFO(short_name(channel));
    CHECK(std::abs(c.step - radians(0.1)) < 1e-3 * radians(0.1));
    CHECK(c.outliers.empty());
  }
}

// ---------------------------------------------------------------- channels that were not measured

/// ug, vg of positions by central differences, in the axes of the heading.
void make_ground_velocity_of_positions(Recording& run) {
  const auto u = run.fill(Channel::u_ground), v = run.fill(Channel::v_ground);
  const auto x = run[Channel::x], y = run[Channel::y], psi = run[Channel::psi];
  for (std::size_t i = 1; i + 1 < run.samples(); ++i) {
    const double h = run.time[i + 1] - run.time[i - 1], V_x = (x[i + 1] - x[i - 1]) / h,
                 V_y = (y[i + 1] - y[i - 1]) / h;
    u[i] = V_x * std::cos(psi[i]) + V_y * std::sin(psi[i]);
    v[i] = V_y * std::cos(psi[i]) - V_x * std::sin(psi[i]);
  }
}

TEST_CASE("sway that was made of something else is named, measured sway is not", "[identification][law]") {
  FaultyRuns runs(9);
  for (int i = 0; i < 40; ++i) {
    const auto run = runs.recorded(runs.truth(), {});
    CHECK(check_run(run).derived.empty());
    auto zero = run, of_yaw_rate = run, of_positions = run;
    for (double& v : zero.fill(Channel::v)) v = 0.0;
    const double lever = runs.either_sign(0.1, 0.6) * runs.L();
    for (std::size_t k = 0; k < run.samples(); ++k)
      FaultyRuns::of(of_yaw_rate, Channel::v)[k] = lever * run[Channel::r][k];
    make_ground_velocity_of_positions(of_positions);
    const auto made_of = [](const Recording& r) {
      const auto derived = check_run(r).derived;
      return derived.empty() ? "" : std::string(short_name(derived[0].channel)) + " of " + derived[0].made_of;
    };
    CHECK(made_of(zero) == "v of a constant, 0 m/s");
    CHECK(made_of(of_yaw_rate) == "v of the yaw rate");
    CHECK(made_of(of_positions) == "vg of the slope of the positions");
    // and nothing is told by what was made up
    const auto check = check_run(zero);
    CHECK_FALSE(found(check, Channel::x, Kind::delay));
    CHECK_FALSE(found(check, Channel::x, Kind::lever_arm_x));
  }
}

// ---------------------------------------------------------------- groups of runs

TEST_CASE("runs are pooled by group, else by the day, else all together", "[identification][law]") {
  FaultyRuns runs(10);
  std::vector<RunCheck> checks;
  const auto add = [&](const char* name, std::vector<RunRemark> keys, double zero) {
    auto run = runs.recorded(runs.truth(), {.gyro_zero = zero});
    run.name = name;
    run.facts.remarks = std::move(keys);
    checks.push_back(check_run(run));
  };
  const double zero = radians(0.1);
  add("a", {{"start_utc", "\"2022-10-27T09:30:00Z\""}}, zero);
  add("b", {{"start_utc", "2022-10-27T22:00:00Z"}}, zero);
  add("c", {{"start_utc", "\"2022-10-28T01:00:00Z\""}}, -zero);
  add("d", {{"group", "\"ballast\""}, {"start_utc", "\"2022-10-28T02:00:00Z\""}}, 0.0);
  add("e", {}, 0.0);
  const auto groups = grouped(checks);
  REQUIRE(groups.size() == 4);
  CHECK(groups[0].group == "2022-10-27");
  CHECK(groups[0].runs == std::vector<std::string>{"a", "b"});
  CHECK(groups[1].group == "2022-10-28");
  CHECK(groups[2].group == "ballast");
  CHECK(groups[3].group.empty());
  for (const std::size_t g : {0U, 1U}) {
    const auto e = std::ranges::find_if(groups[g].errors,
                                        [](const auto& x) { return x.channel == Channel::r && x.kind == Kind::zero; });
    REQUIRE(e != groups[g].errors.end());
    CHECK(e->told);
    CHECK(std::abs(e->value - (g == 0 ? zero : -zero)) < 0.2 * zero);
  }
}

// ---------------------------------------------------------------- runs of one log

Recording part_of(const Recording& run, std::size_t first, std::size_t last) {
  auto part = run;
  const auto cut = [&](std::vector<double>& values) {
    if (!values.empty()) values = {values.begin() + static_cast<long>(first), values.begin() + static_cast<long>(last)};
  };
  cut(part.time);
  for (auto& values : part.channels) cut(values);
  return part;
}

TEST_CASE("runs cut from one log are joined, others are not", "[identification][round-trip]") {
  FaultyRuns runs(6);
  auto log = runs.recorded(runs.truth(), {});
  log.facts = {};
  const std::size_t n = log.samples();
  std::vector cuts{part_of(log, 0, n / 2), part_of(log, n / 3, n)};
  const auto whole = joined(cuts);
  REQUIRE(whole);
  CHECK((recording_text(*whole) == recording_text(log)));
  CHECK_FALSE(
      joined(std::vector{part_of(log, 0, n / 2), part_of(log, n / 2, n)}));  // nothing shows that it is one clock
  cuts[1].channels[index_of(Channel::psi)][0] += 1e-6;
  CHECK_FALSE(joined(cuts));
}

// ---------------------------------------------------------------- real recordings

/// Mean and standard error of one error over the runs of a folder whose names begin alike.
std::optional<InstrumentError> pooled_error(const std::filesystem::path& folder, std::string_view begin,
                                            Channel channel, Kind kind) {
  std::vector<RunCheck> checks;
  for (const auto& file : std::filesystem::directory_iterator(folder))
    if (file.path().extension() == ".csv" && file.path().filename().string().starts_with(begin))
      checks.push_back(check_run(read_recording(file.path()).recording));
  const auto all = pooled(checks);
  for (const auto& e : all)
    if (e.channel == channel && e.kind == kind) return e;
  return {};
}

TEST_CASE("recordings of the basins have the errors that are known of them", "[identification][published]") {
  const auto kvlcc2 = test::benchmark_recordings("kvlcc2"), osaka = test::benchmark_recordings("esso_osaka"),
             gunnerus = test::benchmark_recordings("gunnerus");
  if (!kvlcc2 || !osaka || !gunnerus) return;
  // MARIN: the yaw rate beside the slope of the heading shows 0.031 and 0.035 deg/s
  const auto zero = pooled_error(*kvlcc2, "marin", Channel::r, Kind::zero);
  REQUIRE(zero);
  CHECK(std::abs(degrees(zero->value) - 0.033) < 0.003);
  // HSVA: the yaw rate is made of a heading smoothed over 0.45 s
  const auto smoothing = pooled_error(*kvlcc2, "hsva", Channel::r, Kind::smoothing);
  REQUIRE(smoothing);
  CHECK(std::abs(smoothing->value - 0.45) < 0.01);
  // Osaka: positions early by 0.7 to 1.0 s, the gyro's scale -1.5 % in turns
  const auto early = pooled_error(*osaka, "turn", Channel::x, Kind::delay);
  REQUIRE(early);
  CHECK(early->value > -1.0);
  CHECK(early->value < -0.7);
  const auto scale = pooled_error(*osaka, "turn", Channel::r, Kind::scale);
  REQUIRE(scale);
  CHECK(std::abs(scale->value + 0.015) < 0.003);
  // Gunnerus: on every straight course 1.5 to 3.4 deg of drift to starboard, as axes turned to port show it
  const auto turned = pooled_error(*gunnerus, "", Channel::v_ground, Kind::axes);
  REQUIRE(turned);
  CHECK(degrees(turned->value) < -1.5);
  CHECK(degrees(turned->value) > -2.5);
  // and her speed columns show 0.980 of the way made good over half a day
  std::vector<Recording> runs;
  for (const auto& file : std::filesystem::directory_iterator(*gunnerus))
    if (file.path().extension() == ".csv") runs.push_back(read_recording(file.path()).recording);
  const auto log = joined(runs);
  REQUIRE(log);
  const auto check = check_run(*log);
  const auto* speed = found(check, Channel::u_ground, Kind::scale);
  REQUIRE(speed);
  CHECK(std::abs(1.0 + speed->value - 0.980) < 0.005);
  // of which the runs one by one, on a clock that runs slow between its leaps, tell little
  const auto alone = pooled_error(*gunnerus, "", Channel::u_ground, Kind::scale);
  REQUIRE(alone);
  CHECK(std::abs(1.0 + alone->value - 0.980) < 2.0 * alone->standard_error);
}

TEST_CASE("the jumps of the clock of R/V Gunnerus's positions are found to the second", "[identification][published]") {
  const auto gunnerus = test::benchmark_recordings("gunnerus");
  if (!gunnerus) return;
  struct Known {
    const char* run;
    double from, to;  ///< [s]
    double way;       ///< leapt over [m], forward
  };
  // the source's notes: jumps of 360 and 270 m at 2,698-2,700 s and at 4,213-4,214 s
  for (const auto& [name, from, to, way] :
       {Known{"2550_zigzag_5_10.csv", 2698.0, 2700.0, 360.0}, Known{"4150_zigzag_20_20.csv", 4213.0, 4214.0, 270.0}}) {
    const auto run = read_recording(*gunnerus / name).recording;
    double leapt = 0.0;
    const auto check = check_run(run);
    for (const auto& e : check.errors) {
      if (e.kind != Kind::jump || !e.told) continue;
      INFO(words_for(e));
      CHECK(e.at > from - 0.5);
      CHECK(e.at < to + 0.5);
      leapt -= e.value * Interpolant(run, Channel::u_ground)(e.at);
    }
    CHECK(std::abs(leapt / way - 1.0) < 0.1);
  }
}

TEST_CASE("a run that hardly turns tells nothing of the scale of a gyro", "[identification][published]") {
  const auto gunnerus = test::benchmark_recordings("gunnerus");
  if (!gunnerus) return;
  for (const auto* name : {"0100_speed_run.csv", "0800_speed_run.csv"}) {
    const auto check = check_run(read_recording(*gunnerus / name).recording);
    INFO(name);
    CHECK_FALSE(found(check, Channel::r, Kind::scale));
    CHECK(std::ranges::count(check.cannot_tell, "no turn that begins or ends: scale of a gyro") == 1);
  }
  const auto check = check_run(read_recording(*gunnerus / "3250_zigzag_10_20.csv").recording);
  CHECK(found(check, Channel::r, Kind::scale));
}

// ---------------------------------------------------------------- refusals

TEST_CASE("too few samples are refused in words", "[identification][refusal]") {
  Recording run{.name = "short.csv"};
  run.time = {0.0, 1.0, 2.0};
  CHECK_THROWS_WITH(check_run(run), "short.csv: 3 samples are too few to check instruments by; 20 are needed");
}

}  // namespace
}  // namespace swayaw
