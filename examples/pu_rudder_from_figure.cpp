#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/dual.hpp"
#include "swayaw/core/parts_reader.hpp"
#include "swayaw/nonlinear/models/pu/pu_forces.hpp"

/// The rudder derivatives of the physics-uninformed wPCC, which [Alexandersson2024] does not print, from what it draws.
///
/// Figure 10 shows heading, yaw rate and drift angle of that very model in two zigzags. With the hull of table 7 held
/// fast, least squares find the fifteen derivatives whose zigzags run along these curves; the speed of the model tests
/// stands in for that of the simulations, which is not drawn. Prints the [rudder] parameters of ships/wpcc_pu.toml with
/// their standard errors.
///
///     pu_rudder_from_figure ships/wpcc_pu.toml tests/golden/alexandersson2024_figure_10.json
namespace {

using namespace swayaw;
using nlohmann::json;

constexpr int unknowns = 15;
using D = Dual<unknowns>;
using State = std::array<D, 4>;  ///< psi, u, v, r

/// Vertices of a drawn line.
struct Curve {
  std::vector<double> time, value;

  double at(double t) const {
    const auto after = std::ranges::upper_bound(time, t) - time.begin();
    const auto i = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(after, 1, std::ssize(time) - 1));
    const double w = std::clamp((t - time[i - 1]) / (time[i] - time[i - 1]), 0.0, 1.0);
    return value[i - 1] + w * (value[i] - value[i - 1]);
  }
};

Curve curve(const json& drawn) { return {drawn[0].get<std::vector<double>>(), drawn[1].get<std::vector<double>>()}; }

/// One zigzag of the figure.
struct Zigzag {
  double angle_deg;              ///< rudder and heading
  Curve psi, r, beta, V;         ///< degrees, rad/s, degrees, m/s
  Curve thrust;                  ///< both propellers [N]
  std::vector<double> switches;  ///< [s]
};

/// When the drawn heading passes the angle, first to port.
std::vector<double> switches_of(const Curve& psi, double angle_deg) {
  std::vector<double> times;
  double target = -angle_deg;
  for (std::size_t i = 1; i < psi.time.size(); ++i) {
    const double before = psi.value[i - 1] - target, after = psi.value[i] - target;
    if (before * after > 0.0) continue;
    times.push_back(std::lerp(psi.time[i - 1], psi.time[i], before / (before - after)));
    target = -target;
  }
  return times;
}

Zigzag zigzag_of(const json& figure, const char* name, double angle_deg, Curve thrust) {
  const auto& drawn = figure.at(name);
  Zigzag z{angle_deg,
           curve(drawn.at("PU.psi_deg")),
           curve(drawn.at("PU.r")),
           curve(drawn.at("PU.beta_deg")),
           curve(drawn.at("test.V")),
           std::move(thrust),
           {}};
  z.switches = switches_of(z.psi, angle_deg);
  return z;
}

/// Rudder angle, to port from t = 0, reversed at the switches [rad].
double rudder_at(const Zigzag& z, double rate, double t) {
  double delta = 0.0, from = 0.0, target = radians(z.angle_deg);
  for (std::size_t i = 0;; ++i) {
    const double until = i < z.switches.size() ? z.switches[i] : t;
    const double step = rate * (std::min(t, until) - from);
    delta += std::clamp(target - delta, -step, step);
    if (t <= until) return delta;
    from = until;
    target = -target;
  }
}

State operator*(double h, State s) {
  for (auto& x : s) x *= h;
  return s;
}
State operator+(State a, const State& b) {
  for (std::size_t i = 0; i < 4; ++i) a[i] += b[i];
  return a;
}

constexpr double step = 0.05;  // [s]; half of it changes no printed digit

/// States every `step` until the drawn heading ends, by Runge and Kutta.
std::vector<State> simulate(const PuShip<D>& ship, const Zigzag& z) {
  const double rate = ship.steering_gear.rate.a;
  const auto rates = [&](double t, const State& s) {
    const PlanarMotion<D> m{s[1], s[2], s[3]};
    const D half = D(0.5 * z.thrust.at(t));
    const Controls<D> c{.delta = D(rudder_at(z, rate, t)), .thrust = {half, half}, .by_thrust = true};
    const auto a = acceleration(ship, m, forces(ship, m, c, branch_at(ship, m, c)).total());
    return State{s[3], a.u, a.v, a.r};
  };
  std::vector<State> states{{D(0.0), D(z.V.value.front()), D(0.0), D(0.0)}};
  for (double t = 0.0; t < z.psi.time.back() + step; t += step) {
    const State s = states.back();
    const State k1 = rates(t, s), k2 = rates(t + step / 2, s + step / 2 * k1),
                k3 = rates(t + step / 2, s + step / 2 * k2), k4 = rates(t + step, s + step * k3);
    states.push_back(s + step / 6 * (k1 + 2 * k2 + 2 * k3 + k4));
  }
  return states;
}

/// Normal equations of the fit, and what is left.
struct Normal {
  Eigen::Matrix<double, unknowns, unknowns> A = Eigen::Matrix<double, unknowns, unknowns>::Zero();
  Eigen::Vector<double, unknowns> b = Eigen::Vector<double, unknowns>::Zero();
  double squares = 0.0;
  int count = 0;

  void add(const D& residual) {
    A += residual.v * residual.v.transpose();
    b -= residual.v * residual.a;
    squares += residual.a * residual.a;
    ++count;
  }
};

/// Adds the vertices of one curve, each over its reading error; returns the rms deviation.
template <class Quantity>
double compare(Normal& normal, const std::vector<State>& states, const Curve& drawn, double error,
               Quantity&& quantity) {
  Normal own;
  for (std::size_t i = 0; i < drawn.time.size(); ++i) {
    const auto n = static_cast<std::size_t>(drawn.time[i] / step);
    if (n + 1 >= states.size()) break;
    const double w = drawn.time[i] / step - static_cast<double>(n);
    own.add((quantity((1.0 - w) * states[n] + w * states[n + 1]) - drawn.value[i]) / error);
  }
  normal.A += own.A;
  normal.b += own.b;
  normal.squares += own.squares;
  normal.count += own.count;
  return error * std::sqrt(own.squares / own.count);
}

Normal normal_equations(const PuShip<double>& model, const std::vector<Zigzag>& zigzags, bool tell) {
  auto ship = cast<D>(model);
  constexpr auto terms = MathematicalRudder<D>::parameters();
  for (int k = 0; k < unknowns; ++k) (ship.rudder.*terms[static_cast<std::size_t>(k)].member).v[k] = 1.0;
  Normal normal;
  for (const auto& z : zigzags) {
    const auto states = simulate(ship, z);
    const double psi = compare(normal, states, z.psi, 0.05, [](const State& s) { return s[0] * degrees(1.0); });
    const double r = compare(normal, states, z.r, 2e-4, [](const State& s) { return s[3]; });
    const double beta =
        compare(normal, states, z.beta, 0.03, [](const State& s) { return atan2(-s[2], s[1]) * degrees(1.0); });
    const double V = compare(normal, states, z.V, 0.01, [](const State& s) { return sqrt(s[1] * s[1] + s[2] * s[2]); });
    if (tell)
      fmt::print("# {0:.0f}/{0:.0f}: rms psi {1:.3f} deg, r {2:.5f} rad/s, beta {3:.3f} deg, V {4:.3f} m/s\n",
                 z.angle_deg, psi, r, beta, V);
  }
  return normal;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const PartsReader file(read_text(argv[1]), argv[1]);
  PuShip<double> ship{};
  file.read(file_keys(ship));
  std::ifstream drawing(argv[2]);
  const auto figure = json::parse(drawing);
  const std::vector<Zigzag> zigzags{
      zigzag_of(figure, "zigzag10/10", 10.0, {{0.0, 1.0}, {11.0, 11.0}}),
      zigzag_of(figure, "zigzag20/20", 20.0, curve(figure.at("zigzag20/20").at("thrust")))};
  // far from the answer, near enough to run along the curves
  ship.rudder = {.X_deltadelta = -3e-3, .Y_delta = 4e-3};
  ship.rudder.N_delta = -2e-3;
  constexpr auto terms = MathematicalRudder<double>::parameters();
  for (int iteration = 0; iteration < 10; ++iteration) {
    const auto normal = normal_equations(ship, zigzags, false);
    const Eigen::Vector<double, unknowns> change = normal.A.ldlt().solve(normal.b);
    for (std::size_t k = 0; k < unknowns; ++k) ship.rudder.*terms[k].member += change(static_cast<Eigen::Index>(k));
  }
  const auto normal = normal_equations(ship, zigzags, true);
  const double variance = normal.squares / (normal.count - unknowns);
  const Eigen::Vector<double, unknowns> error = (variance * normal.A.inverse().diagonal()).cwiseSqrt();
  for (std::size_t k = 0; k < unknowns; ++k)
    fmt::print("{} = {:.5g}  # +- {:.2g}\n", terms[k].key, ship.rudder.*terms[k].member,
               error(static_cast<Eigen::Index>(k)));
}
