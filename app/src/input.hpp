#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/detail/spelling.hpp"
#include "swayaw/core/parts_reader.hpp"
#include "swayaw/core/recording_csv.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/core/ship_text.hpp"
#include "swayaw/core/side.hpp"
#include "swayaw/linear/linear_ship_file.hpp"
#include "swayaw/nonlinear/linearization.hpp"
#include "swayaw/nonlinear/published_ships.hpp"
#include "swayaw/nonlinear/replay.hpp"
#include "swayaw/nonlinear/ship_file.hpp"
#include "terminal.hpp"

namespace swayaw::app {

inline Side side_named(std::string_view name) { return name == "port" ? Side::port : Side::starboard; }

/// A recording; its warnings go to stderr.
///
/// @param rudder_positive  "port" or "starboard", whatever the file says; empty: as it says
inline Recording load_run(const std::filesystem::path& file, std::string_view rudder_positive = {}) {
  auto loaded =
      read_recording(file, rudder_positive.empty() ? std::nullopt : std::optional(side_named(rudder_positive)));
  for (const auto& warning : loaded.warnings) say_aside("swayaw: {}\n", warning);
  return std::move(loaded.recording);
}

/// A ship of any model.
using AnyShip = std::variant<LinearShip, Ship>;

[[noreturn]] inline void refuse_ship_name(const std::string& name) {
  std::vector<std::string_view> names;
  for (const auto& ship : published_ships()) names.push_back(ship.name);
  const auto hint = core::detail::did_you_mean(name, names);
  throw Refusal(fmt::format("there is no file and no published ship \"{}\"{}", name,
                            hint.empty() ? fmt::format("; published are {}", fmt::join(names, ", ")) : hint));
}

/// The text of a ship file. Where no such file is there, a bare name means the published ship, which is told on stderr.
inline std::string ship_text(const std::filesystem::path& file) {
  if (std::filesystem::exists(file) || file.has_parent_path() || file.has_extension()) return read_ship_text(file);
  const auto text = published_text(file.string());
  if (!text) refuse_ship_name(file.string());
  say_aside("swayaw: {}: no such file here; the published ship of that name is used\n", file.string());
  return std::string(*text);
}

/// A ship of either kind. @param file  where the text is from, for messages
inline AnyShip parse_any_ship(const std::string& text, const std::filesystem::path& file) {
  if (model_of(text, file) == "linear") return parse_linear_ship(text, file);
  return parse_ship(text, file);
}

inline AnyShip load_ship(const std::filesystem::path& file) { return parse_any_ship(ship_text(file), file); }

/// A linear ship, or the small motions of another about the straight course at that speed, the service speed unless
/// given.
inline LinearShip load_linear_ship(const std::filesystem::path& file,
                                   const std::optional<double>& speed = std::nullopt) {
  auto any = load_ship(file);
  if (auto* linear = std::get_if<LinearShip>(&any)) return std::move(*linear);
  const auto& ship = std::get<Ship>(any);
  say_aside("swayaw: {}: linearized about the straight course\n", ship.name);
  return linear_ship(ship, linearize(ship, straight_course(ship, speed.value_or(service_speed(ship)))));
}

/// A ship of a nonlinear model. @throws Refusal  for a linear one
inline Ship load_nonlinear_ship(const std::filesystem::path& file) {
  auto any = load_ship(file);
  if (auto* ship = std::get_if<Ship>(&any)) return std::move(*ship);
  throw Refusal(fmt::format("{}: this ship is linear and has no parts with forces", file.string()));
}

inline std::vector<double> in_degrees(std::vector<double> angles) {
  for (double& x : angles) x = degrees(x);
  return angles;
}

/// "20/10": rudder angle and heading of a zigzag in degrees. The form was checked when the arguments were read.
struct ZigzagAngles {
  double rudder;   ///< [rad]
  double heading;  ///< [rad]
};

inline ZigzagAngles zigzag_angles(const std::string& text) {
  const auto slash = text.find('/');
  return {.rudder = radians(std::stod(text.substr(0, slash))), .heading = radians(std::stod(text.substr(slash + 1)))};
}

/// "zigzag 20/10".
inline std::string name_of(const ZigzagAngles& angles) {
  return fmt::format("zigzag {:.6g}/{:.6g}", degrees(angles.rudder), degrees(angles.heading));
}

inline Shaft shaft_named(std::string_view name) {
  return name == "recorded" ? Shaft::recorded : Shaft::self_propulsion;
}

}  // namespace swayaw::app
