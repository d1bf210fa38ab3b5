#include "module.hpp"
#include "record.hpp"
#include "swayaw/nonlinear/linearization.hpp"
#include "swayaw/nonlinear/manoeuvres/steady_run_in_wind.hpp"
#include "swayaw/nonlinear/models/force_breakdown.hpp"
#include "swayaw/nonlinear/replay.hpp"
#include "swayaw/nonlinear/simulator.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"

namespace swayaw::python {

template <>
struct Words<SimulatorState> : NamedWords<SimulatorState, 6, words_for> {};
template <>
struct Words<Shaft> {
  static std::vector<std::string> list() { return {"recorded", "self_propulsion"}; }
};
template <>
struct Words<Kept> {
  static std::vector<std::string> list() { return {"heading", "course"}; }
};

namespace {

// ---------------------------------------------------------------- replay

void add_replay(py::module_& m) {
  m.def(
      "replay",
      [](const Ship& ship, const Recording& run, Shaft shaft, double tolerance) {
        return replay(ship, run, {.shaft = shaft, .tolerance = tolerance});
      },
      py::arg("ship"), py::arg("run"), py::kw_only(), py::arg("shaft") = Shaft::recorded,
      py::arg("tolerance") = ReplayOptions{}.tolerance, Unlocked(),
      "The whole run simulated from its recorded start with the recorded rudder and shaft speed, sampled at the "
      "recorded times, in the wind and depth that were measured. shaft=\"self_propulsion\": with what carries the "
      "model "
      "at the recorded starting speed. Raises Refusal if the run does not tell rudder or speed."
      "\n\nship: who sails. run: a recording. shaft: \"recorded\" or \"self_propulsion\". tolerance: error of an "
      "integration step.");
  m.def("tells_propulsion", &tells_propulsion, py::arg("ship"), py::arg("run"),
        "Whether a run tells what propels the ship: her shaft speed, where her model takes one, or a thrust. The "
        "polynomial of an Abkowitz ship holds her propulsion."
        "\n\nship: who sails. run: a recording.");
  m.def(
      "assumed_propulsion",
      [](const Ship& ship, const std::vector<Recording>& runs) { return assumed_propulsion(ship, runs); },
      py::arg("ship"), py::arg("runs"),
      "What is assumed of those runs that do not tell what propels her, in words; empty where all do."
      "\n\nship: who sails. runs: recordings.");
  m.def("recorded_state", &recorded_state, py::arg("ship"), py::arg("run"), py::arg("time"), Unlocked(),
        "Recorded state of the ship through the water at a time [s]."
        "\n\nship: whose instruments and length count. run: a recording. time: within it. Raises Refusal if the run "
        "does not tell rudder or speed.");
}

// ---------------------------------------------------------------- forces

py::dict parts_of(std::span<const ForcePart<double>> parts) {
  py::dict forces;
  for (const auto& part : parts) forces[py::str(part.name)] = part.force;
  return forces;
}

void add_forces_of(py::module_& m) {
  py::class_<ForceBreakdown>(m, "ForceBreakdown", "Forces about midship, split by part, and what they do to the ship.")
      .def_property_readonly(
          "parts", [](const ForceBreakdown& f) { return parts_of(f.parts); },
          "hull, propeller, rudder, …, wind where there is some, and effects by their names: PlanarForce.")
      .def_readonly("total", &ForceBreakdown::total, "Drives the equations of motion of the model.")
      .def_readonly("acceleration", &ForceBreakdown::acceleration, "Of midship in body axes.");
  m.def(
      "force_breakdown", &force_breakdown, py::arg("ship"), py::arg("state"), py::arg("controls"), Unlocked(),
      "Which force acts here, and from which part? The rudder angle is that of the rudder. Raises Refusal if no force "
      "model holds for the motion or the controls."
      "\n\nship: of any nonlinear model. state: where she is and how she moves. controls: rudder angle and shaft speed "
      "or thrust. Forces are in N, moments about midship in N m.");
  m.def(
      "with_forces",
      [](Recording run, const Ship& ship) {
        add_forces(run, ship);
        return run;
      },
      py::arg("run"), py::arg("ship"), Unlocked(),
      "The run with forces by part as extra columns X_hull_N, Y_hull_N, N_hull_N_m, …"
      "\n\nship: of any nonlinear model. run: a recording; Refusal if it does not tell rudder or speed.");
}

// ---------------------------------------------------------------- linearization

/// Rows du/dt, dv/dt, dr/dt; columns from the first on.
py::array_t<double> columns_of(const AccelerationDerivatives& a, std::size_t first, std::size_t count) {
  py::array_t<double> result({std::size_t{3}, count});
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < count; ++k)
      result.mutable_at(static_cast<py::ssize_t>(i), static_cast<py::ssize_t>(k)) = a.d[i][first + k];
  return result;
}

void add_linearization(py::module_& m) {
  using Point = OperatingPoint;
  Record<Point>(m, "OperatingPoint", "A motion and the controls that keep it.", Made::by_anyone)
      .field<&Point::motion>("motion", "Through the water.")
      .field<&Point::controls>("controls", "Rudder and propulsion.");
  py::class_<Linearization>(m, "Linearization",
                            R"(Small motions about a steady one, by exact derivatives of the forces, SI:

    d(x)/dt = A x + B delta,   x = (u, v, r) less that of the operating point)")
      .def_property_readonly_static(
          "states", [](py::handle) { return py::make_tuple("u", "v", "r"); }, "Names of the rows of A and B.")
      .def_property_readonly_static("inputs", [](py::handle) { return py::make_tuple("delta"); })
      .def_property_readonly(
          "A", [](const Linearization& l) { return columns_of(l.whole, 0, 3); },
          "Derivatives of du/dt, dv/dt, dr/dt by u, v, r: numpy.ndarray, 3 by 3.")
      .def_property_readonly(
          "B", [](const Linearization& l) { return columns_of(l.whole, 3, 1); },
          "By the rudder angle, positive to port: numpy.ndarray, 3 by 1.")
      .def_property_readonly(
          "parts",
          [](const Linearization& l) {
            py::dict parts;
            for (const auto& part : l.parts)
              parts[py::str(part.name)] =
                  py::make_tuple(columns_of(part.derivatives, 0, 3), columns_of(part.derivatives, 3, 1));
            return parts;
          },
          "A and B of hull, propeller, rudder, …, centrifugal; they add up to the whole.")
      .def_readonly("point", &Linearization::point)
      .def_readonly("scale", &Linearization::scale, "Length, and speed of the operating point.")
      .def_readonly("poles", &Linearization::poles, "Of u, v and r together [1/s].")
      .def_property_readonly(
          "sway_yaw", [](const Linearization& l) { return sway_yaw(l.whole, l.scale); },
          "Coupled equations of drift and yaw at constant speed, SwayYawCoefficients.")
      .def_property_readonly(
          "sname", [](const Linearization& l) { return sname(l); },
          "Sway and yaw derivatives in ½ρL²U² and ½ρL³U², with the masses of the ship.");
  m.def(
      "linearize", &linearize, py::arg("ship"), py::arg("point"), py::arg("side") = py::none(), Unlocked(),
      "Linear motion about a steady motion. Where the forces have a kink, as the MMG rudder has straight ahead, the "
      "derivatives are those of a turn to `side`, or without a side the mean of both. Raises Refusal if the ship does "
      "not move ahead, or accelerates there by more than 1e-6 U²/L."
      "\n\nship: of any nonlinear model. point: of `straight_course`, or an OperatingPoint of a steady turn.");
  m.def("linearize_transient", &linearize_transient, py::arg("ship"), py::arg("point"), py::arg("side") = py::none(),
        Unlocked(),
        "The same about a motion that need not be steady: the derivatives hold while the motion is near it."
        "\n\nship: of any nonlinear model. point: an OperatingPoint. side: of the derivatives at a kink, else the mean "
        "of both.");
  m.def(
      "straight_course",
      [](const Ship& ship, Maybe speed) { return straight_course(ship, speed.value_or(service_speed(ship))); },
      py::arg("ship"), py::arg("speed") = py::none(), Unlocked(),
      "Straight ahead at that speed [m/s], the service speed unless given, with self-propulsion."
      "\n\nship: of any nonlinear model. speed: straight ahead. Raises Refusal if she cannot propel herself at it.");
  m.def("has_kink", &has_kink, py::arg("ship"), py::arg("point"), Unlocked(),
        "Whether the derivatives of turns to port and to starboard differ there."
        "\n\nship: of any nonlinear model. point: of `straight_course` or of a steady turn.");
  m.def("linear_ship", &linear_ship, py::arg("ship"), py::arg("linearization"), Unlocked(),
        "The ship in small motions about the operating point, in the form that the linear floor works with."
        "\n\nship: she who was linearized. linearization: of `linearize`.");
  Record<SteadyMotion>(m, "SteadyMotion", "A motion in which nothing changes but the place and the heading.")
      .field<&SteadyMotion::motion>("motion", "Through the water.")
      .field<&SteadyMotion::stable>("stable", "A small disturbance dies out.");
  m.def("steady_motion", &steady_motion, py::arg("ship"), py::arg("controls"), py::arg("guess"), Unlocked(),
        "The steady motion that Newton's method finds from the guess at constant controls; None where it does not."
        "\n\nship: of any nonlinear model. controls: rudder angle and shaft speed or thrust. guess: where the search "
        "begins.");
}

// ---------------------------------------------------------------- wind

void add_wind(py::module_& m) {
  Record<WindRun>(m, "WindRun", "A straight run in steady wind on which nothing changes but the place.")
      .field<&WindRun::motion>("motion", "Through the water; r = 0.")
      .field<&WindRun::psi>("psi", "Heading [rad].")
      .field<&WindRun::delta>("delta", "Helm, positive to port [rad].")
      .field<&WindRun::course>("course", "Over ground [rad].")
      .field<&WindRun::speed_over_ground>("speed_over_ground", "[m/s]")
      .field<&WindRun::wind_force>("wind_force", "[N], [N m]")
      .field<&WindRun::holds>("holds", "The helm is within the largest rudder angle.")
      .of()
      .def_property_readonly("leeway", &WindRun::leeway,
                             "Of the track through the water, positive to starboard of the heading [rad].");
  m.def(
      "steady_run_in_wind",
      [](const Ship& ship, double wind_speed, double wind_from, double direction, Kept kept) {
        return steady_run_in_wind(ship, ship.surroundings.windage, {wind_speed, wind_from},
                                  {.direction = direction, .kept = kept});
      },
      py::arg("ship"), py::arg("wind_speed"), py::arg("wind_from"), py::arg("direction") = 0.0,
      py::arg("kept") = Kept::course, Unlocked(),
      "The straight run in a true wind [m/s] from a direction [rad, clockwise from north] that keeps the course or the "
      "heading `direction` [rad]; None where no helm balances that wind."
      "\n\nship: of any nonlinear model. wind_speed, wind_from: the true wind. kept: \"course\" or \"heading\".");
}

// ---------------------------------------------------------------- real time

/// What the instruments show, by column; channels that the ship does not have are left out.
py::dict shown_by(const Simulator& ship) {
  const auto values = ship.instruments();
  py::dict shown;
  for (std::size_t i = 0; i < channel_count; ++i)
    if (!std::isnan(values[i])) shown[py::str(column_name(static_cast<Channel>(i)))] = values[i];
  return shown;
}

void add_simulator(py::module_& m) {
  py::class_<Simulator>(m, "Simulator",
                        R"(A ship in real time with all her effects: what a ship-handling simulator steps.

    ship = Simulator(published_ship("kvlcc2"))
    ship.order_rudder(math.radians(-20))
    ship.step(0.02)

Motion is through the water. Controls, wind, current and a force of the user's own are held until given anew; each raises
ValueError unless the numbers are finite. Steps are those of the classical Runge–Kutta method, none longer than
`longest_step` in L/U_0; the same calls give the same motion.)")
      .def(py::init([](const Ship& ship, double longest_step, Maybe speed) {
             return Simulator(ship, {.longest_step = longest_step, .speed = speed.value_or(0.0)});
           }),
           py::arg("ship"), py::kw_only(), py::arg("longest_step") = SimulatorOptions{}.longest_step,
           py::arg("speed") = py::none(),
           "At the origin on heading 0, straight ahead with the propulsion that carries her at that speed [m/s], the "
           "service speed unless given.")
      .def("step", &Simulator::step, py::arg("dt"), "Goes on by dt [s]; does nothing unless dt > 0.")
      .def("order_rudder", &Simulator::order_rudder, py::arg("angle"),
           "Rudder angle, positive to port [rad], through the steering gear.")
      .def("set_rudder", &Simulator::set_rudder, py::arg("angle"), "The indicator shows that angle [rad] at once.")
      .def("set_shaft_speed", &Simulator::set_shaft_speed, py::arg("rev"),
           "[1/s]. Raises Refusal where the model takes none.")
      .def("set_thrust", &Simulator::set_thrust, py::arg("thrust"),
           "Of all propellers [N], in place of a shaft speed. Raises Refusal where the model takes none.")
      .def(
          "set_wind",
          [](Simulator& s, double speed, double from) {
            s.set_wind({speed, from});
          },
          py::arg("speed"), py::arg("wind_from"),
          "True wind [m/s] and where it comes from, clockwise from north [rad]. Raises Refusal if nothing is known of "
          "what she shows the wind.")
      .def(
          "set_current",
          [](Simulator& s, double speed, double to) {
            s.set_current({speed, to});
          },
          py::arg("speed"), py::arg("to"),
          "Current [m/s] and where it runs to [rad]; the motion through the water stays as it is.")
      .def("set_added_force", &Simulator::set_added_force, py::arg("force"),
           "A force in body axes beside all others, about midship: tugs, lines, own waves.")
      .def("set_state", &Simulator::set_state, py::arg("state"), "Place, heading and motion through the water.")
      .def_property_readonly("time", &Simulator::time, "Since the beginning [s].")
      .def_property_readonly(
          "state", [](const Simulator& s) { return s.state(); }, "The motion is through the water: ShipState.")
      .def_property_readonly("velocity_over_ground", &Simulator::velocity_over_ground)
      .def_property_readonly("heel", &Simulator::heel, "Starboard side down [rad]; 0 without roll coupling.")
      .def_property_readonly("rudder", &Simulator::rudder, "Angle of the rudder, positive to port [rad].")
      .def_property_readonly("rudder_shown", &Simulator::rudder_shown, "Angle that the indicator shows [rad].")
      .def_property_readonly("shaft_speed", &Simulator::shaft_speed, "As ordered [1/s].")
      .def_property_readonly("thrust", &Simulator::thrust,
                             "Of all propellers [N]; NaN where the model does not tell it.")
      .def_property_readonly(
          "forces", [](const Simulator& s) { return parts_of(s.forces()); }, "By part: PlanarForce.")
      .def_property_readonly("instruments", &shown_by, "What the instruments show, by column.")
      .def_property_readonly("valid", &Simulator::valid, "Whether the force model holds where the ship is.")
      .def_property_readonly("why", &Simulator::why, "Else what carries it on, in words.");
}

}  // namespace

void add_motion(py::module_& m) {
  add_replay(m);
  add_forces_of(m);
  add_linearization(m);
  add_wind(m);
  add_simulator(m);
}

}  // namespace swayaw::python
