#include "swayaw/nonlinear/models/validity.hpp"

#include <fmt/format.h>

#include <cmath>

#include "swayaw/core/refusal.hpp"

namespace swayaw::inline nonlinear {
namespace {

bool finite(const PlanarMotion<double>& m, const Controls<double>& c) {
  const double propulsion = c.by_thrust ? c.thrust.port + c.thrust.starboard : c.rev;
  return std::isfinite(m.u + m.v + m.r + c.delta + propulsion);
}

}  // namespace

std::string_view words_for(Validity validity) {
  switch (validity) {
    case Validity::valid: return "";
    case Validity::not_a_number: return "motion and controls must be finite numbers";
    case Validity::no_way_ahead: return "forces are known for way ahead";
    case Validity::turns_on_the_spot: return "forces are not known for a ship that turns on the spot";
    case Validity::shaft_astern: return "the thrust is known for a shaft that turns ahead";
  }
  return "";
}

Validity validity_of(const PlanarMotion<double>& m, const Controls<double>& c, double L) {
  if (!finite(m, c)) return Validity::not_a_number;
  if (m.u <= 0.0) return Validity::no_way_ahead;
  if (std::abs(m.r) * L > largest_yaw_rate * speed(m)) return Validity::turns_on_the_spot;
  if (!c.by_thrust && c.rev < 0.0) return Validity::shaft_astern;
  return Validity::valid;
}

void require_valid(const PlanarMotion<double>& m, const Controls<double>& c, double L) {
  const auto validity = validity_of(m, c, L);
  const auto words = words_for(validity);
  switch (validity) {
    case Validity::valid: return;
    case Validity::not_a_number: throw Refusal(std::string(words));
    case Validity::no_way_ahead: throw Refusal(fmt::format("{}, not for u = {:.6g} m/s", words, m.u));
    case Validity::turns_on_the_spot: throw Refusal(fmt::format("{}: rL/U = {:.6g}", words, m.r * L / speed(m)));
    case Validity::shaft_astern: throw Refusal(fmt::format("{}, not at {:.6g} 1/s", words, c.rev));
  }
}

void require_valid(const Ship& ship, const PlanarMotion<double>& motion, const Controls<double>& controls) {
  require_valid(motion, controls, length(ship));
}

}  // namespace swayaw::nonlinear
