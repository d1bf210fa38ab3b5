#pragma once

#include <fmt/format.h>

#include "run_filter.hpp"
#include "state_slopes.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/replay.hpp"

/// What a filter of N states does, for the two files that compile it. Not installed.
namespace swayaw::inline identification::detail {

template <int N>
class RunFilterOf final : public RunFilter<N> {
 public:
  RunFilterOf(const Ship& ship, const Recording& run, std::span<const Channel> channels, const ShipState<double>& start,
              double tau, double longest_step, std::shared_ptr<const RunControls> known, const Recording* finer)
      : run_(run),
        finer_(finer),
        channels_(channels),
        controls_(controls_of(ship, run, finer, std::move(known))),
        predictor_(ship, controls_->recorded.wind(), tau, longest_step),
        observer_(instruments_of(ship), predictor_.current()),
        start_(start),
        L_(length(ship)),
        U_0_(service_speed(ship)) {}

  void forward(const FilterNoise& noise, FilteredRun<N>& pass,
               const std::function<void(std::size_t, const Gaussian<N>&)>& tell) override {
    pass.restart(run_.samples(), channels_.size());
    pass.tau = predictor_.tau();
    pass.controls = controls_;
    Gaussian<N> estimate = start(noise);
    predictor_.restart(estimate.mean);
    double log_likelihood = 0.0;
    for (std::size_t k = 0; k < run_.samples(); ++k) {
      if (k > 0) predict(estimate, k, noise, pass);
      log_likelihood += measure(estimate, k, noise, pass);
      pass.passed.push_back({pass.steps.size(), pass.innovations.size(), log_likelihood});
      if (tell) tell(k, estimate);
      if (!pass.kept) pass.forget_steps();
    }
  }

  FilterNoise backward(const FilterNoise& noise, const FilteredRun<N>& pass,
                       const std::function<void(std::size_t, const Smoother<N>&)>& tell) const override {
    FilterNoise slope = FilterNoise::Zero();
    Smoother<N> smoother;
    std::size_t slope_count = pass.slopes.size();
    for (std::size_t k = pass.passed.size(); k-- > 0;) {
      if (tell) tell(k, smoother);
      const auto before = k == 0 ? Passed{} : pass.passed[k - 1];
      for (std::size_t i = pass.passed[k].innovations; i-- > before.innovations;) {
        const auto& now = pass.innovations[i];
        const int place = place_of(now.channel);
        // S' = |e| √S/c of an outlier grows with R half as fast as its widening says
        const double share = now.widening > 1.0 ? 0.5 * now.widening : 1.0;
        slope[place] += share * noise[place] *
                        smoother.step_back(now, now.state >= 0 ? ChannelSlope() : pass.slopes[--slope_count]);
      }
      for (std::size_t i = pass.passed[k].steps; i-- > before.steps;) {
        slope[place_of_walk] += noise[place_of_walk] * pass.steps[i].h * (smoother.slope(0) + smoother.slope(1));
        add_slope(slope, noise, pass.steps[i].share, smoother);
        smoother.step_back(pass.steps[i]);
        add_slope(slope, noise, pass.steps[i].share, smoother);
      }
    }
    if (has_memory()) add_slope(slope, noise, 1.0, smoother);
    return slope;
  }

  void residuals(const FilteredRun<N>& pass, Eigen::Ref<Eigen::VectorXd> out) override {
    walk(
        pass,
        [&](FilterVector<N>& x, const Interval& step, const Controls<double>& controls, const Transition<N>& t) {
          predictor_.repeat(x, controls, step.from, step.to, t);
        },
        [](const FilterVector<N>&, std::size_t) {},
        [&](const FilterVector<N>&, const Sight&, std::size_t row, double e) {
          out[static_cast<Eigen::Index>(row)] = e / std::sqrt(pass.innovations[row].variance);
        });
  }

  std::vector<bool> slopes(const FilteredRun<N>& pass, const Ship& ship, std::span<const Neighbour> neighbours,
                           Eigen::Ref<Eigen::MatrixXd> out) override {
    const auto& recorded = controls_->recorded;
    const bool surrounded = !recorded.wind().empty() || in_depth(ship, recorded.depth());  // which no tape knows
    if (surrounded) return std::vector<bool>(neighbours.size(), false);
    const auto differences = differences_between(ship, neighbours, run_, *controls_, finer_);
    predictor_.tape(ship, differences.variable);
    StateSlopes<N> X(differences, observer_);
    StepSlopes by;
    TapedShip::Slopes at_sample;
    if (predictor_.hides_states()) {
      TapedShip::HiddenSlopes at_first;
      predictor_.slopes_of_hidden(first_state(), at_first);
      X.begin(at_first);
    }
    walk(
        pass,
        [&](FilterVector<N>& x, const Interval& step, const Controls<double>& controls, const Transition<N>& t) {
          predictor_.repeat(x, controls, step.from, step.to, t, by);
          X.step(t, by, controls,
                 [&](const RunControls& c) { return c.in_step(run_, step.sample, step.from, step.to); });
        },
        [&](const FilterVector<N>& x, std::size_t k) {
          if (!observer_.late()) return;
          predictor_.slopes(x, at_samples()[k], at_sample);
          X.accelerate(at_sample, k, at_samples()[k]);
        },
        [&](const FilterVector<N>& x, const Sight& sight, std::size_t row, double) {
          X.observe({ship_state<N>(x), sight.acceleration, sight.phi}, pass.innovations[row],
                    out.row(static_cast<Eigen::Index>(row)));
        });
    return differences.found;
  }

 private:
  FilterVector<N> first_state() const {
    FilterVector<N> x = FilterVector<N>::Zero();
    x.template head<6>() << start_.x, start_.y, start_.psi, start_.motion.u, start_.motion.v, start_.motion.r;
    return x;
  }

  /// A quarter of a ship length, of the speed and of a radian about the recorded state.
  Gaussian<N> start(const FilterNoise& noise) const {
    const double U = speed(start_.motion), quarter = 0.25;
    Gaussian<N> estimate{first_state(), FilterMatrix<N>::Zero()};
    auto variance = estimate.P.diagonal();
    variance.template head<6>() << L_, L_, 1.0, U, U, U / L_;
    if constexpr (N == 9) variance.template tail<3>() << U * U / L_, U * U / L_, U * U / (L_ * L_);
    variance = (quarter * variance).array().square().eval();
    if (has_memory()) variance.template tail<3>() = noise.tail<3>();
    return estimate;
  }

  /// @throws Refusal  where the motion has run away, or is none
  void require_motion(const FilterVector<N>& x, std::size_t k) const {
    constexpr double runaway = 1e3;  // speeds over the service speed that no ship has
    if (!(x[3] * x[3] + x[4] * x[4] < std::pow(runaway * U_0_, 2)))
      throw Refusal(fmt::format("{}: the ship loses her way at {:.6g} s", run_.name, run_.time[k]));
  }

  /// A step of the filter on the way to a sample [s].
  struct Interval {
    double from, to;
    std::size_t sample;
  };

  /// The way through a run with the gains and the steps of a pass.
  /// @param move(x, step, controls, transition)  moves a state over a step
  /// @param arrived(x, k)                        before the measurements of a sample
  /// @param told(x, sight, row, e)            a residual, before the state takes it
  template <class Move, class Arrived, class Told>
  void walk(const FilteredRun<N>& pass, Move&& move, Arrived&& arrived, Told&& told) {
    FilterVector<N> x = first_state();
    predictor_.set_tau(pass.tau);
    predictor_.restart(x);
    std::size_t step = 0, row = 0;
    for (std::size_t k = 0; k < pass.passed.size(); ++k) {
      require_motion(x, k);
      const int count = static_cast<int>(pass.passed[k].steps - step);
      for (int i = 0; i < count; ++i, ++step) {
        const auto interval = step_in(k, i, count);
        move(x, interval, controls_in(interval), pass.steps[step]);
      }
      const auto sight = sight_at(x, k);
      arrived(x, k);
      for (; row < pass.passed[k].innovations; ++row) {
        const auto& now = pass.innovations[row];
        const double e = compared(now.channel, run_[now.channel][k], expected(now.channel, x, sight));
        told(x, sight, row, e);
        x += now.K * e;
      }
    }
  }

  /// The i-th of the steps from sample k − 1 to k.
  Interval step_in(std::size_t k, int i, int count) const {
    const double begin = run_.time[k - 1], h = run_.time[k] - begin;
    return {begin + h * i / count, i + 1 == count ? run_.time[k] : begin + h * (i + 1) / count, k};
  }

  Controls<double> controls_in(const Interval& step) const {
    return controls_->in_step(run_, step.sample, step.from, step.to);
  }

  /// To sample k, in steps that are short for the ship.
  void predict(Gaussian<N>& estimate, std::size_t k, const FilterNoise& noise, FilteredRun<N>& pass) {
    require_motion(estimate.mean, k - 1);
    const int count = predictor_.steps(speed(ship_state<N>(estimate.mean).motion), run_.time[k] - run_.time[k - 1]);
    for (int i = 0; i < count; ++i) {
      const auto step = step_in(k, i, count);
      const auto& t = pass.steps.emplace_back(predictor_.step(estimate.mean, controls_in(step), step.from, step.to));
      estimate.P.diagonal().template segment<3>(random) += t.share * noise.tail<3>();
      estimate.P = carried<N>(estimate.P, t);
      estimate.P.diagonal().template head<2>().array() += noise[place_of_walk] * t.h;
      estimate.P.diagonal().template segment<3>(random) += t.share * noise.tail<3>();
    }
    require_motion(estimate.mean, k);
  }

  /// @return log likelihood of the sample
  double measure(Gaussian<N>& estimate, std::size_t k, const FilterNoise& noise, FilteredRun<N>& pass) {
    double product = 1.0, squares = 0.0;  // of variances, whose logarithm is slow
    const auto before = sight_at(estimate.mean, k);
    for (const Channel channel : channels_) {
      const auto samples = run_[channel];
      if (samples.empty() || std::isnan(samples[k])) continue;
      const auto& now =
          pass.innovations.emplace_back(update(estimate, channel, k, before, noise[place_of(channel)], pass));
      const double square = now.error * now.error / now.variance;
      squares += square;
      product *= 2.0 * pi * now.variance;
      pass.sums[index_of(channel)].add(std::copysign(std::sqrt(square), now.error));
    }
    return -0.5 * (squares + std::log(product));
  }

  /// @param before  what there is to look at before the measurements of the sample
  Innovation<N> update(Gaussian<N>& estimate, Channel channel, std::size_t k, const Sight& before, double R,
                       FilteredRun<N>& pass) {
    const double value = run_[channel][k];
    if (const auto state = observer_.state_alone(channel))
      return updated<N>(estimate, channel, *state, value - observer_.bias(channel), R, pass.outlying);
    const auto expected = [&](const FilterVector<N>& x, ChannelSlope& slope) {
      return observer_.value(channel, {ship_state<N>(x), before.acceleration, before.phi}, slope);
    };
    return updated<N>(estimate, channel, expected, observer_.linear(channel), value, R, pass.slopes.emplace_back(),
                      pass.outlying);
  }

  double expected(Channel channel, const FilterVector<N>& x, const Sight& sight) const {
    if (const auto state = observer_.state_alone(channel)) return x[*state] + observer_.bias(channel);
    return observer_.value(channel, {ship_state<N>(x), sight.acceleration, sight.phi});
  }

  /// With the accelerations where a late channel needs them.
  Sight sight_at(const FilterVector<N>& x, std::size_t k) const {
    const double phi = shown_by(predictor_.hidden(), Channel::phi);
    if (!observer_.late()) return {ship_state<N>(x), {0.0, 0.0, 0.0}, phi};
    const auto rate = predictor_.rates(x, at_samples()[k]);
    PlanarAcceleration<double> a{rate[3], rate[4], rate[5]};
    if constexpr (N == 9) a = {a.u + x[6], a.v + x[7], a.r + x[8]};
    return {ship_state<N>(x), a, phi};
  }

  static void add_slope(FilterNoise& slope, const FilterNoise& noise, double share, const Smoother<N>& smoother) {
    for (int i = 0; i < 3; ++i)
      slope[place_of_process_noise(i)] += share * noise[place_of_process_noise(i)] * smoother.slope(random + i);
  }

  static constexpr int random = N == 9 ? 6 : 3;  ///< first of the states that random accelerations drive

  const std::vector<Controls<double>>& at_samples() const { return controls_->at_samples; }

  bool has_memory() const { return N == 9 && std::isfinite(predictor_.tau()); }

  /// Those that are known, where they serve this ship too.
  static std::shared_ptr<const RunControls> controls_of(const Ship& ship, const Recording& run, const Recording* finer,
                                                        std::shared_ptr<const RunControls> known) {
    if (!known) return std::make_shared<const RunControls>(ship, run, finer);
    auto other = known->differing(ship, run, finer);
    return other ? std::make_shared<const RunControls>(*std::move(other)) : known;
  }

  const Recording& run_;
  const Recording* finer_;
  std::span<const Channel> channels_;
  std::shared_ptr<const RunControls> controls_;
  ShipPredictor<N> predictor_;
  ChannelObserver observer_;
  ShipState<double> start_;
  double L_, U_0_;
};

template <int N>
std::unique_ptr<RunFilter<N>> run_filter(const Ship& ship, const Recording& run, std::span<const Channel> channels,
                                         const ShipState<double>& start, double tau, double longest_step,
                                         std::shared_ptr<const RunControls> known, const Recording* finer) {
  const auto shallow = in_depth(ship, recorded_depth(run));
  return std::make_unique<RunFilterOf<N>>(shallow ? *shallow : ship, run, channels, start, tau, longest_step,
                                          std::move(known), finer);
}

}  // namespace swayaw::identification::detail
