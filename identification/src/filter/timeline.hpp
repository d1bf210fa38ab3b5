#pragma once

#include <algorithm>
#include <cmath>
#include <span>

/// When a filter looks at a ship. Not installed.
namespace swayaw::inline identification::detail {

/// The samples of a recording, and so many more before and after it, in its mean interval: a reading that is late shows
/// a time before the run, one that is early a time after it.
class Timeline {
 public:
  Timeline() = default;

  Timeline(std::span<const double> time, std::size_t before, std::size_t after)
      : time_(time), before_(before), after_(after) {
    if (time.size() > 1) interval_ = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
  }

  /// With room for readings of these delays [s]; no more than the run is long.
  static Timeline of(std::span<const double> time, double latest, double earliest) {
    const Timeline run(time, 0, 0);
    const auto within = [&](double delay) {
      const double count = std::ceil(std::max(0.0, delay) / run.interval_);
      return std::isfinite(count) ? static_cast<std::size_t>(std::min(count, static_cast<double>(time.size()))) : 0;
    };
    return {time, within(latest), within(-earliest)};
  }

  std::size_t before() const { return before_; }
  std::size_t after() const { return after_; }
  std::size_t size() const { return before_ + time_.size() + after_; }

  /// Seconds from the first to the beginning of the run.
  double lead() const { return static_cast<double>(before_) * interval_; }

  double operator[](std::size_t i) const {
    if (i < before_) return time_.front() - static_cast<double>(before_ - i) * interval_;
    i -= before_;
    if (i < time_.size()) return time_[i];
    return time_.back() + static_cast<double>(i + 1 - time_.size()) * interval_;
  }

  /// Whether there is a sample of the recording then.
  bool recorded(std::size_t i) const { return before_ <= i && i < before_ + time_.size(); }

  /// That sample; of a time before or after the run its first or last.
  std::size_t sample(std::size_t i) const { return std::min(i - std::min(i, before_), time_.size() - 1); }

  /// Nearest to a time.
  std::size_t nearest(double time) const {
    const auto after = std::ranges::lower_bound(time_, time);
    if (after == time_.begin() || after == time_.end()) {
      const double end = after == time_.begin() ? time_.front() : time_.back();
      const double steps = std::round((time - end) / interval_);
      const auto at_end = static_cast<double>(before_ + (after == time_.begin() ? 0 : time_.size() - 1));
      return std::isfinite(steps)
                 ? static_cast<std::size_t>(std::clamp(at_end + steps, 0.0, static_cast<double>(size() - 1)))
                 : before_;
    }
    const auto k = static_cast<std::size_t>(after - time_.begin());
    return before_ + (time - time_[k - 1] <= time_[k] - time ? k - 1 : k);
  }

 private:
  std::span<const double> time_;
  std::size_t before_ = 0, after_ = 0;
  double interval_ = 0.0;
};

}  // namespace swayaw::identification::detail
