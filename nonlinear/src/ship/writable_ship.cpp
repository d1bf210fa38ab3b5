#include "swayaw/nonlinear/writable_ship.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "swayaw/nonlinear/coefficients.hpp"

namespace swayaw::inline nonlinear {
namespace {

bool fits(double value, const Range& range) { return std::isfinite(value) && range.contains(value); }

std::string words_for(std::string_view name, double found, double written) {
  return fmt::format("{} = {:.6g} was found, which no ship file holds; {:.6g} stands there", name, found, written);
}

/// Where a file may leave a number out, what that means is allowed too.
template <class Entry>
bool may_stand(const Entry& p, double number) {
  const bool is_fallback = number == p.fallback || (std::isnan(number) && std::isnan(p.fallback));
  return (!p.required && is_fallback) || fits(number, p.range);
}

/// The nearest number in the range, or what an open range has beside its end.
double nearest(double number, const Range& range) {
  if (std::isnan(number)) return std::isfinite(range.low) ? range.low : 0.0;
  const double inside = std::clamp(number, range.low, range.high);
  return range.contains(inside) ? inside : std::nextafter(inside, range.high);
}

void make_writable(Effect& effect, std::vector<std::string>& changed) {
  for_each_parameter(effect, [&](const auto& p, double& number) {
    if (may_stand(p, number)) return;
    const double found = number;
    number = p.required ? nearest(number, p.range) : p.fallback;
    changed.push_back(words_for(fmt::format("{} of {}", p.key, id_of(effect)), found, number));
  });
}

}  // namespace

WritableShip writable(const Ship& found, const Ship& beginning) {
  WritableShip result{found, {}};
  const auto numbers = parameters_of(found), before = parameters_of(beginning);
  std::vector<Parameter> outside;
  std::vector<double> values;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto& n = numbers[i];
    if (n.value == before[i].value || fits(n.value, n.range)) continue;
    outside.push_back(n);
    values.push_back(before[i].value);
    result.changed.push_back(words_for(n.name, n.value / n.si, before[i].value / n.si));
  }
  result.ship = with_values(found, outside, values);
  for (auto& effect : result.ship.effects) make_writable(effect, result.changed);
  std::erase_if(result.ship.confidence.named,
                [](const auto& trust) { return !(std::isfinite(trust.second) && trust.second >= 0.0); });
  return result;
}

}  // namespace swayaw::nonlinear
