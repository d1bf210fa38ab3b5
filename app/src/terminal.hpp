#pragma once

#include <string>
#include <string_view>

/// What goes to a person at a terminal rather than to a file or another program.
namespace swayaw::app {

/// Columns of the terminal behind stdout; 0 where there is none.
int terminal_columns();

/// The words folded at blanks so that no line is wider; further lines begin with `indent` blanks. 0 columns: as it is.
std::string folded(std::string_view words, int columns, std::size_t indent = 0);

/// Words to stdout on lines of their own, folded at a terminal.
void print_words(std::string_view words, std::size_t indent = 0);

}  // namespace swayaw::app
