#pragma once

#include <array>
#include <nlohmann/json.hpp>

#include "files.hpp"
#include "json.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/linear/indices.hpp"
#include "swayaw/linear/ship_parts.hpp"
#include "swayaw/linear/zigzag.hpp"

/// The chemical tanker of Artyszuk 2016 as printed, and the reference numbers of the paper.
namespace swayaw::test {

/// tests/golden/artyszuk_linear.json
inline const nlohmann::json& reference() {
  static const auto all = json_in(golden / "artyszuk_linear.json").at("artyszuk");
  return all;
}

/// The printed time constants and gains of table 3, with variations of T3b and T3w.
inline SteeringIndices<double> printed_indices(double T3b = 0.154, double T3w = 0.983) {
  return {.T1T2 = 10.491 * 0.298, .T1_plus_T2 = 10.491 + 0.298, .T3b = T3b, .T3w = T3w, .Kb = -3.464, .Kw = -4.896};
}

inline SwayYawCoefficients<double> coefficients_of(const nlohmann::json& j) {
  return {j.at("a1"), j.at("b1"), j.at("c1"), j.at("a2"), j.at("b2"), j.at("c2")};
}

inline LinearParts<double> parts_of(const nlohmann::json& t) {
  return {.hull = {t.at("LB"), t.at("cB"), t.at("k11"), t.at("k22"), t.at("rz"), t.at("r66"), t.at("Yb"), t.at("Yw"),
                   t.at("Nb"), t.at("Nw")},
          .rudder = {t.at("AR"), t.at("w"), t.at("cTh"), t.at("cLa"), t.at("aH"), t.at("cRy"), t.at("xR")}};
}

/// Hull and rudder of table 1.
inline LinearParts<double> printed_table_1() { return parts_of(reference().at("table1_input")); }

/// What may be known of hull and rudder, with its key in the reference.
inline constexpr std::array<std::pair<const char*, KnownPart>, 5> known_parts{{{"Yb", KnownPart::Y_b},
                                                                               {"Yw", KnownPart::Y_w},
                                                                               {"Nb", KnownPart::N_b},
                                                                               {"Nw", KnownPart::N_w},
                                                                               {"cRy", KnownPart::c_Ry}}};

/// The 10/10 zigzag of the paper at degrees per second; she sails a length in 13.39 s.
inline LinearZigzagOrder ten_ten(double rate_deg_s = 2.5, Side first = Side::port) {
  return {.rudder = radians(10), .heading = radians(10), .rate = radians(rate_deg_s) * 13.39, .first = first};
}

}  // namespace swayaw::test
