#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "swayaw/core/detail/idle_threads.hpp"

/// Independent parts of a work on all cores. Whoever calls it links the threads of the platform.
namespace swayaw::inline core {

/// Whether this thread works on a part already.
inline thread_local bool on_a_part = false;

/// Calls work(0) … work(parts − 1), each once, in any order; the calling thread works too. Within a part, on its thread
/// and on those that the work around it has no part left for: never are there more than that one asked for.
///
/// @param threads  0 for one on each core
/// @throws what the first call that failed threw, once all threads have ended
template <class Work>
void in_parallel(std::size_t parts, unsigned threads, const Work& work) {
  if (parts == 0) return;
  const std::size_t wanted = threads > 0 ? threads : std::max(1u, std::thread::hardware_concurrency());
  std::atomic<int> own = static_cast<int>(wanted) - 1, none = 0;
  const bool inner = on_a_part;
  auto* const before = detail::idle_threads;
  auto& idle = !inner ? own : before ? *before : none;
  const int others = detail::taken(idle, std::min(wanted, parts) - 1);
  if (inner && others == 0) {
    for (std::size_t part = 0; part < parts; ++part) work(part);
    return;
  }
  std::atomic<std::size_t> next = 0;
  std::exception_ptr trouble;
  std::mutex guard;
  const auto take = [&] {
    on_a_part = true, detail::idle_threads = &idle;
    try {
      for (std::size_t part = next++; part < parts; part = next++) work(part);
    } catch (...) {
      const std::scoped_lock lock(guard);
      if (!trouble) trouble = std::current_exception();
    }
    on_a_part = inner, detail::idle_threads = before;
  };
  {
    std::vector<std::jthread> helpers;
    for (int i = 0; i < others; ++i) helpers.emplace_back([&] { take(), ++idle; });
    take();
    if (!inner) ++idle;  // it only waits from here on
  }
  if (trouble) std::rethrow_exception(trouble);
}

}  // namespace swayaw::core
