#include "way_ahead.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/models/validity.hpp"
#include "swayaw/nonlinear/replay.hpp"
#include "terminal.hpp"

namespace swayaw::app {
namespace {

/// What a part must have of way to be worked with, in ship lengths: a window of `compare`, a forecast of a fit.
constexpr double shortest_way = 2.0;

/// The recorded ship at a time, and until the next moment.
struct Moment {
  double time;
  double u;    ///< [m/s]
  bool holds;  ///< the models answer for motion and controls
};

/// Nothing where no channel tells the motion, as behind the first reading of a log.
std::optional<ShipState<double>> state_told(const Ship& ship, const Recording& run, double time) try {
  return recorded_state(ship, run, time);
} catch (const Refusal&) {
  return std::nullopt;
}

/// A quarter of L/U apart, over which a recorded state is averaged.
std::vector<Moment> moments_of(const Ship& ship, const Recording& run) {
  const RecordedControls controls(ship, run);
  const double step = 0.25 * time_unit_of(ship), end = run.time.back();
  std::vector<Moment> moments;
  for (double time = run.time.front(); time < end; time += step) {
    const auto state = state_told(ship, run, time);
    const bool holds = !state || validity_of(state->motion, controls.at(time), length(ship)) == Validity::valid;
    const bool astern = controls.shaft_astern(time, std::min(end, time + step)).has_value();
    moments.push_back({time, state ? state->motion.u : service_speed(ship), holds && !astern});
  }
  return moments;
}

/// From one time to another, with the way made.
struct Part {
  double from, to;  ///< [s]
  double way;       ///< [m]
};

/// The part with the most way of those in which the models hold and she makes enough of it, at the neighbouring moments
/// too: a recorded state is a mean over some of the time to them.
std::optional<Part> most_way(const std::vector<Moment>& moments, double end, double least) {
  const auto sails = [&](std::size_t k) { return k >= moments.size() || (moments[k].holds && moments[k].u >= least); };
  std::optional<Part> most, now;
  for (std::size_t k = 0; k < moments.size(); ++k) {
    const auto& m = moments[k];
    if (!sails(k) || !sails(k + 1) || (k > 0 && !sails(k - 1))) {
      now.reset();
      continue;
    }
    const double to = k + 1 < moments.size() ? moments[k + 1].time : end;
    if (!now) now = Part{m.time, to, 0.0};
    now->to = to, now->way += m.u * (to - m.time);
    if (!most || now->way > most->way) most = now;
  }
  return most;
}

/// The samples of a part.
Recording samples_of(const Recording& run, const Part& part) {
  const auto first = std::ranges::lower_bound(run.time, part.from) - run.time.begin(),
             end = std::ranges::upper_bound(run.time, part.to) - run.time.begin();
  const auto cut = [&]<class T>(const std::vector<T>& all) {
    return all.empty() ? all : std::vector<T>(all.begin() + first, all.begin() + end);
  };
  Recording result{run.name, run.facts, cut(run.time), {}, {}};
  std::ranges::transform(run.channels, result.channels.begin(), cut);
  for (const auto& extra : run.extra) result.extra.push_back({extra.name, cut(extra.cells)});
  return result;
}

void tell_part(const Ship& ship, const Recording& run, const Recording& part) {
  const bool before = part.time.front() > run.time.front(), after = part.time.back() < run.time.back();
  const auto times = before && after ? fmt::format("from {:.6g} to {:.6g} s", part.time.front(), part.time.back())
                     : before        ? fmt::format("from {:.6g} s on", part.time.front())
                                     : fmt::format("up to {:.6g} s", part.time.back());
  const auto* where = before && after ? "before and after" : before ? "before" : "after";
  const bool astern = RecordedControls(ship, run).shaft_astern(run.time.front(), run.time.back()).has_value();
  say_aside("swayaw: {}: used {}: {}, she has no way ahead{}\n", run.name, times, where,
            astern ? " or her shaft turns astern" : "");
}

}  // namespace

std::string why_not(const Ship& ship, const Recording& run) try {
  const auto start = recorded_state(ship, run, run.time.front());
  const double until = run.time.front() + shortest_way * time_unit_of(ship);
  const auto count = std::max<std::ptrdiff_t>(2, std::ranges::upper_bound(run.time, until) - run.time.begin());
  const auto times = std::span(run.time).first(std::min(run.time.size(), static_cast<std::size_t>(count)));
  if (times.size() < 2) return "it has one sample";
  (void)replay_from(ship, RecordedControls(ship, run), start, times);
  return {};
} catch (const std::exception& trouble) {
  return trouble.what();
}

Recording with_way_ahead(const Ship& ship, Recording run) try {
  if (run.samples() < 2) return run;
  const auto moments = moments_of(ship, run);
  const bool sails = why_not(ship, run).empty();
  if (sails && std::ranges::all_of(moments, &Moment::holds)) return run;
  const auto part = most_way(moments, run.time.back(), least_way * service_speed(ship));
  if (!part || part->way < shortest_way * length(ship)) return run;
  auto used = samples_of(run, *part);
  if (used.samples() == run.samples() || (sails && !why_not(ship, used).empty())) return run;
  tell_part(ship, run, used);
  return used;
} catch (const std::exception&) {
  return run;  // what is wrong with it is told where it is sailed
}

}  // namespace swayaw::app
