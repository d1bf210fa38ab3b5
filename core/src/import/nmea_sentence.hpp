#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

/// Lines of a log taken apart into sentences. Not installed.
namespace swayaw::inline core::detail {

/// A sentence of NMEA 0183: $ttsss,field 1,field 2,...*hh
struct NmeaSentence {
  static constexpr std::size_t most_fields = 40;

  std::string_view address;                            ///< "HEHDT"
  std::array<std::string_view, most_fields> fields{};  ///< as the standard counts them, from 1; the address is 0
  std::size_t field_count = 0;                         ///< address included
  bool has_checksum = false;

  std::string_view talker() const { return address.substr(0, 2); }
  std::string_view formatter() const { return address.substr(2); }

  /// A field; empty where the sentence has no more.
  std::string_view text(std::size_t i) const { return i < field_count ? fields[i] : std::string_view{}; }

  /// The number in a field.
  std::optional<double> number(std::size_t i) const;
};

/// What was found where a sentence should be.
enum class SentenceState { good, wrong_checksum, not_a_sentence };

/// Takes a sentence apart that begins with '$' or '!' and ends before the next one or the end of the line.
SentenceState take_apart(std::string_view text, NmeaSentence& sentence);

/// Exclusive or of all characters.
unsigned char nmea_checksum(std::string_view text);

/// Value of two hexadecimal digits.
std::optional<unsigned char> hexadecimal(std::string_view digits);

/// A time in front of a sentence.
struct TimeStamp {
  enum class Kind { instant, time_of_day, elapsed };
  Kind kind;
  double seconds;  ///< since 1970 UTC, since midnight, or since the log began [s]
  bool zone_said = false;
};

/// The time in the text before a sentence: of a TAG block \c:1600070401*hh\, date and time, time of day, seconds,
/// milliseconds or microseconds since 1970, or seconds since the log began.
std::optional<TimeStamp> time_stamp_in(std::string_view text);

/// Seconds since midnight of "hhmmss.sss".
std::optional<double> nmea_time(std::string_view text);

/// Days since 1970 of a date; nothing for one that does not exist.
std::optional<long> day_number(int year, int month, int day);

/// "2020-09-14T08:00:01.230Z", of seconds since 1970
std::string utc_text(double seconds);

}  // namespace swayaw::core::detail
