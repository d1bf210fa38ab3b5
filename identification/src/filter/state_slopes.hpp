#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "run_filter.hpp"
#include "swayaw/nonlinear/replay.hpp"

/// How the states and the residuals of a filter with given gains change with many unknowns at once. Not installed.
namespace swayaw::inline identification::detail {

/// What the unknowns change, per unit of each.
struct NeighbourDifferences {
  /// A number of the ship that an unknown moves.
  struct OfNumber {
    Eigen::Index unknown, variable;  ///< of the taped ship
    double slope;
  };

  struct OfControls {
    Eigen::Index unknown;
    double step;
    RunControls controls;
  };

  struct OfObserver {
    Eigen::Index unknown;
    double step;
    ChannelObserver observer;
  };

  std::vector<bool> found;     ///< for each neighbour; the others change nothing here
  std::vector<bool> variable;  ///< which numbers of the ship change at all
  std::vector<OfNumber> numbers;
  std::vector<OfControls> controls;
  std::vector<OfObserver> observers;
};

/// @param channels  that the filter compares
/// @param times     of its samples
/// @param controls  of the ship
/// @param finer     recording that tells the controls between the samples, if any
NeighbourDifferences differences_between(const Ship& ship, std::span<const Neighbour> neighbours, const Recording& run,
                                         std::span<const Channel> channels, SampleTimes times,
                                         const RunControls& controls, const Recording* finer);

/// Derivatives X of a filter's state x by all unknowns, from one state to the next.
///
/// With the gains K, the variances S and the steps of a pass as they are, a state moves by x⁺ = x + C h f(x, c; p),
/// C as in Transition, and a measurement y tells e = y − g(x; p), x⁺ = x + K e. So, row by row of an unknown,
///
///     X⁺ = X + C h (∂f/∂x X + ∂f/∂c dc/dp + ∂f/∂p),   de/dp = −(∂g/∂x X + ∂g/∂p),   X⁺ = X + K de/dp
///
/// Hidden states, which f depends on and no measurement corrects, have derivatives H beside them, along the four stages
/// of their own way.
template <int N>
class StateSlopes {
 public:
  StateSlopes(const NeighbourDifferences& differences, const ChannelObserver& observer)
      : differences_(differences),
        observer_(observer),
        X_(Unknowns<N>::Zero(std::ssize(differences.found), N)),
        H_(OfHidden::Zero(std::ssize(differences.found), hidden)) {}

  /// The run begins with hidden states.
  /// @param by        their derivatives by the variables of the taped ship
  /// @param first(c)  the controls c of a neighbour then
  template <class First>
  void begin(const TapedShip::HiddenSlopes& by, const Controls<double>& controls, First&& first) {
    hides_ = true;
    add_direct(H_, by, controls, first);
  }

  /// Over a step.
  /// @param of_step    derivatives of the rates by the variables of the taped ship
  /// @param late       whether accelerations are needed at its end
  /// @param in_step(c)  the controls c of a neighbour in it
  template <class InStep>
  void step(const Transition<N>& t, const StepSlopes& of_step, bool late, const Controls<double>& controls,
            InStep&& in_step) {
    const auto& by = of_step.rates;
    const Eigen::Matrix<double, 6, N> C = with_curve(t);
    const Eigen::Matrix<double, 6, 6> Ch = t.h * C.template leftCols<6>();
    Eigen::Matrix<double, 6, N - 2> B;
    B.template leftCols<4>() = Ch * by.leftCols<4>();
    if constexpr (N == 9) B.template rightCols<3>() = Ch.template rightCols<3>() - t.fading * C.template rightCols<3>();
    moved_.noalias() = X_.template rightCols<N - 2>().lazyProduct(B.transpose());
    forced_.noalias() = Ch.lazyProduct(by);
    OfHidden rate;
    if (hides_) {
      before_ = X_.template middleCols<3>(3);
      follows_rudder_ = of_step.by_rudder.size() > 0;
      if (follows_rudder_) {
        by_rudder_ = before_ * of_step.by_rudder.template segment<3>(TapedVariables::u).transpose();
        add_direct(by_rudder_, of_step.by_rudder, controls, in_step);
      }
      rate = of_hidden(of_step.hidden[0], before_, H_);
      moved_ += (H_ + 0.5 * t.h * rate) * forced_.template middleCols<hidden>(TapedVariables::hidden).transpose();
    }
    if (late) {
      const Eigen::Matrix<double, 3, 4> A = t.hA.template bottomRows<3>() / t.h;
      acceleration_.noalias() = X_.template middleCols<4>(2) * (by.template block<3, 4>(3, 0) - A).transpose();
      if (hides_)
        acceleration_ += (H_ + 0.5 * t.h * rate) * by.template block<3, hidden>(3, TapedVariables::hidden).transpose();
      add_direct(acceleration_, by.template bottomRows<3>(), controls, in_step);
    }
    X_.template leftCols<6>() += moved_;
    if constexpr (N == 9) X_.template rightCols<3>() *= t.faded();
    add_direct(X_.template leftCols<6>(), forced_, controls, in_step);
    if (hides_) follow(of_step, rate, t.h);
  }

  /// The accelerations of the model with which the run begins.
  /// @param by        their derivatives by the variables of the taped ship, in the last rows
  /// @param first(c)  the controls c of a neighbour then
  template <class First>
  void accelerate_at_first(const TapedShip::Slopes& by, const Controls<double>& controls, First&& first) {
    acceleration_ = X_.template middleCols<4>(2) * by.template block<3, 4>(3, 0).transpose();
    if (hides_) acceleration_ += H_ * by.template block<3, hidden>(3, TapedVariables::hidden).transpose();
    add_direct(acceleration_, by.template bottomRows<3>(), controls, first);
  }

  /// The rudder on the way to what is shown on a side.
  /// @param by_rudder  derivatives of the accelerations by its angle, kept from the pass
  /// @param moved(c)   from its mean angle in the step before, by the controls c [rad]
  template <class Moved>
  void steer(Side side, const Eigen::Vector3d& by_rudder, const RunControls& controls, Moved&& moved) {
    auto& steered = steered_[side];
    steered.clear();
    if (differences_.controls.empty()) return;
    const double here = moved(controls);
    for (const auto& d : differences_.controls)
      steered.push_back({d.unknown, (moved(d.controls) - here) / d.step * by_rudder});
  }

  /// Takes a residual. @param out  its derivatives over its standard deviation
  template <class Row>
  void observe(const Sight& sight, const Reading& reading, const Innovation<N>& now, Row&& out) {
    const Channel channel = reading.channel;
    if (const auto alone = observer_.state_alone(channel)) {
      seen_ = X_.col(*alone);
    } else {
      ChannelSlope slope;
      observer_.value(reading, sight, slope);
      seen_ = X_.template leftCols<6>() * slope.by_state;
      if (observer_.late(channel)) {
        seen_ += acceleration_ * slope.by_acceleration;
        for (const auto side : {past, future})
          for (const auto& s : steered_[side]) seen_[s.unknown] += s.acceleration.dot(slope.by_side[side]);
        if constexpr (N == 9) seen_ += X_.template rightCols<3>() * slope.by_acceleration;
      }
    }
    if (hides_)
      if (const double by_phi = observer_.by_phi(reading, sight); by_phi != 0.0) seen_ += by_phi * H_.col(heel);
    for (const auto& d : differences_.observers)
      if (observer_.differs(d.observer, channel))
        seen_[d.unknown] += (d.observer.value(reading, sight) - observer_.value(reading, sight)) / d.step;
    out = seen_.transpose() / -std::sqrt(now.variance);
    X_.noalias() -= seen_.lazyProduct(now.K.transpose());
  }

 private:
  template <int Size>
  using Unknowns = Eigen::Matrix<double, Eigen::Dynamic, Size>;

  /// C = 1 + h A/2! + h²A²/3! in the rows of x … r, of x⁺ = x + C h f with f of all states.
  static Eigen::Matrix<double, 6, N> with_curve(const Transition<N>& t) {
    Eigen::Matrix<double, 6, N> first = Eigen::Matrix<double, 6, N>::Zero();
    first.template middleCols<4>(2) = t.hA;
    if constexpr (N == 9) first.template bottomRightCorner<3, 3>().diagonal().array() += t.h;
    Eigen::Matrix<double, 6, N> second = t.hA.lazyProduct(first.template middleRows<4>(2));
    if constexpr (N == 9) second.template bottomRightCorner<3, 3>().diagonal().array() -= t.fading * t.h;
    Eigen::Matrix<double, 6, N> C = first / 2.0 + second / 6.0;
    C.template leftCols<6>().diagonal().array() += 1.0;
    return C;
  }

  /// What an unknown changes of the accelerations by the rudder.
  struct Steered {
    Eigen::Index unknown;
    Eigen::Vector3d acceleration;
  };

  static constexpr int hidden = static_cast<int>(hidden_count);
  using OfHidden = Unknowns<hidden>;

  /// The hidden state that the heel is.
  static constexpr Eigen::Index heel = [] {
    const auto found = std::ranges::find(hidden_quantities, std::optional(Channel::phi), &HiddenQuantity::channel);
    return found - hidden_quantities.begin();
  }();

  /// Derivatives of the rates of hidden states in a stage of their way.
  OfHidden of_hidden(const TapedShip::HiddenSlopes& by, const Unknowns<3>& motion, const OfHidden& H) const {
    using V = TapedVariables;
    OfHidden rate = motion * by.template middleCols<3>(V::u).transpose();
    rate += H * by.template middleCols<hidden>(V::hidden).transpose();
    if (follows_rudder_) rate += by_rudder_ * by.col(V::by_rudder).transpose();
    add_numbers(rate, by);
    return rate;
  }

  /// The step of Runge and Kutta, its first stage known.
  void follow(const StepSlopes& by, const OfHidden& first, double h) {
    const Unknowns<3> after = X_.template middleCols<3>(3), middle = 0.5 * (before_ + after);
    const auto second = of_hidden(by.hidden[1], middle, H_ + 0.5 * h * first),
               third = of_hidden(by.hidden[2], middle, H_ + 0.5 * h * second),
               last = of_hidden(by.hidden[3], after, H_ + h * third);
    H_ += h / 6.0 * (first + 2.0 * (second + third) + last);
  }

  /// What an unknown changes directly: numbers of the ship.
  template <class To, class By>
  void add_numbers(To&& to, const By& by) const {
    for (const auto& d : differences_.numbers) to.row(d.unknown) += d.slope * by.col(d.variable).transpose();
  }

  /// The same, and controls.
  template <class To, class By, class Then>
  void add_direct(To&& to, const By& by, const Controls<double>& controls, Then&& then) const {
    add_numbers(to, by);
    for (const auto& d : differences_.controls) add_controls(to, d.unknown, d.step, by, controls, then(d.controls));
  }

  /// Of an unknown that changes controls to others.
  template <class To, class By>
  static void add_controls(To&& to, Eigen::Index unknown, double step, const By& by, const Controls<double>& controls,
                           const Controls<double>& other) {
    using V = TapedVariables;
    to.row(unknown) +=
        ((other.delta - controls.delta) * by.col(V::delta) + (other.rev - controls.rev) * by.col(V::rev) +
         (other.thrust.port - controls.thrust.port) * by.col(V::port) +
         (other.thrust.starboard - controls.thrust.starboard) * by.col(V::starboard))
            .transpose() /
        step;
  }

  const NeighbourDifferences& differences_;
  const ChannelObserver& observer_;
  Unknowns<N> X_;
  OfHidden H_;
  Unknowns<1> by_rudder_;  ///< of the force of the rudder over a step
  bool hides_ = false, follows_rudder_ = false;
  Unknowns<6> moved_;
  Unknowns<3> before_;
  /// Of the accelerations of the model at the end of a step, the rudder at its mean, for channels that are late; less
  /// those by which they go with the state of the sample.
  Unknowns<3> acceleration_;
  std::array<std::vector<Steered>, 2> steered_;
  Eigen::VectorXd seen_;
  TapedShip::Slopes forced_;
};

}  // namespace swayaw::identification::detail
