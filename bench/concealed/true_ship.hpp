#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "swayaw/core/channel.hpp"
#include "swayaw/core/motion.hpp"

/// Ships that are not built like the models of swayaw: their forces are computed here and nowhere else.
///
///     hull        linear in (v, r) with the forward speed u, and drag of a cross flow that separates gradually, strip
///                 by strip; or the cubic terms of a Taylor polynomial; or quadratic terms with the size of v and r
///     flow        straightened with a factor that passes smoothly from side to side and saturates
///     rudder      normal force f_alpha a tanh(alpha/a): softens long before it stalls; or a Taylor polynomial; or a
///                 pod that turns its thrust; one or two of them, each behind a propeller of its own
///     propeller   cubic K_T, wake that changes smoothly with the drift, governor and torque of an engine
///     heel        about a metacentric height, with a force of its own on sway and yaw
///
/// Axes, signs and units: docs/notation.md; the rudder angle is positive to port.
namespace swayaw::concealed {

/// Third-order terms of sway and yaw about the way straight ahead at U_0 and every term of the rudder, in v/U_0, rL/U_0
/// and the angle to port:
///
///     Y = ½ρLdU_0² (Y_vvv v³ + Y_vvr v²r + Y_vrr vr² + Y_rrr r³ + (u/U_0)² Y_d δ + Y_ddd δ³ + Y_vvd v²δ + Y_vdd vδ²)
///     X = ½ρLdU_0² (X_dd δ² + X_vd vδ);  N alike, over another L
///
/// Source: [Chislett1965]
struct TaylorTerms {
  double Y_vvv, Y_vvr, Y_vrr, Y_rrr, N_vvv, N_vvr, N_vrr, N_rrr;
  double X_dd, X_vd, Y_d, Y_ddd, Y_vvd, Y_vdd, N_d, N_ddd, N_vvd, N_vdd;
};

/// Second-order terms of sway and yaw in v and rL, odd by the size of one of them:
///
///     Y = ½ρLd (Y_vv |v|v + Y_vr |v|rL + Y_rv |rL|v + Y_rr |rL|rL);  N alike, over another L
///
/// Source: [Fossen2011]
struct ModulusTerms {
  double Y_vv, Y_vr, Y_rv, Y_rr, N_vv, N_vr, N_rv, N_rr;
};

/// Hull primes refer to ½ρLd and to the forward speed, ½ρLdu(Y_v v + Y_r L r), added masses to ½ρL²d and ½ρL⁴d, lengths
/// to L.
struct TrueShip {
  std::string kind;
  double L, B, d, C_B;        ///< [m], block coefficient
  double x_G, k_zz;           ///< over L
  double U_0;                 ///< [m/s]
  double A_front, A_lateral;  ///< [m²]
  double m_x, m_y, J_z;
  double R_0, rise;  ///< ½ρLdR_0 u² (1 + rise (u²/U_0² − 1))
  double Y_v, Y_r, N_v, N_r;
  double C_D, taper, onset;  ///< drag of the cross flow C_D (1 + taper x/L), and the drift at which it sets in
  double X_vv, X_vr, X_rr;
  double D, t_P, w_0;
  std::array<double, 4> K_T;  ///< K_T = Σ K_T[i] J^i
  std::array<double, 2> K_Q;
  double wake_rate, wake_gain,
      wake_sides;  ///< u_P = u (1 − w_0)(1 + (gain ± sides − 1)(1 − exp(−(rate |beta_P|)^1.2)))
  double A_R, H_R, f_alpha, softness;  ///< [m²], [m], [1/rad], a [rad]
  double t_R, a_H, x_H, l_R;
  double gamma, gamma_sides;  ///< flow straightening, mean and what the two sides differ by
  double epsilon, kappa;
  double rudder_rate;  ///< [rad/s]
  double droop, engine_lag,
      inertia;  ///< governor droop, 0 where the shaft keeps its speed; lag [L/U], inertia of the shaft line over that
                ///< of the propeller's torque

  // what only some have
  std::optional<TaylorTerms> taylor = {};    ///< in place of cross flow and of a rudder in a flow
  std::optional<ModulusTerms> modulus = {};  ///< in place of cross flow
  double stall = 0.0;                        ///< angle of attack at which the rudder stalls [rad], 0 for never
  double y_P = 0.0;   ///< two propellers and rudders at ± that [m], 0 for one on the centre line
  bool pods = false;  ///< the propellers turn with the rudder angle
  double GM = 0.0, Y_phi = 0.0, N_phi = 0.0;  ///< heels; force ½ρLdU² Y_phi sin φ, moment over another L

  int screws() const { return y_P > 0.0 ? 2 : 1; }
  double volume() const { return C_B * L * B * d; }
  double time_unit() const { return L / U_0; }
};

/// "tanker", "container", "training".
std::array<std::string_view, 3> ship_kinds();

/// Ships of other structures: "cross_flow", a full ship whose cross flow separates at once and whose rudder stalls;
/// "polynomial", a Taylor polynomial of third order; "rolling", a container ship that heels; "twin_screw", with two
/// rudders that stall; "podded"; "modulus", a supply vessel with terms of second order.
std::array<std::string_view, 6> ship_structures();

/// A ship of that kind or structure with parameters that vary by a few per cent with the seed.
/// @throws std::domain_error  for a kind that there is not
TrueShip true_ship(std::string_view kind, std::uint64_t seed);

/// The same with port and starboard alike.
TrueShip symmetric(TrueShip ship);

/// What is hidden: every number is 0 where it does nothing. SI and radians; coefficients are departures from those of
/// the ship.
struct Concealment {
  double wind_speed = 0, wind_from = 0;
  double gust_speed = 0, gust_from = 0, gust_onset = 0, gust_end = 0;
  double current_speed = 0, current_to = 0;
  double wave_force = 0, wave_from = 0;
  double draught_over_depth = 0;
  double Y_v = 0, Y_r = 0, N_v = 0, N_r = 0;
  double Y_vvr = 0, Y_vrr = 0, N_vvr = 0, N_vrr = 0;
  double cross_flow = 0, resistance = 0;
  double X_vv = 0, X_vr = 0, X_rr = 0;
  double m_y = 0, J_z = 0;
  double lift = 0, a_H = 0, stall_angle = 0, gap_angle = 0, gap_strength = 0;
  double straightening = 0, kappa = 0, side_force = 0;
  double wake_positive = 0, wake_negative = 0;
  double shaft_drop = 0;
  double rudder_offset = 0, rudder_lag = 0, rudder_play = 0;
  double Y_phi = 0, N_phi = 0, GM = 0;
  double memory_share = 0, memory_tau = 0;
  double heading_bias = 0, gyro_bias = 0, log_scale = 0, antenna_x = 0, antenna_y = 0, delay = 0;
  Channel late = Channel::psi;
  // kinds that swayaw does not know
  double kelp = 0;            ///< ½ρLd U_0² kelp (U/U_0)^1.3 against the flow at one bow
  double kelp_place = 0;      ///< to starboard of the centreline [m]
  double tow_line = 0;        ///< the same for a drogue on the starboard quarter, from tow_onset on
  double tow_onset = 0;       ///< [s]
  double fouled_side = 0;     ///< drag of cross flow from starboard only
  double sloshing = 0;        ///< mass of a tank over that of the ship
  double compass_cosine = 0;  ///< heading error · cos(psi) [rad]
  double broken_blade = 0;    ///< side force that beats, ½ρLdU_0²
  double bank = 0;            ///< suction to a bank at a place of the earth, ½ρLdU²
  double tug = 0;             ///< push to starboard of a tug at tug_place from tug_onset to tug_end, ½ρLdU_0²
  double tug_place = 0;       ///< forward of midship [L]
  double tug_onset = 0, tug_end = 0;  ///< [s]
};

/// Place, motion, shaft and what goes on out of sight: roll, lagging flow, water in a tank.
struct State {
  enum Place : std::size_t {
    x,
    y,
    psi,
    u,
    v,
    r,
    shaft,
    engine_torque,
    phi,
    roll_rate,
    slow_v,
    slow_r,
    tank,
    tank_rate
  };
};
inline constexpr std::size_t state_count = State::tank_rate + 1;
using States = std::array<double, state_count>;

/// A point at which the engine runs steadily.
struct ShaftPoint {
  double rev;     ///< [1/s]
  double torque;  ///< [N m]
};

/// What acts from outside in a moment.
struct Moment {
  double time;       ///< of the run [s]
  double delta;      ///< true rudder angle, positive to port [rad]
  ShaftPoint order;  ///< of the governor
  PlanarAcceleration<double> disturbance;
  double turbulence;  ///< share of the wind speed
};

/// Forces by part; wind, waves and all that is hidden besides stand under `other`.
struct TrueForces {
  PlanarForce<double> hull, propeller, rudder, other;
};

TrueForces forces(const TrueShip& ship, const Concealment& hidden, const States& s, const Moment& now);

/// Angle at which she heels in a steady motion [rad], starboard side down positive.
double steady_heel(const TrueShip& ship, double u, double r);

/// Time derivatives of all states.
States rates(const TrueShip& ship, const Concealment& hidden, const States& s, const Moment& now);

/// Shaft speed [1/s] and torque [N m] that keep the speed on a straight course with nothing hidden.
ShaftPoint self_propulsion(const TrueShip& ship, double speed);

inline constexpr double stall_span = 0.35;  ///< over which a stalling rudder loses half of its lift [rad]

/// Share of the lift that a gap leaves, 1/(1 − s x²) for x beyond an angle.
double kept_through_gap(double delta, double from, double strength);

}  // namespace swayaw::concealed
