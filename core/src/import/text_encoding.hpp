#pragma once

#include <filesystem>
#include <string>

namespace swayaw::inline core::detail {

/// Text in UTF-8 and what it was before.
struct DecodedText {
  std::string text;
  std::string encoding;  ///< "UTF-8", "UTF-16LE", "Windows-1252"
};

/// The encoding is told by the byte order mark; without one, text that is not UTF-8 is Windows-1252, of which ISO
/// 8859-1 is a part, and zero bytes in every other place mean UTF-16.
/// @throws FileError  for bytes that are no text, such as a workbook
DecodedText decoded(std::string bytes, const std::filesystem::path& file);

}  // namespace swayaw::core::detail
