#pragma once

#include <random>
#include <utility>

#include "swayaw/core/recording.hpp"

namespace swayaw::test {

/// White noise of a tank's instruments on a simulated run of a 7 m model; drift and thrust are not recorded.
inline void measure(Recording& run, std::mt19937_64& engine) {
  for (const auto& [channel, deviation] : {std::pair{Channel::x, 5e-3},
                                           {Channel::y, 5e-3},
                                           {Channel::psi, 2e-3},
                                           {Channel::r, 1e-3},
                                           {Channel::u, 5e-3}}) {
    std::normal_distribution error(0.0, deviation);
    for (double& sample : run.fill(channel)) sample += error(engine);
  }
  run.channels[index_of(Channel::v)].clear();
  run.channels[index_of(Channel::thrust)].clear();
}

}  // namespace swayaw::test
