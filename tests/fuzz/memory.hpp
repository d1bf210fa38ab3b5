#pragma once

#include <cstddef>

/// Memory that this program holds, of C++ and of C libraries alike (memory.cpp).
namespace swayaw::fuzz {

/// Whether it is counted: not under sanitizers, which bring an allocator of their own.
bool counts_memory();

/// From now on the largest is counted anew. @return bytes held now
std::size_t begin_counting();

/// Most bytes held at once since then.
std::size_t most_held();

}  // namespace swayaw::fuzz
