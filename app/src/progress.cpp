#include "progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <utility>

namespace swayaw::app {
namespace {

using namespace std::chrono_literals;

std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler sets it");

extern "C" void note_interrupt(int) { interrupted = true; }

constexpr std::string_view wipe = "\r\x1b[K";

}  // namespace

Progress::Progress(std::string work)
    : work_(std::move(work)), terminal_(::isatty(STDERR_FILENO) == 1), next_(Clock::now() + 1s) {}

Progress::~Progress() {
  if (written_ && terminal_) fmt::print(stderr, "{}", wipe);
}

void Progress::tell(std::string_view how_far) {
  const auto now = Clock::now();
  if (now < next_) return;
  fmt::print(stderr, "{}swayaw: {}: {}{}", terminal_ ? wipe : "", work_, how_far, terminal_ ? "" : "\n");
  std::fflush(stderr);
  written_ = true;
  next_ = now + (terminal_ ? 100ms : 5000ms);
}

Interrupt::Interrupt() {
  interrupted = false;
  struct sigaction action {};
  action.sa_handler = note_interrupt;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, &before_);
}

Interrupt::~Interrupt() { sigaction(SIGINT, &before_, nullptr); }

bool Interrupt::asked() const { return interrupted; }

}  // namespace swayaw::app
