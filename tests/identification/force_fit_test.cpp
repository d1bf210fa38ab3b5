#include "swayaw/identification/force_fit.hpp"

#include <catch.hpp>
#include <random>

#include "files.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/published_ships.hpp"

namespace swayaw {
namespace {

/// Zigzags of a ship with three rudder amplitudes, densely sampled.
std::vector<Recording> zigzags(const Ship& ship) {
  const double time_unit = time_unit_of(ship);
  std::vector<Recording> runs;
  for (const auto& [rudder, heading, side] :
       {std::tuple{10.0, 10.0, Side::starboard}, {20.0, 20.0, Side::port}, {30.0, 15.0, Side::starboard}})
    runs.push_back(zigzag(ship, {radians(rudder), radians(heading), side}, {.step = 0.02 * time_unit}).run);
  return runs;
}

/// What instruments tell of it: position, heading, yaw rate, speed through the water and rudder with white noise.
Recording measured(const Recording& truth, const Ship& ship, double size, std::mt19937_64& engine) {
  std::normal_distribution<double> normal;
  const double L = length(ship), U = service_speed(ship);
  Recording run = truth;
  for (const Channel c : {Channel::u, Channel::v}) run.channels[index_of(c)].clear();
  const auto see = [&](Channel shown, Channel of, double deviation) {
    auto column = run.fill(shown);
    for (std::size_t i = 0; i < column.size(); ++i) column[i] = truth[of][i] + size * deviation * normal(engine);
  };
  see(Channel::x, Channel::x, 1e-3 * L);
  see(Channel::y, Channel::y, 1e-3 * L);
  see(Channel::psi, Channel::psi, 1e-3);
  see(Channel::r, Channel::r, 3e-3 * U / L);
  see(Channel::speed_through_water, Channel::u, 5e-3 * U);
  return run;
}

/// The ship with other parameters to begin with.
Ship shaken(const Ship& ship, const std::vector<std::string>& names, std::mt19937_64& engine) {
  std::normal_distribution<double> normal;
  const auto parameters = parameters_of(ship, names);
  std::vector<double> values;
  for (const auto& n : parameters) values.push_back(n.value * (1.0 + 0.2 * normal(engine)));
  return with_values(ship, parameters, values);
}

const Coefficient& coefficient(const ForceFit& fit, const std::string& name) {
  for (const auto& equation : fit.equations)
    for (const auto& c : equation.fit.coefficients)
      if (c.name == name) return c;
  throw std::out_of_range(name);
}

const std::vector<std::string> linear_hull{"Y_v", "Y_r", "N_v", "N_r"};

}  // namespace

TEST_CASE("coefficients come back from the forces of recorded zigzags, whatever ship the estimate begins with",
          "[identification][round-trip]") {
  std::mt19937_64 engine(1);
  for (const auto* name : {"kvlcc2_pi_vvr", "wpcc_pi", "wpcc_pu"}) {
    const auto ship = published_ship(name);
    std::vector<Recording> runs;
    for (const auto& truth : zigzags(ship)) runs.push_back(measured(truth, ship, 1.0, engine));
    std::vector<std::string> names;
    for (const auto& n : parameters_of(ship, linear_hull))
      if (n.value != 0.0) names.push_back(n.name);
    const auto fit = fit_forces(shaken(ship, names, engine), runs, {.parameters = names});
    for (const auto& n : parameters_of(ship, names)) {
      INFO(name << " " << n.name);
      const auto& c = coefficient(fit, n.name);
      CHECK(std::abs(c.estimate.value - n.value) <
            0.04 * std::abs(n.value) + 0.02 * std::abs(parameters_of(ship, std::array{std::string("N_v")})[0].value));
      CHECK(n.value >= c.low);
      CHECK(n.value <= c.high);
      CHECK(parameters_of(fit.ship, std::array{n.name})[0].value == c.estimate.value);
    }
  }
}

TEST_CASE("errors of the smoothed motion hardly move the coefficients, and the fit says how much", "[identification]") {
  std::mt19937_64 engine(2);
  const auto ship = published_ship("kvlcc2_pi_vvr");
  std::vector<Recording> runs;
  for (const auto& truth : zigzags(ship)) runs.push_back(measured(truth, ship, 5.0, engine));
  const auto fit = fit_forces(ship, runs, {.parameters = linear_hull});
  for (const auto& equation : fit.equations)
    for (std::size_t i = 0; i < equation.bias.size(); ++i) {
      CHECK(equation.bias[i] > 0.0);
      CHECK(equation.bias[i] < equation.fit.coefficients[i].estimate.standard_error);
    }
}

TEST_CASE("a number that is not linear, acts twice or does nothing is refused", "[identification][refusal]") {
  const auto ship = published_ship("kvlcc2_l7");
  const auto runs = zigzags(ship);
  CHECK_THROWS_WITH(fit_forces(ship, runs, {.parameters = {"kappa"}}), Catch::Contains("not linear in kappa"));
  CHECK_THROWS_WITH(fit_forces(ship, runs, {.parameters = {"t_R", "a_H"}}),
                    Catch::Contains("a_H acts in more than one force equation"));
  CHECK_THROWS_WITH(fit_forces(ship, runs, {.parameters = {"displacement_m3"}}),
                    Catch::Contains("does not act on the force"));
  CHECK_THROWS_WITH(fit_forces(ship, runs, {.parameters = {}}), "no coefficient is to be found");
}

TEST_CASE("the range of a fit is that of its runs", "[identification]") {
  const auto ship = published_ship("kvlcc2_pi_vvr");
  const auto runs = zigzags(ship);
  const auto fit = fit_forces(ship, runs, {.parameters = linear_hull});
  CHECK(degrees(fit.range.rudder) == Approx(30.0).epsilon(1e-6));
  double omega = 0.0;
  for (const auto& run : runs)
    for (std::size_t i = 0; i < run.samples(); ++i)
      omega = std::max(
          omega, std::abs(run[Channel::r][i]) * length(ship) / std::hypot(run[Channel::u][i], run[Channel::v][i]));
  CHECK(fit.range.omega == Approx(omega).epsilon(0.02));
}

}  // namespace swayaw
