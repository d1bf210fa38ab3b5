#pragma once

#include <chrono>
#include <csignal>
#include <string>
#include <string_view>

/// What a command that takes its time tells on stderr, and how Ctrl-C ends it early.
namespace swayaw::app {

/// One line on stderr about how far the work is. Nothing in the first second; then on a terminal a line that is written
/// over and wiped at the end, elsewhere a new line every five seconds.
class Progress {
 public:
  explicit Progress(std::string work);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void tell(std::string_view how_far);

 private:
  using Clock = std::chrono::steady_clock;

  std::string work_;
  bool terminal_;
  bool written_ = false;
  Clock::time_point next_;  ///< when the line is written next
};

/// While it lives, the first Ctrl-C asks the work to end with what it has; a second one ends the program at once.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  /// Whether Ctrl-C was pressed.
  bool asked() const;

 private:
  struct sigaction before_;
};

}  // namespace swayaw::app
