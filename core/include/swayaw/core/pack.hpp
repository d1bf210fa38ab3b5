#pragma once

#include <xsimd/xsimd.hpp>

#include "swayaw/core/scalar.hpp"

namespace swayaw {

/// As many doubles as the instruction set of this translation unit handles at once; one ship a lane.
using Pack = xsimd::batch<double>;

}  // namespace swayaw
