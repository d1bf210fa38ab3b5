#include "swayaw/core/recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "swayaw/core/refusal.hpp"

namespace swayaw {

bool Recording::has(Channel channel) const {
  return std::ranges::any_of((*this)[channel], [](double x) { return !std::isnan(x); });
}

std::span<double> Recording::fill(Channel channel) {
  auto& values = channels[index_of(channel)];
  if (values.empty()) values.assign(time.size(), missing);
  return values;
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

}  // namespace swayaw
