#include "trajectory_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "swayaw/core/angle.hpp"

namespace swayaw::inline identification::detail {
namespace {

// ---------------------------------------------------------------- noise

/// Sums over the residuals of a channel.
struct ChannelSum {
  double square = 0.0, count = 0.0;
};
using ChannelSums = std::array<ChannelSum, channel_count>;

/// Expected min(z², k²) of a normal variable z.
double clipped_square(double k) {
  const double outside = std::erfc(k / std::sqrt(2.0)), density = std::exp(-0.5 * k * k) / std::sqrt(2.0 * pi);
  return 1.0 - outside - 2.0 * k * density + k * k * outside;
}

/// Sums over all segments; in the robust case of residuals that are clipped at k standard deviations, made up for the
/// clipping.
ChannelSums channel_sums(const std::vector<ShootingSegment>& segments, const std::vector<SegmentResponse>& responses,
                         const Weights& weights) {
  ChannelSums sums;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (std::size_t k = 0; k < segments[i].part.measurements.size(); ++k) {
      const auto channel = index_of(segments[i].part.measurements[k].channel);
      const double e = responses[i].residual[static_cast<Eigen::Index>(k)];
      const bool clips = weights.robust && weights.noise[channel] > 0.0;
      const double most = clips ? *weights.robust * weights.noise[channel] : std::numeric_limits<double>::infinity();
      sums[channel].square += std::min(e * e, most * most) / (clips ? clipped_square(*weights.robust) : 1.0);
      sums[channel].count += 1.0;
    }
  }
  return sums;
}

/// Least noise that a channel is credited with, over its unit: residuals of an exact fit are rounding alone.
constexpr double least_noise = 1e-7;

/// Standard deviations that make the residuals most likely; `unknowns` take degrees of freedom from all channels alike.
std::array<double, channel_count> noise_of(const TrajectoryProblem& problem, const ChannelSums& sums, double unknowns) {
  double measurements = 0.0;
  for (const auto& sum : sums) measurements += sum.count;
  const double freedom = std::max(1.0 - unknowns / measurements, 0.1);
  std::array<double, channel_count> noise{};
  for (const Channel channel : problem.channels) {
    const auto& sum = sums[index_of(channel)];
    noise[index_of(channel)] =
        std::max(std::sqrt(sum.square / (sum.count * freedom)), least_noise * unit_of(channel, problem.L, problem.U));
  }
  return noise;
}

/// Known noise in place of estimated.
std::array<double, channel_count> with_known(std::array<double, channel_count> noise, const MeasurementNoise& known) {
  for (std::size_t i = 0; i < channel_count; ++i)
    if (known[i] && noise[i] > 0.0) noise[i] = *known[i];
  return noise;
}

double largest_change(const TrajectoryProblem& problem, const std::array<double, channel_count>& a,
                      const std::array<double, channel_count>& b) {
  double largest = 0.0;
  for (const Channel channel : problem.channels)
    largest = std::max(largest, std::abs(std::log(b[index_of(channel)] / a[index_of(channel)])));
  return largest;
}

}  // namespace

/// −½ Σ (e²/σ² + ln 2πσ²)
double log_likelihood(const std::vector<ShootingSegment>& segments, const std::vector<SegmentResponse>& responses,
                      const Weights& weights) {
  double sum = 0.0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    sum -= 0.5 * weighted({responses[i].residual, {}, {}, {}}, segments[i].part, weights).residual.squaredNorm();
    for (const auto& measurement : segments[i].part.measurements)
      sum -= 0.5 * std::log(2.0 * pi) + std::log(weights.noise[index_of(measurement.channel)]);
  }
  return sum;
}

// ---------------------------------------------------------------- search

namespace {

/// Where a search is.
struct Situation {
  Iterate iterate;
  std::vector<SegmentResponse> responses;
  Weights weights;
  double log_likelihood = -std::numeric_limits<double>::infinity();
};

class Searcher {
 public:
  Searcher(const SearchTask& task, const Iterate& start)
      : task_(task), now_{start, simulated(task.problem, task.segments, start, true), {}} {
    now_.weights.robust = task.options.robust;
    now_.weights.noise = noise_here({});
  }

  Found run() {
    for (int iteration = 0;; ++iteration) {
      Linearization at(task_.problem, task_.segments, now_.iterate, now_.responses, now_.weights, task_.prior);
      const auto step = at.step(damping());
      const bool there = arrives(at, step);
      const bool stuck = mu_ > 1e12;
      if (there || stopped_ || iteration >= task_.options.most_iterations || stuck)
        return {std::move(at), now_.weights, now_.iterate, status(there), stuck && !there, iteration, sensitivities_};
      if (!take(at, step)) continue;
      weigh_again();
      const auto& report = task_.options.progress;
      stopped_ = report && !report({iteration + 1, now_.log_likelihood, size_of(step), now_.iterate.values});
      watch(stopped_ || iteration + 1 == task_.options.most_iterations);
    }
  }

 private:
  TrajectoryFitStatus status(bool there) const {
    if (stopped_) return TrajectoryFitStatus::stopped;
    return there ? TrajectoryFitStatus::converged : TrajectoryFitStatus::iteration_limit;
  }

  /// An iterate on the way, where no number is out of its range by rounding.
  Iterate moved_within(const Iterate& from, const Step& move, double share) const {
    auto to = moved(from, move, share);
    for (std::size_t i = 0; i < to.values.size(); ++i) {
      const double slack = 1e-12 * task_.unit[static_cast<Eigen::Index>(i)], low = task_.problem.low[i],
                   high = task_.problem.high[i];
      to.values[i] = to.values[i] < low + slack ? low : to.values[i] > high - slack ? high : to.values[i];
    }
    return to;
  }

  /// Estimated and known noise.
  std::array<double, channel_count> noise_here(const Weights& weights) const {
    const double unknowns =
        6.0 * static_cast<double>(task_.problem.runs.size()) + static_cast<double>(task_.problem.parameters.size());
    return with_known(noise_of(task_.problem, channel_sums(task_.segments, now_.responses, weights), unknowns),
                      task_.options.noise);
  }

  Eigen::VectorXd damping() const { return mu_ * task_.unit.array().square().inverse(); }

  /// Changes of a start in units of the ship.
  Eigen::VectorXd in_units(const Eigen::VectorXd& change) const {
    return change.cwiseQuotient(state_unit_.head(change.size()));
  }

  /// Root mean square of the changes, parameters in their units, starts in those of the ship.
  double size_of(const Step& move) const {
    double sum = move.values.cwiseQuotient(task_.unit).squaredNorm() / static_cast<double>(move.values.size());
    for (const auto& start : move.starts)
      sum += in_units(start).squaredNorm() / (6.0 * static_cast<double>(move.starts.size()));
    return std::sqrt(sum);
  }

  /// Squared standard deviations that are not worth a simulation, and those over which derivatives hardly change.
  static constexpr double nothing = 1e-5, little = 0.1;

  bool ends(const Linearization& at, const Step& move) const {
    const auto far = [&](const auto& start) { return in_units(start).cwiseAbs().maxCoeff() > 1e-4; };
    return at.gain(move) < nothing && std::ranges::none_of(move.starts, far);
  }

  /// Whether the step gains next to nothing and closes no gaps, or so does the one that would follow a small step, by
  /// the same derivatives. Takes what is left of the way.
  bool arrives(const Linearization& at, const Step& step) {
    if (change_ > 0.1) return false;
    auto next = moved_within(now_.iterate, step, 1.0);
    if (ends(at, step)) {
      if (change_ > 1e-3) return false;
      now_.iterate = std::move(next);
      return true;
    }
    if (at.gain(step) > little) return false;
    auto responses = simulated(task_.problem, task_.segments, next, false);
    if (!finite(responses)) return false;
    const auto rest = at.step(next, responses, damping());
    if (!ends(at, rest)) return false;
    now_.iterate = moved_within(next, rest, 1.0);
    now_.responses = std::move(responses);
    weigh_again();
    return change_ < 1e-3;
  }

  /// Takes the step, its half or its quarter: the longest after which the same derivatives ask for less of a move than
  /// before (Deuflhard's natural test). The sum of squares may rise on the way, as it must where a narrow valley bends.
  /// Source: [Deuflhard2011] sections 3.3, 4.3
  bool take(const Linearization& at, const Step& step) {
    const double whole = size_of(step);
    for (double share = 1.0; share > 0.2; share *= 0.5) {
      auto iterate = moved_within(at.iterate(), step, share);
      auto responses = simulated(task_.problem, task_.segments, iterate, true);
      sensitivities_ += 1.0;
      if (!finite(responses) || size_of(at.step(iterate, responses, damping())) > (1.0 - 0.25 * share) * whole)
        continue;
      now_.iterate = std::move(iterate);
      now_.responses = std::move(responses);
      mu_ = std::max(least_damping, 0.1 * mu_);
      return true;
    }
    mu_ *= 100.0;
    return false;
  }

  /// The noise that makes the residuals here most likely.
  void weigh_again() {
    const auto noise = noise_here(now_.weights);
    change_ = largest_change(task_.problem, now_.weights.noise, noise);
    now_.weights.noise = noise;
    now_.log_likelihood = log_likelihood(task_.segments, now_.responses, now_.weights);
  }

  /// Largest gap between the end of a segment and the beginning of the next, in ship units.
  double largest_gap() const {
    double largest = 0.0;
    for (std::size_t i = 0; i < task_.segments.size(); ++i) {
      if (!task_.segments[i].joined) continue;
      largest = std::max(largest, in_units(now_.responses[i].end - now_.iterate.starts[i + 1]).cwiseAbs().maxCoeff());
    }
    return largest;
  }

  /// Gaps that count as closed: smaller than the noise of every channel, or segments with gaps would seem more likely
  /// than the run without.
  double closed() const {
    double least = 1e-3;
    for (const Channel channel : task_.problem.channels)
      least =
          std::min(least, now_.weights.noise[index_of(channel)] / unit_of(channel, task_.problem.L, task_.problem.U));
    return least;
  }

  /// Keeps the most likely iterate whose segments fit together; a robust fit, whose noise is not that of largest
  /// likelihood, the last one. A search that has not found a better one for some steps, or that takes no more, goes
  /// back to it.
  void watch(bool last) {
    constexpr int patience = 4;
    if (task_.options.robust || (now_.log_likelihood > best_.log_likelihood && largest_gap() < closed())) {
      best_ = now_;
      since_best_ = 0;
      return;
    }
    const bool known = std::isfinite(best_.log_likelihood);
    if (!known || (++since_best_ <= patience && !last)) return;
    now_ = best_;
    since_best_ = 0;
    change_ = 1.0;
    mu_ = std::max(mu_, worst_mu_) * 100.0;
    worst_mu_ = mu_;
  }

  static constexpr double least_damping =
      0.01;  ///< a number that nothing tells of moves as if it were known to ten times its size

  const SearchTask& task_;
  Eigen::VectorXd state_unit_ = state_units(task_.problem);
  Situation now_, best_;
  int since_best_ = 0;
  double change_ = 1.0;  ///< of the noise in the last step
  double mu_ = least_damping, worst_mu_ = least_damping;
  double sensitivities_ = 1.0;
  bool stopped_ = false;
};

}  // namespace

Found search_from(const SearchTask& task, const Iterate& start) { return Searcher(task, start).run(); }

}  // namespace swayaw::identification::detail
