#include "swayaw/identification/nomoto_zigzag.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "swayaw/core/detail/matrices.hpp"
#include "swayaw/core/refusal.hpp"

namespace swayaw::inline identification {
namespace {

/// Heading, yaw rate and ∫ delta dt at the samples that have a heading.
struct Moment {
  double time, psi, r, rudder_integral;
};

std::vector<Moment> moments(const Recording& run) {
  const Interpolant heading(run, Channel::psi), rudder(run, Channel::delta);
  const auto times = heading.times();
  const auto psi = heading.values();
  if (times.size() < 3) throw Refusal(fmt::format("{}: fewer than three headings", run.name));
  std::optional<Interpolant> yaw_rate;
  if (run.has(Channel::r)) yaw_rate.emplace(run, Channel::r);
  std::vector<Moment> result;
  double integral = 0.0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (i > 0) integral += 0.5 * (rudder(times[i - 1]) + rudder(times[i])) * (times[i] - times[i - 1]);
    const std::size_t before = i > 0 ? i - 1 : 0, after = std::min(i + 1, times.size() - 1);
    const double slope = (psi[after] - psi[before]) / (times[after] - times[before]);
    result.push_back({times[i], psi[i], yaw_rate ? (*yaw_rate)(times[i]) : slope, integral});
  }
  return result;
}

/// Heading peaks: the outermost sample of each excursion from the mean heading that reaches a third of the largest.
/// The last excursion counts only if it was left again.
std::vector<std::size_t> peaks(const std::vector<Moment>& run, double mean, double largest) {
  std::vector<std::size_t> result;
  std::size_t outermost = 0;
  const auto off = [&](std::size_t i) { return run[i].psi - mean; };
  for (std::size_t i = 1; i < run.size(); ++i) {
    if (off(i) * off(i - 1) < 0.0) {
      if (std::abs(off(outermost)) > largest / 3.0) result.push_back(outermost);
      outermost = i;
    } else if (std::abs(off(i)) > std::abs(off(outermost))) {
      outermost = i;
    }
  }
  return result;
}

/// The sample nearest the mean heading between each pair of peaks.
std::vector<std::size_t> passages(const std::vector<Moment>& run, double mean, const std::vector<std::size_t>& peaks) {
  std::vector<std::size_t> result;
  const auto distance = [&](const Moment& m) { return std::abs(m.psi - mean); };
  for (std::size_t k = 1; k < peaks.size(); ++k) {
    const auto from = run.begin() + static_cast<std::ptrdiff_t>(peaks[k - 1]),
               to = run.begin() + static_cast<std::ptrdiff_t>(peaks[k]);
    result.push_back(static_cast<std::size_t>(std::ranges::min_element(from, to, {}, distance) - run.begin()));
  }
  return result;
}

}  // namespace

NomotoZigzag nomoto_zigzag_analysis(const Recording& run) {
  const auto all = moments(run);
  const auto [low, high] = std::ranges::minmax(all, {}, &Moment::psi);
  const double start = all.front().psi, largest = std::max(high.psi - start, start - low.psi);
  const auto tops = peaks(all, start, largest), zeros = passages(all, start, tops);
  if (tops.size() < 3)
    throw Refusal(fmt::format("{}: a zigzag with three heading peaks is needed, found {}", run.name, tops.size()));
  // −T [r] + K ∫ delta dt + K delta_r (t2 − t1) = [psi]
  const auto equations = static_cast<Eigen::Index>(tops.size() + zeros.size() - 2);
  Eigen::MatrixX3d A(equations, 3);
  Eigen::VectorXd b(equations);
  Eigen::Index row = 0;
  for (const auto* marks : {&tops, &zeros}) {
    for (std::size_t k = 1; k < marks->size(); ++k, ++row) {
      const auto &p = all[(*marks)[k - 1]], &q = all[(*marks)[k]];
      A.row(row) << p.r - q.r, q.rudder_integral - p.rudder_integral, q.time - p.time;
      b[row] = q.psi - p.psi;
    }
  }
  const Eigen::Vector3d x = core::detail::least_squares(A, b);
  const double residual = std::sqrt((A * x - b).squaredNorm() / static_cast<double>(equations));
  return {.K = x[1],
          .T = x[0],
          .delta_r = x[2] / x[1],
          .intervals = static_cast<std::size_t>(equations),
          .residual = residual};
}

}  // namespace swayaw::identification
