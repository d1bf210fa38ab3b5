#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

/// Chance that is the same with every compiler.
namespace swayaw::concealed {

/// splitmix64 and the normal numbers of Box and Muller.
class RandomSource {
 public:
  explicit RandomSource(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ull);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
  }

  /// In (0, 1).
  double uniform() { return (static_cast<double>(bits() >> 11) + 0.5) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  double sign() { return uniform() < 0.5 ? -1.0 : 1.0; }
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(bits() % n); }

  double normal() { return std::sqrt(-2.0 * std::log(uniform())) * std::cos(2.0 * std::numbers::pi * uniform()); }

 private:
  std::uint64_t state_;
};

/// A first-order Gauss–Markov process: standard deviation 1, memory in steps.
class Wandering {
 public:
  Wandering(double memory, RandomSource& random)
      : stays_(std::exp(-1.0 / memory)), random_(random), value_(random.normal()) {}

  double next() { return value_ = stays_ * value_ + std::sqrt(1.0 - stays_ * stays_) * random_.normal(); }

 private:
  double stays_;
  RandomSource& random_;
  double value_;
};

/// A seed of its own for part `index` of what has that seed.
inline std::uint64_t seed_of(std::uint64_t seed, std::uint64_t index) {
  return RandomSource(seed * 0x2545f4914f6cdd1dull + index).bits();
}

}  // namespace swayaw::concealed
