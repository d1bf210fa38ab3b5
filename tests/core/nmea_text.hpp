#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

/// Logs of sentences, as tests write them.
namespace swayaw::test {

/// $body*hh
inline std::string sentence(const std::string& body) {
  unsigned sum = 0;
  for (const char c : body) sum ^= static_cast<unsigned char>(c);
  return fmt::format("${}*{:02X}", body, sum);
}

/// hhmmss.ss
inline std::string hhmmss(double seconds) {
  const auto hundredths = std::llround(100.0 * seconds) % 8640000;
  return fmt::format("{:02}{:02}{:02}.{:02}", hundredths / 360000, hundredths / 6000 % 60, hundredths / 100 % 60,
                     hundredths % 100);
}

/// 5403.12345,N
inline std::string angle(double degrees, int digits, const char* sides) {
  const double whole = std::floor(std::abs(degrees));
  const double minutes = (std::abs(degrees) - whole) * 60.0;
  return fmt::format("{:0{}.0f}{:08.5f},{}", whole, digits, minutes, degrees < 0.0 ? sides[1] : sides[0]);
}

/// What a log tells, known at every time: a ship that swings about a course across the equator's other side.
struct Voyage {
  double heading(double t) const { return std::fmod(350.0 + 25.0 * std::sin(0.02 * t) + 360.0, 360.0); }  // [deg]
  double yaw_rate(double t) const { return 60.0 * 25.0 * 0.02 * std::cos(0.02 * t); }                     // [deg/min]
  double rudder(double t) const { return 12.0 * std::sin(0.05 * t); }            // [deg], starboard
  double rudder_port(double t) const { return rudder(t) + 0.8; }                 // [deg]
  double speed(double t) const { return 14.0 + 0.5 * std::sin(0.01 * t); }       // [kn]
  double drift(double t) const { return 0.7 * std::sin(0.02 * t); }              // [kn]
  double course(double t) const { return std::fmod(heading(t) + 4.0, 360.0); }   // [deg]
  double rev(double t) const { return 95.0 + 2.0 * std::sin(0.03 * t); }         // [rpm]
  double latitude(double t) const { return -33.9 + 1e-6 * t; }                   // [deg]
  double longitude(double t) const { return -18.4 + 2e-6 * t; }                  // [deg]
  double wind_speed(double t) const { return 18.0 + std::sin(0.04 * t); }        // [kn]
  double wind_from(double t) const { return 240.0 + 5.0 * std::sin(0.01 * t); }  // [deg]
  double depth(double t) const { return 42.0 + 0.01 * t; }                       // [m]
};

}  // namespace swayaw::test
