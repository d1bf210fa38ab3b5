#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "swayaw/core/angle.hpp"
#include "swayaw/mismatch/diagnose.hpp"
#include "swayaw/nonlinear/effects.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "symmetric_ship.hpp"
#include "tank_instruments.hpp"

/// Effects planted at the sizes that a diagnosis lists as the smallest to show.
namespace swayaw::test {

inline const ManoeuvreOptions sampled{.duration = 110.0, .step = 0.3};

/// Two zigzags and a turn with new noise.
inline std::vector<Recording> trials(const Ship& ship, unsigned seed) {
  std::vector<Recording> runs{
      zigzag(ship, {.rudder = radians(10), .heading = radians(10)}, sampled).run,
      zigzag(ship, {.rudder = radians(20), .heading = radians(20), .first = Side::port}, sampled).run,
      turning_circle(ship, {.rudder = radians(35), .side = Side::starboard}, sampled).run};
  std::mt19937_64 engine(seed);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    runs[i].name = fmt::format("run {}", i);
    measure(runs[i], engine);
  }
  return runs;
}

inline Diagnosis diagnosed(const Ship& real, unsigned seed) {
  return diagnose(symmetric_ship(), trials(real, seed), {}, {}, {.most_effects = 1});
}

/// An effect of a listed size; where it has a direction, from anywhere.
inline Effect planted(const Ship& ship, const DetectableSize& size, std::mt19937_64& engine) {
  auto effect = make_effect(size.effect);
  std::uniform_real_distribution around(0.0, 2.0 * pi);
  for (const auto& p : parameters_of(ship, effect)) {
    auto& value = parameter_value(effect, p.index);
    if (p.key == size.key) {
      value = p.null + size.value;
    } else if (p.direction) {
      value = around(engine);
    }
  }
  return effect;
}

struct Found {
  int first = 0, among_equals = 0;
  std::map<std::string, int> instead{};  ///< what was named, and how often
};

/// How often it is named, or told not to be told from what is named.
inline Found found_of(const DetectableSize& size, int count) {
  const auto ship = symmetric_ship();
  Found found;
  for (int i = 0; i < count; ++i) {
    std::mt19937_64 engine(1000u + static_cast<unsigned>(i));
    const auto effect = planted(ship, size, engine);
    const auto d = diagnosed(with_effect(ship, effect), 100u + static_cast<unsigned>(i));
    if (d.effects.empty()) {
      ++found.instead[std::string(name_of(d.verdict))];
      continue;
    }
    const auto& named = d.effects.front();
    const bool is_first = id_of(named.effect) == size.effect;
    if (is_first) ++found.first;
    else ++found.instead[std::string(id_of(named.effect))];
    found.among_equals += is_first || std::ranges::count(named.indistinguishable_from, size.effect) > 0;
  }
  return found;
}

/// What a diagnosis of these runs lists where nothing is hidden.
inline std::vector<DetectableSize> listed_sizes() { return diagnosed(symmetric_ship(), 7).detectable; }

}  // namespace swayaw::test
