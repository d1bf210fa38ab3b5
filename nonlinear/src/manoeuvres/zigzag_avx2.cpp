#include "zigzag_lanes.hpp"

namespace swayaw::inline nonlinear::mmg_batch {

ZigzagKernel avx2_zigzags() { return run_lanes<xsimd::fma3<xsimd::avx2>>; }

}  // namespace swayaw::nonlinear::mmg_batch
