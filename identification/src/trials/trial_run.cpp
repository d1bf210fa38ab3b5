#include "trial_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/detail/median.hpp"
#include "swayaw/core/refusal.hpp"

namespace swayaw::inline identification::detail {
namespace {

double median_between(const Samples& s, double from, double to) {
  std::vector<double> inside;
  for (std::size_t i = s.index_at(from); i < s.size() && s.time[i] <= to; ++i) inside.push_back(s.value[i]);
  return inside.empty() ? s.value[std::min(s.index_at(from), s.size() - 1)]
                        : core::detail::median_of(std::move(inside));
}

double largest_off(const Samples& s, double level) {
  double result = 0.0;
  for (const double value : s.value) result = std::max(result, std::abs(value - level));
  return result;
}

/// Side of the rudder: beyond half of the largest angle, or within a quarter; in between that before.
double side_of(double off, double largest, double before) {
  if (std::abs(off) > 0.5 * largest) return std::copysign(1.0, off);
  return std::abs(off) < 0.25 * largest ? 0.0 : before;
}

/// Median of the samples within a tenth of the angle that a fifth of the leg goes beyond: without the way there.
double held_level(const Samples& delta, const RudderLeg& leg) {
  std::vector<double> off;
  for (std::size_t i = delta.index_at(leg.from); i < delta.size() && delta.time[i] <= leg.to; ++i)
    off.push_back(delta.value[i]);
  if (leg.sign == 0.0) return core::detail::median_of(std::move(off));
  std::ranges::sort(off, {}, [&](double x) { return leg.sign * x; });
  const double beyond = off[off.size() * 4 / 5];
  std::erase_if(off, [&](double x) { return leg.sign * x < 0.9 * std::abs(beyond); });
  return off[off.size() / 2];
}

/// Whether the rudder is on its way all the time: it moves by a tenth of the largest angle in the middle half.
bool moves_in(const Samples& delta, const RudderLeg& leg, double largest) {
  const double quarter = 0.25 * (leg.to - leg.from);
  const std::size_t a = delta.index_at(leg.from + quarter), b = delta.index_at(leg.to - quarter);
  return b < a + 2 || std::abs(delta.value[b] - delta.value[a]) > 0.1 * largest;
}

std::vector<RudderLeg> legs_of(const Samples& delta, double before, double largest) {
  std::vector<RudderLeg> legs;
  double side = 0.0;
  legs.push_back({0.0, delta.time.front(), delta.time.front(), before});
  for (std::size_t i = 0; i < delta.size(); ++i) {
    const double now = side_of(delta.value[i] - before, largest, side);
    if (now != side) legs.push_back({now, delta.time[i], delta.time[i], 0.0});
    legs.back().to = delta.time[i];
    side = now;
  }
  // amidships on the way from side to side is no leg
  for (std::size_t k = 1; k + 1 < legs.size();) {
    const bool passing =
        legs[k].sign == 0.0 && legs[k - 1].sign * legs[k + 1].sign < 0.0 && moves_in(delta, legs[k], largest);
    if (passing) legs.erase(legs.begin() + static_cast<std::ptrdiff_t>(k));
    else ++k;
  }
  for (std::size_t k = 1; k < legs.size(); ++k) legs[k].level = held_level(delta, legs[k]);
  return legs;
}

std::vector<double> combined(const Recording& run, Channel a, Channel b, double (*f)(double, double)) {
  std::vector<double> result;
  for (std::size_t i = 0; i < run.samples(); ++i) result.push_back(f(run[a][i], run[b][i]));
  return result;
}

/// Without the missing samples.
Samples complete(const Recording& run, const std::vector<double>& values) {
  std::vector<double> time, value;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::isfinite(values[i])) time.push_back(run.time[i]), value.push_back(values[i]);
  return samples_of(std::move(time), std::move(value));
}

/// Angles of a rudder: put over in steps, which are no noise, and not smoothed.
Samples rudder_samples(const Recording& run, Channel channel) {
  auto s = samples_of(run, channel);
  if (s.size() > 0) s.noise = {std::max(white_noise_of(s.value), s.digit / std::sqrt(12.0))};
  return s;
}

double hypotenuse(double a, double b) { return std::hypot(a, b); }

/// Forward speed of the track, (dx cos psi + dy sin psi)/dt between samples.
Samples track_speed(const Samples& x, const Samples& y, const Samples& psi) {
  std::vector<double> time, value;
  if (x.time != y.time) return {};
  for (std::size_t i = 1; i < x.size(); ++i) {
    const double dt = x.time[i] - x.time[i - 1], middle = 0.5 * (x.time[i] + x.time[i - 1]);
    const std::size_t k = std::min(psi.index_at(middle), psi.size() - 1);
    const double heading = psi.value[k];
    time.push_back(middle);
    value.push_back(
        ((x.value[i] - x.value[i - 1]) * std::cos(heading) + (y.value[i] - y.value[i - 1]) * std::sin(heading)) / dt);
  }
  return samples_of(std::move(time), std::move(value));
}

void find_speed(TrialRun& t) {
  const auto& run = *t.recording;
  const auto take = [&](SpeedSource source, Samples samples) {
    if (t.source != SpeedSource::none || samples.size() < 5) return;
    t.source = source;
    t.speed = std::move(samples);
  };
  if (run.has(Channel::u) && run.has(Channel::v))
    take(SpeedSource::water, complete(run, combined(run, Channel::u, Channel::v, hypotenuse)));
  take(SpeedSource::log, samples_of(run, Channel::u));
  take(SpeedSource::log, samples_of(run, Channel::speed_through_water));
  take(SpeedSource::ground, samples_of(run, Channel::speed_over_ground));
  if (run.has(Channel::u_ground) && run.has(Channel::v_ground))
    take(SpeedSource::ground, complete(run, combined(run, Channel::u_ground, Channel::v_ground, hypotenuse)));
  if (t.has_track()) take(SpeedSource::positions, track_speed(t.x, t.y, t.psi));
}

/// When the samples first pass that level in the direction of `way` between two times, by straight lines.
double crossing(const Samples& s, double level, double way, double from, double to) {
  std::size_t i = std::max<std::size_t>(s.index_at(from), 1);
  for (; i < s.size() && s.time[i - 1] <= to; ++i) {
    const double a = s.value[i - 1] - level, b = s.value[i] - level;
    if (a * way < 0.0 && b * way >= 0.0) return s.time[i - 1] + a / (a - b) * (s.time[i] - s.time[i - 1]);
  }
  return missing;
}

/// The straight line of the move from one leg to the next: through 20 % and 80 % of the way.
RudderMove move_between(const Samples& delta, const RudderLeg& before, const RudderLeg& after) {
  const double from_angle = before.level, to_angle = after.level, from = before.from, to = after.to;
  const double way = to_angle - from_angle, late = crossing(delta, from_angle + 0.8 * way, way, from, to);
  RudderMove move{.start = {late, 0.0}, .from = from_angle, .to = to_angle, .rate = std::nullopt};
  // the last passage of 20 % before that of 80 %
  double early = missing;
  for (std::size_t i = delta.index_at(late); i > 0 && delta.time[i] >= from; --i) {
    const double a = delta.value[i - 1] - from_angle - 0.2 * way,
                 b = delta.value[std::min(i, delta.size() - 1)] - from_angle - 0.2 * way;
    if (a * b > 0.0 || a == b) continue;
    early = delta.time[i - 1] + a / (a - b) * (delta.time[i] - delta.time[i - 1]);
    break;
  }
  if (std::isnan(early) || std::isnan(late))
    return {.start = {from, to - from}, .from = from_angle, .to = to_angle, .rate = {}};
  const std::size_t k = std::clamp<std::size_t>(delta.index_at(late), 1, delta.size() - 1);
  const double step = delta.time[k] - delta.time[k - 1];
  const double rate = late > early ? 0.6 * std::abs(way) / (late - early) : 0.0;
  if (late - early > 0.7 * step) {
    // 20 % of the way before its passage; noise at both passages, 4/3 and 1/3 of it
    move.start = {early - (late - early) / 3.0, std::hypot(1.37 * delta.noise.deviation / rate, 0.1 * step)};
    move.rate = rate;
  } else {
    move.start = {delta.time[k - 1] + 0.5 * step, step / std::sqrt(12.0)};
  }
  move.start.value = std::max(move.start.value, delta.time.front());
  return move;
}

/// Until when the rudder stays where it is at first, to 0.3 deg or its noise.
double still_until(const Samples& delta) {
  const double slack = std::max(radians(0.3), 4.0 * delta.noise.deviation);
  std::size_t i = 0;
  while (i + 1 < delta.size() && std::abs(delta.value[i + 1] - delta.value[0]) <= slack) ++i;
  return delta.time[i];
}

/// Without the legs before the execute, or before the leg that turns the ship by 180 deg or more, which no leg of a
/// zigzag does: steering in the approach.
std::vector<RudderLeg> without_approach(std::vector<RudderLeg> legs, const Samples& psi,
                                        std::optional<double> execute) {
  std::size_t first = 1;
  double most = radians(180.0);
  const auto heading = [&](double t) { return psi.value[std::min(psi.index_at(t), psi.size() - 1)]; };
  for (std::size_t k = 1; k < legs.size(); ++k) {
    const double change = std::abs(heading(legs[k].to) - heading(legs[k].from));
    if (legs[k].sign != 0.0 && change > most) first = k, most = change;
    if (execute && legs[k].to < *execute) first = std::max(first, k + 1);
  }
  if (first >= legs.size() || first == 1) return legs;
  legs[0].from = legs[first - 1].from;
  legs[0].to = legs[first - 1].to;
  legs.erase(legs.begin() + 1, legs.begin() + static_cast<std::ptrdiff_t>(first));
  return legs;
}

/// A rudder of a zigzag this much further over than ordered is no leg of it: then the helmsman brings her back to her
/// course. A helmsman misses his order by a few degrees; the next usual order, 20 for 10 deg, is twice as far.
constexpr double beyond_order = 1.5;

/// Without the legs from the first one that goes beyond the order. @return when that one begins; infinite: never
double cut_after_manoeuvre(std::vector<RudderLeg>& legs, double before, double ordered) {
  const auto is_beyond = [&](const RudderLeg& leg) { return std::abs(leg.level - before) > beyond_order * ordered; };
  const auto first = std::ranges::find_if(legs, is_beyond);
  if (first == legs.end()) return HUGE_VAL;
  const double from = first->from;
  legs.erase(first, legs.end());
  return from;
}

MaybeTold first_move(const Samples& delta, const std::vector<RudderLeg>& legs) {
  if (legs.size() < 2) return std::nullopt;
  return move_between(delta, legs[0], legs[1]).start;
}

}  // namespace

Samples drift_samples(const Recording& run) {
  if (!run.has(Channel::u) || !run.has(Channel::v)) return {};
  return complete(run, combined(run, Channel::u, Channel::v, [](double u, double v) { return std::atan2(-v, u); }));
}

TrialRun prepared(const Recording& run) {
  if (!run.has(Channel::psi)) throw Refusal(fmt::format("{}: no heading recorded: nothing can be judged", run.name));
  const Channel rudder = run.has(Channel::delta) ? Channel::delta : Channel::delta_order;
  if (!run.has(rudder)) throw Refusal(fmt::format("{}: no rudder angle recorded: nothing can be judged", run.name));
  TrialRun t{.recording = &run,
             .psi = samples_of(run, Channel::psi),
             .delta = rudder_samples(run, rudder),
             .x = samples_of(run, Channel::x),
             .y = samples_of(run, Channel::y),
             .speed = {},
             .rudder_before = 0.0,
             .largest = 0.0,
             .legs = {},
             .steered_until = 0.0,
             .execute = {run.time.front(), 0.0},
             .execute_said = run.facts.execute.has_value()};
  if (t.psi.size() < 10 || t.delta.size() < 10)
    throw Refusal(fmt::format("{}: too short: {} headings and {} rudder angles; ten of each are needed", run.name,
                              t.psi.size(), t.delta.size()));
  find_speed(t);
  const double start = t.delta.time.front(), first = run.facts.execute.value_or(start);
  // without an execute the first samples that agree; amidships where the rudder is already over
  t.rudder_before = median_between(t.delta, start, first > start ? first : still_until(t.delta));
  if (std::abs(t.rudder_before) > 0.3 * largest_off(t.delta, 0.0)) t.rudder_before = 0.0;
  t.largest = largest_off(t.delta, t.rudder_before);
  const double ordered = std::min(t.largest, zigzag_rudder(run).value_or(t.largest));
  t.legs = without_approach(legs_of(t.delta, t.rudder_before, ordered), t.psi, run.facts.execute);
  t.steered_until = std::min(t.end(), cut_after_manoeuvre(t.legs, t.rudder_before, ordered));
  if (run.facts.execute) t.execute = {*run.facts.execute, 0.0};
  else if (const auto moved = first_move(t.delta, t.legs)) t.execute = *moved;
  return t;
}

std::vector<RudderMove> moves_of(const TrialRun& run) {
  std::vector<RudderMove> moves;
  for (std::size_t k = 1; k < run.legs.size(); ++k)
    moves.push_back(move_between(run.delta, run.legs[k - 1], run.legs[k]));
  return moves;
}

Approach approach_of(const TrialRun& run, const TrialOptions& options) {
  const double start = run.psi.time.front(), execute = run.execute.value;
  const auto at_execute = [&](const Samples& s) -> MaybeTold {
    const auto mean = level_before(s, start, execute), joined = value_at(s, execute);
    if (!joined || (mean && mean->standard_error < joined->standard_error)) return mean;
    return joined;
  };
  Approach result{.execute = run.execute,
                  .execute_said = run.execute_said,
                  .heading = *at_execute(run.psi),
                  .speed = at_execute(run.speed),
                  .speed_source = run.source,
                  .rudder = run.rudder_before,
                  .before = std::max(execute - start, 0.0)};
  if (options.U) {
    result.speed = Told{*options.U, 0.0};
    result.speed_source = SpeedSource::given;
  }
  return result;
}

MaybeTold way_between(const TrialRun& run, const Told& from, const Told& to) {
  if (run.speed.size() < 5 || to.value <= from.value || run.speed.time.back() < to.value) return std::nullopt;
  constexpr int parts = 8;  // Simpson's rule on local cubics
  double way = 0.0, variance = 0.0, last = 0.0;
  const double h = (to.value - from.value) / parts;
  for (int k = 0; k <= parts; ++k) {
    const auto U = value_at(run.speed, from.value + k * h);
    if (!U) return std::nullopt;
    const double weight = h / 3.0 * (k == 0 || k == parts ? 1.0 : k % 2 == 1 ? 4.0 : 2.0);
    way += weight * U->value;
    variance += weight * weight * U->standard_error * U->standard_error;
    last = U->value;
  }
  return Told{way, together(std::sqrt(variance), last * to.standard_error, last * from.standard_error)};
}

}  // namespace swayaw::identification::detail
