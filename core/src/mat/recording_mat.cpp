#include "recording_mat.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>

#include "../run_keys.hpp"
#include "swayaw/core/detail/csv_text.hpp"
#include "swayaw/core/refusal.hpp"

namespace swayaw::inline core::detail {
namespace {

// ---------------------------------------------------------------- writing

/// Numbers of a column of text, if it has no other cells.
std::optional<std::vector<double>> numbers_in(const ExtraColumn& column) {
  std::vector<double> numbers;
  for (const auto& cell : column.cells) {
    const auto number = number_in(unquoted(cell));
    if (!number && !is_missing(cell)) return std::nullopt;
    numbers.push_back(number.value_or(missing));
  }
  const bool any = std::ranges::any_of(numbers, [](double number) { return std::isfinite(number); });
  return any ? std::optional(std::move(numbers)) : std::nullopt;
}

MatValue value_of(const ExtraColumn& column) {
  if (auto numbers = numbers_in(column)) return mat_column(std::move(*numbers));
  std::vector<std::string> texts;
  std::ranges::transform(column.cells, std::back_inserter(texts), name_in);
  return mat_texts(texts);
}

MatValue value_of(const toml::node& node, std::string_view as_written) {
  if (const auto* number = node.as_floating_point()) return mat_number(number->get());
  if (const auto* number = node.as_integer()) return mat_number(static_cast<double>(number->get()));
  if (const auto* truth = node.as_boolean()) return {truth->get()};
  if (const auto* text = node.as_string()) return {text->get()};
  const auto* list = node.as_array();
  if (list == nullptr) return {std::string(as_written)};
  MatCell cell{.values = {}, .is_row = true};
  for (const auto& element : *list) cell.values.push_back(value_of(element, as_written));
  return {std::move(cell)};
}

MatValue value_of(const RunRemark& remark) {
  try {
    const auto table = toml::parse("value = " + remark.value);
    return value_of(*table.get("value"), remark.value);
  } catch (const toml::parse_error&) {
    return {remark.value};
  }
}

/// Names of extra columns as the file has them.
MatValue renamed(MatValue names) {
  if (auto* cell = std::get_if<MatCell>(&names.is))
    for (auto& value : cell->values)
      if (auto* name = std::get_if<std::string>(&value.is)) *name = mat_name(*name);
  return names;
}

class RecordingVariables {
 public:
  void add(std::string_view name, MatValue value) { variables_.push_back({unused(mat_name(name)), std::move(value)}); }

  void add(const RunFacts& facts) {
    add("rudder_positive", {std::string("port")});
    if (!facts.manoeuvre.empty()) add("manoeuvre", {facts.manoeuvre});
    if (facts.execute) add("execute_s", mat_number(*facts.execute));
    if (facts.water_depth) add("water_depth_m", mat_number(*facts.water_depth));
    for (const auto& remark : facts.remarks)
      add(remark.key, remark.key == "extra_columns" ? renamed(value_of(remark)) : value_of(remark));
  }

  std::vector<MatVariable> taken() { return std::move(variables_); }

 private:
  /// The name, with a number behind it where it is taken.
  std::string unused(const std::string& name) const {
    const auto is_taken = [&](const std::string& one) {
      return std::ranges::find(variables_, one, &MatVariable::name) != variables_.end();
    };
    auto result = name;
    for (int i = 2; is_taken(result); ++i) result = fmt::format("{}_{}", name.substr(0, 58), i);
    return result;
  }

  std::vector<MatVariable> variables_;
};

// ---------------------------------------------------------------- reading

bool is_column_name(std::string_view name) {
  return name == "time_s" || name == "lat_deg" || name == "lon_deg" || column_named(name);
}

const MatVariable* variable_named(const std::vector<MatVariable>& variables, std::string_view name) {
  const auto found = std::ranges::find(variables, name, &MatVariable::name);
  return found == variables.end() ? nullptr : &*found;
}

/// The variables of the file, or the fields of the one struct that is a recording.
std::vector<MatVariable> run_in(std::vector<MatVariable> variables, const std::filesystem::path& file) {
  if (variable_named(variables, "time_s") != nullptr) return variables;
  std::vector<MatStruct*> runs;
  for (auto& variable : variables)
    if (auto* record = std::get_if<MatStruct>(&variable.value.is))
      if (variable_named(record->fields, "time_s") != nullptr) runs.push_back(record);
  if (runs.size() > 1) throw FileError({file, 1, 1}, "holds several structs with time_s; a file is one recording");
  if (runs.size() == 1) return std::move(runs.front()->fields);
  for (const auto& variable : variables)
    if (const auto* other = std::get_if<MatOther>(&variable.value.is))
      throw FileError({file, 1, 1}, fmt::format("variable {} is {}; save a struct of vectors: "
                                                "table2struct(t, \"ToScalar\", true)",
                                                shown(variable.name), other->what));
  throw FileError({file, 1, 1},
                  "no variable time_s, nor a struct with that field; swayaw import reads files whose "
                  "variables have other names");
}

std::string number_text(double value) { return std::isnan(value) ? std::string{} : fmt::format("{}", value); }

/// A whole number of TOML has no sign at 0.
std::string toml_number(double value) {
  return value == 0.0 && std::signbit(value) ? "-0.0" : fmt::format("{}", value);
}

/// A cell of a comma-separated file with that text.
std::string cell_with(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return c >= 0 && c < ' '; }, ' ');
  return cell_naming(text);
}

std::optional<std::string> cell_text(const MatValue& value) {
  if (const auto* text = std::get_if<std::string>(&value.is)) return cell_with(*text);
  const auto* numbers = std::get_if<MatNumbers>(&value.is);
  if (numbers == nullptr || numbers->values.size() > 1) return std::nullopt;
  return numbers->values.empty() ? std::string{} : number_text(numbers->values.front());
}

/// Text of the recording file that the variables stand for.
class RecordingText {
 public:
  RecordingText(const std::vector<MatVariable>& variables, const std::filesystem::path& file)
      : file_(file), samples_(length_of(*variable_named(variables, "time_s"))) {
    for (const auto& variable : variables) add(variable);
  }

  std::string text() const {
    auto text = facts_ + fmt::format("{}\n", fmt::join(names_, ","));
    for (std::size_t i = 0; i < samples_; ++i)
      for (const auto& column : columns_) text.append(column[i]).append(&column == &columns_.back() ? "\n" : ",");
    return text;
  }

  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  [[noreturn]] void refuse(const std::string& what) const { throw FileError({file_, 1, 1}, what); }

  /// Numbers of a vector. @throws FileError  if the variable is none
  std::size_t length_of(const MatVariable& variable) const {
    const auto* numbers = std::get_if<MatNumbers>(&variable.value.is);
    if (numbers == nullptr || (numbers->rows > 1 && numbers->columns > 1))
      refuse(fmt::format("variable {} is not a vector of numbers", shown(variable.name)));
    return numbers->values.size();
  }

  void add(const MatVariable& variable) {
    if (is_column_name(variable.name)) return add_known(variable);
    if (samples_ > 1 && add_other(variable)) return;
    if (const auto value = toml_value(variable.value)) {
      facts_ += fmt::format("# {} = {}\n", variable.name, *value);
      return;
    }
    warnings_.push_back(fmt::format("{}: variable {} is neither a column of {} samples nor a run key; left out",
                                    file_.filename().string(), shown(variable.name), samples_));
  }

  void add_known(const MatVariable& variable) {
    const auto length = length_of(variable);
    if (length == 0 && variable.name != "time_s") return;
    if (length != samples_)
      refuse(fmt::format("variable {} has {} numbers, and time_s has {}", variable.name, length, samples_));
    add_column(variable.name, std::get<MatNumbers>(variable.value.is).values);
  }

  /// A column that recordings do not have, as long as the others. @return whether it is one
  bool add_other(const MatVariable& variable) {
    if (const auto* numbers = std::get_if<MatNumbers>(&variable.value.is)) {
      if (numbers->values.size() != samples_) return false;
      add_column(variable.name, numbers->values);
      return true;
    }
    const auto* cell = std::get_if<MatCell>(&variable.value.is);
    if (cell == nullptr || cell->is_row || cell->values.size() != samples_) return false;
    std::vector<std::string> cells;
    for (const auto& value : cell->values)
      if (auto text = cell_text(value)) cells.push_back(std::move(*text));
    if (cells.size() != samples_) return false;
    names_.push_back(variable.name);
    columns_.push_back(std::move(cells));
    return true;
  }

  void add_column(const std::string& name, const std::vector<double>& values) {
    names_.push_back(name);
    std::ranges::transform(values, std::back_inserter(columns_.emplace_back()), number_text);
  }

  std::filesystem::path file_;
  std::size_t samples_;
  std::string facts_;
  std::vector<std::string> names_;
  std::vector<std::vector<std::string>> columns_;
  std::vector<std::string> warnings_;
};

}  // namespace

std::vector<MatVariable> mat_of(const Recording& recording) {
  RecordingVariables variables;
  variables.add("time_s", mat_column(recording.time));
  for (std::size_t i = 0; i < channel_count; ++i)
    if (!recording.channels[i].empty())
      variables.add(column_name(static_cast<Channel>(i)), mat_column(recording.channels[i]));
  for (const auto& extra : recording.extra) variables.add(extra.name, value_of(extra));
  variables.add(recording.facts);
  return variables.taken();
}

std::optional<std::string> toml_value(const MatValue& value) {
  if (const auto* truth = std::get_if<bool>(&value.is)) return *truth ? "true" : "false";
  if (const auto* text = std::get_if<std::string>(&value.is)) return in_quotes(*text);
  std::vector<std::string> list;
  if (const auto* numbers = std::get_if<MatNumbers>(&value.is)) {
    if (numbers->rows > 1 && numbers->columns > 1) return std::nullopt;
    std::ranges::transform(numbers->values, std::back_inserter(list), toml_number);
    if (list.size() == 1) return list.front();
  } else if (const auto* cell = std::get_if<MatCell>(&value.is)) {
    for (const auto& element : cell->values) {
      auto text = toml_value(element);
      if (!text) return std::nullopt;
      list.push_back(std::move(*text));
    }
  } else {
    return std::nullopt;
  }
  return fmt::format("[{}]", fmt::join(list, ", "));
}

RecordingFile read_recording_mat(const std::filesystem::path& file, std::optional<Side> rudder_positive) {
  const RecordingText text(run_in(read_mat(file), file), file);
  auto result = parse_recording(text.text(), file, rudder_positive);
  result.warnings.insert(result.warnings.begin(), text.warnings().begin(), text.warnings().end());
  return result;
}

}  // namespace swayaw::core::detail
