#include "seaway.hpp"

#include <cmath>

#include "swayaw/core/angle.hpp"

namespace swayaw::concealed {

Seaway seaway_by_chance(RandomSource& random) {
  constexpr int count = 5;
  if (random.below(5) >= 2) return {};
  Seaway sea{.to = random.uniform(0.0, 2.0 * pi),
             .period = random.uniform(7.0, 11.0),
             .yaw = radians(random.uniform(0.12, 0.35)),
             .sway = random.uniform(0.05, 0.12)};
  const double mean = 2.0 * pi / sea.period, share = 1.0 / std::sqrt(static_cast<double>(count));
  for (int i = 0; i < count; ++i)
    sea.waves.push_back({.frequency = mean * (1.0 + random.uniform(-0.125, 0.125)),
                         .yaw = share * sea.yaw,
                         .sway = share * sea.sway,
                         .phase = random.uniform(0.0, 2.0 * pi),
                         .lag = random.uniform(0.0, 2.0 * pi)});
  return sea;
}

TrueTrack in_waves(TrueTrack track, const Seaway& sea) {
  constexpr double g = 9.80665;
  for (const auto& wave : sea.waves) {
    double phase = wave.phase, way_aside = 0.0;
    for (auto& q : track.states) {
      const double psi = q[State::psi], across = std::sin(sea.to - psi), along = std::cos(sea.to - psi);
      const double encounter = wave.frequency - wave.frequency * wave.frequency / g * q[State::u] * along;
      const double v = wave.sway * across * std::cos(phase), yaw = wave.yaw * 2.0 * across * along;
      way_aside += track.step * v;
      q[State::v] += v;
      q[State::x] -= way_aside * std::sin(psi), q[State::y] += way_aside * std::cos(psi);
      q[State::psi] += yaw * std::sin(phase - wave.lag);
      q[State::r] += yaw * encounter * std::cos(phase - wave.lag);
      phase += track.step * encounter;
    }
  }
  return track;
}

}  // namespace swayaw::concealed
