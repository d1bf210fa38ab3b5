#include "budget.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <span>

#include "swayaw/core/parallel.hpp"
#include "swayaw/mismatch/run_picture.hpp"
#include "swayaw/nonlinear/effects.hpp"
#include "swayaw/nonlinear/models/force_breakdown.hpp"
#include "swayaw/nonlinear/replay.hpp"

namespace swayaw::inline mismatch::detail {
namespace {

template <class Kind>
constexpr bool has_a_direction = std::ranges::any_of(parameter_list<Kind>, [](const auto& p) { return p.direction; });

template <class Kind>
concept Remembers = requires {
  Kind::hidden;
};

template <class Kind>
constexpr bool differs_between_sides =
    std::is_same_v<Kind, PropellerSideForce<>> || std::is_same_v<Kind, RudderOffset<>>;

template <class Kind>
Follows follows_kind(const Kind& effect) {
  if constexpr (requires { effect.channel; })
    return effect.channel == Channel::delta ? Follows::past : Follows::instruments;
  else if constexpr (IsInstrument<Kind>) return Follows::instruments;
  else if constexpr (std::is_same_v<Kind, UnknownForce<>>) return effect.drag != 0.0 ? Follows::side : Follows::nothing;
  else if constexpr (GivesWind<Kind> || GivesCurrent<Kind> || has_a_direction<Kind>) return Follows::earth;
  else if constexpr (differs_between_sides<Kind>) return Follows::side;
  else if constexpr (Remembers<Kind> || ActuatesRudder<Kind>) return Follows::past;
  else return Follows::form;
}

// ---------------------------------------------------------------- ships that have more and more of what was found

/// In this order the ship that is given gets what was found: what falls to the first cannot fall to the next.
constexpr std::array order{Follows::instruments, Follows::earth, Follows::past, Follows::side, Follows::form};

/// Whether what follows that is among the first so many of the order.
bool is_among(Follows kind, std::size_t stages) {
  return std::ranges::find(order, kind) - order.begin() < static_cast<std::ptrdiff_t>(stages);
}

/// Coordinates of the form that differ from side to side, or all of them, are taken in before those of the form.
Point with_stages(const Trial& trial, Point point, std::size_t stages) {
  if (!is_among(Follows::form, stages)) point.head(std::ssize(trial.parameters)).setZero();
  const auto axes = form_axes(trial);
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (axes[i] >= 0 && !is_among(differs_from_side_to_side(axes[i]) ? Follows::side : Follows::form, stages))
      point[static_cast<Eigen::Index>(i)] = 0.0;
  return point;
}

/// The ship after so many stages; nothing where she is that of the stage before.
std::optional<Ship> ship_of_stage(const Trial& trial, const Hypothesis& hypothesis, const Point& point,
                                  std::size_t stages, const Recording& run) {
  const Point now = with_stages(trial, point, stages);
  bool differs = stages == 0 || now != with_stages(trial, point, stages - 1);
  auto ship = ship_with(trial, hypothesis, now, &run, [&](const Effect& effect, bool) {
    if (std::holds_alternative<ModelForm<>>(effect)) return true;
    differs = differs || follows(effect) == order[stages - 1];
    return is_among(follows(effect), stages);
  });
  return differs ? std::optional(std::move(ship)) : std::nullopt;
}

// ---------------------------------------------------------------- shares

constexpr std::size_t axes = 3, stage_count = order.size() + 1;

/// Sums over samples of d_k d_0, the force that is missing after k stages times that of the given ship, and of the
/// squares of her own force.
struct Sums {
  std::array<std::array<double, stage_count>, axes> products{};
  std::array<double, axes> own{};

  void add(const Sums& other) {
    for (std::size_t axis = 0; axis < axes; ++axis) {
      own[axis] += other.own[axis];
      for (std::size_t k = 0; k < stage_count; ++k) products[axis][k] += other.products[axis][k];
    }
  }
};

std::array<double, axes> components(const PlanarForce<double>& f) { return {f.X, f.Y, f.N}; }

/// Of the hull alone, without what pushes her on.
std::array<double, axes> own_force(const Ship& ship, const PlanarMotion<double>& motion,
                                   const Controls<double>& controls) try {
  const auto forces = force_breakdown(ship, {0.0, 0.0, 0.0, motion}, controls);
  const auto hull = std::ranges::find(forces.parts, "hull", [](const auto& part) { return part.name; });
  return components(hull == forces.parts.end() ? forces.total : hull->force);
} catch (const std::exception&) {
  return {};
}

/// What the given ship lacks in a run, and the squares of her own force there; nothing where she cannot sail it.
struct OfGivenShip {
  std::vector<MissingForce> missing;
  std::array<double, axes> own{};
};

OfGivenShip of_given_ship(const Trial& trial, const Hypothesis& hypothesis, const Point& point, const PreparedRun& run,
                          const Noise& noise) try {
  OfGivenShip given{.missing = missing_force(*ship_of_stage(trial, hypothesis, point, 0, *run.run), run, noise)};
  const RecordedControls controls(trial.ship, *run.run);
  for (std::size_t i = 0; i < given.missing.size(); ++i) {
    const auto own = own_force(trial.ship, given.missing[i].motion, controls.at(run.run->time[i]));
    for (std::size_t axis = 0; axis < axes; ++axis) given.own[axis] += own[axis] * own[axis];
  }
  return given;
} catch (const std::exception&) {
  return {};
}

Sums sums_of(const Trial& trial, const Hypothesis& hypothesis, const Point& point, const PreparedRun& run,
             const Noise& noise, const OfGivenShip& given) try {
  Sums sums{.own = given.own};
  auto missing = given.missing;
  for (std::size_t k = 0; k < stage_count; ++k) {
    if (k > 0)
      if (const auto ship = ship_of_stage(trial, hypothesis, point, k, *run.run))
        missing = missing_force(*ship, run, noise);
    for (std::size_t i = 0; i < missing.size(); ++i) {
      const auto now = components(missing[i].force), before = components(given.missing[i].force);
      for (std::size_t axis = 0; axis < axes; ++axis)
        if (std::isfinite(now[axis] * before[axis])) sums.products[axis][k] += now[axis] * before[axis];
    }
  }
  return sums;
} catch (const std::exception&) {
  return {};
}

/// At each point, of all runs that the ships can sail.
std::vector<Sums> sums_of(const Trial& trial, const Hypothesis& hypothesis, std::span<const Point> points,
                          const Noise& noise) {
  const auto runs = trial.runs.size();
  std::vector<OfGivenShip> given(runs);
  in_parallel(runs, 0, [&](std::size_t i) {
    given[i] = of_given_ship(trial, hypothesis, points.front(), trial.runs[i], noise);
  });
  std::vector<Sums> of_each(points.size() * runs);
  in_parallel(of_each.size(), 0, [&](std::size_t i) {
    const auto run = i % runs;
    if (!given[run].missing.empty())
      of_each[i] = sums_of(trial, hypothesis, points[i / runs], trial.runs[run], noise, given[run]);
  });
  std::vector<Sums> all(points.size());
  for (std::size_t i = 0; i < of_each.size(); ++i) all[i / runs].add(of_each[i]);
  return all;
}

/// By Follows.
std::array<double, follows_count> shares_of(const std::array<double, stage_count>& products) {
  std::array<double, follows_count> shares{};
  for (std::size_t k = 0; k < order.size(); ++k)
    shares[static_cast<std::size_t>(order[k])] = (products[k] - products[k + 1]) / products[0];
  shares[static_cast<std::size_t>(Follows::nothing)] = products.back() / products[0];
  return shares;
}

/// Points as likely as the posterior has them, between their bounds.
std::vector<Point> drawn(const EstimationProblem& problem, const MapFit& fit) {
  constexpr std::size_t count = 8;
  constexpr unsigned seed = 1;
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const Eigen::MatrixXd root = fit.covariance.llt().matrixL();
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) {
    Point z(fit.point.size());
    for (double& x : z) x = normal(random);
    points.push_back(problem.within_bounds(fit.point + root * z));
  }
  return points;
}

}  // namespace

Follows follows(const Effect& effect) {
  return std::visit([](const auto& e) { return follows_kind(e); }, effect);
}

std::vector<ForceBudget> budget_of(const Trial& trial, const Hypothesis& hypothesis, const MapFit& fit) {
  const auto problem = problem_of(trial, hypothesis);
  const auto noise = best_noise(problem_of(trial, trial.ship), {}, fit.noise, false).noise;
  auto points = drawn(problem, fit);
  points.insert(points.begin(), fit.point);
  const auto all = sums_of(trial, hypothesis, points, noise);
  const auto& sums = all.front();
  const std::span others(all.begin() + 1, all.end());
  constexpr std::array names{"surge_force", "sway_force", "yaw_moment"};
  std::vector<ForceBudget> budget;
  for (std::size_t axis = 0; axis < axes; ++axis) {
    ForceBudget b{.quantity = names[axis],
                  .share = shares_of(sums.products[axis]),
                  .standard_error = {},
                  .size = sums.products[axis][0] / sums.own[axis]};
    for (const auto& other : others) {
      const auto share = shares_of(other.products[axis]);
      for (std::size_t i = 0; i < share.size(); ++i) b.standard_error[i] += std::pow(share[i] - b.share[i], 2);
    }
    for (double& error : b.standard_error) error = std::sqrt(error / static_cast<double>(others.size()));
    budget.push_back(b);
  }
  return budget;
}

}  // namespace swayaw::mismatch::detail
