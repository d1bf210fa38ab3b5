#include "gram_packs.hpp"

namespace swayaw::inline identification::gram {

GramKernel avx512_gram() { return gram_packs<xsimd::avx512bw>; }

}  // namespace swayaw::identification::gram
