#pragma once

namespace swayaw::inline nonlinear {

/// When a motion counts as steady, and how long it is waited for.
struct Settling {
  double tolerance = 1e-7;  ///< largest acceleration of u and v over U²/L, of r over U²/L², U the approach speed
  double longest = 300.0;   ///< time in L/U after which waiting ends
};

}  // namespace swayaw::nonlinear
