#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <string_view>

#include "swayaw/core/recording_csv.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/core/side.hpp"
#include "swayaw/nonlinear/replay.hpp"

namespace swayaw::app {

/// A recording; its warnings go to stderr.
inline Recording load_run(const std::filesystem::path& file) {
  auto loaded = read_recording(file);
  for (const auto& warning : loaded.warnings) fmt::print(stderr, "swayaw: {}\n", warning);
  return std::move(loaded.recording);
}

inline Side side_named(std::string_view name) { return name == "port" ? Side::port : Side::starboard; }

inline Shaft shaft_named(std::string_view name) { return name == "recorded" ? Shaft::recorded : Shaft::self_propulsion; }

/// Says once on stderr where the shaft speed comes from when the run does not tell it.
inline void tell_shaft(const Recording& run, Shaft shaft) {
  if (shaft == Shaft::recorded && !run.has(Channel::rev))
    fmt::print(stderr, "swayaw: {}: no shaft speed recorded; the model's self-propulsion point is used\n", run.name);
}

}  // namespace swayaw::app
