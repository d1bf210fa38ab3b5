#pragma once

#include <exception>
#include <string>
#include <vector>

#include "swayaw/core/recording.hpp"
#include "swayaw/nonlinear/ship.hpp"

/// Which recordings a long work takes up. What it could not use is better known before than after minutes.
namespace swayaw::app {

/// A run that was set aside, and why.
struct SetAside {
  std::string run;
  std::string why;
};

/// Notes that a run is set aside, and says so on stderr.
void set_aside(std::vector<SetAside>& aside, const std::string& run, const std::string& why);

/// The parts of the runs that the ship can sail (way_ahead.hpp); runs whose first two ship lengths she cannot sail go
/// to `aside`, and to stderr by name.
///
/// Where no channel tells the speed of a run, its first sample gets the ship's service speed as that of the log; stderr
/// says so.
std::vector<Recording> sailable(const Ship& ship, std::vector<Recording> runs, std::vector<SetAside>& aside);

/// @throws Refusal  naming every run that was set aside, if none is left
void require_some(const std::vector<Recording>& runs, const std::vector<SetAside>& aside);

/// Notes a trouble in words and on stderr.
void tell_trouble(std::vector<std::string>& troubles, const std::string& what, const std::string& why);

/// Does a step late in a long work; where it fails, that is noted in words and on stderr, and the rest is kept.
template <class Step>
void attempt(std::vector<std::string>& troubles, const std::string& what, const Step& step) {
  try {
    step();
  } catch (const std::exception& trouble) {
    tell_trouble(troubles, what, trouble.what());
  }
}

}  // namespace swayaw::app
