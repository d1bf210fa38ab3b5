#pragma once

#include <array>

#include "swayaw/core/parameter.hpp"
#include "swayaw/core/scalar.hpp"

/// Parts that the physics-informed and the physics-uninformed model share.
///
/// Derivatives are in the prime system of SNAME: forces over ½ρL²U², moments over ½ρL³U², masses over ½ρL³, their
/// coupling over ½ρL⁴, inertia over ½ρL⁵. They hold the centrifugal and Munk terms of the entrained water, which the
/// equations of motion of this model leave out; they are not those of the MMG model in another scale.
///
/// Source: [Alexandersson2024] section 2.1, table 1, appendix A
namespace swayaw::inline nonlinear {

template <class S = double>
struct ViscousWater {
  S rho;  ///< density [kg/m^3]
  S nu;   ///< kinematic viscosity [m^2/s]

  static constexpr auto parameters() {
    using P = ParameterOf<ViscousWater, S>;
    return std::array{
        P{"density_kg_m3", &ViscousWater::rho, "kg/m3", positive},
        P{"kinematic_viscosity_m2_s", &ViscousWater::nu, "m2/s", positive},
    };
  }
};

template <class S = double>
struct PrimeParticulars {
  S L;          ///< length between perpendiculars [m]
  S B;          ///< beam [m]
  S d;          ///< draught [m]
  S nabla;      ///< displaced volume [m^3]
  S x_G;        ///< centre of gravity forward of midship [m]
  S I_z;        ///< yaw inertia about midship [kg m^2], 0 where k_zz is given
  S k_zz;       ///< radius of gyration about the centre of gravity [m], 0 where I_z is given
  S U_0;        ///< service speed [m/s]
  S Fn_0;       ///< Froude number of the speed from which u' counts
  S A_front;    ///< frontal windage area [m^2], 0 if not known
  S A_lateral;  ///< lateral windage area [m^2], 0 if not known

  static constexpr auto parameters() {
    using P = ParameterOf<PrimeParticulars, S>;
    using Q = PrimeParticulars;
    return std::array{
        P{"length_m", &Q::L, "m", positive},
        P{"beam_m", &Q::B, "m", positive},
        P{"draught_m", &Q::d, "m", positive},
        P{"displacement_m3", &Q::nabla, "m3", positive},
        P{"x_g_m", &Q::x_G, "m", any_number},
        P{.key = "inertia_z_kg_m2", .member = &Q::I_z, .unit = "kg m2", .range = positive, .required = false},
        P{.key = "radius_of_gyration_m", .member = &Q::k_zz, .unit = "m", .range = positive, .required = false},
        P{"service_speed_m_s", &Q::U_0, "m/s", positive},
        P{.key = "perturbed_speed_froude",
          .member = &Q::Fn_0,
          .unit = "-",
          .range = non_negative,
          .required = false,
          .fallback = 0.02},
        P{.key = "frontal_area_m2", .member = &Q::A_front, .unit = "m2", .range = non_negative, .required = false},
        P{.key = "lateral_area_m2", .member = &Q::A_lateral, .unit = "m2", .range = non_negative, .required = false},
    };
  }
};

template <class S = double>
struct PrimeAddedMass {
  S X_udot;          ///< negative for a real ship
  S Y_vdot, Y_rdot;  ///< sway force of sway and yaw acceleration
  S N_vdot, N_rdot;  ///< yaw moment of sway and yaw acceleration

  static constexpr auto parameters() {
    constexpr auto derivative = [](std::string_view key, S PrimeAddedMass::*member) {
      return ParameterOf<PrimeAddedMass, S>{key, member, "-", any_number, Role::coefficient};
    };
    return std::array{
        derivative("X_udot", &PrimeAddedMass::X_udot), derivative("Y_vdot", &PrimeAddedMass::Y_vdot),
        derivative("Y_rdot", &PrimeAddedMass::Y_rdot), derivative("N_vdot", &PrimeAddedMass::N_vdot),
        derivative("N_rdot", &PrimeAddedMass::N_rdot),
    };
  }
};

/// Terms that a ship file does not name are zero; without damping of sway and yaw, and the moment by drift, it is no
/// hull.
template <class S = double>
struct PrimeHull {
  S X_0, X_u, X_vv, X_vr, X_rr;                 ///< surge derivatives
  S Y_0, Y_v, Y_r, Y_vvv, Y_vvr, Y_vrr, Y_rrr;  ///< sway derivatives
  S N_0, N_v, N_r, N_vvv, N_vvr, N_vrr, N_rrr;  ///< yaw derivatives, about midship

  static constexpr auto parameters() {
    using H = PrimeHull;
    constexpr auto needed = [](std::string_view key, S H::*member) {
      return ParameterOf<H, S>{
          .key = key, .member = member, .unit = "-", .range = any_number, .role = Role::coefficient};
    };
    constexpr auto term = [](std::string_view key, S H::*member) {
      return ParameterOf<H, S>{
          .key = key, .member = member, .unit = "-", .range = any_number, .role = Role::coefficient, .required = false};
    };
    return std::array{
        term("X_0", &H::X_0),     term("X_u", &H::X_u),     term("X_vv", &H::X_vv),   term("X_vr", &H::X_vr),
        term("X_rr", &H::X_rr),   term("Y_0", &H::Y_0),     needed("Y_v", &H::Y_v),   term("Y_r", &H::Y_r),
        term("Y_vvv", &H::Y_vvv), term("Y_vvr", &H::Y_vvr), term("Y_vrr", &H::Y_vrr), term("Y_rrr", &H::Y_rrr),
        term("N_0", &H::N_0),     needed("N_v", &H::N_v),   needed("N_r", &H::N_r),   term("N_vvv", &H::N_vvv),
        term("N_vvr", &H::N_vvr), term("N_vrr", &H::N_vrr), term("N_rrr", &H::N_rrr),
    };
  }
};

/// One propeller on the centre line, or two. Its thrust is measured, or follows from the open-water curve.
template <class S = double>
struct PrimePropeller {
  S D;              ///< diameter [m]
  S x_P;            ///< forward of midship [m]; used by the wake change only
  S y_P_port;       ///< port propeller, positive to starboard [m]; 0 for a single propeller
  S y_P_starboard;  ///< starboard propeller, positive to starboard [m]; 0 for a single propeller
  S t_P;            ///< thrust deduction fraction
  S w_f;            ///< wake fraction, straight ahead
  S T_0;            ///< thrust of all propellers at service speed [N], 0 if not known
  S k_0, k_1, k_2;  ///< K_T = k_0 + k_1 J + k_2 J², 0 if not known
  S C_1;            ///< wake change, rate
  S C_2_positive;   ///< wake change, limit for beta_P > 0
  S C_2_negative;   ///< wake change, limit for beta_P < 0
  Selection wake;   ///< constant, or changing as in the MMG model

  bool twin() const { return first_lane(y_P_port) != first_lane(y_P_starboard); }
  bool wake_changes() const { return wake.index == 1; }
  bool has_open_water_curve() const { return first_lane(k_0) > 0.0; }

  static constexpr auto parameters() {
    using P = ParameterOf<PrimePropeller, S>;
    using Q = PrimePropeller;
    constexpr auto coefficient = Role::coefficient;
    constexpr auto optional = [](std::string_view key, S Q::*member, const char* unit, Range range, Role role,
                                 double fallback = 0.0) {
      return P{.key = key,
               .member = member,
               .unit = unit,
               .range = range,
               .role = role,
               .required = false,
               .fallback = fallback};
    };
    return std::array{
        P{"diameter_m", &Q::D, "m", positive},
        optional("x_m", &Q::x_P, "m", any_number, Role::fact),
        optional("y_m[0]", &Q::y_P_port, "m", {.high = 0.0}, Role::fact),
        optional("y_m[1]", &Q::y_P_starboard, "m", non_negative, Role::fact),
        P{"thrust_deduction", &Q::t_P, "-", {-1.0, 1.0}, coefficient},
        P{"wake_fraction", &Q::w_f, "-", {-1.0, 1.0}, coefficient},
        optional("thrust_N", &Q::T_0, "N", positive, Role::fact),
        optional("kt[0]", &Q::k_0, "-", positive, coefficient),
        optional("kt[1]", &Q::k_1, "-", any_number, coefficient),
        optional("kt[2]", &Q::k_2, "-", any_number, coefficient),
        optional("wake_C1", &Q::C_1, "-", non_negative, coefficient),
        optional("wake_C2_positive", &Q::C_2_positive, "-", non_negative, coefficient, 1.0),
        optional("wake_C2_negative", &Q::C_2_negative, "-", non_negative, coefficient, 1.0),
    };
  }

  static constexpr auto choices() {
    return std::array{Choice<PrimePropeller>{"wake", &PrimePropeller::wake, {"constant", "mmg"}}};
  }
};

}  // namespace swayaw::nonlinear
