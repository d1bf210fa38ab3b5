#include "fleet_changes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace swayaw::inline mismatch::detail {
namespace {

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
  days.erase(std::unique(days.begin(), days.end()), days.end());
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

}  // namespace

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

}  // namespace swayaw::mismatch::detail
