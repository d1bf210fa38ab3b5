#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// Variables of MATLAB files as tables. Not installed.
namespace swayaw::inline core::detail {

struct MatTable {
  std::string text;                ///< comma-separated, variable names in its header
  std::vector<std::string> notes;  ///< what was left out
};

/// @throws FileError  as import_mat
MatTable read_mat_table(const std::filesystem::path& file);

}  // namespace swayaw::core::detail
