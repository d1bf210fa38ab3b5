#include "text_encoding.hpp"

#include <fmt/format.h>
#include <iconv.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <memory>
#include <optional>
#include <string_view>

#include "swayaw/core/detail/csv_text.hpp"
#include "swayaw/core/refusal.hpp"

namespace swayaw::inline core::detail {
namespace {

/// All of the bytes in UTF-8; nothing where they are not of the encoding.
std::optional<std::string> converted(std::string_view bytes, const char* encoding) {
  const auto close = [](void* converter) { iconv_close(converter); };
  const std::unique_ptr<void, decltype(close)> converter(iconv_open("UTF-8", encoding), close);
  std::string text;
  text.reserve(bytes.size() + bytes.size() / 8);
  std::array<char, 16384> piece;
  auto* from = const_cast<char*>(bytes.data());
  for (std::size_t left = bytes.size(); left > 0;) {
    auto* to = piece.data();
    std::size_t space = piece.size();
    const auto failed = iconv(converter.get(), &from, &left, &to, &space) == static_cast<std::size_t>(-1);
    if (failed && errno != E2BIG) return std::nullopt;
    text.append(piece.data(), piece.size() - space);
  }
  return text;
}

/// Length of the character of UTF-8 that begins here; 0 if none does.
std::size_t character_length(std::string_view text) {
  const auto byte = static_cast<unsigned char>(text.front());
  const std::size_t length = byte < 0x80   ? 1
                             : byte < 0xC2 ? 0
                             : byte < 0xE0 ? 2
                             : byte < 0xF0 ? 3
                             : byte < 0xF5 ? 4
                                           : 0;
  const auto continues = [](char c) { return (c & 0xC0) == 0x80; };
  if (length == 0 || text.size() < length) return 0;
  return std::ranges::all_of(text.substr(1, length - 1), continues) ? length : 0;
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const auto length = character_length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

/// UTF-16 without a byte order mark: the upper byte of plain letters and digits is zero.
const char* utf16_without_mark(std::string_view bytes) {
  std::size_t even = 0, odd = 0;
  const auto begin = bytes.substr(0, 4096);
  for (std::size_t i = 0; i < begin.size(); ++i)
    if (begin[i] == '\0') ++(i % 2 == 0 ? even : odd);
  // most letters of a table are plain, so more than a quarter of all bytes are zero, and all on one side
  const auto many = begin.size() / 4;
  return odd > many && even == 0 ? "UTF-16LE" : even > many && odd == 0 ? "UTF-16BE" : nullptr;
}

[[noreturn]] void refuse_zero(std::string_view bytes, const std::filesystem::path& file) {
  const auto before = bytes.substr(0, bytes.find('\0'));
  const auto line = static_cast<std::size_t>(std::ranges::count(before, '\n')) + 1;
  const auto in_line = before.substr(before.rfind('\n') + 1);
  throw FileError({file, line, in_line.size() + 1}, "a zero byte; a table is plain text");
}

void refuse_workbook(std::string_view bytes, const std::filesystem::path& file) {
  const auto begins = [&](std::string_view mark) { return bytes.starts_with(mark); };
  if (begins("PK\x03\x04") || begins("\xD0\xCF\x11\xE0"))
    throw FileError({file, 1, 1}, "a workbook or archive, not text; save the sheet as CSV first");
}

}  // namespace

DecodedText decoded(std::string bytes, const std::filesystem::path& file) {
  const std::string_view view = bytes;
  refuse_workbook(view, file);
  const auto from = [&](std::size_t mark, const char* encoding) -> DecodedText {
    auto text = converted(view.substr(mark), encoding);
    if (!text) throw FileError({file, 1, 1}, fmt::format("begins as {} and has bytes that are none", encoding));
    if (text->find('\0') != std::string::npos) refuse_zero(*text, file);
    return {std::move(*text), encoding};
  };
  if (view.starts_with("\xFF\xFE")) return from(2, "UTF-16LE");
  if (view.starts_with("\xFE\xFF")) return from(2, "UTF-16BE");
  if (const auto* encoding = utf16_without_mark(view)) return from(0, encoding);
  if (view.find('\0') != std::string_view::npos) refuse_zero(view, file);
  const bool mark = view.starts_with("\xEF\xBB\xBF");
  if (is_utf8(view)) return {mark ? bytes.substr(3) : std::move(bytes), mark ? "UTF-8 with byte order mark" : "UTF-8"};
  if (auto text = converted(view, "CP1252")) return {std::move(*text), "Windows-1252"};
  return from(0, "ISO-8859-1");
}

}  // namespace swayaw::core::detail
