#include "zigzag_lanes.hpp"

namespace swayaw::mmg_batch {

ZigzagKernel baseline_zigzags() {
#ifdef XSIMD_NO_SUPPORTED_ARCHITECTURE
  return nullptr;
#else
  return run_lanes<xsimd::default_arch>;
#endif
}

}  // namespace swayaw::mmg_batch
