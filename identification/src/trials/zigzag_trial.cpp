#include <algorithm>
#include <cmath>

#include "trial_run.hpp"

namespace swayaw::inline identification::detail {
namespace {

double yaw_sign_of(double x) { return x < 0.0 ? -1.0 : 1.0; }

Side side_of(double sign) { return sign > 0.0 ? Side::starboard : Side::port; }

/// A reversal of the rudder: its move, and until when the heading may have its peak.
struct Reverse {
  const RudderMove* move;
  double middle;  ///< the rudder passes its mean [s]
  double until;   ///< the next reversal, or the end of leg and run [s]
};

std::vector<Reverse> reversals_of(const TrialRun& run, const std::vector<RudderMove>& moves) {
  std::vector<Reverse> result;
  for (std::size_t k = 2; k < run.legs.size(); ++k)
    if (run.legs[k].sign * run.legs[k - 1].sign < 0.0) result.push_back({&moves[k - 1], run.legs[k].from, 0.0});
  for (std::size_t k = 0; k < result.size(); ++k)
    result[k].until = k + 1 < result.size() ? result[k + 1].middle : run.steered_until;
  return result;
}

/// Where the heading goes between the first execute and the first reversal, and then to and fro.
double first_sign(const TrialRun& run, double approach, double until) {
  const auto psi = value_at(run.psi, until);
  return yaw_sign_of(psi->value - approach);
}

MaybeTold minus(const MaybeTold& a, const MaybeTold& b) {
  if (!a || !b) return std::nullopt;
  return Told{a->value - b->value, together(a->standard_error, b->standard_error)};
}

/// Whether a peak that is not beyond H may have reached it.
bool touches(const Told& peak, double H) { return std::abs(peak.value - H) <= 2.0 * peak.standard_error; }

TrialReversal reversal(const TrialRun& run, const Approach& approach, double H, double sign, double from,
                       const Reverse& reverse) {
  TrialReversal result{.side = side_of(sign),
                       .execute = {},
                       .rudder_start = reverse.move->start,
                       .heading_then = {},
                       .peak_time = {},
                       .overshoot = {},
                       .beyond_start = {},
                       .overshoot_time = {}};
  const double psi0 = approach.heading.value;
  const auto off = [&](const Told& psi) {
    return Told{sign * (psi.value - psi0), together(psi.standard_error, approach.heading.standard_error)};
  };
  if (const auto psi = value_at(run.psi, reverse.move->start.value)) {
    const auto slope = local_cubic(run.psi, reverse.move->start.value)->slope(reverse.move->start.value);
    result.heading_then = off(*psi);
    result.heading_then->standard_error =
        together(result.heading_then->standard_error, slope.value * reverse.move->start.standard_error);
  }
  const auto top = peak(run.psi, sign, from, reverse.until);
  const double last = top ? top->time.value : reverse.until;
  if (auto passed = passage(run.psi, psi0 + sign * H, sign, from, last)) {
    // the level is as uncertain as the heading of the approach
    const auto slope = local_cubic(run.psi, passed->value)->slope(passed->value);
    passed->standard_error = together(passed->standard_error, approach.heading.standard_error / slope.value);
    result.execute = passed;
  } else if (top && touches(off(top->value), H)) {
    // then the rudder tells when
    const auto& start = reverse.move->start;
    result.execute = Told{start.value, together(start.standard_error, top->time.value - start.value)};
  }
  if (!top || top->time.value < reverse.move->start.value) return result;
  const Told height = off(top->value);
  result.peak_time = top->time;
  result.overshoot = Told{height.value - H, height.standard_error};
  result.beyond_start = minus(height, result.heading_then);
  result.overshoot_time = minus(result.peak_time, result.execute);
  return result;
}

/// The last execute minus the last but two.
MaybeTold period_of(const std::vector<TrialReversal>& reversals) {
  const auto n = reversals.size();
  return n < 3 ? std::nullopt : minus(reversals[n - 1].execute, reversals[n - 3].execute);
}

}  // namespace

ZigzagTrial zigzag_trial(const TrialRun& run, const Approach& approach, const TrialManoeuvre& manoeuvre,
                         const std::vector<RudderMove>& moves) {
  const auto reversals = reversals_of(run, moves);
  ZigzagTrial result{.first = Side::starboard,
                     .reversals = {},
                     .period = {},
                     .reach = {},
                     .initial_turning = {},
                     .end = run.steered_until};
  if (reversals.empty()) return result;
  const double psi0 = approach.heading.value;
  double sign = first_sign(run, psi0, reversals.front().middle), from = approach.execute.value;
  result.first = side_of(sign);
  for (const auto& r : reversals) {
    const auto next = reversal(run, approach, manoeuvre.heading, sign, from, r);
    if (!next.execute) break;
    result.reversals.push_back(next);
    result.end = r.until;
    from = result.reversals.back().peak_time ? result.reversals.back().peak_time->value : r.middle;
    sign = -sign;
  }
  result.broken_off = result.reversals.size() < reversals.size();
  if (result.reversals.empty()) return result;
  result.period = period_of(result.reversals);
  const auto& first = result.reversals.front();
  if (first.peak_time)
    result.reach =
        minus(passage(run.psi, psi0, -yaw_sign(result.first), first.peak_time->value, run.end()), approach.execute);
  if (first.execute) result.initial_turning = way_between(run, approach.execute, *first.execute);
  return result;
}

}  // namespace swayaw::identification::detail
