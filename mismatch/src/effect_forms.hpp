#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "swayaw/nonlinear/acting_ship.hpp"

/// Effects in coordinates that a fit moves. Not installed.
namespace swayaw {

/// One coordinate of an effect: 0 or `centre` where little is known, of order 1 where the effect has its usual size.
struct Coordinate {
  std::string name;
  double centre = 0.0;     ///< mean before any data
  double deviation = 1.0;  ///< standard deviation before any data
  double step = 0.02;      ///< of differences
  double low = -HUGE_VAL;
  double high = HUGE_VAL;
};

/// An effect as a function of coordinates. Wind, stream and waves go by their north and east parts, since a direction
/// means nothing where the speed is 0; a depth by its inverse.
struct EffectForm {
  std::string id;  ///< as in ship files
  std::vector<Coordinate> coordinates;
  std::function<Effect(std::span<const double>)> at;
  std::vector<std::vector<double>> starts;  ///< where fits begin: an effect that is not linear has several valleys
  std::vector<double>
      window{};  ///< its last two coordinates, onset and end, where most force is missing; empty where it has none
  std::function<EffectForm(std::span<const std::size_t>)>
      with_terms{};  ///< the same of some of its coordinates, where each is a term by itself
};

/// A rudder whose lift falls a little with its angle, K = 1 − loss (delta)²: what every lift curve does and no linear
/// one knows. It belongs to the baseline of every ship that has a place for it.
/// @return nothing for other models, and where the ship has a gap of her own
std::optional<EffectForm> ordinary_lift_loss(const Ship& ship);

/// Whether a number is a direction on the earth, that wind and waves come from or a stream goes to.
bool is_direction(const Parameter& number);

/// d(numbers)/d(coordinates) of an effect, numbers as `numbers_of` gives them; directions turn the short way.
Eigen::MatrixXd number_slopes(const Ship& ship, const EffectForm& form, const Eigen::VectorXd& coordinates);

/// All candidates for a ship, the channels of her runs and their longest duration [s]; the last is a constant force
/// without a name that begins and ends.
std::vector<EffectForm> effect_forms(const Ship& ship, std::span<const Channel> channels, double duration);

/// A force that no candidate explains, as a map of the motion and the heading, term by term.
EffectForm unknown_map(const Ship& ship);

/// Whether an effect is larger than the practical floor in any of its numbers that decide.
bool is_finding(const Ship& ship, const Effect& effect);

}  // namespace swayaw
