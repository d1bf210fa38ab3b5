#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "swayaw/core/recording.hpp"
#include "swayaw/core/side.hpp"

namespace swayaw::inline core {

/// A recording and what its reader should be told.
struct RecordingFile {
  Recording recording;
  std::vector<std::string> warnings;  ///< one line each, beginning with the file's name
};

/// Reads a recording from comma-separated text (docs/formats.md), or from a file that ends in .mat, whose variables or
/// whose struct of vectors have the names of columns and run keys (docs/matlab.md).
///
/// Every unit becomes SI, the rudder positive to port, latitude and longitude a north–east plane
/// about the first fix, heading unwrapped. Position and velocity move from the reported point, reference_x_m
/// forward of midship, to midship:  x − l cos(psi),  y − l sin(psi),  v − l r,  and speed and course over
/// ground accordingly. Columns that are not understood are kept and named in a warning.
///
/// @param rudder_positive  side to which the rudder column is positive, whatever the file says; nothing: as it says
/// @throws FileError  "FILE:LINE:COLUMN: what is wrong"
RecordingFile read_recording(const std::filesystem::path& file, std::optional<Side> rudder_positive = {});

/// The same from text; `name` stands for the file in messages.
RecordingFile parse_recording(std::string_view text, const std::filesystem::path& name,
                              std::optional<Side> rudder_positive = {});

/// Comma-separated text of a recording: SI columns, rudder positive to port, full precision.
std::string recording_text(const Recording& recording);

/// Writes `recording_text`, or variables with its names if the file ends in .mat; all of it or nothing.
/// @throws FileError  if the file cannot be written
void write_recording(const Recording& recording, const std::filesystem::path& file);

}  // namespace swayaw::core
