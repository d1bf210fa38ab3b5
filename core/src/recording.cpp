#include "swayaw/core/recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "swayaw/core/detail/median.hpp"
#include "swayaw/core/detail/recording_rows.hpp"
#include "swayaw/core/refusal.hpp"

namespace swayaw::inline core {

bool Recording::has(Channel channel) const {
  return std::ranges::any_of((*this)[channel], [](double x) { return !std::isnan(x); });
}

Recording detail::rows_of(const Recording& run, std::size_t first, std::size_t end) {
  const auto part = [&]<class T>(const std::vector<T>& all) {
    if (all.empty()) return all;
    return std::vector<T>(all.begin() + static_cast<std::ptrdiff_t>(first),
                          all.begin() + static_cast<std::ptrdiff_t>(end));
  };
  Recording result{run.name, run.facts, part(run.time), {}, {}};
  for (std::size_t k = 0; k < channel_count; ++k) result.channels[k] = part(run.channels[k]);
  for (const auto& extra : run.extra) result.extra.push_back({extra.name, part(extra.cells)});
  return result;
}

std::span<double> Recording::fill(Channel channel) {
  auto& values = channels[index_of(channel)];
  if (values.empty()) values.assign(time.size(), missing);
  return values;
}

std::vector<Channel> recorded_channels(std::span<const Recording> runs, std::span<const Channel> among,
                                       std::span<const Channel> wanted) {
  std::vector<Channel> result;
  for (const Channel c : among)
    if ((wanted.empty() || std::ranges::count(wanted, c) > 0) &&
        std::ranges::any_of(runs, [c](const Recording& run) { return run.has(c); }))
      result.push_back(c);
  return result;
}

Interpolant::Interpolant(const Recording& recording, Channel channel) {
  const auto values = recording[channel];
  time_.reserve(values.size());
  value_.reserve(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isnan(values[i])) continue;
    time_.push_back(recording.time[i]);
    value_.push_back(values[i]);
  }
  if (time_.empty()) throw Refusal(fmt::format("{}: no sample of {}", recording.name, column_name(channel)));
}

double Interpolant::operator()(double time) const {
  const auto after = std::ranges::upper_bound(time_, time);
  if (after == time_.begin()) return value_.front();
  if (after == time_.end()) return value_.back();
  const auto k = static_cast<std::size_t>(after - time_.begin());
  const double share = (time - time_[k - 1]) / (time_[k] - time_[k - 1]);
  return value_[k - 1] + share * (value_[k] - value_[k - 1]);
}

double white_noise_of(std::span<const double> values) {
  constexpr std::size_t enough = 10;    // differences, fewer of which tell no median
  constexpr double quartile = 0.6745;   // of the normal distribution
  const double gain = std::sqrt(20.0);  // of white noise by third differences, √(1 + 9 + 9 + 1)
  std::vector<double> sizes;
  for (std::size_t i = 3; i < values.size(); ++i) {
    const double third = values[i] - 3.0 * values[i - 1] + 3.0 * values[i - 2] - values[i - 3];
    if (std::isfinite(third)) sizes.push_back(std::abs(third));
  }
  if (sizes.size() < enough) return 0.0;
  return detail::median_of(std::move(sizes)) / (quartile * gain);
}

}  // namespace swayaw::core
