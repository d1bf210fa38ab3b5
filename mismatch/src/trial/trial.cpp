#include "trial.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "other_values.hpp"
#include "swayaw/core/detail/matrices.hpp"
#include "swayaw/core/detail/recording_rows.hpp"
#include "swayaw/core/refusal.hpp"

namespace swayaw::inline mismatch::detail {

void put_prior(Trial& trial) {
  const auto size = trial.baseline_size();
  trial.mean = Eigen::VectorXd::Zero(size);
  trial.precision = Eigen::MatrixXd::Identity(size, size);
  auto at = std::ssize(trial.parameters);
  for (const auto& form : trial.ordinary)
    for (const auto& c : form.coordinates) {
      trial.mean[at] = c.centre;
      trial.precision(at, at) = 1.0 / (c.deviation * c.deviation);
      ++at;
    }
}

double heel_of(std::span<const PreparedRun> runs) {
  double squares = 0.0, time = 0.0;
  for (const auto& run : runs) {
    if (!run.run->has(Channel::phi)) continue;
    const double duration = run.run->time.back() - run.run->time.front();
    squares += run.heel * run.heel * duration, time += duration;
  }
  return time > 0.0 ? std::sqrt(squares / time) : 0.0;
}

bool explains_heel(const Trial& trial, const EffectForm& form) {
  return heel_of(trial.runs) > 0.0 && std::ranges::any_of(form.coordinates, &Coordinate::acts);
}

Hypothesis with(Hypothesis hypothesis, const EffectForm& form) {
  hypothesis.push_back(&form);
  return hypothesis;
}

Trial trial_of(const Ship& ship, std::span<const Recording> runs, std::span<const Channel> channels) {
  Trial trial{.ship = ship, .parameters = {}, .ordinary = {}, .mean = {}, .precision = {}, .runs = {}};
  for (const auto& n : parameters_of(ship))
    if (n.role == Role::coefficient && n.deviation > 0.0) trial.parameters.push_back(n);
  if (auto lift_loss = ordinary_lift_loss(ship)) trial.ordinary.push_back(*std::move(lift_loss));
  put_prior(trial);
  trial.runs = thinned_runs(ship, runs, channels);
  return trial;
}

namespace {

constexpr std::string_view windage = "windage";

/// A load of the wind, and the size of the ship that it goes with.
struct LoadOfWind {
  std::string_view key;
  double Windage<>::*goes_with;
};

constexpr std::array loads_of_wind{LoadOfWind{"wind_load_ahead", &Windage<>::A_F},
                                   LoadOfWind{"wind_load_across", &Windage<>::A_L},
                                   LoadOfWind{"wind_moment", &Windage<>::L_OA}};

/// Factors on what the wind does, of a ship whose windage is known. Wind coefficients of ships of one type spread by a
/// fifth.
std::vector<Parameter> factors_on_wind(const Ship& ship) {
  constexpr double spread = 0.2;
  std::vector<Parameter> factors;
  for (std::size_t i = 0; i < loads_of_wind.size(); ++i)
    if (const auto& [key, goes_with] = loads_of_wind[i]; ship.surroundings.windage.*goes_with > 0.0)
      factors.push_back({.name = std::string(key),
                         .table = windage,
                         .key = key,
                         .unit = "-",
                         .index = i,
                         .value = 1.0,
                         .range = positive,
                         .null = 1.0,
                         .deviation = spread});
  return factors;
}

/// Both halves of a run, each by itself, on its clock; nothing where they are too short to be more than a beginning, or
/// where one of them lacks a channel.
std::vector<Recording> halves_of(const Recording& run, double time_unit) {
  constexpr double least_length = 5.0;  // L/U: as long as a first turn takes to become steady
  if (run.time.back() - run.time.front() < 2.0 * least_length * time_unit) return {};
  const auto middle = run.samples() / 2;
  std::vector halves{core::detail::rows_of(run, 0, middle), core::detail::rows_of(run, middle, run.samples())};
  for (std::size_t i = 0; i < channel_count; ++i)
    for (const auto& half : halves)
      if (const auto channel = static_cast<Channel>(i); run.has(channel) && !half.has(channel)) return {};
  return halves;
}

}  // namespace

Trial as_on_board(Trial trial, std::span<const Recording> runs, std::span<const Channel> channels) {
  std::ranges::move(factors_on_wind(trial.ship), std::back_inserter(trial.parameters));
  for (auto& form : ordinary_forms(trial.ship, runs, channels)) trial.ordinary.push_back(std::move(form));
  put_prior(trial);
  trial.runs = lean_runs(trial.ship, runs, channels);
  if (runs.size() == 1)
    trial.halves = lean_runs(trial.ship, halves_of(runs.front(), time_unit_of(trial.ship)), channels);
  return trial;
}

namespace {

/// Whether a straight course at service speed tells it, on which every ship is tried: resistance and propeller. What
/// such a file has wrong in manoeuvres says nothing of these. Where they became as uncertain as the rest, a resistance
/// twice as large was 10 to 28 deviations of R_0 and had no name (three of six simulated ships with their shaft speed
/// recorded, and no reference runs).
bool is_told_straight_ahead(const Parameter& p) { return p.table == "propeller" || is_resistance(p); }

/// Parts of a ship that theory and tests of series tell, whatever her file says, and how well: standard deviation over
/// value. Nine times the deviations of a file let a fit find no added mass at all, 24 deviations off (J_z 1e-5 in place
/// of 0.010, a case as on board of seed 33); of the cubic damping of a hull nothing else is known.
constexpr std::array known_by_theory{std::string_view("added_mass"), std::string_view("rudder")};
constexpr double deviation_by_theory = 0.2;

/// By how much the deviation of a parameter may be taken for larger than her file has it.
double inflation_of(const Parameter& p, double factor) {
  if (is_told_straight_ahead(p)) return 1.0;
  if (p.null == 0.0 || std::ranges::count(known_by_theory, p.table) == 0) return factor;
  return std::clamp(deviation_by_theory * std::abs(p.null) / p.deviation, 1.0, factor);
}

}  // namespace

Trial with_inflated_prior(Trial trial, double factor) {
  Eigen::VectorXd factors = Eigen::VectorXd::Ones(trial.baseline_size());
  auto of_the_ship = std::ssize(trial.parameters);
  for (Eigen::Index i = 0; i < of_the_ship; ++i)
    factors[i] = inflation_of(trial.parameters[static_cast<std::size_t>(i)], factor);
  if (!trial.ordinary.empty() && takes_rudder_lift(trial.ordinary.front().id)) factors[of_the_ship] = factor;
  trial.precision = with_wider_prior(trial.precision, factors);
  return trial;
}

Eigen::MatrixXd with_wider_prior(const Eigen::MatrixXd& precision, const Eigen::VectorXd& factors) {
  const Eigen::VectorXd narrower = factors.cwiseInverse();
  return narrower.asDiagonal() * precision * narrower.asDiagonal();
}

double gain_by_prior(const EstimationProblem& problem, const MapFit& fit, const Eigen::MatrixXd& precision) {
  // −2 ln of the posterior is K + (p − p̂)ᵀA(p − p̂) with A = H + Λ; Λ' = Λ + D in place of Λ adds dᵀDd to it, d from the
  // mean, and the least of both lies dᵀDd − gᵀA'⁻¹g above K, where d is d̂ and g = Dd̂. What has come to its end stays
  // there: of g and A' the others count
  Eigen::MatrixXd other = problem.precision;
  other.topLeftCorner(precision.rows(), precision.cols()) = precision;
  const Eigen::MatrixXd A = fit.information + problem.precision, A_other = fit.information + other;
  const Eigen::VectorXd d = fit.point - problem.mean(), Dd = (other - problem.precision) * d;
  std::vector<Eigen::Index> moving;
  for (Eigen::Index i = 0; i < d.size(); ++i) {
    const auto& unknown = problem.unknowns[static_cast<std::size_t>(i)];
    if (unknown.low < fit.point[i] && fit.point[i] < unknown.high) moving.push_back(i);
  }
  using namespace core::detail;
  const Eigen::VectorXd g = Dd(moving);
  const double cost = d.dot(Dd) - g.dot(solve_symmetric(Eigen::MatrixXd(A_other(moving, moving)), g));
  return 0.5 * (log_determinant(other) - log_determinant(problem.precision) - log_determinant(A_other) +
                log_determinant(A) - cost);
}

namespace {

bool is_of_the_ship(std::string_view ordinary) { return ordinary == form_id || takes_rudder_lift(ordinary); }

}  // namespace

Eigen::Index ship_size(const Trial& trial) {
  auto size = std::ssize(trial.parameters);
  for (const auto& form : trial.ordinary)
    if (is_of_the_ship(form.id)) size += std::ssize(form.coordinates);
  return size;
}

std::vector<int> form_axes(const Trial& trial) {
  std::vector<int> axes(trial.parameters.size(), -1);
  for (const auto& form : trial.ordinary)
    for (const auto& c : form.coordinates) axes.push_back(form.id == form_id ? axis_of_term(c.name) : -1);
  return axes;
}

namespace {

Eigen::VectorXd form_factors(const Trial& trial, const FormSizes& sizes) {
  Eigen::VectorXd factors = Eigen::VectorXd::Ones(trial.baseline_size());
  const auto axes = form_axes(trial);
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (axes[i] >= 0) factors[static_cast<Eigen::Index>(i)] = sizes[static_cast<std::size_t>(axes[i])];
  return factors;
}

}  // namespace

Trial with_form_sizes(Trial usual, const FormSizes& sizes) {
  usual.precision = with_wider_prior(usual.precision, form_factors(usual, sizes));
  return usual;
}

LikelyForm likely_form(const Trial& usual, const Trial& now, const FormSizes& sizes, const Hypothesis& hypothesis,
                       const MapFit& fit) {
  // of the usual size; of simulated ships of another structure in which nothing was hidden the likeliest were 0.5 to 2
  constexpr double least = 1.0 / 64.0, most = 2.0;
  const auto problem = problem_of(now, hypothesis);
  LikelyForm best{sizes, 0.0};
  if (now.calibrated) return best;
  const auto try_size = [&](std::size_t axis, double factor) {
    auto other = best.sizes;
    other[axis] *= factor;
    if (other[axis] < least || other[axis] > (axis >= asymmetric_axis ? 1.0 : most)) return false;
    const double gain = gain_by_prior(problem, fit, with_wider_prior(usual.precision, form_factors(usual, other)));
    if (!(gain > best.gain)) return false;
    best = {other, gain};
    return true;
  };
  for (bool moved = true; moved;) {
    moved = false;
    for (std::size_t axis = 0; axis < best.sizes.size(); ++axis)
      for (const double factor : {0.5, 2.0})
        while (try_size(axis, factor)) moved = true;
  }
  return best;
}

// ---------------------------------------------------------------- unknowns

namespace {

/// A coefficient of the baseline, in its deviations from the value of the ship file, kept to its range.
Unknown unknown_of(const Parameter& p, double mean) {
  constexpr double clear = 1e-3;  // deviations from an end that is itself refused
  const auto in_deviations = [&](double value) { return (value - p.value) / p.deviation; };
  return {.name = p.name,
          .mean = mean,
          .low = in_deviations(p.range.low) + (p.range.above_low ? clear : 0.0),
          .high = in_deviations(p.range.high)};
}

/// Its value at a coordinate, rounding kept out of what is refused.
double value_at(const Parameter& p, double c) {
  return std::clamp(p.value + p.deviation * c, p.range.low, p.range.high);
}

Unknown unknown_of(const Coordinate& c) {
  return {.name = c.name, .mean = c.centre, .low = c.low, .high = c.high, .step = c.step};
}

}  // namespace

Eigen::Index place_in_point(const Trial& trial, const Hypothesis& hypothesis, std::size_t effect) {
  auto place = trial.baseline_size();
  for (std::size_t i = 0; i < effect; ++i) place += std::ssize(hypothesis[i]->coordinates);
  return place;
}

namespace {

/// Whether it is a filter, which makes its channel late by its time.
bool is_lag(const EffectForm& form) { return form.id == ChannelFilter<>::id; }

}  // namespace

bool is_same_effect(const EffectForm& a, const EffectForm& b) { return a.id == b.id && channel_of(a) == channel_of(b); }

bool stands_for(const EffectForm& form, const EffectForm& ordinary) {
  if (takes_rudder_lift(form.id) && takes_rudder_lift(ordinary.id)) return true;
  if (is_lag(form) && ordinary.id == ChannelDelay<>::id) return channel_of(form) == channel_of(ordinary);
  return form.id != form_id && is_same_effect(form, ordinary);
}

std::vector<OrdinaryPlace> ordinary_places(const Trial& trial) {
  std::vector<OrdinaryPlace> places;
  auto first = std::ssize(trial.parameters);
  for (const auto& form : trial.ordinary) {
    places.push_back({&form, first});
    first += std::ssize(form.coordinates);
  }
  return places;
}

std::vector<Eigen::Index> replaced_by(const Trial& trial, const EffectForm& form) {
  std::vector<Eigen::Index> replaced;
  for (const auto& o : ordinary_places(trial))
    if (stands_for(form, *o.form))
      for (Eigen::Index i = 0; i < o.size(); ++i) replaced.push_back(o.first + i);
  return replaced;
}

std::optional<Effect> in_whose_place(const Trial& trial, const EffectForm& form, const Point& point) {
  for (const auto& o : ordinary_places(trial))
    if (stands_for(form, *o.form) && form.id == o.form->id) return o.form->at(o.coordinates(point));
  return std::nullopt;
}

EstimationProblem problem_of(const Trial& trial, const Hypothesis& hypothesis) {
  const auto base = trial.baseline_size();
  std::vector<Unknown> unknowns;
  for (std::size_t i = 0; i < trial.parameters.size(); ++i)
    unknowns.push_back(unknown_of(trial.parameters[i], trial.mean[static_cast<Eigen::Index>(i)]));
  for (const auto& form : trial.ordinary)
    for (const auto& c : form.coordinates) {
      unknowns.push_back(unknown_of(c));
      unknowns.back().mean = trial.mean[std::ssize(unknowns) - 1];
    }
  std::vector<double> deviations;
  for (const auto* form : hypothesis)
    for (const auto& c : form->coordinates) unknowns.push_back(unknown_of(c)), deviations.push_back(c.deviation);
  const auto size = std::ssize(unknowns);
  Eigen::MatrixXd precision = Eigen::MatrixXd::Zero(size, size);
  precision.topLeftCorner(base, base) = trial.precision;
  for (std::size_t i = 0; i < deviations.size(); ++i) {
    const auto k = base + static_cast<Eigen::Index>(i);
    precision(k, k) = 1.0 / (deviations[i] * deviations[i]);
  }
  return {.unknowns = std::move(unknowns),
          .precision = std::move(precision),
          .runs = trial.runs,
          .ship_in = [&trial, hypothesis](
                         const Point& point,
                         std::size_t run) { return ship_at(trial, hypothesis, point, trial.runs[run].run.get()); },
          .scale = trial.ship};
}

EstimationProblem problem_of(const Trial& trial, const Ship& ship) {
  return {.unknowns = {},
          .precision = {},
          .runs = trial.runs,
          .ship_in = [ship](const Point&, std::size_t) { return ship; },
          .scale = trial.ship};
}

namespace {

/// The number of an ordinary error that decides, and which of its parameters it is.
struct UsualNumber {
  std::size_t index;
  double centre;      ///< null, or what reference runs told
  double departure;   ///< from there, of usual size
  double decided_in;  ///< as many count as one
};

std::optional<UsualNumber> usual_number(const Trial& trial, const EffectForm& form) {
  for (const auto& o : trial.ordinary) {
    if (o.id == form_id || !stands_for(form, o) || form.id != o.id) continue;
    std::vector<double> c(o.coordinates.size(), 0.0);
    const auto& told = o.coordinates.front();
    c.front() = told.centre;
    const auto centre = parameters_of(trial.ship, o.at(c));
    c.front() = told.centre + told.deviation;
    const auto usual = parameters_of(trial.ship, o.at(c));
    for (std::size_t i = 0; i < usual.size(); ++i)
      if (usual[i].decides && usual[i].value != centre[i].value && std::isfinite(usual[i].value))
        return UsualNumber{i, centre[i].value, usual[i].value - centre[i].value, o.decided_in};
  }
  return std::nullopt;
}

/// Whether an effect does what the ordinary error in whose place it stands cannot: a largest rate beside a lag.
bool does_more_than_usual(const Trial& trial, const EffectForm& form, const Effect& effect) {
  const auto usual = usual_number(trial, form);
  const auto parameters = parameters_of(trial.ship, effect);
  for (std::size_t i = 0; i < parameters.size(); ++i)
    if (!(usual && i == usual->index) && parameters[i].value != parameters[i].null) return true;
  return false;
}

double ordinary_deviations(const Trial& trial, const EffectForm& form, const Effect& effect) {
  const auto stands_here = [&](const EffectForm& o) { return stands_for(form, o); };
  // whatever reference runs tell of delays: what filters do besides is part of no baseline
  if (const auto* filter = std::get_if<ChannelFilter<>>(&effect);
      filter && std::ranges::any_of(trial.ordinary, stands_here))
    return beyond_the_ordinary * filter->time / filter_delay(trial.ship);
  const auto usual = usual_number(trial, form);
  if (!usual) return HUGE_VAL;
  const auto is = parameters_of(trial.ship, effect)[usual->index];
  return std::abs((is.value - usual->centre) / (usual->decided_in * usual->departure));
}

/// Everything ordinary that no effect stands for.
std::vector<OrdinaryPlace> still_ordinary(const Trial& trial, const Hypothesis& hypothesis) {
  auto places = ordinary_places(trial);
  std::erase_if(places, [&](const OrdinaryPlace& o) {
    return std::ranges::any_of(hypothesis, [&](const EffectForm* h) { return stands_for(*h, *o.form); });
  });
  return places;
}

Effect ordinary_at(const OrdinaryPlace& o, const Point& point) {
  const auto c = o.coordinates(point);
  std::vector<double> within(c.begin(), c.end());
  for (std::size_t i = 0; i < within.size(); ++i)
    within[i] = std::clamp(within[i], o.form->coordinates[i].low, o.form->coordinates[i].high);
  return o.form->at(within);
}

/// What of another form goes with the rudder angle is a force of the rudder: where its lift has another factor, that
/// has it, too. Reference runs told the form of a rudder with all its lift.
void weaken_with_rudder(std::vector<Effect>& effects) {
  double factor = 1.0;
  for (const auto& effect : effects)
    if (const auto* rudder = std::get_if<RudderEffectiveness<>>(&effect)) factor *= rudder->factor;
  if (factor == 1.0) return;
  for (auto& effect : effects)
    if (auto* form = std::get_if<ModelForm<>>(&effect))
      for (double* term : {&form->X_dd, &form->Y_d, &form->Y_d15, &form->Y_a28, &form->Y_Rg, &form->Y_Rw, &form->N_d,
                           &form->N_d15, &form->N_a28})
        *term *= factor;
}

}  // namespace

Ship bare_ship_at(const Trial& trial, const Point& point) {
  std::vector<double> values;
  for (std::size_t i = 0; i < trial.parameters.size(); ++i)
    values.push_back(value_at(trial.parameters[i], point[static_cast<Eigen::Index>(i)]));
  const auto factors = std::ranges::find(trial.parameters, windage, &Parameter::table);  // after those of her model
  const auto of_model = static_cast<std::size_t>(factors - trial.parameters.begin());
  Ship ship = with_values(trial.ship, std::span(trial.parameters).first(of_model), std::span(values).first(of_model));
  for (std::size_t i = of_model; i < values.size(); ++i)
    ship.surroundings.windage.*loads_of_wind[trial.parameters[i].index].goes_with *= values[i];
  return ship;
}

Ship ship_with(const Trial& trial, const Hypothesis& hypothesis, const Point& point, const Recording* run,
               const WantedEffect& wanted) {
  Ship ship = bare_ship_at(trial, point);
  const auto add = [&](Effect effect, bool ordinary) {
    if (wanted(effect, ordinary)) ship.effects.push_back(std::move(effect));
  };
  for (const auto& o : still_ordinary(trial, hypothesis)) add(ordinary_at(o, point), true);
  Eigen::Index next = trial.baseline_size();
  for (const auto* form : hypothesis) {
    const std::span c{point.data() + next, form->coordinates.size()};
    const auto there = run ? form->in_part(c, form->part_of(*run)) : mean_of_parts(*form, c);
    add(effect_beside(trial, form->at(there), ship), false);
    next += std::ssize(c);
  }
  weaken_with_rudder(ship.effects);
  return ship;
}

Ship ship_at(const Trial& trial, const Hypothesis& hypothesis, const Point& point, const Recording* run) {
  return ship_with(trial, hypothesis, point, run, [](const Effect&, bool) { return true; });
}

Ship model_at(const Trial& trial, const Hypothesis& hypothesis, const Point& point) {
  return ship_with(trial, hypothesis, point, nullptr,
                   [](const Effect& e, bool ordinary) { return !ordinary || is_of_the_ship(id_of(e)); });
}

double ordinary_size(const Trial& trial, const EffectForm& form) {
  const auto usual = usual_number(trial, form);
  return usual ? std::abs(usual->departure) : 0.0;
}

double ordinary_deviations(const Trial& trial, const EffectForm& form, std::span<const double> coordinates) {
  const auto has_less = [&](const EffectForm& o) { return stands_for(form, o) && o.common() < form.common(); };
  const bool has_more = std::ranges::any_of(trial.ordinary, has_less);
  double most = 0.0;
  for (const auto& effect : effects_in_parts(form, coordinates)) {
    if (has_more && does_more_than_usual(trial, form, effect)) return HUGE_VAL;
    most = std::max(most, ordinary_deviations(trial, form, effect));
  }
  return most;
}

std::vector<OrdinaryEstimate> ordinary_instruments(const Trial& trial, const Hypothesis& hypothesis,
                                                   const MapFit& fit) {
  std::vector<OrdinaryEstimate> found;
  for (const auto& o : still_ordinary(trial, hypothesis)) {
    const auto effect = ordinary_at(o, fit.point);
    if (o.size() != 1 || place_of(effect) != EffectPlace::sensor) continue;
    const auto is = parameters_of(trial.ship, effect), one = parameters_of(trial.ship, o.form->at(std::vector{1.0}));
    const auto i =
        static_cast<std::size_t>(std::ranges::find(is, o.form->coordinates.front().name, &Parameter::key) - is.begin());
    found.push_back({effect, is[i].value - is[i].null,
                     std::abs(one[i].value - one[i].null) * std::sqrt(fit.covariance(o.first, o.first)), is[i].key});
  }
  return found;
}

Point with_start(const Point& before, std::span<const double> last_start) {
  Point point(before.size() + std::ssize(last_start));
  point << before, Eigen::Map<const Eigen::VectorXd>(last_start.data(), std::ssize(last_start));
  return point;
}

// ---------------------------------------------------------------- estimation

MapFit fit(const Trial& trial, const Hypothesis& hypothesis, const Point& start, const Noise& noise,
           const FitOptions& options) {
  return fit(problem_of(trial, hypothesis), start, noise, trial.baseline_size(), options);
}

LinearizedFit linearized(const Trial& trial, const Hypothesis& accepted, const MapFit& fit) {
  return linearized(problem_of(trial, accepted), fit);
}

PredictedGain predicted_gain(const Trial& trial, const Hypothesis& accepted, const LinearizedFit& before,
                             const EffectForm& form, std::span<const double> start, int iterations) {
  Hypothesis hypothesis = accepted;
  hypothesis.push_back(&form);
  return predicted_gain(problem_of(trial, hypothesis), before, start, iterations);
}

Eigen::MatrixXd information(const Trial& trial, const LinearizedFit& baseline, const EffectForm& form) {
  constexpr double step = 0.1;  // of coordinates whose usual size is 1
  std::vector<double> null;
  for (const auto& c : form.coordinates) null.push_back(c.centre);
  const auto J = further_slopes(problem_of(trial, {&form}), baseline, null, step);
  return J.transpose() * baseline.projected(J);
}

}  // namespace swayaw::mismatch::detail
