#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/detail/matrices.hpp"
#include "swayaw/core/refusal.hpp"
#include "trial_run.hpp"

namespace swayaw::inline identification::detail {
namespace {

// The steady turn and the drift are read from here on, as [ITTC7.5-04-02-01] and [MSC/Circ.1053] do.
constexpr double settled_from = radians(180.0), whole_turn = radians(360.0);

/// The turn alone: from the execute to where the rudder is taken back.
struct Turn {
  const TrialRun* run;
  const Approach* approach;
  double sign;  ///< of the heading change
  double end;   ///< [s]

  double off(double psi) const { return sign * (psi - approach->heading.value); }

  /// When the heading has changed by that angle; the heading of the approach is uncertain too.
  MaybeTold time_of(double angle) const {
    auto t = passage(run->psi, approach->heading.value + sign * angle, sign, approach->execute.value, end);
    if (!t) return std::nullopt;
    const auto slope = local_cubic(run->psi, t->value)->slope(t->value);
    t->standard_error = together(t->standard_error, approach->heading.standard_error / slope.value);
    return t;
  }
};

Told since(const Told& t, const Told& execute) {
  return {t.value - execute.value, together(t.standard_error, execute.standard_error)};
}

/// A place, with the velocity of the track there.
struct Place {
  Told x, y;
  double vx, vy;
};

std::optional<Place> place_at(const TrialRun& run, double t) {
  const auto x = local_cubic(run.x, t), y = local_cubic(run.y, t);
  if (!x || !y) return std::nullopt;
  return Place{x->value(t), y->value(t), x->slope(t).value, y->slope(t).value};
}

/// Steady drift of the track [m/s], taken off it.
struct Drift {
  double north = 0.0, east = 0.0, standard_error = 0.0;
};

/// Way along (cos a, sin a) from the execute to a time, without the drift.
///
///     s = (x(t) − x(t_0) − V_x (t − t_0)) cos a + (…) sin a
MaybeTold way_along(const Turn& turn, double direction, double direction_error, const Told& t, const Drift& drift) {
  const auto from = place_at(*turn.run, turn.approach->execute.value), to = place_at(*turn.run, t.value);
  if (!from || !to) return std::nullopt;
  const double dt = t.value - turn.approach->execute.value, c = std::cos(direction), s = std::sin(direction);
  const double dx = to->x.value - from->x.value - drift.north * dt, dy = to->y.value - from->y.value - drift.east * dt;
  const double speed_then = (to->vx - drift.north) * c + (to->vy - drift.east) * s,
               speed_first = (from->vx - drift.north) * c + (from->vy - drift.east) * s;
  const double places = together(c * together(from->x.standard_error, to->x.standard_error),
                                 s * together(from->y.standard_error, to->y.standard_error));
  const double moments = together(speed_then * t.standard_error, speed_first * turn.approach->execute.standard_error);
  const double turned = together(direction_error * (dy * c - dx * s), drift.standard_error * dt);
  return Told{dx * c + dy * s, together(places, moments, turned)};
}

CircleTold lengths_of(const Turn& turn, const Drift& drift, const MaybeTold& t90, const MaybeTold& t180,
                      const MaybeTold& t10) {
  CircleTold c{};
  const double psi0 = turn.approach->heading.value, error = turn.approach->heading.standard_error;
  const double across = psi0 + turn.sign * 0.5 * pi;
  if (t90) {
    c.advance = way_along(turn, psi0, error, *t90, drift);
    c.transfer = way_along(turn, across, error, *t90, drift);
  }
  if (t180) c.tactical_diameter = way_along(turn, across, error, *t180, drift);
  if (t10) {
    c.initial_turning = through_water(turn.run->source)
                            ? way_between(*turn.run, turn.approach->execute, *t10)
                            : way_along(turn, psi0 + turn.sign * radians(3.0), error, *t10, drift);
  }
  return c;
}

// ---------------------------------------------------------------- drift of the track

/// Drift between two places with headings 360 deg apart.
struct PairDrift {
  double from;  ///< heading change at the first place [rad]
  double north, east, standard_error;
};

std::vector<PairDrift> pairs_of(const Turn& turn, double change) {
  std::vector<PairDrift> pairs;
  constexpr double step = radians(10.0);
  for (double angle = 0.5 * settled_from; angle + whole_turn <= change; angle += step) {
    const auto t1 = turn.time_of(angle), t2 = turn.time_of(angle + whole_turn);
    if (!t1 || !t2) continue;
    const auto a = place_at(*turn.run, t1->value), b = place_at(*turn.run, t2->value);
    if (!a || !b) continue;
    const double dt = t2->value - t1->value;
    const double x = together(a->x.standard_error, b->x.standard_error),
                 y = together(a->y.standard_error, b->y.standard_error);
    pairs.push_back(
        {angle, (b->x.value - a->x.value) / dt, (b->y.value - a->y.value) / dt, together(x, y) / std::sqrt(2.0) / dt});
  }
  return pairs;
}

Told speed_of(double north, double east, double error) { return {std::hypot(north, east), error}; }

Told direction_of(double north, double east, double error) {
  const double V = std::hypot(north, east), to = std::atan2(east, north);
  return {to < 0.0 ? to + 2.0 * pi : to, V > 0.0 ? std::min(error / V, pi) : pi};
}

PairDrift mean_of(const std::vector<PairDrift>& pairs, auto&& taken) {
  PairDrift mean{0.0, 0.0, 0.0, 0.0};
  double count = 0.0;
  for (const auto& p : pairs) {
    if (!taken(p)) continue;
    mean.north += p.north, mean.east += p.east;
    mean.standard_error += p.standard_error;
    count += 1.0;
  }
  return {count, mean.north / count, mean.east / count, mean.standard_error / count};
}

// Mean over the pairs from 180 deg on. How far the turn is from settled shows in what the earlier pairs say else, and
// in how far the later ones scatter. The share of the
// difference of the earlier pairs that is left in the mean: over simulated turns (trial_intervals_test).
constexpr double unsettled_share = 0.2;

std::optional<DriftTold> drift_of(const Turn& turn, double change) {
  const auto pairs = pairs_of(turn, change);
  const auto settled = [](const PairDrift& p) { return p.from >= settled_from - 1e-9; };
  const auto mean = mean_of(pairs, settled);
  if (!(mean.from > 0.0)) return std::nullopt;
  const auto early = mean_of(pairs, [&](const PairDrift& p) { return !settled(p); });
  const auto off = [&](const PairDrift& p) { return std::hypot(p.north - mean.north, p.east - mean.east); };
  double squares = 0.0;
  for (const auto& p : pairs)
    if (settled(p)) squares += off(p) * off(p);
  const double noise = mean.standard_error,
               scatter = std::sqrt(std::max(0.5 * squares / mean.from - noise * noise, 0.0));
  const double unsettled = early.from > 0.0 ? unsettled_share * off(early) : 0.0;
  // places 10 deg apart share samples: every other pair counts
  const double error = together(noise / std::sqrt(std::max(0.5 * mean.from, 1.0)), std::max(scatter, unsettled));
  return DriftTold{.north = {mean.north, error},
                   .east = {mean.east, error},
                   .speed = speed_of(mean.north, mean.east, error),
                   .direction = direction_of(mean.north, mean.east, error),
                   .pairs = static_cast<std::size_t>(mean.from)};
}

// ---------------------------------------------------------------- steady turn

/// Track of a steady turn, z = x + i y: z = z_c + V t + w exp(i psi). Then u + i v = i r w through the water.
struct SteadyTrack {
  Told radius;
  Told drift_angle;
};

std::optional<SteadyTrack> steady_track(const Turn& turn, const Drift& drift, double from, double to) {
  const auto &x = turn.run->x, &y = turn.run->y, &psi = turn.run->psi;
  if (x.time != y.time) return std::nullopt;
  // [x; y] = [1 0 cos −sin; 0 1 sin cos] [x_c y_c Re w Im w]
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  std::size_t k = 0, count = 0;
  for (std::size_t i = x.index_at(from); i < x.size() && x.time[i] <= to; ++i) {
    while (k + 2 < psi.size() && psi.time[k + 1] < x.time[i]) ++k;
    const double share = (x.time[i] - psi.time[k]) / (psi.time[k + 1] - psi.time[k]);
    const double heading = psi.value[k] + share * (psi.value[k + 1] - psi.value[k]);
    const Eigen::Vector4d a(1.0, 0.0, std::cos(heading), -std::sin(heading)),
        b(0.0, 1.0, std::sin(heading), std::cos(heading));
    const double dt = x.time[i] - from;
    normal += a * a.transpose() + b * b.transpose();
    right += a * (x.value[i] - drift.north * dt) + b * (y.value[i] - drift.east * dt);
    ++count;
  }
  if (count < 8) return std::nullopt;
  const Eigen::Vector4d z = core::detail::solve_symmetric(normal, right);
  // u + i v = i r w: u = −r Im w, v = r Re w
  const double radius = std::hypot(z[2], z[3]);
  // noise of two coordinates on two numbers, and a drift that is off over half a turn
  const double noise = std::max(x.noise.of_mean(count), y.noise.of_mean(count));
  const double error = together(std::sqrt(2.0) * noise, drift.standard_error * (to - from) / pi);
  return SteadyTrack{{radius, error}, {std::atan2(-turn.sign * z[2], -turn.sign * z[3]), error / radius}};
}

// What is left to come of a quantity, of the difference of its means over the two halves of the last half turn: over
// simulated turns (trial_intervals_test).
constexpr double unsettled_half = 0.7;

/// Mean over the second of two stretches.
template <class F>
MaybeTold settled(const F& over, double from, double middle, double to) {
  const auto all = over(from, to), first = over(from, middle), last = over(middle, to);
  if (!all || !first || !last) return std::nullopt;
  return Told{last->value, together(last->standard_error, unsettled_half * (last->value - first->value))};
}

MaybeTold mean_over(const Samples& s, double from, double to) {
  if (const auto line = line_over(s, from, to)) return line->value;
  return std::nullopt;
}

void tell_steady(TurnTrial& result, const Turn& turn, double change, const Drift* drift) {
  const auto& run = *turn.run;
  const double last = change - 1e-6, first = std::max(settled_from, last - settled_from);
  const auto t1 = turn.time_of(first), tm = turn.time_of(0.5 * (first + last));
  if (last - first < radians(60.0) || !t1 || !tm) return;
  const auto over = [&](auto&& f) { return settled(f, t1->value, tm->value, turn.end); };
  result.final_yaw_rate = over([&](double a, double b) -> MaybeTold {
    if (const auto line = line_over(run.psi, a, b)) return line->slope;
    return std::nullopt;
  });
  const auto drift_angles = drift_samples(*run.recording);
  const auto track = [&](const Drift& d, auto&& f) {
    return over([&](double a, double b) -> MaybeTold {
      if (!run.has_track()) return std::nullopt;
      if (const auto t = steady_track(turn, d, a, b)) return f(*t);
      return std::nullopt;
    });
  };
  const auto diameter = [](const SteadyTrack& t) { return Told{2.0 * t.radius.value, 2.0 * t.radius.standard_error}; };
  result.recorded.final_diameter = track({}, diameter);
  const MaybeTold clear = drift != nullptr ? track(*drift, diameter) : std::nullopt;
  if (result.corrected) result.corrected->final_diameter = clear;
  const double r = result.final_yaw_rate ? std::abs(result.final_yaw_rate->value) : 0.0;
  // a log shows u = U cos(beta) only
  if (run.source == SpeedSource::water || (run.source == SpeedSource::log && !clear))
    result.final_speed = over([&](double a, double b) { return mean_over(run.speed, a, b); });
  else if (clear && r > 0.0) result.final_speed = Told{0.5 * r * clear->value, 0.5 * r * clear->standard_error};
  if (drift_angles.size() > 8)
    result.final_drift = over([&](double a, double b) { return mean_over(drift_angles, a, b); });
  else if (drift != nullptr) result.final_drift = track(*drift, [](const SteadyTrack& t) { return t.drift_angle; });
}

/// Yaw rate over the last quarter of a rudder amidships after the turn.
MaybeTold pulled_out(const TrialRun& run, std::size_t turning) {
  if (turning + 1 >= run.legs.size() || run.legs[turning + 1].sign != 0.0) return std::nullopt;
  const auto& leg = run.legs[turning + 1];
  const double turn_time = run.legs[turning].to - run.legs[turning].from;
  if (leg.to - leg.from < 0.2 * turn_time) return std::nullopt;
  const double late = leg.to - 0.25 * (leg.to - leg.from);
  const auto line = line_over(run.psi, late, leg.to), before = line_over(run.psi, late - (leg.to - late), late);
  if (!line || !before) return std::nullopt;
  return Told{line->slope.value, together(line->slope.standard_error, line->slope.value - before->slope.value)};
}

}  // namespace

TurnTrial turn_trial(const TrialRun& run, const Approach& approach, std::vector<std::string>& notes) {
  std::size_t turning = 1;
  while (turning + 1 < run.legs.size() && run.legs[turning].sign == 0.0) ++turning;
  Turn turn{&run, &approach, 1.0, turning < run.legs.size() ? run.legs[turning].to : run.end()};
  if (turning + 1 >= run.legs.size()) turn.end = run.end();
  if (turn.end <= approach.execute.value)
    throw Refusal(fmt::format("{}: the rudder is not held over for a turn; is execute_s right?", run.recording->name));
  const auto last = value_at(run.psi, turn.end);
  turn.sign = last->value < approach.heading.value ? -1.0 : 1.0;
  const double change = turn.off(last->value);
  if (change < radians(10.0))
    throw Refusal(fmt::format("{}: the heading changes by {:.1f} deg while the rudder is held over: no turn to judge",
                              run.recording->name, degrees(change)));
  TurnTrial result{};
  result.side = turn.sign > 0.0 ? Side::starboard : Side::port;
  result.heading_change = change;
  const auto t10 = turn.time_of(radians(10.0)), t90 = turn.time_of(radians(90.0)), t180 = turn.time_of(radians(180.0));
  const auto told_time = [&](const MaybeTold& t) -> MaybeTold {
    return t ? MaybeTold(since(*t, approach.execute)) : std::nullopt;
  };
  result.time_90 = told_time(t90);
  result.time_180 = told_time(t180);
  result.time_270 = told_time(turn.time_of(radians(270.0)));
  result.time_360 = told_time(turn.time_of(radians(360.0)));
  std::optional<Drift> drift;
  if (run.has_track()) {
    result.recorded = lengths_of(turn, {}, t90, t180, t10);
    result.drift = drift_of(turn, change);
    if (result.drift) {
      drift = Drift{result.drift->north.value, result.drift->east.value, result.drift->north.standard_error};
      result.corrected = lengths_of(turn, *drift, t90, t180, t10);
    } else {
      notes.push_back(
          fmt::format("the drift by current and wind cannot be told: the turn ends after {:.0f} deg and 540 are "
                      "needed, so that headings of the steady turn come twice; lengths are those of the track "
                      "as recorded",
                      degrees(change)));
    }
  } else {
    notes.push_back("no positions recorded: advance, transfer and diameters cannot be told");
  }
  tell_steady(result, turn, change, drift ? &*drift : nullptr);
  if (!result.final_yaw_rate)
    notes.push_back(
        fmt::format("no steady turn can be told: the turn ends after {:.0f} deg, and 240 are needed", degrees(change)));
  if (result.final_speed && approach.speed)
    result.speed_kept = Told{result.final_speed->value / approach.speed->value,
                             result.final_speed->value / approach.speed->value *
                                 together(result.final_speed->standard_error / result.final_speed->value,
                                          approach.speed->standard_error / approach.speed->value)};
  if (result.final_yaw_rate && turning < run.legs.size()) {
    const double delta = -(run.legs[turning].level);
    result.gain = Told{result.final_yaw_rate->value / delta, result.final_yaw_rate->standard_error / std::abs(delta)};
  }
  result.residual_yaw_rate = pulled_out(run, turning);
  return result;
}

}  // namespace swayaw::identification::detail
