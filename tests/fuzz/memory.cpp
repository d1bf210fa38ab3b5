#include "memory.hpp"

#include <atomic>

#if defined(__SANITIZE_ADDRESS__) || !defined(__GLIBC__)
namespace swayaw::fuzz {
bool counts_memory() { return false; }
std::size_t begin_counting() { return 0; }
std::size_t most_held() { return 0; }
}  // namespace swayaw::fuzz
#else
#include <malloc.h>

#include <cerrno>

namespace {

std::atomic<std::size_t> held{0}, most{0};

void* counted(void* block) {
  if (block == nullptr) return block;
  const auto now = held += ::malloc_usable_size(block);
  auto before = most.load();
  while (before < now && !most.compare_exchange_weak(before, now)) {}
  return block;
}

void forget(void* block) {
  if (block != nullptr) held -= ::malloc_usable_size(block);
}

}  // namespace

namespace swayaw::fuzz {

bool counts_memory() { return true; }

std::size_t begin_counting() {
  most = held.load();
  return held;
}

std::size_t most_held() { return most; }

}  // namespace swayaw::fuzz

// glibc lets a program stand in for its allocator, and gives these names to it.
extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
void __libc_free(void*);

void* malloc(std::size_t size) noexcept { return counted(__libc_malloc(size)); }
void* calloc(std::size_t count, std::size_t size) noexcept { return counted(__libc_calloc(count, size)); }
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  return counted(__libc_memalign(alignment, size));
}
void* memalign(std::size_t alignment, std::size_t size) noexcept { return counted(__libc_memalign(alignment, size)); }
int posix_memalign(void** block, std::size_t alignment, std::size_t size) noexcept {
  *block = counted(__libc_memalign(alignment, size));
  return *block == nullptr ? ENOMEM : 0;
}
void free(void* block) noexcept {
  forget(block);
  __libc_free(block);
}
void* realloc(void* block, std::size_t size) noexcept {
  const std::size_t before = block == nullptr ? 0 : ::malloc_usable_size(block);
  void* moved = __libc_realloc(block, size);
  if (moved == nullptr && size > 0) return nullptr;
  held -= before;
  return counted(moved);
}
}
#endif
