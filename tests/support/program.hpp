#pragma once

#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "files.hpp"
#include "swayaw/core/atomic_file.hpp"

/// The program from the outside. SWAYAW_PROGRAM is set by CMake.
namespace swayaw::test {

struct Outcome {
  int code;
  std::string out;
  std::string err;
};

inline Outcome run(const Scratch& scratch, const std::string& arguments) {
  const auto out = scratch / "stdout", err = scratch / "stderr";
  const std::string command = std::string(SWAYAW_PROGRAM) + " " + arguments + " >" + out.string() + " 2>" + err.string() + " </dev/null";
  const int status = std::system(command.c_str());
  return {WEXITSTATUS(status), read_text(out), read_text(err)};
}

inline std::size_t lines(const std::string& text) { return static_cast<std::size_t>(std::ranges::count(text, '\n')); }

}  // namespace swayaw::test
