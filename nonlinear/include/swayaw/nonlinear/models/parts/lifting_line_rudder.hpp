#pragma once

#include <array>

#include "swayaw/core/parameter.hpp"
#include "swayaw/core/scalar.hpp"
#include "swayaw/nonlinear/models/parts/rudder_lift_loss.hpp"

namespace swayaw::inline nonlinear {

/// The semi-empirical rudder of the physics-informed model: a lifting line in the race of its propeller.
///
/// One rudder on the centre line or one behind each of two propellers; areas are those of one rudder.
/// Source: [Alexandersson2024] section 2.2, appendix B.2, table 5
template <class S = double>
struct LiftingLineRudder {
  S A_R;                     ///< area [m^2]
  S A_RC;                    ///< area in the race [m^2]
  S A_RU;                    ///< area outside the race [m^2]; 0: the rest, A_R − A_RC
  S b_R;                     ///< span [m]
  S c_r, c_t;                ///< chord at root and tip [m]
  S AR_factor;               ///< effective over geometric aspect ratio: 2 where the hull mirrors the rudder
  S Omega;                   ///< sweep of the quarter chord [rad]
  S x_R;                     ///< forward of midship [m]
  S y_R_port;                ///< port rudder, positive to starboard [m]; 0 leaves the twin-screw terms out
  S y_R_starboard;           ///< starboard rudder [m]
  S x;                       ///< from propeller to rudder [m]
  S gamma_0_port;            ///< inflow on a straight course, port rudder [rad]
  S gamma_0_starboard;       ///< starboard rudder [rad]
  S kappa_v, kappa_v_gamma;  ///< flow straightening of v, and its growth with |gamma_g|
  S kappa_r, kappa_r_gamma;  ///< flow straightening of r, and its growth with |gamma_g|
  S delta_lim;               ///< rudder angle beyond which the gap to the horn opens [rad]
  S s;                       ///< strength of the gap, negative [1/rad^2]
  S alpha_s = S(0.0);        ///< angle of attack at which the rudder stalls [rad], 0 for none; see stall_factor
  S stall_depth = S(0.5);
  S stall_width = S(0.05);  ///< [rad]
  S lift_factor = S(1.0);   ///< on the lift
  S e_0;                    ///< Oswald efficiency
  S C_D_tune;               ///< factor on induced drag
  S C_D0_tune;              ///< factor on drag without lift; goes with the friction line
  S a_H;                    ///< Y_RHI/Y_R
  S x_H;                    ///< N_RHI/N_R, a ratio and no lever
  Selection kind;
  Selection friction_line;
  Selection gap_factor;

  bool ittc57() const { return friction_line.index == 1; }
  bool gap_clipped() const { return gap_factor.index == 1; }

  Stall<S> stall() const { return {alpha_s, stall_depth, stall_width}; }

  static constexpr auto parameters() {
    using R = LiftingLineRudder;
    using P = ParameterOf<R, S>;
    constexpr auto fact = [](std::string_view key, S R::*member, Range range, std::string_view unit = "m") {
      return P{.key = key, .member = member, .unit = unit, .range = range};
    };
    constexpr auto coefficient = [](std::string_view key, S R::*member, Range range = any_number,
                                    std::string_view unit = "-") {
      return P{.key = key, .member = member, .unit = unit, .range = range, .role = Role::coefficient};
    };
    constexpr auto optional = [](P p, double fallback = 0.0) {
      p.required = false;
      p.fallback = fallback;
      return p;
    };
    return std::array{
        fact("area_m2", &R::A_R, positive, "m2"),
        fact("area_covered_m2", &R::A_RC, non_negative, "m2"),
        optional(fact("area_uncovered_m2", &R::A_RU, positive, "m2")),
        fact("span_m", &R::b_R, positive),
        fact("chord_root_m", &R::c_r, positive),
        fact("chord_tip_m", &R::c_t, positive),
        optional(coefficient("aspect_ratio_factor", &R::AR_factor, positive), 2.0),
        optional(fact("sweep_rad", &R::Omega, {-1.0, 1.0}, "rad")),
        fact("x_m", &R::x_R, any_number),
        optional(fact("y_m[0]", &R::y_R_port, {.high = 0.0})),
        optional(fact("y_m[1]", &R::y_R_starboard, non_negative)),
        fact("propeller_distance_m", &R::x, non_negative),
        optional(coefficient("inflow_angle_rad[0]", &R::gamma_0_port, {-1.0, 1.0}, "rad")),
        optional(coefficient("inflow_angle_rad[1]", &R::gamma_0_starboard, {-1.0, 1.0}, "rad")),
        coefficient("kappa_v", &R::kappa_v),
        optional(coefficient("kappa_v_gamma", &R::kappa_v_gamma)),
        coefficient("kappa_r", &R::kappa_r),
        optional(coefficient("kappa_r_gamma", &R::kappa_r_gamma)),
        optional(fact("gap_angle_rad", &R::delta_lim, non_negative, "rad")),
        optional(coefficient("gap_strength", &R::s, {.high = 0.0}, "1/rad2")),
        optional(coefficient("stall_angle_rad", &R::alpha_s, non_negative, "rad")),
        optional(coefficient("stall_depth", &R::stall_depth, {0.0, 1.0}), 0.5),
        optional(coefficient("stall_width_rad", &R::stall_width, positive, "rad"), 0.05),
        optional(coefficient("lift_factor", &R::lift_factor, positive), 1.0),
        optional(coefficient("oswald_efficiency", &R::e_0, positive), 0.9),
        optional(coefficient("drag_factor", &R::C_D_tune, non_negative), 1.0),
        optional(coefficient("zero_lift_drag_factor", &R::C_D0_tune, non_negative), 1.0),
        coefficient("a_H", &R::a_H),
        coefficient("x_H", &R::x_H),
    };
  }

  static constexpr auto choices() {
    using C = Choice<LiftingLineRudder>;
    return std::array{
        C{"kind", &LiftingLineRudder::kind, {"lifting_line"}},
        C{"friction_line", &LiftingLineRudder::friction_line, {"published", "ittc57"}},
        C{"gap_factor", &LiftingLineRudder::gap_factor, {"published", "clipped"}},
    };
  }
};

}  // namespace swayaw::nonlinear
