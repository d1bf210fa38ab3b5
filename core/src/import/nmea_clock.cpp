#include "nmea_clock.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "swayaw/core/detail/median.hpp"

namespace swayaw::inline core::detail {
namespace {

constexpr double day = 86400.0;            // [s]
constexpr double quarter_of_hour = 900.0;  // zones lie that far apart [s]

/// The time that differs from `time` by whole days and lies nearest to `near`.
double on_day_near(double time, double near) { return time + day * std::round((near - time) / day); }

}  // namespace

std::vector<std::size_t> longest_increasing(const std::vector<double>& values) {
  // ends[k]: where the sequence of length k + 1 that ends lowest ends
  std::vector<std::size_t> ends, before(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto at =
        std::ranges::upper_bound(ends, values[i], {}, [&](std::size_t k) { return values[k]; }) - ends.begin();
    const auto length = static_cast<std::size_t>(at);
    before[i] = length > 0 ? ends[length - 1] : i;
    if (length == ends.size()) ends.push_back(i);
    else ends[length] = i;
  }
  std::vector<std::size_t> kept(ends.size());
  if (kept.empty()) return kept;
  kept.back() = ends.back();
  for (std::size_t k = kept.size() - 1; k > 0; --k) kept[k - 1] = before[kept[k]];
  return kept;
}

// ---------------------------------------------------------------- what comes in

void NmeaClock::stamp(std::size_t sentence, const TimeStamp& time) {
  stamps_.push_back({sentence, time.seconds});
  stamp_kind_.push_back(time.kind);
  ++kinds_[static_cast<std::size_t>(time.kind)];
  zone_said_ = zone_said_ && time.zone_said;
}

void NmeaClock::told(std::size_t sentence, std::string_view address, const ToldTime& time) {
  auto source = std::ranges::find(sources_, address, &Source::address);
  if (source == sources_.end()) source = sources_.insert(sources_.end(), Source{std::string(address)});
  const double seconds = time.seconds + day * static_cast<double>(time.day.value_or(0));
  const bool first = source->marks.empty();
  if (source->dated && !time.day && !first && source->marks.back().time > day)
    return;  // a date that is missing now and then
  source->dated = source->dated && time.day;
  source->marks.push_back(
      {sentence, source->dated || first ? seconds : on_day_near(seconds, source->marks.back().time)});
}

// ---------------------------------------------------------------- deciding

bool NmeaClock::settle(std::size_t sentences, std::optional<double> begin) {
  constexpr double enough = 0.5;  // of the sentences with a stamp: a log that was stamped lost some lines at most
  const bool stamped =
      !stamps_.empty() && static_cast<double>(stamps_.size()) >= enough * static_cast<double>(sentences);
  if (stamped) settle_on_stamps(begin);
  else settle_on_sentences(begin);
  return !marks_.empty();
}

void NmeaClock::settle_on_stamps(std::optional<double> begin) {
  using Kind = TimeStamp::Kind;
  const auto most = std::ranges::max_element(kinds_) - kinds_.begin();
  const auto kind = static_cast<Kind>(most);
  std::vector<Mark> marks;
  for (std::size_t i = 0; i < stamps_.size(); ++i)
    if (stamp_kind_[i] == kind) marks.push_back(stamps_[i]);
  if (kind == Kind::time_of_day)  // past midnight
    for (std::size_t i = 1; i < marks.size(); ++i) marks[i].time = on_day_near(marks[i].time, marks[i - 1].time);
  if (kind == Kind::time_of_day && begin && marks.front().time < *begin) {
    const double days = day * std::ceil((*begin - marks.front().time) / day);
    for (auto& mark : marks) mark.time += days;
  }
  keep_increasing(marks, "in front of lines");
  constexpr double now_and_then = 0.05;  // of the sentences: a stamp that many repeat is too coarse for them
  spread_ = static_cast<double>(repeated_) > now_and_then * static_cast<double>(stamps_.size());
  set_marks(marks);
  notes_.emplace_back(spread_
                          ? "clock: times in front of the lines; sentences with the same time lie apart by their order"
                          : "clock: times in front of the lines");
  find_date(best_source(), kind == Kind::instant && zone_said_);
  if (!to_utc_ && kind == Kind::instant) {
    to_utc_ = 0.0;
    notes_.emplace_back("no zone is said and no sentence tells UTC: the times in front of the lines are taken for UTC");
  }
}

void NmeaClock::settle_on_sentences(std::optional<double> begin) {
  const auto* source = best_source();
  if (source == nullptr) return;
  auto marks = source->marks;
  if (!source->dated && begin && marks.front().time < *begin) {
    const double days = day * std::ceil((*begin - marks.front().time) / day);
    for (auto& mark : marks) mark.time += days;
  }
  keep_increasing(marks, "in " + source->address);
  spread_ = own_times_ = true;
  set_marks(marks);
  notes_.push_back(fmt::format(
      "clock: UTC in {}; sentences without a time lie between by their order, which may be wrong by up to {} s",
      source->address, std::round(1000.0 * usual_step_) / 1000.0));
  if (source->dated) to_utc_ = 0.0;
  else notes_.emplace_back("no sentence tells the date (RMC, ZDA)");
}

/// Times in sentences: those with a date first, then the most frequent.
const NmeaClock::Source* NmeaClock::best_source() const {
  const auto worse = [](const Source& a, const Source& b) {
    return std::pair(a.dated, a.marks.size()) < std::pair(b.dated, b.marks.size());
  };
  const auto best = std::ranges::max_element(sources_, worse);
  return best == sources_.end() ? nullptr : &*best;
}

/// Stamps and UTC differ by the zone, which is whole quarters of an hour, and by what the log took to write.
void NmeaClock::find_date(const Source* utc, bool stamps_are_utc) {
  if (stamps_are_utc) to_utc_ = 0.0;
  if (utc == nullptr || (!utc->dated && !stamps_are_utc)) return;
  std::vector<double> differences;
  for (const auto& mark : utc->marks) {
    const double stamp = time_of(mark.sentence);
    if (std::isnan(stamp)) continue;
    differences.push_back((utc->dated ? mark.time : on_day_near(mark.time, stamp)) - stamp);
  }
  if (differences.empty()) return;
  const double difference = median_of(std::move(differences));
  const double zone = quarter_of_hour * std::round(difference / quarter_of_hour);
  const bool counted = kinds_[static_cast<std::size_t>(TimeStamp::Kind::elapsed)] * 2 > stamps_.size();
  if (!stamps_are_utc) to_utc_ = counted ? difference : zone;
  if (counted) return;
  const double ahead = difference - (stamps_are_utc ? 0.0 : zone);
  if (!stamps_are_utc && std::abs(zone) >= quarter_of_hour && std::abs(zone) < day)
    notes_.push_back(fmt::format("the times in front of the lines are UTC{:+.2f} h", -zone / 3600.0));
  notes_.push_back(fmt::format("UTC in {} is {:.3f} s {} the times in front of the lines (median)", utc->address,
                               std::abs(ahead), ahead < 0.0 ? "behind" : "ahead of"));
}

void NmeaClock::keep_increasing(std::vector<Mark>& marks, std::string_view what) {
  std::vector<double> times;
  times.reserve(marks.size());
  for (const auto& mark : marks) times.push_back(mark.time);
  const auto kept = longest_increasing(times);
  if (const auto dropped = marks.size() - kept.size(); dropped > 0)
    notes_.push_back(fmt::format("{} time{} {} that do{} not go on from the others dropped", dropped,
                                 dropped == 1 ? "" : "s", what, dropped == 1 ? "es" : ""));
  std::vector<Mark> result;
  result.reserve(kept.size());
  for (std::size_t i = 0, k = 0; i < marks.size(); ++i)
    if (k < kept.size() && kept[k] == i) result.push_back(marks[i]), ++k;
    else dropped_.push_back(marks[i].sentence);
  marks = std::move(result);
  drop_far_ends(marks);
}

/// The first or the last time alone, far from all others, is a damaged one.
void NmeaClock::drop_far_ends(std::vector<Mark>& marks) {
  constexpr double far = 3600.0;  // [s]
  const auto drop = [&](auto mark) {
    dropped_.push_back(mark->sentence);
    marks.erase(mark);
  };
  if (marks.size() > 2 && marks.back().time - marks[marks.size() - 2].time > far) drop(marks.end() - 1);
  if (marks.size() > 2 && marks[1].time - marks[0].time > far) drop(marks.begin());
  std::ranges::sort(dropped_);
}

/// The first sentence of each time.
void NmeaClock::set_marks(const std::vector<Mark>& marks) {
  for (const auto& mark : marks)
    if (marks_.empty() || mark.time > marks_.back().time) marks_.push_back(mark);
  if (marks_.size() < 2) return;
  std::vector<double> steps;
  for (std::size_t i = 1; i < marks_.size(); ++i) steps.push_back(marks_[i].time - marks_[i - 1].time);
  usual_step_ = median_of(steps);
  for (std::size_t i = 1; i < marks_.size(); ++i)
    steps[i - 1] /= static_cast<double>(marks_[i].sentence - marks_[i - 1].sentence);
  usual_sentence_ = median_of(std::move(steps));
}

// ---------------------------------------------------------------- answers

double NmeaClock::begin() const { return marks_.front().time; }

double NmeaClock::end() const { return marks_.back().time; }

double NmeaClock::time_of(std::size_t sentence) const {
  if (!own_times_ && std::ranges::binary_search(dropped_, sentence)) return std::nan("");
  const auto after = std::ranges::upper_bound(marks_, sentence, {}, &Mark::sentence);
  if (after == marks_.begin())
    return marks_.front().time - usual_sentence_ * static_cast<double>(marks_.front().sentence - sentence);
  const auto& mark = *(after - 1);
  const double past = static_cast<double>(sentence - mark.sentence);
  if (!spread_ || past == 0.0) return mark.time;
  if (after == marks_.end()) return mark.time + usual_sentence_ * past;
  // Sentences go on at their pace while no time is told; across a gap of the log they belong to what comes before it.
  const double sentences = static_cast<double>(after->sentence - mark.sentence);
  const double pace = 1.25 * std::max(usual_sentence_ * sentences, usual_step_);
  return mark.time + std::min(after->time - mark.time, pace) * past / sentences;
}

/// A time of its own counts if it lies between the marks about the sentence, or near them.
double NmeaClock::time_of(std::size_t sentence, const ToldTime& own) const {
  const double carried = time_of(sentence);
  if (!own_times_) return carried;
  const auto after = std::ranges::upper_bound(marks_, sentence, {}, &Mark::sentence);
  const double from = after == marks_.begin() ? carried : (after - 1)->time;
  const double to = after == marks_.end() ? carried : after->time;
  const double near = std::max(2.0 * usual_step_, 1.0);  // fixes of several receivers are that far apart
  const double told = on_day_near(own.seconds, carried);
  return told >= std::min(from, carried) - near && told <= std::max(to, carried) + near ? told : carried;
}

}  // namespace swayaw::core::detail
