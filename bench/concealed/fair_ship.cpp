#include "fair_ship.hpp"

#include <Eigen/QR>
#include <cmath>
#include <functional>
#include <vector>

#include "random_source.hpp"
#include "sea_trial.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/models/mmg/mmg_forces.hpp"
#include "swayaw/nonlinear/surroundings/windage_sources.hpp"

namespace swayaw::concealed {
namespace {

using Mmg = MmgShip<double>;
using Number = std::function<double&(Mmg&)>;

using Point = TruePoint;

/// Drift, yaw rate and rudder about those of turning ships, at two speeds.
std::vector<Point> grid(const TrueShip& truth) {
  const auto order = self_propulsion(truth, truth.U_0);
  std::vector<Point> points;
  for (double r_prime = -0.7; r_prime < 0.71; r_prime += 0.1)
    for (double off = -0.12; off < 0.121; off += 0.03)
      for (int i = 0; i < 10; ++i) {
        const double delta = -35.0 + 17.5 * (i / 2), loss = i % 2 ? 0.7 : 0.25;
        const double beta = 0.43 * r_prime + off, U = truth.U_0 * (1.0 - loss * std::abs(r_prime));
        States q{};
        q[State::u] = U * std::cos(beta), q[State::v] = -U * std::sin(beta), q[State::r] = r_prime * U / truth.L,
        q[State::shaft] = order.rev * (1.0 - 0.03 * std::abs(r_prime));
        q[State::phi] = steady_heel(truth, q[State::u], q[State::r]);
        points.push_back(
            {q, {.time = 0.0, .delta = radians(delta), .order = order, .disturbance = {}, .turbulence = 0.0}});
      }
  return points;
}

/// What the ship passes through in trials.
void add_trials(std::vector<Point>& points, const TrueShip& truth, const std::vector<Manoeuvre>& trials) {
  const auto order = self_propulsion(truth, truth.U_0);
  for (const auto& trial : trials) {
    const auto track = true_track(truth, {}, trial, {.disturbance = 0.0});
    for (std::size_t i = 0; i < track.states.size(); i += 16)
      points.push_back({track.states[i],
                        {.time = 0.0, .delta = track.delta[i], .order = order, .disturbance = {}, .turbulence = 0.0}});
  }
}

MmgForces<double> forces_of(const Mmg& ship, const Point& p) {
  const PlanarMotion<double> motion{p.state[State::u], p.state[State::v], p.state[State::r]};
  const Controls<double> controls{.delta = p.moment.delta, .rev = p.state[State::shaft]};
  return swayaw::forces(ship, motion, controls, branch_at(ship, motion, controls));
}

/// Moves the parameters to the least squares of the residuals, by Gauss and Newton with differences. A number that
/// moves by half of itself from where it stood costs `hold`².
void fit(Mmg& ship, const std::vector<Number>& parameters, const std::function<Eigen::VectorXd(const Mmg&)>& residuals,
         double hold) {
  const auto size = static_cast<Eigen::Index>(parameters.size());
  Mmg start = ship;
  for (int round = 0; round < 8; ++round) {
    const Eigen::VectorXd now = residuals(ship);
    Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(now.size() + size, size);
    Eigen::VectorXd errors(now.size() + size);
    errors.head(now.size()) = now;
    for (Eigen::Index i = 0; i < size; ++i) {
      const auto& number = parameters[static_cast<std::size_t>(i)];
      Mmg moved = ship;
      number(moved) += 1e-5;
      slopes.col(i).head(now.size()) = (residuals(moved) - now) / 1e-5;
      const double cost = hold > 0.0 ? hold / (0.5 * std::abs(number(start))) : 0.0;
      slopes(now.size() + i, i) = cost;
      errors[now.size() + i] = cost * (number(ship) - number(start));
    }
    const Eigen::VectorXd step = slopes.colPivHouseholderQr().solve(-errors);
    for (Eigen::Index i = 0; i < size; ++i) parameters[static_cast<std::size_t>(i)](ship) += step[i];
  }
}

/// Residuals of some forces of a part, in units of their own size.
auto residuals_of(const TrueShip& truth, const std::vector<Point>& points, PlanarForce<double> TrueForces::*true_part,
                  PlanarForce<double> MmgForces<double>::*part, std::vector<double PlanarForce<double>::*> components) {
  std::vector<PlanarForce<double>> target;
  for (const auto& p : points) target.push_back(forces(truth, {}, p.state, p.moment).*true_part);
  return [=](const Mmg& ship) {
    Eigen::VectorXd e(static_cast<Eigen::Index>(points.size() * components.size()));
    Eigen::Index row = 0;
    for (const auto component : components) {
      double size = 0.0;
      for (const auto& f : target) size += f.*component * (f.*component);
      for (std::size_t i = 0; i < points.size(); ++i)
        e[row++] = (forces_of(ship, points[i]).*part.*component - target[i].*component) / std::sqrt(size);
    }
    return e;
  };
}

template <class Part>
std::vector<Number> parameters(Part Mmg::*part, std::vector<double Part::*> members) {
  std::vector<Number> list;
  for (const auto member : members) list.push_back([part, member](Mmg& ship) -> double& { return ship.*part.*member; });
  return list;
}

/// What a ship file can take over as it is.
Mmg particulars_of(const TrueShip& t) {
  // two propellers are one of the same thrust: n²D⁴ twice, J over the wider D
  const double wider = std::pow(t.screws(), 0.25);
  Mmg ship{};
  ship.water.rho = 1025.0;
  ship.particulars = {.L = t.L,
                      .B = t.B,
                      .d = t.d,
                      .nabla = t.volume(),
                      .x_G = t.x_G * t.L,
                      .k_zz = t.k_zz * t.L,
                      .U_0 = t.U_0,
                      .A_front = t.A_front,
                      .A_lateral = t.A_lateral};
  ship.added_mass = {.m_x = t.m_x, .m_y = t.m_y, .J_z = t.J_z, .surge_coupling = {}};
  ship.hull = {};
  ship.propeller = {.D = t.D * wider,
                    .x_P = -0.48,
                    .t_P = t.t_P,
                    .w_P0 = t.w_0,
                    .k_0 = t.K_T[0],
                    .k_1 = t.K_T[1] * wider,
                    .k_2 = t.K_T[2] * wider * wider,
                    .C_1 = t.wake_rate,
                    .C_2_positive = t.wake_gain,
                    .C_2_negative = t.wake_gain,
                    .q_0 = 0.0,
                    .q_1 = 0.0,
                    .q_2 = 0.0};
  ship.rudder = {.A_R = t.A_R * t.screws(),
                 .H_R = t.H_R * wider,
                 .x_R = -0.5,
                 .t_R = t.t_R,
                 .a_H = t.a_H,
                 .x_H = t.x_H,
                 .l_R = t.l_R,
                 .gamma_R_negative = t.gamma,
                 .gamma_R_positive = t.gamma,
                 .epsilon = t.epsilon,
                 .kappa = t.kappa,
                 .f_alpha = t.f_alpha};
  ship.steering_gear = {.rate = t.rudder_rate, .max_angle = radians(35.0), .lag = 0.0, .dead_band = 0.0};
  ship.engine = {};
  return ship;
}

PlanarForce<double> residue_of(const TrueShip& truth, const Mmg& ship, const std::vector<Point>& points) {
  PlanarForce<double> error{}, size{};
  for (const auto& p : points) {
    const auto t = forces(truth, {}, p.state, p.moment);
    const auto a = t.hull + t.propeller + t.rudder, b = forces_of(ship, p).total();
    for (const auto c : {&PlanarForce<double>::X, &PlanarForce<double>::Y, &PlanarForce<double>::N}) {
      error.*c += std::pow(a.*c - b.*c, 2);
      size.*c += std::pow(t.hull.*c, 2);
    }
  }
  return {std::sqrt(error.X / size.X), std::sqrt(error.Y / size.Y), std::sqrt(error.N / size.N)};
}

/// Fits part after part.
void fit_parts(Mmg& ship, const TrueShip& truth, const std::vector<Point>& points, double hold) {
  using H = MmgHull<double>;
  using P = MmgPropeller<double>;
  using R = MmgRudder<double>;
  constexpr auto X = &PlanarForce<double>::X, Y = &PlanarForce<double>::Y, N = &PlanarForce<double>::N;
  const auto hull = [&](auto component, auto members) {
    fit(ship, parameters(&Mmg::hull, members),
        residuals_of(truth, points, &TrueForces::hull, &MmgForces<double>::hull, {component}), hold);
  };
  hull(X, std::vector{&H::R_0, &H::X_vv, &H::X_vr, &H::X_rr, &H::X_vvvv});
  hull(Y, std::vector{&H::Y_v, &H::Y_r, &H::Y_vvv, &H::Y_vvr, &H::Y_vrr, &H::Y_rrr});
  hull(N, std::vector{&H::N_v, &H::N_r, &H::N_vvv, &H::N_vvr, &H::N_vrr, &H::N_rrr});
  const auto thrust = residuals_of(truth, points, &TrueForces::propeller, &MmgForces<double>::propeller, {X});
  Mmg best = ship;
  double least = HUGE_VAL;
  for (const double factor :
       {0.4, 0.5, 0.6, 0.7, 0.85, 1.0, 1.2}) {  // the rate of the wake is looked for, all else is nearly linear
    Mmg tried = ship;
    tried.propeller.C_1 *= hold > 0.0 ? 1.0 : factor;
    fit(tried, parameters(&Mmg::propeller, std::vector{&P::k_0, &P::k_1, &P::C_2_positive, &P::C_2_negative}), thrust,
        hold);
    if (const double left = thrust(tried).norm(); left < least) least = left, best = tried;
  }
  ship = best;
  fit(ship, parameters(&Mmg::rudder, std::vector{&R::f_alpha, &R::gamma_R_negative, &R::gamma_R_positive, &R::l_R}),
      residuals_of(truth, points, &TrueForces::rudder, &MmgForces<double>::rudder, {X, Y}), hold);
}

/// What some 200 lengths of trials tell of a number, with accelerations of 2.4 % that no model has.
constexpr double known_by_trials = 0.0017;

}  // namespace

Confidence confidence_of(const Ship& ship, double least) {
  Confidence confidence{.coefficients = least, .named = {}};
  const auto terms = coefficients_of(ship, "hull");
  const auto size = [](const Parameter& n) {  // "Y_vvr" stands before v'²r'
    double product = std::abs(n.value);
    for (const char c : n.key.substr(2)) product *= c == 'v' ? 0.25 : c == 'r' ? 0.5 : c == 'u' ? 0.3 : 0.0;
    return product;
  };
  for (const char force : {'X', 'Y', 'N'}) {
    double largest = 0.0;
    for (const auto& n : terms)
      if (n.key.front() == force) largest = std::max(largest, size(n));
    for (const auto& n : terms)
      if (n.key.front() == force && n.key != "X_u" && n.value != 0.0 && size(n) < largest)
        confidence.named.emplace_back(n.key, std::min(1.0, least * largest / size(n)));
  }
  return confidence;
}

std::vector<TruePoint> trial_points(const TrueShip& truth) {
  std::vector<TruePoint> points;
  for (const bool to_port : {true, false})
    add_trials(
        points, truth,
        {zigzag(10, 10, to_port, 0.0), zigzag(20, 20, to_port, 0.0), turn(20, to_port, 0.0), turn(35, to_port, 0.0)});
  return points;
}

FairShip fair_ship(const TrueShip& truth, double confidence) {
  Mmg model = particulars_of(truth);
  fit_parts(model, truth, grid(truth), 0.0);
  const auto trials = trial_points(truth);
  fit_parts(model, truth, trials, known_by_trials);
  Ship ship{.name = truth.kind,
            .model = model,
            .confidence = {},
            .surroundings = {
                .windage = *windage_from({.frontal = truth.A_front, .lateral = truth.A_lateral, .length = truth.L})}};
  ship.confidence = confidence_of(ship, confidence);
  return {.ship = ship, .residue = residue_of(truth, model, trials)};
}

Ship slightly_wrong(const Ship& ship, std::uint64_t seed) {
  RandomSource random(seed);
  std::vector<Parameter> coefficients;
  std::vector<double> values;
  for (const auto& n : parameters_of(ship))
    if (n.role == Role::coefficient && n.deviation > 0.0 && !n.key.starts_with("stall"))
      coefficients.push_back(n), values.push_back(n.value + n.deviation * random.normal());
  return with_values(ship, coefficients, values);
}

}  // namespace swayaw::concealed
