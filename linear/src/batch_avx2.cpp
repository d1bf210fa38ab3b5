#include "batch_zigzag.hpp"
#include "sample_blocks.hpp"

namespace swayaw::inline linear::batch {

ZigzagKernel avx2_zigzags() { return sail_packs<xsimd::fma3<xsimd::avx2>>; }

SampleKernel avx2_samples() { return sample_blocks<struct Avx2>; }

}  // namespace swayaw::linear::batch
