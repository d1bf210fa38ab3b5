#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace swayaw::app {

/// How another program ended, and what it said.
struct ProgramEnd {
  int code;  ///< exit code; 128 + number of the signal that ended it
  std::string out;
  std::string err;
};

/// Runs a program of the PATH with those words and that text on its input, without a shell, and waits for its end.
///
/// Input and output are nameless temporary files: neither side ever waits for the other to read.
///
/// @param words  the program's name, then its arguments
/// @return nothing when there is no such program
/// @throws Refusal  if it cannot be started for another reason
std::optional<ProgramEnd> run_program(std::vector<std::string> words, std::string_view input);

}  // namespace swayaw::app
