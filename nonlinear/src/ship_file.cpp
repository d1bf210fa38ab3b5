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
  if (range.above_low) return fmt::format("must be above {} and not above {}", range.low, range.high);
  return fmt::format("must lie between {} and {}", range.low, range.high);
}

enum class Holds { text, table, number };

/// A key that a table may have.
struct KnownKey {
  std::string table;  ///< "" for the keys and tables of the file itself
  std::string key;
  Holds holds;
  bool required = true;
  bool coefficient = false;
  std::size_t numbers = 1;  ///< length of the list

  std::string name() const { return holds == Holds::table ? fmt::format("[{}]", key) : key; }
};

/// The keys of a model's ship file, without those of [confidence].
template <class Model>
std::vector<KnownKey> keys_of_model() {
  std::vector<KnownKey> keys{{"", "name", Holds::text}, {"", "model", Holds::text}, {"", "confidence", Holds::table, false}};
  const auto add_part = [&]<class Part>(std::string_view table, Part Model::*) {
    if (keys.back().table != table) keys.push_back({"", std::string(table), Holds::table});
    for (const auto& p : Part::parameters()) {
      const auto [key, index] = place_of(p.key);
      if (index.value_or(0) > 0) ++keys.back().numbers;
      else keys.push_back({std::string(table), std::string(key), Holds::number, p.required, p.role == Role::coefficient});
    }
  };
  std::apply([&](const auto&... section) { (add_part(section.table, section.part), ...); }, Model::sections());
  return keys;
}

class ShipReader {
 public:
  ShipReader(const toml::table& root, const std::filesystem::path& file) : root_(root), file_(file) {}

  Ship read() {
    require_model();
    require_keys(root_, "");
    Ship ship;
    ship.name = text("name");
    ship.model = read_parts<MmgShip<double>>();
    read_confidence(ship.confidence);
    return ship;
  }

 private:
  using Place = toml::source_position;

  [[noreturn]] void fail(const Place& place, std::string_view what) const {
    throw FileError({file_, place.line, place.column}, what);
  }
  [[noreturn]] void fail(const toml::node& node, std::string_view what) const { fail(node.source().begin, what); }

  /// Refuses models and physics that later versions may understand.
  void require_model() const {
    if (const auto* node = root_.get("model"); node && text("model") != "mmg")
      fail(*node, fmt::format("model \"{}\" is not known to this version (known: mmg)", text("model")));
    if (const auto* effects = root_.get("effect")) fail(*effects, "[[effect]] is not understood by this version");
  }

  std::string text(std::string_view key) const {
    const auto& node = *root_.get(key);
    if (const auto value = node.value_exact<std::string>()) return *value;
    fail(node, fmt::format("{} must be a text in quotes", key));
  }

  // -------------------------------------------------------------- every key, and no other

  /// The first required key that the table lacks.
  const KnownKey* missing_key(const toml::table& table, std::string_view name) const {
    const auto lacks = [&](const KnownKey& k) { return k.table == name && k.required && !table.contains(k.key); };
    const auto found = std::ranges::find_if(keys_, lacks);
    return found == keys_.end() ? nullptr : &*found;
  }

  void require_keys(const toml::table& table, std::string_view name) const {
    const auto* missing = missing_key(table, name);
    const auto where = name.empty() ? std::string{} : fmt::format(" in [{}]", name);
    for (auto&& [key, value] : table) {
      const auto is_key = [&](const KnownKey& k) { return k.table == name && k.key == key.str(); };
      if (std::ranges::any_of(keys_, is_key)) continue;
      const auto hint = missing ? fmt::format("; {} is missing", missing->name()) : std::string{};
      fail(key.source().begin, fmt::format("{}{} is not known{}", key.str(), where, hint));
    }
    if (missing) fail(table, fmt::format("{} is missing{}", missing->name(), where));
  }

  // -------------------------------------------------------------- parts

  template <class Model>
  Model read_parts() const {
    Model model{};
    std::apply([&](const auto&... section) { (require_keys(table_of(section.table), section.table), ...); }, Model::sections());
    std::apply([&](const auto&... section) { (read_part(section.table, model.*section.part), ...); }, Model::sections());
    return model;
  }

  const toml::table& table_of(std::string_view name) const {
    const auto& node = *root_.get(name);
    if (const auto* table = node.as_table()) return *table;
    fail(node, fmt::format("{} must be a table", name));
  }

  template <class Part>
  void read_part(std::string_view table_name, Part& part) const {
    const auto& table = table_of(table_name);
    for (const auto& parameter : Part::parameters()) {
      const auto place = place_of(parameter.key);
      if (const auto* node = table.get(place.key))
        part.*parameter.member = number(*node, place, table_name, parameter.range) * parameter.si;
    }
  }

  double number(const toml::node& node, const KeyPlace& place, std::string_view table, const Range& range) const {
    const auto& element = place.index ? list_element(node, place, table) : node;
    const auto value = element.value<double>();
    if (!value || !element.is_number() || !std::isfinite(*value)) fail(element, fmt::format("{} in [{}] must be a number", place.key, table));
    if (range.contains(*value)) return *value;
    fail(element, fmt::format("{} in [{}] {}, got {}", place.key, table, requirement(range), *value));
  }

  const toml::node& list_element(const toml::node& node, const KeyPlace& place, std::string_view table) const {
    const auto same = [&](const KnownKey& k) { return k.table == table && k.key == place.key; };
    const auto numbers = std::ranges::find_if(keys_, same)->numbers;
    const auto* list = node.as_array();
    if (!list) fail(node, fmt::format("{} in [{}] must be a list of {} numbers", place.key, table, numbers));
    if (list->size() != numbers) fail(node, fmt::format("{} in [{}] must be a list of {} numbers, got {}", place.key, table, numbers, list->size()));
    return *list->get(*place.index);
  }

  // -------------------------------------------------------------- trust

  void read_confidence(Confidence& confidence) const {
    if (!root_.contains("confidence")) return;
    for (auto&& [key, value] : table_of("confidence")) {
      if (key != "coefficients" && !is_coefficient(key.str()))
        fail(key.source().begin, fmt::format("{} in [confidence] is not a coefficient of this model", key.str()));
      const double deviation = number(value, {key.str(), std::nullopt}, "confidence", non_negative);
      if (key == "coefficients") confidence.coefficients = deviation;
      else confidence.named.emplace_back(key.str(), deviation);
    }
  }

  bool is_coefficient(std::string_view key) const {
    return std::ranges::any_of(keys_, [&](const KnownKey& k) { return k.coefficient && k.key == key; });
  }

  const toml::table& root_;
  std::filesystem::path file_;
  std::vector<KnownKey> keys_ = keys_of_model<MmgShip<double>>();
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
