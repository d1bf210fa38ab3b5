#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <tuple>

#include "swayaw/core/parameter.hpp"
#include "swayaw/core/steering_gear.hpp"
#include "swayaw/nonlinear/models/mmg/mmg_ship.hpp"

/// The numbers of a ship in Abkowitz's model: forces as a Taylor polynomial, third order, about steady motion straight
/// ahead at U_0. A subscript names what is multiplied: u the change of surge u − U_0, v the sway, r the yaw rate,
/// d the rudder angle, positive to port. What is not symmetric straight ahead, as the wash of one screw, stands in Y_0,
/// N_0.
///
/// Primes refer to ½ρL²V² (force), ½ρL³V² (moment), ½ρL³ (mass), ½ρL⁴ (mass times length), ½ρL⁵ (moment of inertia),
/// with (u − U_0)/V, v/V and rL/V; V is the speed U of the moment or U_0, see AbkowitzParticulars. Origin is midship.
///
/// Source: [Abkowitz1964], [Chislett1965]
namespace swayaw::inline nonlinear {

template <class S = double>
struct AbkowitzParticulars {
  S L;          ///< length between perpendiculars [m]
  S U_0;        ///< speed the polynomial is expanded about, and service speed [m/s]
  S A_front;    ///< frontal windage area [m^2], 0 if not known
  S A_lateral;  ///< lateral windage area [m^2], 0 if not known

  /// V of the primes. With `nominal` a term in u is the change of a force with speed, and a force that goes with u² has
  /// Y_ud' = 2 Y_d', Y_uud' = Y_d'. With `actual` the speed enters by V besides.
  Selection prime_speed;

  static constexpr auto parameters() {
    using P = ParameterOf<AbkowitzParticulars, S>;
    return std::array{
        P{"length_m", &AbkowitzParticulars::L, "m", positive},
        P{"service_speed_m_s", &AbkowitzParticulars::U_0, "m/s", positive},
        P{.key = "frontal_area_m2",
          .member = &AbkowitzParticulars::A_front,
          .unit = "m2",
          .range = non_negative,
          .required = false},
        P{.key = "lateral_area_m2",
          .member = &AbkowitzParticulars::A_lateral,
          .unit = "m2",
          .range = non_negative,
          .required = false},
    };
  }

  static constexpr auto choices() {
    return std::array{
        Choice<AbkowitzParticulars>{"prime_speed", &AbkowitzParticulars::prime_speed, {"actual", "nominal"}}};
  }

  bool primes_at_nominal_speed() const { return prime_speed.index == 1; }
};

/// Ship and entrained water; acceleration derivatives are negative added masses.
template <class S = double>
struct AbkowitzInertia {
  S m;       ///< mass, m'
  S x_G;     ///< centre of gravity forward of midship over L, x_G'
  S I_z;     ///< moment of inertia about midship, I_z'
  S X_udot;  ///< −m_x'
  S Y_vdot;  ///< −m_y'
  S Y_rdot;
  S N_vdot;
  S N_rdot;  ///< −J_z'

  /// Towing tests measure the centrifugal force of the model together with the water's. With `in_derivatives` the
  /// hull derivatives are such sums: X_vr + m, X_rr + m x_G, Y_r − m, Y_ru − m, N_r − m x_G, N_ru − m x_G, primes of
  /// all.
  Selection centripetal;

  static constexpr auto parameters() {
    using P = ParameterOf<AbkowitzInertia, S>;
    constexpr Range not_positive{.high = 0.0};
    constexpr auto coefficient = Role::coefficient;
    return std::array{
        P{"m", &AbkowitzInertia::m, "-", positive},
        P{"x_G", &AbkowitzInertia::x_G, "-", {-0.5, 0.5}},
        P{"I_z", &AbkowitzInertia::I_z, "-", positive},
        P{"X_udot", &AbkowitzInertia::X_udot, "-", not_positive, coefficient},
        P{"Y_vdot", &AbkowitzInertia::Y_vdot, "-", not_positive, coefficient},
        P{"Y_rdot", &AbkowitzInertia::Y_rdot, "-", any_number, coefficient},
        P{"N_vdot", &AbkowitzInertia::N_vdot, "-", any_number, coefficient},
        P{"N_rdot", &AbkowitzInertia::N_rdot, "-", not_positive, coefficient},
    };
  }

  static constexpr auto choices() {
    return std::array{
        Choice<AbkowitzInertia>{"centripetal", &AbkowitzInertia::centripetal, {"separate", "in_derivatives"}}};
  }

  bool centripetal_in_derivatives() const { return centripetal.index == 1; }
};

/// Hull with its propeller running as it does straight ahead at U_0. Only first derivatives must be given.
template <class S = double>
struct AbkowitzHull {
  S X_u, X_uu, X_uuu, X_vv, X_vr, X_rr, X_vvu, X_vru, X_rru;                           ///< surge
  S Y_0, Y_0u, Y_0uu, Y_v, Y_vu, Y_vuu, Y_r, Y_ru, Y_ruu, Y_vvv, Y_vvr, Y_vrr, Y_rrr;  ///< sway
  S N_0, N_0u, N_0uu, N_v, N_vu, N_vuu, N_r, N_ru, N_ruu, N_vvv, N_vvr, N_vrr, N_rrr;  ///< yaw, about midship

  static constexpr auto parameters() {
    using H = AbkowitzHull;
    using P = ParameterOf<AbkowitzHull, S>;
    constexpr auto first = [](std::string_view key, S H::*member) {
      return P{key, member, "-", any_number, Role::coefficient};
    };
    constexpr auto higher = [](std::string_view key, S H::*member) {
      return P{
          .key = key, .member = member, .unit = "-", .range = any_number, .role = Role::coefficient, .required = false};
    };
    return std::array{
        first("X_u", &H::X_u),      higher("X_uu", &H::X_uu),   higher("X_uuu", &H::X_uuu), higher("X_vv", &H::X_vv),
        higher("X_vr", &H::X_vr),   higher("X_rr", &H::X_rr),   higher("X_vvu", &H::X_vvu), higher("X_vru", &H::X_vru),
        higher("X_rru", &H::X_rru), higher("Y_0", &H::Y_0),     higher("Y_0u", &H::Y_0u),   higher("Y_0uu", &H::Y_0uu),
        first("Y_v", &H::Y_v),      higher("Y_vu", &H::Y_vu),   higher("Y_vuu", &H::Y_vuu), first("Y_r", &H::Y_r),
        higher("Y_ru", &H::Y_ru),   higher("Y_ruu", &H::Y_ruu), higher("Y_vvv", &H::Y_vvv), higher("Y_vvr", &H::Y_vvr),
        higher("Y_vrr", &H::Y_vrr), higher("Y_rrr", &H::Y_rrr), higher("N_0", &H::N_0),     higher("N_0u", &H::N_0u),
        higher("N_0uu", &H::N_0uu), first("N_v", &H::N_v),      higher("N_vu", &H::N_vu),   higher("N_vuu", &H::N_vuu),
        first("N_r", &H::N_r),      higher("N_ru", &H::N_ru),   higher("N_ruu", &H::N_ruu), higher("N_vvv", &H::N_vvv),
        higher("N_vvr", &H::N_vvr), higher("N_vrr", &H::N_vrr), higher("N_rrr", &H::N_rrr),
    };
  }
};

/// Every term with the rudder angle.
template <class S = double>
struct AbkowitzRudder {
  S X_dd, X_udd, X_vd, X_uvd, X_rd, X_urd;                       ///< surge
  S Y_d, Y_ud, Y_uud, Y_ddd, Y_vvd, Y_vdd, Y_rrd, Y_rdd, Y_vrd;  ///< sway
  S N_d, N_ud, N_uud, N_ddd, N_vvd, N_vdd, N_rrd, N_rdd, N_vrd;  ///< yaw, about midship

  static constexpr auto parameters() {
    using R = AbkowitzRudder;
    using P = ParameterOf<AbkowitzRudder, S>;
    constexpr auto first = [](std::string_view key, S R::*member) {
      return P{key, member, "-", any_number, Role::coefficient};
    };
    constexpr auto higher = [](std::string_view key, S R::*member) {
      return P{
          .key = key, .member = member, .unit = "-", .range = any_number, .role = Role::coefficient, .required = false};
    };
    return std::array{
        higher("X_dd", &R::X_dd),   higher("X_udd", &R::X_udd), higher("X_vd", &R::X_vd),   higher("X_uvd", &R::X_uvd),
        higher("X_rd", &R::X_rd),   higher("X_urd", &R::X_urd), first("Y_d", &R::Y_d),      higher("Y_ud", &R::Y_ud),
        higher("Y_uud", &R::Y_uud), higher("Y_ddd", &R::Y_ddd), higher("Y_vvd", &R::Y_vvd), higher("Y_vdd", &R::Y_vdd),
        higher("Y_rrd", &R::Y_rrd), higher("Y_rdd", &R::Y_rdd), higher("Y_vrd", &R::Y_vrd), first("N_d", &R::N_d),
        higher("N_ud", &R::N_ud),   higher("N_uud", &R::N_uud), higher("N_ddd", &R::N_ddd), higher("N_vvd", &R::N_vvd),
        higher("N_vdd", &R::N_vdd), higher("N_rrd", &R::N_rrd), higher("N_rdd", &R::N_rdd), higher("N_vrd", &R::N_vrd),
    };
  }
};

/// A ship in Abkowitz's model.
template <class S = double>
struct AbkowitzShip {
  using Scalar = S;
  static constexpr std::size_t branch_count = 0;  ///< the polynomial is smooth

  Water<S> water;
  AbkowitzParticulars<S> particulars;
  AbkowitzInertia<S> inertia;
  AbkowitzHull<S> hull;
  AbkowitzRudder<S> rudder;
  SteeringGear<S> steering_gear;

  /// Tables of the ship file and the parts they fill.
  static constexpr auto sections() {
    return std::tuple{
        Section<AbkowitzShip, Water<S>>{"water", &AbkowitzShip::water},
        Section<AbkowitzShip, AbkowitzParticulars<S>>{"particulars", &AbkowitzShip::particulars},
        Section<AbkowitzShip, AbkowitzInertia<S>>{"inertia", &AbkowitzShip::inertia},
        Section<AbkowitzShip, AbkowitzHull<S>>{"hull", &AbkowitzShip::hull},
        Section<AbkowitzShip, AbkowitzRudder<S>>{"rudder", &AbkowitzShip::rudder},
        Section<AbkowitzShip, SteeringGear<S>>{"rudder", &AbkowitzShip::steering_gear},
    };
  }
};

}  // namespace swayaw::nonlinear
