#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace swayaw::inline core {

/// The whole text of a file.
/// @throws FileError  if it cannot be read
std::string read_text(const std::filesystem::path& file);

/// Writes beside the file and renames, so that a reader sees the old text or the new, never half.
/// @throws FileError  if it cannot be written; nothing is left behind
void write_text(const std::filesystem::path& file, std::string_view text);

/// The same for what a function writes to the draft beside the file; whether it could is what it returns.
void write_draft(const std::filesystem::path& file, const std::function<bool(const std::filesystem::path&)>& write);

}  // namespace swayaw::core
