// A 20/20 zigzag of a ship from a file.
#include <fmt/format.h>

#include "swayaw/core/angle.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/ship_file.hpp"

int main(int, char** arguments) {
  using namespace swayaw;
  const Ship ship = read_ship(arguments[1]);
  const Zigzag result = zigzag(ship, {.rudder = radians(20), .heading = radians(20), .first = Side::starboard});
  const Reversal& first = result.reversals.front();
  fmt::print("{}: rudder reversed at {:.1f} s, first overshoot {:.1f} deg\n", ship.name, first.time,
             degrees(first.overshoot.value()));
}
