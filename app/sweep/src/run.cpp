#include "swayaw/app/sweep/run.hpp"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "swayaw/core/parallel.hpp"

namespace swayaw::app {
namespace {

/// Blocks that wait to be written, so that memory does not grow where the disk is slow.
constexpr std::size_t most_waiting = 64;

/// Blocks on their way from those who work on them to the one who writes.
class Finished {
 public:
  void put(SweepBlock block) {
    std::unique_lock lock(guard_);
    changed_.wait(lock, [&] { return blocks_.size() < most_waiting || ended_; });
    blocks_.push_back(std::move(block));
    if (blocks_.size() == most_waiting) changed_.notify_all();
  }

  /// All that are there after a while, sooner where many wait or no more come.
  std::vector<SweepBlock> take(const std::atomic<unsigned>& workers) {
    std::unique_lock lock(guard_);
    changed_.wait_for(lock, commit_after, [&] { return blocks_.size() >= most_waiting / 2 || workers == 0; });
    std::vector<SweepBlock> taken;
    taken.swap(blocks_);
    changed_.notify_all();
    return taken;
  }

  void wake() { changed_.notify_all(); }

  /// Nobody takes any more.
  void end() {
    const std::scoped_lock lock(guard_);
    ended_ = true;
    changed_.notify_all();
  }

 private:
  std::mutex guard_;
  std::condition_variable changed_;
  std::vector<SweepBlock> blocks_;
  bool ended_ = false;
};

}  // namespace

SweepCount counted(const SweepWork& work, const SweepStore& store) {
  SweepCount count{.all = work.items()};
  for (std::size_t b = 0; b < work.blocks(); ++b)
    if (store.done()[b]) count.before += work.block_size(b);
  count.done = count.before;
  return count;
}

SweepCount run_sweep(const SweepWork& work, SweepStore& store, unsigned threads,
                     const std::function<bool(const SweepCount&)>& go_on) {
  auto count = counted(work, store);
  std::vector<std::size_t> pending;
  for (std::size_t b = 0; b < work.blocks(); ++b)
    if (!store.done()[b]) pending.push_back(b);

  Finished finished;
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> stop = false;
  std::exception_ptr trouble;
  std::mutex trouble_guard;
  const auto wanted = static_cast<unsigned>(
      std::min<std::size_t>(threads > 0 ? threads : std::max(1u, std::thread::hardware_concurrency()), pending.size()));
  std::atomic<unsigned> workers = wanted;
  const auto take_blocks = [&] {
    core::on_a_part = true;  // what it calls stays on this thread
    try {
      for (std::size_t i = next++; i < pending.size() && !stop; i = next++) finished.put(work.block(pending[i]));
    } catch (...) {
      const std::scoped_lock lock(trouble_guard);
      trouble = std::current_exception();
      stop = true;
    }
    --workers;
    finished.wake();
  };
  {
    std::vector<std::jthread> hands;
    for (unsigned i = 0; i < wanted; ++i) hands.emplace_back(take_blocks);
    try {
      while (true) {
        const bool last = workers == 0;
        const auto blocks = finished.take(workers);
        if (!blocks.empty()) store.write(blocks);
        for (const auto& b : blocks) count.done += b.count;
        if (!go_on(count)) stop = true;
        if (last) break;
      }
    } catch (...) {
      stop = true;
      finished.end();
      throw;
    }
  }
  if (trouble) std::rethrow_exception(trouble);
  return count;
}

}  // namespace swayaw::app
