#pragma once

#include <array>
#include <memory>
#include <span>
#include <string_view>

#include "swayaw/core/channel.hpp"
#include "swayaw/core/motion.hpp"
#include "swayaw/nonlinear/models/branch.hpp"
#include "swayaw/nonlinear/models/controls.hpp"
#include "swayaw/nonlinear/surroundings/surroundings.hpp"

/// A ship in real time: what a ship-handling simulator links.
///
///     Simulator ship(read_ship("kvlcc2.toml"));
///     ship.order_rudder(radians(-20));
///     while (running) ship.step(0.02);
namespace swayaw::inline nonlinear {

struct Ship;

/// Whether the force model holds where the ship is; else what carries it on (docs/simulation.md has the rule).
enum class SimulatorState {
  valid,
  little_way,         ///< u < 0.1 U_0, at rest and astern included: drag of the hull, thrust as at bollard pull
  turns_on_the_spot,  ///< |v| > 2 u or |rL| > 3 u
  too_fast,           ///< u > 2 U_0
  shaft_astern,       ///< counts as stopped
  unbounded,          ///< a step led to no finite motion and was not taken
};

std::string_view words_for(SimulatorState state);

struct SimulatorOptions {
  double longest_step = 0.01;  ///< of a Runge–Kutta step in L/U_0
  double speed = 0.0;          ///< straight ahead at the start [m/s]; 0 for the service speed
};

/// A ship of any model with all her effects: forces, wind and gusts, current, actuators, instruments.
///
/// Motion is through the water. Steps are those of the classical Runge–Kutta method, none longer than `longest_step`,
/// with the branch of the force at its beginning; gusts begin and end, and the steering gear changes its rate, between
/// steps. The result is the same whenever
/// the same calls are made. A zigzag or a turn of any model at 50 Hz is within 1e-5 L and 1e-5 rad of the simulation
/// under error control (tests/nonlinear/simulator_test.cpp).
///
/// `step` and what is read allocate nothing and throw nothing.
class Simulator {
 public:
  /// At the origin on heading 0, straight ahead with the propulsion that carries her.
  /// @throws Refusal  if an effect cannot act on her, or she cannot propel herself at the speed
  explicit Simulator(const Ship& ship, const SimulatorOptions& options = {});
  Simulator(Simulator&&) noexcept;
  Simulator& operator=(Simulator&&) noexcept;
  ~Simulator();

  /// Goes on by dt [s]; does nothing unless dt > 0.
  void step(double dt) noexcept;

  // ------------------------------------------------------------ held until given anew
  // Each throws std::domain_error unless the numbers are finite.

  /// Rudder angle, positive to port [rad], through the steering gear; held at its largest angle.
  void order_rudder(double angle);

  /// The indicator shows that angle at once.
  void set_rudder(double angle);

  /// Shaft speed [1/s]. @throws Refusal  where the model takes none
  void set_shaft_speed(double rev);

  /// Thrust of all propellers [N], in place of a shaft speed. @throws Refusal  where the model takes none
  void set_thrust(double thrust);

  /// True wind; gusts of the ship's effects come on top. @throws Refusal  if nothing is known of what she shows the
  /// wind
  void set_wind(const Wind<double>& wind);

  /// The motion through the water stays as it is.
  void set_current(const Current<double>& current);

  /// A force in body axes beside all others, about midship: tugs, lines, waves of the simulator's own.
  void set_added_force(const PlanarForce<double>& force);

  /// Place, heading and motion through the water. Heel and memory become those of a steady motion.
  void set_state(const ShipState<double>& state);

  // ------------------------------------------------------------ what is known now

  double time() const noexcept;                     ///< since the beginning [s]
  const ShipState<double>& state() const noexcept;  ///< the motion through the water
  PlanarMotion<double> velocity_over_ground() const noexcept;
  double heel() const noexcept;          ///< starboard side down [rad]; 0 without roll coupling
  double rudder() const noexcept;        ///< angle of the rudder [rad]
  double rudder_shown() const noexcept;  ///< angle that the indicator shows [rad]
  double shaft_speed() const noexcept;   ///< as ordered [1/s]
  double thrust() const noexcept;        ///< of all propellers [N]; NaN where the model does not tell it

  /// Forces by part: those of the model, wind, effects, "given". Valid until the next call.
  std::span<const ForcePart<double>> forces() const noexcept;

  /// What the instruments show, by channel; NaN for a channel that a ship does not have. A late channel is drawn back
  /// along its rate.
  std::array<double, channel_count> instruments() const noexcept;

  bool valid() const noexcept { return why() == SimulatorState::valid; }
  SimulatorState why() const noexcept;

 private:
  class Core;
  template <class Model>
  class CoreOf;
  std::unique_ptr<Core> core_;
};

}  // namespace swayaw::nonlinear
