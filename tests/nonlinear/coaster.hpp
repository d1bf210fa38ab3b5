#pragma once

#include "swayaw/nonlinear/estimates/hull_dimensions.hpp"

namespace swayaw::test {

/// A coaster of which nothing but her main dimensions is known.
inline constexpr HullDimensions<double> coaster{.L = 97.4, .B = 16.6, .d = 7.1, .C_B = 0.761};

}  // namespace swayaw::test
