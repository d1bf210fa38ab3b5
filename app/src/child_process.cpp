#include "child_process.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>

#include "swayaw/core/parallel.hpp"
#include "swayaw/core/refusal.hpp"

namespace swayaw::app {
namespace {

[[noreturn]] void refuse(std::string_view what, int reason) {
  throw Refusal(fmt::format("{} ({})", what, std::strerror(reason)));
}

/// A file in memory, without a name and closed in programs that are started: it has no place where others could read
/// it.
class Sheet {
 public:
  Sheet() : file_(opened(), &std::fclose) {
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
  static std::FILE* opened() {
    const int descriptor = ::memfd_create("swayaw", MFD_CLOEXEC);
    return descriptor < 0 ? nullptr : ::fdopen(descriptor, "w+");
  }

  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

/// The three standard files of the program; all others are closed, whoever opened them.
class Redirections {
 public:
  Redirections(const Sheet& in, const Sheet& out, const Sheet& err) {
    ::posix_spawn_file_actions_init(&actions_);
    ::posix_spawn_file_actions_adddup2(&actions_, in.descriptor(), STDIN_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions_, out.descriptor(), STDOUT_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions_, err.descriptor(), STDERR_FILENO);
    ::posix_spawn_file_actions_addclosefrom_np(&actions_, STDERR_FILENO + 1);
  }
  ~Redirections() { ::posix_spawn_file_actions_destroy(&actions_); }
  Redirections(const Redirections&) = delete;
  Redirections& operator=(const Redirections&) = delete;

  const ::posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  ::posix_spawn_file_actions_t actions_;
};

// ---------------------------------------------------------------- what it is told

/// Folders of PATH, but for those that depend on the current one.
std::vector<std::string> program_folders() {
  std::vector<std::string> folders;
  const char* path = std::getenv("PATH");
  std::string_view rest = path ? path : "/usr/local/bin:/usr/bin:/bin";
  while (!rest.empty()) {
    const auto folder = rest.substr(0, rest.find(':'));
    if (folder.starts_with('/')) folders.emplace_back(folder);
    rest.remove_prefix(std::min(folder.size() + 1, rest.size()));
  }
  return folders;
}

bool is_program(const std::string& file) {
  return std::filesystem::is_regular_file(file) && ::access(file.c_str(), X_OK) == 0;
}

/// Where a program is; empty: nowhere.
std::string place_of(const std::string& name) {
  if (name.find('/') != std::string::npos) return name;
  for (const auto& folder : program_folders())
    if (auto file = folder + '/' + name; is_program(file)) return file;
  return {};
}

/// Language, decimal point, zone; where libraries are that do not stand in the usual folders; where SQLite may put what
/// does not fit into memory.
constexpr std::array<std::string_view, 5> needed_variables{"LANG", "LANGUAGE", "LD_LIBRARY_PATH", "TMPDIR", "TZ"};

/// Of a build with sanitizers or coverage: a child is swayaw, too, in a sweep over recordings.
constexpr std::array<std::string_view, 7> build_variables{"ASAN_OPTIONS",     "LSAN_OPTIONS", "UBSAN_OPTIONS",
                                                          "TSAN_OPTIONS",     "GCOV_PREFIX",  "GCOV_PREFIX_STRIP",
                                                          "LLVM_PROFILE_FILE"};

/// A program that a part of a work starts is a part, too: it keeps to one core, as the others are busy.
constexpr const char* variable_of_a_part = "SWAYAW_ON_A_PART";

bool is_needed(std::string_view name) {
  return name.starts_with("LC_") || std::ranges::count(needed_variables, name) > 0 ||
         std::ranges::count(build_variables, name) > 0;
}

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (auto& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// @return nothing when there is no such program
std::optional<::pid_t> start(std::vector<std::string>& words, const Redirections& files) {
  const auto program = place_of(words[0]);
  if (program.empty()) return std::nullopt;
  auto variables = child_variables();
  ::pid_t child = 0;
  const int reason = ::posix_spawn(&child, program.c_str(), files.get(), nullptr, pointers_to(words).data(),
                                   pointers_to(variables).data());
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

std::vector<std::string> child_variables() {
  std::vector<std::string> variables{fmt::format("PATH={}", fmt::join(program_folders(), ":"))};
  for (char** variable = environ; *variable != nullptr; ++variable)
    if (const std::string_view text = *variable; is_needed(text.substr(0, text.find('='))))
      variables.emplace_back(text);
  if (core::on_a_part) variables.push_back(fmt::format("{}=1", variable_of_a_part));
  return variables;
}

void take_part() { core::on_a_part = std::getenv(variable_of_a_part) != nullptr; }

std::optional<ProgramEnd> run_program(std::vector<std::string> words, std::string_view input) {
  Sheet in, out, err;
  in.write(input);
  const auto child = start(words, Redirections(in, out, err));
  if (!child) return std::nullopt;
  const int code = exit_code(*child);
  return ProgramEnd{code, out.read(), err.read()};
}

}  // namespace swayaw::app
