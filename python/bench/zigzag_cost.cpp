// What a zigzag costs in C++: microseconds, the least of many. zigzag_cost.py runs it beside the same from Python.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <string_view>

#include "swayaw/core/angle.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/published_ships.hpp"

int main(int count, char** arguments) {
  using namespace swayaw;
  const auto ship = published_ship("kvlcc2");
  const ManoeuvreOptions options{.sampled = count < 2 || std::string_view(arguments[1]) != "bare"};
  // its end belongs to it, as it does in Python, where nobody keeps the result
  const auto peaks = [&] {
    return zigzag(ship, {.rudder = radians(10.0), .heading = radians(10.0)}, options).reversals.size();
  };
  double least = 1e9;
  for (int i = 0; i < 2000; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    const bool sailed = peaks() == 4;
    const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - begin;
    if (sailed) least = std::min(least, time.count());
  }
  fmt::print("{}\n", least);
}
