#include "swayaw/app/sweep/points.hpp"

#include <algorithm>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>

namespace swayaw::app {
namespace {

/// Source: Steele, Lea, Flood: Fast splittable pseudorandom number generators, OOPSLA 2014 (constants of Stafford).
constexpr std::uint64_t golden = 0x9e3779b97f4a7c15;

constexpr std::uint64_t mixed(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

/// Share of a standard normal law below x.
double normal_share(double x) { return 0.5 * std::erfc(-x * std::sqrt(0.5)); }

/// Its inverse, without the promotion to long double, which takes four times as long.
double normal_quantile(double share) {
  using Fast = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
  return -std::sqrt(2.0) * boost::math::erfc_inv(2.0 * share, Fast());
}

}  // namespace

double unit_draw(std::uint64_t seed, std::uint64_t point, std::uint64_t dimension) {
  const auto bits = mixed(mixed(mixed(seed + golden) + (point + 1) * golden) + (dimension + 1) * golden);
  return (static_cast<double>(bits >> 11) + 0.5) * 0x1p-53;
}

double Law::quantile(double u) const {
  if (kind == Kind::uniform) return low + u * (high - low);
  if (kind == Kind::values) {
    const auto n = values.size();
    return values[std::min(n - 1, static_cast<std::size_t>(u * static_cast<double>(n)))];
  }
  return std::clamp(centre + sd * normal_quantile(share_below + u * (share_to - share_below)), low, high);
}

Law uniform_law(double from, double to) { return {.kind = Law::Kind::uniform, .low = from, .high = to}; }

Law normal_law(double centre, double sd, const Range& cut_to) {
  return {.kind = Law::Kind::normal,
          .low = cut_to.low,
          .high = cut_to.high,
          .centre = centre,
          .sd = sd,
          .share_below = normal_share((cut_to.low - centre) / sd),
          .share_to = normal_share((cut_to.high - centre) / sd)};
}

Law values_law(std::vector<double> values) { return {.kind = Law::Kind::values, .values = std::move(values)}; }

std::size_t point_count(SweepDesign design, std::size_t size, std::span<const Law> laws) {
  if (laws.empty()) return 1;
  if (design == SweepDesign::draws) return size;
  if (design == SweepDesign::sobol) return size * sobol_stride(laws.size());
  std::size_t points = 1;
  for (const auto& law : laws) points *= law.values.size();
  return points;
}

void values_of_point(SweepDesign design, std::uint64_t seed, std::span<const Law> laws, std::size_t point,
                     std::span<double> values) {
  const auto k = laws.size();
  if (design == SweepDesign::grid) {
    for (std::size_t d = k; d-- > 0;) {  // the last one runs fastest
      const auto n = laws[d].values.size();
      values[d] = laws[d].values[point % n];
      point /= n;
    }
    return;
  }
  const auto pair = design == SweepDesign::sobol ? point / sobol_stride(k) : point,
             member = design == SweepDesign::sobol ? point % sobol_stride(k) : 0;
  for (std::size_t d = 0; d < k; ++d) {
    const bool of_b = member == 1 || member == d + 2;
    values[d] = laws[d].quantile(unit_draw(seed, pair, of_b ? k + d : d));
  }
}

}  // namespace swayaw::app
