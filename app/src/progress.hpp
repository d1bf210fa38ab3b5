#pragma once

#include <array>
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

  /// Seconds since the work began.
  double seconds() const;

  /// Says once on stderr how long the rest will take, "about 20 s to 2 min to go", or "up to 2 min to go"
  /// where the least is 0; nothing where that is short.
  void tell_rest(double least_seconds, double most_seconds);

 private:
  using Clock = std::chrono::steady_clock;

  std::string work_;
  bool terminal_;
  bool written_ = false;
  bool rest_told_ = false;
  Clock::time_point began_;
  Clock::time_point next_;  ///< when the line is written next
};

/// While it lives, the first Ctrl-C, or SIGTERM, asks the work to end with what it has; a second one ends the program
/// at once.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  /// Whether the work is to end.
  bool asked() const;

 private:
  static constexpr std::array<int, 2> signals{SIGINT, SIGTERM};

  std::array<struct sigaction, signals.size()> before_;
};

}  // namespace swayaw::app
