#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "run_motion.hpp"
#include "track_regression.hpp"

namespace swayaw::inline identification::detail {
namespace {

using Usable = std::vector<bool>;

/// A run with its way by velocity.
struct Track {
  const Recording& run;
  const VelocitySource& source;
  DeadReckoning reckoned;
};

TrackFit fitted(const Track& track, ClockKind kind, const TrackFrom& from, const Usable& usable) {
  return settled(track.run, track.source, track.reckoned, kind, from, usable);
}

/// The simplest clock, unless others are far likelier: one that may run fast or walk takes away what the run tells of
/// speeds. A clock that jumps is not taken to keep time between its jumps.
TrackFit likeliest(const Track& track, const TrackFrom& from, const Usable& usable) {
  constexpr double far = 20.0;      // of deviance, for each number more, where 9 is 3 standard deviations
  constexpr double matters = 0.25;  // [s] in a minute: 0.4 % of a way
  constexpr double minute = 60.0;   // [s]
  const bool jumps = !from.clock.jumps.empty();
  auto simple = fitted(track, jumps ? ClockKind::steady : ClockKind::good, from, usable);
  auto wandering = fitted(track, ClockKind::wandering, from, usable);
  if (!jumps && wandering.fit.deviance < simple.fit.deviance - far) {
    auto steady = fitted(track, ClockKind::steady, from, usable);
    const bool runs_off = std::abs(steady.clock.rate) * minute > matters;
    if (runs_off && steady.fit.deviance < simple.fit.deviance - far) simple = std::move(steady);
  }
  const bool likelier = wandering.fit.deviance < simple.fit.deviance - 2.0 * far;
  const bool wanders = likelier && wandering.fit.errors.clock * std::sqrt(minute) > matters;
  return wanders ? wandering : simple;
}

// ---------------------------------------------------------------- where a clock jumps

/// A stretch of time.
struct Stretch {
  double from, to;
  double middle() const { return 0.5 * (from + to); }
};

/// Between the rows at which the search looks, but for the first and the last.
std::vector<Stretch> places_in(const TimeSeries& few) {
  constexpr std::size_t ends = 2;  // rows that tell where the track was before, and after
  std::vector<double> times = few.time;
  times.erase(std::unique(times.begin(), times.end()), times.end());
  std::vector<Stretch> places;
  for (std::size_t i = ends; i + ends < times.size(); ++i) places.push_back({times[i - 1], times[i]});
  return places;
}

struct Place {
  Stretch where;
  double gain;   ///< of deviance
  double doubt;  ///< the same that the likeliest of so many places takes by chance
};

/// The place at which a jump explains most.
std::optional<Place> likeliest_place(const TrackFit& track) {
  const auto few = thinned(track.series);
  const auto places = places_in(few);
  if (places.empty()) return {};
  RowMatrix Z(static_cast<Eigen::Index>(few.time.size()), static_cast<Eigen::Index>(places.size()));
  for (std::size_t k = 0; k < few.time.size(); ++k)
    for (std::size_t j = 0; j < places.size(); ++j)
      Z(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(j)) =
          few.time[k] > places[j].middle() ? -few.speed[k] : 0.0;
  Eigen::Index best = 0;
  const double gain = gains_of(few, track.prior, track.fit.errors, Z).maxCoeff(&best);
  return Place{places[static_cast<std::size_t>(best)], gain, 2.0 * std::log(static_cast<double>(places.size()))};
}

/// What is left of the fixes near a place, and the way by which a jump would move them.
struct Near {
  std::vector<double> time, left;
  std::vector<int> axis;
  std::vector<double> at;  ///< time − tau
};

Near fixes_near(const Track& track, const TrackFit& found, const Stretch& where, const Usable& usable) {
  const auto raw = rows_of(track.run, track.source, found.clock, track.reckoned, usable);
  Eigen::VectorXd beta = Eigen::VectorXd::Zero(raw.Xy.cols() - 1);
  beta.head(first_jump) = found.fit.beta.head(first_jump);
  beta[delay] = 0.0;  // it is in the clock
  if (found.kind != ClockKind::good) beta[drift] = 0.0;
  Near near;
  for (std::size_t k = 0; k < raw.time.size(); ++k) {
    if (raw.time[k] < where.from || raw.time[k] > where.to) continue;
    const auto row = raw.Xy.row(static_cast<Eigen::Index>(k));
    near.time.push_back(raw.time[k]);
    near.axis.push_back(raw.axis[k]);
    near.at.push_back(raw.time[k] - found.clock.late(raw.time[k]));
    near.left.push_back(row[beta.size()] - row.head(beta.size()).dot(beta));
  }
  return near;
}

/// What is left if the clock is late by `size` more:   left + I(at) − I(at − size);   missing where the way is not
/// known
std::vector<double> left_after(const Track& track, const Near& near, double size) {
  auto before = near.at;
  for (double& t : before) t -= size;
  const auto &time = track.run.time, &I_x = track.reckoned.I_x, &I_y = track.reckoned.I_y;
  const auto x = at_times(time, I_x, near.at), y = at_times(time, I_y, near.at);
  const auto x_then = at_times(time, I_x, before), y_then = at_times(time, I_y, before);
  auto left = near.left;
  for (std::size_t k = 0; k < left.size(); ++k) {
    left[k] += near.axis[k] == 0 ? x[k] - x_then[k] : y[k] - y_then[k];
    if (before[k] < time.front() || before[k] > time.back()) left[k] = missing;
  }
  return left;
}

/// Mean of each axis over a stretch, and the variance about it.
struct Level {
  std::array<double, 2> mean{};
  double variance = 0.0;
  bool known = false;
};

Level level_of(const Near& near, const std::vector<double>& left, const Stretch& in) {
  Level level;
  std::array<double, 2> n{}, squares{};
  for (std::size_t k = 0; k < left.size(); ++k) {
    if (std::isnan(left[k]) || near.time[k] < in.from || near.time[k] > in.to) continue;
    const auto axis = static_cast<std::size_t>(near.axis[k]);
    n[axis] += 1.0;
    level.mean[axis] += left[k];
    squares[axis] += left[k] * left[k];
  }
  level.known = n[0] > 0.0 && n[1] > 0.0;
  for (const std::size_t axis : {0U, 1U}) {
    level.mean[axis] /= std::max(n[axis], 1.0);
    squares[axis] -= n[axis] * level.mean[axis] * level.mean[axis];
  }
  level.variance = std::max((squares[0] + squares[1]) / std::max(n[0] + n[1] - 2.0, 1.0), 0.0);
  return level;
}

/// The place of a jump among the fixes around it, and its size, as a start of the fit.
class Jump {
 public:
  Jump(const Track& track, const TrackFit& found, const Stretch& where, const Usable& usable)
      : track_(track),
        width_(std::max(where.to - where.from, block_of(track.run))),
        before_{where.from - 3.0 * width_, where.from - 0.5 * width_},
        after_{where.to + 0.5 * width_, where.to + 3.0 * width_},
        near_(fixes_near(track, found, {before_.from, after_.to}, usable)) {}

  bool has_sides() const {
    return level_of(near_, near_.left, before_).known && level_of(near_, near_.left, after_).known;
  }

  /// For which the track goes on after the jump where it was before.
  double size() const {
    const double reach = 3.0 * InstrumentPriors{}.jump, step = std::max(0.5 * block_of(track_.run), 1e-3 * reach);
    const auto before = level_of(near_, near_.left, before_);
    double best = 0.0, least = HUGE_VAL;
    for (double size = -reach; size <= reach; size += step) {
      const auto after = level_of(near_, left_after(track_, near_, size), after_);
      if (!after.known) continue;
      const double off = std::hypot(after.mean[0] - before.mean[0], after.mean[1] - before.mean[1]);
      if (off < least) best = size, least = off;
    }
    return best;
  }

  /// Each boundary k between fixes by its likelihood:
  ///
  ///     −2 ln p(k) = Σ_{i ≤ k} (e_i − a)²/σ² + Σ_{i > k} (e_i(size) − b)²/σ²
  ///
  /// with the level a before, b after; between two fixes every time is alike.
  std::optional<ClockJump> placed(double size, double noise) const {
    const auto moved = left_after(track_, near_, size);
    const auto a = level_of(near_, near_.left, before_), b = level_of(near_, moved, after_);
    const double variance = std::max(0.5 * (a.variance + b.variance), noise * noise);
    std::vector<double> log_p;
    std::vector<Stretch> gaps;
    double sum = 0.0;
    for (std::size_t k = 0; k + 1 < moved.size(); ++k) {
      const auto axis = static_cast<std::size_t>(near_.axis[k]);
      if (!std::isnan(moved[k]))
        sum += 0.5 * (std::pow(moved[k] - b.mean[axis], 2) - std::pow(near_.left[k] - a.mean[axis], 2)) / variance;
      if (near_.time[k + 1] <= near_.time[k] || near_.time[k] < before_.to || near_.time[k + 1] > after_.from) continue;
      gaps.push_back({near_.time[k], near_.time[k + 1]});
      log_p.push_back(sum + std::log(gaps.back().to - gaps.back().from));
    }
    if (gaps.empty()) return {};
    return mean_of(gaps, log_p, size);
  }

 private:
  /// Mean and standard deviation of the time; a gap of width w adds w²/12.
  static ClockJump mean_of(const std::vector<Stretch>& gaps, const std::vector<double>& log_p, double size) {
    const double most = std::ranges::max(log_p), first = gaps.front().from;
    double all = 0.0, mean = 0.0, square = 0.0;
    for (std::size_t k = 0; k < gaps.size(); ++k) {
      const double p = std::exp(log_p[k] - most), t = gaps[k].middle() - first, width = gaps[k].to - gaps[k].from;
      all += p;
      mean += p * t;
      square += p * (t * t + width * width / 12.0);
    }
    mean /= all;
    return {first + mean, std::sqrt(std::max(square / all - mean * mean, 0.0)), size};
  }

  const Track& track_;
  double width_;
  Stretch before_, after_;
  Near near_;
};

/// The fit without its j-th jump, all else as it is.
TrackFit without_jump(TrackFit track, std::size_t j) {
  track.clock.jumps.erase(track.clock.jumps.begin() + static_cast<std::ptrdiff_t>(j));
  return track;
}

TrackClock with_jump(TrackClock clock, const ClockJump& jump) {
  clock.jumps.push_back(jump);
  std::ranges::sort(clock.jumps, {}, &ClockJump::at);
  return clock;
}

/// There and back within a few samples is an outlier, and twice to the same side one jump.
bool is_apart(const ClockJump& jump, const TrackClock& clock, double step) {
  constexpr double fewest = 5.0;  // samples that tell a level
  return std::ranges::none_of(clock.jumps,
                              [&](const ClockJump& other) { return std::abs(other.at - jump.at) < fewest * step; });
}

/// Whether the way is known at as many samples as a check needs at least: a jump of years leaves none.
bool is_enough(const Usable& usable) {
  return static_cast<std::size_t>(std::ranges::count(usable, true)) >= samples_for_check;
}

/// One more jump, placed twice: by the fit without it, and by that with it.
std::optional<TrackFit> with_jump_at(const Track& track, const TrackFit& found, const Stretch& where) {
  const auto& time = track.run.time;
  const auto usable = reckoned_on(found.clock, time);
  const Jump first(track, found, where, usable);
  if (!first.has_sides()) return {};
  const auto jump = first.placed(first.size(), found.fit.errors.white);
  const double step = usual_step(time);
  if (!jump || !is_apart(*jump, found.clock, step)) return {};
  const auto clock = with_jump(found.clock, *jump);
  const auto inside = reckoned_on(clock, time);
  if (!is_enough(inside)) return {};
  auto fit = likeliest(track, {clock, found.fit.errors}, inside);
  const auto j =
      static_cast<std::size_t>(std::ranges::find(fit.clock.jumps, jump->at, &ClockJump::at) - fit.clock.jumps.begin());
  const auto other = without_jump(fit, j);
  const Jump second(track, other, where, usable);
  const auto again = second.placed(fit.clock.jumps[j].size, fit.fit.errors.white);
  if (!again || !is_apart(*again, other.clock, step)) return fit;
  const auto settled_clock = with_jump(other.clock, *again);
  const auto inside_again = reckoned_on(settled_clock, time);
  if (!is_enough(inside_again)) return fit;
  return likeliest(track, {settled_clock, fit.fit.errors}, inside_again);
}

}  // namespace

TrackFit on_likeliest_clock(const Recording& run, const VelocitySource& source) {
  constexpr std::size_t most = 20;  // jumps
  constexpr std::size_t ahead = 1;  // jumps that need not pay alone: one there and one back hide each other
  constexpr double worth_a_fit = 6.0, evident = 20.0;  // of deviance, for each jump; 9 is 3 standard deviations
  const Track track{run, source, dead_reckoning(run, source)};
  const TrackClock none{.middle = 0.5 * (run.time.front() + run.time.back())};
  auto best = likeliest(track, {none, {}}, Usable(run.samples(), true)), trial = best;
  double cost = 0.0;  // of the jumps of the trial that the best has not
  while (trial.clock.jumps.size() < std::min(most, best.clock.jumps.size() + 1 + ahead)) {
    const auto place = likeliest_place(trial);
    if (!place || place->gain < place->doubt + worth_a_fit) break;
    auto next = with_jump_at(track, trial, place->where);
    if (!next) break;
    if (std::ranges::any_of(next->clock.jumps, [](const ClockJump& j) { return std::abs(j.size) < least_delay; }))
      break;
    trial = std::move(*next);
    cost += place->doubt + evident;
    const auto both = reckoned_on(trial.clock, run.time);
    const bool alike = both == reckoned_on(best.clock, run.time);
    const double before =
        alike ? best.fit.deviance : likeliest(track, {best.clock, best.fit.errors}, both).fit.deviance;
    if (trial.fit.deviance > before - cost) continue;
    best = trial;
    cost = 0.0;
  }
  return best;
}

}  // namespace swayaw::identification::detail
