#include "child_process.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "swayaw/core/refusal.hpp"

namespace swayaw::app {
namespace {

[[noreturn]] void refuse(std::string_view what, int reason) {
  throw Refusal(fmt::format("{} ({})", what, std::strerror(reason)));
}

/// A temporary file without a name, which its end removes.
class Sheet {
 public:
  Sheet() : file_(std::tmpfile(), &std::fclose) {
    if (!file_) refuse("no temporary file can be made", errno);
  }

  int descriptor() const { return ::fileno(file_.get()); }

  void write(std::string_view text) {
    const bool written =
        std::fwrite(text.data(), 1, text.size(), file_.get()) == text.size() && std::fflush(file_.get()) == 0;
    if (!written) refuse("a temporary file cannot be written", errno);
    std::rewind(file_.get());
  }

  std::string read() {
    std::rewind(file_.get());
    std::string text;
    char part[4096];
    while (const auto count = std::fread(part, 1, sizeof part, file_.get())) text.append(part, count);
    if (std::ferror(file_.get())) refuse("a temporary file cannot be read", errno);
    return text;
  }

 private:
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

/// What becomes of the three standard files of the program.
class Redirections {
 public:
  Redirections(const Sheet& in, const Sheet& out, const Sheet& err) {
    ::posix_spawn_file_actions_init(&actions_);
    ::posix_spawn_file_actions_adddup2(&actions_, in.descriptor(), STDIN_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions_, out.descriptor(), STDOUT_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions_, err.descriptor(), STDERR_FILENO);
  }
  ~Redirections() { ::posix_spawn_file_actions_destroy(&actions_); }
  Redirections(const Redirections&) = delete;
  Redirections& operator=(const Redirections&) = delete;

  const ::posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  ::posix_spawn_file_actions_t actions_;
};

/// @return nothing when there is no such program
std::optional<::pid_t> start(std::vector<std::string>& words, const Redirections& files) {
  std::vector<char*> pointers;
  for (auto& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  ::pid_t child = 0;
  const int reason = ::posix_spawnp(&child, pointers[0], files.get(), nullptr, pointers.data(), environ);
  if (reason == ENOENT) return std::nullopt;
  if (reason != 0) refuse(fmt::format("{} cannot be started", words[0]), reason);
  return child;
}

int exit_code(::pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) refuse("the end of a program was not seen", errno);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

std::optional<ProgramEnd> run_program(std::vector<std::string> words, std::string_view input) {
  Sheet in, out, err;
  in.write(input);
  const auto child = start(words, Redirections(in, out, err));
  if (!child) return std::nullopt;
  const int code = exit_code(*child);
  return ProgramEnd{code, out.read(), err.read()};
}

}  // namespace swayaw::app
