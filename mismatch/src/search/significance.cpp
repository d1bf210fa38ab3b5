#include "significance.hpp"

#include <algorithm>
#include <cmath>

#include "../trial/other_values.hpp"
#include "ranking.hpp"
#include "swayaw/core/detail/matrices.hpp"

namespace swayaw::inline mismatch::detail {
using namespace core::detail;
namespace {

constexpr double told_from_nothing = 4.0;  ///< squared standard deviations

/// The same of one part of the runs.
bool is_told_in(const Ship& ship, const EffectForm& form, const MapFit& found, const Eigen::MatrixXd& part) {
  const auto size = std::ssize(form.coordinates);
  const Point c = part * found.point.tail(size);
  const auto parameters = parameters_of(ship, form.at({c.data(), static_cast<std::size_t>(c.size())}));
  std::vector<Eigen::Index> deciding;
  std::vector<double> departures;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (!parameters[i].decides) continue;
    if (!std::isfinite(parameters[i].value - parameters[i].null)) return true;
    deciding.push_back(static_cast<Eigen::Index>(i)), departures.push_back(parameters[i].value - parameters[i].null);
  }
  const Eigen::MatrixXd slopes = parameter_slopes(ship, form, c)(deciding, Eigen::all) * part;
  const Eigen::MatrixXd C = slopes * widened(form, found.covariance.bottomRightCorner(size, size)) * slopes.transpose();
  const Eigen::Map<const Eigen::VectorXd> z(departures.data(), std::ssize(departures));
  return !(z.dot(least_norm(C, z)) < told_from_nothing);
}

}  // namespace

Eigen::VectorXd precision_of(const EffectForm& form) {
  Eigen::VectorXd deviation(std::ssize(form.coordinates));
  std::ranges::transform(form.coordinates, deviation.begin(), &Coordinate::deviation);
  return deviation.array().square().inverse();
}

namespace {

Eigen::MatrixXd widened_precision(const Eigen::MatrixXd& prior, const Eigen::MatrixXd& covariance) {
  return prior + (inverse(covariance) - prior) / evidence_excess;
}

}  // namespace

Eigen::MatrixXd widened_precision(const EffectForm& form, const Eigen::MatrixXd& covariance) {
  return widened_precision(Eigen::MatrixXd(precision_of(form).asDiagonal()), covariance);
}

Eigen::MatrixXd widened(const EffectForm& form, const Eigen::MatrixXd& covariance) {
  return inverse(widened_precision(form, covariance));
}

Eigen::MatrixXd widened(const Eigen::MatrixXd& prior, const Eigen::MatrixXd& covariance) {
  return inverse(widened_precision(prior, covariance));
}

bool is_told(const Ship& ship, const EffectForm& form, const MapFit& found) {
  for (std::size_t part = 0; part < std::max<std::size_t>(1, form.parts.size()); ++part)
    if (is_told_in(ship, form, found, part_map(form, part))) return true;
  return false;
}

Eigen::MatrixXd covariance_with_own(const Trial& trial, const EffectForm& form, const MapFit& found, Eigen::Index from,
                                    const Eigen::MatrixXd& slopes, const OwnValues& own) {
  const auto size = std::ssize(form.coordinates), moved = std::ssize(own.moved);
  auto places = own.moved;
  for (Eigen::Index i = 0; i < size; ++i) places.push_back(from + i);
  Eigen::MatrixXd prior = Eigen::MatrixXd::Zero(moved + size, moved + size);
  if (moved > 0) prior.topLeftCorner(moved, moved) = inverse(inverse(trial.precision)(own.moved, own.moved));
  prior.bottomRightCorner(size, size) = precision_of(form).asDiagonal();
  Eigen::MatrixXd all(slopes.rows(), moved + size);
  all << own.slopes, slopes;
  return all * widened(prior, found.covariance(places, places)) * all.transpose();
}

bool is_told_from_file(const Trial& trial, const EffectForm& form, const MapFit& found, Eigen::Index from) {
  const Eigen::MatrixXd mean = mean_part_map(form);
  const Point c = mean * found.point.segment(from, std::ssize(form.coordinates));
  const auto effect = form.at({c.data(), static_cast<std::size_t>(c.size())});
  if (!counts_from_own(effect)) return true;
  const auto parameters = parameters_of(trial.ship, effect);
  const auto own = own_values(trial, effect, found.point);
  std::vector<Eigen::Index> deciding;
  Eigen::VectorXd departures = own.off;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto place = static_cast<Eigen::Index>(i);
    departures[place] += parameters[i].value - parameters[i].null;
    if (parameters[i].decides) deciding.push_back(place);
  }
  const Eigen::MatrixXd slopes = parameter_slopes(trial.ship, form, c) * mean,
                        C = covariance_with_own(trial, form, found, from, slopes, own)(deciding, deciding);
  const Eigen::VectorXd z = departures(deciding);
  return !(z.dot(least_norm(C, z)) < told_from_nothing);
}

bool is_as_ordinary(const Trial& trial, const EffectForm& form, const Point& point, Eigen::Index first) {
  const auto deviations = ordinary_deviations(trial, form, {point.data() + first, form.coordinates.size()});
  const bool is_early =
      form.id == ChannelDelay<>::id && point[first] < 0.0;  // no earlier than is ordinary: `keep_from_early`
  return deviations < beyond_the_ordinary || (is_early && std::isfinite(deviations));
}

bool is_told_by_itself(const Search& s, const Accepted& accepted, double needed) {
  const auto gains_alone = [&](const FittedCandidate& alone) {
    return alone.form->id == accepted.form->id && whole_gain(alone) > needed;
  };
  return whole_gain(accepted) > clearly * needed || std::ranges::any_of(s.first, gains_alone);
}

ActiveTime active_time(const Trial& trial, const Search& s, std::size_t accepted, double needed) {
  const auto with = problem_of(trial, s.hypothesis());
  auto without = with;
  without.ship_in = [&](const Point& point, std::size_t run) {
    return without_accepted(with.ship_in(point, run), s, accepted);
  };
  struct Sample {
    double time, gain;
  };
  std::vector<Sample> samples;
  try {
    const auto a = log_likelihoods(with, s.now.point, s.now.noise),
               b = log_likelihoods(without, s.now.point, s.now.noise);
    for (std::size_t i = 0; i < a.size(); ++i)
      for (std::size_t k = 0; k < a[i].size(); ++k) samples.push_back({trial.runs[i].run->time[k], a[i][k] - b[i][k]});
  } catch (const std::exception&) {
    return {};
  }
  std::ranges::stable_sort(samples, {}, &Sample::time);
  const double settled = 2.0 * time_unit_of(trial.ship), first = samples.front().time + settled,
               last = samples.back().time - settled;
  // where the running sum of the gains is least, the effect begins; from the other side, it ends
  const auto least = [&](auto begin, auto end) {
    double sum = 0.0, lowest = -needed;
    std::optional<double> time;
    for (auto i = begin; i != end; ++i) {
      sum += i->gain;
      if (sum < lowest) lowest = sum, time = i->time;
    }
    return time;
  };
  ActiveTime time_active{least(samples.begin(), samples.end()), least(samples.rbegin(), samples.rend())};
  if (time_active.onset && (*time_active.onset < first || *time_active.onset > last)) time_active.onset.reset();
  if (time_active.end && (*time_active.end > last || *time_active.end < first)) time_active.end.reset();
  if (time_active.onset && time_active.end && !(*time_active.onset < *time_active.end)) return {};
  return time_active;
}

}  // namespace swayaw::mismatch::detail
