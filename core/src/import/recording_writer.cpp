#include "recording_writer.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <iterator>
#include <sstream>

#include "swayaw/core/detail/csv_text.hpp"

namespace swayaw::inline core::detail {
namespace {

void append_trimmed(std::string& text, std::string_view number) {
  const auto last = number.find_last_not_of('0');
  text.append(number.substr(0, number[last] == '.' ? last : last + 1));
}

/// Seconds of microseconds, without zeros at the end.
void append_seconds(std::string& text, Microseconds time) {
  fmt::format_to(std::back_inserter(text), "{}{}", time < 0 ? "-" : "", std::abs(time) / second_us);
  if (const auto rest = std::abs(time) % second_us; rest != 0) append_trimmed(text, fmt::format(".{:06}", rest));
}

class RowWriter {
 public:
  RowWriter(std::string& text, const RawTables& raw, const RecordingPlan& plan, const Times& times)
      : text_(text), raw_(raw), plan_(plan), times_(times) {}

  void write_header() {
    text_ += "time_s";
    for (const auto& c : plan_.channels) text_.append(",").append(c.target);
    for (const auto& c : plan_.kept) text_.append(",").append(cell_naming(c.name));
    text_ += '\n';
  }

  void write_file(std::size_t f) {
    SampleRows rows(raw_.tables[f]);
    for (std::size_t i = 0; rows.next(); ++i)
      if (const auto time = times_.of_file[f][i]; time != no_time) write_row(rows.cells(), time);
  }

 private:
  void write_row(const std::vector<std::string_view>& cells, Microseconds time) {
    if (times_.as_written) write_as_it_is(cells[plan_.time_source], raw_.rules[plan_.time_source]);
    else append_seconds(text_, time - times_.first);
    for (const auto& c : plan_.channels) text_ += ',', write_channel(c, cells);
    for (const auto& c : plan_.kept) text_ += ',', write_kept(cells[c.source], raw_.rules[c.source]);
    text_ += '\n';
  }

  void write_channel(const PlannedColumn& c, const std::vector<std::string_view>& cells) {
    const auto cell = cells[c.source];
    if (c.form == CellForm::number && c.factor == 1.0 && !c.twin) return write_as_it_is(cell, raw_.rules[c.source]);
    auto [value, kind] = value_in(cell, raw_.rules[c.source], c.form);
    if (kind != CellKind::number) return;
    if (c.twin) {
      const auto other = value_in(cells[*c.twin], raw_.rules[*c.twin], c.form);
      if (other.kind != CellKind::number) return;
      const bool sum = c.quantity == Quantity::thrust || c.quantity == Quantity::torque;
      value = (value + other.value) * (sum ? 1.0 : 0.5);
    }
    const auto side = c.hemisphere ? cells[*c.hemisphere] : std::string_view{};
    if (side.starts_with('S') || side.starts_with('W')) value = -value;
    // a tenth of a millimetre on the ground; else all digits that a double surely has
    if (c.form == CellForm::number || c.form == CellForm::sided)
      fmt::format_to(std::back_inserter(text_), "{:.15g}", value * c.factor);
    else append_trimmed(text_, fmt::format("{:.9f}", value));
  }

  void write_as_it_is(std::string_view cell, const NumberRules& rules) {
    NumberCell number;
    if (read_cell(cell, rules, number) == CellKind::number) text_ += number.text();
  }

  void write_kept(std::string_view cell, const NumberRules& rules) {
    NumberCell number;
    switch (read_cell(cell, rules, number)) {
      case CellKind::missing: return;
      case CellKind::number:
        if (number.unit.empty()) return void(text_ += number.text());
        [[fallthrough]];
      case CellKind::text: text_ += cell_naming(one_line(cell));
    }
  }

  static std::string one_line(std::string_view cell) {
    auto text = without_double_quotes(cell);
    for (char& c : text)
      if (c == '\n' || c == '\r') c = ' ';
    return text;
  }

  std::string& text_;
  const RawTables& raw_;
  const RecordingPlan& plan_;
  const Times& times_;
};

}  // namespace

std::string toml_text(const std::string& text) {
  const toml::value<std::string> value(text);
  std::ostringstream quoted;
  quoted << toml::toml_formatter(value, toml::format_flags::allow_unicode_strings);
  return std::move(quoted).str();
}

std::string toml_list(const std::vector<std::string>& texts) {
  std::string list;
  for (const auto& text : texts) list.append(list.empty() ? "[" : ", ").append(toml_text(text));
  return list.empty() ? "[]" : list + "]";
}

std::string key_lines(const std::vector<RunRemark>& keys) {
  std::string text;
  for (const auto& [key, value] : keys) text += fmt::format("# {} = {}\n", key, value);
  return text;
}

void append_rows(std::string& text, const RawTables& raw, const RecordingPlan& plan, const Times& times) {
  RowWriter writer(text, raw, plan, times);
  writer.write_header();
  for (const auto f : times.order) writer.write_file(f);
}

}  // namespace swayaw::core::detail
