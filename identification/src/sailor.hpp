#pragma once

#include "course.hpp"
#include "stepper.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/nonlinear/instruments.hpp"

/// The sailor of a model. Not installed; included by one file for each model.
namespace swayaw {

template <template <class> class Model>
class ModelSailor : public Sailor {
 public:
  ModelSailor(const Model<double>& model, const Surroundings<double>& around, const NumberList& numbers)
      : model_(model), around_(around), numbers_(numbers) {}

  Course sail(const Stretch& stretch, const StateVector<double>& start, std::span<const double> values,
              bool with_slopes) const override {
    Model<double> ship = model_;
    set_values(ship, std::span<const Parameter>(numbers_), values);
    Course course;
    course.residual.resize(static_cast<Eigen::Index>(stretch.readings.size()));
    if (!with_slopes) sail_values(ship, stretch, start, course);
    else if (numbers_.size() <= 4) sail_slopes<8>(ship, stretch, start, course);
    else sail_slopes<16>(ship, stretch, start, course);
    return course;
  }

 private:
  void sail_values(const Model<double>& ship, const Stretch& stretch, const StateVector<double>& start,
                   Course& course) const {
    BranchStepper<Model, double> stepper(ship, ship, around_);
    course.end =
        along(stepper, stretch, start, [&](Eigen::Index i, const Reading& reading, const StateVector<double>& s) {
          course.residual[i] = residual(reading, observe(reading.channel, kinematics(state_of(s), around_.current)));
        });
  }

  /// In passes of N derivatives; the first four are those by psi, u, v, r at the start. Those by x and y are 1 or 0.
  template <int N>
  void sail_slopes(const Model<double>& ship, const Stretch& stretch, const StateVector<double>& start,
                   Course& course) const {
    const auto lanes = static_cast<Eigen::Index>(6 + numbers_.size());
    course.residual_slope.setZero(course.residual.size(), lanes);
    course.end_slope.setZero(6, lanes);
    course.end_slope(0, 0) = course.end_slope(1, 1) = 1.0;
    for (std::size_t i = 0; i < stretch.readings.size(); ++i) {
      if (stretch.readings[i].channel == Channel::x) course.residual_slope(static_cast<Eigen::Index>(i), 0) = 1.0;
      if (stretch.readings[i].channel == Channel::y) course.residual_slope(static_cast<Eigen::Index>(i), 1) = 1.0;
    }
    const std::span<const Parameter> all(numbers_);
    std::size_t done = std::min<std::size_t>(all.size(), N - 4);
    pass<N>(ship, stretch, start, all.first(done), true, 2, course);
    while (done < all.size()) {
      const auto some = all.subspan(done, std::min<std::size_t>(all.size() - done, N));
      pass<N>(ship, stretch, start, some, false, static_cast<Eigen::Index>(6 + done), course);
      done += some.size();
    }
  }

  template <int N>
  void pass(const Model<double>& ship, const Stretch& stretch, const StateVector<double>& start,
            std::span<const Parameter> numbers, bool first, Eigen::Index column, Course& course) const {
    using S = Dual<N>;
    const int states = first ? 4 : 0;
    const auto lanes = static_cast<Eigen::Index>(numbers.size()) + states;
    StateVector<S> s;
    for (int i = 0; i < 6; ++i)
      s[static_cast<std::size_t>(i)] =
          first && i >= 2 ? S(start[static_cast<std::size_t>(i)], i - 2) : S(start[static_cast<std::size_t>(i)]);
    const auto current = cast<S>(around_).current;
    BranchStepper<Model, S> stepper(ship, seeded<N>(ship, numbers, states), around_);
    const auto end = along(stepper, stretch, s, [&](Eigen::Index i, const Reading& reading, const StateVector<S>& now) {
      const S value = observe(reading.channel, kinematics(state_of(now), current));
      course.residual[i] = residual(reading, value.a);
      course.residual_slope.row(i).segment(column, lanes) = value.v.head(lanes).transpose();
    });
    for (std::size_t i = 0; i < 6; ++i)
      course.end_slope.row(static_cast<Eigen::Index>(i)).segment(column, lanes) = end[i].v.head(lanes).transpose();
    course.end = values_of(end);
  }

  static double residual(const Reading& reading, double value) {
    return is_direction(reading.channel) ? wrapped(value - reading.value) : value - reading.value;
  }

  /// Calls seen(i, reading, state) for the readings of the stretch. @return the state at its end
  template <class S, class Seen>
  StateVector<S> along(BranchStepper<Model, S>& stepper, const Stretch& stretch, StateVector<S> s, Seen&& seen) const {
    const auto& run = *stretch.run;
    auto reading = stretch.readings.begin();
    const auto see = [&](std::size_t sample) {
      for (; reading != stretch.readings.end() && reading->sample == sample; ++reading)
        seen(reading - stretch.readings.begin(), *reading, s);
    };
    stepper.begin(values_of(s), run.controls[stretch.from]);
    see(stretch.from);
    for (std::size_t k = stretch.from; k < stretch.to; ++k) {
      const double duration = run.time[k + 1] - run.time[k], h = duration / run.steps[k];
      const auto line = ControlLine::through(run.controls[k], run.controls[k + 1], duration);
      for (int i = 0; i < run.steps[k]; ++i) stepper.advance(s, line, i * h, h);
      see(k + 1);
    }
    return s;
  }

  Model<double> model_;
  Surroundings<double> around_;
  NumberList numbers_;
};

}  // namespace swayaw
