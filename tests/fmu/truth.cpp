// A run by the Simulator itself, every number to its last bit: what a unit of the same ship must do.   truth SHIP.toml
#include <fmt/format.h>

#include "swayaw/core/angle.hpp"
#include "swayaw/nonlinear/ship_file.hpp"
#include "swayaw/nonlinear/simulator.hpp"

int main(int, char** arguments) {
  using namespace swayaw;
  Simulator ship(read_ship(arguments[1]), {.speed = 7.0});
  ship.set_state({.x = 100.0, .y = -50.0, .psi = 0.25, .motion = ship.state().motion});
  ship.set_current({.speed = 0.75, .to = 1.5});
  double order = -0.125;
  ship.order_rudder(order);
  for (int i = 0; i < 6000; ++i) {
    if (i == 1000) ship.set_wind({.speed = 12.0, .from = 2.0});
    if (i == 2000) ship.set_added_force({.X = 1e5, .Y = -2e5, .N = 3e7});
    if (i == 3000) ship.set_shaft_speed(1.25);
    // a zigzag about the heading 0.25 rad
    if ((ship.state().psi - 0.25) * order < 0.0 && std::abs(ship.state().psi - 0.25) >= 0.125)
      ship.order_rudder(order = -order);
    ship.step(0.1);
    const auto& s = ship.state();
    const auto shown = ship.instruments();
    fmt::print("{:a} {:a} {:a} {:a} {:a} {:a} {:a} {:a} {:a} {:a}\n", s.x, s.y, s.psi, s.motion.u, s.motion.v,
               s.motion.r, ship.rudder(), ship.thrust(), shown[index_of(Channel::course_over_ground)],
               shown[index_of(Channel::wind_speed)]);
  }
}
