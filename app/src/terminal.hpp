#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

/// What goes to a person at a terminal rather than to a file or another program.
namespace swayaw::app {

/// Columns of the terminal behind stdout; 0 where there is none.
int terminal_columns();

/// The words folded at blanks so that no line is wider; further lines begin with `indent` blanks. 0 columns: as it is.
std::string folded(std::string_view words, int columns, std::size_t indent = 0);

/// A line without the blanks at its end, folded: it goes on below the last of its columns, which two blanks or more
/// part, or below its first word.
std::string fitted(std::string_view line, int columns);

/// Text to stdout, its lines fitted to the terminal.
void print_fitted(std::string_view text);

template <class... Value>
void say(fmt::format_string<Value...> text, Value&&... values) {
  print_fitted(fmt::format(text, std::forward<Value>(values)...));
}

}  // namespace swayaw::app
