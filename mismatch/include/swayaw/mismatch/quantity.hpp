#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "swayaw/core/recording.hpp"

namespace swayaw::inline mismatch {

/// What is compared between two recordings.
enum class Quantity {
  heading,   ///< psi [rad]
  yaw_rate,  ///< r [rad/s]
  speed,     ///< forward speed u [m/s]
  drift,     ///< beta = atan2(-v, u) [rad]
  position,  ///< distance between the two midship points [m]
};

inline constexpr std::array all_quantities{Quantity::heading, Quantity::yaw_rate, Quantity::speed, Quantity::drift,
                                           Quantity::position};

/// "yaw_rate"
std::string_view name_of(Quantity quantity);

/// "rad/s"
std::string_view unit_of(Quantity quantity);

/// Whether a recording tells the quantity: speed through u or the log, drift through u and v.
bool tells(const Recording& run, Quantity quantity);

/// The quantity sample by sample; missing where it was not recorded. Not for position.
std::vector<double> values_of(const Recording& run, Quantity quantity);

/// Simulated minus recorded, sample by sample, of two recordings with the same times; heading in [-pi, pi],
/// position as a distance. Missing where either is.
std::vector<double> errors_of(const Recording& simulated, const Recording& recorded, Quantity quantity);

/// Root-mean-square distance of the quantity from its mean over the run; of position, of both axes together.
double variation_of(const Recording& run, Quantity quantity);

}  // namespace swayaw::mismatch
