#include "gram_packs.hpp"

namespace swayaw::gram {

GramKernel baseline_gram() {
#ifdef XSIMD_NO_SUPPORTED_ARCHITECTURE
  return nullptr;
#else
  return gram_packs<xsimd::default_arch>;
#endif
}

}  // namespace swayaw::gram
