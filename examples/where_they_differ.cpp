// Where a model and a recording differ, in one sentence and in numbers.
#include <fmt/format.h>

#include "swayaw/core/recording_csv.hpp"
#include "swayaw/mismatch/compare.hpp"
#include "swayaw/nonlinear/ship_file.hpp"

int main(int, char** arguments) {
  using namespace swayaw;
  const Ship ship = read_ship(arguments[1]);
  const Comparison comparison = compare(ship, read_recording(arguments[2]).recording);
  for (const QuantityError& error : comparison.errors)
    fmt::print("{:<10}{:>10.4f} {:<6} {:.0f} % of its variation\n", name_of(error.quantity), error.window_rms,
               unit_of(error.quantity), 100.0 * error.normalised());
  fmt::print("{}\n", verdict({comparison}));
}
