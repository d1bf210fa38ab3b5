#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "swayaw/nonlinear/manoeuvre.hpp"

/// Indices of manoeuvres that were measured, from a file (docs/formats.md).
namespace swayaw::inline identification {

using MeasuredManoeuvre = std::variant<TurnOrder, ZigzagOrder>;

/// "turn 35 to starboard", "zigzag 10/10 first port"
std::string name_of(const MeasuredManoeuvre& manoeuvre);

/// One measured number.
struct MeasuredIndex {
  std::string name;   ///< as in the file: "advance_L", "overshoot_deg 2" for the second heading peak
  std::size_t place;  ///< in the list of CircleIndices or ZigzagIndices
  double value;       ///< [SI]; of a turn to port that of its mirror image
  double deviation;   ///< standard deviation of what the measurement and the model leave open [SI]
  double si;          ///< SI value of one unit of the file
};

struct MeasuredTrial {
  MeasuredManoeuvre manoeuvre;
  std::vector<MeasuredIndex> indices;
};

struct MeasuredIndices {
  std::optional<double> speed;   ///< approach speed [m/s]; the service speed unless given
  std::optional<double> rev;     ///< shaft speed [1/s]; that of self-propulsion unless given
  std::optional<double> thrust;  ///< of all propellers [N], in place of a shaft speed
  std::vector<MeasuredTrial> trials;
};

/// Relative standard deviation of an index where the file says nothing.
inline constexpr double default_index_tolerance = 0.05;

/// @param L  ship length [m], for lengths that the file gives in it
/// @throws FileError  "FILE:LINE:COLUMN: what is wrong"
MeasuredIndices read_indices(const std::filesystem::path& file, double L);

/// The same from text; `name` stands for the file in messages.
MeasuredIndices parse_indices(std::string_view text, const std::filesystem::path& name, double L);

}  // namespace swayaw::identification
