#include "time_cell.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string>
#include <tuple>
#include <utility>

#include "characters.hpp"
#include "swayaw/core/detail/csv_text.hpp"

namespace swayaw::inline core::detail {
namespace {

constexpr bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c & 0x80) != 0; }

/// Months by their first letters in English, German, Norwegian, Danish, Dutch and Spanish.
constexpr std::array months = std::to_array<std::pair<std::string_view, int>>(
    {{"jan", 1},  {"ene", 1},  {"feb", 2},  {"mar", 3},  {"m\xC3\xA4r", 3}, {"mrz", 3},  {"maa", 3},
     {"mrt", 3},  {"apr", 4},  {"abr", 4},  {"may", 5},  {"mai", 5},        {"maj", 5},  {"mei", 5},
     {"jun", 6},  {"jul", 7},  {"aug", 8},  {"ago", 8},  {"sep", 9},        {"oct", 10}, {"okt", 10},
     {"nov", 11}, {"dec", 12}, {"dez", 12}, {"des", 12}, {"dic", 12}});

/// Time zones by name, minutes east of UTC.
constexpr std::array zones = std::to_array<std::pair<std::string_view, int>>(
    {{"z", 0}, {"utc", 0}, {"gmt", 0}, {"cet", 60}, {"mez", 60}, {"cest", 120}, {"mesz", 120}, {"jst", 540}});

/// Takes text from the front, as long as it is what is asked for.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : rest_(text) {}

  std::string_view rest() const { return rest_; }
  bool at_end() const { return rest_.empty(); }

  bool take(char c) {
    if (!rest_.starts_with(c)) return false;
    rest_.remove_prefix(1);
    return true;
  }
  char take_one_of(std::string_view chars) {
    if (rest_.empty() || chars.find(rest_.front()) == std::string_view::npos) return '\0';
    const char c = rest_.front();
    rest_.remove_prefix(1);
    return c;
  }
  void skip_blanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(' '), rest_.size())); }

  struct Digits {
    int value;
    std::size_t count;
  };
  std::optional<Digits> digits(std::size_t most) {
    std::size_t count = 0;
    while (count < rest_.size() && is_digit(rest_[count])) ++count;
    if (count == 0 || count > most) return std::nullopt;
    int value = 0;
    std::from_chars(rest_.data(), rest_.data() + count, value);
    rest_.remove_prefix(count);
    return Digits{value, count};
  }
  std::string word() {
    std::size_t count = 0;
    while (count < rest_.size() && is_letter(rest_[count])) ++count;
    const auto found = lower_case(rest_.substr(0, count));
    rest_.remove_prefix(count);
    return found;
  }

 private:
  std::string_view rest_;
};

std::optional<int> month_named(std::string_view word) {
  const auto found = std::ranges::find_if(months, [&](const auto& month) { return word.starts_with(month.first); });
  return found == months.end() ? std::nullopt : std::optional(found->second);
}

/// .5 of a second in microseconds.
Microseconds fraction(Scanner& text) {
  Microseconds value = 0, unit = second_us / 10;
  while (const char c = text.take_one_of("0123456789")) {
    value += (c - '0') * unit;
    unit /= 10;
  }
  return value;
}

/// AM and PM. @return whether the hour is one of a clock with twelve
bool take_half_of_day(Scanner& text, int& hour) {
  Scanner ahead = text;
  ahead.skip_blanks();
  auto word = ahead.word();
  if ((word == "a" || word == "p") && ahead.take('.')) word += ahead.word(), ahead.take('.');
  if (word != "am" && word != "pm") return true;
  if (hour < 1 || hour > 12) return false;
  hour = hour % 12 + (word == "pm" ? 12 : 0);
  text = ahead;
  return true;
}

std::optional<Microseconds> take_clock(Scanner& text) {
  const auto hour = text.digits(2);
  if (!hour || !text.take(':')) return std::nullopt;
  const auto minute = text.digits(2);
  if (!minute || minute->count != 2) return std::nullopt;
  Microseconds seconds = 0;
  if (text.take(':')) {
    const auto second = text.digits(2);
    if (!second || second->value > 59) return std::nullopt;
    seconds = second->value * second_us;
    if (text.take_one_of(".,:") != '\0') seconds += fraction(text);
  }
  int h = hour->value;
  if (!take_half_of_day(text, h) || minute->value > 59) return std::nullopt;
  // 24:00:00 is the end of a day
  if (h > 23 && !(h == 24 && minute->value == 0 && seconds == 0)) return std::nullopt;
  return h * hour_us + minute->value * (hour_us / 60) + seconds;
}

/// "Mar 12, 2024"
std::optional<WrittenDate> take_date_from_month(Scanner& text) {
  const auto month = month_named(text.word());
  if (!month) return std::nullopt;
  text.take_one_of(".-/ ");
  text.skip_blanks();
  const auto day = text.digits(2);
  if (!day || text.take_one_of(", -/") == '\0') return std::nullopt;
  text.skip_blanks();
  const auto year = text.digits(4);
  if (!year) return std::nullopt;
  return WrittenDate{{day->value, *month, year->value}, DateOrder::day_month_year};
}

std::optional<WrittenDate> take_date(Scanner& text) {
  if (!text.at_end() && is_letter(text.rest().front())) return take_date_from_month(text);
  const auto first = text.digits(8);
  if (!first) return std::nullopt;
  if (first->count == 8)
    return WrittenDate{{first->value / 10000, first->value / 100 % 100, first->value % 100}, DateOrder::year_month_day};
  const char separator = text.take_one_of("./- ");
  if (separator == '\0' || first->count > 4) return std::nullopt;
  text.skip_blanks();
  const auto named = text.at_end() || is_digit(text.rest().front()) ? std::nullopt : month_named(text.word());
  const auto second = named ? Scanner::Digits{*named, 2} : text.digits(2).value_or(Scanner::Digits{0, 0});
  if (second.count == 0 || text.take_one_of("./- ") == '\0') return std::nullopt;
  text.skip_blanks();
  const auto third = text.digits(4);
  if (!third || (separator == ' ' && !named)) return std::nullopt;
  WrittenDate date{{first->value, second.value, third->value}};
  if (first->count >= 3) date.order = DateOrder::year_month_day;
  else if (named || separator == '.') date.order = DateOrder::day_month_year;
  return date;
}

}  // namespace

std::optional<int> zone_named(std::string_view text) {
  const auto small = lower_case(trimmed(text));
  const auto known = std::ranges::find(zones, small, &std::pair<std::string_view, int>::first);
  if (known != zones.end()) return known->second;
  Scanner rest(small);
  for (const std::string_view name : {"utc", "gmt"})
    if (small.starts_with(name)) rest = Scanner(std::string_view(small).substr(name.size()));
  const char sign = rest.take_one_of("+-");
  const auto hours = sign == '\0' ? std::nullopt : rest.digits(4);
  if (!hours) return std::nullopt;
  int minutes = hours->count > 2 ? hours->value / 100 * 60 + hours->value % 100 : hours->value * 60;
  if (rest.take(':')) {
    const auto more = rest.digits(2);
    if (!more) return std::nullopt;
    minutes += more->value;
  }
  if (!rest.at_end() || minutes > 14 * 60) return std::nullopt;
  return sign == '-' ? -minutes : minutes;
}

std::optional<TimeCell> time_cell(std::string_view cell) {
  if (cell.size() < 4 || cell.size() > 48) return std::nullopt;
  TimeCell found;
  Scanner text(cell);
  if (Scanner ahead = text; (found.clock = take_clock(ahead))) text = ahead;
  else if ((found.date = take_date(text))) {
    const bool letter = text.take_one_of("Tt") != '\0';
    text.take_one_of(",_");
    text.skip_blanks();
    if (Scanner clock = text; (found.clock = take_clock(clock))) text = clock;
    else if (letter) return std::nullopt;
  } else return std::nullopt;
  text.skip_blanks();
  if (text.at_end()) return found;
  found.zone_minutes = found.clock ? zone_named(text.rest()) : std::nullopt;
  return found.zone_minutes ? std::optional(found) : std::nullopt;
}

std::optional<std::int64_t> day_of(const WrittenDate& date, DateOrder order) {
  auto [y, m, d] = date.parts;
  if (order == DateOrder::day_month_year) std::swap(y, d);
  if (order == DateOrder::month_day_year) std::tie(m, d, y) = std::tuple(y, m, d);
  if (y < 100) y += 2000;
  const std::chrono::year_month_day day{std::chrono::year{y}, std::chrono::month{static_cast<unsigned>(m)},
                                        std::chrono::day{static_cast<unsigned>(d)}};
  if (!day.ok()) return std::nullopt;
  // the library's clock counts nanoseconds, which end in 2262
  constexpr int first_year = 1700, last_year = 2261;
  if (y < first_year || y > last_year) return std::nullopt;
  return std::chrono::sys_days{day}.time_since_epoch().count();
}

std::string iso_utc(Microseconds time) {
  const std::chrono::sys_time<std::chrono::microseconds> at{std::chrono::microseconds{time}};
  const auto whole = std::chrono::floor<std::chrono::seconds>(at);
  auto text = fmt::format("{:%Y-%m-%dT%H:%M:%S}", whole);
  if (const auto rest = (at - whole).count(); rest != 0) {
    text += fmt::format(".{:06}", rest);
    text.erase(text.find_last_not_of('0') + 1);
  }
  return text + "Z";
}

}  // namespace swayaw::core::detail
