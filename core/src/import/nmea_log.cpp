#include "nmea_log.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "nmea_clock.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/detail/csv_text.hpp"
#include "swayaw/core/refusal.hpp"

namespace swayaw::inline core::detail {
namespace {

/// A number that a sentence told, before its time is known.
struct Reading {
  std::size_t sentence;
  std::size_t series;
  double first, second;
  std::optional<ToldTime> own;
  bool has_checksum;
};

class LogReader {
 public:
  explicit LogReader(const std::filesystem::path& file) : file_(file), text_(read_text(file)) {}

  NmeaLog read(std::optional<double> begin) {
    std::string_view rest = text_;
    while (!rest.empty()) read_line(take(rest, '\n'));
    if (log_.counts.sentences == 0) throw FileError({file_, 1, 1}, "no sentence of NMEA 0183 with a right checksum");
    if (!clock_.settle(log_.counts.sentences, begin))
      throw FileError({file_, 1, 1},
                      "no time: neither stamps in front of the lines nor sentences ZDA, RMC, GGA or GLL");
    drop_cut_sentences();
    place_in_time();
    return std::move(log_);
  }

 private:
  /// Sentences of a line; one that a line end broke in two is joined.
  void read_line(std::string_view line) {
    ++line_number_;
    line = trimmed(line);
    auto begin = line.find_first_of("$!");
    if (begin == std::string_view::npos) return read_continuation(line);
    broken_.clear();
    const auto stamp = time_stamp_in(line.substr(0, begin));
    while (begin != std::string_view::npos) {
      const auto end = line.find_first_of("$!", begin + 1);
      read_sentence(line.substr(begin, end == std::string_view::npos ? end : end - begin), stamp);
      begin = end;
    }
  }

  void read_continuation(std::string_view line) {
    if (line.empty()) return;
    NmeaSentence whole;
    const auto joined = broken_ + std::string(line);
    const bool fits = !broken_.empty() && take_apart(joined, whole) == SentenceState::good && whole.has_checksum;
    if (fits) {
      if (broken_readings_ < readings_.size()) readings_.resize(broken_readings_);
      read_good(whole, {});
    } else ++log_.counts.lines_without;
    broken_.clear();
  }

  void read_sentence(std::string_view text, const std::optional<TimeStamp>& stamp) {
    NmeaSentence sentence;
    switch (take_apart(text, sentence)) {
      case SentenceState::wrong_checksum: return log_.counts.wrong_checksum.add(line_number_);
      case SentenceState::not_a_sentence: return log_.counts.unreadable.add(line_number_);
      case SentenceState::good: break;
    }
    broken_readings_ = readings_.size();
    if (!sentence.has_checksum) broken_ = text;
    read_good(sentence, stamp);
  }

  void read_good(const NmeaSentence& sentence, const std::optional<TimeStamp>& stamp) {
    const auto number = log_.counts.sentences++;
    if (stamp) clock_.stamp(number, *stamp);
    const auto result = reading_.read(sentence);
    if (result == SentenceReading::Result::not_used) ++log_.counts.not_used[std::string(sentence.formatter())];
    if (result == SentenceReading::Result::invalid) ++log_.counts.invalid[std::string(sentence.address)];
    if (result == SentenceReading::Result::unreadable) log_.counts.unreadable.add(line_number_);
    if (reading_.time()) clock_.told(number, sentence.address, *reading_.time());
    for (const auto& told : reading_.told()) keep(told, sentence, number, stamp);
  }

  void keep(const Told& told, const NmeaSentence& sentence, std::size_t number, const std::optional<TimeStamp>& stamp) {
    const auto series = series_of(told, sentence.address);
    if (stamp && last_stamp_[series] == stamp->seconds) clock_.repeated();
    last_stamp_[series] = stamp ? stamp->seconds : missing;
    readings_.push_back({number, series, told.first, told.second, reading_.time(), sentence.has_checksum});
    lines_.push_back(line_number_);
  }

  std::size_t series_of(const Told& told, std::string_view address) {
    const auto same = [&](const NmeaSeries& s) {
      return s.quantity == told.quantity && s.directness == told.directness && s.which == told.which &&
             s.address == address;
    };
    const auto found = std::ranges::find_if(log_.series, same);
    if (found != log_.series.end()) return static_cast<std::size_t>(found - log_.series.begin());
    log_.series.push_back({std::string(address), told.quantity, told.directness, told.which});
    last_stamp_.push_back(missing);
    return log_.series.size() - 1;
  }

  /// A sentence without checksum is cut where most of its kind have one.
  void drop_cut_sentences() {
    std::vector<std::size_t> with(log_.series.size()), without(log_.series.size());
    for (const auto& reading : readings_) ++(reading.has_checksum ? with : without)[reading.series];
    for (std::size_t i = 0; i < readings_.size(); ++i) {
      auto& reading = readings_[i];
      if (reading.has_checksum) continue;
      if (with[reading.series] >= without[reading.series]) {
        log_.counts.cut.add(lines_[i]);
        reading.first = reading.second = missing;
      } else ++log_.counts.without_checksum[log_.series[reading.series].address];
    }
  }

  void place_in_time() {
    const double to_utc = clock_.to_utc().value_or(0.0);
    log_.dated = clock_.to_utc().has_value();
    log_.clock_notes = clock_.notes();
    log_.begin = clock_.begin() + to_utc;
    log_.end = clock_.end() + to_utc;
    for (const auto& reading : readings_) {
      if (std::isnan(reading.first) && std::isnan(reading.second)) continue;
      const double time =
          reading.own ? clock_.time_of(reading.sentence, *reading.own) : clock_.time_of(reading.sentence);
      if (!std::isnan(time))
        log_.series[reading.series].samples.push_back({time + to_utc, reading.first, reading.second});
    }
  }

  static constexpr double missing = std::numeric_limits<double>::quiet_NaN();

  std::filesystem::path file_;
  std::string text_;
  std::size_t line_number_ = 0;
  std::string broken_;               ///< a sentence without checksum, the last of its line
  std::size_t broken_readings_ = 0;  ///< how many there were before it
  SentenceReading reading_;
  NmeaClock clock_;
  std::vector<Reading> readings_;
  std::vector<std::size_t> lines_;  ///< of the readings
  std::vector<double> last_stamp_;  ///< of each series [s]
  NmeaLog log_;
};

}  // namespace

NmeaLog read_nmea_log(const std::filesystem::path& file, std::optional<double> begin) {
  return LogReader(file).read(begin);
}

}  // namespace swayaw::core::detail
