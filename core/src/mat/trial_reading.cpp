#include "trial_reading.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <new>
#include <system_error>

#include "swayaw/core/refusal.hpp"

namespace swayaw::inline core::detail {
namespace {

constexpr int harmless = 0, too_large = 99;

/// Bytes of address space that this process has now.
std::size_t address_space() {
  unsigned long long pages = 0;
  if (auto* file = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(file, "%llu", &pages) != 1) pages = 0;
    std::fclose(file);
  }
  return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

void limit(__rlimit_resource what, std::size_t most) {
  const rlimit to{most, most};
  ::setrlimit(what, &to);
}

/// Crashes, time and words of the copy stay its own.
void stand_alone(double seconds, std::size_t memory) {
  for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL, SIGPROF, SIGTERM, SIGINT})
    std::signal(signal, SIG_DFL);
  if (const int nowhere = ::open("/dev/null", O_RDWR | O_CLOEXEC); nowhere >= 0)
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) ::dup2(nowhere, stream);
  limit(RLIMIT_CORE, 0);
  if (const auto now = address_space(); now > 0) limit(RLIMIT_AS, now + memory);
  const auto whole = static_cast<time_t>(std::floor(seconds));
  const itimerval time{{0, 0}, {whole, static_cast<suseconds_t>(1e6 * (seconds - std::floor(seconds)))}};
  ::setitimer(ITIMER_PROF, &time, nullptr);
}

/// In the copy. A library that goes on without the memory that it asked for leaves the reason behind.
[[noreturn]] void try_reading(const std::function<void()>& read) {
  errno = 0;
  try {
    read();
  } catch (const std::bad_alloc&) {
    ::_exit(too_large);
  } catch (...) {}
  ::_exit(errno == ENOMEM ? too_large : harmless);
}

int ended(pid_t copy) {
  int status = 0;
  while (::waitpid(copy, &status, 0) < 0)
    if (errno != EINTR) return harmless;  // who takes the ends of all children away leaves us without an answer
  return status;
}

}  // namespace

void require_harmless(const std::filesystem::path& file, const std::function<void()>& read) {
  std::error_code unknown;
  const auto size = std::filesystem::file_size(file, unknown);
  const auto bytes = unknown ? 0 : static_cast<std::size_t>(size);
  const auto memory = trial_memory + trial_memory_per_byte * bytes;
  const double seconds = trial_time + trial_time_per_byte * static_cast<double>(bytes);
  const pid_t copy = ::fork();
  if (copy < 0) return;  // no process to be had: as without this guard
  if (copy == 0) {
    stand_alone(seconds, memory);
    try_reading(read);
  }
  const int status = ended(copy);
  const auto refuse = [&](std::string_view what) { throw FileError({file, 1, 1}, what); };
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGPROF)
    refuse(fmt::format("is damaged: it takes more than {:.3g} s to read", seconds));
  if (WIFSIGNALED(status)) refuse("is damaged: libmatio, which reads MATLAB files, crashes on it");
  if (WIFEXITED(status) && WEXITSTATUS(status) == too_large)
    refuse(fmt::format("is damaged: its {} bytes ask for more than {:.3g} MB of memory", bytes,
                       1e-6 * static_cast<double>(memory)));
}

}  // namespace swayaw::core::detail
