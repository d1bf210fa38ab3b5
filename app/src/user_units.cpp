#include "user_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/model_scale.hpp"

namespace swayaw::app {
namespace {

constexpr double knot = 1852.0 / 3600.0;  // m/s

std::string told(double value, double error, double one, const char* unit) {
  return fmt::format("{} {}", with_error(value / one, error / one), unit);
}

}  // namespace

std::string with_error(double value, double error) {
  if (!std::isfinite(value)) return "-";
  if (!(error > 0.0) || !std::isfinite(error)) {
    const int decimals =
        value == 0.0 ? 0 : std::clamp(2 - static_cast<int>(std::floor(std::log10(std::abs(value)))), 0, 8);
    return fmt::format("{:.{}f}", value + 0.0, decimals);
  }
  const int decimals = std::clamp(1 - static_cast<int>(std::floor(std::log10(error))), 0, 8);
  return fmt::format("{:.{}f} ± {:.{}f}", value + 0.0, decimals, error, decimals);
}

std::string percent_of(double share) {
  if (!std::isfinite(share)) return "-";
  return fmt::format("{:.{}f}\u00a0%", 100.0 * share, std::abs(share) < 0.0095 ? 2 : std::abs(share) < 0.095 ? 1 : 0);
}

std::string UserUnits::speed(double m_s, double error) const {
  return si_ || L_ < longest_model ? told(m_s, error, 1.0, "m/s") : told(m_s, error, knot, "kn");
}

std::string UserUnits::angle(double rad, double error) const {
  return si_ ? told(rad, error, 1.0, "rad") : told(rad, error, radians(1.0), "deg");
}

std::string UserUnits::ordered(double rad) const { return si_ ? angle(rad) : fmt::format("{:.6g} deg", degrees(rad)); }

std::string UserUnits::yaw_rate(double rad_s, double error) const {
  return si_ ? told(rad_s, error, 1.0, "rad/s") : told(rad_s, error, radians(1.0), "deg/s");
}

std::string UserUnits::length(double m, double error) const {
  const auto metres = told(m, error, 1.0, "m");
  return si_ || !(L_ > 0.0) ? metres : fmt::format("{} ({:.2f} L)", metres, m / L_);
}

std::string UserUnits::clock_rate(double rate, double error) const {
  return si_ ? told(rate, error, 1.0, "s/s") : told(std::abs(rate), error, 0.01, rate < 0.0 ? "% fast" : "% slow");
}

std::string UserUnits::time(double s, double error) const { return told(s, error, 1.0, "s"); }

std::string UserUnits::direction(double rad, double error) const {
  if (si_) return angle(rad, error);
  constexpr std::array points{"N", "NNE", "NE", "ENE", "E", "ESE", "SE", "SSE",
                              "S", "SSW", "SW", "WSW", "W", "WNW", "NW", "NNW"};
  const double turned = degrees(wrapped(rad)), bearing = turned < 0.0 ? turned + 360.0 : turned;
  const auto point = static_cast<std::size_t>(std::lround(bearing / 22.5)) % points.size();
  const auto uncertain = error > 0.0 ? fmt::format(" ± {:.0f}", std::max(degrees(error), 1.0)) : "";
  return fmt::format("{:03.0f}{} deg ({})", bearing, uncertain, points[point]);
}

std::string UserUnits::in_unit(const std::string& unit, double value, double error) const {
  if (unit == "m/s") return speed(value, error);
  if (unit == "rad") return angle(value, error);
  if (unit == "rad/s") return yaw_rate(value, error);
  if (unit == "m") return length(value, error);
  if (unit == "N" && std::abs(value) >= 2e3 && !si_) return told(value, error, 1e3, "kN");
  return unit.empty() ? with_error(value, error) : told(value, error, 1.0, unit.c_str());
}

}  // namespace swayaw::app
