#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

/// Independent parts of a work on all cores. Whoever calls it links the threads of the platform.
namespace swayaw::inline core {

/// Whether this thread works on a part already.
inline thread_local bool on_a_part = false;

/// Calls work(0) … work(parts − 1), each once, in any order; the calling thread works too. Within a part, one after the
/// other on its thread: the cores are busy with the other parts.
///
/// @param threads  0 for one on each core
/// @throws what the first call that failed threw, once all threads have ended
template <class Work>
void in_parallel(std::size_t parts, unsigned threads, const Work& work) {
  if (on_a_part) {
    for (std::size_t part = 0; part < parts; ++part) work(part);
    return;
  }
  std::atomic<std::size_t> next = 0;
  std::exception_ptr trouble;
  std::mutex guard;
  const auto take = [&] {
    on_a_part = true;
    try {
      for (std::size_t part = next++; part < parts; part = next++) work(part);
    } catch (...) {
      const std::scoped_lock lock(guard);
      if (!trouble) trouble = std::current_exception();
    }
    on_a_part = false;
  };
  const std::size_t wanted = threads > 0 ? threads : std::max(1u, std::thread::hardware_concurrency());
  {
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < std::min(wanted, parts); ++i) others.emplace_back(take);
    take();
  }
  if (trouble) std::rethrow_exception(trouble);
}

}  // namespace swayaw::core
