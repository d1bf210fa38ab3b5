#include "gram_packs.hpp"

namespace swayaw::inline identification::gram {

GramKernel avx2_gram() { return gram_packs<xsimd::fma3<xsimd::avx2>>; }

}  // namespace swayaw::identification::gram
