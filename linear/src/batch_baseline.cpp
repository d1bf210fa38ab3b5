#include "batch_zigzag.hpp"
#include "sample_blocks.hpp"

namespace swayaw::batch {

ZigzagKernel baseline_zigzags() {
#ifdef XSIMD_NO_SUPPORTED_ARCHITECTURE
  return nullptr;
#else
  return sail_packs<xsimd::default_arch>;
#endif
}

SampleKernel baseline_samples() { return sample_blocks<struct Baseline>; }

}  // namespace swayaw::batch
