#include "module.hpp"
#include "record.hpp"
#include "swayaw/nonlinear/equilibria.hpp"
#include "swayaw/nonlinear/manoeuvres/imo_criteria.hpp"
#include "swayaw/nonlinear/manoeuvres/index_slopes.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"

namespace swayaw::python {
namespace {

void add_imo(py::module_& m) {
  Record<Criterion>(m, "Criterion", "One number that must not be exceeded.")
      .field<&Criterion::name>("name", "\"tactical_diameter\"")
      .field<&Criterion::side>("side", "Turned to first.")
      .field<&Criterion::value>("value", "In `unit`; None where the manoeuvre did not come so far.")
      .field<&Criterion::limit>("limit", "In `unit`.")
      .field<&Criterion::unit>("unit", "\"L\", ship lengths, or \"deg\".")
      .field<&Criterion::pass>("passed", "None without a value.");
  Record<ImoCriteria>(m, "ImoCriteria", "Steering criteria of MSC.137(76), section 5.3, to both sides.")
      .field<&ImoCriteria::criteria>("criteria", "First of manoeuvres to starboard, then to port.")
      .field<&ImoCriteria::L>("length", "[m]")
      .field<&ImoCriteria::speed>("speed", "Test speed [m/s].")
      .field<&ImoCriteria::propulsion>("propulsion", "Held during the manoeuvres.");
  m.def(
      "imo_criteria",
      [](const Ship& ship, Maybe speed, Maybe rev, Maybe thrust) {
        return imo_criteria(ship, {.speed = speed, .rev = rev, .thrust = thrust, .duration = {}, .step = {}});
      },
      py::arg("ship"), py::kw_only(), py::arg("speed") = py::none(), py::arg("rev") = py::none(),
      py::arg("thrust") = py::none(), Unlocked(),
      "Turning circle and the zigzags 10/10 and 20/20, to both sides, judged by MSC.137(76); speed [m/s]."
      "\n\nship: of any nonlinear model. speed: of the approach, the service speed unless given. rev: shaft speed "
      "[1/s], or thrust: of all propellers [N]; self-propulsion unless given. Raises Refusal if she cannot propel "
      "herself at the speed.");
}

// ---------------------------------------------------------------- exact derivatives

/// Derivatives by index as arrays in the order of the parameters; None for an index that does not exist.
template <class Indices>
py::dict slopes_by_name(const Indices& slopes, const std::vector<Parameter>& parameters) {
  py::dict result;
  for (const auto& index : Indices::parameters()) {
    const auto& by_number = slopes.*index.member;
    if (by_number.empty()) {
      result[py::str(index.key)] = py::none();
      continue;
    }
    std::vector<double> values;
    for (std::size_t i = 0; i < parameters.size(); ++i) values.push_back(by_number[i] * parameters[i].si);
    result[py::str(index.key)] = owned(std::move(values));
  }
  return result;
}

/// Sails the manoeuvre of the order and takes its derivatives.
template <class Sail, class Order>
py::dict slopes(const Ship& ship, const Order& order, ManoeuvreOptions options, const std::vector<std::string>& names,
                const Sail& sail) {
  options.traced = true;
  const auto parameters = parameters_of(ship, names);
  const auto result = [&] {
    const py::gil_scoped_release unlocked;
    return index_slopes(ship, order, options, sail(ship, order, options), parameters);
  }();
  return slopes_by_name(result, parameters);
}

void add_slopes(py::module_& m) {
  m.def(
      "zigzag_slopes",
      [](const Ship& ship, double rudder, double heading, const std::vector<std::string>& parameters, Side first,
         Maybe speed) {
        return slopes(ship, ZigzagOrder{rudder, heading, first},
                      {.speed = speed, .rev = {}, .thrust = {}, .duration = {}, .step = {}}, parameters, zigzag);
      },
      py::arg("ship"), py::arg("rudder"), py::arg("heading"), py::arg("parameters"), py::arg("first") = Side::starboard,
      py::kw_only(), py::arg("speed") = py::none(),
      "Exact derivatives of the indices of a zigzag (SI) by parameters of the ship, in the units of her file: a "
      "dictionary from index to an array in the order of the names, None for an index that does not exist. Raises "
      "Refusal for a ship in wind or with effects other than a current."
      "\n\nship: of any nonlinear model. rudder, heading: angles [rad], positive. parameters: names. first: side "
      "turned to first. speed: of the approach [m/s], the service speed unless given.");
  m.def(
      "turning_circle_slopes",
      [](const Ship& ship, double rudder, const std::vector<std::string>& parameters, Side side, Maybe speed) {
        return slopes(ship, TurnOrder{rudder, side},
                      {.speed = speed, .rev = {}, .thrust = {}, .duration = {}, .step = {}}, parameters,
                      turning_circle);
      },
      py::arg("ship"), py::arg("rudder"), py::arg("parameters"), py::arg("side") = Side::starboard, py::kw_only(),
      py::arg("speed") = py::none(),
      "The same of a turning circle, told as of a turn to starboard."
      "\n\nship: of any nonlinear model. rudder: angle [rad], positive. parameters: by name. side: turned to. speed: "
      "of the approach [m/s], the service speed unless given.");
}

void add_curve(py::module_& m) {
  m.def(
      "steady_turn_curve",
      [](const Ship& ship, double largest, Maybe speed) {
        const double approach = speed.value_or(service_speed(ship));
        return steady_turn_curve(ship, self_propulsion(ship, approach), largest);
      },
      py::arg("ship"), py::arg("largest"), py::kw_only(), py::arg("speed") = py::none(), Unlocked(),
      "The r-delta curve through all its folds, up to that rudder angle [rad] on both sides, with the propulsion of "
      "that straight speed [m/s]."
      "\n\nship: of any nonlinear model. largest: rudder angle. speed: the service speed unless given.");
  m.def("instability_loop", &instability_loop, py::arg("curve"),
        "Hysteresis of a curve of steady turns; None where there is one turn at every rudder angle."
        "\n\ncurve: of `steady_turn_curve`, in its order.");
}

}  // namespace

void add_criteria(py::module_& m) {
  add_imo(m);
  add_slopes(m);
  add_curve(m);
}

}  // namespace swayaw::python
