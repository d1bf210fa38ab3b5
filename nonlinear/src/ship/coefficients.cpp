#include "swayaw/nonlinear/coefficients.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "swayaw/core/parts_reader.hpp"
#include "swayaw/core/refusal.hpp"

namespace swayaw::inline nonlinear {
namespace {

Parameter ship_parameter(const FileParameter& p, std::size_t index, const Confidence& confidence) {
  return {.name = std::string(p.key),
          .table = p.table,
          .key = p.key,
          .unit = p.unit,
          .index = index,
          .value = *p.value,
          .range = scaled(p.range, p.si),
          .si = p.si,
          .role = p.role,
          .null = *p.value,
          .deviation = p.role == Role::coefficient ? std::abs(*p.value) * confidence.of(p.key) : 0.0};
}

/// "rudder.x_prime" where another table has that key too.
void name_by_table(std::vector<Parameter>& parameters) {
  for (auto& p : parameters)
    if (std::ranges::count(parameters, p.key, &Parameter::key) > 1) p.name = fmt::format("{}.{}", p.table, p.key);
}

}  // namespace

std::vector<Parameter> parameters_of(const Ship& ship) {
  std::vector<Parameter> parameters;
  const auto add = [&](auto model) {
    for (const auto& p : file_parameters(model))
      parameters.push_back(ship_parameter(p, parameters.size(), ship.confidence));
  };
  std::visit(add, ship.model);
  name_by_table(parameters);
  return parameters;
}

std::vector<Parameter> parameters_of(const Ship& ship, std::span<const std::string> names) {
  const auto all = parameters_of(ship);
  std::vector<Parameter> picked;
  for (const auto& name : names) {
    const auto found = std::ranges::find_if(
        all, [&](const Parameter& p) { return name == p.name || name == fmt::format("{}.{}", p.table, p.key); });
    if (found == all.end()) throw Refusal(fmt::format("{}: her model has no number {}", ship.name, name));
    picked.push_back(*found);
  }
  return picked;
}

std::vector<Parameter> coefficients_of(const Ship& ship, std::string_view table) {
  auto parameters = parameters_of(ship);
  std::erase_if(parameters, [&](const Parameter& p) { return p.table != table || p.role != Role::coefficient; });
  return parameters;
}

bool is_resistance(const Parameter& parameter) {
  constexpr std::array keys{std::string_view("R_0"), std::string_view("X_0"), std::string_view("X_u"),
                            std::string_view("X_uu"), std::string_view("X_uuu")};
  return parameter.table == "hull" && std::ranges::count(keys, parameter.key) > 0;
}

Ship with_values(const Ship& ship, std::span<const Parameter> parameters, std::span<const double> values) {
  Ship result = ship;
  std::visit([&](auto& model) { set_values(model, parameters, values); }, result.model);
  return result;
}

}  // namespace swayaw::nonlinear
