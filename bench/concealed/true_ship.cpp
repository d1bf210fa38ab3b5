#include "true_ship.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "random_source.hpp"
#include "swayaw/core/angle.hpp"

namespace swayaw::concealed {
namespace {

constexpr double rho = 1025.0, rho_air = 1.225, gravity = 9.81;

using Force = PlanarForce<double>;

double square(double a) { return a * a; }

double polynomial(const auto& coefficients, double J) {
  double sum = 0.0;
  for (auto k = coefficients.rbegin(); k != coefficients.rend(); ++k) sum = sum * J + *k;
  return sum;
}

Force operator*(double a, const Force& f) { return {a * f.X, a * f.Y, a * f.N}; }

/// A force at a place of the ship.
Force at(double X, double Y, double x_place, double y_place = 0.0) { return {X, Y, x_place * Y - y_place * X}; }

// ---------------------------------------------------------------- hull

/// What a finite depth does: Kijima's (1 − d/h)^−n − d/h, with an exponent of its own for each number.
double shallow(double ratio, double exponent) { return ratio > 0.0 ? std::pow(1.0 - ratio, -exponent) - ratio : 1.0; }

/// ½ρd ∫ C_D(x) |w| w (1, x) dx, w = v + xr, by Simpson's rule; only one direction of the flow where asked. The flow
/// separates gradually: the drag grows with w³ until w is about `onset`.
Force cross_flow(const TrueShip& s, double C_D, double taper, double v, double r, double onset, bool one_side = false) {
  constexpr int strips = 40;
  Force sum{};
  for (int i = 0; i <= strips; ++i) {
    const double place = (static_cast<double>(i) / strips - 0.5) * s.L, flow = v + place * r;
    if (one_side && flow < 0.0) continue;
    const double weight = (i == 0 || i == strips ? 1.0 : i % 2 ? 4.0 : 2.0) * s.L / (3.0 * strips);
    const double drag =
        -0.5 * rho * s.d * C_D * (1.0 + taper * place / s.L) * flow * flow * flow / std::hypot(flow, onset) * weight;
    sum = sum + at(0.0, drag, place);
  }
  return sum;
}

/// Linear damping ½ρLdu (Y_v v + Y_r L r), without the hidden part that follows late.
Force linear_damping(const TrueShip& s, const Concealment& h, double u, double v, double r) {
  const double q = 0.5 * rho * s.L * s.d * u, x = h.draught_over_depth;
  const double Y_v = (s.Y_v + h.Y_v) * shallow(x, 0.75), Y_r = (s.Y_r + h.Y_r) * shallow(x, 0.55);
  const double N_v = (s.N_v + h.N_v) * shallow(x, 0.80), N_r = (s.N_r + h.N_r) * shallow(x, 0.55);
  return {0.0, q * (Y_v * v + Y_r * s.L * r), q * s.L * (N_v * v + N_r * s.L * r)};
}

/// Cubic terms of a Taylor polynomial about U_0, in v and rL.
Force taylor_hull(const TrueShip& s, const TaylorTerms& c, double v, double r) {
  const double unit = 0.5 * rho * s.L * s.d / s.U_0, a = v, b = r * s.L;
  return {0.0, unit * (c.Y_vvv * a * a * a + c.Y_vvr * a * a * b + c.Y_vrr * a * b * b + c.Y_rrr * b * b * b),
          unit * s.L * (c.N_vvv * a * a * a + c.N_vvr * a * a * b + c.N_vrr * a * b * b + c.N_rrr * b * b * b)};
}

/// Quadratic terms with the size of v or rL.
Force modulus_hull(const TrueShip& s, const ModulusTerms& c, double v, double r) {
  const double unit = 0.5 * rho * s.L * s.d, a = v, b = r * s.L, size_a = std::abs(a), size_b = std::abs(b);
  return {0.0, unit * (c.Y_vv * size_a * a + c.Y_vr * size_a * b + c.Y_rv * size_b * a + c.Y_rr * size_b * b),
          unit * s.L * (c.N_vv * size_a * a + c.N_vr * size_a * b + c.N_rv * size_b * a + c.N_rr * size_b * b)};
}

/// ½ρLdU² (Y_φ, L N_φ) sin φ
Force heeled(const TrueShip& s, const States& q, double Y_phi, double N_phi) {
  const double dynamic = 0.5 * rho * s.L * s.d * (square(q[State::u]) + square(q[State::v])),
               lean = std::sin(q[State::phi]);
  return {0.0, dynamic * Y_phi * lean, dynamic * s.L * N_phi * lean};
}

Force hull(const TrueShip& s, const Concealment& h, const States& q) {
  const double u = q[State::u], v = q[State::v], r = q[State::r], U = std::hypot(u, v);
  const double v_prime = v / U, r_prime = r * s.L / U, x = h.draught_over_depth,
               dynamic = 0.5 * rho * s.L * s.d * U * U;
  const double R = 0.5 * rho * s.L * s.d * s.R_0 * u * std::abs(u) * (1.0 + s.rise * (square(u / s.U_0) - 1.0)) *
                   (1.0 + h.resistance) * (1.0 + 0.45 * x * x);
  const double surge = (s.X_vv + h.X_vv) * v_prime * v_prime * square(u / U) + (s.X_vr + h.X_vr) * v_prime * r_prime +
                       (s.X_rr + h.X_rr) * r_prime * r_prime;
  const double under_keel = 1.0 + 2.0 * x * x * x;  // of the drag across, in shallow water
  // cubic terms that level off
  const double level = 1.0 / (1.0 + v_prime * v_prime + 0.25 * r_prime * r_prime),
               vvr = level * v_prime * v_prime * r_prime, vrr = level * v_prime * r_prime * r_prime;
  const Force cubic{0.0, dynamic * (h.Y_vvr * vvr + h.Y_vrr * vrr), dynamic * s.L * (h.N_vvr * vvr + h.N_vrr * vrr)};
  Force sum = linear_damping(s, h, u, v, r) + cross_flow(s, s.C_D * under_keel, s.taper, v, r, s.onset * u) + cubic +
              Force{dynamic * surge - R, 0.0, 0.0};
  if (h.cross_flow != 0.0) sum = sum + cross_flow(s, h.cross_flow, 0.1, v, r, 0.02 * u);
  if (s.taylor) sum = sum + under_keel * taylor_hull(s, *s.taylor, v, r);
  if (s.modulus) sum = sum + under_keel * modulus_hull(s, *s.modulus, v, r);
  if (s.GM > 0.0) sum = sum + heeled(s, q, s.Y_phi, s.N_phi);
  if (h.fouled_side != 0.0) sum = sum + cross_flow(s, h.fouled_side, 0.0, v, r, 0.02 * u, true);
  if (h.memory_share != 0.0) {
    const Force late = linear_damping(s, h, u, q[State::slow_v], q[State::slow_r]), now = linear_damping(s, h, u, v, r);
    sum = sum + h.memory_share * (late + -1.0 * now);
  }
  return sum;
}

// ---------------------------------------------------------------- propeller and rudder

/// Axial speed at the propeller.
double inflow(const TrueShip& s, const Concealment& h, const States& q) {
  const double U = std::hypot(q[State::u], q[State::v]), beta_P = -(q[State::v] - 0.48 * s.L * q[State::r]) / U,
               side = std::tanh(beta_P / 0.02);
  const double gain =
      s.wake_gain + s.wake_sides * side + 0.5 * (1.0 + side) * h.wake_positive + 0.5 * (1.0 - side) * h.wake_negative;
  const double straight = 1.0 - s.w_0 * (1.0 + 0.25 * h.draught_over_depth);
  return q[State::u] * straight * (1.0 + (gain - 1.0) * -std::expm1(-std::pow(s.wake_rate * std::abs(beta_P), 1.2)));
}

double advance(const TrueShip& s, double u_P, double rev) { return u_P / (std::max(rev, 1e-3) * s.D); }

/// Shaft speed that the propeller really has: a tired engine gives way in a turn, however it is governed.
double true_rev(const TrueShip& s, const Concealment& h, const States& q) {
  const double load =
      std::tanh(std::abs(q[State::r]) * s.L / std::hypot(q[State::u], q[State::v]) / 0.6) / std::tanh(1.0);
  return q[State::shaft] * (1.0 - h.shaft_drop * load);
}

double thrust(const TrueShip& s, double u_P, double rev) {
  return rho * rev * rev * std::pow(s.D, 4) * polynomial(s.K_T, advance(s, u_P, rev));
}
double torque(const TrueShip& s, double u_P, double rev) {
  return rho * rev * rev * std::pow(s.D, 5) * polynomial(s.K_Q, advance(s, u_P, rev));
}

/// Share of the lift that a stalled rudder keeps: half of it goes over stall_span.
double after_stall(double angle, double stall) {
  if (stall <= 0.0) return 1.0;
  const double t = std::clamp((std::abs(angle) - stall) / stall_span, 0.0, 1.0);
  return 1.0 - 0.5 * t * t * (3.0 - 2.0 * t);
}

double through_gap(double delta, const Concealment& h) { return kept_through_gap(delta, h.gap_angle, h.gap_strength); }

/// Every term of a Taylor polynomial with the rudder angle.
Force taylor_rudder(const TrueShip& s, const Concealment& h, const States& q, double delta) {
  const auto& c = *s.taylor;
  const double u = q[State::u] / s.U_0, v = q[State::v] / s.U_0, d = delta;
  const double unit =
      0.5 * rho * s.L * s.d * s.U_0 * s.U_0 * (1.0 + h.lift) * after_stall(d, h.stall_angle) * through_gap(d, h);
  return {unit * (c.X_dd * d * d + c.X_vd * v * d),
          unit * (u * u * c.Y_d * d + c.Y_ddd * d * d * d + c.Y_vvd * v * v * d + c.Y_vdd * v * d * d),
          unit * s.L * (u * u * c.N_d * d + c.N_ddd * d * d * d + c.N_vvd * v * v * d + c.N_vdd * v * d * d)};
}

/// What a pod changes by turning its thrust, without the lift of its strut.
Force turned_thrust(const TrueShip& s, const Concealment& h, double delta, double T) {
  const double Y = (1.0 + h.lift) * T * std::sin(delta);
  return {-(1.0 - s.t_P) * T * (1.0 - std::cos(delta)), Y, -0.48 * s.L * Y};
}

Force rudder(const TrueShip& s, const Concealment& h, const States& q, double delta_to_port, double u_P, double T) {
  if (s.taylor) return taylor_rudder(s, h, q, delta_to_port);
  const double U = std::hypot(q[State::u], q[State::v]), delta = -delta_to_port;
  // drift at the rudder; the hull turns the flow into its own direction, less so where it is steep
  const double beta_R = -(q[State::v] + s.l_R * s.L * q[State::r]) / U;
  const double x = h.draught_over_depth, side = std::tanh(beta_R / 0.02);
  const double factor = (s.gamma + s.gamma_sides * side) * (1.0 + h.straightening) * (1.0 + 0.6 * x * x);
  const double v_R = U * factor * 1.5 * std::tanh(beta_R / 1.5);
  const double race = std::sqrt(std::max(0.0, u_P * u_P + 8.0 * T / (pi * rho * s.D * s.D)));
  const double eta = s.D / s.H_R, behind = u_P + (s.kappa + h.kappa) * (race - u_P);
  const double u_R = s.epsilon * std::sqrt(eta * behind * behind + (1.0 - eta) * u_P * u_P);
  const double alpha = delta - std::atan2(v_R, u_R);
  const double F_N = 0.5 * rho * s.A_R * s.f_alpha * (1.0 + h.lift) * (u_R * u_R + v_R * v_R) * s.softness *
                     std::tanh(alpha / s.softness) * after_stall(alpha, h.stall_angle) * after_stall(alpha, s.stall) *
                     through_gap(delta, h);
  const double a_H = s.a_H + h.a_H;
  const Force lift{-(1.0 - s.t_R) * F_N * std::sin(delta), -(1.0 + a_H) * F_N * std::cos(delta),
                   -(-0.5 + a_H * s.x_H) * s.L * F_N * std::cos(delta)};
  return s.pods ? lift + turned_thrust(s, h, delta_to_port, T) : lift;
}

// ---------------------------------------------------------------- air, waves, and the rest

Force wind_load(const TrueShip& s, double V, double from, const States& q, double u_ground, double v_ground) {
  const double relative = from - q[State::psi], a_u = V * std::cos(relative) + u_ground,
               a_v = V * std::sin(relative) + v_ground;
  const double dynamic = 0.5 * rho_air * (a_u * a_u + a_v * a_v), angle = std::atan2(a_v, a_u);
  const double C_Y = -0.78 * std::sin(angle) * (1.0 + 0.12 * square(std::sin(2.0 * angle)));
  return {dynamic * s.A_front * (-0.72 * std::cos(angle) - 0.08 * std::cos(3.0 * angle)), dynamic * s.A_lateral * C_Y,
          -0.085 * dynamic * s.A_lateral * s.L * std::sin(2.0 * angle)};
}

double gust_now(const TrueShip& s, const Concealment& h, double time) {
  const double edge = 0.2 * s.time_unit(), in = (time - h.gust_onset) / edge, out = (h.gust_end - time) / edge;
  return h.gust_speed * std::clamp(std::min(in, out) + 0.5, 0.0, 1.0);
}

Force air(const TrueShip& s, const Concealment& h, const States& q, const Moment& now) {
  const double gust = h.gust_speed > 0.0 ? gust_now(s, h, now.time) : 0.0;
  if (h.wind_speed <= 0.0 && gust <= 0.0) return {};
  const double north = h.wind_speed * std::cos(h.wind_from) + gust * std::cos(h.gust_from),
               east = h.wind_speed * std::sin(h.wind_from) + gust * std::sin(h.gust_from);
  const double drift = h.current_to - q[State::psi];
  return wind_load(s, std::hypot(north, east) * (1.0 + now.turbulence), std::atan2(east, north), q,
                   q[State::u] + h.current_speed * std::cos(drift), q[State::v] + h.current_speed * std::sin(drift));
}

Force waves(const TrueShip& s, const Concealment& h, const States& q) {
  const double a = h.wave_from - q[State::psi], beam = std::sin(a);
  return h.wave_force * Force{-0.28 * std::cos(a) * (1.0 + 0.15 * std::cos(a)), -beam * std::pow(std::abs(beam), 0.8),
                              -0.05 * s.L * std::sin(2.0 * a)};
}

/// Forces that no effect of swayaw is like.
Force unknown(const TrueShip& s, const Concealment& h, const States& q, const Moment& now) {
  const double unit = 0.5 * rho * s.L * s.d * s.U_0 * s.U_0, u = q[State::u], v = q[State::v], r = q[State::r];
  Force sum{};
  const auto drag = [&](double size, double power, double x_place, double y_place) {
    const double a = u - y_place * r, b = v + x_place * r, U = std::hypot(a, b),
                 f = -size * unit * std::pow(U / s.U_0, power) / U;
    sum = sum + at(f * a, f * b, x_place, y_place);
  };
  if (h.kelp != 0.0) drag(h.kelp, 1.3, 0.45 * s.L, h.kelp_place);
  if (h.tow_line != 0.0 && now.time >= h.tow_onset) drag(h.tow_line, 0.5, -0.48 * s.L, 0.4 * s.B);
  if (h.broken_blade != 0.0)
    sum = sum + at(0.0, h.broken_blade * unit * std::sin(2.0 * pi * now.time / (0.8 * s.time_unit())), -0.48 * s.L);
  if (h.bank != 0.0) {
    const double away = (q[State::y] - 2.0 * s.L) / (1.5 * s.L),
                 pull = h.bank * unit * (u * u + v * v) / square(s.U_0) * std::exp(-away * away);
    sum = sum + at(0.0, pull * std::cos(q[State::psi]), -0.25 * s.L);
  }
  if (h.tug != 0.0 && now.time >= h.tug_onset && now.time < h.tug_end)
    sum = sum + at(0.0, h.tug * unit, h.tug_place * s.L);
  if (h.sloshing != 0.0)
    sum = sum +
          at(0.0, h.sloshing * rho * s.volume() * square(2.0 * pi / (1.5 * s.time_unit())) * q[State::tank], 0.1 * s.L);
  return sum;
}

}  // namespace

double kept_through_gap(double delta, double from, double strength) {
  return strength < 0.0 ? 1.0 / (1.0 - strength * square(std::max(0.0, std::abs(delta) - from))) : 1.0;
}

double steady_heel(const TrueShip& s, double u, double r) {
  return s.GM > 0.0 ? -std::asin(std::clamp(0.5 * s.d * u * r / (gravity * s.GM), -0.5, 0.5)) : 0.0;
}

TrueForces forces(const TrueShip& s, const Concealment& h, const States& q, const Moment& now) {
  const double t_P = s.t_P * (1.0 + 0.3 * h.draught_over_depth), rev = true_rev(s, h, q);
  double T = 0.0;
  Force propeller{}, rudders{};
  for (int screw = 0; screw < s.screws(); ++screw) {
    const double y = (2 * screw - s.screws() + 1) * s.y_P;
    States here = q;
    here[State::u] -= y * q[State::r];  // of the water that meets it
    const double u_P = inflow(s, h, here), T_P = thrust(s, u_P, rev);
    const Force steering = rudder(s, h, here, now.delta, u_P, T_P);
    T += T_P;
    propeller = propeller + at((1.0 - t_P) * T_P, 0.0, 0.0, y);
    rudders = rudders + steering + Force{0.0, 0.0, -y * steering.X};
  }
  const Force side = at(0.0, h.side_force * T, -0.48 * s.L);
  return {.hull = hull(s, h, q),
          .propeller = propeller,
          .rudder = rudders,
          .other = air(s, h, q, now) + waves(s, h, q) + heeled(s, q, h.Y_phi, h.N_phi) + side + unknown(s, h, q, now)};
}

States rates(const TrueShip& s, const Concealment& h, const States& q, const Moment& now) {
  const auto f = forces(s, h, q, now);
  const Force sum = f.hull + f.propeller + f.rudder + f.other;
  const double m = rho * s.volume(), added = 0.5 * rho * s.L * s.L * s.d, x = h.draught_over_depth, x_G = s.x_G * s.L;
  const double m_u = m + added * s.m_x * (1.0 + 0.8 * x * x),
               m_v = m + added * (s.m_y + h.m_y) * (1.0 + 2.2 * std::pow(x, 3.5));
  const double inertia =
      m * (square(s.k_zz * s.L) + x_G * x_G) + added * s.L * s.L * (s.J_z + h.J_z) * (1.0 + 1.5 * std::pow(x, 3.5));
  const double u = q[State::u], v = q[State::v], r = q[State::r], c = std::cos(q[State::psi]),
               e = std::sin(q[State::psi]);
  const double Y = sum.Y - m_u * u * r, N = sum.N - m * x_G * u * r, det = m_v * inertia - square(m * x_G);
  States d{};
  d[State::x] = u * c - v * e + h.current_speed * std::cos(h.current_to);
  d[State::y] = u * e + v * c + h.current_speed * std::sin(h.current_to);
  d[State::psi] = r;
  d[State::u] = (sum.X + m_v * v * r + m * x_G * r * r) / m_u + now.disturbance.u;
  d[State::v] = (inertia * Y - m * x_G * N) / det + now.disturbance.v;
  d[State::r] = (m_v * N - m * x_G * Y) / det + now.disturbance.r;
  // a governor with droop asks for torque, and the engine gives it late
  if (const auto& ordered = now.order; s.droop > 0.0) {
    const double wanted =
        ordered.torque * std::clamp(1.0 + (ordered.rev - q[State::shaft]) / (s.droop * ordered.rev), 0.0, 1.3);
    d[State::engine_torque] = (wanted - q[State::engine_torque]) / (s.engine_lag * s.time_unit());
    d[State::shaft] = (q[State::engine_torque] - torque(s, inflow(s, h, q), q[State::shaft])) * ordered.rev /
                      (s.inertia * s.time_unit() * ordered.torque);
  }
  // roll about a metacentric height, damped at a tenth of critical: what holds her sideways does so half a draught
  // below the centre of gravity, her rudders a little deeper
  if (const double GM = h.GM > 0.0 ? h.GM : s.GM; GM > 0.0) {
    const double k = 0.4 * s.B, omega2 = gravity * GM / (k * k), side = d[State::v] + x_G * d[State::r] + u * r;
    d[State::phi] = q[State::roll_rate];
    d[State::roll_rate] = -0.2 * std::sqrt(omega2) * q[State::roll_rate] - omega2 * std::sin(q[State::phi]) -
                          s.d * (0.5 * side + 0.15 * f.rudder.Y / m) / (k * k);
  }
  if (h.memory_tau > 0.0) {
    d[State::slow_v] = (v - q[State::slow_v]) / h.memory_tau;
    d[State::slow_r] = (r - q[State::slow_r]) / h.memory_tau;
  }
  if (h.sloshing != 0.0) {
    const double omega = 2.0 * pi / (1.5 * s.time_unit());
    d[State::tank] = q[State::tank_rate];
    d[State::tank_rate] = -0.1 * omega * q[State::tank_rate] - omega * omega * q[State::tank] - d[State::v] - u * r;
  }
  return d;
}

ShaftPoint self_propulsion(const TrueShip& s, double speed) {
  const double u_P = speed * (1.0 - s.w_0),
               R = 0.5 * rho * s.L * s.d * s.R_0 * speed * speed * (1.0 + s.rise * (square(speed / s.U_0) - 1.0));
  double low = 0.3 * u_P / s.D, high = 20.0 * u_P / s.D;
  for (int i = 0; i < 60; ++i) {
    const double rev = 0.5 * (low + high);
    (s.screws() * (1.0 - s.t_P) * thrust(s, u_P, rev) < R ? low : high) = rev;
  }
  return {low, torque(s, u_P, low)};
}

// ---------------------------------------------------------------- fleet

namespace {

/// Particulars and coefficients near those published for a KVLCC2, a KCS and a training ship of 90 m; what the sources
/// do not tell is usual.
TrueShip tanker() {
  return {.kind = "tanker",
          .L = 320.0,
          .B = 58.0,
          .d = 20.8,
          .C_B = 0.81,
          .x_G = 0.035,
          .k_zz = 0.25,
          .U_0 = 7.97,
          .A_front = 1160.0,
          .A_lateral = 3650.0,
          .m_x = 0.022,
          .m_y = 0.223,
          .J_z = 0.011,
          .R_0 = 0.022,
          .rise = 0.06,
          .Y_v = -0.29,
          .Y_r = 0.07,
          .N_v = -0.146,
          .N_r = -0.046,
          .C_D = 2.2,
          .taper = -0.2,
          .onset = 0.80,
          .X_vv = 0.03,
          .X_vr = -0.140,
          .X_rr = 0.020,
          .D = 9.86,
          .t_P = 0.22,
          .w_0 = 0.35,
          .K_T = {0.2931, -0.2600, -0.1700, 0.0200},
          .K_Q = {0.031, -0.025},
          .wake_rate = 3.0,
          .wake_gain = 1.35,
          .wake_sides = 0.20,
          .A_R = 86.0,
          .H_R = 15.8,
          .f_alpha = 2.747,
          .softness = 1.05,
          .t_R = 0.387,
          .a_H = 0.312,
          .x_H = -0.464,
          .l_R = -0.71,
          .gamma = 0.50,
          .gamma_sides = 0.11,
          .epsilon = 1.09,
          .kappa = 0.5,
          .rudder_rate = radians(2.6),
          .droop = 0.12,
          .engine_lag = 0.15,
          .inertia = 0.05};
}

TrueShip container() {
  return {.kind = "container",
          .L = 230.0,
          .B = 32.2,
          .d = 10.8,
          .C_B = 0.651,
          .x_G = -0.015,
          .k_zz = 0.245,
          .U_0 = 11.5,
          .A_front = 950.0,
          .A_lateral = 4300.0,
          .m_x = 0.010,
          .m_y = 0.145,
          .J_z = 0.0085,
          .R_0 = 0.0150,
          .rise = 0.08,
          .Y_v = -0.215,
          .Y_r = 0.045,
          .N_v = -0.108,
          .N_r = -0.044,
          .C_D = 2.1,
          .taper = -0.3,
          .onset = 0.80,
          .X_vv = -0.05,
          .X_vr = -0.100,
          .X_rr = -0.005,
          .D = 7.9,
          .t_P = 0.20,
          .w_0 = 0.30,
          .K_T = {0.5228, -0.4300, -0.0900, 0.0200},
          .K_Q = {0.080, -0.060},
          .wake_rate = 3.5,
          .wake_gain = 1.25,
          .wake_sides = 0.12,
          .A_R = 40.0,
          .H_R = 8.4,
          .f_alpha = 2.60,
          .softness = 1.1,
          .t_R = 0.26,
          .a_H = 0.32,
          .x_H = -0.44,
          .l_R = -0.75,
          .gamma = 0.43,
          .gamma_sides = 0.06,
          .epsilon = 0.98,
          .kappa = 0.60,
          .rudder_rate = radians(2.8),
          .droop = 0.15,
          .engine_lag = 0.20,
          .inertia = 0.06};
}

TrueShip training() {
  return {.kind = "training",
          .L = 90.0,
          .B = 14.6,
          .d = 5.3,
          .C_B = 0.60,
          .x_G = -0.010,
          .k_zz = 0.245,
          .U_0 = 7.2,
          .A_front = 150.0,
          .A_lateral = 720.0,
          .m_x = 0.012,
          .m_y = 0.165,
          .J_z = 0.0095,
          .R_0 = 0.0185,
          .rise = 0.08,
          .Y_v = -0.255,
          .Y_r = 0.052,
          .N_v = -0.112,
          .N_r = -0.050,
          .C_D = 2.1,
          .taper = -0.15,
          .onset = 0.80,
          .X_vv = -0.04,
          .X_vr = -0.095,
          .X_rr = 0.002,
          .D = 3.7,
          .t_P = 0.19,
          .w_0 = 0.24,
          .K_T = {0.4200, -0.3700, -0.1000, 0.0200},
          .K_Q = {0.060, -0.046},
          .wake_rate = 3.0,
          .wake_gain = 1.22,
          .wake_sides = 0.08,
          .A_R = 9.2,
          .H_R = 4.1,
          .f_alpha = 2.55,
          .softness = 1.0,
          .t_R = 0.28,
          .a_H = 0.27,
          .x_H = -0.43,
          .l_R = -0.78,
          .gamma = 0.46,
          .gamma_sides = 0.04,
          .epsilon = 1.02,
          .kappa = 0.58,
          .rudder_rate = radians(3.2),
          .droop = 0.10,
          .engine_lag = 0.25,
          .inertia = 0.08};
}

/// A full tanker whose cross flow separates at once and whose rudder stalls.
TrueShip cross_flow_ship() {
  TrueShip s = tanker();
  s.kind = "cross_flow";
  s.L = 240.0, s.B = 42.0, s.d = 14.9, s.C_B = 0.83, s.U_0 = 7.4, s.D = 7.2, s.H_R = 10.6, s.A_R = 56.0;
  s.A_front = 820.0, s.A_lateral = 2600.0;
  s.C_D = 1.05, s.taper = -0.5, s.onset = 0.03, s.Y_v = -0.34, s.N_r = -0.052;
  s.stall = radians(24.0), s.softness = 1.6, s.wake_sides = 0.10;
  return s;
}

/// A cargo liner by the numbers of planar motion tests, from ½ρL² to ½ρLd and without the centrifugal force that they
/// hold; propeller, engine and windage are usual ones. Source: [Chislett1965]
TrueShip polynomial_ship() {
  TrueShip s = training();
  constexpr double L = 160.93, d = 7.47, k = 1e-5 * L / d;
  s.kind = "polynomial";
  s.L = L, s.B = 23.17, s.d = d, s.C_B = 0.597, s.x_G = -0.023, s.k_zz = 0.2205, s.U_0 = 7.7175;
  s.A_front = 420.0, s.A_lateral = 2100.0;
  s.m_x = 42.0 * k, s.m_y = 748.0 * k, s.J_z = 43.8 * k, s.R_0 = 0.0165;
  s.Y_v = -1160.0 * k, s.Y_r = 341.0 * k, s.N_v = -264.0 * k, s.N_r = -184.0 * k;
  s.X_vv = -899.0 * k, s.X_vr = -748.0 * k, s.X_rr = 36.0 * k;
  s.C_D = 0.0, s.D = 6.1, s.A_R = 30.0, s.H_R = 6.7, s.rudder_rate = radians(5.0);
  s.taylor = {.Y_vvv = -8078.0 * k,
              .Y_vvr = 15356.0 * k,
              .Y_vrr = 0.0,
              .Y_rrr = 0.0,
              .N_vvv = 1636.0 * k,
              .N_vvr = -5483.0 * k,
              .N_vrr = 0.0,
              .N_rrr = 0.0,
              .X_dd = -95.0 * k,
              .X_vd = 93.0 * k,
              .Y_d = 278.0 * k,
              .Y_ddd = -90.0 * k,
              .Y_vvd = 1190.0 * k,
              .Y_vdd = -4.0 * k,
              .N_d = -139.0 * k,
              .N_ddd = 45.0 * k,
              .N_vvd = -489.0 * k,
              .N_vdd = 13.0 * k};
  return s;
}

/// A container ship that heels by 13 to 18 deg in a hard turn and is turned by her heel.
TrueShip rolling_ship() {
  TrueShip s = container();
  s.kind = "rolling";
  s.L = 175.0, s.B = 25.4, s.d = 8.5, s.C_B = 0.559, s.U_0 = 9.5, s.D = 6.5, s.H_R = 7.7, s.A_R = 33.0;
  s.A_front = 560.0, s.A_lateral = 2500.0;
  s.C_D = 1.4, s.onset = 0.25;
  s.GM = 0.35, s.Y_phi = -0.010, s.N_phi = -0.012;
  return s;
}

/// A ferry with two propellers and two rudders that stall.
TrueShip twin_screw_ship() {
  TrueShip s = container();
  s.kind = "twin_screw";
  s.L = 165.0, s.B = 26.5, s.d = 6.4, s.C_B = 0.58, s.U_0 = 10.0, s.k_zz = 0.25;
  s.A_front = 690.0, s.A_lateral = 3400.0;
  s.D = 4.5, s.y_P = 5.2, s.A_R = 13.5, s.H_R = 4.4, s.f_alpha = 2.5, s.stall = radians(22.0), s.softness = 1.6;
  s.w_0 = 0.12, s.wake_gain = 1.08, s.wake_sides = 0.0, s.gamma = 0.65, s.gamma_sides = 0.0, s.R_0 = 0.0185;
  s.C_D = 1.5, s.onset = 0.2, s.N_r = -0.052, s.Y_v = -0.25;
  return s;
}

/// A cruise ship with two pods.
TrueShip podded_ship() {
  TrueShip s = container();
  s.kind = "podded";
  s.L = 240.0, s.B = 32.0, s.d = 7.8, s.C_B = 0.63, s.U_0 = 10.8, s.k_zz = 0.25;
  s.A_front = 1100.0, s.A_lateral = 7600.0;
  s.D = 5.2, s.y_P = 7.0, s.pods = true, s.A_R = 11.0, s.H_R = 5.2, s.f_alpha = 2.2, s.softness = 1.2;
  s.w_0 = 0.10, s.wake_gain = 1.08, s.wake_sides = 0.0, s.gamma = 0.8, s.gamma_sides = 0.0, s.R_0 = 0.0175;
  s.C_D = 1.5, s.onset = 0.25, s.N_r = -0.050, s.rudder_rate = radians(5.0);
  return s;
}

/// A supply vessel with two propellers and flap rudders, whose hull follows quadratic terms.
TrueShip modulus_ship() {
  TrueShip s = training();
  s.kind = "modulus";
  s.L = 75.0, s.B = 16.5, s.d = 5.6, s.C_B = 0.70, s.x_G = -0.010, s.k_zz = 0.26, s.U_0 = 6.9;
  s.A_front = 260.0, s.A_lateral = 780.0;
  s.D = 3.0, s.y_P = 3.9, s.A_R = 5.2, s.H_R = 3.1, s.f_alpha = 2.9, s.softness = 1.8;
  s.w_0 = 0.14, s.wake_gain = 1.10, s.wake_sides = 0.0, s.gamma = 0.60, s.gamma_sides = 0.0, s.R_0 = 0.024;
  s.C_D = 0.0, s.Y_v = -0.30, s.Y_r = 0.060, s.N_v = -0.100, s.N_r = -0.055;
  s.modulus = {.Y_vv = -0.95,
               .Y_vr = 0.12,
               .Y_rv = -0.38,
               .Y_rr = 0.02,
               .N_vv = 0.02,
               .N_vr = -0.13,
               .N_rv = -0.045,
               .N_rr = -0.035};
  return s;
}

TrueShip usual(std::string_view kind) {
  constexpr std::array<std::pair<std::string_view, TrueShip (*)()>, 9> fleet{{{"tanker", tanker},
                                                                              {"container", container},
                                                                              {"training", training},
                                                                              {"cross_flow", cross_flow_ship},
                                                                              {"polynomial", polynomial_ship},
                                                                              {"rolling", rolling_ship},
                                                                              {"twin_screw", twin_screw_ship},
                                                                              {"podded", podded_ship},
                                                                              {"modulus", modulus_ship}}};
  const auto* ship = std::ranges::find(fleet, kind, [](const auto& entry) { return entry.first; });
  if (ship == fleet.end()) throw std::domain_error("no kind of ship \"" + std::string(kind) + "\"");
  return ship->second();
}

}  // namespace

std::array<std::string_view, 6> ship_structures() {
  return {"cross_flow", "polynomial", "rolling", "twin_screw", "podded", "modulus"};
}

std::array<std::string_view, 3> ship_kinds() { return {"tanker", "container", "training"}; }

TrueShip true_ship(std::string_view kind, std::uint64_t seed) {
  TrueShip s = usual(kind);
  RandomSource random(seed);
  const double size = random.uniform(0.8, 1.15);
  for (double* length : {&s.L, &s.B, &s.d, &s.D, &s.H_R, &s.y_P, &s.GM}) *length *= size;
  for (double* area : {&s.A_front, &s.A_lateral, &s.A_R}) *area *= size * size;
  s.U_0 *= std::sqrt(size);
  for (double* number : {&s.m_y,     &s.J_z,  &s.R_0,   &s.Y_v,         &s.Y_r,        &s.N_v,       &s.N_r,
                         &s.C_D,     &s.X_vv, &s.X_vr,  &s.X_rr,        &s.w_0,        &s.wake_rate, &s.A_R,
                         &s.f_alpha, &s.a_H,  &s.gamma, &s.gamma_sides, &s.wake_sides, &s.kappa,     &s.softness})
    *number *= 1.0 + 0.04 * random.normal();
  return s;
}

TrueShip symmetric(TrueShip ship) {
  ship.wake_sides = ship.gamma_sides = 0.0;
  return ship;
}

}  // namespace swayaw::concealed
