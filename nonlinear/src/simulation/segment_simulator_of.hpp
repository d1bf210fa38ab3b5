#pragma once

#include "branch_stepper.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/nonlinear/instruments/instruments.hpp"
#include "swayaw/nonlinear/simulation/segment_simulator.hpp"

/// The simulator of a model. Not installed; included by one file for each model.
namespace swayaw::inline nonlinear::detail {

template <template <class> class Model>
class ModelSegmentSimulator : public SegmentSimulator {
 public:
  ModelSegmentSimulator(const Model<double>& model, const Surroundings<double>& around,
                        const std::vector<Parameter>& parameters)
      : model_(model), around_(around), parameters_(parameters) {}

  SegmentResponse simulate(const RunSegment& segment, const StateVector<double>& start, std::span<const double> values,
                           bool with_slopes) const override {
    Model<double> ship = model_;
    set_values(ship, std::span<const Parameter>(parameters_), values);
    SegmentResponse response;
    response.residual.resize(static_cast<Eigen::Index>(segment.measurements.size()));
    if (with_slopes) simulate_slopes<8>(ship, segment, start, response);
    else simulate_values(ship, segment, start, response);
    return response;
  }

 private:
  void simulate_values(const Model<double>& ship, const RunSegment& segment, const StateVector<double>& start,
                       SegmentResponse& response) const {
    BranchStepper<Model, double> stepper(ship, ship, around_);
    response.end = along(
        stepper, segment, start, [&](Eigen::Index i, const Measurement& measurement, const StateVector<double>& s) {
          response.residual[i] =
              residual(measurement, observe(measurement.channel, kinematics(state_of(s), around_.current)));
        });
  }

  /// In passes of N derivatives; the first four are those by psi, u, v, r at the start. Those by x and y are 1 or 0.
  template <int N>
  void simulate_slopes(const Model<double>& ship, const RunSegment& segment, const StateVector<double>& start,
                       SegmentResponse& response) const {
    const auto lanes = static_cast<Eigen::Index>(6 + parameters_.size());
    response.residual_slope.setZero(response.residual.size(), lanes);
    response.end_slope.setZero(6, lanes);
    response.end_slope(0, 0) = response.end_slope(1, 1) = 1.0;
    for (std::size_t i = 0; i < segment.measurements.size(); ++i) {
      if (segment.measurements[i].channel == Channel::x) response.residual_slope(static_cast<Eigen::Index>(i), 0) = 1.0;
      if (segment.measurements[i].channel == Channel::y) response.residual_slope(static_cast<Eigen::Index>(i), 1) = 1.0;
    }
    const std::span<const Parameter> all(parameters_);
    std::size_t done = std::min<std::size_t>(all.size(), N - 4);
    pass<N>(ship, segment, start, all.first(done), true, 2, response);
    while (done < all.size()) {
      const auto some = all.subspan(done, std::min<std::size_t>(all.size() - done, N));
      pass<N>(ship, segment, start, some, false, static_cast<Eigen::Index>(6 + done), response);
      done += some.size();
    }
  }

  template <int N>
  void pass(const Model<double>& ship, const RunSegment& segment, const StateVector<double>& start,
            std::span<const Parameter> parameters, bool first, Eigen::Index column, SegmentResponse& response) const {
    using S = Dual<N>;
    const int states = first ? 4 : 0;
    const auto lanes = static_cast<Eigen::Index>(parameters.size()) + states;
    StateVector<S> s;
    for (int i = 0; i < 6; ++i)
      s[static_cast<std::size_t>(i)] =
          first && i >= 2 ? S(start[static_cast<std::size_t>(i)], i - 2) : S(start[static_cast<std::size_t>(i)]);
    const auto current = cast<S>(around_).current;
    BranchStepper<Model, S> stepper(ship, seeded<N>(ship, parameters, states), around_);
    const auto end =
        along(stepper, segment, s, [&](Eigen::Index i, const Measurement& measurement, const StateVector<S>& now) {
          const S value = observe(measurement.channel, kinematics(state_of(now), current));
          response.residual[i] = residual(measurement, value.a);
          response.residual_slope.row(i).segment(column, lanes) = value.v.head(lanes).transpose();
        });
    for (std::size_t i = 0; i < 6; ++i)
      response.end_slope.row(static_cast<Eigen::Index>(i)).segment(column, lanes) = end[i].v.head(lanes).transpose();
    response.end = values_of(end);
  }

  static double residual(const Measurement& measurement, double value) {
    return is_direction(measurement.channel) ? wrapped(value - measurement.value) : value - measurement.value;
  }

  /// Calls seen(i, measurement, state) for the measurements of the segment. @return the state at its end
  template <class S, class Seen>
  StateVector<S> along(BranchStepper<Model, S>& stepper, const RunSegment& segment, StateVector<S> s,
                       Seen&& seen) const {
    const auto& run = *segment.run;
    auto measurement = segment.measurements.begin();
    const auto see = [&](std::size_t sample) {
      for (; measurement != segment.measurements.end() && measurement->sample == sample; ++measurement)
        seen(measurement - segment.measurements.begin(), *measurement, s);
    };
    stepper.begin(values_of(s), run.controls[segment.from]);
    see(segment.from);
    for (std::size_t k = segment.from; k < segment.to; ++k) {
      const double duration = run.time[k + 1] - run.time[k], h = duration / run.steps[k];
      const ControlLine line{run.controls[k], run.controls[k + 1], duration};
      if (!run.air.empty()) stepper.blow(run.air[k]);
      for (int i = 0; i < run.steps[k]; ++i) stepper.advance(s, line, i * h, h);
      see(k + 1);
    }
    return s;
  }

  Model<double> model_;
  Surroundings<double> around_;
  std::vector<Parameter> parameters_;
};

}  // namespace swayaw::nonlinear::detail

namespace swayaw::inline nonlinear {

template <template <class> class Model>
std::unique_ptr<SegmentSimulator> segment_simulator(const Model<double>& model, const Surroundings<double>& around,
                                                    const std::vector<Parameter>& parameters) {
  return std::make_unique<detail::ModelSegmentSimulator<Model>>(model, around, parameters);
}

}  // namespace swayaw::nonlinear
