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

/// The largest number that all differences of values are multiples of, if there is one: rounding.
double step_of(std::vector<double> values) {
  constexpr std::size_t enough = 2000;  // distinct values
  constexpr double exact = 1e-3;        // of a step; digits written by other programs are good to 1e-9 of a value
  std::ranges::sort(values);
  const double range = values.back() - values.front();
  std::vector<double> distinct{values.front()};
  for (const double x : values)
    if (x - distinct.back() > 1e-9 * std::max(range, std::abs(x))) distinct.push_back(x);
  if (distinct.size() < 4) return 0.0;
  double step = HUGE_VAL;
  for (std::size_t i = 1; i < distinct.size(); ++i) step = std::min(step, distinct[i] - distinct[i - 1]);
  if (distinct.size() > enough) distinct.resize(enough);
  for (const double x : distinct) {
    const double multiple = (x - distinct.front()) / step;
    if (std::abs(multiple - std::round(multiple)) > exact * std::max(1.0, 1e-4 * multiple)) return 0.0;
  }
  return step;
}

/// How far each sample is off the straight line between its neighbours; 0 of the first and the last.
std::vector<double> bends_of(const Samples& s) {
  std::vector<double> bends(s.size(), 0.0);
  for (std::size_t i = 1; i + 1 < s.size(); ++i) {
    const double share = (s.time[i] - s.time[i - 1]) / (s.time[i + 1] - s.time[i - 1]);
    bends[i] = s.value[i] - s.value[i - 1] - share * (s.value[i + 1] - s.value[i - 1]);
  }
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

/// Single samples far off the line through two neighbours on either side, compared with what is usual.
std::vector<std::size_t> outliers_of(const Samples& s, double step) {
  constexpr double far = 12.0;  // times the median: 8 standard deviations of normal noise
  const auto bends = bends_of(s);
  const double limit = std::max(far * core::detail::median_size_of(bends), 3.0 * step);
  std::vector<std::size_t> found;
  for (std::size_t i = 2; i + 2 < s.size(); ++i) {
    // a spike bends the line by −½, 1, −½ of its height; a corner by less at its neighbours
    const bool spike = bends[i] * bends[i - 1] < 0.0 && bends[i] * bends[i + 1] < 0.0 &&
                       std::min(std::abs(bends[i - 1]), std::abs(bends[i + 1])) > 0.3 * std::abs(bends[i]);
    if (limit > 0.0 && spike && std::abs(bends[i]) > limit) found.push_back(s.place[i]);
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
