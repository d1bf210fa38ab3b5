#pragma once

#include <fmt/format.h>

#include <numeric>

#include "run_filter.hpp"
#include "state_slopes.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/replay.hpp"
#include "timeline.hpp"

/// What a filter of N states does, for the two files that compile it. Not installed.
namespace swayaw::inline identification::detail {

template <int N>
class RunFilterOf final : public RunFilter<N> {
 public:
  RunFilterOf(const Ship& ship, const Recording& run, std::span<const Channel> channels, const ShipState<double>& start,
              double tau, SampleTimes times, double longest_step, std::shared_ptr<const RunControls> known,
              const Recording* finer)
      : run_(run),
        finer_(finer),
        channels_(channels),
        times_(times),
        controls_(controls_of(ship, run, finer, std::move(known), lateness_of(ship, channels, times))),
        predictor_(ship, controls_->recorded.wind(), tau, longest_step,
                   N == 9 && finer ? Changes::half_way : Changes::at_ends),
        observer_(instruments_of(ship), predictor_.current(), controls_->lateness, run.time.front()),
        start_(start),
        L_(length(ship)),
        U_0_(service_speed(ship)) {}

  void forward(const FilterNoise& noise, FilteredRun<N>& pass,
               const std::function<void(std::size_t, const Gaussian<N>&)>& tell) override {
    place_readings(pass.readings);
    pass.restart(timeline_.size(), channels_.size());
    pass.before = timeline_.before(), pass.after = timeline_.after();
    pass.tau = predictor_.tau();
    pass.controls = controls_;
    Gaussian<N> estimate = start(noise);
    predictor_.restart(estimate.mean, first_controls());
    double log_likelihood = 0.0;
    for (std::size_t k = 0; k < timeline_.size(); ++k) {
      if (k > 0) predict(estimate, k, noise, pass);
      log_likelihood += measure(estimate, k, noise, pass);
      pass.passed.push_back({pass.steps.size(), pass.innovations.size(), log_likelihood});
      if (tell && timeline_.recorded(k)) tell(timeline_.sample(k), estimate);
      if (!pass.kept) pass.forget_steps();
    }
  }

  FilterNoise backward(const FilterNoise& noise, const FilteredRun<N>& pass,
                       const std::function<void(std::size_t, const Smoother<N>&)>& tell) const override {
    FilterNoise slope = FilterNoise::Zero();
    Smoother<N> smoother;
    std::size_t slope_count = pass.slopes.size();
    const Timeline timeline(run_.time, pass.before, pass.after);
    for (std::size_t k = pass.passed.size(); k-- > 0;) {
      if (tell && timeline.recorded(k)) tell(timeline.sample(k), smoother);
      const auto before = k == 0 ? Passed{} : pass.passed[k - 1];
      for (std::size_t i = pass.passed[k].innovations; i-- > before.innovations;) {
        const auto& now = pass.innovations[i];
        const int place = place_of(pass.readings[i].channel);
        // S' = |e| √S/c of an outlier grows with R half as fast as its widening says
        const double widening = widening_of(now, pass.outlying), share = widening > 1.0 ? 0.5 * widening : 1.0;
        slope[place] += share * noise[place] *
                        smoother.step_back(now, now.state >= 0 ? FilterVector<N>() : pass.slopes[--slope_count]);
      }
      for (std::size_t i = pass.passed[k].steps; i-- > before.steps;) {
        slope[place_of_walk] += noise[place_of_walk] * pass.steps[i].h * (smoother.slope(0) + smoother.slope(1));
        const auto& t = pass.steps[i];
        const auto change = [&] {
          for (int axis = 0; axis < 3; ++axis) add_slope(slope, noise, axis, t.share * smoother.slope(random + axis));
        };
        if (t.changes == Changes::at_ends) change();
        else if constexpr (N == 9) {
          const auto G = t.by_change();
          for (int axis = 0; axis < 3; ++axis)
            add_slope(slope, noise, axis, t.share * smoother.slope(FilterVector<N>(G.col(axis))));
        }
        smoother.step_back(t);
        if (t.changes == Changes::at_ends) change();
      }
    }
    for (int axis = 0; has_memory() && axis < 3; ++axis) add_slope(slope, noise, axis, smoother.slope(random + axis));
    return slope;
  }

  void residuals(const FilteredRun<N>& pass, Eigen::Ref<Eigen::VectorXd> out) override {
    walk(
        pass, observer_.late(),
        [&](FilterVector<N>& x, const Interval& step, const Controls<double>& controls, const Transition<N>& t) {
          predictor_.repeat(x, controls, step.from, step.to, t);
        },
        [](const FilterVector<N>&, std::size_t, const Sight&) {},
        [&](const FilterVector<N>&, const Sight&, std::size_t row, double e) {
          out[static_cast<Eigen::Index>(row)] = e / std::sqrt(pass.innovations[row].variance);
        });
  }

  std::vector<bool> slopes(const FilteredRun<N>& pass, const Ship& ship, std::span<const Neighbour> neighbours,
                           Eigen::Ref<Eigen::MatrixXd> out) override {
    const auto& recorded = controls_->recorded;
    const bool surrounded = !recorded.wind().empty() || in_depth(ship, recorded.depth());  // which no tape knows
    if (surrounded) return std::vector<bool>(neighbours.size(), false);
    const auto differences = differences_between(ship, neighbours, run_, channels_, times_, *controls_, finer_);
    predictor_.tape(ship, differences.variable);
    StateSlopes<N> X(differences, observer_);
    StepSlopes by;
    TapedShip::Slopes at_sample;
    Interval last{};
    const Transition<N>* way = nullptr;  // the last step
    if (predictor_.hides_states()) {
      TapedShip::HiddenSlopes at_first;
      predictor_.slopes_of_hidden(first_state(), first_controls(), at_first);
      X.begin(at_first, first_controls(), [](const RunControls& c) { return c.at_samples.front(); });
    }
    const bool late =
        observer_.late() || std::ranges::any_of(differences.observers, [](const auto& d) { return d.observer.late(); });
    walk(
        pass, late,
        [&](FilterVector<N>& x, const Interval& step, const Controls<double>& controls, const Transition<N>& t) {
          predictor_.repeat(x, controls, step.from, step.to, t, by);
          last = step, way = &t;
          X.step(t, by, late, controls, [&](const RunControls& c) { return controls_in(c, step); });
        },
        [&](const FilterVector<N>& x, std::size_t k, const Sight&) {
          if (!late) return;
          if (!way) {
            predictor_.slopes(x, first_controls(), at_sample);
            X.accelerate_at_first(at_sample, first_controls(),
                                  [](const RunControls& c) { return c.at_samples.front(); });
            return;
          }
          for (const auto side : {past, future})
            X.steer(side, way->by_rudder, *controls_, [&](const RunControls& c) {
              return controls_towards(c, k, pass.shown[k][side]).delta - controls_in(c, last).delta;
            });
        },
        [&](const FilterVector<N>& x, const Sight& sight, std::size_t row, double) {
          X.observe(seen_from(x, sight), pass.readings[row], pass.innovations[row],
                    out.row(static_cast<Eigen::Index>(row)));
        });
    return differences.found;
  }

 private:
  /// The recorded state, or where a ship that keeps her motion comes from if readings show times before the run.
  FilterVector<N> first_state() const {
    const auto first = moved_back(start_, Current<double>{}, PlanarAcceleration<double>{}, timeline_.lead());
    FilterVector<N> x = FilterVector<N>::Zero();
    x.template head<6>() << first.x, first.y, first.psi, first.motion.u, first.motion.v, first.motion.r;
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
      throw Refusal(fmt::format("{}: the ship loses her way at {:.6g} s", run_.name, timeline_[k]));
  }

  /// A step of the filter on the way to a sample [s].
  struct Interval {
    double from, to;
    std::size_t sample;
  };

  /// The way through a run with the gains and the steps of a pass.
  /// @param late                                whether accelerations are needed
  /// @param move(x, step, controls, transition)  moves a state over a step
  /// @param arrived(x, k, sight)                 before the measurements of a sample
  /// @param told(x, sight, row, e)            a residual, before the state takes it
  template <class Move, class Arrived, class Told>
  void walk(const FilteredRun<N>& pass, bool late, Move&& move, Arrived&& arrived, Told&& told) {
    timeline_ = {run_.time, pass.before, pass.after};
    FilterVector<N> x = first_state();
    predictor_.set_tau(pass.tau);
    predictor_.restart(x, first_controls());
    std::size_t step = 0, row = 0;
    for (std::size_t k = 0; k < pass.passed.size(); ++k) {
      require_motion(x, k);
      const int count = static_cast<int>(pass.passed[k].steps - step);
      for (int i = 0; i < count; ++i, ++step) {
        const auto interval = step_in(k, i, count);
        move(x, interval, controls_in(*controls_, interval), pass.steps[step]);
      }
      const auto sight = sight_at(x, k, pass.shown[k], step == 0 ? nullptr : &pass.steps[step - 1], late);
      arrived(x, k, sight);
      for (; row < pass.passed[k].innovations; ++row) {
        const auto& reading = pass.readings[row];
        const double e = compared(reading.channel, run_[reading.channel][reading.sample], expected(reading, x, sight));
        told(x, sight, row, e);
        x += pass.innovations[row].K * e;
      }
    }
  }

  /// The i-th of the steps from sample k − 1 to k.
  Interval step_in(std::size_t k, int i, int count) const {
    const double begin = timeline_[k - 1], h = timeline_[k] - begin;
    return {begin + h * i / count, i + 1 == count ? timeline_[k] : begin + h * (i + 1) / count, k};
  }

  const Controls<double>& first_controls() const { return controls_->at_samples.front(); }

  /// Before and after the run they are as at its ends.
  Controls<double> controls_in(const RunControls& controls, const Interval& step) const {
    const bool within = timeline_.recorded(step.sample - 1) && timeline_.recorded(step.sample);
    const auto k = timeline_.sample(step.sample);
    return within ? controls.in_step(run_, k, step.from, step.to) : controls.at_samples[k];
  }

  /// By how much the rudder moves in a step [rad].
  double rudder_moves(const Interval& step) const {
    const bool within = timeline_.recorded(step.sample - 1) && timeline_.recorded(step.sample);
    return within ? controls_->rudder_moves(run_, timeline_.sample(step.sample), step.from, step.to) : 0.0;
  }

  /// Mean from a sample to a time this long after it [s], no further than the samples go.
  Controls<double> controls_towards(const RunControls& controls, std::size_t k, double after) const {
    const double at = timeline_[k];
    if (after == 0.0) return controls.at_samples[timeline_.sample(k)];
    const double from = std::min(at, at + after), to = std::max(at, at + after);
    std::optional<Controls<double>> mean;
    double weight = 0.0;
    const auto add = [&](std::size_t step) {  // the one that leads to this sample
      const double begin = std::max(from, timeline_[step - 1]), end = std::min(to, timeline_[step]);
      if (!(end > begin)) return;
      const auto there = controls_in(controls, {begin, end, step});
      weight += end - begin;
      mean = mean ? between(*mean, there, (end - begin) / weight) : there;
    };
    for (std::size_t j = k + 1; j < timeline_.size() && timeline_[j - 1] < to; ++j) add(j);
    for (std::size_t j = k; j > 0 && timeline_[j] > from; --j) add(j);
    return mean.value_or(controls.at_samples[timeline_.sample(k)]);
  }

  /// The times furthest from their sample that readings show on either side, after it [s].
  std::array<double, 2> furthest_shown(std::span<const Reading> readings) const {
    std::array furthest{0.0, 0.0};
    for (const auto& reading : readings)
      observer_.for_each_look(reading, [&](double shown) {
        auto& time = furthest[side_of(-shown)];
        if (std::abs(shown) > std::abs(time)) time = shown;
      });
    return furthest;
  }

  /// To sample k, in steps that are short for the ship. As what measures, inlined as a whole: with these parts called
  /// one by one a filter of 20,000 samples took 3 to 15 % longer.
  [[gnu::flatten]] void predict(Gaussian<N>& estimate, std::size_t k, const FilterNoise& noise, FilteredRun<N>& pass) {
    require_motion(estimate.mean, k - 1);
    const int count = predictor_.steps(speed(ship_state<N>(estimate.mean).motion), timeline_[k] - timeline_[k - 1]);
    for (int i = 0; i < count; ++i) {
      const auto step = step_in(k, i, count);
      const auto& t =
          pass.steps.emplace_back(predictor_.step(estimate.mean, controls_in(*controls_, step), rudder_moves(step),
                                                  observer_.late() && i + 1 == count, step.from, step.to));
      const FilterVector<3> variance = t.share * noise.template tail<3>();
      const auto change = [&] { estimate.P.diagonal().template segment<3>(random) += variance; };
      if (t.changes == Changes::at_ends) change();
      estimate.P = carried<N>(estimate.P, t);
      if (t.changes == Changes::at_ends) change();
      else if constexpr (N == 9) {
        const auto G = t.by_change();
        estimate.P.noalias() += (G * variance.asDiagonal()).lazyProduct(G.transpose());
      }
      estimate.P.diagonal().template head<2>().array() += noise[place_of_walk] * t.h;
    }
    require_motion(estimate.mean, k);
  }

  /// @return log likelihood of the sample
  [[gnu::flatten]] double measure(Gaussian<N>& estimate, std::size_t k, const FilterNoise& noise,
                                  FilteredRun<N>& pass) {
    double product = 1.0, squares = 0.0;  // of variances, whose logarithm is slow
    const auto readings =
        std::span<const Reading>(pass.readings).subspan(first_reading_[k], first_reading_[k + 1] - first_reading_[k]);
    const auto& shown = pass.shown.emplace_back(furthest_shown(readings));
    const auto before = sight_at(estimate.mean, k, shown, k == 0 ? nullptr : &pass.steps.back(), observer_.late());
    for (const auto& reading : readings) {
      const Channel channel = reading.channel;
      const auto& now =
          pass.innovations.emplace_back(update(estimate, reading, before, noise[place_of(channel)], pass));
      const double square = now.error * now.error / now.variance;
      squares += square;
      product *= 2.0 * pi * now.variance;
      pass.sums[index_of(channel)].add(std::copysign(std::sqrt(square), now.error));
    }
    return -0.5 * (squares + std::log(product));
  }

  /// @param before  what there is to look at before the measurements of the sample
  Innovation<N> update(Gaussian<N>& estimate, const Reading& reading, const Sight& before, double R,
                       FilteredRun<N>& pass) {
    const Channel channel = reading.channel;
    const double value = run_[channel][reading.sample];
    if (const auto state = observer_.state_alone(channel))
      return updated<N>(estimate, channel, *state, value - observer_.bias(channel), R, pass.outlying);
    const auto expected = [&](const FilterVector<N>& x, FilterVector<N>& slope) {
      ChannelSlope by;
      const double shown = observer_.value(reading, seen_from(x, before), by);
      slope.template head<6>() = by.by_state;
      if constexpr (N == 9) slope.template tail<3>() = by.by_acceleration;
      return shown;
    };
    return updated<N>(estimate, channel, expected, observer_.linear(channel), value, R, pass.slopes.emplace_back(),
                      pass.outlying);
  }

  double expected(const Reading& reading, const FilterVector<N>& x, const Sight& sight) const {
    if (const auto state = observer_.state_alone(reading.channel)) return x[*state] + observer_.bias(reading.channel);
    return observer_.value(reading, seen_from(x, sight));
  }

  /// With the accelerations of the model where a late channel needs them: those at the end of the step that led to the
  /// sample, by the curve of the step, with the rudder as it stands on the way to the times that readings show. One way
  /// for all, to the furthest of them, had them jump where another reading, on the other side, became the furthest: in
  /// a run with a moving rudder, sums of squares by a third. (Worked out by the model at the sample, on either side,
  /// they took two thirds of its evaluations.)
  /// @param way  the step that led to the sample, whose derivatives are those at it; nothing at the first
  Sight sight_at(const FilterVector<N>& x, std::size_t k, const std::array<double, 2>& shown, const Transition<N>* way,
                 bool late) const {
    Sight sight{.state = ship_state<N>(x), .phi = shown_by(predictor_.hidden(), Channel::phi), .shown = shown};
    if (!late) return sight;
    if (!way) {
      const auto rate = predictor_.rates(x, first_controls());
      sight.acceleration.fill({rate[3], rate[4], rate[5]});
      return sight;
    }
    sight.A = way->hA.template bottomRows<3>() / way->h;
    const auto& arrival = predictor_.arrival();
    const auto there = arrival.acceleration_there(sight.A);
    for (const auto side : {past, future}) {
      const double moved = controls_towards(*controls_, k, shown[side]).delta - arrival.rudder;
      const Eigen::Vector3d a = there + moved * way->by_rudder;
      sight.acceleration[side] = {a[0], a[1], a[2]};
    }
    return sight;
  }

  /// What there is to look at when the state of a sample is known better, by measurements before: the accelerations go
  /// with it, the unmodelled ones are part of it. A delay multiplies what they move by, so a filter that kept these
  /// until the next sample would swing itself up.
  static Sight seen_from(const FilterVector<N>& x, const Sight& before) {
    Sight sight = before;
    sight.state = ship_state<N>(x);
    const auto &now = sight.state, &then = before.state;
    const Eigen::Vector4d d{now.psi - then.psi, now.motion.u - then.motion.u, now.motion.v - then.motion.v,
                            now.motion.r - then.motion.r};
    Eigen::Vector3d more = before.A * d;
    if constexpr (N == 9) more += x.template tail<3>();
    for (auto& a : sight.acceleration) a.u += more[0], a.v += more[1], a.r += more[2];
    return sight;
  }

  /// By the logarithm of a variance, of a slope by it.
  static void add_slope(FilterNoise& slope, const FilterNoise& noise, int axis, double by_variance) {
    slope[place_of_process_noise(axis)] += noise[place_of_process_noise(axis)] * by_variance;
  }

  static constexpr int random = N == 9 ? 6 : 3;  ///< first of the states that change at random

  bool has_memory() const { return N == 9 && std::isfinite(predictor_.tau()); }

  /// Those that are known, where they serve this ship too.
  static std::shared_ptr<const RunControls> controls_of(const Ship& ship, const Recording& run, const Recording* finer,
                                                        std::shared_ptr<const RunControls> known, double lateness) {
    if (!known) return std::make_shared<const RunControls>(ship, run, finer, lateness);
    auto other = known->differing(ship, run, finer, lateness);
    return other ? std::make_shared<const RunControls>(*std::move(other)) : known;
  }

  /// Each at the sample nearest to the time that it shows, channel by channel.
  void place_readings(std::vector<Reading>& readings) {
    double latest = 0.0, earliest = 0.0;
    for (const Channel channel : channels_) {
      if (!observer_.late(channel)) continue;
      for (const double time : run_.time) {
        const double delay = observer_.delay(channel, time);
        latest = std::max(latest, delay), earliest = std::min(earliest, delay);
      }
    }
    timeline_ = Timeline::of(run_.time, latest, earliest);
    first_reading_.assign(timeline_.size() + 1, 0);
    const auto for_each = [&](auto&& f) {
      for (const Channel channel : channels_) {
        const auto values = run_[channel];
        const bool late = observer_.late(channel);
        for (std::size_t i = 0; i < values.size(); ++i)
          if (!std::isnan(values[i]))
            f(channel, i,
              late ? timeline_.nearest(run_.time[i] - observer_.delay(channel, run_.time[i])) : i + timeline_.before());
      }
    };
    for_each([&](Channel, std::size_t, std::size_t k) { ++first_reading_[k + 1]; });
    std::partial_sum(first_reading_.begin(), first_reading_.end(), first_reading_.begin());
    readings.resize(first_reading_.back());
    auto next = first_reading_;
    for_each([&](Channel channel, std::size_t i, std::size_t k) {
      readings[next[k]++] = {channel, i, run_.time[i], run_.time[i] - timeline_[k]};
    });
  }

  const Recording& run_;
  const Recording* finer_;
  std::span<const Channel> channels_;
  SampleTimes times_;
  std::shared_ptr<const RunControls> controls_;
  ShipPredictor<N> predictor_;
  ChannelObserver observer_;
  ShipState<double> start_;
  double L_, U_0_;
  Timeline timeline_;
  std::vector<std::size_t> first_reading_;  ///< of each time of the timeline, and the end
};

template <int N>
std::unique_ptr<RunFilter<N>> run_filter(const Ship& ship, const Recording& run, std::span<const Channel> channels,
                                         const ShipState<double>& start, double tau, SampleTimes times,
                                         double longest_step, std::shared_ptr<const RunControls> known,
                                         const Recording* finer) {
  const auto shallow = in_depth(ship, recorded_depth(run));
  return std::make_unique<RunFilterOf<N>>(shallow ? *shallow : ship, run, channels, start, tau, times, longest_step,
                                          std::move(known), finer);
}

}  // namespace swayaw::identification::detail
