// Drift and helm that keep a course in 15 m/s of wind from every side, for a ship whose file tells her windage areas.
#include <fmt/format.h>

#include "swayaw/core/angle.hpp"
#include "swayaw/nonlinear/manoeuvres/steady_run_in_wind.hpp"
#include "swayaw/nonlinear/ship_file.hpp"

int main(int, char** arguments) {
  using namespace swayaw;
  const Ship ship = read_ship(arguments[1]);
  std::vector<double> from;
  for (int angle = 0; angle <= 180; angle += 30) from.push_back(radians(angle));
  fmt::print("{}\n{:>10}{:>12}{:>12}{:>12}\n", ship.name, "wind deg", "speed m/s", "leeway deg", "helm deg");
  for (const auto& [relative, run] : steady_runs_in_wind(ship, ship.surroundings.windage, 15.0, from)) {
    if (!run) fmt::print("{:>10.0f}  cannot hold the course\n", degrees(relative));
    else
      fmt::print("{:>10.0f}{:>12.3f}{:>12.3f}{:>12.3f}{}\n", degrees(relative), run->speed_over_ground,
                 degrees(run->leeway()), degrees(run->delta), run->holds ? "" : "  beyond the largest rudder angle");
  }
}
