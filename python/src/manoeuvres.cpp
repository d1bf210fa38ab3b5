#include "module.hpp"
#include "record.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/manoeuvres/pull_out.hpp"
#include "swayaw/nonlinear/manoeuvres/spiral.hpp"
#include "swayaw/nonlinear/manoeuvres/williamson_turn.hpp"

namespace swayaw::python {
namespace {

// ---------------------------------------------------------------- options by name

/// The options of manoeuvres as keyword arguments of every one of them.
ManoeuvreOptions options_of(Maybe speed, Maybe rev, Maybe thrust, Maybe duration, Maybe step, double tolerance,
                            bool sampled) {
  return {.speed = speed,
          .rev = rev,
          .thrust = thrust,
          .duration = duration,
          .step = step,
          .tolerance = tolerance,
          .sampled = sampled};
}

constexpr double usual_tolerance = ManoeuvreOptions{}.tolerance;

#define SWAYAW_MANOEUVRE_ARGUMENTS                                                                           \
  py::kw_only(), py::arg("speed") = py::none(), py::arg("rev") = py::none(), py::arg("thrust") = py::none(), \
                 py::arg("duration") = py::none(), py::arg("step") = py::none(),                             \
                 py::arg("tolerance") = usual_tolerance, py::arg("sampled") = true, Unlocked()

#define SWAYAW_MANOEUVRE_DOC                                                                                        \
  "\n\nspeed: of the approach [m/s], the service speed unless given. rev: shaft speed [1/s], or thrust: of all "    \
  "propellers [N]; self-propulsion at that speed unless given. duration [s]: else until the indices are known. "    \
  "step: between samples [s]. sampled=False keeps no time series and is faster.\n\nRaises ValueError for an angle " \
  "that is not positive or beyond the ship's largest, Refusal if she cannot propel herself at the speed."

// ---------------------------------------------------------------- results

void add_zigzag(py::module_& m) {
  Record<ZigzagOrder>(m, "ZigzagOrder", "A zigzag.", Made::by_anyone)
      .field<&ZigzagOrder::rudder>("rudder", "[rad], positive.")
      .field<&ZigzagOrder::heading>("heading", "At which the rudder is reversed [rad], positive.")
      .optional<&ZigzagOrder::first>("first", "Side turned to first.");
  Record<Reversal>(m, "Reversal", "A rudder reversal and the heading peak that follows.")
      .field<&Reversal::time>("time", "When the heading reaches the switch angle [s].")
      .field<&Reversal::peak_time>("peak_time", "When the yaw rate passes zero [s].")
      .field<&Reversal::overshoot>("overshoot", "Heading peak beyond the switch angle [rad].");
  Record<Zigzag>(m, "Zigzag", "A simulated zigzag and its indices. Source: IMO resolution MSC.137(76).")
      .field<&Zigzag::reversals>("reversals", "In their order.")
      .field<&Zigzag::period>("period", "Of the last full cycle, reversal to the next but one [s].")
      .field<&Zigzag::initial_turning>("initial_turning", "Way made when the heading first reaches H [m].")
      .field<&Zigzag::approach_speed>("approach_speed", "[m/s]")
      .field<&Zigzag::propulsion>("propulsion", "Held during the manoeuvre.")
      .field<&Zigzag::run>("run", "The time series.");
  m.def(
      "zigzag",
      [](const Ship& ship, double rudder, double heading, Side first, Maybe speed, Maybe rev, Maybe thrust,
         Maybe duration, Maybe step, double tolerance, bool sampled) {
        return zigzag(ship, {rudder, heading, first},
                      options_of(speed, rev, thrust, duration, step, tolerance, sampled));
      },
      py::arg("ship"), py::arg("rudder"), py::arg("heading"), py::arg("first") = Side::starboard,
      SWAYAW_MANOEUVRE_ARGUMENTS,
      "Zigzag: the rudder [rad] is put over to the side `first`; whenever the heading has changed by `heading` [rad] "
      "to "
      "the side of the turn it is reversed. Ends after the fourth overshoot unless a duration is "
      "given." SWAYAW_MANOEUVRE_DOC "\n\ntolerance: error of an integration step.");
}

void add_turning_circle(py::module_& m) {
  Record<TurnOrder>(m, "TurnOrder", "A turn with the rudder held.", Made::by_anyone)
      .field<&TurnOrder::rudder>("rudder", "[rad], positive.")
      .optional<&TurnOrder::side>("side", "Turned to.");
  Record<TurningCircle>(m, "TurningCircle",
                        "A simulated turning circle and its indices; None for what was not reached.")
      .field<&TurningCircle::advance>("advance", "Forward way at 90 deg change of heading [m].")
      .field<&TurningCircle::transfer>("transfer", "Sideways way at 90 deg [m].")
      .field<&TurningCircle::time_90>("time_90", "[s]")
      .field<&TurningCircle::tactical_diameter>("tactical_diameter", "Sideways way at 180 deg [m].")
      .field<&TurningCircle::time_180>("time_180", "[s]")
      .field<&TurningCircle::initial_turning>("initial_turning", "Way made at 10 deg change of heading [m].")
      .field<&TurningCircle::final_diameter>("final_diameter", "2U/|r| of the steady turn [m].")
      .field<&TurningCircle::steady>("steady", "The steady turn, if the ship settles in one.")
      .field<&TurningCircle::way_lost>("way_lost", "When the ship ceased to move ahead, which ended the turn [s].")
      .field<&TurningCircle::approach_speed>("approach_speed", "[m/s]")
      .field<&TurningCircle::propulsion>("propulsion", "Held during the manoeuvre.")
      .field<&TurningCircle::run>("run", "The time series.");
  m.def(
      "turning_circle",
      [](const Ship& ship, double rudder, Side side, Maybe speed, Maybe rev, Maybe thrust, Maybe duration, Maybe step,
         double tolerance, bool sampled) {
        return turning_circle(ship, {rudder, side}, options_of(speed, rev, thrust, duration, step, tolerance, sampled));
      },
      py::arg("ship"), py::arg("rudder"), py::arg("side") = Side::starboard, SWAYAW_MANOEUVRE_ARGUMENTS,
      "Turning circle with the rudder [rad] held over to a side. Ends after 540 deg, or where the ship no longer moves "
      "ahead, unless a duration is given." SWAYAW_MANOEUVRE_DOC "\n\ntolerance: error of an integration step.");
}

void add_pull_out(py::module_& m) {
  Record<PullOutSide>(m, "PullOutSide", "Pull-out from a turn to one side.")
      .field<&PullOutSide::execute>("execute", "When the rudder is ordered amidships [s].")
      .field<&PullOutSide::turning>("turning", "Yaw rate then [rad/s].")
      .field<&PullOutSide::turning_settled>("turning_settled", "The turn was steady.")
      .field<&PullOutSide::residual>("residual", "Yaw rate at the end [rad/s]: 0 for a course-stable ship.")
      .field<&PullOutSide::settled>("settled", "The end was steady.")
      .field<&PullOutSide::fall_time>("fall_time", "From the order until 1/e of the change of yaw rate is left [s].")
      .field<&PullOutSide::decay_time>("decay_time", "T of exp(-t/T) at the end [s].")
      .field<&PullOutSide::T1>("T1", "Slower time constant of sway and yaw about the steady motion [s].")
      .field<&PullOutSide::run>("run", "The time series.");
  using Both = Sides<PullOutSide>;
  Record<Both>(m, "PullOutSides", "By the side of the turn.")
      .field<&Both::port>("port", "From a turn to port.")
      .field<&Both::starboard>("starboard", "From a turn to starboard.");
  Record<PullOut>(m, "PullOut", "What is left of a turn once the rudder is amidships.")
      .field<&PullOut::sides>("sides", "By the side of the turn.")
      .field<&PullOut::approach_speed>("approach_speed", "[m/s]")
      .field<&PullOut::propulsion>("propulsion", "Held during the manoeuvre.");
  m.def(
      "pull_out",
      [](const Ship& ship, double rudder, Maybe speed, Maybe rev, Maybe thrust, Maybe duration, Maybe step,
         double tolerance, bool sampled) {
        return pull_out(ship, {rudder, {}}, options_of(speed, rev, thrust, duration, step, tolerance, sampled));
      },
      py::arg("ship"), py::arg("rudder"), SWAYAW_MANOEUVRE_ARGUMENTS,
      "Turns with the rudder [rad] held, then puts it amidships, to both sides; both motions last until they are "
      "steady. "
      "`duration` is not used. Source: [MSC/Circ.1053] appendix 4." SWAYAW_MANOEUVRE_DOC
      "\n\ntolerance: error of an integration step.");
}

void add_spiral(py::module_& m) {
  Record<SteadyTurn>(m, "SteadyTurn", "A point of the r-delta curve.")
      .field<&SteadyTurn::delta>("delta", "Rudder angle, positive to port [rad].")
      .field<&SteadyTurn::motion>("motion", "Steady there.")
      .field<&SteadyTurn::stable>("stable", "A small disturbance dies out.");
  Record<InstabilityLoop>(m, "InstabilityLoop", "Hysteresis of an unstable ship.")
      .field<&InstabilityLoop::width>("width", "Of rudder angle between the folds of the curve [rad].")
      .field<&InstabilityLoop::height>("height", "Between the stable yaw rates at the neutral rudder angle [rad/s].");
  Record<SpiralPoint>(m, "SpiralPoint", "What became of the ship at one rudder angle.")
      .field<&SpiralPoint::delta>("delta", "Rudder angle, positive to port [rad].")
      .field<&SpiralPoint::motion>("motion", "At the end.")
      .field<&SpiralPoint::held>("held", "Time since the order [s].")
      .field<&SpiralPoint::settled>("settled", "The motion was steady.");
  Record<SpiralLoop>(m, "SpiralLoop", "Where the way out and the way back differ.")
      .field<&SpiralLoop::width>("width", "Between the outermost such rudder angles [rad].")
      .field<&SpiralLoop::height>("height", "Largest difference of yaw rate at one rudder angle [rad/s].");
  Record<Spiral>(m, "Spiral", "Dieudonné's spiral.")
      .field<&Spiral::down>("down", "From the largest angle on the first side to the largest on the other.")
      .field<&Spiral::up>("up", "And back.")
      .field<&Spiral::loop>("loop", "Of the two; None where they agree.")
      .field<&Spiral::curve>("curve", "All steady turns up to the largest angle, the unstable ones too.")
      .field<&Spiral::exact>("exact", "Loop of that curve.")
      .field<&Spiral::approach_speed>("approach_speed", "[m/s]")
      .field<&Spiral::propulsion>("propulsion", "Held during the manoeuvre.")
      .field<&Spiral::run>("run", "The time series.");
  m.def(
      "spiral",
      [](const Ship& ship, double largest, double step_angle, Side first, Maybe speed, Maybe rev, Maybe thrust,
         Maybe duration, Maybe step, double tolerance, bool sampled) {
        return spiral(ship, {.largest = largest, .step = step_angle, .first = first, .settling = {}},
                      options_of(speed, rev, thrust, duration, step, tolerance, sampled));
      },
      py::arg("ship"), py::arg("largest") = SpiralOrder{}.largest, py::arg("step_angle") = SpiralOrder{}.step,
      py::arg("first") = Side::starboard, SWAYAW_MANOEUVRE_ARGUMENTS,
      "Dieudonné's spiral: the rudder goes from the largest angle [rad] on one side to that on the other and back in "
      "steps of `step_angle` [rad], held at each until the ship turns steadily. `duration` is not "
      "used." SWAYAW_MANOEUVRE_DOC "\n\nfirst: side of the first angle. tolerance: error of an integration step.");
  Record<HeldYawRate>(m, "HeldYawRate", "A yaw rate and the rudder that holds it.")
      .field<&HeldYawRate::r>("r", "[rad/s]")
      .field<&HeldYawRate::turn>("turn", "None where no rudder angle up to the largest holds it.");
  Record<ReverseSpiral>(m, "ReverseSpiral", "Bech's reverse spiral.")
      .field<&ReverseSpiral::points>("points", "From the largest yaw rate to port to the largest to starboard.")
      .field<&ReverseSpiral::approach_speed>("approach_speed", "[m/s]")
      .field<&ReverseSpiral::propulsion>("propulsion", "Held.");
  m.def(
      "reverse_spiral",
      [](const Ship& ship, double largest, int steps, Maybe speed, Maybe rev, Maybe thrust) {
        return reverse_spiral(ship, {.largest = largest, .steps = steps},
                              {.speed = speed, .rev = rev, .thrust = thrust, .duration = {}, .step = {}});
      },
      py::arg("ship"), py::arg("largest") = ReverseSpiralOrder{}.largest, py::arg("steps") = ReverseSpiralOrder{}.steps,
      py::kw_only(), py::arg("speed") = py::none(), py::arg("rev") = py::none(), py::arg("thrust") = py::none(),
      Unlocked(),
      "For each yaw rate the mean rudder angle of a helmsman who keeps it, up to `largest` [rad]."
      "\n\nship: of any nonlinear model. steps: between yaw rate 0 and the largest. speed: of the approach [m/s], the "
      "service speed unless given. rev: shaft speed [1/s], or thrust: of all propellers [N].");
}

void add_williamson_turn(py::module_& m) {
  Record<TrackPlace>(m, "TrackPlace", "Where the ship is on the original track.")
      .field<&TrackPlace::time>("time", "[s]")
      .field<&TrackPlace::along>("along", "Ahead of the place of the first order [m].")
      .field<&TrackPlace::offset>("offset", "Beside the track, positive on the side turned to first [m].");
  Record<WilliamsonTurn>(m, "WilliamsonTurn", "Back along the own track.")
      .field<&WilliamsonTurn::shifted>("shifted", "Rudder ordered to the other side.")
      .field<&WilliamsonTurn::amidships>("amidships", "Rudder ordered amidships.")
      .field<&WilliamsonTurn::reciprocal>("reciprocal", "Heading opposite to the approach.")
      .field<&WilliamsonTurn::way>("way", "Made from the first order until then [m].")
      .field<&WilliamsonTurn::heading>("heading", "Change of heading at the end, to the side turned to first [rad].")
      .field<&WilliamsonTurn::yaw_rate>("yaw_rate", "At the end, positive to starboard [rad/s].")
      .field<&WilliamsonTurn::approach_speed>("approach_speed", "[m/s]")
      .field<&WilliamsonTurn::propulsion>("propulsion", "Held during the manoeuvre.")
      .field<&WilliamsonTurn::run>("run", "The time series.");
  m.def(
      "williamson_turn",
      [](const Ship& ship, double rudder, double heading, double before, Side first, Maybe speed, Maybe rev,
         Maybe thrust, Maybe duration, Maybe step, double tolerance, bool sampled) {
        return williamson_turn(ship, {rudder, heading, before, first},
                               options_of(speed, rev, thrust, duration, step, tolerance, sampled));
      },
      py::arg("ship"), py::arg("rudder") = WilliamsonOrder{}.rudder, py::arg("heading") = WilliamsonOrder{}.heading,
      py::arg("before") = WilliamsonOrder{}.before, py::arg("first") = Side::starboard, SWAYAW_MANOEUVRE_ARGUMENTS,
      "Rudder [rad] hard over to `first` until the heading has changed by `heading` [rad], to the other side until it "
      "is "
      "`before` [rad] short of the reciprocal, then amidships. Source: [IAMSAR]." SWAYAW_MANOEUVRE_DOC
      "\n\nrudder, heading, before: angles, positive. tolerance: error of an integration step.");
}

}  // namespace

void add_manoeuvres(py::module_& m) {
  add_zigzag(m);
  add_turning_circle(m);
  add_pull_out(m);
  add_spiral(m);
  add_williamson_turn(m);
}

}  // namespace swayaw::python
