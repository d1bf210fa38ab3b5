#include "units.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "swayaw/core/channel_table.hpp"
#include "swayaw/core/detail/csv_text.hpp"

namespace swayaw::inline core::detail {
namespace {

using enum Measure;
constexpr double minute = 60.0;

/// One row for each way of writing; the first of a kind is the one that columns of recordings have.
constexpr std::array units{
    Unit{"deg", angle, degree, "_deg", "deg"},
    Unit{"\xC2\xB0", angle, degree, "_deg", "deg"},
    Unit{"\xC2\xBA", angle, degree, "_deg", "deg"},
    Unit{"degree", angle, degree, "_deg", "deg"},
    Unit{"degrees", angle, degree, "_deg", "deg"},
    Unit{"degs", angle, degree, "_deg", "deg"},
    Unit{"degt", angle, degree, "_deg", "deg"},
    Unit{"grad", angle, degree, "_deg", "deg"},
    Unit{"grader", angle, degree, "_deg", "deg"},
    Unit{"graden", angle, degree, "_deg", "deg"},
    Unit{"grados", angle, degree, "_deg", "deg"},
    Unit{"do", angle, degree, "_deg", "deg"},
    Unit{"rad", angle, 1.0, "_rad", "rad"},
    Unit{"radian", angle, 1.0, "_rad", "rad"},
    Unit{"radians", angle, 1.0, "_rad", "rad"},
    Unit{"rad/s", yaw_rate, 1.0, "_rad_s", "rad/s"},
    Unit{"rad/sec", yaw_rate, 1.0, "_rad_s", "rad/s"},
    Unit{"deg/s", yaw_rate, degree, "_deg_s", "deg/s"},
    Unit{"deg/sec", yaw_rate, degree, "_deg_s", "deg/s"},
    Unit{"degrees/s", yaw_rate, degree, "_deg_s", "deg/s"},
    Unit{"degree/s", yaw_rate, degree, "_deg_s", "deg/s"},
    Unit{"\xC2\xB0/s", yaw_rate, degree, "_deg_s", "deg/s"},
    Unit{"\xC2\xB0/sec", yaw_rate, degree, "_deg_s", "deg/s"},
    Unit{"\xC2\xBA/s", yaw_rate, degree, "_deg_s", "deg/s"},
    Unit{"grad/s", yaw_rate, degree, "_deg_s", "deg/s"},
    Unit{"dps", yaw_rate, degree, "_deg_s", "deg/s"},
    Unit{"deg/min", yaw_rate, degree / minute, "_deg_min", "deg/min"},
    Unit{"degrees/min", yaw_rate, degree / minute, "_deg_min", "deg/min"},
    Unit{"degree/min", yaw_rate, degree / minute, "_deg_min", "deg/min"},
    Unit{"degrees/minute", yaw_rate, degree / minute, "_deg_min", "deg/min"},
    Unit{"deg/minute", yaw_rate, degree / minute, "_deg_min", "deg/min"},
    Unit{"\xC2\xB0/min", yaw_rate, degree / minute, "_deg_min", "deg/min"},
    Unit{"\xC2\xBA/min", yaw_rate, degree / minute, "_deg_min", "deg/min"},
    Unit{"grad/min", yaw_rate, degree / minute, "_deg_min", "deg/min"},
    Unit{"deg/m", yaw_rate, degree / minute, "_deg_min", "deg/min"},
    Unit{"m/s", speed, 1.0, "_m_s", "m/s"},
    Unit{"ms-1", speed, 1.0, "_m_s", "m/s"},
    Unit{"m/sec", speed, 1.0, "_m_s", "m/s"},
    Unit{"mps", speed, 1.0, "_m_s", "m/s"},
    Unit{"kn", speed, knot, "_kn", "kn"},
    Unit{"kt", speed, knot, "_kn", "kn"},
    Unit{"kts", speed, knot, "_kn", "kn"},
    Unit{"knot", speed, knot, "_kn", "kn"},
    Unit{"knots", speed, knot, "_kn", "kn"},
    Unit{"knoten", speed, knot, "_kn", "kn"},
    Unit{"knop", speed, knot, "_kn", "kn"},
    Unit{"knob", speed, knot, "_kn", "kn"},
    Unit{"knopen", speed, knot, "_kn", "kn"},
    Unit{"nudos", speed, knot, "_kn", "kn"},
    Unit{"sm/h", speed, knot, "_kn", "kn"},
    Unit{"nm/h", speed, knot, "_kn", "kn"},
    Unit{"km/h", speed, 1.0 / 3.6, "", "km/h"},
    Unit{"kmh", speed, 1.0 / 3.6, "", "km/h"},
    Unit{"kph", speed, 1.0 / 3.6, "", "km/h"},
    Unit{"cm/s", speed, 0.01, "", "cm/s"},
    Unit{"m", length, 1.0, "_m", "m"},
    Unit{"metre", length, 1.0, "_m", "m"},
    Unit{"metres", length, 1.0, "_m", "m"},
    Unit{"meter", length, 1.0, "_m", "m"},
    Unit{"meters", length, 1.0, "_m", "m"},
    Unit{"mm", length, 0.001, "", "mm"},
    Unit{"cm", length, 0.01, "", "cm"},
    Unit{"km", length, 1000.0, "", "km"},
    Unit{"nm", length, 1852.0, "", "nautical miles"},
    Unit{"sm", length, 1852.0, "", "nautical miles"},
    Unit{"ft", length, 0.3048, "", "ft"},
    Unit{"feet", length, 0.3048, "", "ft"},
    Unit{"rpm", frequency, 1.0 / minute, "_rpm", "rpm"},
    Unit{"1/min", frequency, 1.0 / minute, "_rpm", "rpm"},
    Unit{"min-1", frequency, 1.0 / minute, "_rpm", "rpm"},
    Unit{"min^-1", frequency, 1.0 / minute, "_rpm", "rpm"},
    Unit{"u/min", frequency, 1.0 / minute, "_rpm", "rpm"},
    Unit{"upm", frequency, 1.0 / minute, "_rpm", "rpm"},
    Unit{"o/min", frequency, 1.0 / minute, "_rpm", "rpm"},
    Unit{"omdr/min", frequency, 1.0 / minute, "_rpm", "rpm"},
    Unit{"r/min", frequency, 1.0 / minute, "_rpm", "rpm"},
    Unit{"rev/min", frequency, 1.0 / minute, "_rpm", "rpm"},
    Unit{"1/s", frequency, 1.0, "_s", "1/s"},
    Unit{"s-1", frequency, 1.0, "_s", "1/s"},
    Unit{"s^-1", frequency, 1.0, "_s", "1/s"},
    Unit{"hz", frequency, 1.0, "_s", "1/s"},
    Unit{"rps", frequency, 1.0, "_s", "1/s"},
    Unit{"rev/s", frequency, 1.0, "_s", "1/s"},
    Unit{"u/s", frequency, 1.0, "_s", "1/s"},
    Unit{"s", time, 1.0, "_s", "s"},
    Unit{"sec", time, 1.0, "_s", "s"},
    Unit{"secs", time, 1.0, "_s", "s"},
    Unit{"second", time, 1.0, "_s", "s"},
    Unit{"seconds", time, 1.0, "_s", "s"},
    Unit{"sek", time, 1.0, "_s", "s"},
    Unit{"sekunden", time, 1.0, "_s", "s"},
    Unit{"sekunder", time, 1.0, "_s", "s"},
    Unit{"seconden", time, 1.0, "_s", "s"},
    Unit{"segundos", time, 1.0, "_s", "s"},
    Unit{"ms", time, 0.001, "", "ms"},
    Unit{"msec", time, 0.001, "", "ms"},
    Unit{"millis", time, 0.001, "", "ms"},
    Unit{"us", time, 1e-6, "", "us"},
    Unit{"min", time, minute, "", "min"},
    Unit{"minutes", time, minute, "", "min"},
    Unit{"h", time, 3600.0, "", "h"},
    Unit{"hours", time, 3600.0, "", "h"},
    Unit{"d", time, 86400.0, "", "days"},
    Unit{"days", time, 86400.0, "", "days"},
    Unit{"kN", force, 1000.0, "_kN", "kN"},
    Unit{"MN", force, 1e6, "", "MN"},
    Unit{"N", force, 1.0, "_N", "N"},
    Unit{"kNm", moment, 1000.0, "_kN_m", "kN m"},
    Unit{"kN m", moment, 1000.0, "_kN_m", "kN m"},
    Unit{"kN*m", moment, 1000.0, "_kN_m", "kN m"},
    Unit{"kN.m", moment, 1000.0, "_kN_m", "kN m"},
    Unit{"Nm", moment, 1.0, "_N_m", "N m"},
    Unit{"N m", moment, 1.0, "_N_m", "N m"},
    Unit{"N*m", moment, 1.0, "_N_m", "N m"},
    Unit{"N.m", moment, 1.0, "_N_m", "N m"},
    Unit{"MNm", moment, 1e6, "", "MN m"},
    Unit{"%", none, 1.0, "", "%"},
};

std::string without(std::string text, std::string_view piece, std::string_view by) {
  for (auto at = text.find(piece); at != std::string::npos; at = text.find(piece, at + by.size()))
    text.replace(at, piece.size(), by);
  return text;
}

/// Superscripts, dots and blanks as plain characters: "min⁻¹", "m·s⁻¹", "deg / min", "° per min", "deg.".
std::string plain(std::string text) {
  for (const auto& [piece, by] : {std::pair<std::string_view, std::string_view>{"\xE2\x81\xBB\xC2\xB9", "-1"},
                                  {"\xC2\xB7", "*"},
                                  {"\xE2\x8B\x85", "*"},
                                  {" per ", "/"},
                                  {" / ", "/"},
                                  {"^-1", "-1"},
                                  {"[", ""},
                                  {"]", ""},
                                  {"(", ""},
                                  {")", ""}})
    text = without(std::move(text), piece, by);
  if (text.size() > 1 && text.ends_with('.')) text.pop_back();
  for (const std::string_view reference : {" true", " True", " T", "T"})  // degrees from true north
    if (text.ends_with(reference) &&
        (text.starts_with("\xC2\xB0") || text.starts_with("deg") || text.starts_with("Deg")))
      text.resize(text.size() - reference.size());
  return std::string(trimmed(text));
}

/// "_deg_min" as in the names of recordings' columns, without the first bar.
bool is_suffix(const Unit& unit, std::string_view text) {
  return !unit.suffix.empty() && unit.suffix.substr(1) == text && unit.measure != time && unit.measure != frequency;
}

}  // namespace

std::optional<Unit> unit_named(std::string_view text) {
  const auto exact = plain(std::string(text));
  if (exact.empty()) return std::nullopt;
  const auto small = lower_case(exact);
  const auto slashed = without(without(small, "*s-1", "/s"), " s-1", "/s");
  // "Nm" and "kN" are told from "NM" and "kn" by their size
  if (const auto found = std::ranges::find(units, exact, &Unit::written); found != units.end()) return *found;
  const auto same = [&](const Unit& u) { return u.written == small || u.written == slashed || is_suffix(u, exact); };
  const auto found = std::ranges::find_if(units, same);
  return found == units.end() ? std::nullopt : std::optional(*found);
}

std::array<std::string_view, 2> usual_units(Measure measure) {
  switch (measure) {
    case angle: return {"deg", "rad"};
    case yaw_rate: return {"deg/min", "deg/s"};
    case speed: return {"kn", "m/s"};
    case frequency: return {"rpm", "1/s"};
    case force: return {"kN", "N"};
    case moment: return {"kNm", "Nm"};
    default: return {"m", "m"};
  }
}

std::optional<Unit> unit_of_column(std::string_view column) {
  const auto known = column_named(column);
  if (!known) return std::nullopt;
  const auto suffix = column.substr(short_name(known->channel).size());
  const auto measure_fits = [&](const Unit& u) { return u.suffix == suffix && u.si == known->si; };
  const auto found = std::ranges::find_if(units, measure_fits);
  return found == units.end() ? std::nullopt : std::optional(*found);
}

}  // namespace swayaw::core::detail
