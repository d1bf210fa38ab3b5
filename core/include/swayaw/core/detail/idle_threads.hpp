#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>

/// Threads of a work in parts that have no part left. Not for users.
namespace swayaw::inline core::detail {

/// How many threads of the work that this thread has a part of are idle, no part being left for them; null where all
/// stays on this thread.
inline thread_local std::atomic<int>* idle_threads = nullptr;

/// Takes up to so many of them. @return how many
inline int taken(std::atomic<int>& idle, std::size_t most) {
  int here = idle, taken = 0;
  do taken = std::min(std::max(here, 0), static_cast<int>(most));
  while (taken > 0 && !idle.compare_exchange_weak(here, here - taken));
  return taken;
}

}  // namespace swayaw::core::detail
