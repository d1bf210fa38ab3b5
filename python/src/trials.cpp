#include "module.hpp"
#include "record.hpp"
#include "swayaw/identification/trial.hpp"
#include "swayaw/nonlinear/ship.hpp"

namespace swayaw::python {

template <>
struct Words<TrialKind> : NamedWords<TrialKind, 4, name_of> {};
template <>
struct Words<SpeedSource> : NamedWords<SpeedSource, 6, in_words> {};

namespace {

void add_approach(py::module_& m) {
  Record<Told>(m, "Told", "A number read from a recording, with the standard error of noise, rounding and sampling.")
      .field<&Told::value>("value", "SI.")
      .field<&Told::standard_error>("standard_error", "NaN where none was derived.")
      .of()
      .def("__float__", [](const Told& told) { return told.value; });
  Record<TrialManoeuvre>(m, "TrialManoeuvre", "What was sailed.")
      .field<&TrialManoeuvre::kind>("kind", "zigzag, turn, spiral or steady run.")
      .field<&TrialManoeuvre::rudder>("rudder", "D [rad]; 0 of a steady run.")
      .field<&TrialManoeuvre::heading>("heading", "H of a zigzag [rad], else 0.")
      .field<&TrialManoeuvre::said>("said", "By the run itself; else told from rudder and heading.")
      .field<&TrialManoeuvre::name>("name", "\"zigzag 10/10\", \"turn 35\" …");
  Record<Approach>(m, "Approach", "The ship before the first rudder order.")
      .field<&Approach::execute>("execute", "When the rudder begins to move [s].")
      .field<&Approach::execute_said>("execute_said", "By the run itself.")
      .field<&Approach::heading>("heading", "[rad]")
      .field<&Approach::speed>("speed", "[m/s]")
      .field<&Approach::speed_source>("speed_source", "Where the speed comes from.")
      .field<&Approach::rudder>("rudder", "Mean angle, positive to port [rad].")
      .field<&Approach::before>("before", "Recorded time before the execute [s].");
  Record<RudderMove>(m, "RudderMove", "A rudder order as it was carried out.")
      .field<&RudderMove::start>("start", "[s]")
      .field<&RudderMove::from>("before", "Angle before, positive to port [rad].")
      .field<&RudderMove::to>("after", "Angle held after [rad].")
      .field<&RudderMove::rate>("rate", "Mean of the middle part of the way [rad/s].");
}

void add_zigzags(py::module_& m) {
  Record<TrialReversal>(m, "TrialReversal", "A heading peak of a recorded zigzag, and the execute before it.")
      .field<&TrialReversal::side>("side", "To which the heading is off.")
      .field<&TrialReversal::execute>("execute", "The heading passes H [s].")
      .field<&TrialReversal::rudder_start>("rudder_start", "The rudder begins to go back [s].")
      .field<&TrialReversal::heading_then>("heading_then", "Heading off the approach then [rad].")
      .field<&TrialReversal::peak_time>("peak_time", "[s]")
      .field<&TrialReversal::overshoot>("overshoot", "Of the peak beyond H [rad].")
      .field<&TrialReversal::beyond_start>("beyond_start", "Of the peak beyond heading_then [rad].")
      .field<&TrialReversal::overshoot_time>("overshoot_time", "From execute to peak [s].");
  Record<ZigzagTrial>(m, "ZigzagTrial", "A recorded zigzag.")
      .field<&ZigzagTrial::first>("first", "Side turned to first.")
      .field<&ZigzagTrial::reversals>("reversals", "In their order.")
      .field<&ZigzagTrial::period>("period", "Of the last full cycle [s].")
      .field<&ZigzagTrial::reach>("reach", "From the first execute until the heading is back [s].")
      .field<&ZigzagTrial::initial_turning>("initial_turning", "Way made when the heading first reaches H [m].")
      .field<&ZigzagTrial::end>("end", "Of the zigzag [s].")
      .field<&ZigzagTrial::broken_off>("broken_off", "The rudder was reversed before the heading reached H.");
}

void add_turns(py::module_& m) {
  Record<CircleTold>(m, "CircleTold", "Lengths of a recorded turning circle.")
      .field<&CircleTold::advance>("advance", "At 90 deg [m].")
      .field<&CircleTold::transfer>("transfer", "At 90 deg [m].")
      .field<&CircleTold::tactical_diameter>("tactical_diameter", "At 180 deg [m].")
      .field<&CircleTold::final_diameter>("final_diameter", "Of the steady turn [m].")
      .field<&CircleTold::initial_turning>("initial_turning", "Way made at 10 deg [m].");
  Record<DriftTold>(m, "DriftTold", "Drift of the track over ground, of current and wind together.")
      .field<&DriftTold::north>("north", "[m/s]")
      .field<&DriftTold::east>("east", "[m/s]")
      .field<&DriftTold::speed>("speed", "[m/s]")
      .field<&DriftTold::direction>("direction", "To which it sets, clockwise from north [rad].")
      .field<&DriftTold::pairs>("pairs", "Of places with headings 360 deg apart.");
  Record<TurnTrial>(m, "TurnTrial", "A recorded turning circle.")
      .field<&TurnTrial::side>("side", "Turned to.")
      .field<&TurnTrial::heading_change>("heading_change", "In all [rad].")
      .field<&TurnTrial::time_90>("time_90", "From the execute [s].")
      .field<&TurnTrial::time_180>("time_180", "[s]")
      .field<&TurnTrial::time_270>("time_270", "[s]")
      .field<&TurnTrial::time_360>("time_360", "[s]")
      .field<&TurnTrial::recorded>("recorded", "Of the track as it was recorded.")
      .field<&TurnTrial::drift>("drift", "None where the turn does not tell it.")
      .field<&TurnTrial::corrected>("corrected", "Of the track without that drift.")
      .field<&TurnTrial::final_yaw_rate>("final_yaw_rate", "Positive to starboard [rad/s].")
      .field<&TurnTrial::final_speed>("final_speed", "[m/s]")
      .field<&TurnTrial::final_drift>("final_drift", "Drift angle [rad].")
      .field<&TurnTrial::speed_kept>("speed_kept", "Final over approach speed.")
      .field<&TurnTrial::gain>("gain", "Final yaw rate over rudder angle [1/s].")
      .field<&TurnTrial::residual_yaw_rate>("residual_yaw_rate",
                                            "Pull-out: left after the rudder went amidships [rad/s].");
}

void add_others(py::module_& m) {
  Record<SpiralStep>(m, "SpiralStep", "A rudder angle of a recorded spiral.")
      .field<&SpiralStep::delta>("delta", "Rudder held, positive to port [rad].")
      .field<&SpiralStep::from>("begin", "[s]")
      .field<&SpiralStep::to>("end", "[s]")
      .field<&SpiralStep::yaw_rate>("yaw_rate", "Of the second half [rad/s].");
  Record<SpiralTrial>(m, "SpiralTrial", "A recorded spiral.")
      .field<&SpiralTrial::steps>("steps", "As they were sailed.")
      .field<&SpiralTrial::loop_width>("loop_width", "Between the outermost rudder angles with two yaw rates [rad].")
      .field<&SpiralTrial::loop_height>("loop_height", "Largest difference of yaw rate at one rudder angle [rad/s].");
  Record<SteadyTrial>(m, "SteadyTrial", "A recorded steady run.")
      .field<&SteadyTrial::helm>("helm", "Mean rudder angle, positive to port [rad].")
      .field<&SteadyTrial::yaw_rate>("yaw_rate", "[rad/s]")
      .field<&SteadyTrial::speed>("speed", "[m/s]")
      .field<&SteadyTrial::drift>("drift", "Drift angle through the water [rad].")
      .field<&SteadyTrial::leeway>("leeway", "Of the track over ground, positive to starboard [rad].");
}

void add_steering(py::module_& m) {
  Record<NomotoTold>(m, "NomotoTold", R"(T dr/dt + r = K (delta + offset), delta positive to STARBOARD, as K is read:
positive for a stable ship.)")
      .field<&NomotoTold::K>("K", "[1/s]")
      .field<&NomotoTold::T>("T", "[s]")
      .field<&NomotoTold::offset>("offset", "Acts beside the recorded angle, positive to starboard [rad].")
      .field<&NomotoTold::residual>("residual", "Rms of the heading left unexplained [rad].")
      .field<&NomotoTold::time>("time", "Of the fitted heading [s].")
      .field<&NomotoTold::heading>("heading", "Fitted, off the approach [rad].");
  Record<SecondOrderTold>(m, "SecondOrderTold",
                          "T1 T2 d²r/dt² + (T1 + T2) dr/dt + r = K (delta + T3 d(delta)/dt), the same sign.")
      .field<&SecondOrderTold::K>("K", "[1/s]")
      .field<&SecondOrderTold::T1T2>("T1T2", "[s²]")
      .field<&SecondOrderTold::T1_plus_T2>("T1_plus_T2", "[s]")
      .field<&SecondOrderTold::T1>("T1", "[s]; None for a complex pair.")
      .field<&SecondOrderTold::T2>("T2", "[s]; None for a complex pair.")
      .field<&SecondOrderTold::T3>("T3", "[s]")
      .field<&SecondOrderTold::K_told>("K_told", "Its standard error is no more than half of it.")
      .field<&SecondOrderTold::T1_told>("T1_told", "Likewise.")
      .field<&SecondOrderTold::T2_told>("T2_told", "Likewise.")
      .field<&SecondOrderTold::T3_told>("T3_told", "Likewise.");
  Record<SteeringTrial>(m, "SteeringTrial", "K and T of a recorded manoeuvre.")
      .field<&SteeringTrial::worked>("worked", "Nomoto's own method, without standard errors.")
      .field<&SteeringTrial::least_squares>("least_squares", "Of the heading of the whole manoeuvre.")
      .field<&SteeringTrial::second>("second", "Second order.")
      .field<&SteeringTrial::K_prime>("K_prime", "K L/U.")
      .field<&SteeringTrial::T_prime>("T_prime", "T U/L.")
      .field<&SteeringTrial::P>("P", "Norrbin's P, as recorded.")
      .field<&SteeringTrial::P_of_fit>("P_of_fit", "K' (1 - T' + T' exp(-1/T')).");
  Record<JudgedCriterion>(m, "JudgedCriterion", "A criterion of MSC.137(76) on a recorded number.")
      .field<&JudgedCriterion::name>("name", "\"tactical_diameter\"")
      .field<&JudgedCriterion::side>("side", "Turned to first.")
      .field<&JudgedCriterion::value>("value", "In `unit`.")
      .field<&JudgedCriterion::limit>("limit", "In `unit`.")
      .field<&JudgedCriterion::unit>("unit", "\"L\" or \"deg\".")
      .field<&JudgedCriterion::pass>("passed", "None where value ± 2 standard errors holds the limit.");
}

void add_result(py::module_& m) {
  Record<TrialResult>(m, "TrialResult", "A recorded manoeuvre judged.")
      .field<&TrialResult::run>("run", "Its name.")
      .field<&TrialResult::manoeuvre>("manoeuvre", "What was sailed.")
      .field<&TrialResult::approach>("approach", "Before the first rudder order.")
      .field<&TrialResult::rudder>("rudder", "Orders as they were carried out.")
      .field<&TrialResult::zigzag>("zigzag", "If it is one.")
      .field<&TrialResult::turn>("turn", "If it is one.")
      .field<&TrialResult::spiral>("spiral", "If it is one.")
      .field<&TrialResult::steady>("steady", "If it is one.")
      .field<&TrialResult::time_10>("time_10", "From the execute to 10 deg change of heading [s].")
      .field<&TrialResult::steering>("steering", "K and T.")
      .field<&TrialResult::imo>("imo", "Empty without length or speed.")
      .field<&TrialResult::against_rudder>("against_rudder", "The sign of the rudder is wrong.")
      .field<&TrialResult::notes>("notes", "What cannot be told and why.");
  Record<ImoSummary>(m, "ImoSummary", "The criteria of several trials together.")
      .field<&ImoSummary::any>("any", "Whether anything was judged.")
      .field<&ImoSummary::failed>("failed", "\"tactical_diameter to port\"")
      .field<&ImoSummary::open>("cannot_tell", "The value crosses the limit, or was not reached.")
      .field<&ImoSummary::missing>("not_told", "No run tells it on either side.");
}

}  // namespace

void add_trials(py::module_& m) {
  add_approach(m);
  add_zigzags(m);
  add_turns(m);
  add_others(m);
  add_steering(m);
  add_result(m);
  m.def(
      "trial",
      [](const Recording& run, const Ship* ship, Maybe L, Maybe U) {
        TrialOptions options{.L = L, .U = U};
        if (ship && !options.L) options.L = length(*ship);
        if (ship) options.max_rudder = turning_rudder(*ship);
        return judge_trial(run, options);
      },
      py::arg("run"), py::arg("ship") = py::none(), py::kw_only(), py::arg("length") = py::none(),
      py::arg("speed") = py::none(), Unlocked(),
      "A recorded manoeuvre judged: overshoots, K and T, turning circle, criteria of MSC.137(76), with standard "
      "errors. "
      "Heading and rudder suffice. The ship gives her length [m] and largest rudder angle; speed: of the approach "
      "[m/s], "
      "in place of the recorded one. Raises Refusal where the run tells no manoeuvre."
      "\n\nrun: the recording. ship: of any nonlinear model; without her, length: of the ship [m].");
  m.def(
      "trial_summary", [](const std::vector<TrialResult>& trials) { return summary_of(trials); }, py::arg("trials"),
      "One verdict of several trials by MSC.137(76)."
      "\n\ntrials: of `trial`, one for each run.");
}

}  // namespace swayaw::python
