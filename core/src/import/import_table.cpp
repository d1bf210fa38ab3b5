#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "../run_keys.hpp"
#include "name_words.hpp"
#include "recording_writer.hpp"
#include "swayaw/core/detail/toml_depth.hpp"
#include "swayaw/core/import.hpp"
#include "text_encoding.hpp"

namespace swayaw::inline core {
using namespace detail;
namespace {

std::string shown_separator(char separator) {
  switch (separator) {
    case ';': return "semicolons";
    case '\t': return "tabs";
    case '|': return "bars";
    case ',': return "commas";
    default: return "blanks";
  }
}

std::vector<RawTable> read_tables(const std::vector<std::filesystem::path>& files, const NumberRules& rules) {
  std::vector<RawTable> tables;
  for (const auto& file : files) tables.push_back(read_table(file, rules));
  const auto& first = tables.front();
  for (const auto& table : tables)
    for (std::size_t i = 0; i < std::max(table.header.size(), first.header.size()); ++i) {
      const bool same =
          i < table.header.size() && i < first.header.size() && table.header[i].name == first.header[i].name;
      if (same) continue;
      const auto& place = table.header[std::min(i, table.header.size() - 1)].place;
      throw FileError(
          {table.file, place.line, place.column},
          fmt::format("the columns are not those of {}, so the two cannot be joined: \"{}\" here, \"{}\" there",
                      first.file.filename().string(), i < table.header.size() ? shown(table.header[i].name) : "",
                      i < first.header.size() ? shown(first.header[i].name) : ""));
    }
  return tables;
}

RawTables surveyed(std::vector<RawTable> tables, const NumberRules& rules) {
  RawTables raw{.tables = std::move(tables), .survey = {}, .rules = {}};
  raw.survey = survey_of(raw.tables, rules);
  if (raw.survey.rows == 0)
    throw FileError({raw.tables.front().file, raw.tables.front().data_line, 1}, "no samples below the names");
  for (const char mark : decimal_marks(raw.tables, raw.survey, rules)) {
    raw.rules.push_back(rules);
    raw.rules.back().decimal = mark;
  }
  return raw;
}

class TableImporter {
 public:
  TableImporter(std::vector<RawTable> tables, const ColumnMap& map)
      : map_(map), raw_(surveyed(std::move(tables), map.numbers)) {}

  Import run() {
    columns_ = named_columns(raw_, map_);
    choose_time();
    choose_among_equals(raw_, columns_);
    choose_position(columns_);
    require_heading_and_rudder(raw_, columns_);
    choose_units(raw_, columns_, seconds());
    require_heading_and_rudder(raw_, columns_);
    plan_rows();
    describe_files();
    std::size_t size = 0;
    for (const auto& table : raw_.tables) size += table.text.size();
    import_.text.reserve(size + size / 8);
    import_.text = key_lines(keys());
    append_rows(import_.text, raw_, plan_, times_);
    return std::move(import_);
  }

 private:
  // -------------------------------------------------------------- time

  /// The first column whose times increase.
  void choose_time() {
    const auto candidates = time_candidates(raw_, columns_, map_);
    for (const auto& candidate : candidates) {
      try {
        times_ = times_of(raw_.tables, raw_.survey, candidate, map_.time, raw_.rules[candidate.time]);
        return take_time(candidate);
      } catch (const FileError& error) {
        if (!refusal_) refusal_ = error;
      }
    }
    throw FileError(*refusal_);
  }

  void take_time(const TimeColumns& chosen) {
    plan_.time_source = chosen.time;
    for (auto& c : columns_) {
      const bool is_time = c.source == chosen.time, is_date = times_.uses_date && c.source == chosen.date;
      if (!is_time && !is_date) {
        if (c.quantity == Quantity::time || c.quantity == Quantity::date)
          c.quantity.reset(), c.target.clear(), c.why = "another time";
        continue;
      }
      c.quantity = is_time ? Quantity::time : Quantity::date;
      c.target = "time_s";
      c.why = is_time ? times_.words : "date";
    }
  }

  /// Times of all rows in the order of the files as they were given.
  std::vector<double> seconds() const {
    std::vector<double> seconds;
    seconds.reserve(raw_.survey.rows);
    for (const auto& file : times_.of_file)
      for (const auto time : file)
        seconds.push_back(time == no_time ? std::numeric_limits<double>::quiet_NaN()
                                          : static_cast<double>(time - times_.first) * 1e-6);
    return seconds;
  }

  // -------------------------------------------------------------- columns

  bool is_name_taken(const std::string& name) const {
    return is_recording_column(name) || std::ranges::find(plan_.kept, name, &KeptColumn::name) != plan_.kept.end();
  }

  std::string name_to_keep(std::size_t source) const {
    auto name = raw_.shown_name(source);
    for (int n = 2; is_name_taken(name); ++n) name = fmt::format("{} ({})", raw_.shown_name(source), n);
    return name;
  }

  void plan_rows() {
    for (const auto& c : columns_) {
      const bool is_time = c.quantity == Quantity::time || c.quantity == Quantity::date;
      auto why = c.why;
      if (c.is_left_out) why = "left out: " + why;
      else if (is_time) why += "";
      else if (!c.target.empty()) {
        why += steps_of(c);
        plan_.channels.push_back(c);
      } else {
        plan_.kept.push_back({c.source, name_to_keep(c.source)});
        why = why.empty() ? "not understood; kept as it is" : why + "; kept as it is";
      }
      import_.columns.push_back({raw_.shown_name(c.source), c.is_left_out ? "" : c.target, std::move(why),
                                 raw_.survey.columns[c.source].samples()});
    }
  }

  /// Resolution of a column by the digits that are written.
  std::string steps_of(const PlannedColumn& c) const {
    if (c.form != CellForm::number || c.twin) return {};
    return fmt::format(", steps of {} {}", std::pow(10.0, -raw_.survey.columns[c.source].decimals), c.unit->shown);
  }

  // -------------------------------------------------------------- notes and keys

  void note(std::string text) { import_.notes.push_back(std::move(text)); }

  void describe_files() {
    for (const auto f : times_.order) {
      const auto& table = raw_.tables[f];
      note(fmt::format("{}: {}, cells between {}, names on line {}", table.file.filename().string(), table.encoding,
                       shown_separator(table.separator), table.header.front().place.line));
    }
    const bool comma = std::ranges::any_of(raw_.rules, [](const auto& r) { return r.decimal == ','; });
    if (comma) note("decimal commas");
    if (raw_.survey.repeated_headers > 0)
      note(fmt::format("{} repeated rows of names are passed over", raw_.survey.repeated_headers));
    for (const auto& file : raw_.survey.broke_off)
      note(fmt::format("{}: the last row breaks off and is left out", file));
    for (auto& text : times_.notes) note(std::move(text));
    if (times_.start_utc) note(fmt::format("starts at {}", *times_.start_utc));
    note(fmt::format("{} rows", raw_.survey.rows));
  }

  static bool has(const std::vector<RunRemark>& keys, std::string_view key) {
    return std::ranges::find(keys, key, &RunRemark::key) != keys.end();
  }

  std::vector<RunRemark> keys() {
    auto keys = map_.run;
    for (auto& key : keys_of_preamble())
      if (!has(keys, key.key)) keys.push_back(std::move(key));
    add_rudder_sign(keys);
    if (times_.start_utc && !has(keys, "start_utc")) keys.push_back({"start_utc", toml_text(*times_.start_utc)});
    std::vector<std::string> kept, files;
    for (const auto& c : plan_.kept) kept.push_back(c.name);
    for (const auto f : times_.order) files.push_back(raw_.tables[f].file.filename().string());
    if (!kept.empty()) keys.push_back({"extra_columns", toml_list(kept)});
    keys.push_back({"imported.files", toml_list(files)});
    for (const auto& c : import_.columns)
      if (!c.taken_for.empty() && c.why != "date")
        keys.push_back({"imported." + c.taken_for, toml_text(fmt::format("{}: {}", c.source, c.why))});
    keys.push_back({"imported.notes", toml_list(import_.notes)});
    return keys;
  }

  /// "# key = value" above the names, as recordings have it.
  std::vector<RunRemark> keys_of_preamble() const {
    const auto& table = raw_.tables[times_.order.front()];
    std::vector<RunRemark> keys;
    RunFacts facts;
    Convention convention;
    std::vector<std::string> warnings;
    RunKeyReader reader(table.file, facts, convention, warnings);
    for (const auto& [line, text] : table.preamble) {
      const auto written = trimmed(text);
      const auto equals = written.find('=');
      if (!written.starts_with('#') || equals == std::string_view::npos || !is_toml(written.substr(1))) continue;
      const auto key = std::string(trimmed(written.substr(1, equals - 1)));
      if (key.starts_with("imported") || key == "extra_columns") continue;
      reader.read(written.substr(1), line, 2);
      keys.push_back({key, std::string(trimmed(written.substr(equals + 1)))});
    }
    return keys;
  }

  static bool is_toml(std::string_view text) {
    if (place_of_deep_key(text)) return false;
    try {
      return !toml::parse(text).empty();
    } catch (const toml::parse_error&) {
      return false;
    }
  }

  /// The side of positive rudder angles: of the column map, of a name such as "Rudder [deg, stbd +]", of a line above.
  void add_rudder_sign(std::vector<RunRemark>& keys) {
    if (has(keys, "rudder_positive")) return;
    std::string side;
    for (const auto& c : plan_.channels)
      if (side.empty() && (c.quantity == Quantity::rudder || c.quantity == Quantity::rudder_order))
        side = c.rudder_positive;
    for (const auto& [line, text] : raw_.tables.front().preamble)
      if (side.empty() && speaks_of_rudder(text)) side = positive_side_in(text);
    if (!side.empty()) {
      keys.push_back({"rudder_positive", toml_text(side)});
      return note(fmt::format("rudder angles are positive to {}, as the file says", side));
    }
    note(
        "which side positive rudder angles turn to is not said; a recording without rudder_positive means port, and "
        "swayaw check tells it from the motion");
  }

  static bool speaks_of_rudder(std::string_view text) {
    return std::ranges::any_of(words_of(text), [](const std::string& word) {
      return word.starts_with("rud") || word.starts_with("ror") || word == "delta" || word == "timon" ||
             word.starts_with("roer") || word == "dakaku";
    });
  }

  const ColumnMap& map_;
  RawTables raw_;
  std::vector<PlannedColumn> columns_;
  Times times_;
  RecordingPlan plan_;
  std::optional<FileError> refusal_;
  Import import_;
};

}  // namespace

Import import_table(const std::vector<std::filesystem::path>& files, const ImportOptions& options) {
  if (files.empty()) throw Refusal("no file to import");
  const auto map = read_column_map(options.column_map);
  return TableImporter(read_tables(files, map.numbers), map).run();
}

Import import_table_text(std::string_view text, const std::filesystem::path& name, const ImportOptions& options) {
  const auto map = read_column_map(options.column_map);
  return TableImporter({table_of(std::string(text), name, map.numbers)}, map).run();
}

}  // namespace swayaw::core
