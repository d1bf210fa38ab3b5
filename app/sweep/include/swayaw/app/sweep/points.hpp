#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "swayaw/app/sweep/plan.hpp"
#include "swayaw/core/parameter.hpp"

/// The points of a sweep: values of the parameters that vary. A point is told by its number alone, whoever asks, in
/// whatever order.
namespace swayaw::app {

/// Uniform between 0 and 1, both excluded, for a seed and two counters. Neighbours are independent: the counters go
/// through two rounds of the mixing of SplitMix64.
double unit_draw(std::uint64_t seed, std::uint64_t point, std::uint64_t dimension);

/// The law of one parameter, in the unit of the ship file.
struct Law {
  enum class Kind { uniform, normal, values } kind = Kind::uniform;
  double low = 0.0, high = 1.0;              ///< the ends
  double centre = 0.0, sd = 0.0;             ///< of a normal law
  double share_below = 0.0, share_to = 1.0;  ///< shares of it below the ends, between which draws lie
  std::vector<double> values{};              ///< of a grid

  /// The value below which a share u of all draws lies.
  double quantile(double u) const;
};

Law uniform_law(double from, double to);
Law normal_law(double centre, double sd, const Range& cut_to);
Law values_law(std::vector<double> values);

/// How many points a design has for laws of so many parameters.
std::size_t point_count(SweepDesign design, std::size_t size, std::span<const Law> laws);

/// The values of a point into `values`, one for each law.
void values_of_point(SweepDesign design, std::uint64_t seed, std::span<const Law> laws, std::size_t point,
                     std::span<double> values);

/// Points of the Sobol design that belong together: A, B, and A with each parameter of B in turn.
inline std::size_t sobol_stride(std::size_t parameters) { return parameters + 2; }

}  // namespace swayaw::app
