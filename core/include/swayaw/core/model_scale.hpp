#pragma once

/// Ships and their models.
namespace swayaw::inline core {

/// What is shorter is a model: manned ones are up to 15 m long. It moves quicker than a ship, so do its instruments,
/// and its speeds are told in m/s [m].
inline constexpr double longest_model = 20.0;

}  // namespace swayaw::core
