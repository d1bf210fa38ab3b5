#include "track_regression.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "run_motion.hpp"

namespace swayaw::inline identification::detail {

double TrackClock::late(double t) const {
  double tau = delay + rate * (t - middle);
  for (const auto& jump : jumps)
    if (t > jump.at) tau += jump.size;
  return tau;
}

VelocitySource source_of(const Recording& run, Channel speed) {
  const bool ground = speed == Channel::u_ground;
  const Channel sway = ground ? Channel::v_ground : Channel::v;
  return {speed, sway, run.has(sway), !ground};
}

DeadReckoning dead_reckoning(const Recording& run, const VelocitySource& source) {
  const auto psi = filled(run, Channel::psi), u = filled(run, source.surge), r = yaw_rate(run);
  const auto v = source.has_sway ? filled(run, source.sway) : std::vector<double>(run.samples(), 0.0);
  const std::vector<double> room(run.samples());
  DeadReckoning d{room, room, room, room, room, room, room, room};
  for (std::size_t i = 0; i < run.samples(); ++i) {
    d.c[i] = std::cos(psi[i]);
    d.s[i] = std::sin(psi[i]);
    d.V_x[i] = u[i] * d.c[i] - v[i] * d.s[i];
    d.V_y[i] = u[i] * d.s[i] + v[i] * d.c[i];
    d.H_x[i] = -r[i] * d.V_y[i];
    d.H_y[i] = r[i] * d.V_x[i];
  }
  d.I_x = integral(run.time, d.V_x);
  d.I_y = integral(run.time, d.V_y);
  d.H_x = integral(run.time, d.H_x);
  d.H_y = integral(run.time, d.H_y);
  return d;
}

double usual_speed(const DeadReckoning& d) { return std::hypot(rms(d.V_x), rms(d.V_y)); }

DeadReckoning seen_on(const TrackClock& clock, const std::vector<double>& time, const DeadReckoning& d) {
  std::vector<double> at(time.size());
  for (std::size_t i = 0; i < time.size(); ++i) at[i] = time[i] - clock.late(time[i]);
  const auto late = [&](const std::vector<double>& f) { return at_times(time, f, at); };
  return {late(d.V_x), late(d.V_y), late(d.I_x), late(d.I_y), late(d.H_x), late(d.H_y), late(d.c), late(d.s)};
}

std::vector<bool> reckoned_on(const TrackClock& clock, const std::vector<double>& time) {
  std::vector<bool> inside(time.size(), true);
  if (clock.jumps.empty()) return inside;  // a delay alone is short: the way is drawn on beyond its ends
  for (std::size_t i = 0; i < time.size(); ++i) {
    const double at = time[i] - clock.late(time[i]);
    inside[i] = at >= time.front() && at <= time.back();
  }
  return inside;
}

namespace {

/// A measured coordinate.
struct Fix {
  std::size_t sample;
  bool north;
};

std::vector<Fix> fixes_of(const Recording& run, const std::vector<bool>& usable) {
  std::vector<Fix> fixes;
  for (std::size_t i = 0; i < run.samples(); ++i)
    for (const bool north : {true, false})
      if (usable[i] && !std::isnan(run[north ? Channel::x : Channel::y][i])) fixes.push_back({i, north});
  return fixes;
}

double first_of(std::span<const double> values) { return values[present(values).front()]; }

/// One row: the columns of the errors and p − I − p_0.
template <class Row>
void fill(Row row, const Recording& run, const TrackClock& clock, const DeadReckoning& d, const Fix& fix, double p_0) {
  const auto [i, north] = fix;
  const double V = north ? d.V_x[i] : d.V_y[i];
  row[scale] = north ? d.I_x[i] : d.I_y[i];
  row[axes] = north ? -d.I_y[i] : d.I_x[i];
  row[delay] = -V;
  row[drift] = -V * (run.time[i] - clock.middle);
  row[heading_delay] = north ? d.H_x[i] : d.H_y[i];
  row[lever_x] = north ? d.c[i] - d.c[0] : d.s[i] - d.s[0];
  row[lever_y] = north ? d.s[0] - d.s[i] : d.c[i] - d.c[0];
  row[north ? current_x : current_y] = run.time[i] - run.time[0];
  row[north ? start_x : start_y] = 1.0;
  Eigen::Index at = first_jump;
  for (const auto& jump : clock.jumps) row[at++] = run.time[i] > jump.at ? -V : 0.0;
  row[at] = run[north ? Channel::x : Channel::y][i] - p_0 - (north ? d.I_x[i] : d.I_y[i]);
}

/// Means of the rows of each axis over blocks of time: what waves do to a ship within one is left out.
TimeSeries block_means(const TimeSeries& s, double block) {
  struct Block {
    std::size_t rows = 0;
    double time = 0.0, speed = 0.0, bridge = 0.0;
    Eigen::RowVectorXd Xy;
  };
  std::map<double, std::array<Block, 2>> blocks;  // by place; those of a gap are not there
  for (std::size_t k = 0; k < s.time.size(); ++k) {
    const double place = std::floor((s.time[k] - s.time[0]) / block);
    auto& b = blocks[place][static_cast<std::size_t>(s.axis[k])];
    if (b.rows++ == 0) b.Xy = Eigen::RowVectorXd::Zero(s.Xy.cols());
    b.time += s.time[k];
    b.speed += s.speed[k];
    b.bridge = std::hypot(b.bridge, s.bridge[k]);
    b.Xy += s.Xy.row(static_cast<Eigen::Index>(k));
  }
  std::size_t filled = 0;
  for (const auto& [place, both] : blocks) filled += (both[0].rows > 0) + (both[1].rows > 0);
  TimeSeries means(filled, s.Xy.cols());
  std::size_t i = 0;
  for (const auto& [place, both] : blocks)
    for (const int axis : {0, 1}) {
      const auto& b = both[static_cast<std::size_t>(axis)];
      if (b.rows == 0) continue;
      const auto n = static_cast<double>(b.rows);
      means.time[i] = std::max(b.time / n, i > 0 ? means.time[i - 1] : b.time / n);
      means.axis[i] = axis;
      means.speed[i] = b.speed / n;
      means.bridge[i] = b.bridge;
      means.Xy.row(static_cast<Eigen::Index>(i++)) = b.Xy / n;
    }
  return means;
}

Eigen::VectorXd priors(const Recording& run, const VelocitySource& source, const DeadReckoning& d, ClockKind kind,
                       std::size_t jumps) {
  const InstrumentPriors p;
  const double U = usual_speed(d), radius = U / std::max(rms(yaw_rate(run)), 1e-4);
  // of a velocity over ground a current is an error of its zero
  const double current = source.through_water ? p.current * U : 1e-3 * U, place = 10.0 * U;
  const auto known = [&](double prior) { return source.has_sway ? prior : not_asked; };
  const double clock_drift = kind == ClockKind::good ? p.good_clock : p.drift;
  Eigen::VectorXd all(first_jump + static_cast<Eigen::Index>(jumps));
  all.setConstant(p.jump);
  all.head(first_jump) << p.scale, p.axes, known(p.delay), clock_drift, known(p.delay), p.lever * radius,
      known(p.lever * radius), current, current, place, place;
  return all;
}

/// Of a receiver with a memory of a minute; of velocities whose errors add up.
std::vector<ErrorModel> of_good_clocks(const Recording& run, double U) {
  const double white = std::max(white_noise_of(run[Channel::x]), 1e-5 * U);
  constexpr double jitter = 0.01;  // [s]
  return {{.white = white, .markov = 3.0 * white, .memory = 60.0, .walk = 1e-3 * U, .jitter = jitter},
          {.white = white, .markov = 0.1 * white, .memory = 60.0, .walk = 0.02 * U, .jitter = jitter}};
}

/// The same, and a clock that wanders by 0.1 s in a second.
std::vector<ErrorModel> of_bad_clocks(const Recording& run, double U) {
  auto guesses = of_good_clocks(run, U);
  for (auto& guess : guesses) guess.clock = guess.jitter = 0.1;
  return guesses;
}

/// And those of a fit that was close.
std::vector<ErrorModel> guesses_of(const Recording& run, double U, ClockKind kind,
                                   const std::optional<ErrorModel>& close) {
  auto guesses = kind == ClockKind::wandering ? of_bad_clocks(run, U) : of_good_clocks(run, U);
  if (!close) return guesses;
  guesses.push_back(*close);
  if (kind != ClockKind::wandering) guesses.back().clock = 0.0;
  else if (close->clock == 0.0) guesses.back().clock = guesses.front().clock;
  return guesses;
}

/// A number of the clock and its column.
template <class F>
void for_each_number(TrackClock& clock, ClockKind kind, F&& f) {
  f(clock.delay, delay);
  if (kind != ClockKind::good) f(clock.rate, drift);
  for (std::size_t j = 0; j < clock.jumps.size(); ++j)
    f(clock.jumps[j].size, first_jump + static_cast<Eigen::Index>(j));
}

/// Rows whose beta is the whole of each number of the clock, on which the prior is, and not its next step.
TimeSeries with_clock(TimeSeries series, TrackClock& clock, ClockKind kind) {
  auto& Xy = series.Xy;
  for_each_number(clock, kind, [&](double value, Eigen::Index at) { Xy.rightCols(1) += value * Xy.col(at); });
  return series;
}

/// The clock after a step of the fit, and whether the step was a large one.
bool moved(TrackClock& clock, ClockKind kind, const ColouredFit& fit) {
  constexpr double little = 0.1;  // standard errors
  bool far = false;
  for_each_number(clock, kind, [&](double& value, Eigen::Index at) {
    far |= std::abs(fit.beta[at] - value) > little * std::sqrt(fit.covariance(at, at));
    value = fit.beta[at];
  });
  return far;
}

}  // namespace

TimeSeries rows_of(const Recording& run, const VelocitySource& source, const TrackClock& clock,
                   const DeadReckoning& reckoned, const std::vector<bool>& usable) {
  constexpr double lost = 0.1;  // share of the speed that a straight line across a gap is wrong by
  const auto d = seen_on(clock, run.time, reckoned);
  const auto fixes = fixes_of(run, usable);
  const auto gaps = gaps_of(run, source.surge);
  const double x_0 = first_of(run[Channel::x]), y_0 = first_of(run[Channel::y]), U = usual_speed(d);
  const double noise = white_noise_of(run[source.surge]);
  TimeSeries s(fixes.size(), first_jump + static_cast<Eigen::Index>(clock.jumps.size()) + 1);
  for (std::size_t k = 0, i = 0; k < fixes.size(); ++k) {
    const auto& [sample, north] = fixes[k];
    for (; i <= sample; ++i)
      s.bridge[k] = std::hypot(s.bridge[k], lost * U * gaps[i], noise * step_before(run.time, i));
    s.time[k] = run.time[sample];
    s.axis[k] = north ? 0 : 1;
    s.speed[k] = north ? d.V_x[sample] : d.V_y[sample];
    fill(s.Xy.row(static_cast<Eigen::Index>(k)), run, clock, d, fixes[k], north ? x_0 : y_0);
  }
  return s;
}

double block_of(const Recording& run) {
  constexpr double little = 0.1;  // [rad]
  const double step = usual_step(run.time), longest = (run.time.back() - run.time.front()) / 60.0;
  return std::clamp(little / hard_yaw_rate(run), step, std::max(longest, step));
}

TrackFit settled(const Recording& run, const VelocitySource& source, const DeadReckoning& reckoned, ClockKind kind,
                 const TrackFrom& from, const std::vector<bool>& usable) {
  constexpr int most = 6;  // iterates; Gauss and Newton's method on a delay that is small beside the turns needs two
  const auto prior = priors(run, source, reckoned, kind, from.clock.jumps.size());
  const double U = usual_speed(reckoned), block = block_of(run);
  const auto guesses = guesses_of(run, U, kind, from.errors);
  auto starts = guesses;
  TrackFit found{{}, from.clock, kind, {0, 0}, prior};
  for (int iterate = 0; iterate < most; ++iterate) {
    auto rows = block_means(rows_of(run, source, found.clock, reckoned, usable), block);
    found.series = with_clock(std::move(rows), found.clock, kind);
    found.fit = coloured_regression(found.series, prior, starts);
    // the errors of an iterate whose jumps are far off are no start for the next
    starts = from.clock.jumps.empty() ? std::vector<ErrorModel>{} : guesses;
    starts.push_back(found.fit.errors);
    if (!moved(found.clock, kind, found.fit)) break;
  }
  return found;
}

}  // namespace swayaw::identification::detail
