#include "sample_blocks.hpp"
#ifdef SWAYAW_PACKS
#include "batch_zigzag.hpp"
#endif

namespace swayaw::inline linear::batch {

ZigzagKernel baseline_zigzags() {
#if defined(SWAYAW_PACKS) && !defined(XSIMD_NO_SUPPORTED_ARCHITECTURE)
  return sail_packs<xsimd::default_arch>;
#else
  return nullptr;
#endif
}

SampleKernel baseline_samples() { return sample_blocks<struct Baseline>; }

}  // namespace swayaw::linear::batch
