#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>

#include "recording_mat.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/detail/csv_text.hpp"
#include "swayaw/core/detail/toml_text.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/core/ship_text.hpp"

namespace swayaw::inline core {
namespace {

using namespace detail;

/// A variable that tells the units and is no part of the ship.
constexpr std::string_view units_name = "units";

// ---------------------------------------------------------------- writing

MatStruct struct_of(const toml::table& table);

MatValue list_of(const toml::array& list) {
  if (std::ranges::all_of(list, [](const auto& element) { return element.is_number(); })) {
    MatNumbers row{1, list.size(), {}};
    for (const auto& element : list) row.values.push_back(element.template value<double>().value());
    return {std::move(row)};
  }
  MatCell cell{};
  for (const auto& element : list) {
    if (const auto* table = element.as_table()) cell.values.push_back({struct_of(*table)});
    if (const auto* text = element.as_string()) cell.values.push_back({text->get()});
  }
  return {std::move(cell)};
}

MatValue value_of(const toml::node& node) {
  if (const auto* table = node.as_table()) return {struct_of(*table)};
  if (const auto* list = node.as_array()) return list_of(*list);
  if (const auto* text = node.as_string()) return {text->get()};
  if (const auto* truth = node.as_boolean()) return {truth->get()};
  return mat_number(node.value<double>().value_or(0.0));
}

MatStruct struct_of(const toml::table& table) {
  std::vector<std::pair<std::string, const toml::node*>> in_order;
  for (auto&& [key, node] : table) in_order.emplace_back(key.str(), &node);
  std::ranges::sort(in_order, {}, [](const auto& one) {
    const auto place = one.second->source().begin;
    return std::pair(place.line, place.column);
  });
  MatStruct result;
  for (const auto& [key, node] : in_order) result.fields.push_back({key, value_of(*node)});
  return result;
}

/// Units of the numbers of a table, those of a list once.
MatStruct units_in(const MatVariable& table, const std::vector<ShipFileUnit>& units) {
  MatStruct result;
  const auto of = [&](std::string_view key) {
    return std::ranges::find_if(
        units, [&](const auto& u) { return u.table == table.name && u.key.substr(0, u.key.find('[')) == key; });
  };
  for (const auto& field : std::get<MatStruct>(table.value.is).fields)
    if (const auto unit = of(field.name); unit != units.end())
      result.fields.push_back({field.name, {std::string(unit->unit)}});
  return result;
}

/// The same structs with texts in place of the numbers.
MatStruct units_of(const std::vector<MatVariable>& ship, const std::vector<ShipFileUnit>& units) {
  MatStruct result;
  for (const auto& table : ship)
    if (std::holds_alternative<MatStruct>(table.value.is))
      if (auto of_table = units_in(table, units); !of_table.fields.empty())
        result.fields.push_back({table.name, {std::move(of_table)}});
  return result;
}

// ---------------------------------------------------------------- reading

class ShipText {
 public:
  explicit ShipText(const std::filesystem::path& file) : file_(file) {}

  std::string of(const std::vector<MatVariable>& variables) {
    for (const auto& v : variables)
      if (!is_table(v.value) && v.name != units_name) write(v.name, v.value);
    for (const auto& v : variables)
      if (is_table(v.value) && v.name != units_name) write_table(v.name, v.value);
    return std::move(text_);
  }

 private:
  static bool is_struct(const MatValue& value) { return std::holds_alternative<MatStruct>(value.is); }

  /// A struct, or structs in a row.
  static bool is_table(const MatValue& value) {
    const auto* cell = std::get_if<MatCell>(&value.is);
    return is_struct(value) || (cell != nullptr && std::ranges::all_of(cell->values, is_struct));
  }

  void write(const std::string& key, const MatValue& value) {
    const auto* numbers = std::get_if<MatNumbers>(&value.is);
    if (numbers != nullptr && numbers->values.empty()) return;  // a field that other structs of the array have
    const auto text = toml_value(value);
    if (!text) {
      const auto* other = std::get_if<MatOther>(&value.is);
      throw FileError({file_, 1, 1}, fmt::format("{} is {}; a number, a row of numbers or a text in '...' is needed",
                                                 shown(key), other != nullptr ? other->what : "no value of a ship"));
    }
    text_ += fmt::format("{} = {}\n", key, *text);
  }

  /// Several structs are [[key]]s; so is one that is named effect.
  void write_table(const std::string& key, const MatValue& value) {
    if (const auto* cell = std::get_if<MatCell>(&value.is)) {
      for (const auto& element : cell->values) write_fields(fmt::format("[[{}]]", key), element);
      return;
    }
    write_fields(key == "effect" ? "[[effect]]" : fmt::format("[{}]", key), value);
  }

  void write_fields(const std::string& heading, const MatValue& value) {
    text_ += fmt::format("\n{}\n", heading);
    for (const auto& field : std::get<MatStruct>(value.is).fields) write(field.name, field.value);
  }

  std::filesystem::path file_;
  std::string text_;
};

/// The variables of the file, or the fields of its only struct that names a model.
std::vector<MatVariable> ship_in(std::vector<MatVariable> variables) {
  const auto has_model = [](const std::vector<MatVariable>& list) {
    return std::ranges::find(list, "model", &MatVariable::name) != list.end();
  };
  if (has_model(variables)) return variables;
  for (auto& variable : variables)
    if (auto* record = std::get_if<MatStruct>(&variable.value.is); record != nullptr && has_model(record->fields))
      return std::move(record->fields);
  return variables;
}

}  // namespace

std::vector<ShipFileUnit> units_of(const FileKeys& keys) {
  std::vector<ShipFileUnit> units;
  for (const auto& n : keys.parameters) units.push_back({n.table, n.key, n.unit});
  return units;
}

std::string read_ship_text(const std::filesystem::path& file) {
  if (!is_mat(file)) return read_text(file, FileUse::description);
  return ShipText(file).of(ship_in(read_mat(file, FileUse::description)));
}

void write_ship_text(const std::filesystem::path& file, std::string_view text, const std::vector<ShipFileUnit>& units) {
  if (!is_mat(file)) return write_text(file, text);
  auto variables = struct_of(parsed_toml(text, file)).fields;
  auto in_words = units_of(variables, units);
  if (!units.empty()) variables.push_back({std::string(units_name), {std::move(in_words)}});
  write_mat(file, variables);
}

}  // namespace swayaw::core
