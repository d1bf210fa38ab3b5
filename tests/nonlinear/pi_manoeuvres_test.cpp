#include <catch.hpp>

#include "alexandersson2024.hpp"
#include "json.hpp"
#include "prime_manoeuvres.hpp"
#include "swayaw/core/angle.hpp"

namespace swayaw {
namespace {

using nlohmann::json;

json figure_10() { return test::json_in(test::golden / "alexandersson2024_figure_10.json"); }

// ---------------------------------------------------------------- against the independent program

TEST_CASE("the wPCC answers a rudder ramp as in the independent program", "[nonlinear][second-route]") {
  const auto golden = test::alexandersson2024().at("wPCC ramp Reference");
  const auto ship = test::pi_ship("wpcc_reference");
  const auto run = test::sail(
      ship, golden.at("U"), 40.0, 0.01, [&](double) { return golden.at("thrust_total").get<double>(); },
      [&](const test::PrimeSample&) { return golden.at("delta").get<double>(); });
  for (std::size_t i = 0; i < 3; ++i) {
    const double t = golden.at("t")[i];
    const auto& s = run.at(static_cast<std::size_t>(t / 0.01 + 0.5)).state;
    const double values[] = {s.x, s.y, s.psi, s.motion.u, s.motion.v, s.motion.r};
    for (std::size_t j = 0; j < 6; ++j)
      CHECK_THAT(values[j], WithinAbs(golden.at("state_x_y_psi_u_v_r")[i][j].get<double>(), 1e-5));
  }
}

void check_overshoots(const PiShip<double>& ship, const json& golden) {
  const double angle = radians(golden.at("rudder_deg"));
  const auto run = test::sail(
      ship, golden.at("U"), 50.0, 0.01, [&](double) { return golden.at("thrust_total").get<double>(); },
      test::ZigzagOrders(angle));
  std::vector<double> overshoots;
  for (std::size_t i = 2; i < run.size(); ++i)
    if (run[i - 1].state.motion.r * run[i].state.motion.r <= 0.0)
      overshoots.push_back(degrees(std::abs(run[i].state.psi) - angle));
  REQUIRE(overshoots.size() >= 3);
  for (std::size_t i = 0; i < 3; ++i)
    CHECK_THAT(overshoots[i], WithinAbs(golden.at("overshoot_deg")[i].get<double>(), 0.05));
}

TEST_CASE("overshoots of the wPCC are those of the independent program", "[nonlinear][second-route]") {
  const auto golden = test::alexandersson2024();
  check_overshoots(test::pi_ship("wpcc_reference"), golden.at("wPCC zigzag Reference 20/20"));
  check_overshoots(test::pi_ship("wpcc_pi"), golden.at("wPCC zigzag PI 10/10"));
}

// ---------------------------------------------------------------- against figure 10

double interpolated(const json& curve, double t) {
  const auto& time = curve[0];
  const auto& value = curve[1];
  for (std::size_t i = 1; i < time.size(); ++i)
    if (t <= time[i].get<double>())
      return std::lerp(value[i - 1].get<double>(), value[i].get<double>(),
                       (t - time[i - 1].get<double>()) / (time[i].get<double>() - time[i - 1].get<double>()));
  return value.back();
}

/// Heading of a closed-loop zigzag against the vertices of the drawn curve, rms [deg].
template <PrimeShip Ship>
double heading_error(const Ship& ship, const json& figure, const std::string& zigzag, const std::string& model) {
  const auto& drawn = figure.at(zigzag);
  const auto& psi = drawn.at(model + ".psi_deg");
  const double angle = radians(zigzag == "zigzag10/10" ? 10.0 : 20.0);
  const auto thrust = [&](double t) { return zigzag == "zigzag10/10" ? 11.0 : interpolated(drawn.at("thrust"), t); };
  const auto run = test::sail(ship, drawn.at("test.V")[1][0], psi[0].back().get<double>() + 0.05, 0.02, thrust,
                              test::ZigzagOrders(angle));
  double squares = 0.0;
  for (std::size_t i = 0; i < psi[0].size(); ++i) {
    const auto& s = run.at(static_cast<std::size_t>(psi[0][i].get<double>() / 0.02 + 0.5));
    const double error =
        degrees(s.state.psi) - psi[1][i].get<double>() + degrees(s.state.motion.r) * (psi[0][i].get<double>() - s.time);
    squares += error * error;
  }
  return std::sqrt(squares / static_cast<double>(psi[0].size()));
}

TEST_CASE("zigzags of the reference, PI and PU sets run along the curves of figure 10", "[nonlinear][published]") {
  const auto figure = figure_10();
  for (const std::string zigzag : {"zigzag10/10", "zigzag20/20"}) {
    INFO(zigzag);
    CHECK(heading_error(test::pi_ship("wpcc_reference"), figure, zigzag, "Reference") < 0.2);
    CHECK(heading_error(test::pi_ship("wpcc_pi"), figure, zigzag, "PI") < 0.2);
    CHECK(heading_error(test::wpcc_pu(), figure, zigzag, "PU") < 0.2);
  }
}

TEST_CASE("a model that is right in a zigzag can be wrong in the wind", "[nonlinear][published]") {
  // the PU set follows its own zigzag, but has a tenth of the reference's yaw moment at 10 deg of drift
  const auto moment = [](const auto& ship) {
    const double beta = radians(10.0);
    const PlanarMotion<double> m{0.8 * std::cos(beta), -0.8 * std::sin(beta), 0.0};
    return forces(ship, m, Controls<double>{.delta = 0.0, .thrust = {5.0, 5.0}, .by_thrust = true}).total().N;
  };
  const double reference = moment(test::pi_ship("wpcc_reference"));
  CHECK_THAT(moment(test::pi_ship("wpcc_pi")) / reference, WithinAbs(0.70, 0.005));
  CHECK_THAT(moment(test::wpcc_pu()) / reference, WithinAbs(0.09, 0.005));
}

}  // namespace
}  // namespace swayaw
