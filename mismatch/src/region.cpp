#include "swayaw/mismatch/region.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "statistics.hpp"
#include "swayaw/core/angle.hpp"

namespace swayaw {
namespace {

constexpr std::array angle_bounds{radians(-25), radians(-15), radians(-8), radians(-4), radians(-1.5),
                                  radians(1.5), radians(4),   radians(8),  radians(15), radians(25)};
constexpr std::array yaw_bounds{-0.6, -0.4, -0.25, -0.1, -0.03, 0.03, 0.1, 0.25, 0.4, 0.6};

std::span<const double> bounds_of(Variable variable) {
  if (variable == Variable::yaw_rate) return yaw_bounds;
  return angle_bounds;
}

std::vector<RegionError> errors_by(Variable variable, std::span<const double> errors, std::span<const double> values) {
  const auto bounds = bounds_of(variable);
  std::vector<Sums> sums(bounds.size() + 1);
  Sums all;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    if (std::isnan(values[i])) continue;
    const auto bin = std::ranges::upper_bound(bounds, values[i]) - bounds.begin();
    sums[static_cast<std::size_t>(bin)].add(errors[i]);
    all.add(errors[i]);
  }
  std::vector<RegionError> regions;
  for (std::size_t bin = 0; bin < sums.size(); ++bin) {
    const auto& s = sums[bin];
    if (s.count == 0.0) continue;
    regions.push_back({.variable = variable,
                       .from = bin > 0 ? std::optional(bounds[bin - 1]) : std::nullopt,
                       .to = bin < bounds.size() ? std::optional(bounds[bin]) : std::nullopt,
                       .samples = static_cast<std::size_t>(s.count),
                       .rms = s.rms(),
                       .bias = s.mean(),
                       .share = all.squares > 0.0 ? s.squares / all.squares : 0.0});
  }
  return regions;
}

/// Which way a positive value points.
std::string_view positive_side(Variable variable) {
  switch (variable) {
    case Variable::drift: return "bow to starboard of the track";
    case Variable::yaw_rate: return "to starboard";
    case Variable::rudder: return "to port";
  }
  return "";
}

std::string_view negative_side(Variable variable) {
  switch (variable) {
    case Variable::drift: return "bow to port of the track";
    case Variable::yaw_rate: return "to port";
    case Variable::rudder: return "to starboard";
  }
  return "";
}

/// A bound in the unit that people read: degrees, or r'.
std::string shown(Variable variable, double bound) {
  if (variable == Variable::yaw_rate) return fmt::format("{:g}", bound);
  return fmt::format("{:g}", std::round(degrees(bound) * 1000.0) / 1000.0);
}

/// "15 to 25 deg" or "beyond 25 deg", of the size of the variable.
std::string size_words(Variable variable, double low, double high) {
  const auto unit = variable == Variable::yaw_rate ? "" : " deg";
  if (std::isinf(high)) return fmt::format("beyond {}{}", shown(variable, low), unit);
  return fmt::format("{} to {}{}", shown(variable, low), shown(variable, high), unit);
}

std::string_view subject(Variable variable) {
  switch (variable) {
    case Variable::drift: return "drift angle";
    case Variable::yaw_rate: return "yaw rate r'";
    case Variable::rudder: return "rudder";
  }
  return "";
}

}  // namespace

std::string_view name_of(Variable variable) {
  switch (variable) {
    case Variable::drift: return "drift";
    case Variable::yaw_rate: return "yaw_rate";
    case Variable::rudder: return "rudder";
  }
  return "";
}

std::span<const double> Conditions::of(Variable variable) const {
  switch (variable) {
    case Variable::drift: return drift;
    case Variable::yaw_rate: return yaw_rate;
    case Variable::rudder: break;
  }
  return rudder;
}

std::string words_for(const RegionError& region) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const auto variable = region.variable;
  const double low = region.from.value_or(-infinite), high = region.to.value_or(infinite);
  if (low < 0.0 && high > 0.0)
    return fmt::format("{} within {}{} of zero", subject(variable), shown(variable, high),
                       variable == Variable::yaw_rate ? "" : " deg");
  if (low > 0.0)
    return fmt::format("{} {} {}", subject(variable), size_words(variable, low, high), positive_side(variable));
  return fmt::format("{} {} {}", subject(variable), size_words(variable, -high, -low), negative_side(variable));
}

std::vector<RegionError> errors_by_region(std::span<const double> errors, const Conditions& conditions) {
  std::vector<RegionError> all;
  for (const auto variable : {Variable::drift, Variable::yaw_rate, Variable::rudder}) {
    const auto regions = errors_by(variable, errors, conditions.of(variable));
    all.insert(all.end(), regions.begin(), regions.end());
  }
  return all;
}

std::optional<RegionError> worst_region(std::span<const RegionError> regions) {
  std::optional<RegionError> worst;
  for (const auto& region : regions) {
    double samples = 0.0;
    for (const auto& other : regions)
      if (other.variable == region.variable) samples += static_cast<double>(other.samples);
    if (static_cast<double>(region.samples) < 0.05 * samples) continue;
    if (!worst || region.rms > worst->rms) worst = region;
  }
  return worst;
}

}  // namespace swayaw
