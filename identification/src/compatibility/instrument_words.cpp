#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/channel_table.hpp"
#include "swayaw/identification/data_compatibility.hpp"

namespace swayaw::inline identification {
namespace {

using Kind = InstrumentErrorKind;

using core::detail::knot;

/// A value in the unit that people read.
struct Shown {
  double factor;
  std::string_view unit;
};

Shown shown(const InstrumentError& e) {
  const auto unit = unit_of(e);
  if (unit == "rad") return {degrees(1.0), "deg"};
  if (unit == "rad/s") return {degrees(1.0), "deg/s"};
  if (e.kind == Kind::scale || e.kind == Kind::clock_rate) return {100.0, "%"};
  return {1.0, unit};
}

std::string_view law(const InstrumentError& e) {
  switch (e.kind) {
    case Kind::zero: return "shows, at rest,";
    case Kind::scale: return e.value > 0.0 ? "too large by" : "too small by";
    case Kind::delay: return e.value > 0.0 ? "late by" : "early by";
    case Kind::clock: return "their clock wanders, in a minute by";
    case Kind::clock_rate: return e.value > 0.0 ? "their clock runs slow by" : "their clock runs fast by";
    case Kind::smoothing: return "smoothed over a window of standard deviation";
    case Kind::lever_arm_x: return e.value > 0.0 ? "of a point forward of midship by" : "of a point aft of midship by";
    case Kind::lever_arm_y: return e.value > 0.0 ? "of a point to starboard by" : "of a point to port by";
    case Kind::axes:
      if (e.channel == Channel::psi) return e.value > 0.0 ? "less than the track's by" : "more than the track's by";
      return e.value > 0.0 ? "axes turned to starboard of the heading by" : "axes turned to port of the heading by";
    default: return "";
  }
}

/// What a delay may be besides: "; it is a first-order lag", "; or velocities over ground late …".
std::string readings_in_words(const InstrumentError& e) {
  if (e.kind != Kind::delay || e.readings.empty()) return "";
  if (e.channel == Channel::r && e.readings.size() == 1) return fmt::format("; it is a {}", e.readings[0]);
  if (e.channel == Channel::r) return fmt::format("; a {}, the run does not tell which", fmt::join(e.readings, " or "));
  if (e.readings.size() == 1) return "";
  const std::vector others(e.readings.begin() + 1, e.readings.end());
  return fmt::format("; or {} by as much: kinematics cannot tell", fmt::join(others, ", or "));
}

bool has_side(Kind kind) { return kind != Kind::zero && kind != Kind::smoothing; }

/// What a column really holds: the unit that its values are in.
std::string unit_meant(const InstrumentError& e) {
  const auto near = [&](double factor) { return std::abs(std::log(e.value / factor)) < 0.1; };
  if (dimension_of(e.channel) == Dimension::speed)
    return near(1.0 / knot) ? "kn" : near(3.6) ? "km/h" : near(knot) ? "m/s, not kn" : "km/h called kn";
  if (e.channel != Channel::r) return e.value > 1.0 ? "deg" : "rad";
  if (near(degrees(1.0))) return "deg/s";
  if (near(60.0 * degrees(1.0))) return "deg/min";
  if (near(60.0)) return "deg/min, not deg/s";
  return near(1.0 / 60.0) ? "deg/s, not deg/min" : "rad/s";
}

}  // namespace

std::string_view name_of(InstrumentErrorKind kind) {
  switch (kind) {
    case Kind::unit: return "unit";
    case Kind::sign: return "sign";
    case Kind::order: return "order";
    case Kind::zero: return "zero";
    case Kind::scale: return "scale";
    case Kind::delay: return "delay";
    case Kind::clock: return "clock";
    case Kind::clock_rate: return "clock_rate";
    case Kind::jump: return "jump";
    case Kind::smoothing: return "smoothing";
    case Kind::axes: return "axes";
    case Kind::lever_arm_x: return "lever_arm_x";
    case Kind::lever_arm_y: return "lever_arm_y";
  }
  return "";
}

std::string_view unit_of(const InstrumentError& e) {
  switch (e.kind) {
    case Kind::zero: return e.channel == Channel::r ? "rad/s" : "rad";
    case Kind::order: return "rad/s";
    case Kind::axes: return "rad";
    case Kind::delay:
    case Kind::clock:
    case Kind::jump:
    case Kind::smoothing: return "s";
    case Kind::lever_arm_x:
    case Kind::lever_arm_y: return "m";
    default: return "";
  }
}

bool is_mistake(InstrumentErrorKind kind) { return kind == Kind::unit || kind == Kind::sign || kind == Kind::order; }

std::string words_for(const InstrumentError& e) {
  const auto what = plain_name(e.channel);
  if (e.kind == Kind::sign)
    return e.channel == Channel::delta || e.channel == Channel::delta_order
               ? fmt::format("{}: turns the ship to the other side than its sign says", what)
               : fmt::format("{}: of the other sign, positive to port", what);
  if (e.kind == Kind::unit) return fmt::format("{}: the values are in {}", what, unit_meant(e));
  if (e.kind == Kind::order)
    return fmt::format("{}: jumps at {:.0f} deg/s, which is an order and no angle", what, degrees(e.value));
  const auto [factor, unit] = shown(e);
  const double value = has_side(e.kind) ? std::abs(e.value) : e.value;
  const auto drift = e.kind == Kind::axes && e.channel != Channel::psi && dimension_of(e.channel) == Dimension::speed &&
                     (e.channel == Channel::v || e.channel == Channel::v_ground);
  if (e.kind == Kind::jump)
    return fmt::format("{}: their clock jumps at {:.6g} ± {:.2g} s, from then on {:.3g} ± {:.2g} s {} than before",
                       what, e.at, e.at_standard_error, value, e.standard_error, e.value > 0.0 ? "later" : "earlier");
  if (e.kind == Kind::clock) return fmt::format("{}: {} {:.2g} s", what, law(e), value);
  return fmt::format("{}: {} {:.3g} ± {:.2g} {}{}{}", what, law(e), factor * value, factor * e.standard_error, unit,
                     drift ? ", on straight courses" : "", e.told ? readings_in_words(e) : "");
}

std::string remedy_for(const InstrumentError& e) {
  const auto column = column_name(e.channel);
  if (e.kind == Kind::sign && (e.channel == Channel::delta || e.channel == Channel::delta_order))
    return "say which side is positive: --rudder-positive starboard (or port, if the file says starboard), or "
           "rudder_positive = \"starboard\" above its header row";
  if (e.kind == Kind::sign) return fmt::format("turn the sign of {}", column);
  if (e.kind == Kind::unit)
    return fmt::format("name the column {} by the unit that it is in, or convert it", short_name(e.channel));
  if (e.kind == Kind::order)
    return "name the column delta_order_deg or delta_order_rad, or write order_recorded = true";
  return "";
}

}  // namespace swayaw::identification
