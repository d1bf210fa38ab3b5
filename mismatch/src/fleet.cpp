#include "swayaw/mismatch/fleet.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <numeric>
#include <optional>

#include "effect_forms.hpp"
#include "linear_gaussian.hpp"
#include "swayaw/core/detail/matrices.hpp"
#include "swayaw/core/parallel.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/core/run_remark.hpp"
#include "swayaw/mismatch/compare.hpp"
#include "trial.hpp"

namespace swayaw::inline mismatch {
using namespace detail;

std::string_view name_of(ChangeShape shape) { return shape == ChangeShape::sudden ? "sudden" : "gradual"; }

double VesselReport::worst() const {
  double most = 0.0;
  for (const auto& c : changes) most = std::max(most, c.floors);
  for (const auto& d : differences) most = std::max(most, d.floors);
  return most;
}

std::string date_text(double day) {
  constexpr double seconds_of_a_day = 86400.0;
  return fmt::format("{:%Y-%m-%d}", fmt::gmtime(static_cast<std::time_t>(std::floor(day) * seconds_of_a_day)));
}

namespace {

// ---------------------------------------------------------------- coordinates

/// What may change in months of service, of a hull, a rudder and of instruments that somebody sets or replaces.
constexpr std::array watched_ids{RudderOffset<>::id, RudderEffectiveness<>::id, AddedResistance<>::id,
                                 LogScale<>::id,     GyroScale<>::id,           GyroBias<>::id,
                                 HeadingBias<>::id};

/// A form of one coordinate whose number is followed from day to day.
struct Watched {
  EffectForm form;
  Eigen::Index place;  ///< among the coordinates that are kept
  double deviation;    ///< of the level of a vessel, and of what changes
  double floor;        ///< the least size that matters, as a coordinate
};

/// The trial of a class: coordinates of a day first, then which of them belong to the ships.
struct ClassTrial {
  Trial trial;
  std::vector<Eigen::Index> kept, of_a_day;  ///< of the ship and what is watched; the others
  std::vector<Watched> watched;
  Eigen::VectorXd of_class;  ///< standard deviations of what the class has in common, 0 for instruments

  Eigen::Index size() const { return std::ssize(kept); }
};

bool is_of_a_day(const Effect& effect) {
  const auto place = place_of(effect);
  return place == EffectPlace::air || place == EffectPlace::water || place == EffectPlace::sensor;
}

/// Values of the parameter that a form of one coordinate moves.
const Parameter& moved_parameter(const std::vector<Parameter>& parameters) {
  return *std::ranges::find_if(parameters, [](const Parameter& p) { return p.decides; });
}

double parameter_at(const Ship& ship, const EffectForm& form, double c) {
  return moved_parameter(parameters_of(ship, form.at(std::array{c}))).value;
}

/// d(parameter)/d(coordinate)
double parameter_slope(const Ship& ship, const EffectForm& form, double c) {
  constexpr double step = 1e-3;
  return (parameter_at(ship, form, c + step) - parameter_at(ship, form, c - step)) / (2.0 * step);
}

/// Wide about null to both sides, for resistances also fall.
EffectForm to_both_sides(EffectForm form) {
  auto& c = form.coordinates.front();
  c.low = std::max(c.low, -std::abs(c.high));
  if (form.id == AddedResistance<>::id) c.low = -1.0;
  return form;
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
    const bool is_watched = std::ranges::count(watched_ids, form.id) > 0;
    if (is_watched) {
      const auto parameters = parameters_of(ship, form.at(null));
      const double slope = parameter_slope(ship, form, form.coordinates.front().centre);
      result.watched.push_back({form, std::ssize(result.kept), form.coordinates.front().deviation,
                                moved_parameter(parameters).floor / std::abs(slope)});
    }
    const auto effect = form.at(null);
    const bool kept = is_watched || !is_of_a_day(effect);
    // no instrument errs alike on all sisters
    const bool shared = !is_watched || place_of(effect) != EffectPlace::sensor;
    for (const auto& c : form.coordinates) {
      if (kept) deviations.push_back(shared ? c.deviation : 0.0);
      (kept ? result.kept : result.of_a_day).push_back(next++);
    }
  }
  result.of_class = Eigen::Map<const Eigen::VectorXd>(deviations.data(), std::ssize(deviations));
  return result;
}

// ---------------------------------------------------------------- a day

/// The runs of a vessel on one day, and what they tell.
struct Day {
  std::size_t vessel;
  double date;  ///< since 1970-01-01 [days]
  std::vector<std::size_t> runs;
  Noise noise{};  ///< at the most probable point of the day by itself
  Told all{};     ///< of all coordinates of the trial, from their means; empty until the day is fitted
  Told told{};    ///< of those that are kept, what is of the day alone eliminated
};

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
  const Eigen::MatrixXd A = linear.slopes.transpose() * linear.slopes;
  day.all = {A, A * (point - trial.mean) - linear.slopes.transpose() * linear.residuals, 0.0};
  Eigen::MatrixXd L = Eigen::MatrixXd::Zero(A.rows(), std::ssize(whole.of_a_day));
  for (std::size_t i = 0; i < whole.of_a_day.size(); ++i) {
    const auto place = whole.of_a_day[i];
    L(place, static_cast<Eigen::Index>(i)) = 1.0 / std::sqrt(trial.precision(place, place));
  }
  const auto eliminated = blurred(day.all, L);
  day.told = {eliminated.A(whole.kept, whole.kept), eliminated.b(whole.kept), eliminated.c};
}

/// About the most probable point of the day by itself.
void fit_day(Day& day, const ClassTrial& whole) {
  const auto trial = trial_of_day(whole, day);
  const auto found = fit(trial, {}, trial.mean, Noise::on_board());
  if (found.point.size() == 0) throw Refusal("the ship cannot sail them");
  day.noise = found.noise;
  linearize(day, whole, trial, found.point);
}

/// About coordinates that the fleet tells, what is of the day as is likeliest beside them.
void move_day(Day& day, const ClassTrial& whole, const Eigen::VectorXd& kept) {
  const auto trial = trial_of_day(whole, day);
  const Eigen::MatrixXd A =
      day.all.A(whole.of_a_day, whole.of_a_day) + Eigen::MatrixXd(trial.precision(whole.of_a_day, whole.of_a_day));
  const Eigen::VectorXd b = day.all.b(whole.of_a_day) - day.all.A(whole.of_a_day, whole.kept) * kept;
  Point point = trial.mean;
  point(whole.kept) += kept;
  point(whole.of_a_day) += core::detail::solve_symmetric(A, b);
  const auto problem = problem_of(trial, Hypothesis{});
  point = problem.within_bounds(point);
  // what the numbers of the day alone had taken in is noise now
  day.noise = best_noise(problem, point, day.noise, true).noise;
  linearize(day, whole, trial, point);
}

// ---------------------------------------------------------------- the fleet as a linear model

/// A change of one watched number of a vessel.
struct Shift {
  std::size_t watched;
  ChangeShape shape;
  double since;

  /// 0 before, 1 on the last day.
  double at(double date, double last) const {
    if (date < since) return 0.0;
    return shape == ChangeShape::sudden || last <= since ? 1.0 : (date - since) / (last - since);
  }
};

/// How far vessels and days lie apart.
struct Spread {
  double vessels = 0.25;                     ///< coefficients of a vessel from those of the class, over `[confidence]`
  double days = 0.0625;                      ///< of a day from those of the vessel
  std::vector<std::vector<double>> watched;  ///< of the days of each vessel, over the least size that matters
};

/// Between which spreads are searched, in factors of 2; a spread of coefficients beyond those of the file has no sense.
constexpr double least_spread = 1.0 / 64.0, most_spread = 1.0, most_watched_spread = 4.0;

/// What days of one vessel scatter by in what is watched, before data: about a quarter of the least size that matters,
/// and as likely twice as half of that. A scatter that is as large as what matters is most often a change.
constexpr double usual_watched_spread = 0.25;

double log_prior_of_scatter(double spread) {
  const double octaves = std::log2(spread / usual_watched_spread);
  return -0.5 * octaves * octaves;
}

class FleetModel {
 public:
  FleetModel(const ClassTrial& whole, std::vector<Day> days, std::size_t vessels)
      : whole_(&whole),
        days_(std::make_shared<const std::vector<Day>>(std::move(days))),
        shifts_(vessels),
        last_(vessels, -HUGE_VAL),
        scattered_(days_->size()),
        of_vessel_(vessels),
        of_class_(vessels) {
    spread_.watched.assign(vessels, std::vector(whole.watched.size(), usual_watched_spread));
    for (const auto& day : *days_) last_[day.vessel] = std::max(last_[day.vessel], day.date);
    renew();
  }

  const std::vector<Day>& days() const { return *days_; }
  const Spread& spread() const { return spread_; }
  std::size_t vessels() const { return shifts_.size(); }
  const std::vector<Shift>& shifts(std::size_t vessel) const { return shifts_[vessel]; }
  double last(std::size_t vessel) const { return last_[vessel]; }
  double log_evidence() const { return log_evidence_; }

  /// The same with one more shift, the scatter of what it moves as is likeliest with it.
  FleetModel with(std::size_t vessel, const Shift& shift) const {
    FleetModel other = *this;
    other.shifts_[vessel].push_back(shift);
    other.renew(vessel);
    other.climb_watched(vessel, shift.watched);
    return other;
  }

  /// The same without one of her shifts, spreads as they are.
  FleetModel without(std::size_t vessel, std::size_t shift) const {
    FleetModel other = *this;
    other.shifts_[vessel].erase(other.shifts_[vessel].begin() + static_cast<std::ptrdiff_t>(shift));
    other.renew(vessel);
    return other;
  }

  /// The same with the scatter of the days of a vessel in what is watched as is likeliest.
  FleetModel with_likely_scatter(std::size_t vessel, std::size_t watched) const {
    FleetModel other = *this;
    other.climb_watched(vessel, watched);
    return other;
  }

  /// The same with days of a vessel that hardly scatter in what is watched: a shift stands out.
  FleetModel with_little_scatter(std::size_t vessel, std::size_t watched) const {
    constexpr double little = 0.125;  // of the least size that matters
    FleetModel other = *this;
    other.spread_.watched[vessel][watched] = std::min(little, other.spread_.watched[vessel][watched]);
    other.renew(vessel);
    return other;
  }

  /// The days anew about what the fleet tells of them.
  void move_days() {
    std::vector<NormalLaw> laws;
    for (std::size_t vessel = 0; vessel < vessels(); ++vessel) laws.push_back(law_of(vessel));
    auto all = *days_;
    in_parallel(all.size(), 0, [&](std::size_t i) {
      auto moved = all[i];
      try {
        move_day(moved, *whole_, coordinates_on(moved, laws[moved.vessel]));
      } catch (const Refusal&) {  // the ship cannot sail them like that: the day stays as it was
        return;
      }
      all[i] = std::move(moved);
    });
    days_ = std::make_shared<const std::vector<Day>>(std::move(all));
    renew();
    find_spreads();
  }

  /// The last shift of a vessel in another place of her list.
  void move_last_to(std::size_t vessel, std::size_t place) {
    auto& shifts = shifts_[vessel];
    std::rotate(shifts.begin() + static_cast<std::ptrdiff_t>(place), shifts.end() - 1, shifts.end());
    renew(vessel);
  }

  /// Spreads at which the days are likeliest.
  void find_spreads() {
    for (double before = -HUGE_VAL; log_evidence_ > before + worth_a_round;) {
      before = log_evidence_;
      if (vessels() > 1) climb(spread_.vessels, most_spread, [&] { renew(); });
      climb(spread_.days, most_spread, [&] { renew(); });
      for (std::size_t vessel = 0; vessel < vessels(); ++vessel)
        for (std::size_t k = 0; k < whole_->watched.size(); ++k) climb_watched(vessel, k);
    }
  }

  /// Of a vessel: coordinates that are kept, then the size of each of her shifts.
  NormalLaw law_of(std::size_t vessel) const {
    const auto prior = prior_of(vessel);
    return posterior(of_vessel_[vessel], prior.mean, prior.L);
  }

  /// A coordinate of a vessel in two parts: what her class has, and what is her own.
  struct OwnPart {
    double of_class, own, error;  ///< standard error of her own
  };

  std::function<OwnPart(Eigen::Index)> own_law_of(std::size_t vessel) const {
    const auto d = whole_->size();
    const auto prior = prior_of(vessel);
    Eigen::MatrixXd M = prior.L.transpose() * of_vessel_[vessel].A * prior.L;
    M.diagonal().array() += 1.0;
    const Eigen::MatrixXd of_n = core::detail::inverse(M);
    const Eigen::VectorXd n = of_n * (prior.L.transpose() * (of_vessel_[vessel].b - of_vessel_[vessel].A * prior.mean));
    const Eigen::VectorXd of_class = prior.mean.head(d) + prior.L.topLeftCorner(d, d) * n.head(d);
    const Eigen::VectorXd own = own_deviations().cwiseProduct(n.segment(d, d));
    const Eigen::VectorXd error =
        own_deviations().cwiseProduct(of_n.diagonal().segment(d, d).cwiseMax(0.0).cwiseSqrt());
    return [=](Eigen::Index k) { return OwnPart{of_class[k], own[k], error[k]}; };
  }

  /// Coordinates of a vessel on a day, by her law.
  Eigen::VectorXd coordinates_on(const Day& day, const NormalLaw& law) const { return map_of(day) * law.mean; }

  /// Of what the class has in common.
  NormalLaw law_of_class() const {
    Told all = Told::nothing(whole_->size());
    for (const auto& told : of_class_) all += told;
    const Eigen::MatrixXd before = whole_->of_class.asDiagonal();
    return posterior(all, Eigen::VectorXd::Zero(whole_->size()), before);
  }

  /// Gain in log evidence of one more shift, for each of these dates, spreads as they are.
  std::vector<double> gains(std::size_t vessel, std::size_t watched, ChangeShape shape, std::span<const double> dates,
                            const NormalLaw& law) const {
    const auto k = whole_->watched[watched].place;
    const double variance = std::pow(whole_->watched[watched].deviation, 2);
    std::vector<double> result;
    for (const double since : dates) {
      const Shift shift{watched, shape, since};
      Eigen::VectorXd h = Eigen::VectorXd::Zero(law.mean.size());
      double zz = 0.0, bz = 0.0;
      for (std::size_t i = 0; i < days().size(); ++i) {
        if (days()[i].vessel != vessel) continue;
        const double g = shift.at(days()[i].date, last_[vessel]);
        h += g * (map_of(days()[i]).transpose() * scattered_[i].A.col(k));
        zz += g * g * scattered_[i].A(k, k), bz += g * scattered_[i].b[k];
      }
      const double S = zz - h.dot(law.covariance * h) + 1.0 / variance, r = bz - h.dot(law.mean);
      result.push_back(0.5 * r * r / S - 0.5 * std::log(S * variance));
    }
    return result;
  }

 private:
  static constexpr double worth_a_round = 0.5;  ///< of log evidence

  /// Of a vessel before her own days: mean + L n of the class as her sisters tell it, what is her own, and her shifts.
  struct Prior {
    Eigen::VectorXd mean;
    Eigen::MatrixXd L;
  };

  Prior prior_of(std::size_t vessel) const {
    const auto d = whole_->size(), m = std::ssize(shifts_[vessel]);
    Told others = Told::nothing(d);
    for (std::size_t other = 0; other < shifts_.size(); ++other)
      if (other != vessel) others += of_class_[other];
    const Eigen::MatrixXd before = whole_->of_class.asDiagonal();
    Prior prior{Eigen::VectorXd::Zero(d + m), Eigen::MatrixXd::Zero(d + m, 2 * d + m)};
    prior.mean.head(d) = posterior(others, Eigen::VectorXd::Zero(d), before).mean;
    prior.L.topLeftCorner(d, d) = square_root_of(others, before);
    prior.L.block(0, d, d, d) = own_deviations().asDiagonal();
    for (Eigen::Index j = 0; j < m; ++j)
      prior.L(d + j, 2 * d + j) = deviation_of(shifts_[vessel][static_cast<std::size_t>(j)]);
    return prior;
  }

  /// Deviations of a vessel from the class.
  Eigen::VectorXd own_deviations() const {
    Eigen::VectorXd own = spread_.vessels * whole_->of_class;
    for (const auto& w : whole_->watched) own[w.place] = w.deviation;
    return own;
  }

  double deviation_of(const Shift& shift) const { return whole_->watched[shift.watched].deviation; }

  /// From the coordinates of a vessel, her shifts among them, to those of a day.
  Eigen::MatrixXd map_of(const Day& day) const {
    const auto d = whole_->size();
    const auto& shifts = shifts_[day.vessel];
    Eigen::MatrixXd G = Eigen::MatrixXd::Zero(d, d + std::ssize(shifts));
    G.leftCols(d).setIdentity();
    for (std::size_t j = 0; j < shifts.size(); ++j)
      G(whole_->watched[shifts[j].watched].place, d + static_cast<Eigen::Index>(j)) =
          shifts[j].at(day.date, last_[day.vessel]);
    return G;
  }

  /// L with L Lᵀ the covariance after data of x = L_0 n: L_0 M^(−1/2), by the axes of L_0ᵀ A L_0.
  static Eigen::MatrixXd square_root_of(const Told& told, const Eigen::MatrixXd& before) {
    const auto axes = core::detail::principal_axes(before.transpose() * told.A * before);
    const Eigen::VectorXd shrunk = (axes.size.array().max(0.0) + 1.0).rsqrt();
    return before * axes.axis * shrunk.asDiagonal();
  }

  /// What follows from the spreads, of all vessels.
  void renew() {
    in_parallel(vessels(), 0, [&](std::size_t vessel) { renew_told(vessel); });
    renew_evidence();
  }

  void renew(std::size_t vessel) { renew_told(vessel), renew_evidence(); }

  void renew_told(std::size_t vessel) {
    const auto d = whole_->size(), m = std::ssize(shifts_[vessel]);
    Eigen::VectorXd of_days = spread_.days * whole_->of_class;
    for (std::size_t k = 0; k < whole_->watched.size(); ++k)
      of_days[whole_->watched[k].place] = spread_.watched[vessel][k] * whole_->watched[k].floor;
    const Eigen::MatrixXd scatter = of_days.asDiagonal();
    Told told = Told::nothing(d + m);
    for (std::size_t i = 0; i < days().size(); ++i) {
      if (days()[i].vessel != vessel) continue;
      scattered_[i] = blurred(days()[i].told, scatter);
      told += scattered_[i].of(map_of(days()[i]));
    }
    Eigen::VectorXd own(d + m);
    own.head(d) = own_deviations();
    for (Eigen::Index j = 0; j < m; ++j) own[d + j] = deviation_of(shifts_[vessel][static_cast<std::size_t>(j)]);
    const auto about_class = blurred(told, Eigen::MatrixXd(own.asDiagonal()));
    of_vessel_[vessel] = std::move(told);
    of_class_[vessel] = {about_class.A.topLeftCorner(d, d), about_class.b.head(d), about_class.c};
  }

  void renew_evidence() {
    log_evidence_ = law_of_class().log_evidence;
    for (const auto& spreads : spread_.watched)
      for (const double spread : spreads) log_evidence_ += log_prior_of_scatter(spread);
  }

  /// Moves one spread by factors of 2 as long as the evidence grows.
  template <class Renew>
  void climb(double& spread, double most, const Renew& renew_with) {
    for (const double factor : {2.0, 0.5})
      for (;;) {
        const double before = spread, evidence = log_evidence_;
        spread = before * factor;
        const bool possible = spread <= most && spread >= least_spread;
        if (possible) renew_with();
        if (possible && log_evidence_ > evidence) continue;
        spread = before;
        if (possible) renew_with();
        break;
      }
  }

  void climb_watched(std::size_t vessel, std::size_t k) {
    climb(spread_.watched[vessel][k], most_watched_spread, [&] { renew(vessel); });
  }

  const ClassTrial* whole_;
  std::shared_ptr<const std::vector<Day>> days_;  ///< the same in models that differ in shifts and spreads
  std::vector<std::vector<Shift>> shifts_;        ///< of each vessel
  std::vector<double> last_;
  Spread spread_{};
  std::vector<Told> scattered_;  ///< by day, its scatter eliminated
  std::vector<Told> of_vessel_;  ///< of her coordinates and the sizes of her shifts
  std::vector<Told> of_class_;   ///< what each vessel tells of the class
  double log_evidence_ = -HUGE_VAL;
};

// ---------------------------------------------------------------- dates

/// Dates that a change may have begun at, each standing for the time about it.
struct DateGrid {
  std::vector<double> date, from, to;

  void add(double d, double a, double b) { date.push_back(d), from.push_back(a), to.push_back(b); }
};

/// Between two days anything sudden is alike; what grows may begin on a day or midway.
DateGrid dates_of(const FleetModel& model, std::size_t vessel, ChangeShape shape) {
  std::vector<double> days;
  for (const auto& day : model.days())
    if (day.vessel == vessel) days.push_back(day.date);
  std::ranges::sort(days);
  days.erase(std::ranges::unique(days).begin(), days.end());
  DateGrid grid;
  for (std::size_t i = 0; i + 1 < days.size(); ++i) {
    const double a = days[i], b = days[i + 1], middle = 0.5 * (a + b);
    if (shape == ChangeShape::sudden) grid.add(middle, a, b);
    else if (i + 2 < days.size()) grid.add(a, a, middle), grid.add(middle, middle, b);
    else grid.add(a, a, b);
  }
  return grid;
}

/// Posterior weights of the dates, uniform in time before, and the logarithm of their mean likelihood ratio.
struct DateLaw {
  std::vector<double> weight;
  double gain;
  std::size_t likeliest = 0;
};

DateLaw date_law(const DateGrid& grid, std::span<const double> gains) {
  const double whole = grid.to.back() - grid.from.front(), best = std::ranges::max(gains);
  DateLaw law{.weight = {}, .gain = 0.0};
  double sum = 0.0;
  for (std::size_t i = 0; i < gains.size(); ++i) {
    law.weight.push_back((grid.to[i] - grid.from[i]) / whole * std::exp(gains[i] - best));
    sum += law.weight.back();
  }
  for (double& w : law.weight) w /= sum;
  law.gain = best + std::log(sum);
  law.likeliest = static_cast<std::size_t>(std::ranges::max_element(law.weight) - law.weight.begin());
  return law;
}

/// The date below which the law has that share.
double quantile(const DateGrid& grid, const std::vector<double>& weight, double share) {
  double sum = 0.0;
  for (std::size_t i = 0; i < weight.size(); ++i) {
    if (sum + weight[i] >= share) return std::lerp(grid.from[i], grid.to[i], (share - sum) / weight[i]);
    sum += weight[i];
  }
  return grid.to.back();
}

DateEstimate estimate_of(const DateGrid& grid, const DateLaw& law) {
  constexpr double tail = 0.025;
  return {grid.date[law.likeliest], quantile(grid, law.weight, tail), quantile(grid, law.weight, 1.0 - tail)};
}

// ---------------------------------------------------------------- the search

/// A shift of a vessel, what it gains in log evidence over the mean of its dates, and when it began.
struct Proposal {
  std::size_t vessel;
  Shift shift;
  double gain;
  DateEstimate since;
  double over_dates;  ///< what the mean of the dates gains more than the likeliest, mostly less
};

/// The likeliest date of a watched number of a vessel that shifts in this shape, spreads as they are; nothing where she
/// has too few days.
std::optional<Proposal> proposal(const FleetModel& model, std::size_t vessel, std::size_t watched, ChangeShape shape) {
  const auto grid = dates_of(model, vessel, shape);
  if (grid.date.size() < 2) return std::nullopt;
  const auto gains = model.gains(vessel, watched, shape, grid.date, model.law_of(vessel));
  const auto dates = date_law(grid, gains);
  const auto since = estimate_of(grid, dates);
  return Proposal{vessel, {watched, shape, since.likeliest}, dates.gain, since, dates.gain - gains[dates.likeliest]};
}

/// The model with a proposal, the scatter of what it moves as is likeliest with it, and what that gains.
struct Tried {
  FleetModel model;
  Proposal proposal;
};

/// @param without  log evidence without it, scatter as is likeliest
Tried tried(const FleetModel& model, const Proposal& p, double without) {
  const auto first = model.with(p.vessel, p.shift);
  // dates at the scatter that is left
  const auto before = first.without(p.vessel, first.shifts(p.vessel).size() - 1);
  auto found = *proposal(before, p.vessel, p.shift.watched, p.shift.shape);
  auto with = before.with(p.vessel, found.shift);
  // the date that is taken is the best of many: their mean gains less
  found.gain = with.log_evidence() - without + found.over_dates;
  return {std::move(with), found};
}

/// What may have shifted on a vessel, each as it would stand out, those that gain most first.
std::vector<Proposal> proposals(const ClassTrial& whole, const FleetModel& model, std::size_t vessel) {
  std::vector<Proposal> result;
  for (std::size_t k = 0; k < whole.watched.size(); ++k) {
    const auto quiet = model.with_little_scatter(vessel, k);
    for (const auto shape : {ChangeShape::sudden, ChangeShape::gradual})
      if (auto p = proposal(quiet, vessel, k, shape)) result.push_back(*std::move(p));
  }
  std::ranges::sort(result, std::greater{}, &Proposal::gain);
  return result;
}

/// Of the proposals of a vessel, how many have their scatter found anew.
constexpr std::size_t confirmed = 5;

/// Takes shifts vessel by vessel, that first which gains most.
void add_shifts(const ClassTrial& whole, FleetModel& model, const FleetOptions& options) {
  for (std::size_t vessel = 0; vessel < model.vessels(); ++vessel)
    while (model.shifts(vessel).size() < options.most_changes) {
      auto best = proposals(whole, model, vessel);
      if (best.size() > confirmed) best.resize(confirmed);
      std::optional<Tried> next;
      for (const auto& p : best)
        if (auto t = tried(model, p, model.log_evidence()); !next || t.proposal.gain > next->proposal.gain)
          next.emplace(std::move(t));
      if (!next || !(next->proposal.gain > options.detection)) break;
      model = std::move(next->model);
    }
  model.find_spreads();
}

/// A shift beside all others, and how probable it is against others in its place and against none.
struct SettledShift {
  Proposal proposal;
  double probability;
};

/// Each shift once more beside all others: its shape and date may be others now, and it may gain too little.
std::vector<SettledShift> settled(const ClassTrial& whole, FleetModel& model, const FleetOptions& options) {
  std::vector<SettledShift> result;
  for (std::size_t vessel = 0; vessel < model.vessels(); ++vessel)
    for (std::size_t j = 0; j < model.shifts(vessel).size();) {
      const auto watched = model.shifts(vessel)[j].watched;
      const auto without = model.without(vessel, j).with_likely_scatter(vessel, watched);
      std::vector<Tried> all;
      for (const auto& p : proposals(whole, without, vessel))
        if (all.size() < confirmed || p.shift.watched == watched)
          all.push_back(tried(without, p, without.log_evidence()));
      std::optional<std::size_t> best;
      double most = options.detection;
      for (std::size_t i = 0; i < all.size(); ++i) {
        const auto& p = all[i].proposal;
        most = std::max(most, p.gain);
        if (p.shift.watched == watched && (!best || p.gain > all[*best].proposal.gain)) best = i;
      }
      if (!best || !(all[*best].proposal.gain > options.detection)) {
        model = without;
        continue;
      }
      double sum = std::exp(options.detection - most), of_this = 0.0;
      for (const auto& t : all) {
        const double share = std::exp(t.proposal.gain - most);
        sum += share;
        if (t.proposal.shift.watched == watched) of_this += share;
      }
      // in the place of the old one, which was taken out of the list and is its last now
      model = std::move(all[*best].model);
      model.move_last_to(vessel, j);
      result.push_back({all[*best].proposal, of_this / sum});
      ++j;
    }
  return result;
}

// ---------------------------------------------------------------- days

/// Days of vessels in the order of time, runs of the same `group` or date together.
std::vector<Day> days_of(std::span<const FleetRun> runs, const std::vector<std::string>& vessels) {
  constexpr double seconds_of_a_day = 86400.0;
  std::map<std::pair<std::size_t, std::string>, Day> days;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const auto start = start_utc(runs[i].run);
    if (!start)
      throw Refusal(
          fmt::format("{} does not tell when it was: write a line like # start_utc = \"2026-03-04T09:30:00Z\" "
                      "above its columns",
                      runs[i].run.name));
    const auto vessel = static_cast<std::size_t>(std::ranges::find(vessels, runs[i].vessel) - vessels.begin());
    const double date = *start / seconds_of_a_day;
    const auto [day, is_new] = days.try_emplace({vessel, part_name(Scope::group, runs[i].run)}, Day{vessel, date, {}});
    day->second.date = std::min(day->second.date, date);
    day->second.runs.push_back(i);
  }
  std::vector<Day> result;
  for (auto& [key, day] : days) result.push_back(std::move(day));
  std::ranges::sort(result, {}, [](const Day& d) { return std::pair(d.vessel, d.date); });
  return result;
}

/// Fits each day; those that cannot be are told and left out.
std::vector<Day> fitted(const ClassTrial& whole, std::vector<Day> days, std::span<const FleetRun> runs,
                        const FleetOptions& options, std::vector<std::string>& troubles) {
  std::atomic<std::size_t> done = 0;
  std::atomic<bool> stopped = false;
  std::mutex guard;
  in_parallel(days.size(), 0, [&](std::size_t i) {
    if (stopped) return;
    try {
      fit_day(days[i], whole);
    } catch (const std::exception& trouble) {
      const std::scoped_lock lock(guard);
      troubles.push_back(fmt::format("{} on {} is left out: {}", runs[days[i].runs.front()].vessel,
                                     date_text(days[i].date), trouble.what()));
    }
    const std::scoped_lock lock(guard);
    if (options.progress && !options.progress(++done, days.size())) stopped = true;
  });
  std::erase_if(days, [](const Day& day) { return day.told.b.size() == 0; });
  if (stopped) troubles.push_back(fmt::format("stopped early: {} days are fitted", days.size()));
  if (days.empty())
    throw Refusal(troubles.empty() ? std::string("there is no run")
                                   : fmt::format("no day can be fitted; {}", troubles.front()));
  std::ranges::sort(troubles);
  return days;
}

// ---------------------------------------------------------------- ships

/// A point of the trial with these coordinates that are kept, what is of a day at its mean.
Point whole_point(const ClassTrial& whole, const Eigen::VectorXd& kept) {
  Point point = whole.trial.mean;
  point(whole.kept) += kept.head(whole.size());
  return point;
}

/// The ship of a point with some of what is watched.
Ship ship_of(const ClassTrial& whole, const Eigen::VectorXd& kept, const std::function<bool(std::string_view)>& has) {
  return ship_with(whole.trial, {}, whole_point(whole, kept), nullptr, [&](const Effect& effect, bool) {
    const auto id = id_of(effect);
    return std::ranges::count(watched_ids, id) > 0 ? has(id) : !is_of_a_day(effect);
  });
}

/// Whether the class has in common what is watched.
bool is_shared(const ClassTrial& whole, std::string_view id) {
  return std::ranges::any_of(whole.watched,
                             [&](const Watched& w) { return w.form.id == id && whole.of_class[w.place] > 0.0; });
}

// ---------------------------------------------------------------- answers

/// A coordinate as it is, and its parameter.
struct Level {
  double value, slope;
};

Level level(const ClassTrial& whole, const Watched& w, double c) {
  const double at = w.form.coordinates.front().centre + c;
  return {parameter_at(whole.trial.ship, w.form, at), parameter_slope(whole.trial.ship, w.form, at)};
}

Effect effect_at(const Watched& w, double c) { return w.form.at(std::array{w.form.coordinates.front().centre + c}); }

std::string key_of(const ClassTrial& whole, const Watched& w) {
  return std::string(moved_parameter(parameters_of(whole.trial.ship, effect_at(w, 0.0))).key);
}

/// The parameter day by day, its error at least that of the scatter between days.
std::vector<DayLevel> levels_of(const ClassTrial& whole, const FleetModel& model, std::size_t vessel,
                                std::size_t watched, const NormalLaw& law) {
  const auto& w = whole.watched[watched];
  const double scatter = model.spread().watched[vessel][watched] * w.floor;
  std::vector<DayLevel> result;
  for (const auto& day : model.days()) {
    if (day.vessel != vessel) continue;
    Eigen::VectorXd now = model.coordinates_on(day, law);
    const double precision = day.told.A(w.place, w.place);
    if (!(precision > 0.0)) continue;
    now[w.place] += (day.told.b[w.place] - day.told.A.row(w.place).dot(now)) / precision;
    const auto there = level(whole, w, now[w.place]);
    result.push_back({day.date, there.value, std::abs(there.slope) * std::hypot(scatter, 1.0 / std::sqrt(precision))});
  }
  return result;
}

VesselChange change_of(const ClassTrial& whole, const FleetModel& model, const SettledShift& s, std::size_t index,
                       const NormalLaw& law) {
  const auto& p = s.proposal;
  const auto& w = whole.watched[p.shift.watched];
  const auto z = whole.size() + static_cast<Eigen::Index>(index);
  // before this shift: those of the same number that began earlier have come
  double before = law.mean[w.place];
  const auto& shifts = model.shifts(p.vessel);
  for (std::size_t j = 0; j < shifts.size(); ++j)
    if (shifts[j].watched == p.shift.watched && shifts[j].since < p.shift.since)
      before += law.mean[whole.size() + static_cast<Eigen::Index>(j)];
  const double after = before + law.mean[z], slope = level(whole, w, after).slope,
               worth = moved_parameter(parameters_of(whole.trial.ship, effect_at(w, after))).law;
  return {.effect = effect_at(w, after),
          .key = key_of(whole, w),
          .shape = p.shift.shape,
          .before = level(whole, w, before).value,
          .after = level(whole, w, after).value,
          .standard_error = std::hypot(std::abs(slope) * std::sqrt(law.covariance(z, z)), worth * slope * law.mean[z]),
          .floors = std::abs(law.mean[z]) / w.floor,
          .since = p.since,
          .probability = s.probability,
          .log_evidence_gain = p.gain,
          .days = levels_of(whole, model, p.vessel, p.shift.watched, law)};
}

/// Levels from the first day on, told from those of the class and large enough to matter. The class as its other ships
/// tell it, and as the ship file where there are none.
std::vector<VesselDifference> differences_of(const ClassTrial& whole, const FleetModel& model, std::size_t vessel) {
  constexpr double told = 3.0;  // standard errors
  const auto own_law = model.own_law_of(vessel);
  std::vector<VesselDifference> result;
  for (const auto& w : whole.watched) {
    const auto [sisters, own, error] = own_law(w.place);
    if (std::abs(own) < w.floor || std::abs(own) < told * error) continue;
    const auto level_now = level(whole, w, sisters + own);
    result.push_back({effect_at(w, sisters + own), key_of(whole, w), level(whole, w, sisters).value, level_now.value,
                      std::abs(level_now.slope) * error, std::abs(own) / w.floor});
  }
  std::ranges::sort(result, std::greater{}, &VesselDifference::floors);
  return result;
}

std::vector<SharedCoefficient> shared_of(const ClassTrial& whole, const NormalLaw& law) {
  std::vector<SharedCoefficient> result;
  for (std::size_t i = 0; i < whole.trial.parameters.size(); ++i) {
    const auto& p = whole.trial.parameters[i];
    const auto k = static_cast<Eigen::Index>(i);
    const double c = std::clamp(p.value + p.deviation * law.mean[k], p.range.low, p.range.high);
    result.push_back({p.name, p.value, c, p.deviation * std::sqrt(law.covariance(k, k)), (c - p.value) / p.deviation});
  }
  return result;
}

/// Squares of the errors of replays and of the variation of each quantity, over runs.
class ReplayErrors {
 public:
  /// @return whether the ship can sail the run
  bool add(const Ship& ship, const Recording& run) try {
    for (const auto& e : compare(ship, run).errors)
      if (e.quantity != Quantity::position && std::isfinite(e.window_rms)) {
        auto& [error, variation] = of_[e.quantity];
        error += e.window_rms * e.window_rms, variation += e.variation * e.variation;
      }
    return true;
  } catch (const Refusal&) {
    return false;
  }

  /// Mean over quantities of the root of errors over variation; missing where there is none.
  double mean() const {
    double sum = 0.0;
    int told = 0;
    for (const auto& [quantity, squares] : of_)
      if (squares.second > 0.0) sum += std::sqrt(squares.first / squares.second), ++told;
    return told > 0 ? sum / told : missing;
  }

 private:
  std::map<Quantity, std::pair<double, double>> of_;
};

FleetErrors errors_of(const ClassTrial& whole, const FleetModel& model, std::size_t vessel, const NormalLaw& law,
                      const Ship& sisters, std::span<const FleetRun> runs) {
  std::array<ReplayErrors, 3> errors;
  for (const auto& day : model.days()) {
    if (day.vessel != vessel) continue;
    const Eigen::VectorXd now = model.coordinates_on(day, law);
    const auto own = ship_of(whole, now, [](std::string_view) { return true; });
    for (const auto run : day.runs) {
      auto with = errors;
      if (with[0].add(whole.trial.ship, runs[run].run) && with[1].add(sisters, runs[run].run) &&
          with[2].add(own, runs[run].run))
        errors = std::move(with);
    }
  }
  return {errors[0].mean(), errors[1].mean(), errors[2].mean()};
}

// ---------------------------------------------------------------- words

std::string words_of(const FleetDiagnosis& d) {
  std::string words;
  for (const auto& v : d.vessels) {
    if (v.changes.empty() && v.differences.empty()) continue;
    std::vector<std::string> parts;
    for (const auto& c : v.changes)
      parts.push_back(fmt::format("{} {} {} (95 %: {} to {})", text_of(c.effect).phrase,
                                  c.shape == ChangeShape::sudden ? "since" : "growing since",
                                  date_text(c.since.likeliest), date_text(c.since.from), date_text(c.since.to)));
    for (const auto& x : v.differences) parts.push_back(fmt::format("{} from the first day", text_of(x.effect).phrase));
    words += fmt::format("{}{}: {}.", words.empty() ? "" : " ", v.vessel, fmt::join(parts, "; "));
  }
  const auto quiet = std::ranges::count_if(
      d.vessels, [](const VesselReport& v) { return v.changes.empty() && v.differences.empty(); });
  if (quiet == std::ssize(d.vessels))
    return "Nothing has changed on any vessel, and none differs from her sisters, by more than matters.";
  if (quiet > 0)
    words += fmt::format(" On {} of {} vessels nothing has changed by more than matters.", quiet, d.vessels.size());
  return words;
}

}  // namespace

FleetDiagnosis diagnose_fleet(const Ship& ship, std::span<const FleetRun> runs, const FleetOptions& options) {
  if (runs.empty()) throw Refusal("there is no run");
  std::vector<std::string> vessels;
  std::vector<Recording> recordings;
  for (const auto& r : runs) {
    if (std::ranges::count(vessels, r.vessel) == 0) vessels.push_back(r.vessel);
    recordings.push_back(r.run);
  }
  auto days = days_of(runs, vessels);
  FleetDiagnosis d;
  const auto whole = class_trial(ship, recordings);
  FleetModel model(whole, fitted(whole, std::move(days), runs, options, d.troubles), vessels.size());
  model.find_spreads();
  model.move_days();
  add_shifts(whole, model, options);
  model.move_days();
  const auto shifts = settled(whole, model, options);
  const auto of_class = model.law_of_class();
  d.shared = shared_of(whole, of_class);
  d.sisters = ship_of(whole, of_class.mean, [&](std::string_view id) { return is_shared(whole, id); });
  d.spread = vessels.size() > 1 ? model.spread().vessels : 0.0;
  d.day_to_day = model.spread().days;
  for (std::size_t vessel = 0; vessel < vessels.size(); ++vessel) {
    const auto law = model.law_of(vessel);
    VesselReport report{.vessel = vessels[vessel]};
    Eigen::VectorXd on_last_day;
    for (const auto& day : model.days()) {
      if (day.vessel != vessel) continue;
      on_last_day = model.coordinates_on(day, law);
      if (report.days++ == 0) report.first_day = day.date;
      report.last_day = day.date, report.runs += day.runs.size();
    }
    if (report.days == 0) continue;  // told among the troubles
    std::vector<std::string_view> found;
    std::size_t index = 0;
    for (const auto& s : shifts) {
      if (s.proposal.vessel != vessel) continue;
      auto change = change_of(whole, model, s, index++, law);
      if (change.floors < 1.0) {
        d.trace.push_back(fmt::format("{}: {} since {}, too small to matter", report.vessel,
                                      text_of(change.effect).phrase, date_text(change.since.likeliest)));
        continue;
      }
      found.push_back(id_of(change.effect));
      report.changes.push_back(std::move(change));
    }
    std::ranges::sort(report.changes, std::greater{}, &VesselChange::floors);
    report.differences = differences_of(whole, model, vessel);
    for (const auto& x : report.differences) found.push_back(id_of(x.effect));
    report.errors = errors_of(whole, model, vessel, law, d.sisters, runs);
    report.today = ship_of(whole, on_last_day, [&](std::string_view id) {
      return is_shared(whole, id) || std::ranges::count(found, id) > 0;
    });
    d.vessels.push_back(std::move(report));
  }
  std::ranges::stable_sort(d.vessels, std::greater{}, &VesselReport::worst);
  d.words = words_of(d);
  return d;
}

}  // namespace swayaw::mismatch
