#include "column_map.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <utility>

#include "../run_keys.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/channel.hpp"
#include "swayaw/core/detail/toml_text.hpp"

namespace swayaw::inline core::detail {
namespace {

using namespace std::string_view_literals;

template <class T, std::size_t n>
using Choices = std::array<std::pair<std::string_view, T>, n>;

constexpr Choices<TimeFormat, 9> formats{{{"seconds", TimeFormat::seconds},
                                          {"milliseconds", TimeFormat::milliseconds},
                                          {"minutes", TimeFormat::minutes},
                                          {"hours", TimeFormat::hours},
                                          {"excel", TimeFormat::excel},
                                          {"unix", TimeFormat::unix_s},
                                          {"unix_ms", TimeFormat::unix_ms},
                                          {"hhmmss", TimeFormat::hhmmss},
                                          {"day_fraction", TimeFormat::day_fraction}}};
constexpr Choices<DateOrder, 3> date_orders{
    {{"dmy", DateOrder::day_month_year}, {"mdy", DateOrder::month_day_year}, {"ymd", DateOrder::year_month_day}}};
constexpr Choices<Repeats, 3> repeat_ways{
    {{"refuse", Repeats::refuse}, {"drop", Repeats::drop}, {"spread", Repeats::spread}}};
constexpr Choices<char, 2> marks{{{".", '.'}, {",", ','}}};

std::string toml_of(const toml::node& value) {
  std::ostringstream text;
  value.visit([&](const auto& node) { text << toml::toml_formatter(node, toml::format_flags::allow_unicode_strings); });
  return std::move(text).str();
}

class ColumnMapReader {
 public:
  explicit ColumnMapReader(const std::filesystem::path& file) : file_(file) {}

  ColumnMap read() {
    const auto text = read_text(file_, FileUse::description);
    for (auto&& [key, value] : parsed_toml(text, file_)) take(key.str(), key.source(), value);
    return std::move(map_);
  }

 private:
  FilePlace at(const toml::source_region& source) const { return {file_, source.begin.line, source.begin.column}; }
  [[noreturn]] void fail(const toml::node& value, std::string_view what) const {
    throw FileError(at(value.source()), what);
  }

  void take(std::string_view key, const toml::source_region& place, const toml::node& value) {
    if (key == "columns") take_columns(value);
    else if (key == "ignore") take_ignored(value);
    else if (key == "missing") take_missing(value);
    else if (key == "decimal") map_.numbers.decimal = choice(key, value, marks);
    else if (key == "thousands") map_.numbers.thousands = choice(key, value, marks);
    else if (key == "time_zone") map_.time.zone_minutes = zone(value);
    else if (key == "time") take_time(value);
    else if (key == "run") take_run(value);
    else
      throw FileError(at(place), fmt::format("{} is not a key of a column map; those are columns, ignore, missing, "
                                             "decimal, thousands, time_zone, time and run",
                                             shown(key)));
  }

  const toml::table& table(std::string_view key, const toml::node& value) const {
    if (const auto* found = value.as_table()) return *found;
    fail(value, fmt::format("{} must be a table, [{}]", key, key));
  }

  std::string text(std::string_view key, const toml::node& value) const {
    if (const auto found = value.value_exact<std::string>()) return *found;
    fail(value, fmt::format("{} must be a text in quotes", shown(key)));
  }

  template <class T, std::size_t n>
  T choice(std::string_view key, const toml::node& value, const Choices<T, n>& choices) const {
    const auto word = text(key, value);
    std::string all;
    for (const auto& [name, meaning] : choices) {
      if (name == word) return meaning;
      all += fmt::format("{}\"{}\"", all.empty() ? "" : ", ", name);
    }
    fail(value, fmt::format("{} must be one of {}, got \"{}\"", key, all, shown(word)));
  }

  /// The value, or all values of a list.
  template <class F>
  void each(const toml::node& value, F&& take_one) const {
    if (const auto* list = value.as_array())
      for (const auto& one : *list) take_one(one);
    else take_one(value);
  }

  void take_columns(const toml::node& value) {
    for (auto&& [key, target] : table("columns", value)) {
      const std::string name(key.str()), column = text(name, target);
      if (!is_recording_column(column))
        fail(target,
             fmt::format("\"{}\" is not a column of recordings, such as psi_deg (docs/formats.md)", shown(column)));
      map_.columns.push_back({name, column, at(key.source())});
    }
  }

  void take_ignored(const toml::node& value) {
    each(value, [&](const toml::node& one) { map_.ignored.push_back({text("ignore", one), {}, at(one.source())}); });
  }

  void take_missing(const toml::node& value) {
    each(value, [&](const toml::node& one) {
      if (const auto number = one.value<double>(); number && one.is_number())
        map_.numbers.missing_numbers.push_back(*number);
      else map_.numbers.missing_texts.push_back(text("missing", one));
    });
  }

  int zone(const toml::node& value) const {
    if (const auto found = zone_named(text("the zone", value))) return *found;
    fail(value, "a zone is \"Z\" or an offset such as \"+02:00\"");
  }

  TimeCell origin(const toml::node& value) const {
    const auto written = value.is_string() ? text("origin", value) : toml_of(value);
    const auto found = time_cell(written);
    const bool is_date = found && found->date && found->date->order == DateOrder::year_month_day;
    if (is_date && day_of(*found->date, DateOrder::year_month_day)) return *found;
    fail(value, "origin must be a date and time like \"2024-03-12T10:00:00Z\" or \"2024-03-12\"");
  }

  void take_time(const toml::node& value) {
    for (auto&& [key, entry] : table("time", value)) {
      const auto name = key.str();
      if (name == "column") each(entry, [&](const toml::node& one) { map_.time.columns.push_back(text(name, one)); });
      else if (name == "format") map_.time.format = choice(name, entry, formats);
      else if (name == "date_order") map_.time.date_order = choice(name, entry, date_orders);
      else if (name == "zone") map_.time.zone_minutes = zone(entry);
      else if (name == "origin") map_.time.origin = origin(entry);
      else if (name == "repeats") map_.time.repeats = choice(name, entry, repeat_ways);
      else
        throw FileError(at(key.source()),
                        fmt::format("{} is not a key of [time]; those are column, format, date_order, "
                                    "zone, origin and repeats",
                                    shown(name)));
    }
    if (map_.time.columns.size() > 2) fail(value, "column of [time] is one name, or those of date and time");
  }

  /// Keys for above the header row; those that the reader of recordings knows must be as it takes them.
  void take_run(const toml::node& value) {
    RunFacts facts;
    Convention convention;
    std::vector<std::string> warnings;
    for (auto&& [key, entry] : table("run", value)) {
      const std::string name(key.str());
      const auto written = toml_of(entry);
      if (entry.is_table() || written.find('\n') != std::string::npos)
        fail(entry, "a run key holds one value on one line");
      RunKeyReader reader(file_, facts, convention, warnings);
      reader.read(name + " = " + written, key.source().begin.line, key.source().begin.column);
      if (!warnings.empty())
        throw FileError(at(key.source()),
                        fmt::format("{} is not a run key; is {} meant?", shown(name), similar_run_key(name)));
      map_.run.push_back({name, written});
    }
  }

  std::filesystem::path file_;
  ColumnMap map_;
};

}  // namespace

const MappedColumn* ColumnMap::of(const std::string& source) const {
  const auto found = std::ranges::find(columns, source, &MappedColumn::source);
  return found == columns.end() ? nullptr : &*found;
}

bool ColumnMap::ignores(const std::string& source) const {
  return std::ranges::find(ignored, source, &MappedColumn::source) != ignored.end();
}

ColumnMap read_column_map(const std::filesystem::path& file) {
  return file.empty() ? ColumnMap{} : ColumnMapReader(file).read();
}

bool is_recording_column(std::string_view name) {
  return column_named(name) || name == "time_s" || name == "lat_deg" || name == "lon_deg";
}

}  // namespace swayaw::core::detail
