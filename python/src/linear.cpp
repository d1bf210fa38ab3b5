#include "module.hpp"
#include "record.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/followed_order.hpp"
#include "swayaw/core/steering_gear.hpp"
#include "swayaw/linear/dimensional.hpp"
#include "swayaw/linear/indices.hpp"
#include "swayaw/linear/inversion.hpp"
#include "swayaw/linear/linear_ship_file.hpp"
#include "swayaw/linear/ship_parts.hpp"
#include "swayaw/linear/sname.hpp"

namespace swayaw::python {

template <>
struct Words<KnownPart> : NamedWords<KnownPart, 5, name_of> {};

namespace {

using Coefficients = SwayYawCoefficients<double>;
using Transfer = SwayYawTransfer<double>;
using Indices = SteeringIndices<double>;
using Sname = SnameDerivatives<double>;
using Parts = LinearParts<double>;
using Hull = LinearHull<double>;
using Rudder = LinearRudder<double>;

void add_equations(py::module_& m) {
  Record<Coefficients>(m, "SwayYawCoefficients",
                       R"(Linear sway–yaw equations at constant speed, dimensionless time s' = tU/L:

    d(beta)/ds'   = a1 beta + b1 omega' + c1 delta
    d(omega')/ds' = a2 beta + b2 omega' + c2 delta

beta drift angle [rad], omega' = rL/U, delta rudder angle positive to port [rad]. Source: [Artyszuk2016] eq. (1))",
                       Made::by_anyone)
      .field<&Coefficients::a1>("a1", "Drift by drift.")
      .field<&Coefficients::b1>("b1", "Drift by yaw.")
      .field<&Coefficients::c1>("c1", "Drift by rudder.")
      .field<&Coefficients::a2>("a2", "Yaw by drift.")
      .field<&Coefficients::b2>("b2", "Yaw by yaw.")
      .field<&Coefficients::c2>("c2", "Yaw by rudder.")
      .of()
      .def_property_readonly("stable", &is_stable<double>, "Both poles lie in the left half-plane.")
      .def_property_readonly("complex_poles", &has_complex_poles<double>, "The poles are a complex pair.");
  Record<Transfer>(m, "SwayYawTransfer", R"(Laplace transforms of drift and yaw over that of the rudder:

    beta/delta   = (nb1 s + nb0) / (s² + e1 s + e0)
    omega'/delta = (nw1 s + nw0) / (s² + e1 s + e0)

Regular for every ship: stable, unstable, neutral, complex poles, Kb = 0 or Kw = 0.)",
                   Made::by_anyone)
      .field<&Transfer::e0>("e0", "1/(T1 T2)")
      .field<&Transfer::e1>("e1", "(T1 + T2)/(T1 T2)")
      .field<&Transfer::nb0>("nb0", "Kb/(T1 T2)")
      .field<&Transfer::nb1>("nb1", "Kb T3b/(T1 T2)")
      .field<&Transfer::nw0>("nw0", "Kw/(T1 T2)")
      .field<&Transfer::nw1>("nw1", "Kw T3w/(T1 T2)");
  Record<Indices>(m, "SteeringIndices", R"(Indices of the second-order equations of drift and yaw, dimensionless:

    T1 T2 d²(omega')/ds'² + (T1 + T2) d(omega')/ds' + omega' = Kw (delta + T3w d(delta)/ds'),   beta with Kb and T3b

Kb and Kw are negative for a stable ship, since a rudder angle to port is positive. Source: [Artyszuk2016] eqs (15), (16))",
                  Made::by_anyone)
      .field<&Indices::T1T2>("T1T2", "Product of the time constants.")
      .field<&Indices::T1_plus_T2>("T1_plus_T2", "Their sum.")
      .field<&Indices::T3b>("T3b", "Rudder-rate time constant of drift.")
      .field<&Indices::T3w>("T3w", "Rudder-rate time constant of yaw.")
      .field<&Indices::Kb>("Kb", "Gain of drift.")
      .field<&Indices::Kw>("Kw", "Gain of yaw.");
  using Constants = TimeConstants<double>;
  Record<Constants>(m, "TimeConstants", "T1 and T2, real.", Made::by_anyone)
      .field<&Constants::T1>("T1", "Of the slower mode, negative for an unstable ship.")
      .field<&Constants::T2>("T2", "Of the faster mode.");
  using First = FirstOrder<double>;
  Record<First>(m, "FirstOrder", "Nomoto's first-order equation T d(omega')/ds' + omega' = K delta.", Made::by_anyone)
      .field<&First::K>("K", "Gain.")
      .field<&First::T>("T", "Time constant.");
}

void add_conversions(py::module_& m) {
  m.def("transfer_functions", py::overload_cast<const Coefficients&>(&transfer_functions<double>),
        py::arg("coefficients"),
        "Transfer functions of the coupled equations."
        "\n\ncoefficients: a1 to c2.");
  m.def("transfer_functions", py::overload_cast<const Indices&>(&transfer_functions<double>), py::arg("indices"),
        "Transfer functions with given indices."
        "\n\nindices: of `steering_indices`.");
  m.def("steering_indices", py::overload_cast<const Coefficients&>(&steering_indices<double>), py::arg("coefficients"),
        "Steering indices of the coupled equations. Source: [Artyszuk2016] eqs (17)–(24). Infinite or not a number for "
        "a neutral ship, or where Kb or Kw is 0."
        "\n\ncoefficients: a1 to c2.");
  m.def("steering_indices", py::overload_cast<const Transfer&>(&steering_indices<double>), py::arg("transfer"),
        "Steering indices of transfer functions."
        "\n\ntransfer: of `transfer_functions`.");
  m.def(
      "coefficients_from", py::overload_cast<const Indices&>(&coefficients_from<double>), py::arg("indices"),
      "Coupled equations with given indices, the inverse of steering_indices. Infinite or not a number for T3b = T3w. "
      "Source: [Artyszuk2016] eqs (29)–(34)");
  m.def("coefficients_from", py::overload_cast<const Transfer&>(&coefficients_from<double>), py::arg("transfer"),
        "Coupled equations with given transfer functions, the inverse of transfer_functions.");
  m.def(
      "time_constants", [](const Transfer& h) { return time_constants(h); }, py::arg("transfer"),
      "T1 and T2; None when they are a complex pair."
      "\n\ntransfer: of `transfer_functions`; dimensionless.");
  m.def(
      "time_constants", [](const Coefficients& c) { return time_constants(transfer_functions(c)); },
      py::arg("coefficients"),
      "T1 and T2; None when they are a complex pair."
      "\n\ncoefficients: a1 to c2; dimensionless.");
  m.def("first_order_drift", &first_order_drift<double>, py::arg("indices"),
        "First-order equation with T_b = T1 + T2 - T3b. Source: [Artyszuk2016] eq. (41)"
        "\n\nindices: T1T2, T1_plus_T2, T3b … of `steering_indices`.");
  m.def("first_order_yaw", &first_order_yaw<double>, py::arg("indices"),
        "First-order equation with T_w = T1 + T2 - T3w. Source: [Artyszuk2016] eq. (42)"
        "\n\nindices: T1T2, T1_plus_T2, T3w … of `steering_indices`.");
  m.def("condition_number", &condition_number, py::arg("coefficients"),
        "How much accuracy the conversion between coefficients and indices can lose; infinite where there is none."
        "\n\ncoefficients: a1 to c2; the number is that of the matrix [c w] of docs/linear.md.");
  m.def("inverse_distance", &inverse_distance<double>, py::arg("indices"),
        "|T3b - T3w|/(|T3b| + |T3w|), 0 where no inverse exists."
        "\n\nindices: whose T3b and T3w are looked at.");
}

void add_dimension(py::module_& m) {
  Record<PrimeScale>(m, "PrimeScale", "Length and speed that make quantities dimensionless: s' = tU/L, omega' = rL/U.",
                     Made::by_anyone)
      .field<&PrimeScale::L>("L", "[m]")
      .field<&PrimeScale::U>("U", "[m/s]");
  using D = DimensionalIndices<double>;
  Record<D>(m, "DimensionalIndices", "Steering indices with dimension.", Made::by_anyone)
      .field<&D::T1T2_s2>("T1T2_s2", "[s²]")
      .field<&D::T1_plus_T2_s>("T1_plus_T2_s", "[s]")
      .field<&D::T3b_s>("T3b_s", "[s]")
      .field<&D::T3w_s>("T3w_s", "[s]")
      .field<&D::Kb>("Kb", "[-]")
      .field<&D::Kr_per_s>("Kr_per_s", "Yaw rate per rudder angle [1/s].");
  using S = DimensionalSwayYaw<double>;
  Record<S>(m, "DimensionalSwayYaw", R"(The coupled equations in seconds, for v = -U beta and r:

    dv/dt = v_v v + v_r r + v_delta delta,   dr/dt = r_v v + r_r r + r_delta delta)",
            Made::by_anyone)
      .field<&S::v_v>("v_v", "[1/s]")
      .field<&S::v_r>("v_r", "[m/s]")
      .field<&S::v_delta>("v_delta", "[m/s²]")
      .field<&S::r_v>("r_v", "[1/(m s)]")
      .field<&S::r_r>("r_r", "[1/s]")
      .field<&S::r_delta>("r_delta", "[1/s²]");
  m.def(
      "dimensional", [](const Indices& i, const PrimeScale& scale) { return dimensional(i, scale); },
      py::arg("indices"), py::arg("scale"),
      "With dimension: T = T' L/U, Kr = Kw U/L.\n\nindices: dimensionless. scale: length and speed.");
  m.def(
      "dimensional", [](const Coefficients& c, const PrimeScale& scale) { return dimensional(c, scale); },
      py::arg("coefficients"), py::arg("scale"),
      "With dimension: the coupled equations for v and r in seconds.\n\ncoefficients: dimensionless. scale: length and "
      "speed.");
  m.def(
      "to_prime", [](const D& i, const PrimeScale& scale) { return to_prime(i, scale); }, py::arg("indices"),
      py::arg("scale"),
      "The inverse of dimensional."
      "\n\nindices: with dimension. scale: length and speed.");
  m.def(
      "to_prime", [](const S& c, const PrimeScale& scale) { return to_prime(c, scale); }, py::arg("equations"),
      py::arg("scale"),
      "The inverse of dimensional."
      "\n\nequations: with dimension. scale: length and speed.");
}

void add_sname(py::module_& m) {
  Record<Sname>(m, "SnameDerivatives", R"(Linear derivatives in the SNAME form, all primed in one system:

    (m' - Y_vdot) dv'/ds' + (m' x_G - Y_rdot) dr'/ds' = Y_v v' + (Y_r - m') r' + Y_delta delta
    (m' x_G - N_vdot) dv'/ds' + (I_z - N_rdot) dr'/ds' = N_v v' + (N_r - m' x_G) r' + N_delta delta

about midship, v' = v/U = -beta, r' = omega'.)",
                Made::by_anyone)
      .field<&Sname::m>("m", "Mass.")
      .field<&Sname::x_G>("x_G", "Centre of gravity forward of midship over length.")
      .field<&Sname::I_z>("I_z", "Moment of inertia about midship.")
      .field<&Sname::Y_vdot>("Y_vdot", "Added mass.")
      .field<&Sname::Y_rdot>("Y_rdot", "Added mass.")
      .field<&Sname::N_vdot>("N_vdot", "Added mass.")
      .field<&Sname::N_rdot>("N_rdot", "Added mass.")
      .field<&Sname::Y_v>("Y_v", "Sway.")
      .field<&Sname::Y_r>("Y_r", "Sway.")
      .field<&Sname::Y_delta>("Y_delta", "Sway.")
      .field<&Sname::N_v>("N_v", "Yaw.")
      .field<&Sname::N_r>("N_r", "Yaw.")
      .field<&Sname::N_delta>("N_delta", "Yaw.");
  const auto convention = [](Side positive_to) {
    return positive_to == Side::port ? RudderConvention::positive_to_port : RudderConvention::positive_to_starboard;
  };
  m.def(
      "coefficients_of",
      [convention](const Sname& d, Side rudder_positive) { return coefficients(d, convention(rudder_positive)); },
      py::arg("derivatives"), py::arg("rudder_positive") = Side::port,
      "Coefficients of the coupled equations, A = M⁻¹F with the signs of v' = -beta. rudder_positive: side to which "
      "the "
      "rudder angle of the derivatives turns the ship."
      "\n\nderivatives: SnameDerivatives.");
  m.def(
      "sname_derivatives",
      [convention](const Coefficients& c, const Sname& inertia, Side rudder_positive) {
        return sname_derivatives(c, inertia, convention(rudder_positive));
      },
      py::arg("coefficients"), py::arg("inertia"), py::arg("rudder_positive") = Side::port,
      "The derivatives that give the coefficients, with mass, inertia and added masses as in `inertia`; F = M A."
      "\n\ncoefficients: a1 to c2. inertia: SnameDerivatives. rudder_positive: side to which the rudder angle of the "
      "derivatives turns the ship.");
}

// ---------------------------------------------------------------- hull and rudder

void add_parts(py::module_& m) {
  Record<Hull>(m, "LinearHull", "Hull of a ship in linear motion, dimensionless. Source: [Artyszuk2016] eqs (2)–(14)",
               Made::by_anyone)
      .field<&Hull::L_over_B>("L_over_B", "Length over beam.")
      .field<&Hull::c_B>("c_B", "Block coefficient.")
      .field<&Hull::k_11>("k_11", "Surge added mass over mass.")
      .field<&Hull::k_22>("k_22", "Sway added mass over mass.")
      .field<&Hull::r_z>("r_z", "Radius of gyration over length.")
      .field<&Hull::r_66>("r_66", "Added radius of gyration over length.")
      .field<&Hull::Y_b>("Y_b", "Sway force by drift, per degree, ½ρLTV².")
      .field<&Hull::Y_w>("Y_w", "Sway force by omega', ½ρLTV².")
      .field<&Hull::N_b>("N_b", "Yaw moment by drift, per degree, ½ρL²TV².")
      .field<&Hull::N_w>("N_w", "Yaw moment by omega', ½ρL²TV².");
  Record<Rudder>(m, "LinearRudder", "Rudder of a ship in linear motion, dimensionless.", Made::by_anyone)
      .field<&Rudder::area_ratio>("area_ratio", "A_R/(LT)")
      .field<&Rudder::w>("w", "Wake fraction.")
      .field<&Rudder::c_Th>("c_Th", "Thrust loading 8 K_T/(π J²).")
      .field<&Rudder::lift_slope>("lift_slope", "d(c_L)/d(alpha) on the race speed, per degree.")
      .field<&Rudder::a_H>("a_H", "Hull's share of the rudder force.")
      .field<&Rudder::c_Ry>("c_Ry", "Effective over geometric drift angle at the rudder.")
      .field<&Rudder::x_Reff>("x_Reff", "Where the rudder force acts, forward of midship over length.");
  Record<Parts>(m, "LinearParts", "A ship in linear motion, as hull and rudder.", Made::by_anyone)
      .field<&Parts::hull>("hull", "Hull.")
      .field<&Parts::rudder>("rudder", "Rudder.");
  using Split = SwayYawSplit<double>;
  Record<Split>(m, "SwayYawSplit", "The coefficients split by what they come from.")
      .field<&Split::hull>("hull", "Of the hull.")
      .field<&Split::rudder>("rudder", "Of the rudder.")
      .field<&Split::centrifugal>("centrifugal", "Of the centrifugal force.")
      .of()
      .def_property_readonly("total", &Split::total, "Their sum.");
  m.def(
      "coefficients_of", [](const Parts& parts) { return coefficients(parts); }, py::arg("parts"),
      "Coefficients from hull and rudder, split by what they come from. Source: [Artyszuk2016] eqs (3)–(14)"
      "\n\nparts: LinearParts, hull and rudder.");
  m.def(
      "parts_from",
      [](const Coefficients& c, const Parts& ship, KnownPart known) { return parts_from(c, ship, known); },
      py::arg("coefficients"), py::arg("ship"), py::arg("known"),
      "Hull and rudder that have given coefficients. c1 gives a_H, c2/c1 gives x_Reff; the known number, one of Y_b, "
      "Y_w, N_b, N_w, c_Ry, closes a1, b1, a2, b2 for the other four. Source: [Artyszuk2016] eqs (44)–(46)"
      "\n\ncoefficients: given. ship: LinearParts, whose other numbers stay. known: the number that is known. Raises "
      "Refusal where no hull has them.");
}

// ---------------------------------------------------------------- ships

py::object form_of(const LinearShip& ship) {
  return std::visit([](const auto& form) { return py::cast(form); }, ship.form);
}

void add_linear_ship(py::module_& m) {
  using Gear = SteeringGear<double>;
  Record<Gear>(m, "SteeringGear", "How the rudder follows its order.", Made::by_anyone)
      .field<&Gear::rate>("rate", "Largest rate [rad/s].")
      .field<&Gear::max_angle>("max_angle", "[rad]")
      .optional<&Gear::lag>("lag", "T [s], 0 for a rudder that keeps its rate until it arrives.")
      .optional<&Gear::dead_band>("dead_band", "[rad], 0 for none.");
  m.def("with_followed_order", &with_followed_order, py::arg("run"), py::arg("gear"),
        "A run that tells the ordered rudder angle alone, with that of a rudder that follows it, as fit_linear needs; "
        "any other run as it is."
        "\n\nrun: a recording. gear: SteeringGear.");
  py::class_<LinearShip>(m, "LinearShip", "A ship in linear motion.")
      .def(
          py::init([](std::string name, double length, double service_speed, const LinearForm& form,
                      const std::optional<Gear>& gear) {
            return LinearShip{.name = std::move(name),
                              .particulars = {length, service_speed},
                              .steering_gear = gear.value_or(Gear{radians(2.3), radians(35.0), 0.0, 0.0}),
                              .form = form,
                              .confidence = {}};
          }),
          py::arg("name"), py::arg("length"), py::arg("service_speed"), py::arg("form"),
          py::arg("steering_gear") = py::none(),
          "Length [m], service speed [m/s], and LinearParts, SwayYawCoefficients or SteeringIndices. The steering gear "
          "turns by 2.3 deg/s up to 35 deg unless given.")
      .def_readwrite("name", &LinearShip::name)
      .def_property_readonly(
          "length", [](const LinearShip& s) { return s.particulars.L; }, "[m]")
      .def_property_readonly(
          "service_speed", [](const LinearShip& s) { return s.particulars.U_0; }, "[m/s]")
      .def_readonly("steering_gear", &LinearShip::steering_gear)
      .def_property_readonly("form", &form_of, "LinearParts, SwayYawCoefficients or SteeringIndices.")
      .def_property_readonly(
          "coefficients", [](const LinearShip& s) { return coefficients(s); },
          "Of the coupled equations. Raises Refusal where there are none.")
      .def_property_readonly(
          "indices", [](const LinearShip& s) { return indices(s); }, "Steering indices.")
      .def_property_readonly(
          "transfer_functions", [](const LinearShip& s) { return transfer_functions(s); },
          "Every linear ship has them.")
      .def("scale", &prime_scale, py::arg("speed"), "Length of the ship and a speed [m/s].")
      .def("text", py::overload_cast<const LinearShip&, std::string_view>(&ship_text), py::arg("remark") = "",
           "The text of her ship file.")
      .def(
          "save",
          [](const LinearShip& ship, const std::filesystem::path& file, std::string_view remark) {
            write_linear_ship(file, ship, remark);
          },
          py::arg("file"), py::arg("remark") = "", "Writes her ship file, whole or not at all.")
      .def("__eq__", [](const LinearShip& a, const LinearShip& b) { return ship_text(a) == ship_text(b); })
      .def("__hash__", [](const LinearShip& ship) { return std::hash<std::string>()(ship_text(ship)); })
      .def(py::pickle([](const LinearShip& ship) { return ship_text(ship); },
                      [](const std::string& text) { return parse_linear_ship(text, "pickled ship"); }));
  m.def("parse_linear_ship", &parse_linear_ship, py::arg("text"), py::arg("name") = "ship",
        "A linear ship from the text of a ship file; `name` stands for the file in messages."
        "\n\ntext: of a ship file. name: of the file. Raises FileError \"NAME:LINE:COLUMN: what is wrong\".");
  m.def("read_linear_ship", &read_linear_ship, py::arg("file"),
        "A linear ship from a ship file."
        "\n\nfile: of the model \"linear\". Raises FileError \"FILE:LINE:COLUMN: what is wrong\".");
}

// ---------------------------------------------------------------- inversion

/// d ln(result)/d ln(input) by result and input.
template <std::size_t Count>
py::dict elasticities(const std::array<InvertedNumber, Count>& numbers) {
  py::dict result;
  for (const auto& number : numbers) {
    py::dict by_input;
    for (std::size_t i = 0; i < inversion_inputs.size(); ++i)
      by_input[py::str(inversion_inputs[i])] = number.elasticity[i];
    result[py::str(number.name)] = by_input;
  }
  return result;
}

void add_inversion(py::module_& m) {
  m.def(
      "coefficient_elasticities",
      [](const Coefficients& c) { return elasticities(inverted_coefficients(c, steering_indices(c))); },
      py::arg("coefficients"),
      "Exact d ln(a1 … c2)/d ln(T1, T2, T3b, T3w, Kb, Kw): a dictionary of dictionaries, NaN where there is none."
      "\n\ncoefficients: a1 to c2.");
  m.def(
      "part_elasticities",
      [](const Coefficients& c, const Parts& formal, KnownPart known) {
        return elasticities(inverted(c, steering_indices(c), formal, known).parts);
      },
      py::arg("coefficients"), py::arg("ship"), py::arg("known"),
      "The same of hull and rudder, by the indices and the known number."
      "\n\ncoefficients: given. ship: LinearParts, whose other numbers stay. known: the known number.");
}

}  // namespace

void add_linear(py::module_& m) {
  add_equations(m);
  add_conversions(m);
  add_dimension(m);
  add_sname(m);
  add_parts(m);
  add_linear_ship(m);
  add_inversion(m);
}

}  // namespace swayaw::python
