#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "commands.hpp"
#include "json.hpp"
#include "swayaw/app/page.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/recording.hpp"
#include "swayaw/linear/linear_ship.hpp"
#include "swayaw/linear/zigzag.hpp"
#include "user_units.hpp"

/// What the commands on linear ships share.
namespace swayaw::app {

/// {"a1": …, …, "c2": …}
Json coefficients_json(const SwayYawCoefficients<double>& m);

/// A number in a column, "-" where it is infinite or not a number.
std::string cell(double value);

/// What `swayaw indices --json` prints, without its schema.
Json indices_json(const LinearShip& ship, double speed);

/// Time constants and gains with and without dimension.
void print_index_table(const LinearShip& ship, double speed);

/// First-order steering in the signs of ship owners, where a rudder to starboard that turns the ship to starboard has
/// K > 0: K = −Kw, T = T1 + T2 − T3w.
struct Steering {
  double K_prime, T_prime;  ///< per L/U
  double K_per_s, T_s;
};
Steering steering_of(const LinearShip& ship, double speed);

/// "K' = 1.3 (0.031 1/s), T' = …, course stable": two lines.
void print_steering(const LinearShip& ship, double speed);

/// Drift angle beyond which linear equations mean nothing: where the cubic sway force Y_vvv v'^3 of measured hulls is
/// half of the linear Y_v v', 14.8 deg for KCS and 18.2 deg for KVLCC2.
inline constexpr double largest_linear_drift = radians(15.0);

/// Adds to a page whether linear equations hold at a drift angle [rad]; where they do not, in its headline too.
void tell_drift(Page& page, double drift, const UserUnits& units);

/// The heading a1 … c2, and a row of it.
void print_coefficient_names();
void print_coefficients(std::string_view name, const SwayYawCoefficients<double>& m);

/// "course stable, …" and the like.
std::string stability_words(const SwayYawTransfer<double>& h);

/// "hull and rudder", "coefficients" or "indices": what the ship file gives.
std::string_view form_words(const LinearShip& ship);

/// The manoeuvre's speed: as asked, or the service speed.
double speed_of(const LinearShip& ship, const std::optional<double>& asked);

/// A zigzag D/H with the steering gear of the ship, rudder rate in rad per ship length.
/// @throws std::domain_error  if an angle is not positive, or the rudder order beyond the largest angle
LinearZigzagOrder linear_order(const LinearShip& ship, const std::string& zigzag, const std::string& first,
                               double speed);

/// The zigzag as a recording, its facts filled in.
Recording zigzag_recording(const LinearShip& ship, const LinearZigzag<double>& zigzag, const LinearZigzagOrder& order,
                           double speed, const std::optional<double>& step);

/// `swayaw simulate` for a linear ship.
void simulate_linear(const LinearShip& ship, const SimulateArguments& arguments);

}  // namespace swayaw::app
