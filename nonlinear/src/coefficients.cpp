#include "swayaw/nonlinear/coefficients.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "swayaw/core/parts_reader.hpp"
#include "swayaw/core/refusal.hpp"

namespace swayaw {
namespace {

ShipNumber ship_number(const FileNumber& n, std::size_t index, const Confidence& confidence) {
  const double deviation = n.role == Role::coefficient ? std::abs(*n.value) * confidence.of(n.key) : 0.0;
  return {.name = std::string(n.key),
          .table = n.table,
          .key = n.key,
          .index = index,
          .value = *n.value,
          .range = n.range,
          .si = n.si,
          .role = n.role,
          .deviation = deviation};
}

/// "rudder.x_prime" where another table has that key too.
void name_by_table(std::vector<ShipNumber>& numbers) {
  for (auto& n : numbers)
    if (std::ranges::count(numbers, n.key, &ShipNumber::key) > 1) n.name = fmt::format("{}.{}", n.table, n.key);
}

}  // namespace

std::vector<ShipNumber> ship_numbers(const Ship& ship) {
  std::vector<ShipNumber> numbers;
  const auto add = [&](auto model) {
    for (const auto& n : file_numbers(model)) numbers.push_back(ship_number(n, numbers.size(), ship.confidence));
  };
  std::visit(add, ship.model);
  name_by_table(numbers);
  return numbers;
}

std::vector<ShipNumber> ship_numbers(const Ship& ship, std::span<const std::string> names) {
  const auto all = ship_numbers(ship);
  std::vector<ShipNumber> picked;
  for (const auto& name : names) {
    const auto found = std::ranges::find_if(
        all, [&](const ShipNumber& n) { return name == n.name || name == fmt::format("{}.{}", n.table, n.key); });
    if (found == all.end()) throw Refusal(fmt::format("{}: her model has no number {}", ship.name, name));
    picked.push_back(*found);
  }
  return picked;
}

std::vector<ShipNumber> coefficients_of(const Ship& ship, std::string_view table) {
  auto numbers = ship_numbers(ship);
  std::erase_if(numbers, [&](const ShipNumber& n) { return n.table != table || n.role != Role::coefficient; });
  return numbers;
}

Ship with_values(const Ship& ship, std::span<const ShipNumber> numbers, std::span<const double> values) {
  Ship result = ship;
  std::visit([&](auto& model) { set_values(model, numbers, values); }, result.model);
  return result;
}

}  // namespace swayaw
