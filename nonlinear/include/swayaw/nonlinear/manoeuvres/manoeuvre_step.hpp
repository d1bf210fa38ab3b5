#pragma once

#include <array>
#include <cstddef>

namespace swayaw::inline nonlinear {

/// No model has more branch functions.
inline constexpr std::size_t most_branches = 6;

/// What ended a step of the integration.
enum class StepEnd {
  none,    ///< nothing: its length
  kink,    ///< the rudder rate jumps
  branch,  ///< the force changes its branch
  watch,   ///< what the manoeuvre waited for has come
};

/// A step of an integration, so that it can be taken again in another scalar.
struct ManoeuvreStep {
  double to;  ///< its end [s]
  StepEnd end;
  std::array<bool, most_branches> branch;  ///< the branch of the force during the step
  std::size_t function;                    ///< branch function that passed zero at its end
};

}  // namespace swayaw::nonlinear
