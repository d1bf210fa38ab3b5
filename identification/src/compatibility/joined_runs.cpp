#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "swayaw/identification/data_compatibility.hpp"

namespace swayaw::inline identification {
namespace {

bool alike(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

/// A sample of a run.
struct Place {
  const Recording* run;
  std::size_t sample;
};

bool are_alike(const Place& a, const Place& b) {
  for (std::size_t c = 0; c < channel_count; ++c) {
    const auto &left = a.run->channels[c], &right = b.run->channels[c];
    if (!left.empty() && !right.empty() && !alike(left[a.sample], right[b.sample])) return false;
  }
  return true;
}

}  // namespace

std::optional<Recording> joined(std::span<const Recording> runs) {
  std::map<double, Place> samples;
  std::size_t shared = 0;
  for (const auto& run : runs)
    for (std::size_t i = 0; i < run.samples(); ++i) {
      const auto [known, is_new] = samples.try_emplace(run.time[i], Place{&run, i});
      if (is_new) continue;
      if (!are_alike(known->second, {&run, i})) return {};
      ++shared;
    }
  if (shared == 0) return {};
  Recording log{.name = "all runs on one clock"};
  for (const auto& [time, place] : samples) log.time.push_back(time);
  for (std::size_t c = 0; c < channel_count; ++c) {
    if (std::ranges::none_of(runs, [&](const Recording& run) { return !run.channels[c].empty(); })) continue;
    for (const auto& [time, place] : samples) {
      const auto& values = place.run->channels[c];
      log.channels[c].push_back(values.empty() ? missing : values[place.sample]);
    }
  }
  return log;
}

}  // namespace swayaw::identification
