#include "times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include "swayaw/core/refusal.hpp"

namespace swayaw::inline core::detail {
namespace {

class TimesReader {
 public:
  TimesReader(const std::vector<RawTable>& tables, TimeRows rows, const TimeColumns& columns, const TimeRules& rules)
      : tables_(tables), columns_(columns), rules_(rules), format_(rows.format), rows_(std::move(rows.of_file)) {}

  Times read() {
    choose_date_order();
    for (std::size_t f = 0; f < tables_.size(); ++f) times_.of_file.push_back(since_1970(f));
    order_files();
    for (const auto f : times_.order) pass_midnights(f);
    if (rules_.repeats == Repeats::spread) spread_repeats();
    require_increase();
    describe();
    return std::move(times_);
  }

 private:
  [[noreturn]] void fail(std::size_t file, const CellPlace& place, std::string_view what) const {
    throw FileError({tables_[file].file, place.line, place.column}, what);
  }

  // -------------------------------------------------------------- dates

  /// Day and month by what the dates themselves say: a number above 12, a month that would change from day to day.
  void choose_date_order() {
    std::set<int> first, second;
    std::optional<std::pair<std::size_t, CellPlace>> open;
    for (std::size_t f = 0; f < rows_.size(); ++f)
      for (const auto& row : rows_[f]) {
        if (!row.date || row.date->order) continue;
        if (!open) open.emplace(f, row.place);
        first.insert(row.date->parts[0]);
        second.insert(row.date->parts[1]);
      }
    if (!open) return;
    if (rules_.date_order) date_order_ = *rules_.date_order;
    else if (const bool day_first = *first.rbegin() > 12, month_first = *second.rbegin() > 12; day_first != month_first)
      date_order_ = day_first ? DateOrder::day_month_year : DateOrder::month_day_year;
    else if (day_first || (first.size() > 1) == (second.size() > 1))
      fail(open->first, open->second,
           "dates may be day/month or month/day; [time] date_order = \"dmy\" or \"mdy\" in "
           "the column map settles it");
    else date_order_ = first.size() > 1 ? DateOrder::day_month_year : DateOrder::month_day_year;
  }

  bool has_day() const {
    return format_ == TimeFormat::excel || format_ == TimeFormat::unix_s || format_ == TimeFormat::unix_ms ||
           (!rows_.empty() && !rows_.front().empty() && rows_.front().front().date);
  }

  /// Hours of a day that begin anew at midnight, without a date.
  bool is_clock_alone() const {
    return !has_day() && (!format_ || format_ == TimeFormat::hhmmss || format_ == TimeFormat::day_fraction);
  }

  /// Times of a file since 1970, or since whatever the column counts from; those with a zone in UTC.
  std::vector<Microseconds> since_1970(std::size_t f) {
    std::vector<Microseconds> times;
    for (const auto& row : rows_[f]) {
      Microseconds time = row.time;
      if (row.date.has_value() != rows_.front().front().date.has_value())
        fail(f, row.place, "some times have a date and others have none");
      if (row.date) {
        const auto day = day_of(*row.date, row.date->order.value_or(date_order_));
        if (!day) fail(f, row.place, "there is no such date");
        time += *day * day_us;
      }
      if (row.zone_minutes.has_value() != rows_.front().front().zone_minutes.has_value())
        fail(f, row.place, "some times have a zone and others have none");
      times.push_back(time - row.zone_minutes.value_or(0) * 60 * second_us);
    }
    return times;
  }

  // -------------------------------------------------------------- order

  void order_files() {
    times_.order.resize(tables_.size());
    std::iota(times_.order.begin(), times_.order.end(), 0u);
    for (std::size_t f = 0; f < tables_.size(); ++f)
      if (times_.of_file[f].empty())
        throw FileError({tables_[f].file, tables_[f].data_line, 1}, "no samples below the names");
    if (is_clock_alone()) return;
    std::ranges::stable_sort(times_.order, {}, [&](std::size_t f) { return times_.of_file[f].front(); });
  }

  /// A clock that goes back by more than half a day has passed midnight.
  void pass_midnights(std::size_t f) {
    if (!is_clock_alone()) return;
    for (std::size_t i = 0; i < times_.of_file[f].size(); ++i) {
      auto& time = times_.of_file[f][i];
      if (last_clock_ && *last_clock_ - time > day_us / 2) {
        days_passed_ += day_us;
        times_.notes.push_back(fmt::format("{}: the clock passes midnight on line {}",
                                           tables_[f].file.filename().string(), rows_[f][i].place.line));
      }
      last_clock_ = time;
      time += days_passed_;
    }
  }

  /// n rows of one time evenly over the step to the next time.
  void spread_repeats() {
    for (const auto f : times_.order) {
      auto& times = times_.of_file[f];
      Microseconds step = second_us;
      for (auto begin = times.begin(); begin != times.end();) {
        const auto same = *begin;
        const auto end = std::find_if(begin, times.end(), [&](Microseconds time) { return time != same; });
        if (end != times.end()) step = *end - same;
        const auto count = end - begin;
        for (std::ptrdiff_t k = 0; begin != end; ++begin, ++k) *begin += step / count * k + step % count * k / count;
      }
    }
  }

  void require_increase() {
    std::optional<Microseconds> last;
    std::size_t dropped = 0;
    for (const auto f : times_.order)
      for (std::size_t i = 0; i < times_.of_file[f].size(); ++i) {
        auto& time = times_.of_file[f][i];
        if (last && time <= *last) {
          if (rules_.repeats != Repeats::drop) refuse_repeat(f, i, time == *last);
          time = no_time;
          ++dropped;
          continue;
        }
        last = time;
      }
    if (dropped > 0) times_.notes.push_back(fmt::format("rows left out as their time does not increase: {}", dropped));
  }

  [[noreturn]] void refuse_repeat(std::size_t f, std::size_t i, bool same) const {
    if (i == 0)
      fail(f, rows_[f][i].place, "the file begins before the one before it ends; files must follow each other in time");
    fail(f, rows_[f][i].place,
         same ? "the time is that of the row before; [time] repeats = \"drop\" or \"spread\" in the column map leaves "
                "such "
                "rows out, or spreads them over the step"
              : "the time steps back; [time] repeats = \"drop\" in the column map leaves such rows out");
  }

  // -------------------------------------------------------------- what is said of it

  void describe() {
    const auto& first_file = times_.of_file[times_.order.front()];
    times_.first = first_file.front();
    times_.uses_date = rows_.front().front().date.has_value();
    const bool from_zero = columns_.is_own || times_.first == 0;
    times_.as_written =
        format_ == TimeFormat::seconds && from_zero && tables_.size() == 1 && rules_.repeats != Repeats::spread;
    times_.words = format_ ? std::string(words_of_format(*format_)) : has_day() ? "date and clock time" : "clock time";
    describe_date_order();
    describe_start();
  }

  void describe_date_order() {
    if (!has_day() || format_ || rows_.front().front().date->order) return;
    times_.notes.push_back(date_order_ == DateOrder::day_month_year ? "dates are day, month, year"
                                                                    : "dates are month, day, year");
  }

  /// UTC of the first sample, where date and zone are known.
  void describe_start() {
    const auto& row = rows_.front().front();
    const bool unix_time = format_ == TimeFormat::unix_s || format_ == TimeFormat::unix_ms;
    std::optional<int> zone = rules_.zone_minutes;
    if (!zone) zone = columns_.zone_minutes;
    Microseconds origin = 0;
    bool has_date = has_day();
    if (rules_.origin && !has_date) {
      origin = *day_of(*rules_.origin->date, DateOrder::year_month_day) * day_us + rules_.origin->clock.value_or(0);
      has_date = true;
      if (rules_.origin->zone_minutes) zone = rules_.origin->zone_minutes;
    }
    if (columns_.is_own && !rules_.origin) return;
    if (!has_date) {
      if (!format_ || format_ == TimeFormat::hhmmss)
        times_.notes.push_back(
            "the date is not known, so start_utc is left out; [time] origin in the column map tells it");
      return;
    }
    if (!zone && !row.zone_minutes && !unix_time) {
      times_.notes.push_back(
          "the time zone is not known, so start_utc is left out; time_zone = \"+02:00\" in the column "
          "map tells it");
      return;
    }
    const auto shift = row.zone_minutes || unix_time ? 0 : *zone;
    times_.start_utc = iso_utc(origin + (columns_.is_own ? 0 : times_.first) - shift * 60 * second_us);
  }

  const std::vector<RawTable>& tables_;
  const TimeColumns& columns_;
  const TimeRules& rules_;
  std::optional<TimeFormat> format_;  ///< of a column of numbers
  std::vector<std::vector<RowTime>> rows_;
  DateOrder date_order_ = DateOrder::year_month_day;
  std::optional<Microseconds> last_clock_;
  Microseconds days_passed_ = 0;
  Times times_;
};

}  // namespace

Times times_of(const std::vector<RawTable>& tables, const Survey& survey, const TimeColumns& columns,
               const TimeRules& time_rules, const NumberRules& number_rules) {
  return TimesReader(tables, time_rows(tables, survey, columns, time_rules, number_rules), columns, time_rules).read();
}

}  // namespace swayaw::core::detail
