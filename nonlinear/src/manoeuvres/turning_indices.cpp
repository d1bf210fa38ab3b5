#include "swayaw/nonlinear/manoeuvres/turning_indices.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <stdexcept>

namespace swayaw::inline nonlinear {
namespace {

std::array<double, 6> numbers(const TurningIndices& t) { return {t.u_s, t.v_s, t.r_s, t.D, t.Ad, t.Td}; }

}  // namespace

std::optional<TurningIndices> turning_indices(const TurningCircle& circle, double L) {
  if (!circle.steady || !circle.tactical_diameter) return std::nullopt;
  const auto& [u, v, r] = *circle.steady;
  return TurningIndices{.u_s = u,
                        .v_s = std::copysign(1.0, r) * v,
                        .r_s = std::abs(r),
                        .D = *circle.final_diameter / L,
                        .Ad = *circle.advance / L,
                        .Td = *circle.tactical_diameter / L};
}

IndexError index_error(std::span<const TurningIndices> turns, std::span<const TurningIndices> measured) {
  if (turns.size() != measured.size())
    throw std::domain_error(
        fmt::format("{} turns cannot be compared with {} measured ones", turns.size(), measured.size()));
  IndexError error{0.0, 0.0};
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const auto is = numbers(turns[i]), should = numbers(measured[i]);
    for (std::size_t k = 0; k < is.size(); ++k) {
      if (should[k] == 0.0) throw std::domain_error("an index that was measured as 0 has no relative error");
      const double part = 1.0 - is[k] / should[k];
      error.squares += part * part;
      error.absolute += std::abs(part);
    }
  }
  return error;
}

}  // namespace swayaw::nonlinear
