#include "swayaw/nonlinear/surroundings/windage_sources.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "swayaw/core/refusal.hpp"

namespace swayaw::inline nonlinear {
namespace {

/// Two angles closer than this are one [rad].
constexpr double same_angle = 1e-9;

/// The same direction in [−pi, pi).
double first_turn(double angle) {
  const double result = wrapped(angle);
  return result > pi - same_angle ? -pi : result;
}

bool same_direction(const WindRow& a, const WindRow& b) { return b.angle - a.angle < same_angle; }

/// Rows of one direction become one row.
///
/// @throws std::domain_error  if they differ
void merge_equal(WindTable& table) {
  for (std::size_t i = 1; i < table.size(); ++i) {
    const auto &a = table[i - 1], &b = table[i];
    if (same_direction(a, b) && (a.C_X != b.C_X || a.C_Y != b.C_Y || a.C_N != b.C_N))
      throw std::domain_error(fmt::format("wind table has two different rows at {:.6g} deg", degrees(a.angle)));
  }
  const auto rest = std::unique(table.begin(), table.end(), same_direction);
  table.erase(rest, table.end());
}

double require_known(double area, std::string_view quantity) {
  if (area >= 0.0) return area;
  throw std::domain_error(fmt::format("{} must not be negative, got {}", quantity, area));
}

/// Regression coefficients at one angle.
struct IsherwoodRow {
  std::array<double, 7> A, B;
  std::array<double, 6> C;
};

/// 0, 10, …, 180 deg. Source: [Isherwood1973] as tabled in [MSS] isherwood72.m
constexpr std::array<IsherwoodRow, 19> isherwood_rows{{
    {{2.152, -5.00, 0.243, -0.164, 0, 0, 0}, {0, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0}},
    {{1.714, -3.33, 0.145, -0.121, 0, 0, 0}, {0.096, 0.22, 0, 0, 0, 0, 0}, {0.0596, 0.061, 0, 0, 0, -0.074}},
    {{1.818, -3.97, 0.211, -0.143, 0, 0, 0.033}, {0.176, 0.71, 0, 0, 0, 0, 0}, {0.1106, 0.204, 0, 0, 0, -0.170}},
    {{1.965, -4.81, 0.243, -0.154, 0, 0, 0.041},
     {0.225, 1.38, 0, 0.023, 0, -0.29, 0},
     {0.2258, 0.245, 0, 0, 0, -0.380}},
    {{2.333, -5.99, 0.247, -0.190, 0, 0, 0.042},
     {0.329, 1.82, 0, 0.043, 0, -0.59, 0},
     {0.2017, 0.457, 0, 0.0067, 0, -0.472}},
    {{1.726, -6.54, 0.189, -0.173, 0.348, 0, 0.048},
     {1.164, 1.26, 0.121, 0, -0.242, -0.95, 0},
     {0.1759, 0.573, 0, 0.0118, 0, -0.523}},
    {{0.913, -4.68, 0, -0.104, 0.482, 0, 0.052},
     {1.163, 0.96, 0.101, 0, -0.177, -0.88, 0},
     {0.1925, 0.480, 0, 0.0115, 0, -0.546}},
    {{0.457, -2.88, 0, -0.068, 0.346, 0, 0.043},
     {0.916, 0.53, 0.069, 0, 0, -0.65, 0},
     {0.2133, 0.315, 0, 0.0081, 0, -0.526}},
    {{0.341, -0.91, 0, -0.031, 0, 0, 0.032},
     {0.844, 0.55, 0.082, 0, 0, -0.54, 0},
     {0.1827, 0.254, 0, 0.0053, 0, -0.443}},
    {{0.355, 0, 0, 0, -0.247, 0, 0.018}, {0.889, 0, 0.138, 0, 0, -0.66, 0}, {0.2627, 0, 0, 0, 0, -0.508}},
    {{0.601, 0, 0, 0, -0.372, 0, -0.020}, {0.799, 0, 0.155, 0, 0, -0.55, 0}, {0.2102, 0, -0.0195, 0, 0.0335, -0.492}},
    {{0.651, 1.29, 0, 0, -0.582, 0, -0.031},
     {0.797, 0, 0.151, 0, 0, -0.55, 0},
     {0.1567, 0, -0.0258, 0, 0.0497, -0.457}},
    {{0.564, 2.54, 0, 0, -0.748, 0, -0.024},
     {0.996, 0, 0.184, 0, -0.212, -0.66, 0.34},
     {0.0801, 0, -0.0311, 0, 0.0740, -0.396}},
    {{-0.142, 3.58, 0, 0.047, -0.700, 0, -0.028},
     {1.014, 0, 0.191, 0, -0.280, -0.69, 0.44},
     {-0.0189, 0, -0.0488, 0.0101, 0.1128, -0.420}},
    {{-0.677, 3.64, 0, 0.069, -0.529, 0, -0.032},
     {0.784, 0, 0.166, 0, -0.209, -0.53, 0.38},
     {0.0256, 0, -0.0422, 0.0100, 0.0889, -0.463}},
    {{-0.723, 3.14, 0, 0.064, -0.475, 0, -0.032},
     {0.536, 0, 0.176, -0.029, -0.163, 0, 0.27},
     {0.0552, 0, -0.0381, 0.0109, 0.0689, -0.476}},
    {{-2.148, 2.56, 0, 0.081, 0, 1.27, -0.027},
     {0.251, 0, 0.106, -0.022, 0, 0, 0},
     {0.0881, 0, -0.0306, 0.0091, 0.0366, -0.415}},
    {{-2.707, 3.97, -0.175, 0.126, 0, 1.81, 0},
     {0.125, 0, 0.046, -0.012, 0, 0, 0},
     {0.0851, 0, -0.0122, 0.0025, 0, -0.220}},
    {{-2.529, 3.76, -0.174, 0.128, 0, 1.55, 0}, {0, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0}},
}};

}  // namespace

const BlendermannShip& blendermann_ship(std::string_view type) {
  const auto found = std::ranges::find(blendermann_ships, type, &BlendermannShip::type);
  if (found != blendermann_ships.end()) return *found;
  std::vector<std::string_view> known;
  for (const auto& ship : blendermann_ships) known.push_back(ship.type);
  throw std::domain_error(fmt::format("no type of ship \"{}\"; known are {}", type, fmt::join(known, ", ")));
}

std::optional<Windage<double>> windage_from(const WindageAreas& areas, std::string_view type) {
  const auto& ship = blendermann_ship(type);
  const double A_F = require_known(areas.frontal, "frontal windage area [m^2]");
  const double A_L = require_known(areas.lateral, "lateral windage area [m^2]");
  const double L = require_positive(areas.length, "ship length L [m]");
  if (A_F == 0.0 || A_L == 0.0) return std::nullopt;
  return Windage<double>{.A_F = A_F,
                         .A_L = A_L,
                         .L_OA = L,
                         .C_Dt = ship.C_Dt,
                         .C_Dl_bow = ship.C_Dl_bow,
                         .C_Dl_stern = ship.C_Dl_stern,
                         .delta = ship.delta};
}

bool feels_wind(const Windage<double>& windage) { return windage.A_F != 0.0 || windage.A_L != 0.0; }

WindTable mirrored(WindTable table) {
  for (auto& row : table) row = {-row.angle, row.C_X, -row.C_Y, -row.C_N};
  return table;
}

WindTable both_sides(const WindTable& one_side) {
  WindTable table = one_side;
  std::ranges::sort(table, {}, &WindRow::angle);
  merge_equal(table);  // here, so that a refusal names the angle that was given
  const WindTable other = mirrored(table);
  table.insert(table.end(), other.begin(), other.end());
  return table;
}

WindSpline wind_spline(WindTable table) {
  for (auto& row : table) row.angle = first_turn(row.angle);
  std::ranges::sort(table, {}, &WindRow::angle);
  merge_equal(table);
  const auto column = [&](double WindRow::*member) {
    std::vector<double> values;
    for (const auto& row : table) values.push_back(row.*member);
    return values;
  };
  const auto angle = column(&WindRow::angle);
  return {periodic_spline(angle, column(&WindRow::C_X)), periodic_spline(angle, column(&WindRow::C_Y)),
          periodic_spline(angle, column(&WindRow::C_N))};
}

WindTable isherwood_table(const Windage<double>& w, const IsherwoodProfile& profile) {
  const double L = require_positive(w.L_OA, "length over all L_OA [m]");
  const double B = require_positive(profile.B, "beam B [m]");
  const double A_L = require_positive(w.A_L, "lateral windage area [m^2]");
  const double A_F = require_positive(w.A_F, "frontal windage area [m^2]");
  const double C = 0.5 * L - w.x_A;
  const std::array common{1.0, 2.0 * A_L / (L * L), 2.0 * A_F / (B * B), L / B, profile.perimeter / L, C / L};
  const auto sum = [&common](const auto& k, double last) {
    double total = 0.0;
    for (std::size_t i = 0; i < common.size(); ++i) total += k[i] * common[i];
    return k.size() > common.size() ? total + k.back() * last : total;
  };
  WindTable one_side;
  for (std::size_t i = 0; i < isherwood_rows.size(); ++i) {
    const auto& row = isherwood_rows[i];
    one_side.push_back({.angle = radians(10.0 * static_cast<double>(i)),
                        .C_X = -sum(row.A, profile.masts),
                        .C_Y = -sum(row.B, profile.A_SS / A_L),
                        .C_N = -sum(row.C, 0.0)});
  }
  return both_sides(one_side);
}

}  // namespace swayaw::nonlinear
