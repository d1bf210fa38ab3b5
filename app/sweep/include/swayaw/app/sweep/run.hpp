#pragma once

#include <chrono>
#include <cstddef>
#include <functional>

#include "swayaw/app/sweep/store.hpp"
#include "swayaw/app/sweep/work.hpp"

namespace swayaw::app {

struct SweepCount {
  std::size_t before = 0;  ///< items that were there at the start
  std::size_t done = 0;    ///< items that are there now
  std::size_t all = 0;
};

/// Items that are there before a sweep begins.
SweepCount counted(const SweepWork& work, const SweepStore& store);

/// What is done goes to the file that often; a commit waits for the disk, about 5 ms.
inline constexpr std::chrono::milliseconds commit_after{200};

/// Works on the blocks that are not there yet and writes them as they come, until all are there or it is told to end.
/// Which thread works on a block, and when, changes nothing in it.
///
/// @param threads  0 for one on each core
/// @param go_on    told how far it is now and then; false ends the work, with the blocks in work written
/// @throws Refusal  if results cannot be written
SweepCount run_sweep(const SweepWork& work, SweepStore& store, unsigned threads,
                     const std::function<bool(const SweepCount&)>& go_on);

}  // namespace swayaw::app
