#include <algorithm>
#include <array>
#include <cmath>

#include "coloured_regression.hpp"
#include "relations.hpp"
#include "run_motion.hpp"
#include "swayaw/core/detail/matrices.hpp"

namespace swayaw::inline identification::detail {
namespace {

enum Column : Eigen::Index {
  scale,
  axes,
  delay,
  drift,
  heading_delay,
  lever_x,
  lever_y,
  current_x,
  current_y,
  start_x,
  start_y,
  columns
};

/// Velocity over the earth as the instruments have it, and the way by it.
struct DeadReckoning {
  std::vector<double> V_x, V_y, I_x, I_y;
  std::vector<double> H_x, H_y;  ///< ∫ r (−V_y, V_x) dt
  std::vector<double> c, s;      ///< of the heading
};

struct Source {
  Channel surge;
  Channel sway;
  bool has_sway;
  bool through_water;
};

Source source_of(const Recording& run, Channel speed) {
  const bool ground = speed == Channel::u_ground;
  const Channel sway = ground ? Channel::v_ground : Channel::v;
  return {speed, sway, run.has(sway), !ground};
}

DeadReckoning dead_reckoning(const Recording& run, const Source& source) {
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

/// The same as positions late by `delay` show it.
DeadReckoning seen_late(const std::vector<double>& time, const DeadReckoning& d, double delay) {
  if (delay == 0.0) return d;
  const auto late = [&](const std::vector<double>& f) { return delayed(time, f, delay); };
  return {late(d.V_x), late(d.V_y), late(d.I_x), late(d.I_y), late(d.H_x), late(d.H_y), late(d.c), late(d.s)};
}

double usual_speed(const DeadReckoning& d) { return std::hypot(rms(d.V_x), rms(d.V_y)); }

/// A measured coordinate.
struct Fix {
  std::size_t sample;
  bool north;
};

std::vector<Fix> fixes_of(const Recording& run) {
  std::vector<Fix> fixes;
  for (std::size_t i = 0; i < run.samples(); ++i)
    for (const bool north : {true, false})
      if (!std::isnan(run[north ? Channel::x : Channel::y][i])) fixes.push_back({i, north});
  return fixes;
}

double first_of(std::span<const double> values) { return values[present(values).front()]; }

/// One row: the columns of the errors and p − I − p_0.
template <class Row>
void fill(Row row, const Recording& run, const DeadReckoning& d, const Fix& fix, double p_0) {
  const auto [i, north] = fix;
  const double middle = 0.5 * (run.time.front() + run.time.back());
  const double V = north ? d.V_x[i] : d.V_y[i];
  row[scale] = north ? d.I_x[i] : d.I_y[i];
  row[axes] = north ? -d.I_y[i] : d.I_x[i];
  row[delay] = -V;
  row[drift] = -V * (run.time[i] - middle);
  row[heading_delay] = north ? d.H_x[i] : d.H_y[i];
  row[lever_x] = north ? d.c[i] - d.c[0] : d.s[i] - d.s[0];
  row[lever_y] = north ? d.s[0] - d.s[i] : d.c[i] - d.c[0];
  row[north ? current_x : current_y] = run.time[i] - run.time[0];
  row[north ? start_x : start_y] = 1.0;
  row[columns] = run[north ? Channel::x : Channel::y][i] - p_0 - (north ? d.I_x[i] : d.I_y[i]);
}

/// Rows of x and y, in time.
TimeSeries rows_of(const Recording& run, const Source& source, const DeadReckoning& d) {
  constexpr double lost = 0.1;  // share of the speed that a straight line across a gap is wrong by
  const auto fixes = fixes_of(run);
  const auto gaps = gaps_of(run, source.surge);
  const double x_0 = first_of(run[Channel::x]), y_0 = first_of(run[Channel::y]), U = usual_speed(d);
  const double noise = white_noise_of(run[source.surge]);
  TimeSeries s(fixes.size(), columns + 1);
  for (std::size_t k = 0, i = 0; k < fixes.size(); ++k) {
    const auto& [sample, north] = fixes[k];
    for (; i <= sample; ++i)
      s.bridge[k] = std::hypot(s.bridge[k], lost * U * gaps[i], noise * step_before(run.time, i));
    s.time[k] = run.time[sample];
    s.axis[k] = north ? 0 : 1;
    s.speed[k] = north ? d.V_x[sample] : d.V_y[sample];
    fill(s.Xy.row(static_cast<Eigen::Index>(k)), run, d, fixes[k], north ? x_0 : y_0);
  }
  return s;
}

/// Means of the rows of each axis over blocks of time: what waves do to a ship within one is left out.
TimeSeries block_means(const TimeSeries& s, double block) {
  struct Block {
    std::size_t rows = 0;
    double time = 0.0, speed = 0.0, bridge = 0.0;
    Eigen::RowVectorXd Xy;
  };
  std::vector<std::array<Block, 2>> blocks;
  for (std::size_t k = 0; k < s.time.size(); ++k) {
    const auto place = static_cast<std::size_t>((s.time[k] - s.time[0]) / block);
    if (blocks.size() <= place) blocks.resize(place + 1);
    auto& b = blocks[place][static_cast<std::size_t>(s.axis[k])];
    if (b.rows++ == 0) b.Xy = Eigen::RowVectorXd::Zero(s.Xy.cols());
    b.time += s.time[k];
    b.speed += s.speed[k];
    b.bridge = std::hypot(b.bridge, s.bridge[k]);
    b.Xy += s.Xy.row(static_cast<Eigen::Index>(k));
  }
  std::size_t filled = 0;
  for (const auto& both : blocks) filled += (both[0].rows > 0) + (both[1].rows > 0);
  TimeSeries means(filled, s.Xy.cols());
  std::size_t i = 0;
  for (const auto& both : blocks)
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

/// In which a ship turns by a tenth of a radian when she turns hard: a manoeuvre is slower, waves are not [s].
double block_of(const Recording& run) {
  constexpr double little = 0.1;  // [rad]
  const double step = usual_step(run.time), longest = (run.time.back() - run.time.front()) / 60.0;
  return std::clamp(little / hard_yaw_rate(run), step, std::max(longest, step));
}

/// @param clock_drift  [s/s]
Eigen::VectorXd priors(const Recording& run, const Source& source, const DeadReckoning& d, double clock_drift) {
  const InstrumentPriors p;
  const double U = usual_speed(d), radius = U / std::max(rms(yaw_rate(run)), 1e-4);
  // of a velocity over ground a current is an error of its zero
  const double current = source.through_water ? p.current * U : 1e-3 * U, place = 10.0 * U;
  const auto known = [&](double prior) { return source.has_sway ? prior : not_asked; };
  return Eigen::Vector<double, columns>{
      p.scale, p.axes,  known(p.delay), clock_drift, known(p.delay), p.lever * radius, known(p.lever * radius),
      current, current, place,          place};
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

/// A fit with the delay at which it settled.
struct TrackFit {
  ColouredFit fit;
  double delay;
  bool bad_clock = false;
};

/// Gauss–Newton in the delay, the one error that bends the columns of the others.
TrackFit settled(const Recording& run, const Source& source, const DeadReckoning& reckoned,
                 const Eigen::VectorXd& prior, std::vector<ErrorModel> starts) {
  constexpr double little = 0.1;  // standard errors
  TrackFit found{{}, 0.0};
  for (int iterate = 0; iterate < 4; ++iterate) {
    const auto series = block_means(rows_of(run, source, seen_late(run.time, reckoned, found.delay)), block_of(run));
    found.fit = coloured_regression(series, prior, starts);
    starts = {found.fit.errors};
    if (std::abs(found.fit.beta[delay]) < little * std::sqrt(found.fit.covariance(delay, delay))) break;
    found.delay += found.fit.beta[delay];
  }
  return found;
}

constexpr double minute = 60.0;

/// With good clocks, unless bad ones are far likelier: a clock that may wander takes away what the run tells of speeds.
TrackFit settled(const Recording& run, const Source& source) {
  constexpr double far = 40.0;      // of deviance, for two numbers: 20 each, where 9 is 3 standard deviations
  constexpr double matters = 0.25;  // [s] in a minute: 0.4 % of a way
  const InstrumentPriors p;
  const auto reckoned = dead_reckoning(run, source);
  const double U = usual_speed(reckoned);
  const auto good = settled(run, source, reckoned, priors(run, source, reckoned, p.good_clock), of_good_clocks(run, U));
  const auto bad = settled(run, source, reckoned, priors(run, source, reckoned, p.drift), of_bad_clocks(run, U));
  const bool likelier = bad.fit.deviance < good.fit.deviance - far;
  if (!likelier || bad.fit.errors.clock * std::sqrt(minute) < matters) return good;
  return {bad.fit, bad.delay, true};
}

/// The clocks of positions, heading and velocities from how late positions and heading are against velocities: one
/// alone where that explains both,   late = tau e,  e = (1, 0), (0, 1) or (−1, −1), else positions and heading.
std::vector<InstrumentError> delays_of(Channel speed, const Eigen::Vector2d& late, const Eigen::Matrix2d& C) {
  constexpr double explained = 9.0;  // chi-squared of what is left: 3 standard deviations
  const Eigen::Matrix2d information = core::detail::inverse(C);
  const auto by = [&](Channel channel, const Eigen::Vector2d& e) {
    const double weight = e.dot(information * e), tau = e.dot(information * late) / weight;
    const Eigen::Vector2d left = late - tau * e;
    return std::pair(InstrumentError{channel, InstrumentErrorKind::delay, tau, 1.0 / std::sqrt(weight)},
                     left.dot(information * left));
  };
  const std::array causes{by(Channel::x, {1.0, 0.0}), by(Channel::psi, {0.0, 1.0}), by(speed, {-1.0, -1.0})};
  const double least = std::ranges::min(causes, {}, [](const auto& cause) { return cause.second; }).second;
  constexpr double alike = 4.0;  // within which the clock of the positions is the likeliest to be wrong
  if (least < explained)
    return {std::ranges::find_if(causes, [&](const auto& cause) { return cause.second < least + alike; })->first};
  return {{Channel::x, InstrumentErrorKind::delay, late[0], std::sqrt(C(0, 0))},
          {Channel::psi, InstrumentErrorKind::delay, late[1], std::sqrt(C(1, 1))}};
}

}  // namespace

std::vector<Channel> speeds_of(const Recording& run) {
  std::vector<Channel> speeds;
  if (run.has(Channel::u_ground) && run.has(Channel::v_ground)) speeds.push_back(Channel::u_ground);
  if (run.has(Channel::u)) speeds.push_back(Channel::u);
  if (run.has(Channel::speed_through_water)) speeds.push_back(Channel::speed_through_water);
  return speeds;
}

std::vector<InstrumentError> track_errors(const Recording& run, Channel speed) {
  if (!run.has(Channel::x) || !run.has(Channel::y)) return {};
  const auto source = source_of(run, speed);
  if (!source.has_sway && !is_straight(run)) return {};
  const auto [fit, late, bad_clock] = settled(run, source);
  const auto error = [&, &fit = fit](Channel channel, InstrumentErrorKind kind, Column at, double value) {
    return InstrumentError{channel, kind, value, std::sqrt(fit.covariance(at, at))};
  };
  // p = p_0 + (1 + k) R(eps) I
  const double along = 1.0 + fit.beta[scale], across = fit.beta[axes];
  const double eps = std::atan2(across, along), one_more = std::hypot(along, across);
  std::vector<InstrumentError> found{
      error(speed, InstrumentErrorKind::scale, scale, 1.0 / one_more - 1.0),
      error(source.has_sway ? speed : Channel::psi, InstrumentErrorKind::axes, axes, eps)};
  if (bad_clock) {
    constexpr double persistence = 300.0;  // [s], of the rate of the one such clock that was seen, R/V Gunnerus's
    // a clock that wanders may have run fast or slow for minutes: as much of the way is not known
    const double share = std::min(1.0, std::sqrt(persistence / (run.time.back() - run.time.front())));
    found[0].standard_error = std::hypot(found[0].standard_error, share * InstrumentPriors{}.drift);
    found.push_back({Channel::x, InstrumentErrorKind::clock, fit.errors.clock * std::sqrt(minute), 0.0, true});
    return found;
  }
  if (!source.has_sway) return found;
  const Eigen::Vector2d late_by{late + fit.beta[delay], fit.beta[heading_delay]};
  for (const auto& e : delays_of(speed, late_by, fit.covariance({delay, heading_delay}, {delay, heading_delay})))
    found.push_back(e);
  found.push_back(error(Channel::x, InstrumentErrorKind::lever_arm_x, lever_x, fit.beta[lever_x]));
  found.push_back(error(Channel::x, InstrumentErrorKind::lever_arm_y, lever_y, fit.beta[lever_y]));
  return found;
}

}  // namespace swayaw::identification::detail
