#include "zigzag_lanes.hpp"

namespace swayaw::inline nonlinear::mmg_batch {

ZigzagKernel avx512_zigzags() { return run_lanes<xsimd::avx512bw>; }

}  // namespace swayaw::nonlinear::mmg_batch
