#include "nmea_sentence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>

#include "characters.hpp"
#include "swayaw/core/detail/csv_text.hpp"

namespace swayaw::inline core::detail {
namespace {

bool is_capital_or_digit(char c) { return (c >= 'A' && c <= 'Z') || is_digit(c); }

/// Reads numbers and separators off the front of a text.
class Reader {
 public:
  explicit Reader(std::string_view text) : rest_(text) {}

  /// A whole number of `fewest` to `most` digits.
  std::optional<int> digits(std::size_t fewest, std::size_t most) {
    std::size_t count = 0;
    while (count < std::min(most, rest_.size()) && is_digit(rest_[count])) ++count;
    if (count < fewest) return std::nullopt;
    int value = 0;
    std::from_chars(rest_.data(), rest_.data() + count, value);
    rest_.remove_prefix(count);
    return value;
  }

  /// ".25" or ",25", 0 where there is none
  double fraction() {
    if (rest_.size() < 2 || !(rest_[0] == '.' || rest_[0] == ',') || !is_digit(rest_[1])) return 0.0;
    rest_.remove_prefix(1);
    double value = 0.0, weight = 0.1;
    for (; !rest_.empty() && is_digit(rest_[0]); rest_.remove_prefix(1), weight *= 0.1)
      value += weight * (rest_[0] - '0');
    return value;
  }

  bool skip(std::string_view any) {
    if (rest_.empty() || any.find(rest_[0]) == std::string_view::npos) return false;
    rest_.remove_prefix(1);
    return true;
  }

  void skip_blanks() {
    while (skip(" \t")) {}
  }

  std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
};

/// hh:mm:ss, 11:59:59 pm, after a date hhmmss too, with a fraction of the seconds or not
std::optional<double> take_time_of_day(Reader& reader, bool colons_needed) {
  const auto hours = reader.digits(1, 2);
  const bool colons = reader.skip(":");
  const auto minutes = hours ? reader.digits(2, 2) : std::nullopt;
  if (!minutes || reader.skip(":") != colons || (colons_needed && !colons)) return std::nullopt;
  const auto seconds = reader.digits(2, 2);
  if (!seconds || *hours > 23 || *minutes > 59 || *seconds > 60) return std::nullopt;
  const double time = *hours * 3600.0 + *minutes * 60.0 + *seconds + reader.fraction();
  constexpr double half_day = 43200.0;
  const auto half = lower_case(trimmed(reader.rest()).substr(0, 2));
  if (half == "pm" && *hours < 12) return time + half_day;
  if (half == "am" && *hours == 12) return time - half_day;
  return time;
}

/// 2020-09-14, 2020/09/14, 20200914 or 14.09.2020
std::optional<long> take_date(Reader& reader) {
  const Reader begin = reader;
  if (const auto year = reader.digits(4, 4)) {
    const bool separated = reader.skip("-/");
    const auto month = reader.digits(separated ? 1 : 2, 2);
    const auto day = month && reader.skip("-/") == separated ? reader.digits(separated ? 1 : 2, 2) : std::nullopt;
    if (day) return day_number(*year, *month, *day);
  }
  reader = begin;
  const auto day = reader.digits(1, 2);
  const auto month = day && reader.skip(".") ? reader.digits(1, 2) : std::nullopt;
  const auto year = month && reader.skip(".") ? reader.digits(4, 4) : std::nullopt;
  return year ? day_number(*year, *month, *day) : std::nullopt;
}

/// Z, +02:00, +0200 [s]; nothing where no zone is said.
std::optional<double> take_zone(Reader& reader) {
  if (reader.skip("Zz")) return 0.0;
  const bool east = !reader.rest().empty() && reader.rest()[0] == '+';
  if (!reader.skip("+-")) return std::nullopt;
  const auto hours = reader.digits(2, 2);
  if (!hours) return std::nullopt;
  reader.skip(":");
  const double offset = *hours * 3600.0 + reader.digits(2, 2).value_or(0) * 60.0;
  return east ? offset : -offset;
}

std::optional<TimeStamp> calendar_stamp(std::string_view text) {
  Reader reader(text);
  const Reader begin = reader;
  auto day = take_date(reader);
  if (!day || !reader.skip("T ,;\t_")) reader = begin, day.reset();
  reader.skip_blanks();
  const auto seconds = take_time_of_day(reader, !day);
  if (!seconds) return std::nullopt;
  const auto zone = take_zone(reader);
  if (!day) return TimeStamp{TimeStamp::Kind::time_of_day, *seconds, zone.has_value()};
  return TimeStamp{TimeStamp::Kind::instant, static_cast<double>(*day) * 86400.0 + *seconds - zone.value_or(0.0),
                   zone.has_value()};
}

/// Numbers of this size are seconds, milliseconds, microseconds since 1970, of the years 2001 to 2286; smaller ones
/// count from the beginning of the log.
std::optional<TimeStamp> counted_stamp(std::string_view text) {
  const auto end = text.find_first_of(",; \t");
  const auto number = number_in(text.substr(0, end));
  if (!number || *number < 0.0) return std::nullopt;
  for (const double unit : {1.0, 1e-3, 1e-6, 1e-9})
    if (const double seconds = *number * unit; seconds >= 1e9 && seconds < 1e10)
      return TimeStamp{TimeStamp::Kind::instant, seconds, true};
  if (*number >= 1e9) return std::nullopt;
  return TimeStamp{TimeStamp::Kind::elapsed, *number, true};
}

/// \s:r1,c:1600070401*hh\ with a right checksum
std::optional<TimeStamp> tag_block_stamp(std::string_view text) {
  const auto begin = text.find('\\');
  const auto end = begin == std::string_view::npos ? begin : text.find('\\', begin + 1);
  if (end == std::string_view::npos) return std::nullopt;
  auto block = text.substr(begin + 1, end - begin - 1);
  if (const auto star = block.rfind('*'); star != std::string_view::npos) {
    if (hexadecimal(block.substr(star + 1)) != nmea_checksum(block.substr(0, star))) return std::nullopt;
    block = block.substr(0, star);
  }
  while (!block.empty())
    if (const auto code = take(block, ','); code.starts_with("c:")) return counted_stamp(code.substr(2));
  return std::nullopt;
}

}  // namespace

std::optional<double> NmeaSentence::number(std::size_t i) const { return number_in(text(i)); }

unsigned char nmea_checksum(std::string_view text) {
  unsigned char sum = 0;
  for (const char c : text) sum = static_cast<unsigned char>(sum ^ static_cast<unsigned char>(c));
  return sum;
}

std::optional<unsigned char> hexadecimal(std::string_view digits) {
  unsigned char value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  if (digits.size() != 2 || error != std::errc{} || end != digits.data() + 2) return std::nullopt;
  return value;
}

SentenceState take_apart(std::string_view text, NmeaSentence& sentence) {
  auto body = trimmed(text.substr(1));
  const auto star = body.find('*');
  sentence.has_checksum = star != std::string_view::npos;
  if (sentence.has_checksum) {
    if (hexadecimal(body.substr(star + 1, 2)) != nmea_checksum(body.substr(0, star)))
      return SentenceState::wrong_checksum;
    body = body.substr(0, star);
  }
  sentence.field_count = 0;
  for (bool more = true; more && sentence.field_count < NmeaSentence::most_fields;) {
    more = body.find(',') != std::string_view::npos;
    sentence.fields[sentence.field_count++] = trimmed(take(body, ','));
  }
  sentence.address = sentence.fields[0];
  const bool is_address = sentence.address.size() >= 4 && sentence.address.size() <= 6 &&
                          std::ranges::all_of(sentence.address, is_capital_or_digit);
  return is_address && sentence.field_count > 1 ? SentenceState::good : SentenceState::not_a_sentence;
}

std::optional<TimeStamp> time_stamp_in(std::string_view text) {
  if (const auto tagged = tag_block_stamp(text)) return tagged;
  const auto plain = text.find_first_not_of(" \t[(\"'<");
  if (plain == std::string_view::npos) return std::nullopt;
  const auto stamp = text.substr(plain, text.find_first_of("])\"'>\\", plain) - plain);
  if (const auto calendar = calendar_stamp(stamp)) return calendar;
  return counted_stamp(stamp);
}

std::optional<double> nmea_time(std::string_view text) {
  Reader reader(text);
  const auto hours = reader.digits(2, 2), minutes = reader.digits(2, 2), seconds = reader.digits(2, 2);
  if (!hours || !minutes || !seconds || *hours > 23 || *minutes > 59 || *seconds > 60) return std::nullopt;
  return *hours * 3600.0 + *minutes * 60.0 + *seconds + reader.fraction();
}

std::optional<long> day_number(int year, int month, int day) {
  using namespace std::chrono;
  const year_month_day date{std::chrono::year{year}, std::chrono::month{static_cast<unsigned>(month)},
                            std::chrono::day{static_cast<unsigned>(day)}};
  if (!date.ok()) return std::nullopt;
  return sys_days{date}.time_since_epoch().count();
}

std::string utc_text(double seconds) {
  using namespace std::chrono;
  const sys_time<milliseconds> instant{milliseconds{std::llround(1000.0 * seconds)}};
  const auto date = floor<days>(instant);
  const year_month_day calendar{date};
  const hh_mm_ss clock{instant - date};
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:03}Z", static_cast<int>(calendar.year()),
                     static_cast<unsigned>(calendar.month()), static_cast<unsigned>(calendar.day()),
                     clock.hours().count(), clock.minutes().count(), clock.seconds().count(),
                     clock.subseconds().count());
}

}  // namespace swayaw::core::detail
