#pragma once

#include <fmt/format.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "random_ships.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/side.hpp"
#include "swayaw/nonlinear/simulator.hpp"

/// Days at sea: a ship under an autopilot that sails manoeuvres now and then, and what her instruments show of it.
namespace swayaw::test {

/// A manoeuvre that was sailed.
struct Sailed {
  std::string name;
  double execute;  ///< [s]
  Side side;
};

/// How instruments and helmsman fall short.
struct TrialFaults {
  double rudder_noise = radians(0.3);     ///< [rad]
  double rudder_rounding = radians(0.5);  ///< [rad]; 0 for none
  double heading_noise = radians(0.1);    ///< [rad]
  double correction = radians(0.7);       ///< of the helmsman in a hold, to either side [rad]
  double missing_share = 0.05;            ///< of the samples
  double helm_noise = radians(1.0);       ///< of the autopilot in waves [rad]
  double helm_steps = 0.0;                ///< a hand steers by rudder angles so far apart [rad]; 0 for an autopilot
  double rudder_zero = 0.0;               ///< shown minus true [rad]
};

/// A voyage, sample by sample. Angles of rudders in the orders below are positive to starboard.
class TrialLog {
 public:
  TrialLog(const Ship& ship, double length, double speed, unsigned seed, const TrialFaults& faults = {})
      : ship_(ship),
        unit_(length / speed),
        step_(std::max(0.1, std::round(unit_ / 4.0) / 10.0)),
        faults_(faults),
        random_(seed) {
    run_.name = "trial.csv";
  }

  double step() const { return step_; }

  /// Within which the time of an order can be told: a sample, or two where the next may be missing [s].
  double moment() const { return (faults_.missing_share > 0.0 ? 2.0 : 1.0) * step_; }

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

  /// On the course under the autopilot, for so long, or longer until she sails straight.
  void steam(double duration) {
    const double until = ship_.time() + duration;
    int steady = 0;
    while (ship_.time() < until || steady < 30) {
      steer();
      steady = std::abs(turning()) < 0.01 / unit_ && std::abs(off_course()) < radians(1.0) ? steady + 1 : 0;
      if (ship_.time() > until + 200.0 * unit_) {
        keeps_course_ = false;
        break;
      }
    }
  }

  void change_course(double by) { course_ += by; }

  void zigzag(int rudder_deg, int heading_deg, Side side, int reversals) {
    begin(fmt::format("zigzag {}/{}", rudder_deg, heading_deg), side);
    double sign = yaw_sign(side);
    const double base = ship_.state().psi;
    for (int k = 0; k <= reversals; ++k, sign = -sign)
      hold(
          sign * radians(rudder_deg), 200.0 * unit_,
          [&, sign] { return sign * (ship_.state().psi - base) >= radians(heading_deg); }, true);
    course_ = ship_.state().psi;
  }

  void turn(int rudder_deg, Side side, double by) {
    begin(fmt::format("turn {}", rudder_deg), side);
    const double base = ship_.state().psi, sign = yaw_sign(side);
    hold(
        sign * radians(rudder_deg), 300.0 * unit_, [&] { return sign * (ship_.state().psi - base) >= by; }, true);
    course_ = ship_.state().psi + sign * radians(20.0);
  }

  void spiral(int largest_deg, int step_deg, Side side, double each) {
    begin(fmt::format("spiral {}", largest_deg), side);
    const double sign = yaw_sign(side);
    for (int level = largest_deg; level >= -largest_deg; level -= step_deg)
      hold(sign * radians(level), each, [] { return false; });
    course_ = ship_.state().psi;
  }

  /// A turn, then the rudder amidships.
  void pull_out(int rudder_deg, Side side, double by, double after) {
    turn(rudder_deg, side, by);
    sailed_.push_back({fmt::format("pull-out {}", rudder_deg), ship_.time(), side});
    hold(0.0, after, [] { return false; });
    course_ = ship_.state().psi;
  }

  /// Whether the autopilot got her straight before every manoeuvre, and she answered the rudder in it.
  bool keeps_course() const { return keeps_course_; }

  const Recording& run() const { return run_; }
  const std::vector<Sailed>& sailed() const { return sailed_; }

 private:
  double turning() const { return ship_.state().motion.r; }
  double off_course() const { return course_ - ship_.state().psi; }

  void begin(const std::string& name, Side side) { sailed_.push_back({name, ship_.time(), side}); }

  /// delta = K_p (course − psi) − K_d r, at most 15 deg, and what waves make of it
  void steer() {
    const double wanted = 1.0 * off_course() - 3.0 * unit_ * turning();
    wave_ += 0.2 * (faults_.helm_noise * std::normal_distribution()(random_) - wave_);
    const double limited = std::clamp(wanted, -radians(15.0), radians(15.0)) + wave_;
    const double steps = faults_.helm_steps;
    sail(steps > 0.0 ? steps * std::round(limited / steps) : limited);
  }

  /// The rudder at an angle, as a helmsman keeps it, until `done`.
  template <class Done>
  void hold(double angle, double longest, const Done& done, bool must_end = false) {
    const double until = ship_.time() + longest;
    double correction = 0.0, next = ship_.time() + 0.3 * unit_;
    while (!done() && ship_.time() < until) {
      if (ship_.time() >= next) {
        correction = faults_.correction * uniform(-1.0, 1.0);
        next += uniform(0.2, 1.0) * unit_;
      }
      sail(angle + correction);
    }
    if (must_end && !done()) keeps_course_ = false;
  }

  void sail(double to_starboard) {
    sample();
    ship_.order_rudder(-to_starboard);
    ship_.step(step_);
  }

  void sample() {
    const auto normal = [&] { return std::normal_distribution()(random_); };
    const double shown = ship_.rudder_shown() + faults_.rudder_zero + faults_.rudder_noise * normal();
    const double grid = faults_.rudder_rounding;
    add(Channel::delta, grid > 0.0 ? grid * std::round(shown / grid) : shown);
    add(Channel::psi, wrapped(ship_.state().psi + faults_.heading_noise * normal()));
    add(Channel::speed_through_water, ship_.state().motion.u * (1.0 + 0.003 * normal()));
    run_.time.push_back(ship_.time());
  }

  void add(Channel channel, double value) {
    run_.channels[index_of(channel)].push_back(uniform(0.0, 1.0) < faults_.missing_share ? missing : value);
  }

  Simulator ship_;
  double unit_;  ///< L/U [s]
  double step_;  ///< [s]
  TrialFaults faults_;
  std::mt19937_64 random_;
  double course_ = 0.0;
  double wave_ = 0.0;
  bool keeps_course_ = true;
  Recording run_;
  std::vector<Sailed> sailed_;
};

}  // namespace swayaw::test
