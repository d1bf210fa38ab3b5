#include "effect_words.hpp"

#include <algorithm>

#include "sentences.hpp"

namespace swayaw::app {

std::string_view label_of(std::string_view id) { return text_of(make_effect(id)).label; }

std::string unit_of(const Effect& effect, std::string_view key) {
  std::string unit;
  for_each_parameter(effect, [&](const auto& p, double) {
    if (p.key == key) unit = p.unit;
  });
  return unit == "-" ? "" : unit;
}

std::string name_of_parameter(std::string key, const std::string& unit) {
  for (const std::string_view ending : {"_rad_s", "_m_s", "_rad", "_Nm", "_N", "_m", "_s"})
    if (!unit.empty() && key.ends_with(ending)) {
      key.resize(key.size() - ending.size());
      break;
    }
  return in_words(key);
}

std::string in_users_units(const Effect& effect, const ParameterEstimate& p, const UserUnits& units) {
  if (p.key == "rate") return units.clock_rate(p.value, p.standard_error);
  const bool direction = p.key.ends_with("_from_rad") || p.key.ends_with("_to_rad");
  return direction ? units.direction(p.value, p.standard_error)
                   : units.in_unit(unit_of(effect, p.key), p.value, p.standard_error);
}

std::vector<SurroundingsEstimate> places_of(const FoundEffect& effect, const Diagnosis& diagnosis) {
  std::vector<SurroundingsEstimate> places;
  if (effect.scope == Scope::ship || effect.parameters.empty()) return places;
  for (const auto& there : diagnosis.surroundings)
    if (std::ranges::count(there.parameters, effect.parameters.front().key, &ParameterEstimate::key) > 0)
      places.push_back(there);
  return places;
}

}  // namespace swayaw::app
