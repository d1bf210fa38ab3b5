#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "../trial/effect_forms.hpp"
#include "../trial/trial.hpp"
#include "linear_gaussian.hpp"

/// Sister ships as one trial, and what the runs of a day tell of it. Not installed.
namespace swayaw::inline mismatch::detail {

/// A form of one coordinate whose number is followed from day to day.
struct Watched {
  EffectForm form;
  Eigen::Index place;  ///< among the coordinates that are kept
  double deviation;    ///< of the level of a vessel, and of what changes
  double floor;        ///< the least size that matters, as a coordinate
};

/// The trial of a class: coordinates of a day first, then which of them belong to the ships.
struct ClassTrial {
  Trial trial;
  std::vector<Eigen::Index> kept, of_a_day;  ///< of the ship and what is watched; the others
  std::vector<Watched> watched;
  Eigen::VectorXd of_class;  ///< standard deviations of what the class has in common, 0 for instruments

  Eigen::Index size() const { return std::ssize(kept); }
};

/// Whether a fleet follows an effect from day to day.
bool is_watched(std::string_view id);

/// Whether an effect belongs to a day: the air, the water, an instrument.
bool is_of_a_day(const Effect& effect);

/// Of the values of the parameters of a form of one coordinate, that which it moves.
const Parameter& moved_parameter(const std::vector<Parameter>& parameters);

/// The parameter that a form of one coordinate moves, at a coordinate.
double parameter_at(const Ship& ship, const EffectForm& form, double c);

/// d(parameter)/d(coordinate)
double parameter_slope(const Ship& ship, const EffectForm& form, double c);

/// @param runs  of all ships
ClassTrial class_trial(const Ship& ship, std::span<const Recording> runs);

/// The runs of a vessel on one day, and what they tell.
struct Day {
  std::size_t vessel;
  double date;  ///< since 1970-01-01 [days]
  std::vector<std::size_t> runs;
  Noise noise{};  ///< at the most probable point of the day by itself
  Told all{};     ///< of all coordinates of the trial, from their means; empty until the day is fitted
  Told told{};    ///< of those that are kept, what is of the day alone eliminated
};

/// Fits a day by itself, about its most probable point.
/// @throws Refusal  where the ship cannot sail the runs
void fit_day(Day& day, const ClassTrial& whole);

/// Tells a day anew about coordinates that the fleet tells, what is of the day as is likeliest beside them.
/// @throws Refusal  where the ship cannot sail the runs like that
void move_day(Day& day, const ClassTrial& whole, const Eigen::VectorXd& kept);

/// The ship at these coordinates that are kept, what is of a day at its mean, with some of what is watched.
Ship ship_of(const ClassTrial& whole, const Eigen::VectorXd& kept, const std::function<bool(std::string_view)>& has);

}  // namespace swayaw::mismatch::detail
