#include <algorithm>
#include <cmath>

#include "channel_character.hpp"
#include "mistakes.hpp"
#include "run_motion.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/identification/data_compatibility.hpp"

namespace swayaw::inline identification {
using namespace detail;
namespace {

using Kind = InstrumentErrorKind;

/// Channels that the instrument of a channel has, too.
std::vector<Channel> of_the_same_instrument(Channel channel) {
  switch (channel) {
    case Channel::x: return {Channel::x, Channel::y};
    case Channel::u: return {Channel::u, Channel::v};
    case Channel::u_ground: return {Channel::u_ground, Channel::v_ground};
    default: return {channel};
  }
}

/// c₀ of each sample from c.
template <class F>
void correct(Recording& run, Channel channel, F&& truth) {
  for (const Channel c : of_the_same_instrument(channel))
    for (double& value : run.channels[index_of(c)]) value = truth(value);
}

/// c₀(t) = c(t + delay), by straight lines; where nothing was measured nothing is made up.
void set_clock(Recording& run, Channel channel, double delay) {
  for (const Channel c : of_the_same_instrument(channel)) {
    if (!run.has(c)) continue;
    const auto moved = delayed(run.time, filled(run, c), -delay);
    auto& values = run.channels[index_of(c)];
    for (std::size_t i = 0; i < values.size(); ++i) {
      const bool inside = run.time[i] + delay >= run.time.front() && run.time[i] + delay <= run.time.back();
      values[i] = std::isnan(values[i]) || !inside ? missing : moved[i];
    }
  }
}

void set_place(Recording& run, double l_x, double l_y) {
  const auto psi = filled(run, Channel::psi);
  for (std::size_t i = 0; i < run.samples(); ++i) {
    run.channels[index_of(Channel::x)][i] -= l_x * std::cos(psi[i]) - l_y * std::sin(psi[i]);
    run.channels[index_of(Channel::y)][i] -= l_x * std::sin(psi[i]) + l_y * std::cos(psi[i]);
  }
}

/// Velocity axes turned to starboard by eps: (u, v) in the axes of the hull.
void turn_axes(Recording& run, Channel surge, double eps) {
  const auto both = of_the_same_instrument(surge);
  auto &u = run.channels[index_of(both[0])], &v = run.channels[index_of(both[1])];
  for (std::size_t i = 0; i < u.size(); ++i) {
    const double forward = u[i] * std::cos(eps) - v[i] * std::sin(eps);
    v[i] = u[i] * std::sin(eps) + v[i] * std::cos(eps);
    u[i] = forward;
  }
}

void repair(Recording& run, const InstrumentError& e) {
  const double value = e.value;
  if (e.kind == Kind::zero) correct(run, e.channel, [&](double c) { return c - value; });
  else if (e.kind == Kind::scale) correct(run, e.channel, [&](double c) { return c / (1.0 + value); });
  else if (e.kind == Kind::delay) set_clock(run, e.channel, value);
  else if (e.kind == Kind::lever_arm_x) set_place(run, value, 0.0);
  else if (e.kind == Kind::lever_arm_y) set_place(run, 0.0, value);
  else if (e.kind == Kind::axes && e.channel == Channel::psi)
    correct(run, e.channel, [&](double c) { return c + value; });
  else if (e.kind == Kind::axes && (e.channel == Channel::u || e.channel == Channel::u_ground))
    turn_axes(run, e.channel, value);
}

}  // namespace

Recording repaired(const Recording& run, const RunCheck& check) {
  auto result = run;
  for (const auto& c : check.channels)
    for (const std::size_t i : c.outliers) result.channels[index_of(c.channel)][i] = missing;
  std::vector<InstrumentError> mistakes;
  for (const auto& e : check.errors)
    if (is_mistake(e.kind)) mistakes.push_back(e);
  result = without(std::move(result), mistakes);
  for (const auto& e : check.errors)
    if (e.told && !is_mistake(e.kind)) repair(result, e);
  return result;
}

}  // namespace swayaw::identification
