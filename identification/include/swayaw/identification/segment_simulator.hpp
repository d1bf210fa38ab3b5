#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "swayaw/core/recording.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"

/// Segments of recorded runs, simulated with exact derivatives by the state at their beginning and by parameters of the
/// ship.
namespace swayaw::inline identification {

/// A value that a channel has at a sample.
struct Measurement {
  std::size_t sample;
  Channel channel;
  double value;
};

/// A recording made ready for simulation.
struct SampledRun {
  std::vector<double> time;
  std::vector<Controls<double>> controls;  ///< at each sample; in straight lines between
  std::vector<int> steps;                  ///< of integration, from each sample to the next
  std::vector<Measurement> measurements;   ///< in the order of samples
  std::vector<Change> changes{};           ///< of wind and forces, in order of time: all_changes of the ship
};

/// Part of a run from one sample to another, with the measurements that belong to it.
struct RunSegment {
  const SampledRun* run;
  std::size_t from;
  std::size_t to;
  std::span<const Measurement> measurements;
};

using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A simulated segment. Derivatives are by the states at its beginning and then by the parameters.
struct SegmentResponse {
  Eigen::VectorXd residual;  ///< shown − measured
  Eigen::VectorXd end;       ///< all states
  RowMatrix residual_slope;  ///< a row for each measurement; empty if not asked for
  RowMatrix end_slope;       ///< a row for each state
};

/// Simulates segments with the classical Runge–Kutta step, which ends where the force model changes its branch.
///
/// The states are x, y, psi, u, v, r and, where effects of the ship have some, the hidden ones after them. At the
/// beginning of a run these are those of a steady motion, and only the six are given.
class SegmentSimulator {
 public:
  virtual ~SegmentSimulator() = default;

  /// How many states there are.
  virtual Eigen::Index states() const = 0;

  /// From the states at the first sample of the segment, all of them or six, with these values of the parameters.
  virtual SegmentResponse simulate(const RunSegment& segment, const Eigen::VectorXd& start,
                                   std::span<const double> values, bool with_slopes) const = 0;

  /// All states where six are given, and the controls.
  virtual Eigen::VectorXd steady(const Eigen::VectorXd& motion, const Controls<double>& controls) const = 0;
};

/// Of a ship with her effects; wind and current are her own, and that of the runs.
///
/// The parameters are those of her model, which effects may change after they are set. A channel that is late is read
/// off a motion moved back by constant accelerations (moved_back).
///
/// @throws Refusal  where one of her effects cannot act on her model
std::unique_ptr<SegmentSimulator> segment_simulator(const Ship& ship, const std::vector<Parameter>& parameters);

namespace detail {

/// For ships with effects, and for others. Each model is compiled in a file of its own.
template <template <class> class Model, bool with_effects>
std::unique_ptr<SegmentSimulator> make_segment_simulator(const ActingShip<Model<double>>& acting, const Ship& ship,
                                                         const std::vector<Parameter>& parameters);

}  // namespace detail

}  // namespace swayaw::identification
