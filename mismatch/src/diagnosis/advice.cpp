#include "advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "../search/significance.hpp"
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

/// Deviations by which a size must exceed the least that is named, for it to be named in nine of ten recordings like
/// these.
constexpr double in_nine_of_ten = 1.28;

/// Prior deviations beyond which no effect is: runs that would show only such a size do not tell it.
constexpr double larger_than_any = 4.0;

/// A direction in the coordinates of an effect, and the parameter that tells how far it goes there.
struct Growth {
  Eigen::VectorXd direction;
  std::size_t parameter;
};

Point coordinates_at(const EffectForm& form, const Growth& growth, double c) {
  Point point = c * growth.direction;
  for (std::size_t i = 0; i < form.coordinates.size(); ++i)
    point[static_cast<Eigen::Index>(i)] += form.coordinates[i].centre;
  return point;
}

/// The first place that is too large to be a trace or ordinary.
double least_that_counts(const Trial& trial, const EffectForm& form, const Growth& growth) {
  const auto counts = [&](double c) {
    const Point point = coordinates_at(form, growth, c);
    return is_finding(trial.ship, form, {point.data(), form.coordinates.size()}) &&
           !is_as_ordinary(trial, form, point, 0);
  };
  constexpr double close_enough = 0.01;
  double low = 0.0, high = larger_than_any;
  if (!counts(high)) return HUGE_VAL;
  while (high - low > close_enough * high) (counts(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
  return high;
}

/// Coordinate c at which an effect is found in nine of ten recordings. With information d and prior deviation p its
/// estimate is normal about c with variance 1/d and gains
///
///     ½ d² p²/(1 + d p²) ĉ² − ½ ln(1 + d p²)
///
/// in log evidence; this must be what detection needs, and ĉ large enough to count.
double found_in_nine_of_ten(double d, double p, double detection, double counts) {
  const double k = d * p * p;
  const double gains = std::sqrt((2.0 * detection + std::log1p(k)) * (1.0 + k) / (k * d));
  return std::max(gains, counts) + in_nine_of_ten / std::sqrt(d);
}

/// The largest process noise that the runs allow: they are half as likely as with what was found.
Noise largest_noise(const Trial& trial, const MapFit& fit) {
  const auto problem = problem_of(trial, Hypothesis{});
  const auto scaled = [&](double scale) {
    auto noise = fit.noise;
    noise.scale = scale;
    return noise;
  };
  const double least = log_likelihood(problem, fit.point, fit.noise) - std::numbers::ln2;
  const auto is_allowed = [&](double scale) { return log_likelihood(problem, fit.point, scaled(scale)) >= least; };
  constexpr double finer_than_any = 1e-3, ratio = 1.25;
  double scale = std::max(fit.noise.scale, finer_than_any);
  while (scale < ordinary_scale && is_allowed(ratio * scale)) scale *= ratio;
  return scaled(scale);
}

bool has_direction(std::span<const Parameter> parameters) {
  return std::ranges::any_of(parameters, &Parameter::direction);
}

/// Whether it has one size that grows from nothing, unlike a depth, an angle of stall or a lag.
bool grows(const EffectForm& form, std::span<const Parameter> parameters) {
  if (has_direction(parameters)) return !begins_and_ends(make_effect(form.id));
  return form.with_terms ||
         (form.coordinates.size() == 1 && std::isfinite(std::ranges::find_if(parameters, &Parameter::decides)->null));
}

/// How an effect grows: what blows or flows from where it shows least, terms of a group parameter by parameter.
std::vector<Growth> growths_of(const Trial& trial, const EffectForm& form, std::span<const Parameter> parameters,
                               const Eigen::MatrixXd& D) {
  const auto number =
      static_cast<std::size_t>(std::ranges::find_if(parameters, &Parameter::decides) - parameters.begin());
  const auto size = D.rows();
  std::vector<Growth> growths;
  if (has_direction(parameters)) {
    const auto axes = core::detail::principal_axes(D.topLeftCorner<2, 2>());
    Eigen::Index least;
    axes.size.minCoeff(&least);
    growths.push_back({Eigen::VectorXd::Zero(size), number});
    growths.back().direction.head<2>() = axes.axis.col(least);
  } else if (form.with_terms) {
    // one side of a coefficient alone is a part of what both have and a part of what they differ by
    Eigen::MatrixXd deviations = parameter_slopes(trial.ship, form, Eigen::VectorXd::Zero(size));
    for (Eigen::Index i = 0; i < deviations.rows(); ++i)
      deviations.row(i) /= parameters[static_cast<std::size_t>(i)].deviation;
    for (Eigen::Index i = 0; i < deviations.rows(); ++i)
      growths.push_back({core::detail::least_norm(deviations, Eigen::VectorXd::Unit(deviations.rows(), i)).normalized(),
                         static_cast<std::size_t>(i)});
  } else {
    growths.push_back({Eigen::VectorXd::Unit(size, 0), number});
  }
  return growths;
}

/// @return nothing where it is larger than any, or than it can be
std::optional<DetectableSize> size_along(const Trial& trial, const EffectForm& form, const Growth& growth,
                                         const Eigen::MatrixXd& D, double detection) {
  Eigen::Index axis;
  growth.direction.cwiseAbs().maxCoeff(&axis);
  const double d = growth.direction.dot(D * growth.direction);
  const double c = found_in_nine_of_ten(d, form.coordinates[static_cast<std::size_t>(axis)].deviation, detection,
                                        least_that_counts(trial, form, growth));
  if (!(c <= larger_than_any)) return std::nullopt;
  const Point point = coordinates_at(form, growth, c);
  const auto p = parameters_of(trial.ship, form.at({point.data(), form.coordinates.size()})).at(growth.parameter);
  if (p.value < p.range.low || p.value > p.range.high) return std::nullopt;
  return DetectableSize{form.id, std::string(p.key), std::abs(p.value - p.null)};
}

}  // namespace

std::vector<DetectableSize> detectable_sizes(const Trial& trial, const Search& s, std::span<const EffectForm> forms,
                                             double detection) {
  auto null = s.null;
  null.noise = largest_noise(trial, s.null);
  const auto baseline = linearized(trial, {}, null);
  // terms of a group stand in the place of her own coefficients, which may be further off than was said
  const auto less_sure = with_inflated_prior(trial, inflation_step);
  const auto less_sure_baseline = with_prior_of(problem_of(less_sure, Hypothesis{}), baseline);
  std::vector<DetectableSize> sizes;
  for (const auto& form : forms) {
    if (std::ranges::count(sizes, form.id, &DetectableSize::effect))
      continue;  // the delay of the first channel stands for all
    const auto parameters = parameters_of(trial.ship, make_effect(form.id));
    if (!grows(form, parameters)) continue;
    try {
      const auto D =
          form.with_terms ? information(less_sure, less_sure_baseline, form) : information(trial, baseline, form);
      for (const auto& growth : growths_of(trial, form, parameters, D))
        if (auto size = size_along(trial, form, growth, D, detection)) sizes.push_back(*std::move(size));
    } catch (const std::exception&) {}  // she cannot sail with it
  }
  return sizes;
}

}  // namespace swayaw::mismatch::detail
