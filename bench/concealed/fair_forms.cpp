#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "fair_ship.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/models/force_breakdown.hpp"

namespace swayaw::concealed {
namespace {

using Mmg = MmgShip<double>;
using Names = std::vector<std::string>;
using Vector = Eigen::VectorXd;

// ---------------------------------------------------------------- the fair MMG ship in the terms of another form

/// Primes over ½ρL²; equations of motion with the mass of the ship alone: X_vr + m_y, Y_r − m_x stand in the hull.
PiShip<double> in_pi_form(const Mmg& m) {
  const auto& p = m.particulars;
  const auto& h = m.hull;
  const double k = p.d / p.L, chord = m.rudder.A_R / m.rudder.H_R,
               covered = m.rudder.A_R * std::min(1.0, m.propeller.D / m.rudder.H_R);
  PiShip<double> ship{};
  ship.water = {.rho = m.water.rho, .nu = 1.19e-6};
  ship.particulars = {.L = p.L,
                      .B = p.B,
                      .d = p.d,
                      .nabla = p.nabla,
                      .x_G = p.x_G,
                      .I_z = 0.0,
                      .k_zz = p.k_zz,
                      .U_0 = p.U_0,
                      .Fn_0 = 0.02,
                      .A_front = p.A_front,
                      .A_lateral = p.A_lateral};
  ship.added_mass = {.X_udot = -k * m.added_mass.m_x,
                     .Y_vdot = -k * m.added_mass.m_y,
                     .Y_rdot = 0.0,
                     .N_vdot = 0.0,
                     .N_rdot = -k * m.added_mass.J_z};
  ship.hull = {.X_0 = 0.0,
               .X_u = -k * h.R_0,
               .X_vv = k * h.X_vv,
               .X_vr = k * (h.X_vr + m.added_mass.m_y),
               .X_rr = k * h.X_rr,
               .Y_0 = 0.0,
               .Y_v = k * h.Y_v,
               .Y_r = k * (h.Y_r - m.added_mass.m_x),
               .Y_vvv = k * h.Y_vvv,
               .Y_vvr = k * h.Y_vvr,
               .Y_vrr = k * h.Y_vrr,
               .Y_rrr = k * h.Y_rrr,
               .N_0 = 0.0,
               .N_v = k * h.N_v,
               .N_r = k * h.N_r,
               .N_vvv = k * h.N_vvv,
               .N_vvr = k * h.N_vvr,
               .N_vrr = k * h.N_vrr,
               .N_rrr = k * h.N_rrr};
  ship.propeller = {.D = m.propeller.D,
                    .x_P = m.propeller.x_P * p.L,
                    .y_P_port = 0.0,
                    .y_P_starboard = 0.0,
                    .t_P = m.propeller.t_P,
                    .w_f = m.propeller.w_P0,
                    .T_0 = 0.0,
                    .k_0 = m.propeller.k_0,
                    .k_1 = m.propeller.k_1,
                    .k_2 = m.propeller.k_2,
                    .C_1 = m.propeller.C_1,
                    .C_2_positive = m.propeller.C_2_positive,
                    .C_2_negative = m.propeller.C_2_negative,
                    .wake = {1}};
  ship.rudder.A_R = m.rudder.A_R, ship.rudder.A_RC = covered, ship.rudder.A_RU = m.rudder.A_R - covered;
  ship.rudder.b_R = m.rudder.H_R, ship.rudder.c_r = 1.1 * chord, ship.rudder.c_t = 0.9 * chord;
  ship.rudder.AR_factor = 2.0, ship.rudder.x_R = m.rudder.x_R * p.L, ship.rudder.x = 0.02 * p.L;
  ship.rudder.kappa_v = ship.rudder.kappa_r = 0.5 * (m.rudder.gamma_R_negative + m.rudder.gamma_R_positive);
  ship.rudder.e_0 = 0.9, ship.rudder.C_D_tune = 1.0, ship.rudder.C_D0_tune = 1.0, ship.rudder.friction_line = {1};
  ship.rudder.a_H = m.rudder.a_H, ship.rudder.x_H = m.rudder.a_H * m.rudder.x_H / m.rudder.x_R;
  ship.steering_gear = m.steering_gear;
  return ship;
}

/// Inertia alone; what the fit moves from 0 is the whole force.
AbkowitzShip<double> in_abkowitz_form(const Mmg& m) {
  const auto& p = m.particulars;
  const double k = p.d / p.L, x_G = p.x_G / p.L, mass = p.nabla / (0.5 * p.L * p.L * p.L);
  AbkowitzShip<double> ship{};
  ship.water = m.water;
  ship.particulars = {.L = p.L, .U_0 = p.U_0, .A_front = p.A_front, .A_lateral = p.A_lateral, .prime_speed = {0}};
  ship.inertia = {.m = mass,
                  .x_G = x_G,
                  .I_z = mass * (p.k_zz * p.k_zz / (p.L * p.L) + x_G * x_G),
                  .X_udot = -k * m.added_mass.m_x,
                  .Y_vdot = -k * m.added_mass.m_y,
                  .Y_rdot = 0.0,
                  .N_vdot = 0.0,
                  .N_rdot = -k * m.added_mass.J_z,
                  .centripetal = {0}};
  ship.steering_gear = m.steering_gear;
  return ship;
}

ShipModel in_form(const Mmg& ship, FileForm form) {
  switch (form) {
    case FileForm::mmg: return ship;
    case FileForm::pi: return in_pi_form(ship);
    case FileForm::abkowitz: return in_abkowitz_form(ship);
  }
  throw std::domain_error("no such form of a ship file");
}

/// Coefficients of hull and rudder that trials tell.
Names fitted_names(FileForm form) {
  Names names{"X_vv",  "X_vr", "X_rr", "Y_v",   "Y_r",   "Y_vvv", "Y_vvr", "Y_vrr",
              "Y_rrr", "N_v",  "N_r",  "N_vvv", "N_vvr", "N_vrr", "N_rrr"};
  const auto add = [&](std::initializer_list<const char*> more) {
    names.insert(names.end(), more.begin(), more.end());
  };
  if (form == FileForm::mmg) add({"R_0", "X_vvvv", "f_alpha", "a_H", "gamma_R_negative", "gamma_R_positive"});
  if (form == FileForm::pi) add({"X_u", "lift_factor", "rudder.a_H", "rudder.x_H", "kappa_v", "kappa_r"});
  if (form == FileForm::abkowitz)
    add({"X_u", "X_uu", "Y_vu", "Y_ru", "N_vu", "N_ru", "X_dd", "X_vd", "X_rd", "Y_d", "Y_ud", "Y_ddd", "Y_vvd",
         "Y_vdd", "N_d", "N_ud", "N_ddd", "N_vvd", "N_vdd"});
  return names;
}

// ---------------------------------------------------------------- least squares of accelerations

/// Accelerations in units of those that the hull's force gives, root mean square: one axis after the other, over √n.
class Accelerations {
 public:
  Accelerations(const TrueShip& truth, const std::vector<TruePoint>& points) : points_(points) {
    const auto n = static_cast<Eigen::Index>(points.size());
    truth_.resize(3 * n);
    PlanarForce<double> hull{};
    const double m = 1025.0 * truth.volume(), added = 0.5 * 1025.0 * truth.L * truth.L * truth.d,
                 inertia = (m * truth.k_zz * truth.k_zz + added * truth.J_z) * truth.L * truth.L;
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto& p = points[static_cast<std::size_t>(i)];
      const auto d = rates(truth, {}, p.state, p.moment);
      truth_[i] = d[State::u], truth_[n + i] = d[State::v], truth_[2 * n + i] = d[State::r];
      const auto f = forces(truth, {}, p.state, p.moment).hull;
      hull.X += f.X * f.X, hull.Y += f.Y * f.Y, hull.N += f.N * f.N;
    }
    unit_ = {std::sqrt(hull.X) / (m + added * truth.m_x), std::sqrt(hull.Y) / (m + added * truth.m_y),
             std::sqrt(hull.N) / inertia};
  }

  /// Of a ship less those of the truth.
  Vector errors(const Ship& ship) const {
    const auto n = static_cast<Eigen::Index>(points_.size());
    Vector e(3 * n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto& [q, moment] = points_[static_cast<std::size_t>(i)];
      const ShipState<double> state{0.0, 0.0, 0.0, {q[State::u], q[State::v], q[State::r]}};
      const auto a = force_breakdown(ship, state, {.delta = moment.delta, .rev = q[State::shaft]}).acceleration;
      e[i] = (a.u - truth_[i]) / unit_[0], e[n + i] = (a.v - truth_[n + i]) / unit_[1],
      e[2 * n + i] = (a.r - truth_[2 * n + i]) / unit_[2];
    }
    return e;
  }

 private:
  const std::vector<TruePoint>& points_;
  Vector truth_;
  std::array<double, 3> unit_{};
};

/// What a change that is as large as all of the hull's force costs: terms that the trials do not tell stay where they
/// are. A hundredth of what the form itself leaves.
constexpr double reluctance = 0.01;

/// Gauss and Newton with differences; steps that do not help are halved.
Ship fitted(Ship ship, const Names& names, const Accelerations& target) {
  const auto numbers = parameters_of(ship, names);
  const auto size = static_cast<Eigen::Index>(numbers.size());
  std::vector<double> values;
  for (const auto& n : numbers) values.push_back(n.value);
  const std::vector<double> start = values;
  Vector cost = Vector::Zero(size);
  const auto with_cost = [&](const std::vector<double>& at) {
    const Vector e = target.errors(with_values(ship, numbers, at));
    Vector all(e.size() + size);
    all.head(e.size()) = e;
    for (Eigen::Index i = 0; i < size; ++i)
      all[e.size() + i] = cost[i] * (at[static_cast<std::size_t>(i)] - start[static_cast<std::size_t>(i)]);
    return all;
  };
  for (int round = 0; round < 6; ++round) {
    const Vector now = with_cost(values);
    Eigen::MatrixXd slopes(now.size(), size);
    for (Eigen::Index i = 0; i < size; ++i) {
      auto moved = values;
      const double step = 1e-5 * std::max(1e-3, std::abs(values[static_cast<std::size_t>(i)]));
      moved[static_cast<std::size_t>(i)] += step;
      slopes.col(i) = (with_cost(moved) - now) / step;
      if (round == 0) cost[i] = slopes(now.size() - size + i, i) = reluctance * slopes.col(i).norm();
    }
    const Vector step = slopes.colPivHouseholderQr().solve(-now);
    for (double share = 1.0; share > 0.01; share *= 0.5) {
      auto tried = values;
      for (std::size_t i = 0; i < tried.size(); ++i) tried[i] += share * step[static_cast<Eigen::Index>(i)];
      if (with_cost(tried).norm() >= now.norm()) continue;
      values = tried;
      break;
    }
  }
  return with_values(ship, numbers, values);
}

}  // namespace

std::string_view name_of(FileForm form) {
  constexpr std::array names{"mmg", "pi", "abkowitz"};
  return names[static_cast<std::size_t>(form)];
}

FairShip fair_ship(const TrueShip& truth, FileForm form, double confidence) {
  const auto points = trial_points(truth);
  const Accelerations target(truth, points);
  Ship ship = fair_ship(truth, confidence).ship;
  const auto fitted_from = [&](const Mmg& start) {
    Ship tried = ship;
    tried.model = in_form(start, form);
    return fitted(std::move(tried), fitted_names(form), target);
  };
  // a rudder that was fitted by itself may have gone astray: once more from that of the truth
  Mmg fair = std::get<Mmg>(ship.model), plain = fair;
  plain.rudder.f_alpha = truth.f_alpha, plain.rudder.l_R = truth.l_R;
  plain.rudder.gamma_R_negative = plain.rudder.gamma_R_positive = truth.gamma;
  const Ship one = fitted_from(fair), other = fitted_from(plain);
  ship = target.errors(one).norm() < target.errors(other).norm() ? one : other;
  ship.confidence = confidence_of(ship, confidence);
  const Vector left = target.errors(ship);
  const auto n = left.size() / 3;
  return {.ship = ship, .residue = {left.head(n).norm(), left.segment(n, n).norm(), left.tail(n).norm()}};
}

}  // namespace swayaw::concealed
