#pragma once

#include <string>
#include <string_view>

/// Text of others as it may be shown. Not installed.
namespace swayaw::inline core::detail {

/// Whether a text may have several lines.
enum class Lines { one, many };

/// The text with nothing in it that a terminal obeys or that moves what stands beside it: control characters, marks
/// that turn the direction of writing are written out as in JSON, "\u001b", "\u202e", and bytes that are not UTF-8 as
/// "\xff". Tabs stay, and the ends of lines where there may be several. What was written out once stays as it is.
std::string printable(std::string_view text, Lines lines = Lines::one);

}  // namespace swayaw::core::detail
