#include "swayaw/identification/identify.hpp"

#include <catch.hpp>

#include "files.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/recording_csv.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/identification/captive.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/published_ships.hpp"

namespace swayaw {
namespace {

std::vector<Recording> recordings(const std::filesystem::path& folder, std::initializer_list<const char*> names) {
  std::vector<Recording> runs;
  for (const auto* name : names)
    runs.push_back(read_recording(folder / (std::string("hsva_zz") + name + ".csv")).recording);
  return runs;
}

const auto of_the_paper = {"10_10_port", "10_10_stbd", "20_10_port", "20_10_stbd"};

double thousandths(const ForceFit& fit, const std::string& name) {
  return 1e3 * parameters_of(fit.ship, std::array{name})[0].value;
}

const Regression& equation(const ForceFit& fit, ForceComponent component) {
  return std::ranges::find(fit.equations, component, &ForceEquation::component)->fit;
}

double largest_inflation(const Regression& fit) {
  double most = 0.0;
  for (const auto& c : fit.coefficients) most = std::max(most, c.variance_inflation);
  return most;
}

/// Physics-uninformed, without Y_r, as Alexandersson et al. fitted it.
struct PublishedPu {
  Ship ship = in_model(published_ship("kvlcc2_pi"), "pu");
  ForceFitOptions options{.parameters = usual_parameters(ship)};

  PublishedPu() { std::erase(options.parameters, "Y_r"); }
};

}  // namespace

TEST_CASE("the physics-informed hull of KVLCC2 is found from four zigzags within 3 percent of what is known of them",
          "[identification][published]") {
  const auto folder = test::benchmark_recordings("kvlcc2");
  if (!folder) return;
  const auto ship = published_ship("kvlcc2_pi");
  const auto fit = fit_forces(ship, recordings(*folder, of_the_paper), {.parameters = usual_parameters(ship)});
  CHECK(thousandths(fit, "Y_v") == Approx(-25.7).epsilon(0.03));
  CHECK(thousandths(fit, "N_v") == Approx(-8.43).epsilon(0.03));
  CHECK(thousandths(fit, "N_r") == Approx(-3.99).epsilon(0.03));
  CHECK(equation(fit, ForceComponent::N).condition_number < 5.0);
  SECTION("and is never called stable, since a linear hull is a mean over large motions") {
    const auto verdict = stability_verdict(fit);
    CHECK(verdict.e0 > 0.0);
    CHECK(verdict.straight_course == StraightCourse::not_told);
    CHECK(verdict.words.find("r' = 0.42") != std::string::npos);
  }
  SECTION("and predicts the yaw moment that HMRI measured in a towing tank") {
    std::vector<CaptivePoint> points =
        read_captive(*folder / "captive" / "hmri_static.csv",
                     {.L = length(fit.ship), .towed_L = 6.8927, .thrust_prime = 0.00122033});
    CHECK(captive_error(fit.ship, selected(points, {.tests = {"static_drift"}}), radians(12.0)).N < 0.10);
  }
}

TEST_CASE("small zigzags tell that KVLCC2 is unstable on a straight course", "[identification][published]") {
  const auto folder = test::benchmark_recordings("kvlcc2");
  if (!folder) return;
  const auto ship = published_ship("kvlcc2_pi");
  const auto verdict =
      stability_verdict(fit_forces(ship, recordings(*folder, {"10_01_stbd"}), {.parameters = usual_parameters(ship)}));
  CHECK(verdict.straight_course == StraightCourse::unstable);
  CHECK(degrees(verdict.range.drift) < 5.0);
}

TEST_CASE("the physics-uninformed model is ill-conditioned, and its N_v changes sign with one rudder amplitude",
          "[identification][published]") {
  const auto folder = test::benchmark_recordings("kvlcc2");
  if (!folder) return;
  const PublishedPu pu;
  const auto runs = recordings(*folder, of_the_paper);
  const auto fit = fit_forces(pu.ship, runs, pu.options);
  for (const auto component : {ForceComponent::Y, ForceComponent::N}) {
    CHECK(equation(fit, component).condition_number > 100.0);
    CHECK(largest_inflation(equation(fit, component)) > 1e3);
    CHECK_FALSE(equation(fit, component).undetermined.empty());
  }
  const auto sets = resample(pu.ship, runs, fit, pu.options);
  const auto place =
      static_cast<std::size_t>(std::ranges::find(pu.options.parameters, "N_v") - pu.options.parameters.begin());
  const auto N_v = [&](const std::string& name) {
    return *std::ranges::find(sets, name, &Resample::runs)->values[place];
  };
  CHECK(sets.size() == 1 + 4 + 4 + 2);
  CHECK(N_v("all runs") < 0.0);
  CHECK(N_v("rudder 10 deg alone") > 0.0);
  CHECK(N_v("rudder 20 deg alone") > 0.0);
}

TEST_CASE("overshoots of a recorded zigzag are those known of it", "[identification][published]") {
  const auto folder = test::benchmark_recordings("kvlcc2");
  if (!folder) return;
  const auto run = recordings(*folder, {"10_10_port"}).front();
  const auto order = zigzag_order(run);
  REQUIRE(order);
  CHECK(order->first == Side::port);
  const auto overshoots = recorded_overshoots(run, *order);
  REQUIRE(overshoots.size() >= 2);
  CHECK(degrees(overshoots[0]) == Approx(9.7).margin(0.05));
  CHECK(degrees(overshoots[1]) == Approx(17.8).margin(0.05));
}

TEST_CASE("overshoots read from the samples of a simulated zigzag are those of its events",
          "[identification][second-route]") {
  const auto ship = published_ship("kvlcc2_l7");
  for (const auto side : {Side::port, Side::starboard}) {
    const ZigzagOrder order{radians(20.0), radians(10.0), side};
    auto z = zigzag(ship, order, {.step = 0.05});
    z.run.facts.manoeuvre = "zigzag 20/10";
    const auto read = zigzag_order(z.run);
    REQUIRE(read);
    CHECK(read->first == side);
    CHECK(read->rudder == order.rudder);
    const auto overshoots = recorded_overshoots(z.run, *read);
    REQUIRE(overshoots.size() >= 3);
    for (std::size_t i = 0; i < 3; ++i) CHECK(overshoots[i] == Approx(*z.reversals[i].overshoot).margin(radians(0.01)));
    const auto again = simulated_overshoots(ship, z.run, *read, 3);
    REQUIRE(again);
    for (std::size_t i = 0; i < again->size(); ++i)
      CHECK((*again)[i] == Approx(*z.reversals[i].overshoot).margin(1e-4));
  }
}

TEST_CASE("a run that is no zigzag has no zigzag order", "[identification]") {
  Recording run;
  run.time = {0.0, 1.0};
  for (auto& delta : run.fill(Channel::delta)) delta = 0.2;
  for (const auto* manoeuvre : {"turn 35", "zigzag", "zigzag ten/ten", "zigzag 10", ""}) {
    run.facts.manoeuvre = manoeuvre;
    CHECK_FALSE(zigzag_order(run));
  }
  run.facts.manoeuvre = "zigzag 10/5 first port";
  CHECK(zigzag_order(run));
}

TEST_CASE("a PI ship is taken as a PU ship with a rudder polynomial of zero, and other changes of model are refused",
          "[identification]") {
  const auto ship = published_ship("kvlcc2_pi");
  const auto pu = in_model(ship, "pu");
  const auto& model = std::get<PuShip<double>>(pu.model);
  CHECK(model.hull.Y_v == std::get<PiShip<double>>(ship.model).hull.Y_v);
  CHECK(model.rudder.Y_delta == 0.0);
  CHECK(usual_parameters(pu).size() == usual_parameters(ship).size() + 15);
  CHECK(in_model(ship, "pi").model.index() == ship.model.index());
  CHECK_THROWS_WITH(in_model(pu, "pi"), Catch::Contains("does not tell what model \"pi\" needs"));
  CHECK_THROWS_AS(in_model(published_ship("kvlcc2_l7"), "pi"), Refusal);
}

}  // namespace swayaw
