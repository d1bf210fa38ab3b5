#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "swayaw/core/mat_file.hpp"
#include "swayaw/core/recording_csv.hpp"

/// Recordings as MATLAB files: a variable for each column and each run key, with the names of docs/formats.md. Not
/// installed.
namespace swayaw::inline core::detail {

std::vector<MatVariable> mat_of(const Recording& recording);

/// A value as `key = value` of a recording has it; nothing where it is none that a run key can have.
std::optional<std::string> toml_value(const MatValue& value);

/// @throws FileError  as read_recording; and if no variable, and no field of a struct, is time_s
RecordingFile read_recording_mat(const std::filesystem::path& file, std::optional<Side> rudder_positive);

}  // namespace swayaw::core::detail
