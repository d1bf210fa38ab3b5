#include "batch_zigzag.hpp"

namespace swayaw::batch {

ZigzagKernel avx2_zigzags() { return sail_packs<xsimd::fma3<xsimd::avx2>>; }

}  // namespace swayaw::batch
