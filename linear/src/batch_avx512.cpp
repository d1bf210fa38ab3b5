#include "batch_zigzag.hpp"

namespace swayaw::batch {

ZigzagKernel avx512_zigzags() { return sail_packs<xsimd::avx512bw>; }

}  // namespace swayaw::batch
