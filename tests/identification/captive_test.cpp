#include "swayaw/identification/captive.hpp"

#include <array>
#include <catch.hpp>
#include <numbers>

#include "../nonlinear/model_ships.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/models/force_breakdown.hpp"

/// Laws of captive tests, over seeded random ships of every model.
namespace swayaw {
namespace {

using test::RandomModels;
using test::Scratch;

Ship named(const ShipModel& model) { return {.name = "ship", .model = model, .confidence = {}, .surroundings = {}}; }

template <class Check>
void for_every_model(unsigned seed, int ships, Check&& check) {
  RandomModels random(seed);
  for (int i = 0; i < ships; ++i) {
    check(random, random.ship<MmgShip<double>>());
    check(random, random.ship<PiShip<double>>());
    check(random, random.ship<PuShip<double>>());
    check(random, random.ship<AbkowitzShip<double>>());
  }
}

double size_of(const PlanarForce<double>& f, double L) { return std::abs(f.X) + std::abs(f.Y) + std::abs(f.N) / L; }

TEST_CASE("a ship that moves freely needs no carriage", "[identification][second-route]") {
  for_every_model(1, 30, [](RandomModels& random, const auto& model) {
    const auto motion = random.motion(model);
    const auto controls = random.controls(model);
    const auto force = forces(model, motion, controls).total();
    const CaptivePoint point{.run = "",
                             .tests = {},
                             .moments = {{motion, acceleration(model, motion, force), controls}},
                             .measured = {},
                             .with_inertia = true};
    REQUIRE(size_of(captive_force(named(model), point), model.particulars.L) <
            1e-9 * size_of(force, model.particulars.L));
  });
}

TEST_CASE("in steady drift the carriage measures the force of the water", "[identification][second-route]") {
  for_every_model(2, 30, [](RandomModels& random, const auto& model) {
    auto motion = random.motion(model);
    motion.r = 0.0;
    const auto controls = random.controls(model);
    const auto force = force_breakdown(named(model), {0, 0, 0, motion}, controls).total;
    for (const bool with_inertia : {false, true}) {
      const auto f = captive_force(
          named(model),
          {.run = "", .tests = {}, .moments = {{motion, {}, controls}}, .measured = {}, .with_inertia = with_inertia});
      REQUIRE(size_of({f.X - force.X, f.Y - force.Y, f.N - force.N}, model.particulars.L) <
              1e-9 * size_of(force, model.particulars.L));
    }
  });
}

// ---------------------------------------------------------------- tests of a known ship

/// A basin that measures what a known ship would.
class Basin {
 public:
  explicit Basin(const Ship& truth) : truth_(truth), L_(length(truth)), U_(service_speed(truth)) {
    const double T =
        0.5 * std::visit([](const auto& m) { return m.water.rho; }, truth.model) * L_ * L_ * U_ * U_ * 1.2e-3;
    controls_ = {.delta = 0.0, .thrust = {0.5 * T, 0.5 * T}, .by_thrust = true};
  }

  /// Every kind of test, without noise.
  std::vector<CaptivePoint> all_tests() {
    for (const double scale : {0.7, 0.8, 0.9, 1.0, 1.1}) steady("resistance", {scale * U_, 0, 0}, 0.0, false);
    for (const double delta : {-20.0, -10.0, 0.0, 10.0, 20.0}) steady("static_rudder", {U_, 0, 0}, radians(delta));
    for (const double beta : {-12.0, -9.0, -6.0, -2.0, 4.0, 8.0, 12.0}) {
      steady("static_drift", drifting(beta, 0.0), 0.0);
      steady("static_drift_rudder", drifting(beta, 0.0), radians(-beta));
    }
    for (const double r : {-0.5, -0.3, -0.1, 0.2, 0.4}) {
      steady("circle", drifting(0.0, r), 0.0);
      for (const double beta : {-8.0, 6.0, 12.0}) steady("circle_drift", drifting(beta, r), 0.0);
    }
    for (const double r : {0.1, 0.2, 0.3, 0.4}) {
      for (const double beta : {0.0, 4.0, 8.0, 12.0}) yawing(beta == 0.0 ? "pure_yaw" : "yaw_drift", beta, r);
      swaying(0.1 * r);
    }
    return points_;
  }

 private:
  PlanarMotion<double> drifting(double beta_deg, double r_prime) const {
    return {U_ * std::cos(radians(beta_deg)), -U_ * std::sin(radians(beta_deg)), r_prime * U_ / L_};
  }

  void add(CaptivePoint point) {
    point.measured = captive_force(truth_, point);
    if (point.with_inertia) point.measured.X = std::numeric_limits<double>::quiet_NaN();
    points_.push_back(point);
  }

  void steady(const char* test, const PlanarMotion<double>& motion, double delta, bool propelled = true) {
    auto controls = with_rudder(controls_, delta);
    if (!propelled) controls.thrust = {0.0, 0.0};
    add({.run = test, .tests = {test}, .moments = {{motion, {}, controls}}, .measured = {}});
  }

  template <class At>
  void oscillating(const std::string& test, At&& at) {
    for (const auto& [name, multiple, shift] :
         {std::tuple{":velocity", 1.0, 0.0}, {":acceleration", 1.0, 0.25}, {":second", 2.0, 0.0}}) {
      CaptivePoint point{.run = test, .tests = {test + name}, .moments = {}, .measured = {}, .with_inertia = true};
      for (int k = 0; k < 24; ++k) {
        auto moment = at(2.0 * std::numbers::pi * k / 24.0);
        moment.weight = 2.0 / 24.0 * std::cos(2.0 * std::numbers::pi * (multiple * k / 24.0 - shift));
        point.moments.push_back(moment);
      }
      add(point);
    }
  }

  void yawing(const std::string& test, double beta_deg, double r_prime) {
    oscillating(test, [&](double phase) {
      auto motion = drifting(beta_deg, r_prime);
      const double rate = motion.r * 1.5 * U_ / L_;
      motion.r *= std::cos(phase);
      return CaptiveMoment{motion, {0.0, 0.0, -rate * std::sin(phase)}, controls_};
    });
  }

  void swaying(double v_prime) {
    oscillating("pure_sway", [&](double phase) {
      return CaptiveMoment{{U_, v_prime * U_ * std::cos(phase), 0.0},
                           {0.0, -v_prime * U_ * 1.5 * U_ / L_ * std::sin(phase), 0.0},
                           controls_};
    });
  }

  Ship truth_;
  double L_, U_;
  Controls<double> controls_;
  std::vector<CaptivePoint> points_;
};

/// The ship with nothing of what a plan finds.
Ship blank(const Ship& ship, const CaptivePlan& plan) {
  std::vector<std::string> names;
  for (const auto& step : plan.steps) names.insert(names.end(), step.coefficients.begin(), step.coefficients.end());
  return with_values(ship, parameters_of(ship, names), std::vector<double>(names.size(), 0.7));
}

template <class Model>
void require_recovered(RandomModels& random, std::size_t least) {
  const auto truth = named(random.ship<Model>());
  const auto points = Basin(truth).all_tests();
  const auto plan = captive_plan(truth, points, HullTerms::cubic, radians(12));
  const auto fit = fit_captive(blank(truth, plan), points, plan);
  std::size_t found = 0;
  for (const auto& step : fit.steps) {
    for (const auto& c : step.fit.coefficients) {
      INFO(c.name << " from " << step.step.points.tests.front());
      const double value = parameters_of(truth, std::array{c.name})[0].value;
      REQUIRE_THAT(c.estimate.value, WithinAbs(value, 1e-7 * std::max(std::abs(value), 1e-4)));
      ++found;
    }
  }
  REQUIRE(found >= least);
  REQUIRE(fit.validation.points == 7);
  REQUIRE(fit.validation.relative().Y < 1e-7);
  REQUIRE(fit.validation.relative().N < 1e-7);
}

TEST_CASE("the steps find every coefficient of a ship whose tests have no noise", "[identification][round-trip]") {
  RandomModels random(3);
  for (int i = 0; i < 10; ++i) {
    require_recovered<MmgShip<double>>(random, 20);
    require_recovered<PiShip<double>>(random, 22);
  }
}

TEST_CASE("the velocity part of an oscillating yaw test is Y_r r + 3/4 Y_rrr r³ less the mass that is turned",
          "[identification][second-route]") {
  RandomModels random(4);
  auto ship = random.ship<PiShip<double>>();
  ship.rudder.A_RC = ship.rudder.A_RU = ship.rudder.A_R = 1e-12;
  const auto points = Basin(named(ship)).all_tests();
  const auto yaw = selected(points, {.tests = {"pure_yaw:velocity"}});
  REQUIRE(yaw.size() == 4);
  for (const auto& point : yaw) {
    const auto& m = point.moments.front().motion;
    const double L = ship.particulars.L, U = m.u, r = m.r * L / U;
    const double q = 0.5 * ship.water.rho * L * L * U * U;
    const double Y = q * (ship.hull.Y_r * r + 0.75 * ship.hull.Y_rrr * r * r * r) -
                     ship.water.rho * ship.particulars.nabla * U * m.r;
    CHECK_THAT(point.measured.Y, WithinRel(Y, 1e-9));
  }
}

TEST_CASE("the error of a ship on her own tests is zero, of twice her forces one", "[identification][limit]") {
  RandomModels random(5);
  const auto ship = named(random.ship<MmgShip<double>>());
  auto points = Basin(ship).all_tests();
  const auto none = captive_error(ship, points, radians(12));
  CHECK(none.Y < 1e-12);
  for (auto& point : points) point.measured = {0.5 * point.measured.X, 0.5 * point.measured.Y, 0.5 * point.measured.N};
  const auto all = captive_error(ship, points, radians(12));
  CHECK_THAT(all.X, WithinAbs(1.0, 1e-9));
  CHECK_THAT(all.N, WithinAbs(1.0, 1e-9));
  CHECK(captive_error(ship, points, {.tests = {"static_drift"}, .max_drift = radians(5)}).points == 2);
}

// ---------------------------------------------------------------- files

TEST_CASE("primes, newtons of a smaller model and components of velocity read as the same point",
          "[identification][symmetry]") {
  const Scratch scratch;
  write_text(scratch / "primes.csv",
             "run,test,U_m_s,beta_deg,delta_deg,r_prime,T_prime,X_prime,Y_prime,N_prime\n7,a+b,1.5,-10,5,0.2,1e-3,-1e-"
             "3,2e-3,-3e-4\n");
  const double q = 500.0 * 4.0 * 2.25;  // ½ρL²U² of a model of 2 m
  const auto text = [](double x) { return std::to_string(x); };
  write_text(scratch / "newtons.csv",
             "# a comment\nrun,test,u_m_s,v_m_s,delta_rad,r_rad_s,thrust_N,X_N,Y_N,N_N_m\n7,a+b," +
                 text(1.5 * std::cos(radians(10))) + "," + text(1.5 * std::sin(radians(10))) + "," + text(radians(5)) +
                 "," + text(0.2 * 1.5 / 7.0) + "," + text(q * 1e-3) + "," + text(-q * 1e-3) + "," + text(q * 2e-3) +
                 "," + text(-q * 2.0 * 3e-4) + "\n");
  const auto a = read_captive(scratch / "primes.csv", {.L = 7.0}),
             b = read_captive(scratch / "newtons.csv", {.L = 7.0, .towed_L = 2.0});
  REQUIRE(a.size() == 1);
  REQUIRE(b.size() == 1);
  CHECK(a[0].run == "7");
  CHECK(a[0].tests == std::vector<std::string>{"a", "b"});
  CHECK_THAT(b[0].measured.X, WithinRel(a[0].measured.X, 1e-4));
  CHECK_THAT(b[0].measured.Y, WithinRel(a[0].measured.Y, 1e-4));
  CHECK_THAT(b[0].measured.N, WithinRel(a[0].measured.N, 1e-4));
  const auto &m = a[0].moments[0], &n = b[0].moments[0];
  CHECK_THAT(n.motion.v, WithinRel(m.motion.v, 1e-4));
  CHECK_THAT(n.motion.r, WithinRel(m.motion.r, 1e-4));
  CHECK_THAT(n.controls.delta, WithinRel(m.controls.delta, 1e-4));
  CHECK_THAT(n.controls.thrust.port, WithinRel(m.controls.thrust.port, 1e-4));
  CHECK(m.motion.v > 0.0);
}

TEST_CASE("the files of an oscillating test give velocity, acceleration and second harmonic",
          "[identification][round-trip]") {
  const Scratch scratch;
  write_text(scratch / "yaw.csv",
             "run,beta_deg,U_m_s,freq_hz,r_prime_amp,rdot_prime_amp,Y_in_prime,N_in_prime,Y_out_prime,N_out_prime,Y_"
             "in2_prime,N_in2_prime\n"
             "1,8,1.2,0.03,0.2,-0.3,1e-3,2e-3,3e-3,4e-3,5e-3,6e-3\n");
  const auto points = read_captive(scratch / "yaw.csv", {.L = 7.0, .test = "yaw_drift", .thrust_prime = 1e-3});
  REQUIRE(points.size() == 3);
  const double q = 500.0 * 49.0 * 1.44;
  CHECK(points[0].tests[0] == "yaw_drift:velocity");
  CHECK_THAT(points[0].measured.Y, WithinRel(3e-3 * q, 1e-12));
  CHECK(points[1].tests[0] == "yaw_drift:acceleration");
  CHECK_THAT(points[1].measured.N, WithinRel(2e-3 * q * 7.0, 1e-12));
  CHECK(points[2].tests[0] == "yaw_drift:second");
  CHECK(std::isnan(points[2].measured.X));
  CHECK_THAT(points[0].moments[0].motion.r, WithinRel(0.2 * 1.2 / 7.0, 1e-12));
  double cosine = 0.0;
  for (const auto& m : points[0].moments) cosine += m.weight * m.motion.r;
  CHECK_THAT(cosine, WithinRel(0.2 * 1.2 / 7.0, 1e-12));
}

TEST_CASE("captive files and plans that make no sense are refused in words", "[identification][refusal]") {
  const Scratch scratch;
  const auto file = scratch / "bad.csv";
  const auto refusal = [&](const std::string& text) {
    write_text(file, text);
    try {
      read_captive(file, {.L = 7.0});
    } catch (const FileError& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  CHECK_THAT(refusal("beta_deg,Y_prime\n1,2\n"), ContainsSubstring("captive tests need U_m_s"));
  CHECK_THAT(refusal("U_m_s,Y_prime\n1,2\n"), ContainsSubstring("captive tests need T_prime, thrust_N or rev_s"));
  CHECK_THAT(refusal("U_m_s,rev_s,Y_prime\n1,2,x\n"), ContainsSubstring(":2:1: Y_prime: \"x\" is not a number"));
  CHECK_THAT(refusal("U_m_s,rev_s,Y_prime\n1,2\n"), ContainsSubstring("2 cells in a table of 3 columns"));
  CHECK_THAT(refusal("U_m_s,rev_s,Y_prime\n"), ContainsSubstring("no captive tests"));

  RandomModels random(6);
  const auto ship = named(random.ship<MmgShip<double>>());
  const auto points = Basin(ship).all_tests();
  using enum ForceComponent;
  CHECK_THROWS_WITH(fit_captive(ship, points,
                                {.steps = {{{.tests = {"static_drift_rudder"}}, Y, {"Y_v"}}},
                                 .validation = {.tests = {"static_drift_rudder"}}}),
                    ContainsSubstring("kept for validation"));
  CHECK_THROWS_WITH(
      fit_captive(ship, points, {.steps = {{{.tests = {"static_rudder"}}, Y, {"epsilon"}}}, .validation = {}}),
      ContainsSubstring("not linear in epsilon"));
  CHECK_THROWS_WITH(fit_captive(ship, points, {.steps = {{{.tests = {"static_drift"}}, Y, {"Y_x"}}}, .validation = {}}),
                    ContainsSubstring("no number Y_x"));
  CHECK_THROWS_WITH(fit_captive(ship, points, {.steps = {{{.tests = {"moonshine"}}, Y, {"Y_v"}}}, .validation = {}}),
                    ContainsSubstring("no Y was measured in moonshine"));
}

}  // namespace
}  // namespace swayaw
