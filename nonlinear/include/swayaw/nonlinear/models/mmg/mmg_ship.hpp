#pragma once

#include <array>
#include <cstddef>
#include <tuple>

#include "swayaw/core/parameter.hpp"
#include "swayaw/core/steering_gear.hpp"
#include "swayaw/nonlinear/models/parts/rudder_lift_loss.hpp"

/// The numbers of a ship in the MMG standard model, part by part.
///
/// Hull primes refer to ½ρLdU² (force) and ½ρL²dU² (moment), added masses to ½ρL²d and ½ρL⁴d, lengths
/// to L. Coefficients keep the rudder sign of that standard, positive to starboard; the force
/// functions in mmg_forces.hpp take the angle positive to port, as everywhere in swayaw.
///
/// Source: [Yasukawa2015] eqs (4)–(24)
namespace swayaw::inline nonlinear {

template <class S = double>
struct Water {
  S rho;  ///< density [kg/m^3]

  static constexpr auto parameters() {
    return std::array{ParameterOf<Water, S>{"density_kg_m3", &Water::rho, "kg/m3", positive}};
  }
};

template <class S = double>
struct MmgParticulars {
  S L;          ///< length between perpendiculars [m]
  S B;          ///< beam [m]
  S d;          ///< draught [m]
  S nabla;      ///< displaced volume [m^3]
  S x_G;        ///< centre of gravity forward of midship [m]
  S k_zz;       ///< radius of gyration about the centre of gravity [m]
  S U_0;        ///< service speed [m/s]
  S A_front;    ///< frontal windage area [m^2], 0 if not known
  S A_lateral;  ///< lateral windage area [m^2], 0 if not known

  static constexpr auto parameters() {
    using P = ParameterOf<MmgParticulars, S>;
    return std::array{
        P{"length_m", &MmgParticulars::L, "m", positive},
        P{"beam_m", &MmgParticulars::B, "m", positive},
        P{"draught_m", &MmgParticulars::d, "m", positive},
        P{"displacement_m3", &MmgParticulars::nabla, "m3", positive},
        P{"x_g_m", &MmgParticulars::x_G, "m", any_number},
        P{"radius_of_gyration_m", &MmgParticulars::k_zz, "m", positive},
        P{"service_speed_m_s", &MmgParticulars::U_0, "m/s", positive},
        P{.key = "frontal_area_m2",
          .member = &MmgParticulars::A_front,
          .unit = "m2",
          .range = non_negative,
          .required = false},
        P{.key = "lateral_area_m2",
          .member = &MmgParticulars::A_lateral,
          .unit = "m2",
          .range = non_negative,
          .required = false},
    };
  }
};

template <class S = double>
struct MmgAddedMass {
  S m_x;                     ///< surge, m_x'
  S m_y;                     ///< sway, m_y'
  S J_z;                     ///< yaw, J_z'
  Selection surge_coupling;  ///< what v r accelerates in surge: m + m_y as in the standard, or m alone

  static constexpr auto parameters() {
    using P = ParameterOf<MmgAddedMass, S>;
    return std::array{
        P{"m_x", &MmgAddedMass::m_x, "-", non_negative, Role::coefficient},
        P{"m_y", &MmgAddedMass::m_y, "-", non_negative, Role::coefficient},
        P{"J_z", &MmgAddedMass::J_z, "-", non_negative, Role::coefficient},
    };
  }

  static constexpr auto choices() {
    return std::array{Choice<MmgAddedMass>{"surge_coupling", &MmgAddedMass::surge_coupling, {"m+m_y", "m"}}};
  }
};

template <class S = double>
struct MmgHull {
  S R_0;                                   ///< resistance, R_0'
  S X_vv, X_vr, X_rr, X_vvvv;              ///< surge derivatives
  S Y_v, Y_r, Y_vvv, Y_vvr, Y_vrr, Y_rrr;  ///< sway derivatives
  S N_v, N_r, N_vvv, N_vvr, N_vrr, N_rrr;  ///< yaw derivatives, about midship
  Selection labels;                        ///< under which names a ship file gives them; see relabelled

  static constexpr auto parameters() {
    constexpr auto derivative = [](std::string_view key, S MmgHull::*member) {
      return ParameterOf<MmgHull, S>{key, member, "-", any_number, Role::coefficient};
    };
    return std::array{
        ParameterOf<MmgHull, S>{"R_0", &MmgHull::R_0, "-", non_negative, Role::coefficient},
        derivative("X_vv", &MmgHull::X_vv),
        derivative("X_vr", &MmgHull::X_vr),
        derivative("X_rr", &MmgHull::X_rr),
        derivative("X_vvvv", &MmgHull::X_vvvv),
        derivative("Y_v", &MmgHull::Y_v),
        derivative("Y_r", &MmgHull::Y_r),
        derivative("Y_vvv", &MmgHull::Y_vvv),
        derivative("Y_vvr", &MmgHull::Y_vvr),
        derivative("Y_vrr", &MmgHull::Y_vrr),
        derivative("Y_rrr", &MmgHull::Y_rrr),
        derivative("N_v", &MmgHull::N_v),
        derivative("N_r", &MmgHull::N_r),
        derivative("N_vvv", &MmgHull::N_vvv),
        derivative("N_vvr", &MmgHull::N_vvr),
        derivative("N_vrr", &MmgHull::N_vrr),
        derivative("N_rrr", &MmgHull::N_rrr),
    };
  }

  static constexpr auto choices() {
    return std::array{Choice<MmgHull>{"labels", &MmgHull::labels, {"standard", "kulbiej2021"}}};
  }
};

template <class S = double>
struct MmgPropeller {
  S D;              ///< diameter [m]
  S x_P;            ///< x_P', forward of midship
  S t_P;            ///< thrust deduction fraction
  S w_P0;           ///< wake fraction at the propeller, straight ahead
  S k_0, k_1, k_2;  ///< K_T = k_0 + k_1 J + k_2 J^2
  S C_1;            ///< wake change, rate
  S C_2_positive;   ///< wake change, limit for beta_P > 0
  S C_2_negative;   ///< wake change, limit for beta_P < 0
  S q_0, q_1, q_2;  ///< K_Q = q_0 + q_1 J + q_2 J^2; 0 if not known

  static constexpr auto parameters() {
    using P = ParameterOf<MmgPropeller, S>;
    constexpr auto coefficient = Role::coefficient;
    return std::array{
        P{"diameter_m", &MmgPropeller::D, "m", positive},
        P{"x_prime", &MmgPropeller::x_P, "-", {-1.0, 1.0}, coefficient},
        P{"thrust_deduction", &MmgPropeller::t_P, "-", {-1.0, 1.0}, coefficient},
        P{"wake_fraction", &MmgPropeller::w_P0, "-", {-1.0, 1.0}, coefficient},
        P{"kt[0]", &MmgPropeller::k_0, "-", positive, coefficient},
        P{"kt[1]", &MmgPropeller::k_1, "-", any_number, coefficient},
        P{"kt[2]", &MmgPropeller::k_2, "-", any_number, coefficient},
        P{"wake_C1", &MmgPropeller::C_1, "-", non_negative, coefficient},
        P{"wake_C2_positive", &MmgPropeller::C_2_positive, "-", non_negative, coefficient},
        P{"wake_C2_negative", &MmgPropeller::C_2_negative, "-", non_negative, coefficient},
        P{.key = "kq[0]",
          .member = &MmgPropeller::q_0,
          .unit = "-",
          .range = positive,
          .role = coefficient,
          .required = false},
        P{.key = "kq[1]",
          .member = &MmgPropeller::q_1,
          .unit = "-",
          .range = any_number,
          .role = coefficient,
          .required = false},
        P{.key = "kq[2]",
          .member = &MmgPropeller::q_2,
          .unit = "-",
          .range = any_number,
          .role = coefficient,
          .required = false},
    };
  }
};

/// The engine turns the shaft as ordered, or as far as its torque goes.
template <class S = double>
struct Engine {
  Selection kind;  ///< shaft speed held, or torque limited
  S Q_max;         ///< largest torque [N m]

  bool torque_limited() const { return kind.index == 1; }

  static constexpr auto parameters() {
    return std::array{ParameterOf<Engine, S>{.key = "torque_limit_kN_m",
                                             .member = &Engine::Q_max,
                                             .unit = "kN m",
                                             .range = positive,
                                             .si = 1e3,
                                             .required = false}};
  }

  static constexpr auto choices() {
    return std::array{Choice<Engine>{"kind", &Engine::kind, {"shaft_speed_held", "torque_limited"}}};
  }
};

template <class S = double>
struct MmgRudder {
  S A_R;               ///< movable area [m^2]
  S H_R;               ///< span [m]
  S x_R;               ///< x_R', forward of midship
  S t_R;               ///< steering resistance deduction
  S a_H;               ///< rudder force increase factor
  S x_H;               ///< x_H', where the induced hull force acts
  S l_R;               ///< l_R', effective lever of the yaw rate
  S gamma_R_negative;  ///< flow straightening for beta_R < 0
  S gamma_R_positive;  ///< flow straightening for beta_R > 0
  S epsilon;           ///< (1 − w_R)/(1 − w_P)
  S kappa;             ///< race increase factor
  S f_alpha;           ///< normal force slope [1/rad]
  S alpha_s = S(0.0);  ///< angle of attack at which the rudder stalls [rad], 0 for none; see stall_factor
  S stall_depth = S(0.5);
  S stall_width = S(0.05);  ///< [rad]
  S delta_lim = S(0.0);     ///< rudder angle beyond which the gap to the horn opens [rad]
  S s = S(0.0);             ///< strength of the gap, negative [1/rad²], 0 for none

  Stall<S> stall() const { return {alpha_s, stall_depth, stall_width}; }

  static constexpr auto parameters() {
    using P = ParameterOf<MmgRudder, S>;
    constexpr auto coefficient = Role::coefficient;
    return std::array{
        P{"area_m2", &MmgRudder::A_R, "m2", positive},
        P{"height_m", &MmgRudder::H_R, "m", positive},
        P{"x_prime", &MmgRudder::x_R, "-", {-1.0, 1.0}, coefficient},
        P{"t_R", &MmgRudder::t_R, "-", {-1.0, 1.0}, coefficient},
        P{"a_H", &MmgRudder::a_H, "-", any_number, coefficient},
        P{"x_H_prime", &MmgRudder::x_H, "-", any_number, coefficient},
        P{"l_R_prime", &MmgRudder::l_R, "-", any_number, coefficient},
        P{"gamma_R_negative", &MmgRudder::gamma_R_negative, "-", any_number, coefficient},
        P{"gamma_R_positive", &MmgRudder::gamma_R_positive, "-", any_number, coefficient},
        P{"epsilon", &MmgRudder::epsilon, "-", positive, coefficient},
        P{"kappa", &MmgRudder::kappa, "-", any_number, coefficient},
        P{"f_alpha", &MmgRudder::f_alpha, "1/rad", positive, coefficient},
        P{.key = "stall_angle_rad",
          .member = &MmgRudder::alpha_s,
          .unit = "rad",
          .range = non_negative,
          .role = coefficient,
          .required = false},
        P{.key = "stall_depth",
          .member = &MmgRudder::stall_depth,
          .range = {0.0, 1.0},
          .role = coefficient,
          .required = false,
          .fallback = 0.5},
        P{.key = "stall_width_rad",
          .member = &MmgRudder::stall_width,
          .unit = "rad",
          .range = positive,
          .role = coefficient,
          .required = false,
          .fallback = 0.05},
        P{.key = "gap_angle_rad",
          .member = &MmgRudder::delta_lim,
          .unit = "rad",
          .range = non_negative,
          .required = false},
        P{.key = "gap_strength",
          .member = &MmgRudder::s,
          .unit = "1/rad2",
          .range = {.high = 0.0},
          .role = coefficient,
          .required = false},
    };
  }
};

/// A single-screw, single-rudder ship in the MMG standard model.
template <class S = double>
struct MmgShip {
  using Scalar = S;

  Water<S> water;
  MmgParticulars<S> particulars;
  MmgAddedMass<S> added_mass;
  MmgHull<S> hull;
  MmgPropeller<S> propeller;
  MmgRudder<S> rudder;
  SteeringGear<S> steering_gear;
  Engine<S> engine;

  static constexpr std::size_t branch_count = 3;

  /// Tables of the ship file and the parts they fill.
  static constexpr auto sections() {
    return std::tuple{
        Section<MmgShip, Water<S>>{"water", &MmgShip::water},
        Section<MmgShip, MmgParticulars<S>>{"particulars", &MmgShip::particulars},
        Section<MmgShip, MmgAddedMass<S>>{"added_mass", &MmgShip::added_mass},
        Section<MmgShip, MmgHull<S>>{"hull", &MmgShip::hull},
        Section<MmgShip, MmgPropeller<S>>{"propeller", &MmgShip::propeller},
        Section<MmgShip, MmgRudder<S>>{"rudder", &MmgShip::rudder},
        Section<MmgShip, SteeringGear<S>>{"rudder", &MmgShip::steering_gear},
        Section<MmgShip, Engine<S>>{"engine", &MmgShip::engine},
    };
  }
};

}  // namespace swayaw::nonlinear
