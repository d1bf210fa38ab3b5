#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace swayaw::inline mismatch {

/// What the ship was doing when a sample was taken.
enum class Variable {
  drift,     ///< beta [rad]
  yaw_rate,  ///< r' = rL/U
  rudder,    ///< delta, positive to port [rad]
};

std::string_view name_of(Variable variable);

/// Motion and rudder of every sample, the coordinates of the regions.
struct Conditions {
  std::vector<double> drift;
  std::vector<double> yaw_rate;
  std::vector<double> rudder;

  std::span<const double> of(Variable variable) const;
};

/// Errors while one variable lay between two bounds; an open bound is not given.
struct RegionError {
  Variable variable;
  std::optional<double> from;
  std::optional<double> to;
  std::size_t samples;
  double rms;
  double bias;   ///< mean, simulated minus recorded
  double share;  ///< of all squared errors
};

/// "rudder 15 to 25 deg to port"
std::string words_for(const RegionError& region);

/// Errors sorted by drift, by yaw rate and by rudder, in fixed steps; empty steps are left out.
std::vector<RegionError> errors_by_region(std::span<const double> errors, const Conditions& conditions);

/// The region with the largest root-mean-square error among those that hold a twentieth of the samples or more.
std::optional<RegionError> worst_region(std::span<const RegionError> regions);

}  // namespace swayaw::mismatch
