#include <catch.hpp>
#include <iostream>
#include <nlohmann/json.hpp>

#include "files.hpp"
#include "json.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/identification/captive.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/ship_file.hpp"

/// KVLCC2 in the towing tank of HMRI (SIMMAN 2014) against models of her; recordings that are not part of the project.
namespace swayaw {
namespace {

/// The tests of HMRI as of a ship that long; primes of the file are those of the tank, 6.8927 m model.
std::vector<CaptivePoint> hmri(const std::filesystem::path& folder, const Ship& ship) {
  CaptiveFile file{.L = length(ship), .towed_L = 6.8927, .thrust_prime = 0.00122033};
  std::vector<CaptivePoint> points;
  for (const auto& [name, test] : {std::pair{"static", ""},
                                   {"resistance", "resistance"},
                                   {"pure_sway", "pure_sway"},
                                   {"pure_yaw", "pure_yaw"},
                                   {"yaw_drift", "yaw_drift"}}) {
    file.test = test;
    std::ranges::copy(read_captive(folder / (std::string("hmri_") + name + ".csv"), file), std::back_inserter(points));
  }
  return points;
}

/// "Yvvr" is Y_vvr.
std::string key_of(const std::string& name) { return name.substr(0, 1) + "_" + name.substr(1); }

Ship with_derivatives(const Ship& ship, const nlohmann::json& derivatives) {
  const auto hull = coefficients_of(ship, "hull");
  auto result = with_values(ship, hull, std::vector<double>(hull.size(), 0.0));
  for (const auto& [name, value] : derivatives.items())
    if (name.find("delta") == std::string::npos)
      result = with_values(result, parameters_of(result, std::array{key_of(name)}), std::array{value.get<double>()});
  return result;
}

/// Published relative rms of Y and N, two digits.
struct Published {
  const char* set;
  double Y_12, N_12, Y_30, N_30;
};

std::optional<nlohmann::json> reference() {
  const auto file = std::filesystem::path(SWAYAW_TEST_SHARED) / "reference" / "kvlcc2_pi.json";
  if (std::filesystem::exists(file)) return test::json_in(file);
  std::cout << "[skipped] no reference/kvlcc2_pi.json\n";
  return std::nullopt;
}

/// The PI ship with the rudder and the wake of another set of inputs.
Ship with_inputs(Ship ship, const nlohmann::json& inputs) {
  for (const auto& [theirs, ours] : {std::pair{"nu", "kinematic_viscosity_m2_s"},
                                     {"b_R", "span_m"},
                                     {"c_t", "chord_tip_m"},
                                     {"c_r", "chord_root_m"},
                                     {"A_R_C", "area_covered_m2"},
                                     {"A_R_U", "area_uncovered_m2"},
                                     {"x", "propeller_distance_m"},
                                     {"kappa_v", "kappa_v"},
                                     {"kappa_r", "kappa_r"},
                                     {"a_H", "a_H"},
                                     {"x_H", "x_H"},
                                     {"C_2_beta_p_pos", "wake_C2_positive"},
                                     {"C_2_beta_p_neg", "wake_C2_negative"}})
    ship = with_values(ship, parameters_of(ship, std::array<std::string, 1>{ours}),
                       std::array{inputs[theirs].get<double>()});
  return ship;
}

TEST_CASE("sets that were identified on zigzags of KVLCC2 have the captive errors that are known of them",
          "[identification][published]") {
  const auto folder = test::benchmark_recordings("kvlcc2/captive");
  const auto known = reference();
  if (!folder || !known) return;
  const auto& sets = (*known)["derivatives"];
  const auto pi = read_ship(test::ships / "kvlcc2_pi.toml"),
             literature = with_inputs(pi, (*known)["ships"]["literature"]),
             pu = read_ship(test::ships / "wpcc_pu.toml");
  for (const auto& [set, Y_12, N_12, Y_30, N_30] :
       {Published{"PI | paper rudder | base (paper form)", .44, .08, .15, .14},
        {"PI | paper rudder | +Yr", .18, .08, .14, .14},
        {"PI | paper rudder | +Yr+vvr", .09, .13, .21, .26},
        {"PI | literature rudder | +Yr", .60, .90, .69, 1.14},
        {"PU | base (paper form)", .54, .36, .21, .53},
        {"PU | +Yr", .44, .36, .57, .53},
        {"PU | +Yr+vvr", .08, .09, .27, .09}}) {
    INFO(set);
    const auto ship = with_derivatives(set[1] == 'U' ? pu : set[5] == 'l' ? literature : pi, sets[set]);
    const auto points = hmri(*folder, ship);
    const auto small = captive_error(ship, points, radians(12)), large = captive_error(ship, points, radians(30));
    CHECK_THAT(small.Y, WithinAbs(Y_12, 0.006));
    CHECK_THAT(small.N, WithinAbs(N_12, 0.006));
    CHECK_THAT(large.Y, WithinAbs(Y_30, 0.006));
    CHECK_THAT(large.N, WithinAbs(N_30, 0.006));
  }
}

TEST_CASE(
    "the primes of HMRI are over the square of the speed once: thrust less resistance is the force straight ahead",
    "[identification][second-route]") {
  const auto folder = test::benchmark_recordings("kvlcc2/captive");
  if (!folder) return;
  const auto ship = read_ship(test::ships / "kvlcc2_pi.toml");
  const auto points = hmri(*folder, ship);
  const auto ahead = selected(points, {.tests = {"static_drift"}, .max_drift = 0.0});
  REQUIRE(ahead.size() == 1);
  double R = 0.0;
  for (const auto& point : selected(points, {.tests = {"resistance"}}))
    if (std::abs(point.moments[0].motion.u - 1.17) < 0.001) R = -point.measured.X;
  const double T = 2.0 * ahead[0].moments[0].controls.thrust.port,
               t = 0.233;  // thrust deduction of HMRI's self-propulsion test
  CHECK(R > 30.0);
  CHECK_THAT((1.0 - t) * T - R, WithinAbs(ahead[0].measured.X, 0.05 * R));
}

TEST_CASE("the derivatives that HMRI's own tests give predict drift with rudder, which they have not seen",
          "[identification][published]") {
  const auto folder = test::benchmark_recordings("kvlcc2/captive");
  if (!folder) return;
  for (const auto* name : {"kvlcc2_pi.toml", "kvlcc2_l7.toml"}) {
    INFO(name);
    const auto ship = read_ship(test::ships / name);
    const auto points = hmri(*folder, ship);
    const auto before =
        captive_error(ship, points, CaptiveSelection{.tests = {"static_drift_rudder"}, .max_drift = radians(12)})
            .relative();
    const auto fit = fit_captive(ship, points, captive_plan(ship, points, HullTerms::cubic, radians(12)));
    const auto after = fit.validation.relative();
    CHECK(fit.validation.points == 9);
    CHECK(after.Y < 0.1);
    CHECK(after.N < 0.1);
    CHECK(after.Y < before.Y);
  }
}

}  // namespace
}  // namespace swayaw
