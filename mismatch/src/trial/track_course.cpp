#include "track_course.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/detail/median.hpp"

namespace swayaw::inline mismatch::detail {
namespace {

/// Fixes while a heading was known.
std::vector<std::size_t> fixes_of(const Recording& run) {
  std::vector<std::size_t> fixes;
  for (const auto channel : {Channel::x, Channel::y, Channel::psi})
    if (!run.has(channel)) return fixes;
  const auto x = run[Channel::x], y = run[Channel::y];
  for (std::size_t i = 0; i < run.samples(); ++i)
    if (std::isfinite(x[i] + y[i])) fixes.push_back(i);
  return fixes;
}

/// Where she held her course.
struct Stretch {
  double course;  ///< of the track [rad]
  double off;     ///< heading less course [rad]
};

/// Of one run, each beginning amid the one before.
void add_stretches(const Recording& run, double time_unit, std::vector<Stretch>& stretches) {
  constexpr double steady = radians(3.0);
  const auto fixes = fixes_of(run);
  const auto after = [&](std::size_t from, double span) {
    const auto time = [&](std::size_t i) { return run.time[i]; };
    const auto first = std::ranges::lower_bound(fixes, run.time[fixes[from]] + span, {}, time);
    return static_cast<std::size_t>(first - fixes.begin());
  };
  if (fixes.empty()) return;
  // runs that were thinned tell positions at other times than headings
  const auto headings = Interpolant(run, Channel::psi);
  const auto psi = [&](std::size_t k) { return headings(run.time[fixes[k]]); };
  const auto x = run[Channel::x], y = run[Channel::y];
  for (std::size_t from = 0; from < fixes.size(); from = after(from, 0.5 * time_unit)) {
    const auto to = after(from, time_unit);
    if (to == fixes.size()) return;
    double low = psi(from), high = low, sum = 0.0;
    for (auto k = from; k <= to; ++k) {
      const double heading = psi(k);
      low = std::min(low, heading), high = std::max(high, heading), sum += heading;
    }
    const double north = x[fixes[to]] - x[fixes[from]], east = y[fixes[to]] - y[fixes[from]];
    if (!(high - low < steady) || !(std::hypot(north, east) > 0.0)) continue;
    const double course = std::atan2(east, north);
    stretches.push_back({course, wrapped(sum / static_cast<double>(to - from + 1) - course)});
  }
}

}  // namespace

std::optional<double> heading_off_track(std::span<const PreparedRun> runs, double time_unit) {
  constexpr double another_course = radians(60.0);
  std::vector<Stretch> stretches;
  for (const auto& run : runs) add_stretches(*run.run, time_unit, stretches);
  if (std::ranges::none_of(stretches, [&](const Stretch& s) {
        return std::abs(wrapped(s.course - stretches.front().course)) > another_course;
      }))
    return std::nullopt;
  std::vector<double> off;
  for (const auto& s : stretches) off.push_back(s.off);
  return core::detail::median_of(std::move(off));
}

}  // namespace swayaw::mismatch::detail
