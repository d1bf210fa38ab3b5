#pragma once

#include <numbers>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/motion.hpp"
#include "swayaw/nonlinear/models/parts/lifting_line_rudder.hpp"
#include "swayaw/nonlinear/models/parts/propeller_race.hpp"
#include "swayaw/nonlinear/models/parts/rudder_lift_loss.hpp"

/// Lift and drag of the semi-empirical rudder in the race of its propeller. Valid for way ahead.
/// Source: [Alexandersson2024] section 2.2, appendix B.2
namespace swayaw::inline nonlinear {

/// Water that meets one rudder, from ahead.
template <class S>
struct RudderInflow {
  S V_RxC;  ///< axial, in the race [m/s]
  S V_RxU;  ///< axial, outside the race [m/s]
  S V_Ry;   ///< transverse, positive where it makes lift to starboard [m/s]
  S gamma;  ///< atan(V_Ry/V_RxC) [rad]
};

/// −r x_R − v: transverse speed at the rudder if nothing straightened the flow; gamma_g has its sign [m/s].
template <class S>
S geometric_crossflow(const LiftingLineRudder<S>& k, const PlanarMotion<S>& m) {
  return -m.r * k.x_R - m.v;
}

/// Flow straightening, which grows with the geometric inflow angle.
///
///     V_RxC = V_corr − r y_R,   V_RxU = V_A − r y_R
///     gamma_g = atan((−r x_R − v)/V_RxC)
///     V_Ry = −(kappa_r + kappa_r,gamma |gamma_g|) r x_R − (kappa_v + kappa_v,gamma |gamma_g|) v
///
/// Source: [Alexandersson2024] eqs (17)–(21), (B.20), (B.26), (B.27)
template <class S>
RudderInflow<S> rudder_inflow(const LiftingLineRudder<S>& k, const PlanarMotion<S>& m, const PropellerRace<S>& race,
                              const S& y_R, const Mask<S>& gamma_g_positive) {
  const S V_RxC = race.V_corr - m.r * y_R;
  const S gamma_g = angle_of(geometric_crossflow(k, m), V_RxC);
  const S size = select(gamma_g_positive, gamma_g, S(-gamma_g));  // |gamma_g|
  const S V_Ry = -(k.kappa_r + k.kappa_r_gamma * size) * m.r * k.x_R - (k.kappa_v + k.kappa_v_gamma * size) * m.v;
  return {.V_RxC = V_RxC, .V_RxU = race.V_A - m.r * y_R, .V_Ry = V_Ry, .gamma = angle_of(V_Ry, V_RxC)};
}

/// What the gap between rudder and horn leaves of the lift: 1 while it is closed, 1 + s (|delta| − delta_lim)² when
/// open; with `gap_factor = "clipped"` never below 0. Source: [Alexandersson2024] eq (30)
template <class S>
S gap_factor(const LiftingLineRudder<S>& k, const S& delta, const Mask<S>& open, const Mask<S>& lifts) {
  const S beyond = abs(delta) - k.delta_lim;
  const S K_gap = select(open, S(1.0 + k.s * beyond * beyond), S(1.0));
  return k.gap_clipped() ? select(lifts, K_gap, S(0.0)) : K_gap;
}

/// Numbers of the planform.
template <class S>
struct Planform {
  S AR_e;        ///< effective aspect ratio
  S slope;       ///< dC_L/dalpha [1/rad]
  S cross_flow;  ///< C_D of the flow across the tip
  S chord;       ///< mean [m]
};

/// Whicker and Fehlner's rudder with squared tips.
///
///     AR_e = 2 b_R²/A_R
///     dC_L/dalpha = a_0 AR_e/(cos(Omega) sqrt(AR_e²/cos⁴(Omega) + 4) + 1.8),   a_0 = 1.8π
///     C_DC = 0.1 + 1.6 c_t/c_r
///
/// Source: [Alexandersson2024] eqs (28), (29), (31)–(34), (B.25); (31) is printed with the root over 1.8
template <class S>
Planform<S> planform(const LiftingLineRudder<S>& k) {
  const S AR_e = k.AR_factor * k.b_R * k.b_R / k.A_R;
  const S cos_Omega = cos(k.Omega);
  const S swept = AR_e / (cos_Omega * cos_Omega);
  return {
      .AR_e = AR_e,
      .slope = 1.8 * pi * AR_e / (cos_Omega * sqrt(swept * swept + 4.0) + 1.8),
      .cross_flow = 0.1 + 1.6 * k.c_t / k.c_r,
      .chord = 0.5 * (k.c_r + k.c_t),
  };
}

/// Friction of a flat plate at a Reynolds number, 0.075/(log10 Re − 2)² of ITTC 1957,
/// or 0.075/log10(Re − 2)² as the model was published, 2.7 times less at 1.3e5.
/// Below Re = 1e3, where nothing is turbulent and the formulas have their pole, it stays as it is there: the force then
/// vanishes with the speed. Source: [Alexandersson2024] eqs (B.8)–(B.11)
template <class S>
S friction_coefficient(const S& reynolds, bool ittc57) {
  const S Re = greater(reynolds, S(1e3));
  constexpr double ln10 = std::numbers::ln10;
  const S logarithm = ittc57 ? S(log(Re) - 2.0 * ln10) : S(log(Re - 2.0));
  return 0.075 * ln10 * ln10 / (logarithm * logarithm);
}

/// Lift and drag of one rudder.
template <class S>
struct LiftAndDrag {
  S lift;  ///< across the inflow, positive to starboard [N]
  S drag;  ///< along the inflow [N]
};

/// Lift and drag of the parts in the race (C) and outside it (U).
///
///     C_L = K_gap f (dC_L/dalpha alpha + C_DC alpha |alpha|/AR_e),   f = 1 unless a lift factor or stall_factor(alpha)
///     is there L_R = ½ρ C_L (lambda_R A_RC V_RC² + A_RU V_RU²) D_R = ½ρ (A_RC C_D(V_RC) V_RC² + A_RU C_D(V_RU) V_RU²),
///     C_D(V) = 2.5 C_D0,tune C_F(V c/nu) + C_D,tune C_L²/(π AR_e e_0)
///
/// Source: [Alexandersson2024] eqs (23)–(27), (35), (B.4)–(B.7), (B.21), (B.28)
template <class S>
LiftAndDrag<S> lift_and_drag(const LiftingLineRudder<S>& k, const S& rho, const S& nu, const Planform<S>& plan,
                             const S& lambda_R, const RudderInflow<S>& in, const S& alpha,
                             const Mask<S>& alpha_positive, const S& K_gap) {
  const S size = select(alpha_positive, alpha, S(-alpha));  // |alpha|
  S C_L = K_gap * k.lift_factor * alpha * (plan.slope + plan.cross_flow * size / plan.AR_e);
  if (any(k.alpha_s > S(0.0))) C_L = C_L * stall_factor(k.stall(), alpha);
  const S A_RU = select(k.A_RU > S(0.0), k.A_RU, S(k.A_R - k.A_RC));
  const S VV_C = in.V_RxC * in.V_RxC + in.V_Ry * in.V_Ry;  // V_RC²
  const S VV_U = in.V_RxU * in.V_RxU + in.V_Ry * in.V_Ry;  // V_RU²
  const S dynamic_C = 0.5 * rho * k.A_RC * VV_C;
  const S dynamic_U = 0.5 * rho * A_RU * VV_U;
  const S induced = k.C_D_tune * C_L * C_L / (pi * plan.AR_e * k.e_0);
  const S C_FC = friction_coefficient(S(sqrt(VV_C) * plan.chord / nu), k.ittc57());
  const S C_FU = friction_coefficient(S(sqrt(VV_U) * plan.chord / nu), k.ittc57());
  return {
      .lift = C_L * (lambda_R * dynamic_C + dynamic_U),
      .drag = 2.5 * k.C_D0_tune * (dynamic_C * C_FC + dynamic_U * C_FU) + induced * (dynamic_C + dynamic_U),
  };
}

/// Lift and drag turned from the inflow to the ship, alpha_f = gamma_0 + gamma.
///
///     X_R = −D_R cos(alpha_f) + L_R sin(alpha_f)
///     Y_R =  D_R sin(alpha_f) + L_R cos(alpha_f)
///     N_R = x_R Y_R − y_R X_R
///
/// Source: [Alexandersson2024] eqs (14)–(16), (22), which lacks −y_R X_R
template <class S>
PlanarForce<S> turned_to_ship(const LiftAndDrag<S>& f, const S& alpha_f, const S& x_R, const S& y_R) {
  const auto [sine, cosine] = sin_cos(alpha_f);
  const S X = f.lift * sine - f.drag * cosine;
  const S Y = f.drag * sine + f.lift * cosine;
  return {.X = X, .Y = Y, .N = x_R * Y - y_R * X};
}

/// Force on the hull that the rudder's lift induces, Y_RHI = a_H Y_R and N_RHI = x_H x_R Y_R.
/// Source: [Alexandersson2024] eqs (12), (13)
template <class S>
PlanarForce<S> rudder_hull_interaction(const LiftingLineRudder<S>& k, const PlanarForce<S>& rudder) {
  return {.X = S(0.0), .Y = k.a_H * rudder.Y, .N = k.x_H * k.x_R * rudder.Y};
}

}  // namespace swayaw::nonlinear
