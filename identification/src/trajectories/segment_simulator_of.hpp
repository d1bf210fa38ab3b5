#pragma once

#include <algorithm>
#include <cmath>

#include "branch_stepper.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/identification/segment_simulator.hpp"
#include "swayaw/nonlinear/instruments/instruments.hpp"

/// The simulator of a model. Not installed; included by one file for each model.
namespace swayaw::inline identification::detail {

template <template <class> class Model, bool with_effects>
class ModelSegmentSimulator final : public SegmentSimulator {
 public:
  ModelSegmentSimulator(const ActingShip<Model<double>>& acting, const Ship& ship,
                        const std::vector<Parameter>& parameters)
      : model_(std::get<Model<double>>(ship.model)),
        around_(acting.surroundings),
        effects_(active_effects(ship)),
        acting_(acting.added.acting),
        instruments_(acting.instruments),
        parameters_(parameters) {
    const auto hides = [](const Change& change) { return ActingEffects<>{.acting = change.acting}.hidden(); };
    if (acting.added.hidden() || std::ranges::any_of(acting.changes, hides)) states_ += hidden_states;
  }

  Eigen::Index states() const override { return states_; }

  Eigen::VectorXd steady(const Eigen::VectorXd& motion, const Controls<double>& controls) const override {
    return vector(settled(state_from(motion), ship_of(model_), controls));
  }

  SegmentResponse simulate(const RunSegment& segment, const Eigen::VectorXd& start, std::span<const double> values,
                           bool with_slopes) const override {
    auto model = model_;
    set_values(model, std::span<const Parameter>(parameters_), values);
    SegmentResponse response;
    response.residual.resize(static_cast<Eigen::Index>(segment.measurements.size()));
    if (with_slopes) simulate_slopes<8>(model, segment, start, response);
    else simulate_values(model, segment, start, response);
    return response;
  }

 private:
  static constexpr Eigen::Index hidden_states = with_effects ? hidden_count : 0;
  template <class S>
  using State = StepperState<S, static_cast<std::size_t>(hidden_states)>;
  template <class S>
  using ModelStepper = BranchStepper<Model, S, with_effects>;

  /// The ship of a model before her effects change it.
  template <class S>
  ShipIn<Model, S, with_effects> ship_of(const Model<S>& model) const {
    ShipIn<Model, S, with_effects> ship{.model = model, .around = cast<S>(around_)};
    if constexpr (with_effects) {
      std::vector<EffectIn<S>> effects;
      for (const auto& effect : effects_) effects.push_back(cast<S>(effect));
      ship.model = changed_by<Model<S>>(effects, model);
      ship.added = acting_effects(ship.model, std::span<const EffectIn<S>>(effects));
      ship.added.acting = acting_;
      ship.instruments = cast<S>(instruments_);
    }
    return ship;
  }

  // ---------------------------------------------------------------- states

  /// The hidden states are those of a steady motion.
  template <class S>
  static State<S> settled(State<S> s, const ShipIn<Model, S, with_effects>& ship, const Controls<double>& controls) {
    if constexpr (with_effects)
      std::ranges::copy(steady_hidden(ship.model, ship.added, visible(s).motion, cast<S>(controls)), s.begin() + 6);
    return s;
  }

  static State<double> state_from(const Eigen::VectorXd& given) {
    State<double> s{};
    std::copy(given.begin(), given.end(), s.begin());
    return s;
  }

  Eigen::VectorXd vector(const State<double>& s) const { return Eigen::Map<const Eigen::VectorXd>(s.data(), states_); }

  // ---------------------------------------------------------------- simulation

  void simulate_values(const Model<double>& model, const RunSegment& segment, const Eigen::VectorXd& start,
                       SegmentResponse& response) const {
    const auto ship = ship_of(model);
    ModelStepper<double> stepper(ship, ship);
    response.end = vector(along(stepper, segment, state_from(start), start.size(), [&](Eigen::Index i, double value) {
      response.residual[i] = residual(segment.measurements[static_cast<std::size_t>(i)], value);
    }));
  }

  /// In passes of N derivatives. Those by x and y, which no force knows, are 1 or 0.
  template <int N>
  void simulate_slopes(const Model<double>& model, const RunSegment& segment, const Eigen::VectorXd& start,
                       SegmentResponse& response) const {
    const auto variables = start.size() + static_cast<Eigen::Index>(parameters_.size());
    response.residual_slope.setZero(response.residual.size(), variables);
    response.end_slope.setZero(states(), variables);
    response.end_slope(0, 0) = response.end_slope(1, 1) = 1.0;
    for (std::size_t i = 0; i < segment.measurements.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      const auto& [sample, channel, value] = segment.measurements[i];
      const double scale = instruments_[channel].scale;
      if (channel == Channel::x) response.residual_slope(row, 0) = scale;
      if (channel == Channel::y) response.residual_slope(row, 1) = scale;
    }
    for (Eigen::Index first = 2; first < variables; first += N)
      pass<N>(model, segment, start, first, std::min<Eigen::Index>(variables - first, N), response);
  }

  /// Derivatives by `count` of the variables.
  template <int N>
  void pass(const Model<double>& model, const RunSegment& segment, const Eigen::VectorXd& start, Eigen::Index first,
            Eigen::Index count, SegmentResponse& response) const {
    using S = Dual<N>;
    State<S> s{};
    for (Eigen::Index i = 0; i < start.size(); ++i) {
      s[static_cast<std::size_t>(i)] = S(start[i]);
      if (i >= first && i < first + count) s[static_cast<std::size_t>(i)].v[i - first] = 1.0;
    }
    const auto begin = std::max<Eigen::Index>(first - start.size(), 0), end = first + count - start.size();
    const auto some =
        std::span<const Parameter>(parameters_)
            .subspan(static_cast<std::size_t>(begin), static_cast<std::size_t>(std::max<Eigen::Index>(end - begin, 0)));
    const auto lane = static_cast<int>(start.size() + begin - first);
    ModelStepper<S> stepper(ship_of(model), ship_of(seeded<N>(model, some, lane)));
    const auto last = along(stepper, segment, s, start.size(), [&](Eigen::Index i, const S& value) {
      response.residual[i] = residual(segment.measurements[static_cast<std::size_t>(i)], value.a);
      response.residual_slope.row(i).segment(first, count) = value.v.head(count).transpose();
    });
    for (Eigen::Index i = 0; i < states_; ++i)
      response.end_slope.row(i).segment(first, count) = last[static_cast<std::size_t>(i)].v.head(count).transpose();
    response.end = vector(values_of(last));
  }

  static double residual(const Measurement& measurement, double value) {
    return is_direction(measurement.channel) ? wrapped(value - measurement.value) : value - measurement.value;
  }

  /// Near a sample, on straight lines.
  static Controls<double> controls_at(const SampledRun& run, std::size_t sample, double time) {
    while (sample > 0 && run.time[sample] > time) --sample;
    while (sample + 2 < run.time.size() && run.time[sample + 1] < time) ++sample;
    if (sample + 1 == run.time.size()) return run.controls[sample];
    const double share = (time - run.time[sample]) / (run.time[sample + 1] - run.time[sample]);
    return between(run.controls[sample], run.controls[sample + 1], std::clamp(share, 0.0, 1.0));
  }

  /// What the instruments show of a ship at a sample. Her mean acceleration on the way to another time is that at the
  /// sample; half way there, for the looks of a channel that was smoothed: what a filter does is of the second order.
  template <class S>
  S shown(const ModelStepper<S>& stepper, Channel channel, const State<S>& s, const SampledRun& run,
          std::size_t sample) const {
    const auto& current = stepper.ship().around.current;
    const auto state = visible(s);
    if constexpr (!with_effects) {
      return observe(channel, kinematics(state, current));
    } else {
      const S phi = shown_by(hidden_of(s), Channel::phi);
      const bool smoothed = instruments_[channel].smoothing.acts();
      const auto acceleration = [&](const State<S>& at, const Controls<double>& controls) {
        const auto rate = stepper.rates(at, controls);
        return PlanarAcceleration<S>{rate[3], rate[4], rate[5]};
      };
      const auto ago = [&](const S& delay) {
        if (value_of(delay) == 0.0) return kinematics(state, current, phi);
        auto mean = acceleration(s, run.controls[sample]);
        if (smoothed) {
          const auto half_way = vector_of(moved_back(state, current, mean, S(0.5 * delay)));
          auto there = s;
          std::ranges::copy(half_way, there.begin());
          mean = acceleration(there, controls_at(run, sample, run.time[sample] - 0.5 * value_of(delay)));
        }
        return kinematics(moved_back(state, current, mean, delay), current, phi);
      };
      return observe(channel, stepper.ship().instruments, ago, {run.time[sample], run.time.front()});
    }
  }

  /// Calls seen(i, value) with what is shown where the segment was measured.
  /// @param given  how many of the states are
  /// @return the state at its end
  template <class S, class Seen>
  State<S> along(ModelStepper<S>& stepper, const RunSegment& segment, State<S> s, Eigen::Index given,
                 Seen&& seen) const {
    const auto& run = *segment.run;
    auto change = run.changes.begin();
    const auto pass_changes = [&](double time) {
      for (; change != run.changes.end() && change->time <= time; ++change) stepper.apply(*change);
    };
    auto measurement = segment.measurements.begin();
    const auto see = [&](std::size_t sample) {
      for (; measurement != segment.measurements.end() && measurement->sample == sample; ++measurement)
        seen(measurement - segment.measurements.begin(), shown(stepper, measurement->channel, s, run, sample));
    };
    pass_changes(run.time[segment.from]);
    if (given == 6) s = settled(s, stepper.ship(), run.controls[segment.from]);
    stepper.begin(s, run.controls[segment.from]);
    see(segment.from);
    for (std::size_t k = segment.from; k < segment.to; ++k) {
      const double duration = run.time[k + 1] - run.time[k], h = duration / run.steps[k];
      const ControlLine line{run.controls[k], run.controls[k + 1], duration};
      pass_changes(run.time[k]);
      for (int i = 0; i < run.steps[k]; ++i) {
        double from = i * h;
        const double to = (i + 1) * h;
        for (; change != run.changes.end() && change->time < run.time[k] + to; stepper.apply(*change++)) {
          const double there = change->time - run.time[k];
          if (there > from) stepper.advance(s, line, from, there - from);
          from = std::max(from, there);
        }
        stepper.advance(s, line, from, to - from);
      }
      see(k + 1);
    }
    return s;
  }

  Model<double> model_;  ///< before effects change it
  Surroundings<double> around_;
  std::vector<Effect> effects_;
  std::uint32_t acting_;
  Instruments<double> instruments_;
  std::vector<Parameter> parameters_;
  Eigen::Index states_ = 6;
};

template <template <class> class Model, bool with_effects>
std::unique_ptr<SegmentSimulator> make_segment_simulator(const ActingShip<Model<double>>& acting, const Ship& ship,
                                                         const std::vector<Parameter>& parameters) {
  return std::make_unique<ModelSegmentSimulator<Model, with_effects>>(acting, ship, parameters);
}

}  // namespace swayaw::identification::detail
