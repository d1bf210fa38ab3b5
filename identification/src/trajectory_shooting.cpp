#include "trajectory_shooting.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "swayaw/core/parallel.hpp"

namespace swayaw::trajectory {

// ---------------------------------------------------------------- axes

Axes::Axes(const Eigen::MatrixXd& A) {
  unit_ = A.diagonal().unaryExpr([](double x) { return x > 0.0 ? 1.0 / std::sqrt(x) : 1.0; });
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(unit_.asDiagonal() * A * unit_.asDiagonal());
  length_ = solver.eigenvalues();
  axis_ = solver.eigenvectors();
}

Eigen::MatrixXd Axes::inverse() const {
  Eigen::VectorXd over(length_.size());
  for (Eigen::Index i = 0; i < over.size(); ++i) over[i] = told(i) ? 1.0 / length_[i] : 0.0;
  const Eigen::MatrixXd V = unit_.asDiagonal() * axis_;
  return V * over.asDiagonal() * V.transpose();
}

double Axes::untold(Eigen::Index coordinate) const {
  double share = 0.0;
  for (Eigen::Index i = 0; i < length_.size(); ++i)
    if (!told(i)) share += axis_(coordinate, i) * axis_(coordinate, i);
  return share;
}

// ---------------------------------------------------------------- places

Place moved(const Place& from, const Move& move, double share) {
  Place to = from;
  for (std::size_t i = 0; i < to.values.size(); ++i) to.values[i] += share * move.values[static_cast<Eigen::Index>(i)];
  for (std::size_t i = 0; i < to.starts.size(); ++i) {
    for (std::size_t k = 0; k < 6; ++k) to.starts[i][k] += share * move.starts[i][static_cast<Eigen::Index>(k)];
    to.pushes[i] += share * move.pushes[i];
  }
  return to;
}

std::vector<Course> sail_legs(const TrajectoryProblem& problem, const std::vector<Leg>& legs, const Place& place,
                              bool with_slopes) {
  std::vector<Course> courses(legs.size());
  in_parallel(legs.size(), problem.threads, [&](std::size_t i) {
    courses[i] = problem.sailor->sail(legs[i].stretch, place.starts[i], place.values, with_slopes);
  });
  return courses;
}

bool finite(std::span<const Course> courses) {
  const auto one = [](const Course& c) {
    const bool values = c.residual.allFinite() && std::ranges::all_of(c.end, [](double x) { return std::isfinite(x); });
    return values && c.residual_slope.allFinite() && c.end_slope.allFinite();
  };
  return std::ranges::all_of(courses, one);
}

// ---------------------------------------------------------------- condensing

namespace {

using Vector6 = Eigen::Vector<double, 6>;

Vector6 difference(const StateVector<double>& a, const StateVector<double>& b) {
  return Eigen::Map<const Vector6>(a.data()) - Eigen::Map<const Vector6>(b.data());
}

}  // namespace

Linearization::Linearization(const TrajectoryProblem& problem, const std::vector<Leg>& legs, Place place,
                             std::vector<Course> courses, const Weights& weights, std::vector<Matrix6> disturbance,
                             const Eigen::VectorXd& prior)
    : problem_(problem),
      legs_(legs),
      place_(std::move(place)),
      courses_(std::move(courses)),
      weights_(weights),
      disturbance_(std::move(disturbance)),
      prior_(prior),
      n_(prior.size()),
      information_(prior.asDiagonal()) {
  for (std::size_t first = 0, beyond = 0; first < legs.size(); first = beyond) {
    while (beyond < legs.size() && legs[beyond].run == legs[first].run) ++beyond;
    runs_.push_back(run_of(first, beyond));
    const auto& run = runs_.back();
    const auto by_numbers = run.rows.rightCols(n_);
    information_ += by_numbers.transpose() * by_numbers - run.taken * run.mixed;
  }
}

/// How many unknowns a run has besides the numbers.
Eigen::Index Linearization::own(const Run& run) const {
  return pushed() ? static_cast<Eigen::Index>(6 * (run.beyond - run.first)) : 6;
}

Linearization::Run Linearization::run_of(std::size_t first, std::size_t beyond) const {
  Run run{.first = first,
          .beyond = beyond,
          .rows = {},
          .A = {},
          .by_start = {},
          .own_inverse = {},
          .mixed = {},
          .taken = {}};
  const Eigen::Index own = this->own(run), all = own + n_;
  Eigen::Index count = 0, row = 0;
  for (std::size_t i = first; i < beyond; ++i) count += courses_[i].residual.size();
  run.rows.resize(count, all);
  Eigen::MatrixXd A = Eigen::MatrixXd::Identity(6, all);
  for (std::size_t i = first; i < beyond; ++i) {
    const auto& course = courses_[i];
    const auto w = weighted(course, legs_[i].stretch, weights_);
    run.A.push_back(A);
    run.by_start.push_back(w.slope.leftCols<6>());
    auto rows = run.rows.middleRows(row, w.slope.rows());
    rows.noalias() = run.by_start.back() * A;
    rows.rightCols(n_) += w.slope.rightCols(n_);
    row += w.slope.rows();
    A = (course.end_slope.leftCols<6>() * A).eval();
    A.rightCols(n_) += course.end_slope.rightCols(n_);
    if (pushed() && i + 1 < beyond) A.middleCols<6>(static_cast<Eigen::Index>(6 * (i + 1 - first))) += disturbance_[i];
  }
  const auto by_own = run.rows.leftCols(own);
  Eigen::MatrixXd information = by_own.transpose() * by_own;
  information.diagonal().tail(own - 6).array() += 1.0;  // pushes are normal with deviation 1
  run.own_inverse = Axes(information).inverse();
  run.mixed = by_own.transpose() * run.rows.rightCols(n_);
  run.taken = run.mixed.transpose() * run.own_inverse;
  return run;
}

/// a_i: how far the start of each leg must move for the legs to fit together.
std::vector<Eigen::Vector<double, 6>> Linearization::drifts(const Run& run, const Place& place,
                                                            const std::vector<Course>& courses) const {
  std::vector<Vector6> a{Vector6::Zero()};
  for (std::size_t i = run.first; i + 1 < run.beyond; ++i) {
    Vector6 defect = difference(courses[i].end, place.starts[i + 1]);
    if (pushed()) defect += disturbance_[i] * place.pushes[i];
    a.push_back(courses_[i].end_slope.leftCols<6>() * a.back() + defect);
  }
  return a;
}

/// Weighted residuals as they are once the legs fit together.
Eigen::VectorXd Linearization::residual(const Run& run, const Place& place, const std::vector<Course>& courses) const {
  const auto a = drifts(run, place, courses);
  Eigen::VectorXd result(run.rows.rows());
  Eigen::Index row = 0;
  for (std::size_t i = run.first; i < run.beyond; ++i) {
    const Eigen::VectorXd own = weighted({courses[i].residual, {}, {}, {}}, legs_[i].stretch, weights_).residual;
    result.segment(row, own.size()) = own + run.by_start[i - run.first] * a[i - run.first];
    row += own.size();
  }
  return result;
}

/// Adds the pushes, which are measured to be 0, to a gradient.
Eigen::VectorXd Linearization::push_gradient(const Run& run, const Place& place,
                                             const Eigen::VectorXd& gradient) const {
  Eigen::VectorXd result = gradient;
  for (std::size_t i = run.first; pushed() && i + 1 < run.beyond; ++i)
    result.segment<6>(static_cast<Eigen::Index>(6 * (i + 1 - run.first))) += place.pushes[i];
  return result;
}

Move Linearization::step(const Place& place, const std::vector<Course>& courses, const Eigen::VectorXd& damping,
                         const Eigen::VectorXd& held) const {
  Eigen::VectorXd gradient(n_);
  for (Eigen::Index i = 0; i < n_; ++i)
    gradient[i] =
        prior_[i] * (place.values[static_cast<std::size_t>(i)] - problem_.numbers[static_cast<std::size_t>(i)].value);
  std::vector<Eigen::VectorXd> own_gradient;
  for (const auto& run : runs_) {
    const Eigen::VectorXd r = residual(run, place, courses);
    own_gradient.push_back(push_gradient(run, place, run.rows.leftCols(own(run)).transpose() * r));
    gradient += run.rows.rightCols(n_).transpose() * r - run.taken * own_gradient.back();
  }
  // numbers that are held move as they are told, the others as the equations say
  Eigen::MatrixXd information = information_ + Eigen::MatrixXd(damping.asDiagonal());
  Move move{.values = held.unaryExpr([](double x) { return std::isfinite(x) ? x : 0.0; }), .starts = {}, .pushes = {}};
  gradient += information_ * move.values;
  for (Eigen::Index i = 0; i < n_; ++i) {
    if (!std::isfinite(held[i])) continue;
    information.row(i).setZero();
    information.col(i).setZero();
    gradient[i] = 0.0;
  }
  move.values -= Axes(information).inverse() * gradient;
  for (std::size_t j = 0; j < runs_.size(); ++j) {
    const auto& run = runs_[j];
    const auto a = drifts(run, place, courses);
    Eigen::VectorXd z(own(run) + n_);
    z << -run.own_inverse * (own_gradient[j] + run.mixed * move.values), move.values;
    for (std::size_t i = 0; i < run.A.size(); ++i) {
      move.starts.push_back(run.A[i] * z + a[i]);
      const bool push = pushed() && i + 1 < run.A.size();
      move.pushes.push_back(push ? Vector6(z.segment<6>(static_cast<Eigen::Index>(6 * (i + 1))))
                                 : Vector6(Vector6::Zero()));
    }
  }
  return move;
}

double Linearization::gain(const Move& move) const {
  double sum = move.values.dot(prior_.asDiagonal() * move.values);
  for (const auto& run : runs_) {
    Eigen::VectorXd z(own(run) + n_);
    z.head<6>() = move.starts[run.first];
    for (std::size_t i = run.first; pushed() && i + 1 < run.beyond; ++i)
      z.segment<6>(static_cast<Eigen::Index>(6 * (i + 1 - run.first))) = move.pushes[i];
    z.tail(n_) = move.values;
    sum += (run.rows * z).squaredNorm() + z.segment(6, own(run) - 6).squaredNorm();
  }
  return sum;
}

std::vector<std::vector<Eigen::VectorXd>> Linearization::scores() const {
  std::vector<std::vector<Eigen::VectorXd>> result;
  for (const auto& run : runs_) {
    const Eigen::VectorXd r = residual(run, place_, courses_);
    auto& scores = result.emplace_back();
    std::size_t sample = 0;
    Eigen::Index row = 0;
    for (std::size_t i = run.first; i < run.beyond; ++i) {
      for (const auto& reading : legs_[i].stretch.readings) {
        if (scores.empty() || reading.sample != sample) scores.push_back(Eigen::VectorXd::Zero(n_));
        sample = reading.sample;
        scores.back() += r[row] * (run.rows.row(row).tail(n_).transpose() -
                                   run.taken * run.rows.row(row).head(own(run)).transpose());
        ++row;
      }
      if (!pushed() || i + 1 == run.beyond) continue;
      scores.back() -= run.taken.middleCols<6>(static_cast<Eigen::Index>(6 * (i + 1 - run.first))) * place_.pushes[i];
    }
  }
  return result;
}

}  // namespace swayaw::trajectory
