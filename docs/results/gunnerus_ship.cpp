#include <fmt/format.h>
#include <fmt/ranges.h>

#include "swayaw/nonlinear/estimates/estimated_ship.hpp"
#include "swayaw/nonlinear/ship_file.hpp"

/// Writes a ship file for R/V Gunnerus from her main dimensions, as a beginning for `swayaw identify`.
///
///     gunnerus_ship OUT.toml
///
/// Her two azimuth thrusters, turned together, are one rudder behind one propeller here: what a thruster turned
/// by delta does to the ship, T sin(delta) and the lift of its strut, is of the form of F_N. C_B and the diameter of
/// that propeller are guesses.
int main(int argc, char** argv) {
  using namespace swayaw;
  if (argc != 2) return 2;
  const HullDimensions<double> gunnerus{.L = 33.9, .B = 9.6, .d = 2.7, .C_B = 0.56};
  auto [ship, assumptions, warnings] = estimated_mmg_ship(gunnerus, 5.4, {.propeller_diameter = 2.0});
  Ship named{.name = "R/V Gunnerus, from main dimensions",
             .model = ship,
             .confidence = {.coefficients = 0.4, .named = {{"R_0", 1.0}}},
             .surroundings = {}};
  write_ship(argv[1], named,
             fmt::format("Made by docs/results/gunnerus_ship.cpp from L, B, d of the trials' documentation and C_B "
                         "0.56 (a guess).\nThe confidence is that of a guess from main dimensions; at a Froude number "
                         "of 0.30 the waves that R_0 leaves out resist as much again.\n{}\n{}",
                         fmt::join(assumptions, "\n"), fmt::join(warnings, "\n")));
}
