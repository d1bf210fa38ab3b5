#include "location.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include "../compare/statistics.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/detail/matrices.hpp"
#include "swayaw/core/followed_order.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/mismatch/run_picture.hpp"

namespace swayaw::inline mismatch::detail {
namespace {

// Where words begin that tell the place of a mismatch. By judgement: no decision hangs on them.

constexpr double straight_share = 0.2;        ///< of half the largest yaw rate: almost straight ahead
constexpr double slow_share = 0.75;           ///< of the highest speed: after the loss of speed
constexpr double moving_share = 1e-3;         ///< of half the largest rudder angle between samples: the rudder moves
constexpr double least_time = 0.03;           ///< of the run: a shorter part may be one wave
constexpr double most_time = 0.8;             ///< of the run: a longer part is all along
constexpr double one_sided = 0.8;             ///< of the energy on one side
constexpr double told_place = 0.12;           ///< share of the energy beyond the share of the time
constexpr double told_symmetry = 0.15;        ///< share of the force that is explained besides
constexpr double told_beside_constant = 0.1;  ///< by the heading, beyond what a constant explains

constexpr std::array quantities{"surge_force", "sway_force", "yaw_moment"};

/// Missing accelerations of a run over what is ordinary in each axis, with the motion that they go with.
struct Traced {
  const Recording* run;
  std::vector<double> time;
  std::vector<std::array<double, 3>> missing;
  std::vector<double> delta, beta, r_prime, U, psi;
};

std::optional<Traced> traced(const Ship& ship, const PreparedRun& prepared, const Noise& noise) try {
  const auto& run = *prepared.run;
  const double L = length(ship);
  const auto ordinary = process_noise(ship, {});
  const auto force = missing_force(ship, prepared, noise);
  const Interpolant psi(run, Channel::psi);
  const auto rudder = with_followed_order(run, steering_gear(ship));
  Traced t{&run, run.time, {}, {}, {}, {}, {}, {}};
  for (std::size_t i = 0; i < force.size(); ++i) {
    const auto& m = force[i].motion;
    const double U = std::hypot(m.u, m.v);
    t.missing.push_back({force[i].acceleration.u / ordinary.u, force[i].acceleration.v / ordinary.v,
                         force[i].acceleration.r / ordinary.r});
    t.delta.push_back(rudder[Channel::delta][i]);
    t.beta.push_back(std::atan2(-m.v, m.u));
    t.r_prime.push_back(m.r * L / U);
    t.U.push_back(U);
    t.psi.push_back(psi(run.time[i]));
  }
  return t;
} catch (const std::exception&) {
  return std::nullopt;
}

std::vector<double> energy_of(const Traced& t, std::size_t axis) {
  std::vector<double> energy;
  for (const auto& m : t.missing) energy.push_back(std::isfinite(m[axis]) ? m[axis] * m[axis] : 0.0);
  return energy;
}

double sum_of(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

/// In which most force is missing.
std::size_t main_axis(std::span<const Traced> runs) {
  std::array<double, 3> size{};
  for (const auto& t : runs)
    for (std::size_t axis = 0; axis < 3; ++axis) size[axis] += sum_of(energy_of(t, axis));
  return static_cast<std::size_t>(std::ranges::max_element(size) - size.begin());
}

// ---------------------------------------------------------------- when

/// The samples with the largest sum above the mean.
IndexRange main_part(std::vector<double> energy) {
  const double mean = sum_of(energy) / static_cast<double>(energy.size());
  for (double& e : energy) e -= mean;
  return largest_sum(energy).value_or(IndexRange{0, energy.size() - 1});
}

/// Energy of a run on the axis where most force is missing, in shares of all of it.
std::vector<double> shares_of(const Traced& t) {
  auto energy = energy_of(t, main_axis({&t, 1}));
  const double all = std::max(sum_of(energy), 1e-300);
  for (double& e : energy) e /= all;
  return energy;
}

/// Share of a run's missing force that acts in a time, less the share of its samples.
double excess_within(const Traced& t, const std::vector<double>& shares, const std::pair<double, double>& interval) {
  double sum = 0.0;
  for (std::size_t i = 0; i < shares.size(); ++i)
    if (t.time[i] >= interval.first && t.time[i] <= interval.second)
      sum += shares[i] - 1.0 / static_cast<double>(shares.size());
  return sum;
}

/// Between what times most force is missing in all runs, one laid upon the other; and the same if it is missing there
/// in each of them and clearly so in their mean. Of the labelled cases it is so with all forces of a time, clearest
/// 0.75 in the mean, least 0.29, and 0.20 in the run that shows it least.
void put_intervals(Located& located, std::span<const Traced> runs) {
  constexpr double in_the_mean = 0.25, in_each = 0.15;  // of the missing force, beyond the share of the time
  struct Excess {
    double time, share;
  };
  std::vector<Excess> all;
  std::vector<std::vector<double>> shares;
  for (const auto& t : runs) {
    shares.push_back(shares_of(t));
    for (std::size_t i = 0; i < t.time.size(); ++i)
      all.push_back({t.time[i], shares.back()[i] - 1.0 / static_cast<double>(t.time.size())});
  }
  std::ranges::stable_sort(all, {}, &Excess::time);
  std::vector<double> values(all.size());
  std::ranges::transform(all, values.begin(), &Excess::share);
  const auto range = largest_sum(values);
  if (!range) return;
  const std::pair interval(all[range->first].time, all[range->last].time);
  located.most = interval;
  double sum = 0.0;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const double excess = excess_within(runs[k], shares[k], interval);
    if (!(excess > in_each)) return;
    sum += excess;
  }
  if (sum > in_the_mean * static_cast<double>(runs.size())) located.common = interval;
}

// ---------------------------------------------------------------- where

/// A part of the motion, in words, and whether each sample lies in it.
struct Region {
  std::string words;
  std::vector<char> inside;
};

double largest(const std::vector<double>& values) {
  double most = 0.0;
  for (const double v : values) most = std::max(most, std::isfinite(v) ? std::abs(v) : 0.0);
  return most;
}

Region beyond(const std::string& what, const std::vector<double>& values, double limit, double shown,
              std::string_view unit) {
  Region region{fmt::format("{} beyond {:.2g}{}", what, shown, unit), {}};
  for (const double v : values) region.inside.push_back(std::abs(v) > limit);
  return region;
}

std::vector<Region> regions_of(const Traced& t) {
  std::vector<Region> regions;
  const double delta = 0.5 * largest(t.delta), beta = 0.5 * largest(t.beta), r = 0.5 * largest(t.r_prime);
  regions.push_back(beyond("rudder", t.delta, delta, degrees(delta), " deg"));
  regions.push_back(beyond("drift", t.beta, beta, degrees(beta), " deg"));
  regions.push_back(beyond("yaw rate", t.r_prime, r, r, " U/L"));
  Region straight{"almost straight ahead", {}}, slow{"after the loss of speed", {}},
      turning{"while the rudder moves", {}};
  const double fast = *std::ranges::max_element(t.U);
  for (std::size_t i = 0; i < t.time.size(); ++i) {
    straight.inside.push_back(std::abs(t.r_prime[i]) < straight_share * r);
    slow.inside.push_back(t.U[i] < slow_share * fast);
    turning.inside.push_back(i > 0 && std::abs(t.delta[i] - t.delta[i - 1]) > moving_share * delta);
  }
  regions.push_back(std::move(straight)), regions.push_back(std::move(slow)), regions.push_back(std::move(turning));
  constexpr std::array names{"heading about north", "heading about east", "heading about south", "heading about west"};
  for (int quarter = 0; quarter < 4; ++quarter) {
    Region region{names[static_cast<std::size_t>(quarter)], {}};
    for (const double psi : t.psi) region.inside.push_back(std::abs(wrapped(psi - 0.5 * pi * quarter)) < 0.25 * pi);
    regions.push_back(std::move(region));
  }
  return regions;
}

/// Share of the energy inside less share of the time.
double excess(const Region& region, const std::vector<double>& energy) {
  double inside = 0.0, samples = 0.0;
  for (std::size_t i = 0; i < energy.size(); ++i)
    if (region.inside[i]) inside += energy[i], samples += 1.0;
  const double time = samples / static_cast<double>(energy.size());
  return time < least_time || time > most_time ? 0.0 : inside / sum_of(energy) - time;
}

/// "both sides", "turning to port" or "turning to starboard".
std::string_view side_of(const Traced& t, const Region& region, const std::vector<double>& energy) {
  double port = 0.0, starboard = 0.0;
  for (std::size_t i = 0; i < energy.size(); ++i)
    if (region.inside[i]) (t.r_prime[i] < 0.0 ? port : starboard) += energy[i];
  const double share = port / std::max(port + starboard, 1e-300);
  return share > one_sided ? "turning to port" : share < 1.0 - one_sided ? "turning to starboard" : "both sides";
}

std::string where(const Traced& t, const std::vector<double>& energy) {
  const auto regions = regions_of(t);
  const auto best = std::ranges::max_element(regions, {}, [&](const Region& r) { return excess(r, energy); });
  if (!(excess(*best, energy) > told_place)) return "all along";
  return fmt::format("{}, {}", best->words, side_of(t, *best, energy));
}

MismatchPlace place_of(const Traced& t) {
  const auto axis = main_axis({&t, 1});
  const auto energy = energy_of(t, axis);
  const auto [first, last] = main_part(energy);
  const double inside = std::accumulate(energy.begin() + static_cast<std::ptrdiff_t>(first),
                                        energy.begin() + static_cast<std::ptrdiff_t>(last) + 1, 0.0);
  return {t.run->name,     quantities[axis], t.time[first], t.time[last], inside / std::max(sum_of(energy), 1e-300),
          where(t, energy)};
}

// ---------------------------------------------------------------- symmetry

/// What a force can go with: the motion as a ship without any asymmetry feels it; a constant; the heading; changes of
/// the motion.
struct Basis {
  Eigen::MatrixXd motion, constant, heading, history;
};

Basis basis_of(std::span<const Traced> runs, std::size_t axis) {
  Eigen::Index rows = 0;
  for (const auto& t : runs) rows += static_cast<Eigen::Index>(t.time.size());
  Basis b{Eigen::MatrixXd(rows, 6), Eigen::MatrixXd(rows, 1), Eigen::MatrixXd(rows, 2), Eigen::MatrixXd::Zero(rows, 3)};
  Eigen::Index row = 0;
  for (const auto& t : runs)
    for (std::size_t i = 0; i < t.time.size(); ++i, ++row) {
      const double v = -t.beta[i], r = t.r_prime[i], d = t.delta[i], loss = 1.0 - t.U[i] / t.U[0];
      if (axis == 0) b.motion.row(row) << v * v, v * r, r * r, d * d, loss, 1.0;
      else b.motion.row(row) << v, r, d, v * std::abs(v), r * std::abs(r), d * std::abs(d);
      b.constant(row, 0) = axis == 0 ? r : 1.0;
      b.heading.row(row) << std::cos(t.psi[i]), std::sin(t.psi[i]);
      if (i > 0) b.history.row(row) << v + t.beta[i - 1], r - t.r_prime[i - 1], d - t.delta[i - 1];
    }
  return b;
}

/// Share of the force that columns explain.
double explained(const Eigen::MatrixXd& columns, const Eigen::VectorXd& force) {
  const Eigen::VectorXd rest = force - columns * core::detail::least_squares(columns, force);
  return 1.0 - rest.squaredNorm() / std::max(force.squaredNorm(), 1e-300);
}

Eigen::MatrixXd beside(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  Eigen::MatrixXd both(a.rows(), a.cols() + b.cols());
  both << a, b;
  return both;
}

std::string symmetry_of(std::span<const Traced> runs) {
  if (runs.empty()) return {};
  const auto axis = main_axis(runs);
  const auto b = basis_of(runs, axis);
  Eigen::VectorXd force(b.motion.rows());
  Eigen::Index row = 0;
  for (const auto& t : runs)
    for (const auto& m : t.missing) force[row++] = std::isfinite(m[axis]) ? m[axis] : 0.0;
  const double alone = explained(b.motion, force);
  const std::array gains{explained(beside(b.motion, b.constant), force) - alone,
                         explained(beside(b.motion, b.heading), force) - alone,
                         explained(beside(b.motion, b.history), force) - alone};
  const auto most = static_cast<std::size_t>(std::ranges::max_element(gains) - gains.begin());
  if (gains[most] < told_symmetry) return {};
  // a constant lies in the span of neither; heading explains it in part where the headings are few
  if (most == 1 && gains[1] - gains[0] < told_beside_constant) return "it differs between port and starboard";
  constexpr std::array words{"it differs between port and starboard",
                             "it goes with the heading, as what is fixed to the earth does",
                             "it goes with changes of the motion, not with the motion"};
  return words[most];
}

}  // namespace

Located located(const Trial& trial, const Ship& ship, const Noise& noise) {
  std::vector<Traced> all;
  for (const auto& run : trial.runs)
    if (auto t = traced(ship, run, noise); t && !t->time.empty()) all.push_back(std::move(*t));
  Located result;
  for (const auto& t : all) result.places.push_back(place_of(t));
  put_intervals(result, all);
  result.symmetry = symmetry_of(all);
  return result;
}

}  // namespace swayaw::mismatch::detail
