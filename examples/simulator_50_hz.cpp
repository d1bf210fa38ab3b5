// The loop of a ship-handling simulator: a ship at 50 Hz, her helm and engine, a gust and a tug.
#include <fmt/format.h>

#include "swayaw/core/angle.hpp"
#include "swayaw/nonlinear/ship_file.hpp"
#include "swayaw/nonlinear/simulator.hpp"

int main(int, char** arguments) {
  using namespace swayaw;
  Simulator ship(read_ship(arguments[1]));
  ship.set_current({.speed = 0.5, .to = radians(90)});

  const auto run_until = [&](double time) {
    while (ship.time() < time) ship.step(0.02);
    const auto& s = ship.state();
    const auto ground = ship.velocity_over_ground();
    fmt::print(
        "{:5.0f} s   heading {:6.1f} deg   {:5.2f} m/s through the water, {:5.2f} over ground   rudder {:5.1f} deg   "
        "{}\n",
        ship.time(), degrees(s.psi), speed(s.motion), speed(ground), degrees(ship.rudder()), words_for(ship.why()));
  };

  run_until(60.0);
  ship.order_rudder(radians(-20));  // starboard
  run_until(240.0);
  ship.order_rudder(0.0);
  ship.set_shaft_speed(0.0);
  run_until(900.0);
  ship.set_added_force({.X = 0.0, .Y = -1e6, .N = 1e8});  // a tug on the starboard bow
  run_until(1500.0);
  for (const auto& part : ship.forces())
    fmt::print("{:<12}X {:10.3g} N   Y {:10.3g} N   N {:10.3g} N m\n", part.name, part.force.X, part.force.Y,
               part.force.N);
}
