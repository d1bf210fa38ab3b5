#pragma once

#include <map>

#include "record.hpp"
#include "swayaw/identification/measurement.hpp"

/// Standard deviations by channel, as dictionaries.
namespace swayaw::python {

using NoiseByChannel = std::map<std::string, double>;

inline MeasurementNoise noise_from(const NoiseByChannel& given) {
  MeasurementNoise noise{};
  for (const auto& [name, deviation] : given) noise[index_of(named<Channel>(name))] = deviation;
  return noise;
}

inline py::dict noise_of(const MeasurementNoise& noise) {
  py::dict result;
  for (std::size_t i = 0; i < channel_count; ++i)
    if (noise[i]) result[py::str(short_name(static_cast<Channel>(i)))] = *noise[i];
  return result;
}

/// A field of them.
template <>
struct Form<MeasurementNoise> {
  static std::string type() { return "dict"; }
  static py::object get(MeasurementNoise& value, py::handle) { return noise_of(value); }
  static void set(MeasurementNoise& place, py::handle value) { place = noise_from(value.cast<NoiseByChannel>()); }
};

}  // namespace swayaw::python
