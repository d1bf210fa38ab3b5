#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "swayaw/mismatch/diagnose.hpp"
#include "user_units.hpp"

/// Effects and their parameters as people read them.
namespace swayaw::app {

/// "steady wind" of "steady_wind".
std::string_view label_of(std::string_view id);

/// The unit of a parameter of an effect; empty for a bare number.
std::string unit_of(const Effect& effect, std::string_view key);

/// "wind speed" of "wind_speed_m_s".
std::string name_of_parameter(std::string key, const std::string& unit);

/// "5.1 ± 0.4 kn", "105 ± 6 deg (ESE)"
std::string in_users_units(const Effect& effect, const ParameterEstimate& parameter, const UserUnits& units);

/// Groups or runs with surroundings of their own that have this effect's parameters, where it differs between them.
std::vector<SurroundingsEstimate> places_of(const FoundEffect& effect, const Diagnosis& diagnosis);

}  // namespace swayaw::app
