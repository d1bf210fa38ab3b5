#include "rudder_holds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "swayaw/core/channel_table.hpp"

namespace swayaw::inline core::detail {
// ---------------------------------------------------------------- what is looked at

double Track::at(double t) const {
  const auto after = static_cast<std::size_t>(std::ranges::upper_bound(time, t) - time.begin());
  if (after == 0) return value.front();
  if (after == size()) return value.back();
  const double share = (t - time[after - 1]) / (time[after] - time[after - 1]);
  return value[after - 1] + share * (value[after] - value[after - 1]);
}

std::size_t Track::from(double t) const {
  return static_cast<std::size_t>(std::ranges::lower_bound(time, t) - time.begin());
}

double Track::mean(double begin, double end) const {
  const auto first = from(begin), last = from(end);
  double sum = 0.0;
  for (std::size_t i = first; i < last; ++i) sum += value[i];
  return last > first ? sum / static_cast<double>(last - first) : missing;
}

std::pair<double, double> Track::range(double begin, double end) const {
  const auto first = from(begin), last = from(end);
  if (first >= last) return {0.0, 0.0};
  const auto [low, high] = std::ranges::minmax(std::span(value).subspan(first, last - first));
  return {low, high};
}

Track track_of(const Recording& run, Channel channel, double unit) {
  Track track;
  const auto samples = run[channel];
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (std::isnan(samples[i])) continue;
    track.time.push_back(run.time[i]);
    track.value.push_back(samples[i] / unit);
  }
  return track;
}

Track heading_track(const Recording& run) {
  auto heading = track_of(run, Channel::psi, degree);
  for (std::size_t i = 1; i < heading.size(); ++i)
    heading.value[i] = heading.value[i - 1] + std::remainder(heading.value[i] - heading.value[i - 1], 360.0);
  return heading;
}

Track rudder_track(const Recording& run) {
  auto actual = track_of(run, Channel::delta, degree), order = track_of(run, Channel::delta_order, degree);
  if (actual.size() == 0) return order;
  if (2 * order.size() < actual.size()) return actual;
  constexpr double follows = 2.0;  // [deg] apart, for half of the time at least
  std::vector<double> apart;
  for (std::size_t i = 0; i < order.size(); ++i) apart.push_back(std::abs(order.value[i] - actual.at(order.time[i])));
  const auto [low, high] = std::ranges::minmax(order.value);
  const auto [lowest, highest] = std::ranges::minmax(actual.value);
  return median_of(std::move(apart)) <= follows && high - low >= 0.7 * (highest - lowest) ? order : actual;
}

Track speed_track(const Recording& run) {
  for (const Channel channel :
       {Channel::speed_through_water, Channel::u, Channel::speed_over_ground, Channel::u_ground})
    if (run.has(channel)) return track_of(run, channel, 1.0);
  return {};
}

Track smoothed(const Track& track) {
  constexpr std::size_t half = 3;
  Track result = track;
  std::array<double, 2 * half + 1> window{};
  for (std::size_t i = half; i + half < track.size(); ++i) {
    std::copy_n(track.value.begin() + static_cast<std::ptrdiff_t>(i - half), window.size(), window.begin());
    std::ranges::nth_element(window, window.begin() + half);
    result.value[i] = window[half];
  }
  return result;
}

// ---------------------------------------------------------------- the rudder held

namespace {

/// A helmsman holds an angle within a degree, an indicator rounds to one degree.
double tolerance_of(double level) { return std::clamp(0.2 * std::abs(level), 1.2, 2.5); }  // [deg]

}  // namespace

Hold hold_between(const Track& rudder, std::size_t begin, std::size_t end) {
  const std::span values(rudder.value.data() + begin, end - begin);
  const double level = median_of({values.begin(), values.end()});
  const auto at_level = [&](double value) { return std::abs(value - level) <= tolerance_of(level); };
  const auto flat = static_cast<double>(std::ranges::count_if(values, at_level)) / static_cast<double>(values.size());
  std::size_t from = begin, to = end - 1;
  while (from < to && !at_level(rudder.value[from])) ++from;
  while (to > from && !at_level(rudder.value[to])) --to;
  return {rudder.time[from], rudder.time[to], level, flat, rudder.time[begin], rudder.time[end - 1]};
}

std::vector<Hold> holds_beyond(const Track& rudder, double threshold) {
  std::vector<Hold> holds;
  std::size_t begin = 0;
  int side = 0;
  const auto close = [&](std::size_t end) {
    if (side != 0) holds.push_back(hold_between(rudder, begin, end));
  };
  for (std::size_t i = 0; i < rudder.size(); ++i) {
    const double value = rudder.value[i];
    const int now = value > threshold ? 1 : value < -threshold ? -1 : side * value > 0.5 * threshold ? side : 0;
    if (now == side) continue;
    close(i);
    begin = i;
    side = now;
  }
  close(rudder.size());
  return holds;
}

namespace {

/// Where p = a + b t through the samples i to j is 0, by least squares; nothing unless it rises.
std::optional<double> zero_of_line(std::span<const double> t, std::span<const double> p) {
  double t_mean = 0.0, p_mean = 0.0, tt = 0.0, tp = 0.0;
  const auto n = static_cast<double>(t.size());
  for (std::size_t i = 0; i < t.size(); ++i) t_mean += t[i] / n, p_mean += p[i] / n;
  for (std::size_t i = 0; i < t.size(); ++i) {
    tt += (t[i] - t_mean) * (t[i] - t_mean);
    tp += (t[i] - t_mean) * (p[i] - p_mean);
  }
  return tp > 0.0 ? std::optional(t_mean - p_mean * tt / tp) : std::nullopt;
}

}  // namespace

double start_of_change(const Track& rudder, double from_level, double to_level, double arrived) {
  const auto share = [&](std::size_t i) { return (rudder.value[i] - from_level) / (to_level - from_level); };
  std::size_t i = std::min(rudder.from(arrived), rudder.size() - 1);
  const auto back_to = [&](double part) {
    while (i > 0 && share(i) > part) --i;
    return i;
  };
  const auto crossing = [&](std::size_t k, double part) {
    if (k + 1 == rudder.size() || share(k) > part) return rudder.time[k];
    const double rise = share(k + 1) - share(k);
    const double step = rise > 0.0 ? std::clamp((part - share(k)) / rise, 0.0, 1.0) : 0.0;
    return rudder.time[k] + step * (rudder.time[k + 1] - rudder.time[k]);
  };
  const auto before_85 = back_to(0.85), before_70 = back_to(0.7), before_30 = back_to(0.3), before_15 = back_to(0.15);
  const double at_70 = crossing(before_70, 0.7), at_30 = crossing(before_30, 0.3);
  const double rough = std::max(at_30 - 0.75 * (at_70 - at_30), rudder.time.front());
  std::vector<double> times, shares;
  for (std::size_t k = before_15 + 1; k <= before_85; ++k) times.push_back(rudder.time[k]), shares.push_back(share(k));
  const auto fine = times.size() >= 3 ? zero_of_line(times, shares) : std::nullopt;
  const bool near = fine && std::abs(*fine - rough) <= 0.5 * (at_70 - at_30);
  return near ? std::max(*fine, rudder.time.front()) : rough;
}

}  // namespace swayaw::core::detail
