#include "batch_zigzag.hpp"

namespace swayaw::batch {

ZigzagKernel baseline_zigzags() {
#ifdef XSIMD_NO_SUPPORTED_ARCHITECTURE
  return nullptr;
#else
  return sail_packs<xsimd::default_arch>;
#endif
}

}  // namespace swayaw::batch
