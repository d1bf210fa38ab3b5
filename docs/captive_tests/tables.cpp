// The tables of docs/captive_tests.md.
//   captive_tables SHIPS_FOLDER FOLDER_WITH_HMRI_TESTS FOLDER_FOR_TABLES
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/identification/captive.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/ship_file.hpp"

namespace {

using namespace swayaw;
using Points = std::vector<CaptivePoint>;

/// Length of HMRI's model: KVLCC2 at 1:46.426 [m].
constexpr double towed_L = 320.0 / 46.426;

/// T' of run 314, straight ahead with the rudder amidships: that of the oscillating tests was not recorded.
constexpr double thrust_prime = 0.00122033;

/// All tests, as of a ship that long. Run 279 stands twice in its file, for two drift angles, with the same numbers.
Points hmri(const std::filesystem::path& folder, const Ship& ship) {
  Points points;
  CaptiveFile file{.L = length(ship), .towed_L = towed_L, .thrust_prime = thrust_prime};
  for (const auto& [name, test] : {std::pair{"static", ""},
                                   {"resistance", "resistance"},
                                   {"pure_sway", "pure_sway"},
                                   {"pure_yaw", "pure_yaw"},
                                   {"yaw_drift", "yaw_drift"}}) {
    file.test = test;
    for (const auto& point : read_captive(folder / fmt::format("hmri_{}.csv", name), file))
      if (point.run != "279") points.push_back(point);
  }
  return points;
}

/// The same where the moments of oscillating tests were about the centre of gravity: N + x_G Y about midship.
Points about_centre_of_gravity(Points points, const Ship& ship) {
  const double x_G = parameters_of(ship, std::array<std::string, 1>{"x_g_m"})[0].value;
  for (auto& point : points)
    if (point.with_inertia) point.measured.N += x_G * point.measured.Y;
  return points;
}

std::string per_cent(double share) { return fmt::format("{:.0f} %", 100.0 * share); }

/// A line of the table of errors.
std::string error_line(const std::string& name, const Ship& ship, const Points& points) {
  const auto small = captive_error(ship, points, radians(12)), large = captive_error(ship, points, radians(30));
  const auto rudder =
      captive_error(
          ship, points,
          CaptiveSelection{.tests = {"static_drift_rudder"}, .max_drift = radians(12), .min_rudder = radians(1)})
          .relative();
  const auto yaw = captive_error(ship, points, CaptiveSelection{.tests = {"pure_yaw:velocity"}}).relative();
  return fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", name, per_cent(small.Y), per_cent(small.N),
                     per_cent(large.Y), per_cent(large.N), per_cent(rudder.Y), per_cent(rudder.N), per_cent(yaw.Y),
                     per_cent(yaw.N));
}

/// Value and standard error, two digits of the latter.
std::string text(const Coefficient& c, double scale) {
  const double value = scale * c.estimate.value, error = scale * c.estimate.standard_error;
  const int decimals = std::clamp(1 - static_cast<int>(std::floor(std::log10(error))), 0, 9);
  return fmt::format("{:.{}f} ± {:.{}f}{}", value, decimals, error, decimals, c.undetermined ? " (undetermined)" : "");
}

/// Rudder factors are no primes.
double scale_of(const std::string& name, double thousandths) {
  return name == "a_H" || name.starts_with("x_H") ? 1.0 : thousandths;
}

std::string step_table(const CaptiveFit& fit, double thousandths) {
  std::string table = "| tests | force | points | found | condition | R² |\n| --- | --- | ---: | --- | ---: | ---: |\n";
  for (const auto& s : fit.steps) {
    std::string found;
    for (const auto& c : s.fit.coefficients)
      found += fmt::format("{}{} {}", found.empty() ? "" : "; ", c.name, text(c, scale_of(c.name, thousandths)));
    std::string tests;
    for (const auto& test : s.step.points.tests) tests += (tests.empty() ? "" : ", ") + test;
    table += fmt::format("| {} | {} | {} | {} | {:.1f} | {:.3f} |\n", tests, in_words(s.step.component), s.points,
                         found, s.fit.condition_number, s.fit.R2);
  }
  return table;
}

const Coefficient* found(const CaptiveFit& fit, const std::string& name) {
  for (const auto& s : fit.steps)
    for (const auto& c : s.fit.coefficients)
      if (c.name == name) return &c;
  return nullptr;
}

std::string cell(const CaptiveFit& fit, const std::string& name) {
  const auto* c = found(fit, name);
  return c ? text(*c, scale_of(name, 1000.0)) : "-";
}

std::string cell(const Ship& ship, const std::string& name) {
  const double value = parameters_of(ship, std::array{name})[0].value;
  return value == 0.0 ? "-" : fmt::format("{:.3f}", scale_of(name, 1000.0) * value);
}

std::string comparison_table(const CaptiveFit& linear, const CaptiveFit& cubic, const CaptiveFit& about_G,
                             const Ship& zigzags, const Ship& zigzags_vvr) {
  std::string table =
      "| | HMRI, linear | HMRI, cubic | HMRI, cubic, if oscillating moments are about G | zigzags, with Y_r | zigzags, "
      "with Y_r and v'²r' |\n"
      "| --- | ---: | ---: | ---: | ---: | ---: |\n";
  for (const std::string name :
       {"X_0",   "X_u",   "X_vv",  "Y_v",   "Y_r", "Y_vvv", "Y_vvr",  "Y_vrr",  "Y_rrr",  "N_v",   "N_r",
        "N_vvv", "N_vvr", "N_vrr", "N_rrr", "a_H", "x_H",   "Y_vdot", "N_vdot", "Y_rdot", "N_rdot"})
    table += fmt::format("| {} | {} | {} | {} | {} | {} |\n", name, cell(linear, name), cell(cubic, name),
                         cell(about_G, name), cell(zigzags, name), cell(zigzags_vvr, name));
  return table;
}

std::string error_table(const std::vector<std::pair<std::string, std::pair<Ship, Points>>>& ships) {
  std::string table =
      "| ship | drift ≤ 12°: Y | N | ≤ 30°: Y | N | drift ≤ 12° with rudder: Y | N | pure yaw, velocity: Y | N |\n| "
      "--- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n";
  for (const auto& [name, ship] : ships) table += error_line(name, ship.first, ship.second);
  return table;
}

int make_tables(const std::filesystem::path& ships, const std::filesystem::path& tests,
                const std::filesystem::path& out) {
  const auto pi = read_ship(ships / "kvlcc2_pi.toml"), vvr = read_ship(ships / "kvlcc2_pi_vvr.toml"),
             mmg = read_ship(ships / "kvlcc2_l7.toml");
  const auto points = hmri(tests, pi), of_mmg = hmri(tests, mmg);
  const auto linear = fit_captive(pi, points, captive_plan(pi, points, HullTerms::linear, radians(12)));
  const auto plan = captive_plan(pi, points, HullTerms::cubic, radians(12));
  const auto cubic = fit_captive(pi, points, plan);
  const auto cubic_mmg = fit_captive(mmg, of_mmg, captive_plan(mmg, of_mmg, HullTerms::cubic, radians(12)));
  const auto of_G = about_centre_of_gravity(points, pi);
  const auto wide = fit_captive(pi, points, captive_plan(pi, points, HullTerms::cubic, radians(30)));
  const auto wide_mmg = fit_captive(mmg, of_mmg, captive_plan(mmg, of_mmg, HullTerms::cubic, radians(30)));
  write_text(out / "errors.md", error_table({{"PI, zigzags, with Y_r (`kvlcc2_pi`)", {pi, points}},
                                             {"PI, zigzags, with Y_r and v'²r' (`kvlcc2_pi_vvr`)", {vvr, points}},
                                             {"the same, if oscillating moments are about G", {vvr, of_G}},
                                             {"MMG, Yasukawa & Yoshimura 2015 (`kvlcc2_l7`)", {mmg, of_mmg}},
                                             {"PI, HMRI to 12°, linear hull", {linear.ship, points}},
                                             {"PI, HMRI to 12°, cubic hull", {cubic.ship, points}},
                                             {"PI, HMRI to 30°, cubic hull", {wide.ship, points}},
                                             {"MMG, HMRI to 12°, cubic hull", {cubic_mmg.ship, of_mmg}},
                                             {"MMG, HMRI to 30°, cubic hull", {wide_mmg.ship, of_mmg}}}));
  write_text(out / "steps_pi.md", step_table(cubic, 1000.0));
  write_text(out / "steps_mmg.md", step_table(cubic_mmg, 1.0));
  write_text(out / "comparison.md", comparison_table(linear, cubic, fit_captive(pi, of_G, plan), pi, vvr));
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 4) {
    fmt::print(stderr, "usage: captive_tables SHIPS_FOLDER FOLDER_WITH_HMRI_TESTS FOLDER_FOR_TABLES\n");
    return 2;
  }
  try {
    return make_tables(arguments[1], arguments[2], arguments[3]);
  } catch (const swayaw::Refusal& refusal) {
    fmt::print(stderr, "{}\n", refusal.what());
    return 1;
  }
}
