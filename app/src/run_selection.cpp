#include "run_selection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "swayaw/core/refusal.hpp"
#include "terminal.hpp"
#include "way_ahead.hpp"

namespace swayaw::app {
namespace {

/// What tells the speed of a ship, docs/formats.md.
bool tells_speed(const Recording& run) {
  constexpr std::array channels{Channel::u, Channel::u_ground, Channel::speed_through_water, Channel::speed_over_ground,
                                Channel::x};
  return std::ranges::any_of(channels, [&](Channel c) { return run.has(c); });
}

/// The service speed as the first reading of the log: how a manoeuvre begins, and nothing of how it goes on.
void begin_at_service_speed(const Ship& ship, Recording& run) {
  run.fill(Channel::speed_through_water)[0] = service_speed(ship);
  say_aside(
      "swayaw: {}: no channel tells her speed; the service speed of {:.4g} m/s is taken at the start. A column "
      "stw_kn, sog_kn or a position tells it\n",
      run.name, service_speed(ship));
}

}  // namespace

void set_aside(std::vector<SetAside>& aside, const std::string& run, const std::string& why) {
  say_aside("swayaw: {}: set aside: {}\n", run, why);
  aside.push_back({run, why});
}

std::vector<Recording> sailable(const Ship& ship, std::vector<Recording> runs, std::vector<SetAside>& aside) {
  std::vector<Recording> result;
  for (auto& run : runs) {
    if (!tells_speed(run) && run.samples() > 0) begin_at_service_speed(ship, run);
    if (run.samples() > 0) run = with_way_ahead(ship, std::move(run));
    const auto why = why_not(ship, run);
    if (why.empty()) {
      result.push_back(std::move(run));
      continue;
    }
    set_aside(aside, run.name, "the ship cannot sail it: " + why);
  }
  return result;
}

void require_some(const std::vector<Recording>& runs, const std::vector<SetAside>& aside) {
  if (!runs.empty()) return;
  std::vector<std::string> reasons;
  for (const auto& [run, why] : aside) reasons.push_back(run + ": " + why);
  throw Refusal(fmt::format("no run is left to work on: {}", fmt::join(reasons, "; ")));
}

void tell_trouble(std::vector<std::string>& troubles, const std::string& what, const std::string& why) {
  troubles.push_back(fmt::format("{} could not be told: {}", what, why));
  say_aside("swayaw: {}\n", troubles.back());
}

}  // namespace swayaw::app
