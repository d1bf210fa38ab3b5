#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nmea_quantities.hpp"
#include "nmea_sentence.hpp"

/// When each sentence of a log was written. Not installed.
namespace swayaw::inline core::detail {

/// Times of a log's sentences: by the stamps in front of its lines, else by the times in its sentences. A sentence
/// without either lies between its neighbours by their order.
class NmeaClock {
 public:
  /// A time in front of the sentence of that number; sentences count from 0.
  void stamp(std::size_t sentence, const TimeStamp& time);

  /// A time that a sentence tells.
  void told(std::size_t sentence, std::string_view address, const ToldTime& time);

  /// A quantity that came before with the same stamp.
  void repeated() { ++repeated_; }

  /// Decides. `begin` is where a log without dates goes on: the end of the file before.
  /// @return false if nothing tells the time
  bool settle(std::size_t sentences, std::optional<double> begin);

  /// Times of the first and the last sentence that has one [s]
  double begin() const;
  double end() const;

  /// Of a sentence [s]; NaN where the time in front of it was dropped.
  double time_of(std::size_t sentence) const;

  /// Of a sentence that tells its own time, which counts where the lines have no stamps [s]
  double time_of(std::size_t sentence, const ToldTime& own) const;

  /// What is added to these times to have seconds since 1970 UTC; nothing where no date is known.
  std::optional<double> to_utc() const { return to_utc_; }

  const std::vector<std::string>& notes() const { return notes_; }

 private:
  struct Mark {
    std::size_t sentence;
    double time;  ///< [s]
  };
  struct Source {
    std::string address;
    std::vector<Mark> marks = {};
    bool dated = true;
  };

  void settle_on_stamps(std::optional<double> begin);
  void settle_on_sentences(std::optional<double> begin);
  void find_date(const Source* utc, bool stamps_are_utc);
  void keep_increasing(std::vector<Mark>& marks, std::string_view what);
  void drop_far_ends(std::vector<Mark>& marks);
  void set_marks(const std::vector<Mark>& marks);
  const Source* best_source() const;

  std::vector<Mark> stamps_;
  std::array<std::size_t, 3> kinds_{};  ///< how many stamps of each kind
  std::vector<TimeStamp::Kind> stamp_kind_;
  bool zone_said_ = true;
  std::vector<Source> sources_;
  std::size_t repeated_ = 0;
  std::vector<std::size_t> dropped_;  ///< sentences whose time does not go on from the others
  std::vector<Mark> marks_;           ///< of distinct times
  bool spread_ = false;               ///< sentences between marks lie between them
  bool own_times_ = false;
  double usual_step_ = 0.0;      ///< between marks [s]
  double usual_sentence_ = 0.0;  ///< from sentence to sentence [s]
  std::optional<double> to_utc_;
  std::vector<std::string> notes_;
};

/// Which of the numbers make the longest sequence that does not decrease.
std::vector<std::size_t> longest_increasing(const std::vector<double>& values);

}  // namespace swayaw::core::detail
