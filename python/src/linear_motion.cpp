#include "module.hpp"
#include "record.hpp"
#include "swayaw/linear/frequency_response.hpp"
#include "swayaw/linear/linear_recording.hpp"
#include "swayaw/linear/loop.hpp"
#include "swayaw/linear/response.hpp"
#include "swayaw/linear/rudder_history.hpp"
#include "swayaw/linear/track.hpp"
#include "swayaw/linear/zigzag.hpp"

namespace swayaw::python {

template <>
struct Words<LegEnd> {
  static std::vector<std::string> list() { return {"limit", "arrival", "heading", "peak"}; }
};

namespace {

using Coefficients = SwayYawCoefficients<double>;
using State = LinearState<double>;

/// States as columns beta, omega, psi.
py::dict columns_of(const std::vector<State>& states) {
  std::vector<double> beta, omega, psi;
  for (const auto& x : states) beta.push_back(x.beta), omega.push_back(x.omega), psi.push_back(x.psi);
  py::dict columns;
  columns["beta"] = owned(std::move(beta)), columns["omega"] = owned(std::move(omega));
  columns["psi"] = owned(std::move(psi));
  return columns;
}

// ---------------------------------------------------------------- response

void add_response(py::module_& m) {
  Record<State>(m, "LinearState", "Drift, yaw rate and heading of a ship in linear motion.", Made::by_anyone)
      .optional<&State::beta>("beta", "Drift angle [rad].")
      .optional<&State::omega>("omega", "omega' = rL/U.")
      .optional<&State::psi>("psi", "Heading [rad].");
  Record<RudderHistory>(m, "RudderHistory",
                        "Rudder angle over dimensionless time, straight lines between the points and held after the "
                        "last. Two points at one time are a step.",
                        Made::by_anyone)
      .field<&RudderHistory::s>("s", "Ship lengths, never descending.")
      .field<&RudderHistory::delta>("delta", "Rudder angle [rad], positive to port.");
  m.def("rudder_step", &rudder_step, py::arg("angle"),
        "The rudder is at `angle` [rad] from s' = 0."
        "\n\nangle: positive to port. For `response`.");
  m.def("rudder_ramp_and_hold", &rudder_ramp_and_hold, py::arg("angle"), py::arg("rate"),
        "From midships to `angle` [rad] at `rate` [rad per ship length], then held."
        "\n\nangle: positive to port. rate: positive. For `response`.");
  m.def(
      "response",
      [](const Coefficients& ship, const RudderHistory& history, const Array& times, const State& start) {
        const auto s = numbers_in(times, "s");
        return columns_of(response_to(LinearResponse<double>(ship), history, s, start));
      },
      py::arg("coefficients"), py::arg("rudder"), py::arg("s"), py::arg("start") = State{0.0, 0.0, 0.0},
      "Exact response to a rudder history at dimensionless times s' = tU/L: arrays beta [rad], omega', psi [rad]."
      "\n\ncoefficients: of the ship. rudder: of `rudder_step` or `rudder_ramp_and_hold`. s: times, an array. start: "
      "at s' = 0, straight ahead unless given.");
}

// ---------------------------------------------------------------- zigzag

void add_zigzag(py::module_& m) {
  using Turned = LinearReversal<double>;
  Record<Turned>(m, "LinearReversal", "A rudder reversal and the heading peak that follows it.")
      .field<&Turned::execute>("execute", "s' at which the heading reaches H.")
      .field<&Turned::peak>("peak", "s' at which the yaw rate passes zero.")
      .field<&Turned::overshoot>("overshoot", "Heading beyond H at the peak [rad].")
      .field<&Turned::leg>("leg", "First leg after the reversal.");
  using Line = RudderLine<double>;
  Record<Line>(m, "RudderLine", "Rudder angle that changes linearly: value + rate s.", Made::by_anyone)
      .field<&Line::value>("value", "At the start [rad].")
      .field<&Line::rate>("rate", "Per ship length [rad].");
  using OneLeg = Leg<double>;
  Record<OneLeg>(m, "Leg", "Motion under a rudder that moves in one straight line.")
      .field<&OneLeg::from>("begin", "s' at its start.")
      .field<&OneLeg::length>("length", "Ship lengths until its end.")
      .field<&OneLeg::start>("start", "State there.")
      .field<&OneLeg::rudder>("rudder", "Its rudder.")
      .field<&OneLeg::end>("end", "What ends it: limit, arrival of the rudder, heading, peak.");
  using Sailed = LinearZigzag<double>;
  Record<Sailed>(m, "LinearZigzag", "An exact zigzag of a ship in linear motion.")
      .field<&Sailed::reversals>("reversals", "In their order.")
      .field<&Sailed::legs>("legs", "Each in closed form.")
      .of()
      .def_property_readonly("period", &Sailed::period, "From the last reversal but two to the last [ship lengths].")
      .def(
          "states",
          [](const Sailed& zigzag, const Coefficients& ship, const Array& times) {
            const LinearResponse<double> response(ship);
            std::vector<State> states;
            for (const double s : numbers_in(times, "s")) states.push_back(state_at(response, zigzag.legs, s));
            return columns_of(states);
          },
          py::arg("coefficients"), py::arg("s"), "Exact states of its ship at times s': beta, omega, psi.")
      .def(
          "rudder",
          [](const Sailed& zigzag, const Array& times) {
            std::vector<double> angles;
            for (const double s : numbers_in(times, "s")) angles.push_back(rudder_at(zigzag.legs, s));
            return owned(std::move(angles));
          },
          py::arg("s"), "Rudder angle at times s' [rad].")
      .def(
          "recording",
          [](const Sailed& zigzag, const Coefficients& ship, const PrimeScale& scale, double step) {
            return recording_of(ship, zigzag.legs, scale, step);
          },
          py::arg("coefficients"), py::arg("scale"), py::arg("step"), "As a recording with samples every `step` [s].");
  const auto order = [](double rudder, double heading, double rate, Side first, std::size_t reversals) {
    return LinearZigzagOrder{
        .rudder = rudder, .heading = heading, .rate = rate, .first = first, .reversals = reversals};
  };
  m.def(
      "linear_zigzag",
      [order](const Coefficients& ship, double rudder, double heading, double rate, Side first, std::size_t reversals) {
        return linear_zigzag(ship, order(rudder, heading, rate, first, reversals));
      },
      py::arg("coefficients"), py::arg("rudder"), py::arg("heading"), py::arg("rate"),
      py::arg("first") = Side::starboard, py::arg("reversals") = LinearZigzagOrder{}.reversals, Unlocked(),
      "The zigzag from straight ahead, exact: every leg a closed form, every switch the root of one. Rudder and "
      "heading "
      "[rad]; rate in rad per ship length, infinite for a step."
      "\n\ncoefficients: of the ship. rudder, heading, rate: positive. first: side turned to first. reversals: how "
      "many to "
      "sail for. Raises ValueError "
      "for an angle or a rate that is not positive.");

  using Loop = LoopMeasures<double>;
  Record<Loop>(m, "LoopMeasures", "Measures of the drift–yaw loop of a zigzag.")
      .field<&Loop::area>("area", "|∮ beta d(omega')| [rad].")
      .field<&Loop::length>("length", "Long axis.")
      .field<&Loop::width>("width", "Short axis.")
      .field<&Loop::inclination>("inclination", "Of the long axis from the beta axis towards omega' [rad].")
      .field<&Loop::beta_max>("beta_max", "Largest |beta| [rad].")
      .field<&Loop::omega_max>("omega_max", "Largest |omega'|.")
      .field<&Loop::omega_at_beta_zero>("omega_at_beta_zero", "|omega'| where beta passes zero.")
      .field<&Loop::beta_at_omega_zero>("beta_at_omega_zero", "|beta| where omega' passes zero [rad].")
      .field<&Loop::distance_from_line>("distance_from_line", "Root mean square from omega' = (Kw/Kb) beta.");
  m.def("drift_yaw_loop", &drift_yaw_loop, py::arg("coefficients"), py::arg("zigzag"),
        "The loop of the last full cycle of a zigzag; None with fewer than three reversals."
        "\n\ncoefficients: of the ship that sailed it. zigzag: of `linear_zigzag` or `limit_cycle`.");
  Record<LimitCycle>(m, "LimitCycle", "A zigzag sailed until each reversal repeats the one before.")
      .field<&LimitCycle::zigzag>("zigzag", "As sailed.")
      .field<&LimitCycle::settled>("settled", "Whether it repeats to 1e-12.");
  m.def(
      "limit_cycle",
      [order](const Coefficients& ship, double rudder, double heading, double rate, Side first) {
        return limit_cycle(ship, order(rudder, heading, rate, first, LinearZigzagOrder{}.reversals));
      },
      py::arg("coefficients"), py::arg("rudder"), py::arg("heading"), py::arg("rate"),
      py::arg("first") = Side::starboard, Unlocked(),
      "The zigzag sailed until it repeats."
      "\n\ncoefficients: of the ship. rudder, heading [rad]; rate: of the rudder in rad per ship length. first: side "
      "turned to first.");
  Record<LoopSensitivity>(m, "LoopSensitivity", "Loop and overshoots with exact derivatives by T3b and T3w.")
      .field<&LoopSensitivity::value>("value", "The loop.")
      .field<&LoopSensitivity::by_T3b>("by_T3b", "Its derivatives by T3b, the other indices held.")
      .field<&LoopSensitivity::by_T3w>("by_T3w", "By T3w.")
      .field<&LoopSensitivity::overshoot>("overshoot", "[rad], one for each reversal.")
      .field<&LoopSensitivity::overshoot_by_T3b>("overshoot_by_T3b", "Its derivatives.")
      .field<&LoopSensitivity::overshoot_by_T3w>("overshoot_by_T3w", "Its derivatives.")
      .field<&LoopSensitivity::period>("period", "[ship lengths]")
      .field<&LoopSensitivity::period_by_T3b>("period_by_T3b", "Its derivative.")
      .field<&LoopSensitivity::period_by_T3w>("period_by_T3w", "Its derivative.")
      .field<&LoopSensitivity::settled>("settled", "The loop is the limit cycle.");
  m.def(
      "loop_sensitivity",
      [order](const SteeringIndices<double>& indices, double rudder, double heading, double rate, Side first) {
        return loop_sensitivity(indices, order(rudder, heading, rate, first, LinearZigzagOrder{}.reversals));
      },
      py::arg("indices"), py::arg("rudder"), py::arg("heading"), py::arg("rate"), py::arg("first") = Side::starboard,
      Unlocked(),
      "Exact derivatives of loop and overshoots by T3b and T3w. Raises ValueError if T3b = T3w."
      "\n\nindices: of the ship. rudder, heading [rad]; rate: of the rudder in rad per ship length. first: side turned "
      "to first.");
}

// ---------------------------------------------------------------- frequency

RudderTransfer<double> transfer_to(const SwayYawTransfer<double>& h, const std::string& what) {
  if (what == "drift") return rudder_to_drift(h);
  if (what == "yaw") return rudder_to_yaw(h);
  if (what == "heading") return rudder_to_heading(h);
  throw std::domain_error(fmt::format("\"{}\" is none of drift, yaw, heading", what));
}

void add_frequency(py::module_& m) {
  m.def(
      "bode",
      [](const SwayYawTransfer<double>& h, const std::string& of, const Array& frequencies, const PrimeScale& scale) {
        std::vector<double> rad_s, gains, phases;
        for (const auto& point : bode(transfer_to(h, of), numbers_in(frequencies, "frequencies"), scale))
          rad_s.push_back(point.frequency_rad_s), gains.push_back(point.gain), phases.push_back(point.phase);
        py::dict result;
        result["frequency_rad_s"] = owned(std::move(rad_s)), result["gain"] = owned(std::move(gains));
        result["phase"] = owned(std::move(phases));
        return result;
      },
      py::arg("transfer"), py::arg("of"), py::arg("frequencies"), py::arg("scale"),
      "Bode diagram of \"drift\", \"yaw\" or \"heading\" over the rudder at frequencies in radians per ship length: "
      "arrays frequency_rad_s, gain, phase [rad, continuous]."
      "\n\ntransfer: of `transfer_functions`. of: over the rudder. frequencies: one array. scale: length and speed, "
      "which give rad/s.");
  m.def(
      "bandwidth",
      [](const SwayYawTransfer<double>& h, const std::string& of) { return bandwidth(transfer_to(h, of)); },
      py::arg("transfer"), py::arg("of"),
      "Frequency [radians per ship length] above which the gain stays below 1/√2 of the static one; None for the "
      "heading, a neutral ship and a gain of 0."
      "\n\ntransfer: of `transfer_functions`. of: \"drift\", \"yaw\" or \"heading\".");
  Record<Crossover>(m, "Crossover", "Where a helmsman's loop has gain 1.")
      .field<&Crossover::frequency>("frequency", "Radians per ship length.")
      .field<&Crossover::phase_margin>("phase_margin", "By which the phase of the loop is above -π [rad].");
  m.def("crossover", &crossover, py::arg("transfer"), py::arg("k"),
        "Crossover of the loop of a helmsman who orders delta = k (psi - wanted); None when the gain is nowhere 1."
        "\n\ntransfer: of `transfer_functions`. k: rudder per error of heading.");
}

}  // namespace

void add_linear_motion(py::module_& m) {
  add_response(m);
  add_zigzag(m);
  add_frequency(m);
}

}  // namespace swayaw::python
