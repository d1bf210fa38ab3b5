#pragma once

#include <sys/wait.h>

#include <algorithm>
#include <catch.hpp>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "files.hpp"
#include "json.hpp"
#include "swayaw/core/atomic_file.hpp"

/// The program from the outside. SWAYAW_PROGRAM is set by CMake.
namespace swayaw::test {

struct Outcome {
  int code;
  std::string out;
  std::string err;
};

/// @param environment  "NAME=value " before the command
inline Outcome run(const Scratch& scratch, const std::string& arguments, const std::string& environment = "") {
  const auto out = scratch / "stdout", err = scratch / "stderr";
  const std::string command =
      environment + SWAYAW_PROGRAM + " " + arguments + " >" + out.string() + " 2>" + err.string() + " </dev/null";
  const int status = std::system(command.c_str());
  return {WEXITSTATUS(status), read_text(out), read_text(err)};
}

inline std::size_t lines(const std::string& text) { return static_cast<std::size_t>(std::ranges::count(text, '\n')); }

/// A ship of the project, as a command is told it.
inline std::string ship_file(const std::string& name) { return (ships / name).string(); }

/// The JSON of a command that must succeed.
inline nlohmann::json document(const std::string& arguments) {
  const Scratch scratch;
  const auto outcome = run(scratch, arguments + " --json");
  INFO(arguments << "\n" << outcome.err);
  REQUIRE(outcome.code == 0);
  return json_of(outcome.out);
}

/// The line that a command says that must fail.
inline std::string refusal(const std::string& arguments, int code = 1, const std::string& environment = "") {
  const Scratch scratch;
  const auto outcome = run(scratch, arguments, environment);
  INFO(arguments);
  CHECK(outcome.code == code);
  CHECK(outcome.out.empty());
  CHECK(lines(outcome.err) == 1);
  return outcome.err;
}

}  // namespace swayaw::test
