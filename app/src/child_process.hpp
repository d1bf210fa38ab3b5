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

/// Runs a program with those words and that text on its input, without a shell, and waits for its end.
///
/// A bare name is looked for in the folders of PATH that are told from the root: an empty entry or "." of PATH, which
/// mean the current folder, find nothing. Of the environment the program gets what it needs (`child_variables`), of the
/// open files its input and its two outputs, which are in memory: neither side ever waits for the other to read, and
/// nobody else can read them.
///
/// @param words  the program's name, then its arguments
/// @return nothing when there is no such program
/// @throws Refusal  if it cannot be started for another reason
std::optional<ProgramEnd> run_program(std::vector<std::string> words, std::string_view input);

/// "NAME=value" of each variable that a program which is started may see: the folders of PATH that are told from the
/// root; language, zone, folder of temporary files; where libraries are; what sanitizers and coverage of a build of
/// swayaw are told; where a part of a work starts it (`core::on_a_part`), that it is one, too. All else stays here:
/// tokens, keys, passwords.
std::vector<std::string> child_variables();

/// Keeps this thread to one core if the program was started by a part of a work, whose other parts keep the others
/// busy.
void take_part();

}  // namespace swayaw::app
