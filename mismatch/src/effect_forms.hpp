#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "swayaw/nonlinear/effects/acting_ship.hpp"
#include "swayaw/nonlinear/effects/search_form.hpp"

/// Effects in coordinates that a fit moves. Not installed.
namespace swayaw::inline mismatch::detail {

/// An effect of any kind as a function of coordinates; each kind tells its own in its file.
using EffectForm = SearchForm<Effect>;

/// A rudder whose lift falls a little with its angle, K = 1 − loss (delta)²: what every lift curve does and no linear
/// one knows. It belongs to the baseline of every ship that has a place for it.
/// @return nothing for other models, and where the ship has a gap of her own
std::optional<EffectForm> ordinary_lift_loss(const Ship& ship);

/// Of the force that stands for what is wrong in the form of hull, propeller and rudder.
inline constexpr std::string_view form_id = ModelForm<>::id;

/// Of a coordinate of that force: 0 along, 1 across, 2 of the moment, 3 where it differs from side to side.
int axis_of_term(std::string_view name);

/// The channel that an effect is of, if it is of one.
std::optional<Channel> channel_of(const EffectForm& form);

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

/// All candidates for a ship, the channels of her runs and their longest duration [s]; the last is a constant force
/// without a name that begins and ends.
std::vector<EffectForm> effect_forms(const Ship& ship, std::span<const Channel> channels, double duration);

/// A force that no candidate explains, as a map of the motion and the heading, term by term.
EffectForm unknown_map(const Ship& ship);

/// Whether an effect is larger than the practical floor in any of its parameters that decide.
bool is_finding(const Ship& ship, const Effect& effect);

}  // namespace swayaw::mismatch::detail
