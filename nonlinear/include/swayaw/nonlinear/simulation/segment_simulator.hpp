#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "swayaw/core/recording.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/ship.hpp"

/// Segments of recorded runs, simulated with exact derivatives by the state at their beginning and by parameters of the
/// ship.
namespace swayaw::inline nonlinear {

/// A value that a channel has at a sample.
struct Measurement {
  std::size_t sample;
  Channel channel;
  double value;
};

/// What blows for a while.
struct Air {
  Wind<double> wind;
  bool windy;
};

/// A recording made ready for simulation.
struct SampledRun {
  std::vector<double> time;
  std::vector<Controls<double>> controls;  ///< at each sample; in straight lines between
  std::vector<int> steps;                  ///< of integration, from each sample to the next
  std::vector<Measurement> measurements;   ///< in the order of samples
  std::vector<Air> air{};                  ///< from each sample on, all of it; empty where no wind was recorded
};

/// Part of a run from one sample to another, with the measurements that belong to it.
struct RunSegment {
  const SampledRun* run;
  std::size_t from;
  std::size_t to;
  std::span<const Measurement> measurements;
};

using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A simulated segment. Derivatives are by x, y, psi, u, v, r at its beginning and then by the parameters.
struct SegmentResponse {
  Eigen::VectorXd residual;  ///< shown − measured
  StateVector<double> end;
  RowMatrix residual_slope;  ///< a row for each measurement; empty if not asked for
  RowMatrix end_slope;       ///< a row for each of x, y, psi, u, v, r
};

/// Simulates segments with the classical Runge–Kutta step, which ends where the force model changes its branch.
class SegmentSimulator {
 public:
  virtual ~SegmentSimulator() = default;

  /// From a state at the first sample of the segment, with these values of the parameters.
  virtual SegmentResponse simulate(const RunSegment& segment, const StateVector<double>& start,
                                   std::span<const double> values, bool with_slopes) const = 0;
};

/// Each model is compiled in a file of its own.
template <template <class> class Model>
std::unique_ptr<SegmentSimulator> segment_simulator(const Model<double>& model, const Surroundings<double>& around,
                                                    const std::vector<Parameter>& parameters);

}  // namespace swayaw::nonlinear
