#include "channel_character.hpp"

#include <algorithm>
#include <cmath>

#include "run_motion.hpp"
#include "swayaw/core/detail/median.hpp"

namespace swayaw::inline identification::detail {
namespace {

/// Samples of a channel that are not missing, and where they stand in the run.
struct Samples {
  std::vector<double> time, value;
  std::vector<std::size_t> place;

  std::size_t size() const { return value.size(); }
};

Samples samples_of(const Recording& run, Channel channel) {
  Samples s;
  const auto values = run[channel];
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isnan(values[i])) continue;
    s.time.push_back(run.time[i]);
    s.value.push_back(values[i]);
    s.place.push_back(i);
  }
  return s;
}

/// A number near to a guess that all differences of values are multiples of, if there is one; else 0. A file holds
/// tenths of a degree in radians to six decimals, so the number is known the better the further values are apart.
/// @param values  distinct, ascending
double step_near(double step, std::span<const double> values) {
  constexpr double exact = 0.01;  // of a step: two numbers of six decimals are good to 6e-4 of a tenth of a degree
  // d = m step of neighbours, where m is small, then of all from the least on
  double products = 0.0, squares = 0.0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double difference = values[i] - values[i - 1], multiple = std::round(difference / step);
    products += multiple * difference, squares += multiple * multiple;
  }
  step = products / squares;
  products = squares = 0.0;
  for (const double x : values) {
    const double difference = x - values.front(), multiple = std::round(difference / step);
    if (std::abs(difference - multiple * step) > exact * step * std::max(1.0, 1e-4 * multiple)) return 0.0;
    products += multiple * difference, squares += multiple * multiple;
    if (squares > 0.0) step = products / squares;
  }
  return step;
}

/// The largest number that all differences of values are multiples of, if there is one: rounding. In a turn all samples
/// may be several steps apart.
double step_of(std::vector<double> values) {
  constexpr std::size_t enough = 2000, many = 20;  // distinct values
  constexpr int most = 8;                          // steps that the two nearest may be apart
  std::ranges::sort(values);
  const double range = values.back() - values.front();
  std::vector<double> distinct{values.front()};
  for (const double x : values)
    if (x - distinct.back() > 1e-9 * std::max(range, std::abs(x))) distinct.push_back(x);
  if (distinct.size() < 4) return 0.0;
  double least = HUGE_VAL;
  for (std::size_t i = 1; i < distinct.size(); ++i) least = std::min(least, distinct[i] - distinct[i - 1]);
  if (distinct.size() > enough) distinct.resize(enough);
  for (int apart = 1; apart <= (distinct.size() < many ? 1 : most); ++apart)
    if (const double step = step_near(least / apart, distinct); step > 0.0) return step;
  return 0.0;
}

/// How far a sample is off the straight line between two others.
double off_line(const Samples& s, std::size_t i, std::size_t from, std::size_t to) {
  const double share = (s.time[i] - s.time[from]) / (s.time[to] - s.time[from]);
  return s.value[i] - s.value[from] - share * (s.value[to] - s.value[from]);
}

/// How far each sample is off the straight line between its neighbours; 0 of the first and the last.
std::vector<double> bends_of(const Samples& s) {
  std::vector<double> bends(s.size(), 0.0);
  for (std::size_t i = 1; i + 1 < s.size(); ++i) bends[i] = off_line(s, i, i - 1, i + 1);
  return bends;
}

/// Samples that are no corner of the line through all: those that were interpolated between fixes. Where the line is
/// level nothing is told.
struct Line {
  std::vector<bool> corner;
  double share_between = 0.0;  ///< of the samples on a slope
  double sharpness = 0.0;      ///< how far the usual corner is off the line, over what counts as straight
};

Line line_of(const Samples& s, double step) {
  const auto bends = bends_of(s);
  // both neighbours and the sample are rounded: half a step, a quarter and a quarter
  const double straight = 1.01 * step + 1e-9 * rms(s.value);
  Line line{std::vector<bool>(s.size(), true)};
  std::size_t slopes = 0, between = 0;
  std::vector<double> corners;
  for (std::size_t i = 1; i + 1 < s.size(); ++i) {
    const bool on_slope = std::abs(s.value[i + 1] - s.value[i - 1]) > 6.0 * straight;
    line.corner[i] = !(on_slope && std::abs(bends[i]) <= straight);
    slopes += on_slope;
    between += on_slope && !line.corner[i];
    if (on_slope && line.corner[i]) corners.push_back(std::abs(bends[i]) / straight);
  }
  if (!corners.empty()) line.sharpness = core::detail::median_of(std::move(corners));
  if (slopes > 0) line.share_between = static_cast<double>(between) / static_cast<double>(slopes);
  return line;
}

/// How far off a line samples may be before they are outliers. Where most lie on one, as of a rudder that is held, what
/// the others are off is usual; with few of those nothing but the rounding is.
double limit_of(const Samples& s, const std::vector<double>& off, double step) {
  constexpr double far = 12.0;  // times the median: 8 standard deviations of normal noise
  constexpr std::size_t few = 10;
  const double flat = std::max(step, 1e-9 * rms(s.value));
  double usual = core::detail::median_size_of(off);
  if (usual <= flat) {
    std::vector<double> others;
    std::ranges::copy_if(off, std::back_inserter(others), [&](double x) { return std::abs(x) > flat; });
    usual = others.size() < few ? 0.0 : core::detail::median_size_of(others);
  }
  return std::max(far * usual, 3.0 * step);
}

/// Single samples far off the line through two neighbours on either side, compared with what is usual.
std::vector<std::size_t> outliers_of(const Samples& s, double step) {
  const auto bends = bends_of(s);
  const double limit = limit_of(s, bends, step);
  std::vector<std::size_t> found;
  for (std::size_t i = 2; i + 2 < s.size(); ++i) {
    // a spike bends the line by −½, 1, −½ of its height; a corner by less at its neighbours
    const bool spike = bends[i] * bends[i - 1] < 0.0 && bends[i] * bends[i + 1] < 0.0 &&
                       std::min(std::abs(bends[i - 1]), std::abs(bends[i + 1])) > 0.3 * std::abs(bends[i]);
    if (limit > 0.0 && spike && std::abs(bends[i]) > limit) found.push_back(s.place[i]);
  }
  return found;
}

/// Pairs of samples far off the line through two neighbours on either side: one wrong fix between them, where fixes
/// were interpolated to the times of the file. Beside a jump a neighbour is off the line as well.
std::vector<std::size_t> wrong_pairs_of(const Samples& s, double step) {
  constexpr double well = 0.3;  // of what the nearer is off, that neighbours may be off the line without the pair
  std::vector<double> first(s.size(), 0.0), second(s.size(), 0.0);
  for (std::size_t i = 2; i + 3 < s.size(); ++i)
    first[i] = off_line(s, i, i - 1, i + 2), second[i] = off_line(s, i + 1, i - 1, i + 2);
  const double limit = limit_of(s, first, step);
  const double usual = (s.time.back() - s.time.front()) / static_cast<double>(s.size() - 1);
  std::vector<std::size_t> found;
  for (std::size_t i = 2; i + 3 < s.size() && limit > 0.0; ++i) {
    if (s.time[i + 2] - s.time[i - 1] > 2.0 * 3.0 * usual) continue;  // across a gap the line tells nothing
    const double nearer = std::min(std::abs(first[i]), std::abs(second[i]));
    if (!(nearer > limit && first[i] * second[i] > 0.0) || (!found.empty() && found.back() >= s.place[i])) continue;
    const double before = off_line(s, i - 1, i - 2, i + 2), after = off_line(s, i + 2, i - 1, i + 3);
    if (std::max(std::abs(before), std::abs(after)) > well * nearer) continue;
    found.push_back(s.place[i]), found.push_back(s.place[i + 1]);
  }
  return found;
}

template <class Keep>
Samples those(const Samples& s, Keep&& keep) {
  Samples kept;
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (!keep(i)) continue;
    kept.time.push_back(s.time[i]);
    kept.value.push_back(s.value[i]);
    kept.place.push_back(s.place[i]);
  }
  return kept;
}

Samples fixes_of(const Samples& s, const Line& line) {
  return those(s, [&](std::size_t i) { return line.corner[i]; });
}

std::vector<std::size_t> either(const std::vector<std::size_t>& a, const std::vector<std::size_t>& b) {
  std::vector<std::size_t> all;
  std::ranges::set_union(a, b, std::back_inserter(all));
  return all;
}

bool has(const std::vector<std::size_t>& ascending, std::size_t i) { return std::ranges::binary_search(ascending, i); }

Samples without(const Samples& s, const std::vector<std::size_t>& places) {
  return those(s, [&](std::size_t i) { return !has(places, s.place[i]); });
}

/// Corners with the outliers and without: an outlier makes corners of its neighbours, a wrong fix that is left out of
/// the ends of the lines to it.
Samples fixes_without(const Samples& s, const std::vector<std::size_t>& outliers, const Samples& fixes, double step) {
  const auto rest = without(s, outliers);
  const auto corners = fixes_of(rest, line_of(rest, step));
  return those(corners, [&](std::size_t i) { return has(fixes.place, corners.place[i]); });
}

}  // namespace

ChannelCharacter character_of(const Recording& run, Channel channel) {
  constexpr double interpolated = 0.25;  // share on straight lines; smooth motion recorded in full digits has none
  constexpr double sharp = 8.0;          // noise alone puts a quarter of the samples on lines where its corners have 3
  const auto s = samples_of(run, channel);
  ChannelCharacter c{.channel = channel, .samples = s.size()};
  c.measured = s.place;
  if (s.size() < 5) return c;
  c.step = step_of(s.value);
  const auto line = line_of(s, c.step);
  c.interpolated = line.share_between > interpolated && line.sharpness > sharp;
  const auto fixes = c.interpolated ? fixes_of(s, line) : s;
  c.outliers = outliers_of(fixes, c.step);
  const bool is_position = channel == Channel::x || channel == Channel::y;
  if (is_position && !c.interpolated) c.outliers = either(c.outliers, wrong_pairs_of(s, c.step));
  const auto measured = c.interpolated ? fixes_without(s, c.outliers, fixes, c.step) : without(s, c.outliers);
  c.measured = measured.place;
  c.noise = white_noise_of(measured.value);
  c.interval = (s.time.back() - s.time.front()) / static_cast<double>(std::max<std::size_t>(measured.size(), 2) - 1);
  return c;
}

Recording measured_samples(Recording run, std::span<const ChannelCharacter> characters) {
  for (const auto& c : characters) {
    std::vector<double> measured(run.samples(), missing);
    for (const std::size_t i : c.measured) measured[i] = run[c.channel][i];
    run.channels[index_of(c.channel)] = std::move(measured);
  }
  return run;
}

}  // namespace swayaw::identification::detail

namespace swayaw::inline identification {

std::vector<std::size_t> measured_samples_of(const Recording& run, Channel channel) {
  return detail::character_of(run, channel).measured;
}

}  // namespace swayaw::identification
