#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "swayaw/core/recording.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/ship.hpp"

/// Stretches of recorded runs, simulated with exact derivatives by the state at their beginning and by numbers of the
/// ship. Not installed.
namespace swayaw {

/// A number measured at a sample.
struct Reading {
  std::size_t sample;
  Channel channel;
  double value;
};

/// A recording made ready for simulation.
struct CourseRun {
  std::vector<double> time;
  std::vector<Controls<double>> controls;  ///< at each sample; in straight lines between
  std::vector<int> steps;                  ///< of integration, from each sample to the next
  std::vector<Reading> readings;           ///< in the order of samples
};

/// Part of a run from one sample to another, with the readings that belong to it.
struct Stretch {
  const CourseRun* run;
  std::size_t from;
  std::size_t to;
  std::span<const Reading> readings;
};

using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A simulated stretch. Derivatives are by x, y, psi, u, v, r at its beginning and then by the numbers.
struct Course {
  Eigen::VectorXd residual;  ///< shown − measured
  StateVector<double> end;
  RowMatrix residual_slope;  ///< a row for each reading; empty if not asked for
  RowMatrix end_slope;       ///< a row for each of x, y, psi, u, v, r
};

/// Simulates stretches with the classical Runge–Kutta step, which ends where the force model changes its branch.
class Sailor {
 public:
  virtual ~Sailor() = default;

  /// From a state at the first sample of the stretch, with these values of the numbers.
  virtual Course sail(const Stretch& stretch, const StateVector<double>& start, std::span<const double> values,
                      bool with_slopes) const = 0;
};

using NumberList = std::vector<Parameter>;

/// One for each model; each is compiled in a file of its own.
std::unique_ptr<Sailor> sailor_of(const MmgShip<double>& model, const Surroundings<double>& around,
                                  const NumberList& numbers);
std::unique_ptr<Sailor> sailor_of(const PiShip<double>& model, const Surroundings<double>& around,
                                  const NumberList& numbers);
std::unique_ptr<Sailor> sailor_of(const PuShip<double>& model, const Surroundings<double>& around,
                                  const NumberList& numbers);
std::unique_ptr<Sailor> sailor_of(const AbkowitzShip<double>& model, const Surroundings<double>& around,
                                  const NumberList& numbers);

}  // namespace swayaw
