#pragma once

#include <array>
#include <limits>

#include "swayaw/core/angle.hpp"
#include "swayaw/nonlinear/effect_parameter.hpp"
#include "swayaw/nonlinear/shallow_water.hpp"

/// Effects that change numbers of the model: other values, or factors. docs/effects.md tells formulas and sources.
namespace swayaw {

/// A number of the model that gets another value. One that is not given stays as it is.
template <class Part, class S>
constexpr EffectParameter<Part, S> other_value(std::string_view key, S Part::*member, std::string_view table,
                                               std::string_view number, std::string_view other_name = {},
                                               Range range = any_number, double law = 0.03) {
  return {.key = key,
          .member = member,
          .range = range,
          .null = unchanged,
          .prior = 0.25,
          .floor = 0.05,
          .law = law,
          .scale = ShipUnit::own,
          .required = false,
          .fallback = unchanged,
          .table = table,
          .replaces = {number, other_name}};
}

/// Y_v, Y_r, N_v, N_r as they are.
template <class S = double>
struct HullLinearDerivatives {
  S Y_v{unchanged}, Y_r{unchanged}, N_v{unchanged}, N_r{unchanged};

  static constexpr std::string_view id = "hull_linear_derivatives";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr auto parameters() {
    using H = HullLinearDerivatives;
    constexpr auto term = [](std::string_view key, S H::*member) {
      return other_value<H, S>(key, member, "hull", key);
    };
    return std::array{term("Y_v", &H::Y_v), term("Y_r", &H::Y_r), term("N_v", &H::N_v), term("N_r", &H::N_r)};
  }
};

/// Cubic terms of sway and yaw as they are.
template <class S = double>
struct HullNonlinearDamping {
  S Y_vvv{unchanged}, Y_vvr{unchanged}, Y_vrr{unchanged}, Y_rrr{unchanged};
  S N_vvv{unchanged}, N_vvr{unchanged}, N_vrr{unchanged}, N_rrr{unchanged};

  static constexpr std::string_view id = "hull_nonlinear_damping";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr auto parameters() {
    using H = HullNonlinearDamping;
    constexpr auto term = [](std::string_view key, S H::*member) {
      return other_value<H, S>(key, member, "hull", key, {}, any_number, 0.2);
    };
    return std::array{term("Y_vvv", &H::Y_vvv), term("Y_vvr", &H::Y_vvr), term("Y_vrr", &H::Y_vrr),
                      term("Y_rrr", &H::Y_rrr), term("N_vvv", &H::N_vvv), term("N_vvr", &H::N_vvr),
                      term("N_vrr", &H::N_vrr), term("N_rrr", &H::N_rrr)};
  }
};

/// Surge derivatives as they are.
template <class S = double>
struct SpeedLossInTurn {
  S X_vv{unchanged}, X_vr{unchanged}, X_rr{unchanged}, X_vvvv{unchanged};

  static constexpr std::string_view id = "speed_loss_in_turn";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr auto parameters() {
    using H = SpeedLossInTurn;
    constexpr auto term = [](std::string_view key, S H::*member) {
      return other_value<H, S>(key, member, "hull", key, {}, any_number, 0.2);
    };
    return std::array{term("X_vv", &H::X_vv), term("X_vr", &H::X_vr), term("X_rr", &H::X_rr),
                      term("X_vvvv", &H::X_vvvv)};
  }
};

/// Added masses as they are: m_x, m_y, J_z of the MMG model, acceleration derivatives of the others.
template <class S = double>
struct AddedMass {
  S m_x{unchanged}, m_y{unchanged}, J_z{unchanged};
  S X_udot{unchanged}, Y_vdot{unchanged}, Y_rdot{unchanged}, N_vdot{unchanged}, N_rdot{unchanged};

  static constexpr std::string_view id = "added_mass";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr auto parameters() {
    using A = AddedMass;
    constexpr auto term = [](std::string_view key, S A::*member) {
      return other_value<A, S>(key, member, "added_mass", key);
    };
    return std::array{term("m_x", &A::m_x),       term("m_y", &A::m_y),       term("J_z", &A::J_z),
                      term("X_udot", &A::X_udot), term("Y_vdot", &A::Y_vdot), term("Y_rdot", &A::Y_rdot),
                      term("N_vdot", &A::N_vdot), term("N_rdot", &A::N_rdot)};
  }
};

/// Resistance straight ahead times 1 + relative_increase.
template <class S = double>
struct AddedResistance {
  S relative_increase{};

  static constexpr std::string_view id = "added_resistance";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr auto parameters() {
    using P = EffectParameter<AddedResistance, S>;
    return std::array{P{.key = "relative_increase",
                        .member = &AddedResistance::relative_increase,
                        .range = {.low = -1.0, .above_low = true},
                        .prior = 0.3,
                        .floor = 0.05,
                        .law = 0.06}};
  }
};

/// Lift of the rudder times a factor.
template <class S = double>
struct RudderEffectiveness {
  S factor{1.0};

  static constexpr std::string_view id = "rudder_effectiveness";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr auto parameters() {
    using P = EffectParameter<RudderEffectiveness, S>;
    return std::array{P{.key = "factor",
                        .member = &RudderEffectiveness::factor,
                        .range = positive,
                        .null = 1.0,
                        .prior = 0.2,
                        .floor = 0.05}};
  }
};

/// What the rudder induces on the hull, as it is.
template <class S = double>
struct RudderHullInteraction {
  S a_H{unchanged}, x_H{unchanged};

  static constexpr std::string_view id = "rudder_hull_interaction";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr auto parameters() {
    using R = RudderHullInteraction;
    return std::array{other_value<R, S>("a_H", &R::a_H, "rudder", "a_H"),
                      other_value<R, S>("x_H", &R::x_H, "rudder", "x_H_prime", "x_H")};
  }
};

/// Flow straightening at the rudder, as it is: gamma_R and l_R of the MMG model, kappa_v and kappa_r of the lifting
/// line.
template <class S = double>
struct FlowStraightening {
  S gamma_R_negative{unchanged}, gamma_R_positive{unchanged}, l_R{unchanged}, kappa_v{unchanged}, kappa_r{unchanged};

  static constexpr std::string_view id = "flow_straightening";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr auto parameters() {
    using F = FlowStraightening;
    return std::array{other_value<F, S>("gamma_R_negative", &F::gamma_R_negative, "rudder", "gamma_R_negative"),
                      other_value<F, S>("gamma_R_positive", &F::gamma_R_positive, "rudder", "gamma_R_positive"),
                      other_value<F, S>("l_R", &F::l_R, "rudder", "l_R_prime"),
                      other_value<F, S>("kappa_v", &F::kappa_v, "rudder", "kappa_v"),
                      other_value<F, S>("kappa_r", &F::kappa_r, "rudder", "kappa_r")};
  }
};

/// Race increase factor kappa, as it is.
template <class S = double>
struct RaceOnRudder {
  S kappa{unchanged};

  static constexpr std::string_view id = "propeller_race";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr auto parameters() {
    return std::array{other_value<RaceOnRudder, S>("kappa", &RaceOnRudder::kappa, "rudder", "kappa")};
  }
};

/// Wake change in a turn, as it is.
template <class S = double>
struct WakeChange {
  S C_1{unchanged}, C_2_positive{unchanged}, C_2_negative{unchanged};

  static constexpr std::string_view id = "wake_change";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr auto parameters() {
    using W = WakeChange;
    return std::array{
        other_value<W, S>("C1", &W::C_1, "propeller", "wake_C1", {}, non_negative),
        other_value<W, S>("C2_positive", &W::C_2_positive, "propeller", "wake_C2_positive", {}, non_negative),
        other_value<W, S>("C2_negative", &W::C_2_negative, "propeller", "wake_C2_negative", {}, non_negative)};
  }
};

/// Lift lost beyond an angle of attack; see stall_factor.
template <class S = double>
struct RudderStall {
  S angle{0.5 * pi};  ///< [rad]
  S depth{0.5};
  S width{0.05};  ///< [rad]

  static constexpr std::string_view id = "rudder_stall";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr auto parameters() {
    using P = EffectParameter<RudderStall, S>;
    return std::array{P{.key = "stall_angle_rad",
                        .member = &RudderStall::angle,
                        .range = {.low = 0.0, .high = 0.5 * pi, .above_low = true},
                        .null = 0.5 * pi,
                        .prior = 0.6,
                        .floor = 0.05,
                        .table = "rudder",
                        .replaces = {"stall_angle_rad", {}}},
                      P{.key = "depth",
                        .member = &RudderStall::depth,
                        .range = {0.0, 1.0},
                        .null = 0.5,
                        .prior = 0.2,
                        .decides = false,
                        .required = false,
                        .fallback = 0.5,
                        .table = "rudder",
                        .replaces = {"stall_depth", {}}},
                      P{.key = "width_rad",
                        .member = &RudderStall::width,
                        .range = positive,
                        .null = 0.05,
                        .prior = 0.02,
                        .decides = false,
                        .required = false,
                        .fallback = 0.05,
                        .table = "rudder",
                        .replaces = {"stall_width_rad", {}}}};
  }
};

/// Lift lost to the gap between rudder and horn, 1 + s (|delta| − delta_lim)² beyond delta_lim.
template <class S = double>
struct RudderGap {
  S delta_lim{unchanged};  ///< [rad]
  S s{unchanged};          ///< [1/rad²]

  static constexpr std::string_view id = "rudder_gap";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr auto parameters() {
    using P = EffectParameter<RudderGap, S>;
    return std::array{P{.key = "delta_lim_rad",
                        .member = &RudderGap::delta_lim,
                        .range = {.low = 0.0, .high = 0.5 * pi},
                        .null = unchanged,
                        .prior = 0.2,
                        .decides = false,
                        .table = "rudder",
                        .replaces = {"gap_angle_rad", {}}},
                      P{.key = "s",
                        .member = &RudderGap::s,
                        .range = {.high = 0.0},
                        .null = unchanged,
                        .prior = 1.0,
                        .floor = 0.2,
                        .table = "rudder",
                        .replaces = {"gap_strength", {}}}};
  }
};

/// Water of finite depth; see shallow_water_factors.
template <class S = double>
struct ShallowWater {
  S depth_over_draught{std::numeric_limits<double>::infinity()};
  S sway{1.0}, yaw{1.0}, cubic{1.0}, mass{1.0}, resistance{1.0}, wake{0.5};

  ShallowWaterGrowth<S> growth() const { return {sway, yaw, cubic, mass, resistance, wake}; }

  static constexpr std::string_view id = "shallow_water";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr auto parameters() {
    using W = ShallowWater;
    using P = EffectParameter<W, S>;
    constexpr auto growth = [](std::string_view key, S W::*member, double usual) {
      return P{.key = key,
               .member = member,
               .range = non_negative,
               .null = usual,
               .prior = 0.5,
               .decides = false,
               .required = false,
               .fallback = usual};
    };
    return std::array{P{.key = "depth_over_draught",
                        .member = &W::depth_over_draught,
                        .range = {.low = 1.1},
                        .null = std::numeric_limits<double>::infinity(),
                        .prior = 2.0,
                        .floor = 0.1},
                      growth("sway", &W::sway, 1.0),
                      growth("yaw", &W::yaw, 1.0),
                      growth("cubic", &W::cubic, 1.0),
                      growth("mass", &W::mass, 1.0),
                      growth("resistance", &W::resistance, 1.0),
                      growth("wake", &W::wake, 0.5)};
  }
};

}  // namespace swayaw
