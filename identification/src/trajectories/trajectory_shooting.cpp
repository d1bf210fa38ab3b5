#include "trajectory_shooting.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "../estimation/bounded_step.hpp"
#include "../regression/spectrum.hpp"
#include "swayaw/core/parallel.hpp"

namespace swayaw::inline identification::detail {

// ---------------------------------------------------------------- iterates

Iterate moved(const Iterate& from, const Step& move, double share) {
  Iterate to = from;
  for (std::size_t i = 0; i < to.values.size(); ++i) to.values[i] += share * move.values[static_cast<Eigen::Index>(i)];
  for (std::size_t i = 0; i < to.starts.size(); ++i) to.starts[i] += share * move.starts[i];
  return to;
}

std::vector<SegmentResponse> simulated(const TrajectoryProblem& problem, const std::vector<ShootingSegment>& segments,
                                       const Iterate& iterate, bool with_slopes) {
  std::vector<SegmentResponse> responses(segments.size());
  in_parallel(segments.size(), problem.threads, [&](std::size_t i) {
    responses[i] = problem.simulator->simulate(segments[i].part, iterate.starts[i], iterate.values, with_slopes);
  });
  return responses;
}

bool finite(std::span<const SegmentResponse> responses) {
  const auto one = [](const SegmentResponse& c) {
    return c.residual.allFinite() && c.end.allFinite() && c.residual_slope.allFinite() && c.end_slope.allFinite();
  };
  return std::ranges::all_of(responses, one);
}

// ---------------------------------------------------------------- condensing

Linearization::Linearization(const TrajectoryProblem& problem, const std::vector<ShootingSegment>& segments,
                             Iterate iterate, std::vector<SegmentResponse> responses, const Weights& weights,
                             const Eigen::VectorXd& prior)
    : problem_(problem),
      segments_(segments),
      at_(std::move(iterate)),
      responses_(std::move(responses)),
      weights_(weights),
      prior_(prior),
      n_(prior.size()),
      information_(prior.asDiagonal()) {
  for (std::size_t first = 0, beyond = 0; first < segments.size(); first = beyond) {
    while (beyond < segments.size() && segments[beyond].run == segments[first].run) ++beyond;
    runs_.push_back(run_of(first, beyond));
    const auto& run = runs_.back();
    const auto by_parameter = run.rows.rightCols(n_);
    information_ += by_parameter.transpose() * by_parameter - run.taken * run.mixed;
  }
}

Linearization::Run Linearization::run_of(std::size_t first, std::size_t beyond) const {
  Run run{.first = first,
          .beyond = beyond,
          .rows = {},
          .A = {},
          .by_start = {},
          .start_inverse = {},
          .mixed = {},
          .taken = {}};
  Eigen::Index count = 0, row = 0;
  for (std::size_t i = first; i < beyond; ++i) count += responses_[i].residual.size();
  run.rows.resize(count, 6 + n_);
  Eigen::MatrixXd A = Eigen::MatrixXd::Identity(6, 6 + n_);
  for (std::size_t i = first; i < beyond; ++i) {
    const auto& response = responses_[i];
    const auto w = weighted(response, segments_[i].part, weights_);
    run.A.push_back(A);
    const auto states = w.slope.cols() - n_;
    run.by_start.push_back(w.slope.leftCols(states));
    auto rows = run.rows.middleRows(row, w.slope.rows());
    rows.noalias() = run.by_start.back() * A;
    rows.rightCols(n_) += w.slope.rightCols(n_);
    row += w.slope.rows();
    A = (response.end_slope.leftCols(states) * A).eval();
    A.rightCols(n_) += response.end_slope.rightCols(n_);
  }
  const auto by_start = run.rows.leftCols<6>();
  run.start_inverse = spectrum_of(by_start.transpose() * by_start, no_information).inverse();
  run.mixed = by_start.transpose() * run.rows.rightCols(n_);
  run.taken = run.mixed.transpose() * run.start_inverse;
  return run;
}

/// a_i: how far the start of each segment must move for the segments to fit together.
std::vector<Eigen::VectorXd> Linearization::drifts(const Run& run, const Iterate& iterate,
                                                   const std::vector<SegmentResponse>& responses) const {
  std::vector<Eigen::VectorXd> a{Eigen::VectorXd::Zero(6)};
  for (std::size_t i = run.first; i + 1 < run.beyond; ++i)
    a.push_back(responses_[i].end_slope.leftCols(a.back().size()) * a.back() + responses[i].end -
                iterate.starts[i + 1]);
  return a;
}

/// Weighted residuals as they are once the segments fit together.
Eigen::VectorXd Linearization::residual(const Run& run, const Iterate& iterate,
                                        const std::vector<SegmentResponse>& responses) const {
  const auto a = drifts(run, iterate, responses);
  Eigen::VectorXd result(run.rows.rows());
  Eigen::Index row = 0;
  for (std::size_t i = run.first; i < run.beyond; ++i) {
    const Eigen::VectorXd own = weighted({responses[i].residual, {}, {}, {}}, segments_[i].part, weights_).residual;
    result.segment(row, own.size()) = own + run.by_start[i - run.first] * a[i - run.first];
    row += own.size();
  }
  return result;
}

Step Linearization::step(const Iterate& iterate, const std::vector<SegmentResponse>& responses,
                         const Eigen::VectorXd& damping) const {
  Eigen::VectorXd gradient(n_), low(n_), high(n_);
  for (Eigen::Index i = 0; i < n_; ++i) {
    const auto k = static_cast<std::size_t>(i);
    gradient[i] = prior_[i] * (iterate.values[k] - problem_.parameters[k].value);
    low[i] = std::min(problem_.low[k] - iterate.values[k], 0.0);
    high[i] = std::max(problem_.high[k] - iterate.values[k], 0.0);
  }
  std::vector<Eigen::Vector<double, 6>> by_start;
  for (const auto& run : runs_) {
    const Eigen::VectorXd r = residual(run, iterate, responses);
    by_start.push_back(run.rows.leftCols<6>().transpose() * r);
    gradient += run.rows.rightCols(n_).transpose() * r - run.taken * by_start.back();
  }
  const Eigen::MatrixXd information = information_ + Eigen::MatrixXd(damping.asDiagonal());
  const Eigen::VectorXd size = column_sizes(information.diagonal()), over = size.cwiseInverse();
  const Eigen::VectorXd scaled =
      bounded_step(over.asDiagonal() * information * over.asDiagonal(), over.cwiseProduct(gradient),
                   size.cwiseProduct(low), size.cwiseProduct(high), std::numeric_limits<double>::infinity());
  Step move{.values = over.cwiseProduct(scaled), .starts = {}};
  for (std::size_t j = 0; j < runs_.size(); ++j) {
    const auto& run = runs_[j];
    const auto a = drifts(run, iterate, responses);
    Eigen::VectorXd z(6 + n_);
    z << -run.start_inverse * (by_start[j] + run.mixed * move.values), move.values;
    for (std::size_t i = 0; i < run.A.size(); ++i) move.starts.push_back(run.A[i] * z + a[i]);
  }
  return move;
}

double Linearization::gain(const Step& move) const {
  double sum = move.values.dot(prior_.asDiagonal() * move.values);
  for (const auto& run : runs_) {
    Eigen::VectorXd z(6 + n_);
    z << move.starts[run.first], move.values;
    sum += (run.rows * z).squaredNorm();
  }
  return sum;
}

std::vector<std::vector<Eigen::VectorXd>> Linearization::scores() const {
  std::vector<std::vector<Eigen::VectorXd>> result;
  for (const auto& run : runs_) {
    const Eigen::VectorXd r = residual(run, at_, responses_);
    auto& scores = result.emplace_back();
    std::size_t sample = 0;
    Eigen::Index row = 0;
    for (std::size_t i = run.first; i < run.beyond; ++i) {
      for (const auto& measurement : segments_[i].part.measurements) {
        if (scores.empty() || measurement.sample != sample) scores.push_back(Eigen::VectorXd::Zero(n_));
        sample = measurement.sample;
        scores.back() +=
            r[row] * (run.rows.row(row).tail(n_).transpose() - run.taken * run.rows.row(row).head<6>().transpose());
        ++row;
      }
    }
  }
  return result;
}

}  // namespace swayaw::identification::detail
