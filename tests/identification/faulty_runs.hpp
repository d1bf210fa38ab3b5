#pragma once

#include <array>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "files.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/ship_file.hpp"

/// Simulated manoeuvres as instruments with faults record them; the faults are put in here, by code of their own.
namespace swayaw::test {

/// From a time on a clock is late by so much more [s].
struct Jump {
  double at, by;
};

/// Errors of instruments, 0 for none.
struct Faults {
  double gyro_zero = 0.0;   ///< [rad/s]
  double gyro_scale = 0.0;  ///< r = (1 + s) r₀
  double log_scale = 0.0;   ///< (u, v) = (1 + s) (u₀, v₀)
  double late = 0.0;        ///< of x and y [s]
  double gyro_late = 0.0;   ///< [s]
  double turned = 0.0;      ///< velocity axes to starboard [rad]
  std::vector<Jump> jumps;  ///< of the clock of x and y
};

/// Noise of good instruments on a ship of length L at speed U.
struct Noise {
  double place, heading, rate, speed;
};

/// The channel after a first-order lag, exact for straight lines between samples.
inline void lag(Recording& run, Channel channel, double T) {
  auto& values = run.channels[index_of(channel)];
  double before = values.front(), y = before;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double h = run.time[i] - run.time[i - 1], m = (values[i] - before) / h;
    // T dy/dt + y = x of a ramp of slope m:   y = x − m T + (y₀ − x₀ + m T) exp(−h/T)
    y = values[i] - m * T + (y - before + m * T) * std::exp(-h / T);
    before = std::exchange(values[i], y);
  }
}

/// The channel's mean over the last `window` seconds, of straight lines between samples.
inline void mean_of_the_last(Recording& run, Channel channel, double window) {
  const Interpolant f(run, channel);
  constexpr int parts = 200;
  for (std::size_t i = 0; i < run.samples(); ++i) {
    double sum = 0.0;
    for (int k = 0; k < parts; ++k) sum += f(run.time[i] - window * (k + 0.5) / parts);
    run.channels[index_of(channel)][i] = sum / parts;
  }
}

class FaultyRuns {
 public:
  explicit FaultyRuns(unsigned seed) : engine_(seed) {
    for (const auto* name : {"kvlcc2", "kcs", "kvlcc2_l7", "wpcc_pi", "wpcc_pu", "mariner"})
      ships_.push_back(read_ship(ships / (std::string(name) + ".toml")));
  }

  double uniform(double low, double high) { return std::uniform_real_distribution(low, high)(engine_); }
  bool one_in(int n) { return std::uniform_int_distribution(1, n)(engine_) == 1; }
  double either_sign(double low, double high) { return uniform(low, high) * (one_in(2) ? 1.0 : -1.0); }

  /// A zigzag or a turning circle of one of six ships on any course, without faults and without noise.
  Recording truth() {
    const auto& ship = ships_[std::uniform_int_distribution<std::size_t>(0, ships_.size() - 1)(engine_)];
    L_ = length(ship);
    U_ = service_speed(ship);
    const double D = radians(uniform(15.0, 30.0));
    const Side side = one_in(2) ? Side::port : Side::starboard;
    const double step = uniform(0.02, 0.08) * L_ / U_;
    Recording run =
        one_in(2) ? zigzag(ship, {.rudder = D, .heading = D, .first = side}, {.step = step}).run
                  : turning_circle(ship, {.rudder = D, .side = side}, {.duration = 25.0 * L_ / U_, .step = step}).run;
    turn(run, uniform(-pi, pi));
    run.extra.clear();
    return run;
  }

  /// What the instruments show of it, but for the first and the last third of L/U, or as long as a clock jumps: a delay
  /// is shorter.
  Recording recorded(const Recording& truth, const Faults& f) {
    auto run = truth;
    trim(run, margin(f));
    const Noise noise{1e-3 * L_, radians(0.05), radians(0.05) * U_ / L_ * 0.3, 3e-3 * U_};
    delay(run, truth, {Channel::x, Channel::y}, [&](double t) { return late(f, t); });
    delay(run, truth, {Channel::r}, [&](double) { return f.gyro_late; });
    auto &u = of(run, Channel::u), &v = of(run, Channel::v), &r = of(run, Channel::r);
    for (std::size_t i = 0; i < run.samples(); ++i) {
      const double ahead = u[i], across = v[i];
      u[i] = (1.0 + f.log_scale) * (ahead * std::cos(f.turned) + across * std::sin(f.turned));
      v[i] = (1.0 + f.log_scale) * (across * std::cos(f.turned) - ahead * std::sin(f.turned));
      r[i] = (1.0 + f.gyro_scale) * r[i] + f.gyro_zero;
    }
    spoil(run, Channel::x, noise.place);
    spoil(run, Channel::y, noise.place);
    spoil(run, Channel::psi, noise.heading);
    spoil(run, Channel::r, noise.rate);
    spoil(run, Channel::u, noise.speed);
    spoil(run, Channel::v, noise.speed);
    return run;
  }

  /// Not recorded at either end [s].
  double margin(const Faults& f) const {
    double all = 0.0;
    for (const auto& jump : f.jumps) all += std::abs(jump.by);
    return std::max(0.3 * L_ / U_, all);
  }

  double L() const { return L_; }
  double U() const { return U_; }

  static std::vector<double>& of(Recording& run, Channel channel) { return run.channels[index_of(channel)]; }

 private:
  /// The manoeuvre on another course.
  static void turn(Recording& run, double by) {
    for (std::size_t i = 0; i < run.samples(); ++i) {
      const double x = of(run, Channel::x)[i], y = of(run, Channel::y)[i];
      of(run, Channel::x)[i] = x * std::cos(by) - y * std::sin(by);
      of(run, Channel::y)[i] = x * std::sin(by) + y * std::cos(by);
      of(run, Channel::psi)[i] += by;
    }
  }

  static double late(const Faults& f, double t) {
    double seconds = f.late;
    for (const auto& jump : f.jumps)
      if (t > jump.at) seconds += jump.by;
    return seconds;
  }

  template <class Late>
  static void delay(Recording& run, const Recording& truth, std::initializer_list<Channel> channels, Late&& seconds) {
    for (const Channel c : channels) {
      const Interpolant then(truth, c);
      for (std::size_t i = 0; i < run.samples(); ++i)
        if (const double late = seconds(run.time[i]); late != 0.0) of(run, c)[i] = then(run.time[i] - late);
    }
  }

  /// Without the first and the last seconds, of which nothing is known before and after.
  static void trim(Recording& run, double seconds) {
    const auto outside = [&, first = run.time.front() + seconds, last = run.time.back() - seconds](double t) {
      return t < first || t > last;
    };
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < run.samples(); ++i)
      if (!outside(run.time[i])) kept.push_back(i);
    const auto keep = [&](std::vector<double>& values) {
      for (std::size_t k = 0; k < kept.size() && !values.empty(); ++k) values[k] = values[kept[k]];
      if (!values.empty()) values.resize(kept.size());
    };
    for (auto& values : run.channels) keep(values);
    keep(run.time);
  }

  void spoil(Recording& run, Channel channel, double deviation) {
    for (double& value : of(run, channel)) value += deviation * normal_(engine_);
  }

  std::mt19937 engine_;
  std::normal_distribution<> normal_;
  std::vector<Ship> ships_;
  double L_ = 1.0, U_ = 1.0;
};

}  // namespace swayaw::test
