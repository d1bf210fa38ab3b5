#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "../simulation/ship_stepper.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/core/rounding.hpp"
#include "swayaw/nonlinear/instruments/instruments.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/models/validity.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"

/// What the manoeuvres share. Not installed.
namespace swayaw::inline nonlinear::detail {

/// Straight ahead at the origin.
inline Sample approach(double speed, const Controls<double>& propulsion) {
  return {0.0, {0.0, 0.0, 0.0, {speed, 0.0, 0.0}}, propulsion};
}

/// Speed and propulsion of the approach, when to stop at the latest, and when to take samples.
struct Plan {
  double speed;
  Controls<double> propulsion;
  double end;
  std::vector<double> times;
};

/// @param longest  duration in ship lengths at approach speed, unless the options give one
template <class Model>
Plan plan(const Model& ship, const ManoeuvreOptions& options, double longest);
template <class Model>
Plan plan(const ActingShip<Model>& ship, const ManoeuvreOptions& options, double longest);

/// Samples for which room is made at once, 2 MB. Only what is written takes memory; a list that grows would be moved
/// again and again, and glibc would give its pages back to the system after each manoeuvre and take them anew for the
/// next: 100 µs of a zigzag of 650 µs.
inline constexpr std::size_t most_samples_at_once = 16384;

/// A stepper of the ship as she approaches, which keeps samples and steps as asked.
/// @param plan  must outlive the stepper
template <class Model>
std::unique_ptr<ShipStepper> approaching(const ActingShip<Model>& acting, const Plan& plan,
                                         const ManoeuvreOptions& options) {
  auto stepper = make_stepper(acting, approach(plan.speed, plan.propulsion), options.tolerance);
  stepper->sample_at(plan.times);
  stepper->samples().reserve(std::min(plan.times.size(), most_samples_at_once));
  stepper->trace(options.traced);
  return stepper;
}

inline Sample now(const ShipStepper& stepper) { return {stepper.time(), stepper.state(), stepper.controls()}; }

/// Options of the same manoeuvre, for what is measured on samples: it does not depend on the step of those that are
/// written.
inline ManoeuvreOptions measuring(ManoeuvreOptions options, const std::optional<double>& duration) {
  options.step.reset(), options.duration = duration, options.traced = false;
  return options;
}

/// A little longer than until an event, so that it is reached.
inline double just_after(double event) { return 1.01 * event; }

/// Way made until a time, ∫ U dt by the trapezoidal rule over the samples and the one `last` after them [m]; nothing
/// without samples.
std::optional<double> way_made(const std::vector<Sample>& samples, const Sample& last, double until);

/// States and thrust as her instruments record them.
/// @param begin  of the run, which the samples may be a part of [s]; unless given, the first of them
template <class Model>
Recording recording_of(const std::vector<Sample>& samples, const ActingShip<Model>& acting,
                       std::optional<double> begin = {});

extern template Plan plan(const MmgShip<double>&, const ManoeuvreOptions&, double);
extern template Plan plan(const ActingShip<MmgShip<double>>&, const ManoeuvreOptions&, double);
extern template Plan plan(const PiShip<double>&, const ManoeuvreOptions&, double);
extern template Plan plan(const ActingShip<PiShip<double>>&, const ManoeuvreOptions&, double);
extern template Plan plan(const PuShip<double>&, const ManoeuvreOptions&, double);
extern template Plan plan(const ActingShip<PuShip<double>>&, const ManoeuvreOptions&, double);
extern template Plan plan(const AbkowitzShip<double>&, const ManoeuvreOptions&, double);
extern template Plan plan(const ActingShip<AbkowitzShip<double>>&, const ManoeuvreOptions&, double);
extern template Recording recording_of(const std::vector<Sample>&, const ActingShip<MmgShip<double>>&,
                                       std::optional<double>);
extern template Recording recording_of(const std::vector<Sample>&, const ActingShip<PiShip<double>>&,
                                       std::optional<double>);
extern template Recording recording_of(const std::vector<Sample>&, const ActingShip<PuShip<double>>&,
                                       std::optional<double>);
extern template Recording recording_of(const std::vector<Sample>&, const ActingShip<AbkowitzShip<double>>&,
                                       std::optional<double>);

}  // namespace swayaw::nonlinear::detail
