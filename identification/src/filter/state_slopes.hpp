#pragma once

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

/// @param controls  of the ship
/// @param finer     recording that tells the controls between the samples, if any
NeighbourDifferences differences_between(const Ship& ship, std::span<const Neighbour> neighbours, const Recording& run,
                                         const RunControls& controls, const Recording* finer);

/// Derivatives X of a filter's state x by all unknowns, from one state to the next.
///
/// With the gains K, the variances S and the steps of a pass as they are, a state moves by x⁺ = x + C h f(x, c; p),
/// C as in Transition, and a measurement y tells e = y − g(x; p), x⁺ = x + K e. So, row by row of an unknown,
///
///     X⁺ = X + C h (∂f/∂x X + ∂f/∂c dc/dp + ∂f/∂p),   de/dp = −(∂g/∂x X + ∂g/∂p),   X⁺ = X + K de/dp
template <int N>
class StateSlopes {
 public:
  StateSlopes(const NeighbourDifferences& differences, const ChannelObserver& observer)
      : differences_(differences), observer_(observer), X_(Unknowns<N>::Zero(std::ssize(differences.found), N)) {}

  /// Over a step.
  /// @param by         derivatives of the rates by the variables of the taped ship
  /// @param in_step(c)  the controls c of a neighbour in it
  template <class InStep>
  void step(const Transition<N>& t, const TapedShip::Slopes& by, const Controls<double>& controls, InStep&& in_step) {
    const Eigen::Matrix<double, 6, N> C = with_curve(t);
    const Eigen::Matrix<double, 6, 6> Ch = t.h * C.template leftCols<6>();
    Eigen::Matrix<double, 6, N - 2> B;
    B.template leftCols<4>() = Ch * by.leftCols<4>();
    if constexpr (N == 9) B.template rightCols<3>() = Ch.template rightCols<3>() - t.fading * C.template rightCols<3>();
    moved_.noalias() = X_.template rightCols<N - 2>().lazyProduct(B.transpose());
    X_.template leftCols<6>() += moved_;
    if constexpr (N == 9) X_.template rightCols<3>() *= t.faded();
    forced_.noalias() = Ch.lazyProduct(by);
    add_direct(X_.template leftCols<6>(), forced_, controls, in_step);
  }

  /// Derivatives of the accelerations at a sample, for channels that are late.
  void accelerate(const TapedShip::Slopes& by, double time, const Controls<double>& controls) {
    acceleration_.noalias() = X_.template middleCols<4>(2).lazyProduct(by.block<3, 4>(3, 0).transpose());
    if constexpr (N == 9) acceleration_ += X_.template rightCols<3>();
    add_direct(acceleration_, by.bottomRows<3>(), controls, [&](const RunControls& c) { return c.recorded.at(time); });
  }

  /// Takes a residual. @param out  its derivatives over its standard deviation
  template <class Row>
  void observe(const Sight& sight, const Innovation<N>& now, Row&& out) {
    if (const auto alone = observer_.state_alone(now.channel)) {
      seen_ = X_.col(*alone);
    } else {
      ChannelSlope by_state;
      observer_.value(now.channel, sight, by_state);
      seen_ = X_.template leftCols<6>() * by_state;
    }
    if (observer_.late(now.channel)) seen_ += acceleration_ * by_acceleration(now.channel, sight);
    for (const auto& d : differences_.observers)
      if (observer_.differs(d.observer, now.channel))
        seen_[d.unknown] += (d.observer.value(now.channel, sight) - observer_.value(now.channel, sight)) / d.step;
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

  /// What an unknown changes directly: numbers of the ship, and controls.
  template <class To, class By, class Then>
  void add_direct(To&& to, const By& by, const Controls<double>& controls, Then&& then) {
    using V = TapedVariables;
    for (const auto& d : differences_.numbers) to.row(d.unknown) += d.slope * by.col(d.variable).transpose();
    for (const auto& d : differences_.controls) {
      const auto other = then(d.controls);
      to.row(d.unknown) +=
          ((other.delta - controls.delta) * by.col(V::delta) + (other.rev - controls.rev) * by.col(V::rev) +
           (other.thrust.port - controls.thrust.port) * by.col(V::port) +
           (other.thrust.starboard - controls.thrust.starboard) * by.col(V::starboard))
              .transpose() /
          d.step;
    }
  }

  /// By central differences; a channel is about linear in the accelerations.
  Eigen::Vector3d by_acceleration(Channel channel, const Sight& sight) const {
    constexpr double step = 1e-3;  // m/s², rad/s²
    Eigen::Vector3d slope;
    const std::array<double PlanarAcceleration<double>::*, 3> parts{
        &PlanarAcceleration<double>::u, &PlanarAcceleration<double>::v, &PlanarAcceleration<double>::r};
    for (std::size_t i = 0; i < 3; ++i) {
      Sight more = sight, less = sight;
      more.acceleration.*parts[i] += step, less.acceleration.*parts[i] -= step;
      slope[static_cast<int>(i)] = (observer_.value(channel, more) - observer_.value(channel, less)) / (2.0 * step);
    }
    return slope;
  }

  const NeighbourDifferences& differences_;
  const ChannelObserver& observer_;
  Unknowns<N> X_;
  Unknowns<6> moved_;
  Unknowns<3> acceleration_;
  Eigen::VectorXd seen_;
  TapedShip::Slopes forced_;
};

}  // namespace swayaw::identification::detail
