#pragma once

#include <array>
#include <limits>
#include <span>
#include <vector>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/parameter.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"

/// Indices of manoeuvres and their exact derivatives by the numbers of the ship (docs/index_tuning.md).
namespace swayaw::inline nonlinear {

/// All indices of a turning circle, told as of a turn to starboard. What does not exist is not a number.
template <class S = double>
struct CircleIndices {
  S u, v, r;            ///< of the steady turn; v is negative
  S U;                  ///< its speed
  S beta;               ///< its drift angle
  S D;                  ///< its diameter, 2U/r
  S advance, transfer;  ///< at 90 deg change of heading
  S tactical_diameter;  ///< at 180 deg
  S time_90, time_180;
  S initial_turning;  ///< way made at 10 deg; only if the turn was sampled

  static constexpr auto parameters() {
    using I = CircleIndices;
    using P = ParameterOf<I, S>;
    return std::array{
        P{"final_u", &I::u, "m/s", positive},
        P{"final_v", &I::v, "m/s", not_zero},
        P{"final_yaw_rate", &I::r, "rad/s", positive},
        P{"final_speed", &I::U, "m/s", positive},
        P{"final_drift", &I::beta, "rad", not_zero},
        P{"final_diameter", &I::D, "m", positive},
        P{"advance", &I::advance, "m", not_zero},
        P{"transfer", &I::transfer, "m", not_zero},
        P{"tactical_diameter", &I::tactical_diameter, "m", not_zero},
        P{"time_90", &I::time_90, "s", positive},
        P{"time_180", &I::time_180, "s", positive},
        P{"initial_turning", &I::initial_turning, "m", positive},
    };
  }
};

/// All indices of a zigzag. What does not exist is not a number.
template <class S = double>
struct ZigzagIndices {
  S overshoot_1, overshoot_2, overshoot_3, overshoot_4;  ///< heading peaks beyond the switch angle
  S period;                                              ///< between the last reversal and the last but two
  S initial_turning;  ///< way made at the first reversal; only if the zigzag was sampled

  static constexpr auto parameters() {
    using I = ZigzagIndices;
    using P = ParameterOf<I, S>;
    return std::array{
        P{"overshoot[0]", &I::overshoot_1, "rad", positive},
        P{"overshoot[1]", &I::overshoot_2, "rad", positive},
        P{"overshoot[2]", &I::overshoot_3, "rad", positive},
        P{"overshoot[3]", &I::overshoot_4, "rad", positive},
        P{"period", &I::period, "s", positive},
        P{"initial_turning", &I::initial_turning, "m", positive},
    };
  }
};

CircleIndices<> indices_of(const TurningCircle& circle, Side side);
ZigzagIndices<> indices_of(const Zigzag& zigzag);

/// Derivatives by numbers of a ship, SI; empty for an index that does not exist.
using Slopes = std::vector<double>;

/// Derivatives of the indices by numbers of the ship, exact for the steps that were taken.
///
/// The steps are taken once more in duals. An event comes at g(t, theta) = 0, so that
///
///     dt/dtheta = −(∂g/∂theta) / (dg/dt),
///
/// and the step that ends there is longer or shorter by that. In the steady turn a(m, theta) = 0 and
///
///     dm/dtheta = −(∂a/∂m)⁻¹ ∂a/∂theta
///
/// Self-propulsion at the approach speed is kept, unless shaft speed or thrust were given.
///
/// @param circle   of the same ship, order and options, `traced`
/// @param numbers  every slopes_at_once of them cost one more pass
/// @throws Refusal  for a ship in wind, or with effects other than a current
CircleIndices<Slopes> index_slopes(const Ship& ship, const TurnOrder& order, const ManoeuvreOptions& options,
                                   const TurningCircle& circle, std::span<const Parameter> numbers);

/// The same of a zigzag.
ZigzagIndices<Slopes> index_slopes(const Ship& ship, const ZigzagOrder& order, const ManoeuvreOptions& options,
                                   const Zigzag& zigzag, std::span<const Parameter> numbers);

/// How many numbers one more pass takes.
inline constexpr std::size_t slopes_at_once = 19;

}  // namespace swayaw::nonlinear
