#include "zigzag_kernel.hpp"
#ifdef SWAYAW_PACKS
#include "zigzag_lanes.hpp"
#endif

namespace swayaw::inline nonlinear::mmg_batch {

ZigzagKernel baseline_zigzags() {
#if defined(SWAYAW_PACKS) && !defined(XSIMD_NO_SUPPORTED_ARCHITECTURE)
  return run_lanes<xsimd::default_arch>;
#else
  return nullptr;
#endif
}

}  // namespace swayaw::nonlinear::mmg_batch
