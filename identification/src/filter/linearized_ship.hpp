#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "swayaw/core/dual.hpp"
#include "swayaw/nonlinear/effects/acting_in_wind.hpp"

/// Rates of a ship with her effects, and their derivatives by the state. Not installed.
namespace swayaw::inline identification::detail {

/// The state with derivatives by psi, u, v and r, on which alone rates and forces depend.
inline ShipState<Dual<4>> in_duals(const ShipState<double>& s) {
  using D = Dual<4>;
  return {D(s.x), D(s.y), D(s.psi, 0), {D(s.motion.u, 1), D(s.motion.v, 2), D(s.motion.r, 3)}};
}

/// Whatever her model, which is compiled in a file of its own, where the compiler finds room to inline dual numbers.
class LinearizedShip {
 public:
  struct At {
    Eigen::Matrix<double, 6, 1> rate;  ///< of x, y, psi, u, v, r
    Eigen::Matrix<double, 6, 4> A;     ///< its derivatives by psi, u, v, r
  };

  virtual ~LinearizedShip() = default;

  /// Rates and their derivatives.
  virtual At at(const ShipState<double>& state, const Hidden<double>& hidden,
                const Controls<double>& controls) const = 0;

  /// Rates alone.
  virtual StateVector<double> rates(const ShipState<double>& state, const Hidden<double>& hidden,
                                    const Controls<double>& controls) const = 0;

  /// Hidden states of a motion that has lasted long.
  virtual Hidden<double> steady_hidden(const PlanarMotion<double>& motion, const Controls<double>& controls) const = 0;

  /// Sway force of the rudder over the mass of the ship.
  virtual double sway_by_rudder(const PlanarMotion<double>& motion, const Controls<double>& controls) const = 0;

  /// When wind and forces change, in order of time.
  std::span<const Change> changes() const { return changes_; }

  /// From now on the wind blows, and the forces act, as the change says.
  void apply(const Change& change) {
    change.apply(around_, added_);
    change.apply(around_, dual_added_);
    dual_around_.wind = {D(around_.wind.speed), D(around_.wind.from)};
    dual_around_.windy = around_.windy;
  }

  /// Back to the time before the first change.
  void restart() { apply(before_); }

  const Current<double>& current() const { return around_.current; }
  bool hides_states() const { return added_.hidden(); }
  bool may_follow_rudder() const { return swayaw::may_follow_rudder(added_); }
  Hidden<double> rates_of_hidden(const PlanarMotion<double>& m, const Hidden<double>& h, double by_rudder) const {
    return hidden_rates(added_, m, h, by_rudder);
  }

 protected:
  using D = Dual<4>;

  template <class Model>
  explicit LinearizedShip(const ActingShip<Model>& acting)
      : around_(acting.surroundings),
        dual_around_(cast<D>(around_)),
        added_(acting.added),
        dual_added_(cast<D>(added_)),
        changes_(acting.changes),
        before_{.time = 0.0, .wind = around_.wind, .windy = around_.windy, .acting = added_.acting} {}

  Surroundings<double> around_;
  Surroundings<D> dual_around_;
  ActingEffects<double> added_;
  ActingEffects<D> dual_added_;

 private:
  std::vector<Change> changes_;
  Change before_;
};

/// @param wind  recorded, on top of that of her effects
/// @throws Refusal  where one of her effects cannot act on her model
std::unique_ptr<LinearizedShip> linearized_ship(const Ship& ship, std::span<const WindPiece> wind = {});

}  // namespace swayaw::identification::detail
