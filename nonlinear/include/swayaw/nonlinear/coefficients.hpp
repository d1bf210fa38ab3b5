#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "swayaw/core/dual.hpp"
#include "swayaw/core/parameter.hpp"
#include "swayaw/nonlinear/ship.hpp"

/// The numbers of a ship by name, to be changed one by one: by a fit, in a sensitivity, with a prior.
namespace swayaw {

/// A number of a ship. Its name is the key of the ship file, "N_v", or "rudder.x_prime" where two tables have that key.
struct ShipNumber {
  std::string name;
  std::string_view table;
  std::string_view key;
  std::size_t index;  ///< place among the numbers of the model, in the order of for_each_number
  double value;       ///< SI
  Range range;        ///< accepted values, in the unit of the ship file
  double si;          ///< SI value of one unit
  Role role;
  double deviation;  ///< standard deviation by the confidence of the ship, SI; 0 for a fact
};

/// All numbers of the ship's model.
std::vector<ShipNumber> ship_numbers(const Ship& ship);

/// Those with these names, in that order. A key that two tables have needs the name of its table.
/// @throws Refusal  naming the first one that the model does not have
std::vector<ShipNumber> ship_numbers(const Ship& ship, std::span<const std::string> names);

/// Those of a part, "hull", that can be fitted.
std::vector<ShipNumber> coefficients_of(const Ship& ship, std::string_view table);

/// The ship with other values of these numbers, in SI.
Ship with_values(const Ship& ship, std::span<const ShipNumber> numbers, std::span<const double> values);

/// The model with other values of its numbers at these places, in any scalar.
template <class Model, class S>
void set_values(Model& model, std::span<const ShipNumber> numbers, std::span<const S> values) {
  std::size_t place = 0;
  for_each_number(model, [&](auto& number) {
    for (std::size_t i = 0; i < numbers.size(); ++i)
      if (numbers[i].index == place) number = values[i];
    ++place;
  });
}

/// The model in duals whose derivatives, from `first` on, are those by these numbers.
template <int N, template <class> class Model>
Model<Dual<N>> seeded(const Model<double>& model, std::span<const ShipNumber> numbers, int first = 0) {
  auto result = cast<Dual<N>>(model);
  std::size_t place = 0;
  for_each_number(result, [&](auto& number) {
    for (std::size_t i = 0; i < numbers.size(); ++i)
      if (numbers[i].index == place) number.v[first + static_cast<int>(i)] = 1.0;
    ++place;
  });
  return result;
}

}  // namespace swayaw
