#pragma once

#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "swayaw/core/recording.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"
#include "swayaw/nonlinear/manoeuvres/manoeuvre_step.hpp"
#include "swayaw/nonlinear/simulation/rudder_track.hpp"

/// A ship that is moved through time. Not installed.
namespace swayaw::inline nonlinear::detail {

/// Where the ship is at a time, and her controls: angle of the rudder, shaft speed as ordered.
struct Sample {
  double time;
  ShipState<double> state;
  Controls<double> controls;
  double shown{};           ///< rudder angle as the indicator shows it [rad]
  Hidden<double> hidden{};  ///< hidden states of effects
};

/// What manoeuvres and replays ask of the integration of a ship; see EventStepper.
class ShipStepper {
 public:
  using Watch = std::function<double(const ShipState<double>&)>;

  virtual ~ShipStepper() = default;

  virtual double time() const = 0;
  virtual ShipState<double> state() const = 0;
  virtual Controls<double> controls() const = 0;

  /// Rudder angle as the indicator shows it.
  virtual double shown() const = 0;

  /// Rates of change of x, y, psi, u, v, r now.
  virtual StateVector<double> rates_now() const = 0;

  /// From now on the indicator shows an angle that moves at that rate [rad/s].
  virtual void steer(double rate) = 0;

  /// From now on the rudder moves to that angle, as the steering gear can.
  virtual void order(double angle) = 0;

  /// The rudder follows that track, whatever the indicator shows.
  virtual void steer_along(const RudderTrack& track) = 0;

  /// The indicator shows that angle, whatever the rudder does.
  virtual void show_along(const Interpolant& angle) = 0;

  /// Effects remember that, not what goes with a steady motion.
  virtual void remember(const Hidden<double>& hidden) = 0;

  /// From now on the propulsion changes at that rate per second.
  virtual void drive(const Controls<double>& rate) = 0;

  /// Integrates to `until`, or to the time at which `watch(state)` passes zero.
  /// @return whether the watch ended it
  virtual bool advance(double until, const Watch& watch) = 0;

  void advance(double until) {
    advance(until, [](const ShipState<double>&) { return 1.0; });
  }

  /// Times at which `samples()` grow as the stepper passes them; in order, none before now.
  void sample_at(std::span<const double> times) { wanted_ = times; }
  std::vector<Sample>& samples() { return samples_; }

  /// From now on the steps are kept, if asked for.
  void trace(bool wanted) { traced_ = wanted; }
  std::vector<ManoeuvreStep>& steps() { return steps_; }

 protected:
  std::span<const double> wanted_;
  std::vector<Sample> samples_;
  bool traced_ = false;
  std::vector<ManoeuvreStep> steps_;
};

/// A stepper that follows hidden states of effects where the ship has some.
template <class Model>
std::unique_ptr<ShipStepper> make_stepper(const ActingShip<Model>& acting, const Sample& start, double tolerance);

extern template std::unique_ptr<ShipStepper> make_stepper(const ActingShip<MmgShip<double>>&, const Sample&, double);
extern template std::unique_ptr<ShipStepper> make_stepper(const ActingShip<PiShip<double>>&, const Sample&, double);
extern template std::unique_ptr<ShipStepper> make_stepper(const ActingShip<PuShip<double>>&, const Sample&, double);
extern template std::unique_ptr<ShipStepper> make_stepper(const ActingShip<AbkowitzShip<double>>&, const Sample&,
                                                          double);

}  // namespace swayaw::nonlinear::detail
