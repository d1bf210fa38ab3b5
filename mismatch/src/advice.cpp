#include "advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/detail/matrices.hpp"
#include "swayaw/core/parallel.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/manoeuvres/pull_out.hpp"
#include "words.hpp"

namespace swayaw::inline mismatch::detail {
namespace {

// ---------------------------------------------------------------- menu

struct Manoeuvre {
  std::string words;
  std::function<Recording(const Ship&)> simulate;
};

/// The ship in a world turned against the sun, so that heading 0 is what was that angle.
Ship seen_on(Ship ship, double heading) {
  ship.surroundings.wind.from -= heading;
  ship.surroundings.current.to -= heading;
  for (auto& effect : ship.effects) {
    const auto parameters = parameters_of(ship, effect);
    for (const auto& n : parameters)
      if (n.direction) parameter_value(effect, n.index) -= heading;
  }
  return ship;
}

std::vector<Manoeuvre> menu(const Ship& ship) {
  const double L = length(ship), U = service_speed(ship), largest = steering_gear(ship).max_angle;
  const double step = 0.05 * L / U, minutes = 25.0 * L / U;
  const auto limited = [largest](double angle) { return std::min(angle, largest); };
  const auto options = [=](double speed) {
    return ManoeuvreOptions{.speed = speed, .duration = minutes, .step = step};
  };
  std::vector<Manoeuvre> list;
  for (const double angle : {10.0, 20.0})
    for (const double heading : {0.0, 90.0, 180.0, 270.0})
      list.push_back(
          {fmt::format("zigzag {0:.0f}/{0:.0f} from heading {1:03.0f} deg", angle, heading), [=](const Ship& s) {
             return zigzag(seen_on(s, radians(heading)), {.rudder = limited(radians(angle)), .heading = radians(angle)},
                           options(U))
                 .run;
           }});
  list.push_back(
      {fmt::format("zigzag 20/20 at {:.2g} m/s, half of the service speed", 0.5 * U), [=](const Ship& s) {
         return zigzag(s, {.rudder = limited(radians(20.0)), .heading = radians(20.0)}, options(0.5 * U)).run;
       }});
  for (const auto side : {Side::port, Side::starboard})
    for (const double angle : {15.0, 35.0})
      list.push_back({fmt::format("turn of {:.0f} deg to {}", angle, side == Side::port ? "port" : "starboard"),
                      [=](const Ship& s) {
                        return turning_circle(s, {.rudder = limited(radians(angle)), .side = side}, options(U)).run;
                      }});
  list.push_back(
      {"pull-out from 20 deg", [=](const Ship& s) {
         return pull_out(s, {.rudder = limited(radians(20.0))}, ManoeuvreOptions{.step = step}).sides.port.run;
       }});
  return list;
}

// ---------------------------------------------------------------- separation

/// Variance of the noise of a channel, the mean of the runs that have it; nothing where none has.
std::optional<double> variance_of(std::span<const PreparedRun> runs, Channel channel) {
  double sum = 0.0, count = 0.0;
  for (const auto& run : runs)
    if (std::ranges::count(run.channels, channel) > 0) sum += std::pow(run.deviation[index_of(channel)], 2), ++count;
  return count > 0.0 ? std::optional(sum / count) : std::nullopt;
}

/// The trial with another run, seen by the same instruments.
Trial trial_with(const Trial& trial, const Recording& run) {
  std::vector<Channel> channels;
  std::array<double, channel_count> deviation{};
  for (const auto channel : motion_channels())
    if (const auto variance = variance_of(trial.runs, channel))
      channels.push_back(channel), deviation[index_of(channel)] = std::sqrt(*variance);
  Trial other = trial;
  other.runs = prepared_runs(trial.ship, {&run, 1}, channels);
  other.runs.front().deviation = deviation;
  return other;
}

/// How much better the ship that sailed explains the manoeuvre than the rival does, in log likelihood per minute.
double separation(const Trial& trial, const Manoeuvre& manoeuvre, const Ship& best, const Ship& rival,
                  const Noise& noise) try {
  Recording run = manoeuvre.simulate(best);
  run.name = manoeuvre.words;
  const auto seen = trial_with(trial, run);
  const double minutes = (run.time.back() - run.time.front()) / 60.0;
  return (log_likelihood(problem_of(seen, best), {}, noise) - log_likelihood(problem_of(seen, rival), {}, noise)) /
         minutes;
} catch (const std::exception&) {  // she cannot sail it
  return -HUGE_VAL;
}

struct Rival {
  std::string effect;
  Ship ship;
};

/// The rivals of the last finding; where it has none, the next best that was tried alone.
std::vector<Rival> rivals_of(const Trial& trial, const Search& s) {
  std::vector<Rival> rivals;
  for (std::size_t i = s.accepted.size(); i-- > 0 && rivals.empty();) {
    for (const auto& rival : s.accepted[i].rivals) {
      auto hypothesis = s.hypothesis(i);
      hypothesis.push_back(rival.form);
      rivals.push_back({rival.form->id, ship_at(trial, hypothesis, rival.fit.point)});
    }
  }
  if (!rivals.empty() || s.accepted.size() != 1) return rivals;
  for (const auto& t : s.first)
    if (t.form->id != s.accepted.front().form->id && rivals.empty())
      rivals.push_back({t.form->id, ship_at(trial, {t.form}, t.fit.point)});
  return rivals;
}

}  // namespace

std::optional<Advice> next_manoeuvre(const Trial& trial, const Search& s) {
  if (s.accepted.empty()) return std::nullopt;
  const auto rivals = rivals_of(trial, s);
  if (rivals.empty()) return std::nullopt;
  const auto best = ship_at(trial, s.hypothesis(), s.now.point);
  const auto manoeuvres = menu(trial.ship);
  std::vector<double> least(manoeuvres.size(), HUGE_VAL);
  in_parallel(manoeuvres.size(), 0, [&](std::size_t i) {
    for (const auto& rival : rivals)
      least[i] = std::min(least[i], separation(trial, manoeuvres[i], best, rival.ship, s.now.noise));
  });
  const auto most = static_cast<std::size_t>(std::ranges::max_element(least) - least.begin());
  if (!(least[most] > 0.0)) return std::nullopt;
  Advice advice{fmt::format("{}: it separates them by {} in log likelihood a minute", manoeuvres[most].words,
                            in_two_digits(least[most])),
                {s.accepted.back().form->id}};
  for (const auto& rival : rivals) advice.separates.push_back(rival.effect);
  return advice;
}

namespace {

/// Coordinate at which an effect gains that much log evidence, ½ D c² = gain.
double coordinate_shown(double D, double gain) { return std::sqrt(2.0 * gain / std::max(D, 1e-12)); }

}  // namespace

std::vector<DetectableSize> detectable_sizes(const Trial& trial, const Search& s, std::span<const EffectForm> forms,
                                             double detection) {
  std::vector<DetectableSize> sizes;
  const auto add = [&](const EffectForm& form, const Parameter& n, double D) {
    sizes.push_back({form.id, std::string(n.key), coordinate_shown(D, detection) * n.deviation});
  };
  for (const auto& form : forms) {
    if (std::ranges::count(sizes, form.id, &DetectableSize::effect))
      continue;  // the delay of the first channel stands for all
    const auto parameters = parameters_of(trial.ship, make_effect(form.id));
    const auto number = std::ranges::find_if(parameters, &Parameter::decides);
    const bool by_parts =
        std::ranges::any_of(parameters, &Parameter::direction) && !begins_and_ends(make_effect(form.id));
    const bool in_deviations = form.with_terms || (form.coordinates.size() == 1 && std::isfinite(number->null));
    if (!by_parts && !in_deviations) continue;  // a depth, an angle of stall or a lag: no size that grows from 0
    try {
      const auto D = information(trial, s.baseline, form);
      if (by_parts) add(form, *number, core::detail::principal_axes(D.topLeftCorner<2, 2>()).size.minCoeff());
      else
        for (std::size_t i = 0; i < form.coordinates.size(); ++i)
          add(form, form.with_terms ? parameters[i] : *number,
              D(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i)));
    } catch (const std::exception&) {}
  }
  return sizes;
}

}  // namespace swayaw::mismatch::detail
