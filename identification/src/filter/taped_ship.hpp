#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "swayaw/nonlinear/effects/acting_ship.hpp"
#include "tape.hpp"

/// Rates of a ship with their derivatives by her state, hidden states too, her controls and all of her numbers. Not
/// installed.
namespace swayaw::inline identification::detail {

/// All that a ship is in her equations of motion, as numbers: parameters of her model and of the effects that act in
/// her motion, air and water.
struct ShipNumbers {
  std::vector<double> values;
  std::vector<double> structure;  ///< what another ship must share for her numbers to stand at the same places: her
                                  ///< model, which effects act, when they begin and end
  std::vector<double> angles;     ///< of the values those that mean nothing where a speed is 0 [rad]
};

/// @throws Refusal  where one of her effects cannot act on her model
ShipNumbers numbers_of(const Ship& ship);

/// The first variables of a taped ship; her numbers follow.
struct TapedVariables {
  static constexpr int psi = 0, u = 1, v = 2, r = 3, delta = 4, rev = 5, port = 6, starboard = 7, hidden = 8,
                       by_rudder = hidden + static_cast<int>(hidden_count), count = by_rudder + 1;
};

class TapedShip {
 public:
  virtual ~TapedShip() = default;

  /// Derivatives of the rates of x, y, psi, u, v, r by the variables, a column each.
  using Slopes = Eigen::Matrix<double, 6, Eigen::Dynamic>;
  virtual void at(const ShipState<double>& state, const Hidden<double>& hidden, const Controls<double>& controls,
                  Slopes& slopes) = 0;

  /// Derivatives of the rates of the hidden states by the same.
  using HiddenSlopes = Eigen::Matrix<double, static_cast<int>(hidden_count), Eigen::Dynamic>;
  /// @param by_rudder  sway_by_rudder, a variable of its own
  virtual void of_hidden(const PlanarMotion<double>& motion, const Hidden<double>& hidden, double by_rudder,
                         HiddenSlopes& slopes) = 0;

  /// Derivatives of sway_by_rudder by the same.
  using RowSlopes = Eigen::RowVectorXd;
  virtual void of_rudder(const PlanarMotion<double>& motion, const Controls<double>& controls, RowSlopes& slopes) = 0;

  /// Derivatives of the hidden states of a motion that has lasted long.
  virtual void of_steady_hidden(const PlanarMotion<double>& motion, const Controls<double>& controls,
                                HiddenSlopes& slopes) = 0;

  virtual void restart() = 0;

  /// From now on the wind blows, and the forces act, as a change of the ship says.
  virtual void apply(std::size_t change) = 0;
};

/// @param variable  which of her numbers are variables
/// @throws Refusal  where one of her effects cannot act on her model
std::unique_ptr<TapedShip> taped_ship(const Ship& ship, const std::vector<bool>& variable);

}  // namespace swayaw::identification::detail
