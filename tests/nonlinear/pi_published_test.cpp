#include <catch.hpp>

#include "alexandersson2024.hpp"
#include "prime_ships.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/dual.hpp"

/// Numbers of [Alexandersson2024] and of an independent program of its equations.
namespace swayaw {
namespace {

using nlohmann::json;

PlanarMotion<double> motion_of(const json& state) { return {state.at("u"), state.at("v"), state.at("r")}; }

Controls<double> controls_of(const json& state) {
  const auto& T = state.at("thrusts");
  return {.delta = state.at("delta"), .thrust = {T[0], T.size() > 1 ? T[1].get<double>() : 0.0}, .by_thrust = true};
}

void check_force(const PlanarForce<double>& force, const json& expected, double scale) {
  CHECK_THAT(force.X, WithinAbs(expected[0].get<double>(), scale));
  CHECK_THAT(force.Y, WithinAbs(expected[1].get<double>(), scale));
  CHECK_THAT(force.N, WithinAbs(expected[2].get<double>(), scale));
}

void check_state(const PiShip<double>& ship, const json& state) {
  const auto m = motion_of(state);
  const auto f = forces(ship, m, controls_of(state));
  double largest = 0.0;
  for (const auto& x : state.at("hull")) largest = std::max(largest, std::abs(x.get<double>()));
  check_force(f.hull, state.at("hull"), 1e-9 * largest);
  check_force(f.propeller, state.at("propeller"), 1e-9 * largest);
  check_force(f.rudder, state.at("rudder"), 1e-9 * largest);
  check_force(f.rudder_hull_interaction, state.at("rhi"), 1e-9 * largest);
  check_force(f.total(), state.at("total"), 1e-9 * largest);
  const auto a = acceleration(ship, m, f.total());
  const auto& expected = state.at("accel");
  CHECK_THAT(a.u, WithinAbs(expected[0].get<double>(), 1e-11));
  CHECK_THAT(a.v, WithinAbs(expected[1].get<double>(), 1e-11));
  CHECK_THAT(a.r, WithinAbs(expected[2].get<double>(), 1e-11));
}

TEST_CASE("forces and accelerations of the wPCC are those of the independent program, part by part",
          "[nonlinear][second-route]") {
  const auto golden = test::alexandersson2024();
  for (const auto& state : golden.at("wPCC forces Reference")) check_state(test::pi_ship("wpcc_reference"), state);
  for (const auto& state : golden.at("wPCC forces PI")) check_state(test::pi_ship("wpcc_pi"), state);
}

TEST_CASE("forces of the single-screw KVLCC2 are those of the independent program", "[nonlinear][second-route]") {
  const auto golden = test::alexandersson2024();
  for (const auto& state : golden.at("KVLCC2 forces PI paper +Yr+vvr"))
    check_state(test::pi_ship("kvlcc2_pi_vvr"), state);
}

// ---------------------------------------------------------------- inside the rudder

/// One rudder at a state of the golden file, which tells its side by gamma_0.
void check_rudder(const PiShip<double>& ship, const json& d) {
  const double T = d.at("thrust_one");
  const auto m = motion_of(d);
  const Controls<double> c{.delta = d.at("delta"), .thrust = {T, ship.propeller.twin() ? T : 0.0}, .by_thrust = true};
  const auto branch = branch_at(ship, m, c);
  const auto flow = flow_at_rudders(ship, m, c, branch[PiBranch::wake], branch[PiBranch::crossflow]);
  const bool port = d.at("alpha_f").get<double>() - d.at("gamma").get<double>() > -0.01;
  const auto& race = port ? flow.race.port : flow.race.starboard;
  const auto& in = port ? flow.inflow.port : flow.inflow.starboard;
  const double gamma_0 = port ? ship.rudder.gamma_0_port : ship.rudder.gamma_0_starboard;
  const auto plan = planform(ship.rudder);
  const double lambda_R = lift_diminution(race, plan.chord), alpha_f = gamma_0 + in.gamma;
  const double K_gap = gap_factor(ship.rudder, c.delta, branch[PiBranch::gap], branch[PiBranch::gap_lifts]);
  const auto f = lift_and_drag(ship.rudder, ship.water.rho, ship.water.nu, plan, lambda_R, in, c.delta + alpha_f,
                               branch[port ? PiBranch::attack_port : PiBranch::attack_starboard], K_gap);
  const auto force = turned_to_ship(f, alpha_f, ship.rudder.x_R, 0.0);
  const auto check = [&](const char* name, double value) {
    INFO(name);
    CHECK_THAT(value, WithinAbs(d.at(name).get<double>(), 1e-12 * std::max(1.0, std::abs(value))));
  };
  check("V_A", race.V_A);
  check("V_corr", race.V_corr);
  CHECK_THAT(race.r, WithinRel(d.at("r_x").get<double>() + d.at("r_D").get<double>(), 1e-13));
  check("V_Ry", in.V_Ry);
  check("gamma", in.gamma);
  check("alpha", c.delta + alpha_f);
  check("V_RC", std::hypot(in.V_RxC, in.V_Ry));
  check("V_RU", std::hypot(in.V_RxU, in.V_Ry));
  check("AR_e", plan.AR_e);
  check("dCL", plan.slope);
  check("C_Dcross", plan.cross_flow);
  check("lam_R", lambda_R);
  check("K_gap", K_gap);
  check("L_R", f.lift);
  check("D_R", f.drag);
  check("X_R", force.X);
  check("Y_R", force.Y);
  check("N_R", force.N);
}

TEST_CASE("every step inside the rudder is that of the independent program", "[nonlinear][second-route]") {
  const auto golden = test::alexandersson2024();
  for (const auto& d : golden.at("wPCC rudder detail (one rudder)")) check_rudder(test::pi_ship("wpcc_pi"), d);
  for (const auto& d : golden.at("KVLCC2 rudder detail (paper rudder)")) check_rudder(test::pi_ship("kvlcc2_pi"), d);
}

// ---------------------------------------------------------------- figure 9

/// A virtual captive test in primes; figure 9 shows rudder-hull interaction as part of the hull.
struct Captive {
  PlanarForce<double> hull, rudder;
};

class Figure9 {
 public:
  explicit Figure9(PiShip<double> ship) : ship_(std::move(ship)) {}

  /// Thrust is what the figure's total has beyond hull and rudder.
  Captive at(const std::string& test, const json& marks, std::size_t i) const {
    const double x = marks.at("x")[i], U = ship_.particulars.U_0, L = ship_.particulars.L,
                 beta = test == "Drift angle" ? radians(x) : 0.0;
    const PlanarMotion<double> m{U * std::cos(beta), -U * std::sin(beta), test == "Circle" ? x * U / L : 0.0};
    const double delta = test == "Rudder angle" ? radians(x) : test == "Thrust variation" ? radians(-10.0) : 0.0;
    const auto mark = [&](const char* name) { return marks.at(name)[i].get<double>() * 1e-3; };
    const double q = 0.5 * ship_.water.rho * L * L * U * U;
    const double T = q * (mark("XD_model") - mark("XH_model") - mark("XR_model")) / (1.0 - ship_.propeller.t_P);
    const auto f = forces(ship_, m, Controls<double>{.delta = delta, .thrust = {T / 2, T / 2}, .by_thrust = true});
    const auto prime = [&](const PlanarForce<double>& p) {
      return PlanarForce<double>{p.X / q, p.Y / q, p.N / (q * L)};
    };
    return {prime(f.hull + f.rudder_hull_interaction), prime(f.rudder)};
  }

 private:
  PiShip<double> ship_;
};

TEST_CASE("rudder and hull of the reference set meet the markers of figure 9", "[nonlinear][published]") {
  const auto golden = test::alexandersson2024();
  auto ship = test::pi_ship("wpcc_reference");
  // table 7 prints N_r' twice what the figure was drawn with
  ship.hull.N_r *= 0.5;
  const Figure9 figure(ship);
  int markers = 0;
  for (const auto& [name, marks] : golden.at("published fig 9 model markers (x1000 prime)").items())
    for (std::size_t i = 0; i < marks.at("x").size(); ++i, ++markers) {
      INFO(name << " " << marks.at("x")[i]);
      const auto [hull, rudder] = figure.at(name, marks, i);
      const auto mark = [&, &marks = marks](const char* force) { return marks.at(force)[i].get<double>() * 1e-3; };
      CHECK_THAT(rudder.X, WithinAbs(mark("XR_model"), 1.5e-10));
      CHECK_THAT(rudder.Y, WithinAbs(mark("YR_model"), 1.5e-10));
      CHECK_THAT(rudder.N, WithinAbs(mark("NR_model"), 1.5e-10));
      CHECK_THAT(hull.Y, WithinAbs(mark("YH_model"), 1.5e-10));
      CHECK_THAT(hull.N, WithinAbs(mark("NH_model"), 1.5e-10));
    }
  CHECK(markers == 13);
}

TEST_CASE("figure 9 has the X_vv and X_rr of table 7, and another resistance", "[nonlinear][published]") {
  const auto golden = test::alexandersson2024().at("published fig 9 model markers (x1000 prime)");
  auto ship = test::pi_ship("wpcc_reference");
  const auto X = [&](const char* test, std::size_t i) { return Figure9(ship).at(test, golden.at(test), i).hull.X; };
  const auto mark = [&](const char* test, std::size_t i) {
    return golden.at(test).at("XH_model")[i].get<double>() * 1e-3;
  };
  // X_0' + X_u' u' of the figure, from a straight course and from 10 deg of drift
  const double ahead = mark("Rudder angle", 1) - X("Rudder angle", 1);
  const double adrift = mark("Drift angle", 2) - X("Drift angle", 2);
  CHECK(std::abs(ahead) > 1e-4);
  const double X_u = (adrift - ahead) / (std::cos(radians(10.0)) - 1.0);
  ship.hull.X_u += X_u;
  ship.hull.X_0 += ahead - X_u * prime_motion(ship, {ship.particulars.U_0, 0.0, 0.0}).u;
  for (const std::size_t i : {0u, 1u}) CHECK_THAT(X("Drift angle", i), WithinAbs(mark("Drift angle", i), 1.5e-10));
  for (const std::size_t i : {0u, 1u, 2u}) CHECK_THAT(X("Circle", i), WithinAbs(mark("Circle", i), 1.5e-10));
}

// ---------------------------------------------------------------- figure 14

template <template <class> class Model>
void check_figure_14(const Model<double>& ship, const json& figure, const char* name) {
  const double V = figure.at("V"), beta = radians(figure.at("beta_deg")), T = figure.at("thrust_total");
  const PlanarMotion<double> m{V * std::cos(beta), -V * std::sin(beta), 0.0};
  const auto total =
      forces(ship, m, Controls<double>{.delta = 0.0, .thrust = {T / 2, T / 2}, .by_thrust = true}).total();
  CHECK_THAT(total.Y, WithinAbs(figure.at(name).at("Y_D").get<double>(), 0.5e-3));
  CHECK_THAT(total.N, WithinAbs(figure.at(name).at("N_D").get<double>(), 0.5e-3));
}

TEST_CASE("sway force and yaw moment in side wind are those printed in figure 14", "[nonlinear][published]") {
  const auto figure = test::alexandersson2024().at("published fig 14");
  check_figure_14(test::pi_ship("wpcc_reference"), figure, "Reference");
  check_figure_14(test::pi_ship("wpcc_pi"), figure, "PI");
  check_figure_14(test::wpcc_pu(), figure, "PU");
}

// ---------------------------------------------------------------- linear coefficients

/// M' (dv'/dt', dr'/dt') = D' (v', r') + B' delta about a straight course.
void check_linear(const PiShip<double>& model, const json& linear) {
  using D = Dual<3>;
  const auto ship = cast<D>(model);
  const double U = linear.at("U"), T = linear.at("thrust"), L = model.particulars.L,
               q = 0.5 * model.water.rho * L * L * U * U;
  Controls<D> c{.delta = D(0.0, 2), .thrust = {D(T), D(0.0)}, .by_thrust = true};
  if (model.propeller.twin()) c.thrust = {D(T / 2), D(T / 2)};
  const PlanarMotion<D> m{D(U), D(0.0, 0), D(0.0, 1)};
  const auto total = forces(ship, m, c).total();
  const double mass = model.water.rho * model.particulars.nabla, coupling = mass * model.particulars.x_G;
  const double D_prime[2][2] = {{total.Y.v[0] * U / q, (total.Y.v[1] - mass * U) * U / (q * L)},
                                {total.N.v[0] * U / (q * L), (total.N.v[1] - coupling * U) * U / (q * L * L)}};
  const double B_prime[2] = {total.Y.v[2] / q, total.N.v[2] / (q * L)};
  // what unit forces accelerate is the inverse of M
  const auto by_Y = acceleration(model, {U, 0.0, 0.0}, {0.0, 1.0, 0.0}),
             by_N = acceleration(model, {U, 0.0, 0.0}, {0.0, 0.0, 1.0});
  const double det = by_Y.v * by_N.r - by_Y.r * by_N.v, unit = 0.5 * model.water.rho * L * L * L;
  const double M_prime[2][2] = {{by_N.r / det / unit, -by_N.v / det / (unit * L)},
                                {-by_Y.r / det / (unit * L), by_Y.v / det / (unit * L * L)}};
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK_THAT(B_prime[i], WithinRel(linear.at("Bprime")[i].get<double>(), 1e-8));
    for (std::size_t j = 0; j < 2; ++j) {
      CHECK_THAT(D_prime[i][j], WithinRel(linear.at("Dprime")[i][j].get<double>(), 1e-8));
      CHECK_THAT(M_prime[i][j], WithinRel(linear.at("Mprime")[i][j].get<double>(), 1e-8));
    }
  }
}

TEST_CASE("linear coefficients by dual numbers are those of the independent program", "[nonlinear][second-route]") {
  const auto golden = test::alexandersson2024();
  check_linear(test::pi_ship("wpcc_reference"), golden.at("wPCC linear Reference 12 kn"));
  check_linear(test::pi_ship("wpcc_pi"), golden.at("wPCC linear PI 12 kn"));
  check_linear(test::pi_ship("kvlcc2_pi_vvr"), golden.at("KVLCC2 linear PI paper +Yr+vvr"));
  auto paper_form = test::pi_ship("kvlcc2_pi");
  const auto& hull = golden.at("KVLCC2 hull derivatives").at("base (paper form)");
  paper_form.hull = {.X_0 = hull.at("X0"),
                     .X_u = hull.at("Xu"),
                     .X_vv = hull.at("Xvv"),
                     .X_vr = hull.at("Xvr"),
                     .X_rr = hull.at("Xrr")};
  paper_form.hull.Y_v = hull.at("Yv");
  paper_form.hull.N_v = hull.at("Nv");
  paper_form.hull.N_r = hull.at("Nr");
  check_linear(paper_form, golden.at("KVLCC2 linear PI paper base"));
}

// ---------------------------------------------------------------- what the publication leaves out

TEST_CASE("the twin-screw terms that the publication leaves out are small", "[nonlinear][published]") {
  const auto published = test::pi_ship("wpcc_pi");
  auto twin = published;
  twin.rudder.y_R_port = published.propeller.y_P_port;
  twin.rudder.y_R_starboard = published.propeller.y_P_starboard;
  const double U = published.particulars.U_0, T = published.propeller.T_0;
  const auto rudder = [&](const PiShip<double>& ship, double r_prime, double delta) {
    const PlanarMotion<double> m{U, 0.0, r_prime * U / ship.particulars.L};
    return forces(ship, m, Controls<double>{.delta = delta, .thrust = {T / 2, T / 2}, .by_thrust = true}).rudder;
  };
  const double delta = radians(-10.0);
  const auto turning = rudder(twin, -0.3, delta), turning_published = rudder(published, -0.3, delta);
  CAPTURE(turning.Y / turning_published.Y);
  CHECK_THAT(turning.Y / turning_published.Y, WithinAbs(1.0, 5e-3));
  CHECK(std::abs(turning.Y / turning_published.Y - 1.0) > 1e-3);
  // without yaw rate only the couple of unequal drags is new
  const auto straight = rudder(twin, 0.0, delta), straight_published = rudder(published, 0.0, delta);
  CAPTURE(straight.N / straight_published.N);
  CHECK(straight.Y == straight_published.Y);
  CHECK_THAT(straight.N / straight_published.N, WithinAbs(1.0, 5e-3));
  CHECK(straight.N != straight_published.N);
}

}  // namespace
}  // namespace swayaw
