#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "swayaw/core/file_limits.hpp"

namespace swayaw::inline core {

/// The whole text of a file, or of a pipe into which somebody writes.
///
/// @throws FileError  if it cannot be read, is a folder or a device, is larger than `largest_file(use)`, or has a line
///                    that is longer than `longest_line`
std::string read_text(const std::filesystem::path& file, FileUse use = FileUse::samples);

/// For who reads a file by other means.
/// @throws FileError  if it is there and is no regular file, or is larger than `largest_file(use)`
void require_regular_file(const std::filesystem::path& file, FileUse use = FileUse::samples);

/// Writes beside the file and renames, so that a reader sees the old text or the new, never half.
///
/// A file that is there keeps its permissions; a new one has those that the user's mask leaves. A link stays and the
/// file it points to changes, unless another user laid the link into a folder where all may write, as /tmp.
///
/// @throws FileError  if it cannot be written; nothing is left behind
void write_text(const std::filesystem::path& file, std::string_view text);

/// The same for what a function writes to the draft beside the file; whether it could is what it returns.
void write_draft(const std::filesystem::path& file, const std::function<bool(const std::filesystem::path&)>& write);

}  // namespace swayaw::core
