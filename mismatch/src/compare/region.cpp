#include "swayaw/mismatch/region.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "statistics.hpp"
#include "swayaw/core/angle.hpp"

namespace swayaw::inline mismatch {
using namespace detail;
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

/// A variable in words: what it is, and which way its values point.
struct VariableWords {
  std::string_view name, subject, positive, negative, unit;
};

const VariableWords& words_of(Variable variable) {
  static constexpr std::array words{
      VariableWords{"drift", "drift angle", "bow to starboard of the track", "bow to port of the track", " deg"},
      VariableWords{"yaw_rate", "yaw rate r'", "to starboard", "to port", ""},
      VariableWords{"rudder", "rudder", "to port", "to starboard", " deg"}};
  return words[static_cast<std::size_t>(variable)];
}

/// A bound in the unit that people read: degrees, or r'.
std::string shown(Variable variable, double bound) {
  if (variable == Variable::yaw_rate) return fmt::format("{:g}", bound);
  return fmt::format("{:g}", std::round(degrees(bound) * 1000.0) / 1000.0);
}

/// "15 to 25 deg" or "beyond 25 deg", of the size of the variable.
std::string size_words(Variable variable, double low, double high) {
  const auto unit = words_of(variable).unit;
  if (std::isinf(high)) return fmt::format("beyond {}{}", shown(variable, low), unit);
  return fmt::format("{} to {}{}", shown(variable, low), shown(variable, high), unit);
}

}  // namespace

std::string_view name_of(Variable variable) { return words_of(variable).name; }

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
  const auto& words = words_of(variable);
  const double low = region.from.value_or(-infinite), high = region.to.value_or(infinite);
  if (low < 0.0 && high > 0.0)
    return fmt::format("{} within {}{} of zero", words.subject, shown(variable, high), words.unit);
  const auto size = low > 0.0 ? size_words(variable, low, high) : size_words(variable, -high, -low);
  return fmt::format("{} {} {}", words.subject, size, low > 0.0 ? words.positive : words.negative);
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
  constexpr double least_share = 0.05;  // of the samples: fewer may be one wave or one outlier
  std::optional<RegionError> worst;
  for (const auto& region : regions) {
    double samples = 0.0;
    for (const auto& other : regions)
      if (other.variable == region.variable) samples += static_cast<double>(other.samples);
    if (static_cast<double>(region.samples) < least_share * samples) continue;
    if (!worst || region.rms > worst->rms) worst = region;
  }
  return worst;
}

}  // namespace swayaw::mismatch
