#pragma once

#include <string>

/// Numbers as people read them, with as many digits as their errors allow.
namespace swayaw::app {

/// Degrees, compass directions, and on full-scale ships knots; or SI.
class UserUnits {
 public:
  /// @param L  length of the ship [m]; 0 where it is not known
  UserUnits(bool si, double L) : si_(si), L_(L) {}

  bool si() const { return si_; }

  /// A standard error of 0 is none.
  std::string speed(double m_s, double error = 0.0) const;
  std::string angle(double rad, double error = 0.0) const;

  /// An angle that was ordered: "35 deg".
  std::string ordered(double rad) const;
  std::string yaw_rate(double rad_s, double error = 0.0) const;
  std::string length(double m, double error = 0.0) const;

  /// Of a clock, positive where it falls behind: "0.42 ± 0.08 % slow".
  std::string clock_rate(double rate, double error = 0.0) const;
  std::string time(double s, double error = 0.0) const;

  /// "105 ± 4 deg (ESE)"
  std::string direction(double rad, double error = 0.0) const;

  /// A parameter by the unit in which ship files and JSON have it: "m/s", "rad", "rad/s", "m", "s", "N", "".
  std::string in_unit(const std::string& unit, double value, double error = 0.0) const;

 private:
  bool si_;
  double L_;
};

/// "12.3", or "12.3 ± 0.4": to the second digit of the standard error; three digits where there is none.
std::string with_error(double value, double error = 0.0);

/// "28 %", two digits below one per cent.
std::string percent_of(double share);

}  // namespace swayaw::app
