#pragma once

#include "swayaw/linear/ship_parts.hpp"

namespace swayaw::inline linear::detail {

/// Hull and rudder with constants of another scalar. Not installed.
template <class S>
LinearParts<S> lifted(const LinearParts<double>& ship) {
  const auto& [h, r] = ship;
  return {.hull = {S(h.L_over_B), S(h.c_B), S(h.k_11), S(h.k_22), S(h.r_z), S(h.r_66), S(h.Y_b), S(h.Y_w), S(h.N_b),
                   S(h.N_w)},
          .rudder = {S(r.area_ratio), S(r.w), S(r.c_Th), S(r.lift_slope), S(r.a_H), S(r.c_Ry), S(r.x_Reff)}};
}

}  // namespace swayaw::linear::detail
