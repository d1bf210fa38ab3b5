#include <cstdio>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/dual.hpp"
#include "swayaw/core/recording.hpp"
#include "swayaw/linear/batch.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/ship_file.hpp"

int main(int, char** arguments) {
  using namespace swayaw;
  const Ship ship = read_ship(arguments[1]);
  const Zigzag result = zigzag(ship, {.rudder = radians(20), .heading = radians(20)});
  std::printf("first overshoot %.2f deg\n", degrees(result.reversals.at(0).overshoot.value()));
  const bool packs = available(InstructionSet::baseline);
  std::printf("packs: %s\n", packs ? "yes" : "no");
  return packs;  // there is no xsimd
}
