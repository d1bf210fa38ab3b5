#include "swayaw/linear/zigzag.hpp"

#include <algorithm>
#include <cmath>

#include "leg_functions.hpp"

namespace swayaw::inline linear {
using namespace detail;
namespace {

using State = LinearState<double>;
using Rudder = RudderLine<double>;

/// A heading [rad] from which no ship comes back: only an unstable one gets there, and her motion soon leaves the range
/// of numbers.
constexpr double runaway = 1e9;

/// Sails leg after leg.
class LinearVoyage {
 public:
  LinearVoyage(const SwayYawCoefficients<double>& ship, const LinearZigzagOrder& order)
      : ship_(LinearResponse<double>(ship)), rate_(order.rate), longest_(order.longest) {
    legs_.reserve(3 * std::min<std::size_t>(order.reversals, 100) + 2);
  }

  void order(double angle) {
    target_ = angle;
    moving_ = angle != angle_;
    if (std::isinf(rate_)) {
      angle_ = angle;
      moving_ = false;
    }
  }

  /// Sails until the derivative of psi of that order passes `value`; keeps the legs. @return whether it did
  bool sail_to(int level, double value) {
    for (std::size_t legs = 0; now_ < longest_ && std::abs(state_.psi) < runaway; ++legs) {
      require_sailable(legs);
      const Rudder rudder = line();
      const LegFunctions functions(ship_, state_, rudder);
      const double ramp = moving_ ? (target_ - angle_) / rudder.rate : longest_ - now_;
      const double end = std::min({ramp, functions.horizon(), longest_ - now_});
      const auto [found, last] = functions.sail(level, value, end);
      const auto limit = moving_ && end == ramp ? LegEnd::arrival : LegEnd::limit;
      advance(rudder, last, found ? (level == 0 ? LegEnd::heading : LegEnd::peak) : limit);
      if (found) return true;
    }
    return false;
  }

  double now() const { return now_; }
  const State& state() const { return state_; }
  std::vector<Leg<double>>& legs() { return legs_; }

 private:
  Rudder line() const { return {angle_, moving_ ? std::copysign(rate_, target_ - angle_) : 0.0}; }

  void advance(const Rudder& rudder, const Knot& last, LegEnd end) {
    const double length = last.s;
    legs_.push_back({now_, length, state_, rudder, end});
    state_ = LegFunctions::state(last);
    if (end == LegEnd::peak) state_.omega = 0.0;
    now_ += length;
    angle_ = end == LegEnd::arrival ? target_ : rudder.value + rudder.rate * length;
    if (end == LegEnd::arrival) moving_ = false;
  }

  LegShip ship_;
  double rate_;
  double longest_;
  double now_ = 0.0;
  State state_{0.0, 0.0, 0.0};
  double angle_ = 0.0;
  double target_ = 0.0;
  bool moving_ = false;
  std::vector<Leg<double>> legs_;
};

}  // namespace

LinearZigzag<double> linear_zigzag(const SwayYawCoefficients<double>& ship, const LinearZigzagOrder& order) {
  require_positive(order.rudder, "rudder angle [rad]");
  require_positive(order.heading, "heading angle [rad]");
  require_positive(order.rate, "rudder rate [rad per ship length]");
  LinearVoyage voyage(ship, order);
  LinearZigzag<double> result;
  result.reversals.reserve(std::min<std::size_t>(order.reversals, 100));
  double turn = yaw_sign(order.first);
  voyage.order(-turn * order.rudder);
  while (result.reversals.size() < order.reversals && voyage.sail_to(0, turn * order.heading)) {
    LinearReversal<double> reversal{voyage.now(), 0.0, 0.0, voyage.legs().size()};
    voyage.order(turn * order.rudder);
    if (!voyage.sail_to(1, 0.0)) break;
    reversal.peak = voyage.now();
    reversal.overshoot = turn * voyage.state().psi - order.heading;
    result.reversals.push_back(reversal);
    turn = -turn;
  }
  result.legs = std::move(voyage.legs());
  return result;
}

}  // namespace swayaw::linear
