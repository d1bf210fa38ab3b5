#pragma once

#include <ceres/jet.h>

#include "swayaw/core/scalar.hpp"

namespace swayaw::inline core {

/// Forward-mode dual number: a value `a` and its N derivatives `v`.
template <int N>
using Dual = ceres::Jet<double, N>;

}  // namespace swayaw::core
