#include "fleet_class.hpp"

#include <algorithm>
#include <cmath>

#include "swayaw/core/detail/matrices.hpp"
#include "swayaw/core/refusal.hpp"

namespace swayaw::inline mismatch::detail {
namespace {

/// What may change in months of service, of a hull, a rudder and of instruments that somebody sets or replaces.
constexpr std::array watched_ids{RudderOffset<>::id, RudderEffectiveness<>::id, AddedResistance<>::id,
                                 LogScale<>::id,     GyroScale<>::id,           GyroBias<>::id,
                                 HeadingBias<>::id};

/// Wide about null to both sides, for resistances also fall.
EffectForm to_both_sides(EffectForm form) {
  auto& c = form.coordinates.front();
  c.low = std::max(c.low, -std::abs(c.high));
  if (form.id == AddedResistance<>::id) c.low = -1.0;
  return form;
}

/// The trial of a class with the runs of a day.
Trial trial_of_day(const ClassTrial& whole, const Day& day) {
  Trial trial = whole.trial;
  trial.runs.clear();
  for (const auto run : day.runs) trial.runs.push_back(whole.trial.runs[run]);
  return trial;
}

/// The likelihood of the runs about a point: residuals that are linear in the coordinates.
void linearize(Day& day, const ClassTrial& whole, const Trial& trial, const Point& point) {
  const auto linear = linearized(trial, {}, {.point = point, .noise = day.noise});
  const Eigen::MatrixXd& A = linear.information;
  day.all = {A, A * (point - trial.mean) - linear.slopes.transpose() * linear.residuals, 0.0};
  Eigen::MatrixXd L = Eigen::MatrixXd::Zero(A.rows(), std::ssize(whole.of_a_day));
  for (std::size_t i = 0; i < whole.of_a_day.size(); ++i) {
    const auto place = whole.of_a_day[i];
    L(place, static_cast<Eigen::Index>(i)) = 1.0 / std::sqrt(trial.precision(place, place));
  }
  const auto eliminated = blurred(day.all, L);
  day.told = {eliminated.A(whole.kept, whole.kept), eliminated.b(whole.kept), eliminated.c};
}

/// A point of the trial with these coordinates that are kept, what is of a day at its mean.
Point whole_point(const ClassTrial& whole, const Eigen::VectorXd& kept) {
  Point point = whole.trial.mean;
  point(whole.kept) += kept.head(whole.size());
  return point;
}

}  // namespace

bool is_watched(std::string_view id) { return std::ranges::count(watched_ids, id) > 0; }

bool is_of_a_day(const Effect& effect) {
  const auto place = place_of(effect);
  return place == EffectPlace::air || place == EffectPlace::water || place == EffectPlace::sensor;
}

const Parameter& moved_parameter(const std::vector<Parameter>& parameters) {
  return *std::ranges::find_if(parameters, [](const Parameter& p) { return p.decides; });
}

double parameter_at(const Ship& ship, const EffectForm& form, double c) {
  return moved_parameter(parameters_of(ship, form.at(std::array{c}))).value;
}

double parameter_slope(const Ship& ship, const EffectForm& form, double c) {
  constexpr double step = 1e-3;
  return (parameter_at(ship, form, c + step) - parameter_at(ship, form, c - step)) / (2.0 * step);
}

ClassTrial class_trial(const Ship& ship, std::span<const Recording> runs) {
  const auto channels = recorded_channels(runs, motion_channels());
  ClassTrial result{
      .trial = as_on_board(trial_of(ship, runs, channels), runs, channels), .kept = {}, .watched = {}, .of_class = {}};
  auto& trial = result.trial;
  const auto forms = effect_forms(ship, channels, 1.0);
  for (const auto id : watched_ids) {
    const auto form = std::ranges::find(forms, id, &EffectForm::id);
    if (form == forms.end() || form->coordinates.size() != 1) continue;
    const auto there = std::ranges::find(trial.ordinary, id, &EffectForm::id);
    if (place_of(form->at(std::array{0.0})) == EffectPlace::sensor && there == trial.ordinary.end()) continue;
    if (there != trial.ordinary.end()) *there = to_both_sides(*form);
    else trial.ordinary.push_back(to_both_sides(*form));
  }
  put_prior(trial);
  std::vector<double> deviations(trial.parameters.size(), 1.0);
  for (Eigen::Index i = 0; i < std::ssize(trial.parameters); ++i) result.kept.push_back(i);
  Eigen::Index next = std::ssize(trial.parameters);
  for (const auto& form : trial.ordinary) {
    const std::vector<double> null(form.coordinates.size(), 0.0);
    const bool followed = is_watched(form.id);
    if (followed) {
      const auto parameters = parameters_of(ship, form.at(null));
      const double slope = parameter_slope(ship, form, form.coordinates.front().centre);
      result.watched.push_back({form, std::ssize(result.kept), form.coordinates.front().deviation,
                                moved_parameter(parameters).floor / std::abs(slope)});
    }
    const auto effect = form.at(null);
    const bool kept = followed || !is_of_a_day(effect);
    // no instrument errs alike on all sisters
    const bool shared = !followed || place_of(effect) != EffectPlace::sensor;
    for (const auto& c : form.coordinates) {
      if (kept) deviations.push_back(shared ? c.deviation : 0.0);
      (kept ? result.kept : result.of_a_day).push_back(next++);
    }
  }
  result.of_class = Eigen::Map<const Eigen::VectorXd>(deviations.data(), std::ssize(deviations));
  return result;
}

void fit_day(Day& day, const ClassTrial& whole) {
  const auto trial = trial_of_day(whole, day);
  const auto found = fit(trial, {}, trial.mean, Noise::on_board());
  if (found.point.size() == 0) throw Refusal("the ship cannot sail them");
  day.noise = found.noise;
  linearize(day, whole, trial, found.point);
}

void move_day(Day& day, const ClassTrial& whole, const Eigen::VectorXd& kept) {
  const auto trial = trial_of_day(whole, day);
  const Eigen::MatrixXd A =
      day.all.A(whole.of_a_day, whole.of_a_day) + Eigen::MatrixXd(trial.precision(whole.of_a_day, whole.of_a_day));
  const Eigen::VectorXd b = day.all.b(whole.of_a_day) - day.all.A(whole.of_a_day, whole.kept) * kept;
  Point point = whole_point(whole, kept);
  point(whole.of_a_day) += core::detail::solve_symmetric(A, b);
  const auto problem = problem_of(trial, Hypothesis{});
  point = problem.within_bounds(point);
  // what the numbers of the day alone had taken in is noise now
  day.noise = best_noise(problem, point, day.noise, true).noise;
  linearize(day, whole, trial, point);
}

Ship ship_of(const ClassTrial& whole, const Eigen::VectorXd& kept, const std::function<bool(std::string_view)>& has) {
  return ship_with(whole.trial, {}, whole_point(whole, kept), nullptr, [&](const Effect& effect, bool) {
    const auto id = id_of(effect);
    return is_watched(id) ? has(id) : !is_of_a_day(effect);
  });
}

}  // namespace swayaw::mismatch::detail
