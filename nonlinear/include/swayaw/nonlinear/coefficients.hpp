#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "swayaw/core/dual.hpp"
#include "swayaw/core/parameter.hpp"
#include "swayaw/nonlinear/ship.hpp"

/// The parameters of a ship by name, to be changed one by one: by a fit, in a sensitivity, with a prior.
namespace swayaw::inline nonlinear {

/// All parameters of the ship's model; a coefficient is known as well as the confidence of the ship says.
std::vector<Parameter> parameters_of(const Ship& ship);

/// Those with these names, in that order. A key that two tables have needs the name of its table.
/// @throws Refusal  naming the first one that the model does not have
std::vector<Parameter> parameters_of(const Ship& ship, std::span<const std::string> names);

/// Those of a part, "hull", that can be fitted.
std::vector<Parameter> coefficients_of(const Ship& ship, std::string_view table);

/// Whether it is a coefficient of the resistance of a hull on a straight course: R_0, X_0, X_u, X_uu or X_uuu.
bool is_resistance(const Parameter& parameter);

/// The ship with other values of these numbers, in SI.
Ship with_values(const Ship& ship, std::span<const Parameter> numbers, std::span<const double> values);

/// The model with other values of its numbers at these places, in any scalar.
template <class Model, class S>
void set_values(Model& model, std::span<const Parameter> numbers, std::span<const S> values) {
  std::size_t place = 0;
  for_each_value(model, [&](auto& number) {
    for (std::size_t i = 0; i < numbers.size(); ++i)
      if (numbers[i].index == place) number = values[i];
    ++place;
  });
}

/// The model in duals whose derivatives, from `first` on, are those by these numbers.
template <int N, template <class> class Model>
Model<Dual<N>> seeded(const Model<double>& model, std::span<const Parameter> numbers, int first = 0) {
  auto result = cast<Dual<N>>(model);
  std::size_t place = 0;
  for_each_value(result, [&](auto& number) {
    for (std::size_t i = 0; i < numbers.size(); ++i)
      if (numbers[i].index == place) number.v[first + static_cast<int>(i)] = 1.0;
    ++place;
  });
  return result;
}

}  // namespace swayaw::nonlinear
