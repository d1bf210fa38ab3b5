#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "swayaw/core/angle.hpp"
#include "swayaw/nonlinear/effect_parameter.hpp"

/// Effects that add a force, a wind or a stream to what the model knows. docs/effects.md tells formulas and sources.
namespace swayaw {

inline constexpr Range direction{.low = -2.0 * pi, .high = 2.0 * pi};

/// Wind that blows all the time.
template <class S = double>
struct SteadyWind {
  S speed{};  ///< [m/s]
  S from{};   ///< clockwise from north [rad]

  static constexpr std::string_view id = "steady_wind";
  static constexpr EffectPlace place = EffectPlace::air;
  static constexpr auto parameters() {
    using P = EffectParameter<SteadyWind, S>;
    return std::array{
        P{.key = "wind_speed_m_s",
          .member = &SteadyWind::speed,
          .range = non_negative,
          .prior = 1.0,
          .floor = 0.2,
          .law = 0.1,
          .scale = ShipUnit::wind},
        P{.key = "wind_from_rad",
          .member = &SteadyWind::from,
          .range = direction,
          .prior = pi,
          .law = 0.05,
          .decides = false},
    };
  }
};

/// Wind from onset to end, on top of a steady one.
template <class S = double>
struct Gust {
  S speed{};                                           ///< [m/s]
  S from{};                                            ///< clockwise from north [rad]
  S onset{};                                           ///< [s]
  S end = S(std::numeric_limits<double>::infinity());  ///< [s]

  static constexpr std::string_view id = "gust";
  static constexpr EffectPlace place = EffectPlace::air;
  static constexpr auto parameters() {
    using P = EffectParameter<Gust, S>;
    constexpr double never = std::numeric_limits<double>::infinity();
    return std::array{
        P{.key = "wind_speed_m_s",
          .member = &Gust::speed,
          .range = non_negative,
          .prior = 1.0,
          .floor = 0.2,
          .law = 0.1,
          .scale = ShipUnit::wind},
        P{.key = "wind_from_rad",
          .member = &Gust::from,
          .range = direction,
          .prior = pi,
          .law = 0.05,
          .decides = false},
        P{.key = "onset_s",
          .member = &Gust::onset,
          .prior = 5.0,
          .law = 0.0,
          .scale = ShipUnit::time,
          .decides = false},
        P{.key = "end_s",
          .member = &Gust::end,
          .null = never,
          .prior = 5.0,
          .law = 0.0,
          .scale = ShipUnit::time,
          .decides = false,
          .required = false,
          .fallback = never},
    };
  }
};

/// A uniform stream.
template <class S = double>
struct SteadyCurrent {
  S speed{};  ///< [m/s]
  S to{};     ///< clockwise from north [rad]

  static constexpr std::string_view id = "steady_current";
  static constexpr EffectPlace place = EffectPlace::water;
  static constexpr auto parameters() {
    using P = EffectParameter<SteadyCurrent, S>;
    return std::array{
        P{.key = "current_speed_m_s",
          .member = &SteadyCurrent::speed,
          .range = non_negative,
          .prior = 0.1,
          .floor = 0.02,
          .law = 0.0,
          .scale = ShipUnit::speed},
        P{.key = "current_to_rad",
          .member = &SteadyCurrent::to,
          .range = direction,
          .prior = pi,
          .law = 0.0,
          .decides = false},
    };
  }
};

/// Mean second-order force of the waves.
template <class S = double>
struct WaveDrift {
  S from{};      ///< where the waves come from, clockwise from north [rad]
  S force{};     ///< F, sway force in beam waves [N]
  S ahead{0.4};  ///< surge force in head waves over F
  S moment{};    ///< yaw moment in waves on the bow, 45 deg, over F L

  static constexpr std::string_view id = "wave_drift";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr auto parameters() {
    using P = EffectParameter<WaveDrift, S>;
    return std::array{
        P{.key = "wave_from_rad",
          .member = &WaveDrift::from,
          .range = direction,
          .prior = pi,
          .law = 0.05,
          .decides = false},
        P{.key = "force_N",
          .member = &WaveDrift::force,
          .range = non_negative,
          .prior = 1.0,
          .floor = 0.05,
          .scale = ShipUnit::force},
        P{.key = "ahead",
          .member = &WaveDrift::ahead,
          .null = 0.4,
          .prior = 0.3,
          .decides = false,
          .required = false,
          .fallback = 0.4},
        P{.key = "moment", .member = &WaveDrift::moment, .prior = 0.1, .decides = false, .required = false},
    };
  }
};

/// Drag of the strips of the hull across the flow, beside the polynomial of the model.
template <class S = double>
struct CrossFlowDrag {
  S C_D{};

  static constexpr std::string_view id = "cross_flow_drag";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr auto parameters() {
    using P = EffectParameter<CrossFlowDrag, S>;
    return std::array{
        P{.key = "drag_coefficient", .member = &CrossFlowDrag::C_D, .prior = 0.5, .floor = 0.2, .law = 0.1}};
  }
};

/// Transverse force of a single screw, at the propeller, positive to starboard.
template <class S = double>
struct PropellerSideForce {
  S share{};     ///< over the thrust
  S constant{};  ///< [N]

  static constexpr std::string_view id = "propeller_side_force";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr auto parameters() {
    using P = EffectParameter<PropellerSideForce, S>;
    return std::array{
        P{.key = "share_of_thrust",
          .member = &PropellerSideForce::share,
          .range = {-1.0, 1.0},
          .prior = 0.05,
          .floor = 0.005},
        P{.key = "constant_N",
          .member = &PropellerSideForce::constant,
          .prior = 0.05,
          .floor = 0.005,
          .scale = ShipUnit::force,
          .required = false},
    };
  }
};

/// Heel that changes sway force and yaw moment. The ship heels as the centrifugal force of a turn makes her.
template <class S = double>
struct RollCoupling {
  S GM{unchanged};     ///< metacentric height [m]; 0.05 B unless given
  S Y_phi{};           ///< sway force by heel over ½ρLdU²
  S N_phi{};           ///< yaw moment by heel over ½ρL²dU²
  S zeta{0.1};         ///< damping over critical
  S lever{unchanged};  ///< height of the centre of gravity over the point where the water holds the hull [m]; d/2
                       ///< unless given

  static constexpr std::string_view id = "roll_coupling";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr auto parameters() {
    using P = EffectParameter<RollCoupling, S>;
    // container ship of [Son1982], −0.000063 and −0.0001424 in ½ρL²U², L/d = 20.6
    constexpr double Y_phi = -0.000063 * 175.0 / 8.5, N_phi = -0.0001424 * 175.0 / 8.5;
    return std::array{
        P{.key = "GM_m",
          .member = &RollCoupling::GM,
          .range = positive,
          .null = unchanged,
          .prior = 0.5,
          .scale = ShipUnit::own,
          .decides = false,
          .required = false,
          .fallback = unchanged},
        P{.key = "Y_phi",
          .member = &RollCoupling::Y_phi,
          .prior = 0.02,
          .floor = 0.001,
          .required = false,
          .fallback = Y_phi},
        P{.key = "N_phi",
          .member = &RollCoupling::N_phi,
          .prior = 0.02,
          .floor = 0.001,
          .required = false,
          .fallback = N_phi},
        P{.key = "zeta",
          .member = &RollCoupling::zeta,
          .range = non_negative,
          .null = 0.1,
          .prior = 0.05,
          .decides = false,
          .required = false,
          .fallback = 0.1},
        P{.key = "lever_m",
          .member = &RollCoupling::lever,
          .null = unchanged,
          .prior = 0.5,
          .scale = ShipUnit::own,
          .decides = false,
          .required = false,
          .fallback = unchanged},
    };
  }
};

/// A share of the linear damping of sway and yaw that follows the motion late.
template <class S = double>
struct FluidMemory {
  S tau{1.0};  ///< lag [s]
  S share{};

  static constexpr std::string_view id = "fluid_memory";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr auto parameters() {
    using P = EffectParameter<FluidMemory, S>;
    return std::array{
        P{.key = "tau_s",
          .member = &FluidMemory::tau,
          .range = positive,
          .null = 1.0,
          .prior = 1.0,
          .scale = ShipUnit::time,
          .decides = false},
        P{.key = "share",
          .member = &FluidMemory::share,
          .range = {-2.0, 2.0},
          .prior = 0.3,
          .floor = 0.05,
          .required = false,
          .fallback = 0.3},
    };
  }
};

/// A force that no other effect knows, from onset to end, as a map of what it goes with: nothing at all, the heading,
/// the motion.
///
/// Coefficients over ½ρL²U_0², of the moment over ½ρL³U_0²; the motion over U_0 and U_0/L.
template <class S = double>
struct UnknownForce {
  S X_0{}, X_cos{}, X_sin{}, X_u{}, X_vv{}, X_vr{}, X_rr{}, X_dd{};
  S Y_0{}, Y_cos{}, Y_sin{}, Y_v{}, Y_r{}, Y_d{}, Y_vv{}, Y_rr{};
  S N_0{}, N_cos{}, N_sin{}, N_v{}, N_r{}, N_d{}, N_vv{}, N_rr{};
  S onset = S(-std::numeric_limits<double>::infinity());  ///< [s]
  S end = S(std::numeric_limits<double>::infinity());     ///< [s]

  static constexpr std::string_view id = "unknown";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr auto parameters() {
    using U = UnknownForce;
    constexpr double never = std::numeric_limits<double>::infinity();
    constexpr auto force = [](std::string_view key, S U::*member) {
      return EffectParameter<U, S>{.key = key, .member = member, .prior = 1e-3, .floor = 2e-5, .required = false};
    };
    constexpr auto moment = [](std::string_view key, S U::*member) {
      return EffectParameter<U, S>{.key = key, .member = member, .prior = 3e-4, .floor = 5e-6, .required = false};
    };
    return std::array{
        force("X_0", &U::X_0),
        force("X_cos", &U::X_cos),
        force("X_sin", &U::X_sin),
        force("X_u", &U::X_u),
        force("X_vv", &U::X_vv),
        force("X_vr", &U::X_vr),
        force("X_rr", &U::X_rr),
        force("X_dd", &U::X_dd),
        force("Y_0", &U::Y_0),
        force("Y_cos", &U::Y_cos),
        force("Y_sin", &U::Y_sin),
        force("Y_v", &U::Y_v),
        force("Y_r", &U::Y_r),
        force("Y_d", &U::Y_d),
        force("Y_vv", &U::Y_vv),
        force("Y_rr", &U::Y_rr),
        moment("N_0", &U::N_0),
        moment("N_cos", &U::N_cos),
        moment("N_sin", &U::N_sin),
        moment("N_v", &U::N_v),
        moment("N_r", &U::N_r),
        moment("N_d", &U::N_d),
        moment("N_vv", &U::N_vv),
        moment("N_rr", &U::N_rr),
        EffectParameter<U, S>{.key = "onset_s",
                              .member = &U::onset,
                              .null = -never,
                              .prior = 5.0,
                              .law = 0.0,
                              .scale = ShipUnit::time,
                              .decides = false,
                              .required = false,
                              .fallback = -never},
        EffectParameter<U, S>{.key = "end_s",
                              .member = &U::end,
                              .null = never,
                              .prior = 5.0,
                              .law = 0.0,
                              .scale = ShipUnit::time,
                              .decides = false,
                              .required = false,
                              .fallback = never},
    };
  }

  bool goes_with_heading_or_time() const {
    if (std::isfinite(onset) || std::isfinite(end)) return true;
    const auto there = [](const S& c) { return !(c == S(0.0)); };
    return there(X_cos) || there(X_sin) || there(Y_cos) || there(Y_sin) || there(N_cos) || there(N_sin);
  }
};

}  // namespace swayaw
