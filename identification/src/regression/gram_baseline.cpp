#include "gram_kernel.hpp"
#ifdef SWAYAW_PACKS
#include "gram_packs.hpp"
#endif

namespace swayaw::inline identification::gram {

GramKernel baseline_gram() {
#if defined(SWAYAW_PACKS) && !defined(XSIMD_NO_SUPPORTED_ARCHITECTURE)
  return gram_packs<xsimd::default_arch>;
#else
  return nullptr;
#endif
}

}  // namespace swayaw::identification::gram
