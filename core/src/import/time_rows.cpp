#include "time_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "swayaw/core/detail/csv_text.hpp"
#include "swayaw/core/refusal.hpp"

namespace swayaw::inline core::detail {
namespace {

/// Days from the zeroth of January 1900, as spreadsheets count, to 1970.
constexpr double excel_1970 = 25569.0;

struct FormatFacts {
  TimeFormat format;
  double seconds;  ///< of one
  std::string_view words;
};

constexpr std::array format_facts{
    FormatFacts{TimeFormat::seconds, 1.0, "seconds"},
    FormatFacts{TimeFormat::milliseconds, 0.001, "milliseconds"},
    FormatFacts{TimeFormat::minutes, 60.0, "minutes"},
    FormatFacts{TimeFormat::hours, 3600.0, "hours"},
    FormatFacts{TimeFormat::excel, 86400.0, "days of a spreadsheet, since 1900"},
    FormatFacts{TimeFormat::unix_s, 1.0, "seconds since 1970, UTC"},
    FormatFacts{TimeFormat::unix_ms, 0.001, "milliseconds since 1970, UTC"},
    FormatFacts{TimeFormat::hhmmss, 1.0, "clock times hhmmss"},
    FormatFacts{TimeFormat::day_fraction, 86400.0, "parts of a day"},
};

const FormatFacts& facts_of(TimeFormat format) {
  return *std::ranges::find(format_facts, format, &FormatFacts::format);
}

class TimeRowsReader {
 public:
  TimeRowsReader(const std::vector<RawTable>& tables, const Survey& survey, const TimeColumns& columns,
                 const TimeRules& rules, const NumberRules& numbers)
      : tables_(tables), survey_(survey), columns_(columns), rules_(rules), numbers_(numbers) {}

  TimeRows read() {
    choose_format();
    TimeRows rows{.format = format_, .of_file = {}};
    for (const auto& table : tables_) rows.of_file.push_back(rows_of(table));
    return rows;
  }

 private:
  [[noreturn]] static void fail(const ShownCell& cell, std::string_view what) {
    throw FileError({cell.file, cell.place.line, cell.place.column}, what);
  }
  const ColumnSurvey& column() const { return survey_.columns[columns_.time]; }

  // -------------------------------------------------------------- numbers or text

  void choose_format() {
    const auto& c = column();
    if (c.numbers + c.texts == 0)
      throw FileError({tables_.front().file, tables_.front().header[columns_.time].place.line,
                       tables_.front().header[columns_.time].place.column},
                      "every time is missing");
    if (c.texts > 0 && c.numbers > 0)
      fail(c.texts < c.numbers ? *c.first_text : *c.first_number,
           fmt::format("\"{}\" is not a time as the other cells of the column are",
                       c.texts < c.numbers ? c.first_text->text : c.first_number->text));
    if (c.texts > 0) return;
    format_ = columns_.is_own ? TimeFormat::seconds : rules_.format ? *rules_.format : format_by_values(c);
  }

  TimeFormat format_by_values(const ColumnSurvey& c) const {
    const auto of_unit = [&](double seconds) { return columns_.unit && columns_.unit->si == seconds; };
    // 1986 to 2128; a date in another unit lies elsewhere
    if (c.least > 5e11 && c.most < 5e12) return TimeFormat::unix_ms;
    if (c.least > 5e8 && c.most < 5e9) return TimeFormat::unix_s;
    if (of_unit(0.001)) return TimeFormat::milliseconds;
    if (of_unit(60.0)) return TimeFormat::minutes;
    if (of_unit(3600.0)) return TimeFormat::hours;
    if (of_unit(1.0)) return TimeFormat::seconds;
    // days of 1954 to 2119 in steps below 7 minutes; seconds of a clock would be sampled at 200 Hz and more
    if (c.least > 20000.0 && c.most < 80000.0 && c.shortest_step < 0.005) return TimeFormat::excel;
    // a run of less than a second, or parts of a day in steps below 86 s
    if (c.least >= 0.0 && c.most < 1.0 && c.shortest_step < 0.001) return TimeFormat::day_fraction;
    // from 59 to 100, from 5959 to 10000
    if (c.least >= 0.0 && c.most < 240000.0 && c.most - c.least >= 100.0 && c.longest_step > 40.0 &&
        c.shortest_step < 40.0)
      return TimeFormat::hhmmss;
    // 093012, or a clock in UTC without a unit
    const bool padded =
        c.first_number->text.starts_with('0') && c.first_number->text.find_first_not_of("0123456789") >= 6;
    if (c.least >= 0.0 && c.most < 240000.0 && !columns_.unit &&
        ((padded && c.first_number->text.size() >= 6) || columns_.zone_minutes))
      return TimeFormat::hhmmss;
    // no manoeuvre is sampled once in so long
    constexpr double too_slow = 60.0;  // s
    if (c.shortest_step >= too_slow && std::isfinite(c.shortest_step))
      fail(*c.first_number, fmt::format("times step by {} and have no unit; [time] format = \"milliseconds\" or "
                                        "\"seconds\" in the column map settles it",
                                        c.shortest_step));
    return TimeFormat::seconds;
  }

  // -------------------------------------------------------------- cells

  std::vector<RowTime> rows_of(const RawTable& table) const {
    std::vector<RowTime> rows;
    SampleRows reader(table);
    while (reader.next()) {
      auto row = format_ ? counted(table, reader) : written(table, reader);
      row.place = reader.place_of(reader.cells()[columns_.time]);
      if (columns_.date && is_clock()) row.date = date_in(table, reader);
      rows.push_back(row);
    }
    return rows;
  }

  /// Whether the column tells the time of the day.
  bool is_clock() const { return !format_ || format_ == TimeFormat::hhmmss || format_ == TimeFormat::day_fraction; }

  [[noreturn]] void refuse_cell(const RawTable& table, const SampleRows& reader, std::string_view cell,
                                std::string_view kind) const {
    const auto [line, column] = reader.place_of(cell);
    throw FileError({table.file, line, column}, cell.empty() ? fmt::format("the {} is missing", kind)
                                                             : fmt::format("\"{}\" is not a {}", shown(cell), kind));
  }

  RowTime counted(const RawTable& table, SampleRows& reader) const {
    const auto cell = reader.cells()[columns_.time];
    NumberCell number;
    if (read_cell(cell, numbers_, number) != CellKind::number) refuse_cell(table, reader, cell, "time");
    const auto& facts = facts_of(*format_);
    auto value = number.value;
    if (format_ == TimeFormat::excel) value -= excel_1970;
    if (format_ == TimeFormat::hhmmss) {
      const auto clock = seconds_of_hhmmss(value);
      if (!clock) refuse_cell(table, reader, cell, "clock time hhmmss");
      value = *clock;
    }
    constexpr double longest = 1e11;  // [s], 3,200 years: beyond 292,000 microseconds leave the range of integers
    if (!(std::abs(value * facts.seconds) < longest)) refuse_cell(table, reader, cell, "time");
    auto time = static_cast<Microseconds>(std::llround(value * facts.seconds * 1e6));
    // a day of 2024 with all digits of a double is exact to a microsecond; its seconds are meant
    constexpr Microseconds ms = 1000;
    if (format_ == TimeFormat::excel || format_ == TimeFormat::day_fraction)
      time = (time + (time >= 0 ? ms / 2 : -ms / 2)) / ms * ms;
    return {.time = time};
  }

  static std::optional<double> seconds_of_hhmmss(double value) {
    const double hours = std::floor(value / 10000.0), minutes = std::floor((value - hours * 10000.0) / 100.0);
    const double seconds = value - hours * 10000.0 - minutes * 100.0;
    if (hours >= 24.0 || minutes >= 60.0 || seconds >= 60.0 || value < 0.0) return std::nullopt;
    return hours * 3600.0 + minutes * 60.0 + seconds;
  }

  RowTime written(const RawTable& table, SampleRows& reader) const {
    const auto cell = reader.cells()[columns_.time];
    const auto found = time_cell(cell);
    if (!found || (!found->clock && !columns_.date && !found->date)) refuse_cell(table, reader, cell, "time");
    if (!found->clock) refuse_cell(table, reader, cell, "clock time");
    return {.date = found->date, .time = *found->clock, .zone_minutes = found->zone_minutes};
  }

  std::optional<WrittenDate> date_in(const RawTable& table, SampleRows& reader) const {
    const auto cell = reader.cells()[*columns_.date];
    NumberCell number;
    if (const auto found = time_cell(cell); found && found->date) return found->date;
    // a day as spreadsheets count, as a date
    if (read_cell(cell, numbers_, number) != CellKind::number || number.value < 20000.0 || number.value > 80000.0)
      refuse_cell(table, reader, cell, "date");
    const std::chrono::year_month_day day{
        std::chrono::sys_days{std::chrono::days{static_cast<int>(number.value - excel_1970)}}};
    return WrittenDate{{static_cast<int>(day.year()), static_cast<int>(static_cast<unsigned>(day.month())),
                        static_cast<int>(static_cast<unsigned>(day.day()))},
                       DateOrder::year_month_day};
  }

  const std::vector<RawTable>& tables_;
  const Survey& survey_;
  const TimeColumns& columns_;
  const TimeRules& rules_;
  const NumberRules& numbers_;
  std::optional<TimeFormat> format_;  ///< of a column of numbers
};

}  // namespace

TimeRows time_rows(const std::vector<RawTable>& tables, const Survey& survey, const TimeColumns& columns,
                   const TimeRules& rules, const NumberRules& numbers) {
  return TimeRowsReader(tables, survey, columns, rules, numbers).read();
}

std::string_view words_of_format(TimeFormat format) { return facts_of(format).words; }

}  // namespace swayaw::core::detail
