#include "progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <utility>

#include "swayaw/core/detail/printable.hpp"

namespace swayaw::app {
namespace {

using namespace std::chrono_literals;

std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler sets it");

extern "C" void note_interrupt(int) { interrupted = true; }

constexpr std::string_view wipe = "\r\x1b[K";

/// Nobody asks how long it will be before that [s].
constexpr double worth_waiting_for = 10.0;

/// "20 s", "3 min", "2 h".
std::string duration_text(double seconds) {
  if (seconds < 90.0) return fmt::format("{:.0f} s", seconds);
  return seconds < 5400.0 ? fmt::format("{:.0f} min", seconds / 60.0) : fmt::format("{:.1f} h", seconds / 3600.0);
}

}  // namespace

Progress::Progress(std::string work)
    : work_(std::move(work)), terminal_(::isatty(STDERR_FILENO) == 1), began_(Clock::now()), next_(began_ + 1s) {}

Progress::~Progress() {
  if (written_ && terminal_) fmt::print(stderr, "{}", wipe);
}

void Progress::tell(std::string_view how_far) {
  const auto now = Clock::now();
  if (now < next_) return;
  fmt::print(stderr, "{}swayaw: {}: {}{}", terminal_ ? wipe : "", work_, core::detail::printable(how_far),
             terminal_ ? "" : "\n");
  std::fflush(stderr);
  written_ = true;
  next_ = now + (terminal_ ? 100ms : 5000ms);
}

double Progress::seconds() const { return std::chrono::duration<double>(Clock::now() - began_).count(); }

void Progress::tell_rest(double least, double most) {
  if (rest_told_ || most < worth_waiting_for) return;
  rest_told_ = true;
  const auto low = duration_text(least), high = duration_text(most);
  const auto range = least <= 0.0 ? "up to " + high : low == high ? "about " + low : "about " + low + " to " + high;
  fmt::print(stderr, "{}swayaw: {}: {} to go\n", terminal_ ? wipe : "", work_, range);
  std::fflush(stderr);
}

Interrupt::Interrupt() {
  interrupted = false;
  struct sigaction action {};
  action.sa_handler = note_interrupt;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigemptyset(&action.sa_mask);
  for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &action, &before_[i]);
}

Interrupt::~Interrupt() {
  for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &before_[i], nullptr);
}

bool Interrupt::asked() const { return interrupted; }

}  // namespace swayaw::app
