#include "batch_zigzag.hpp"

namespace swayaw::inline linear::batch {

ZigzagKernel avx512_zigzags() { return sail_packs<xsimd::avx512bw>; }

}  // namespace swayaw::linear::batch
