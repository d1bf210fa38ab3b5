#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "swayaw/identification/map_fit.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"
#include "swayaw/nonlinear/effects/search_form.hpp"

/// Effects in coordinates that a fit moves. Not installed.
namespace swayaw::inline mismatch::detail {

/// An effect of any kind as a function of coordinates, as each kind tells in its file; of all runs, or of another size
/// and direction in each part of them.
///
/// Where it differs, the coordinates that all parts have in common come first, then what each part adds to them, normal
/// with a deviation of its own, the spread: parts of which little is known are drawn towards the others.
struct EffectForm {
  std::string id;  ///< as in ship files
  std::vector<Coordinate> coordinates;
  std::function<Effect(std::span<const double>)> at;  ///< of the coordinates in common; others are not looked at
  std::vector<std::vector<double>> starts;
  std::vector<double> window{};
  /// Where a fit begins, too: what is known of it besides what a fit without it predicts. Empty for most.
  std::vector<double> told{};
  bool told_beside_given = false;  ///< that begins from the ship as given alone
  double begin = 0.0;              ///< [s], from which onset and end among the coordinates count
  std::function<EffectForm(std::span<const std::size_t>)> with_terms{};
  /// Of an ordinary error: how many of its usual sizes count as one where it is decided whether an effect that stands
  /// in its place is more than ordinary.
  double decided_in = 1.0;
  Scope scope = Scope::ship;         ///< of the parts: group or run; of the ship where there are none
  std::vector<std::string> parts{};  ///< names of groups or runs

  /// How many coordinates all parts have in common.
  std::size_t common() const { return coordinates.size() / (parts.size() + 1); }

  /// Coordinates in a part of the runs; those in common for a part of which nothing is known.
  std::vector<double> in_part(std::span<const double> c, std::size_t part) const;

  /// The part that a run is of; past the last where it is of none.
  std::size_t part_of(const Recording& run) const;
};

/// The name of the part that a run is of: its own, that of its group, "all".
std::string part_name(Scope scope, const Recording& run);

/// The same effect, different in each part of the runs, its spread as wide as what is in common.
EffectForm differing(const EffectForm& form, Scope scope, std::span<const PreparedRun> runs);

/// Wind and stream among these effects as they differ from group to group, and from run to run, where there are
/// several.
std::vector<EffectForm> differing_surroundings(std::span<const EffectForm> forms, std::span<const PreparedRun> runs);

/// What coordinates in a part of the runs are, or the mean of all parts, as a matrix times all coordinates.
Eigen::MatrixXd part_map(const EffectForm& form, std::size_t part);
Eigen::MatrixXd mean_part_map(const EffectForm& form);

/// The mean of the parts, as coordinates in common.
std::vector<double> mean_of_parts(const EffectForm& form, std::span<const double> c);

/// The effect in each part of the runs; one where it is the same in all.
std::vector<Effect> effects_in_parts(const EffectForm& form, std::span<const double> c);

/// The same with another spread of the parts, over what the first had.
EffectForm with_spread(EffectForm form, double factor);

/// A rudder whose lift falls a little with its angle, K = 1 − loss (delta)²: what every lift curve does and no linear
/// one knows. It belongs to the baseline of every ship that has a place for it.
/// @return nothing for other models, and where the ship has a gap of her own
std::optional<EffectForm> ordinary_lift_loss(const Ship& ship);

/// Of the force that stands for what is wrong in the form of hull, propeller and rudder.
inline constexpr std::string_view form_id = ModelForm<>::id;

/// Of a coordinate of that force: 0 along, 1 across, 2 of the moment; 3 a constant that differs from side to side, 4
/// what the rudder differs by; 5 along, straight ahead at service speed.
int axis_of_term(std::string_view name);

inline constexpr int asymmetric_axis = 3, rudder_sides_axis = 4, straight_ahead_axis = 5;
inline bool differs_from_side_to_side(int axis) { return axis == asymmetric_axis || axis == rudder_sides_axis; }

/// The channel that an effect is of, if it is of one.
std::optional<Channel> channel_of(const EffectForm& form);

/// Ordinary deviations of an instrument, a rudder or a day from which on an error is no ordinary one.
inline constexpr double beyond_the_ordinary = 2.5;

/// How late a velocity or yaw rate may be by the filter of its instrument alone: gyros and logs of ships are smoothed
/// over half a second to two seconds, those of models over as much of their faster motion; where a ship of 65 m
/// and 12.5 kn counted as a model her gyro, behind a lag of 2.0 s, was late (seed 53). A fit takes less for usual,
/// which tells heading, gyro and rudder apart; where it was also the decision, five of 450 simulated ships on which
/// nothing was hidden were told a yaw rate late or early by about a second (as on board, seeds 34 to 36), and one of 77
/// a log by 1.8 s (seed 37). The least late that was hidden and found was 4.9 s.
double filter_delay(const Ship& ship);

/// What every ship, every instrument and every day has a little of: her forces are of another form than the model's,
/// a smooth function of the motion, alike on both sides and a little not; gyro, log, compass, clocks and the neutral
/// rudder are a little off; a light air and a slow stream. Each of usual size where its coordinates are of order 1.
std::vector<EffectForm> ordinary_forms(const Ship& ship, std::span<const Recording> runs,
                                       std::span<const Channel> channels);

/// Coordinates at which a form has the parameters of an effect of its kind.
/// @return nothing where they are not linear, or parts of what has a direction
std::optional<std::vector<double>> coordinates_of(const Ship& ship, const EffectForm& form, const Effect& effect);

/// d(parameters)/d(coordinates) of an effect, parameters as `parameters_of` gives them; directions turn the short way.
Eigen::MatrixXd parameter_slopes(const Ship& ship, const EffectForm& form, const Eigen::VectorXd& coordinates);

/// All candidates for a ship, the channels of her runs, their longest duration and when they begin on their clock [s];
/// the last is a constant force without a name that begins and ends.
std::vector<EffectForm> effect_forms(const Ship& ship, std::span<const Channel> channels, double duration,
                                     double begin = 0.0);

/// A force that no candidate explains, as a map of the motion and the heading, term by term.
EffectForm unknown_map(const Ship& ship);

/// Whether an effect is larger than the practical floor in any of its parameters that decide.
bool is_finding(const Ship& ship, const Effect& effect);

/// The same in any part of the runs.
bool is_finding(const Ship& ship, const EffectForm& form, std::span<const double> c);

/// Whether an effect of one number is as large as it can be, either way: it stands for something else then.
bool is_at_its_end(const EffectForm& form, std::span<const double> coordinates);

}  // namespace swayaw::mismatch::detail
