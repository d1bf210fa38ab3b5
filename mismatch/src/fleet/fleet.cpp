#include "swayaw/mismatch/fleet.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <map>
#include <mutex>

#include "fleet_changes.hpp"
#include "swayaw/core/parallel.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/core/run_remark.hpp"
#include "swayaw/mismatch/compare.hpp"

namespace swayaw::inline mismatch {
using namespace detail;

static constexpr double seconds_of_a_day = 86400.0;

std::string_view name_of(ChangeShape shape) { return shape == ChangeShape::sudden ? "sudden" : "gradual"; }

double VesselReport::worst() const {
  double most = 0.0;
  for (const auto& c : changes) most = std::max(most, c.floors);
  for (const auto& d : differences) most = std::max(most, d.floors);
  return most;
}

std::string date_text(double day) {
  return fmt::format("{:%Y-%m-%d}", fmt::gmtime(static_cast<std::time_t>(std::floor(day) * seconds_of_a_day)));
}

namespace {

/// Days of vessels in the order of time, runs of the same `group` or date together.
std::vector<Day> days_of(std::span<const FleetRun> runs, const std::vector<std::string>& vessels) {
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

/// Whether the class has in common what is watched.
bool is_shared(const ClassTrial& whole, std::string_view id) {
  return std::ranges::any_of(whole.watched,
                             [&](const Watched& w) { return w.form.id == id && whole.of_class[w.place] > 0.0; });
}

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
  const auto law = model.own_law_of(vessel);
  std::vector<VesselDifference> result;
  for (const auto& w : whole.watched) {
    const double sisters = law.of_class[w.place], own = law.own[w.place], error = law.error[w.place];
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
      parts.push_back(fmt::format("{} {} {} (95 %: {} to {})", phrase_of(c.effect),
                                  c.shape == ChangeShape::sudden ? "since" : "growing since",
                                  date_text(c.since.likeliest), date_text(c.since.from), date_text(c.since.to)));
    for (const auto& x : v.differences) parts.push_back(fmt::format("{} from the first day", phrase_of(x.effect)));
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
        d.trace.push_back(fmt::format("{}: {} since {}, too small to matter", report.vessel, phrase_of(change.effect),
                                      date_text(change.since.likeliest)));
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
