#include "swayaw/nonlinear/ship_file.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/refusal.hpp"

namespace swayaw {
namespace {

/// "kt[0]" is the first number of the list kt.
struct KeyPlace {
  std::string_view key;
  std::optional<std::size_t> index;
};

KeyPlace place_of(std::string_view key) {
  const auto bracket = key.find('[');
  if (bracket == std::string_view::npos) return {key, std::nullopt};
  return {key.substr(0, bracket), static_cast<std::size_t>(key[bracket + 1] - '0')};
}

std::string requirement(const Range& range) {
  if (range.low == 0.0 && std::isinf(range.high)) return range.above_low ? "must be positive" : "must not be negative";
  return fmt::format("must lie {} {} and {}", range.above_low ? "above" : "between", range.low, range.high);
}

class ShipReader {
 public:
  ShipReader(const toml::table& root, const std::filesystem::path& file) : root_(root), file_(file) {}

  Ship read() {
    Ship ship;
    ship.name = text(root_, "name");
    const auto model = text(root_, "model");
    if (model != "mmg") fail(*root_.get("model"), fmt::format("model \"{}\" is not known to this version (known: mmg)", model));
    refuse_effects();
    ship.model = read_parts<MmgShip<double>>();
    read_confidence(ship);
    refuse_unknown(root_, "");
    return ship;
  }

 private:
  [[noreturn]] void fail(const toml::node& node, std::string_view what) const {
    const auto place = node.source().begin;
    throw FileError({file_, place.line, place.column}, what);
  }

  void refuse_effects() const {
    if (const auto* effects = root_.get("effect")) fail(*effects, "[[effect]] is not understood by this version");
  }

  std::string text(const toml::table& table, std::string_view key) {
    known_.push_back(std::string(key));
    const auto* node = table.get(key);
    if (!node) fail(table, fmt::format("{} is missing", key));
    if (const auto value = node->value_exact<std::string>()) return *value;
    fail(*node, fmt::format("{} must be a text in quotes", key));
  }

  // -------------------------------------------------------------- parts

  template <class Model>
  Model read_parts() {
    Model model{};
    std::apply([&](const auto&... section) { (read_part(section.table, model.*section.part), ...); }, Model::sections());
    std::apply([&](const auto&... section) { (refuse_unknown(table_of(section.table), section.table), ...); },
               Model::sections());
    return model;
  }

  const toml::table& table_of(std::string_view name) {
    known_.push_back(std::string(name));
    const auto* node = root_.get(name);
    if (!node) fail(root_, fmt::format("table [{}] is missing", name));
    if (const auto* table = node->as_table()) return *table;
    fail(*node, fmt::format("{} must be a table", name));
  }

  template <class Part>
  void read_part(std::string_view table_name, Part& part) {
    const auto& table = table_of(table_name);
    for (const auto& parameter : Part::parameters()) {
      const auto place = place_of(parameter.key);
      known_.push_back(fmt::format("{}.{}", table_name, place.key));
      if (parameter.role == Role::coefficient) coefficients_.push_back(std::string(place.key));
      const auto* node = table.get(place.key);
      if (node) part.*parameter.member = number(*node, place, table_name, parameter.range) * parameter.si;
      else if (parameter.required) fail(table, fmt::format("{} is missing in [{}]", place.key, table_name));
    }
  }

  double number(const toml::node& node, const KeyPlace& place, std::string_view table, const Range& range) const {
    const auto& element = place.index ? list_element(node, place) : node;
    const auto value = element.value<double>();
    if (!element.is_number() || !std::isfinite(*value)) fail(element, fmt::format("{} in [{}] must be a number", place.key, table));
    if (range.contains(*value)) return *value;
    fail(element, fmt::format("{} in [{}] {}, got {}", place.key, table, requirement(range), *value));
  }

  const toml::node& list_element(const toml::node& node, const KeyPlace& place) const {
    const auto* list = node.as_array();
    const auto needed = std::ranges::count_if(known_, [&](const auto& key) { return key.ends_with(fmt::format(".{}", place.key)); });
    if (!list) fail(node, fmt::format("{} must be a list of numbers", place.key));
    if (list->size() <= *place.index) fail(node, fmt::format("{} needs {} numbers at least, got {}", place.key, needed, list->size()));
    return *list->get(*place.index);
  }

  // -------------------------------------------------------------- trust

  void read_confidence(Ship& ship) {
    known_.push_back("confidence");
    const auto* node = root_.get("confidence");
    if (!node) return;
    const auto* table = node->as_table();
    if (!table) fail(*node, "confidence must be a table");
    for (auto&& [key, value] : *table) {
      const double deviation = number(value, {key.str(), std::nullopt}, "confidence", non_negative);
      if (key == "coefficients") ship.confidence.coefficients = deviation;
      else if (std::ranges::count(coefficients_, key.str())) ship.confidence.named.emplace_back(key.str(), deviation);
      else fail(value, fmt::format("{} in [confidence] is not a coefficient of this model", key.str()));
    }
  }

  // -------------------------------------------------------------- nothing else

  void refuse_unknown(const toml::table& table, std::string_view name) const {
    for (auto&& [key, value] : table) {
      const auto full = name.empty() ? std::string(key.str()) : fmt::format("{}.{}", name, key.str());
      if (std::ranges::count(known_, full)) continue;
      const auto where = name.empty() ? std::string{} : fmt::format(" in [{}]", name);
      throw FileError({file_, key.source().begin.line, key.source().begin.column},
                      fmt::format("{}{} is not known", key.str(), where));
    }
  }

  const toml::table& root_;
  std::filesystem::path file_;
  std::vector<std::string> known_;
  std::vector<std::string> coefficients_;
};

}  // namespace

Ship parse_ship(std::string_view text, const std::filesystem::path& name) {
  try {
    const auto root = toml::parse(text, name.string());
    return ShipReader(root, name).read();
  } catch (const toml::parse_error& error) {
    const auto place = error.source().begin;
    throw FileError({name, place.line, place.column}, error.description());
  }
}

Ship read_ship(const std::filesystem::path& file) { return parse_ship(read_text(file), file); }

}  // namespace swayaw
