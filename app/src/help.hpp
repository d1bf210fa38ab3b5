#pragma once

#include <string>
#include <string_view>

#include "swayaw/core/refusal.hpp"

namespace CLI {
class App;
}

/// What helps at the terminal: examples, completion, the place of an error in its file.
namespace swayaw::app {

/// Puts an example or two below the help of each command.
void add_examples(CLI::App& app);

/// Help of no more than 80 columns, of the program and of the commands that are added to it afterwards.
void narrow_help(CLI::App& app);

/// A script for bash, or zsh by its bashcompinit, that completes commands, their options and files.
std::string completion_script(const CLI::App& app);

/// The line of the file with a caret below the place; empty where no line is known or the file cannot be read.
///
///     4 | 1,0.1,abc
///       |       ^
std::string with_caret(const FilePlace& place);

}  // namespace swayaw::app
