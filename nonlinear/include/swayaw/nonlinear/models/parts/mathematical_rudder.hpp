#pragma once

#include <array>

#include "swayaw/core/parameter.hpp"
#include "swayaw/nonlinear/models/parts/prime_forces.hpp"

namespace swayaw::inline nonlinear {

/// The rudder of the physics-uninformed model: a third-order Taylor expansion in rudder angle, drift and yaw rate.
/// Terms that a ship file does not name are zero, but for the slopes by the rudder angle, which it must. Thrust does
/// not enter; the hull's share is inside.
///
/// Source: [Alexandersson2024] appendix B.1
template <class S = double>
struct MathematicalRudder {
  S X_deltadelta;
  S Y_delta, Y_deltadeltadelta, Y_vdeltadelta, Y_vvdelta, Y_rdeltadelta, Y_rrdelta, Y_vrdelta;
  S N_delta, N_deltadeltadelta, N_vdeltadelta, N_vvdelta, N_rdeltadelta, N_rrdelta, N_vrdelta;
  Selection kind;

  static constexpr auto parameters() {
    using R = MathematicalRudder;
    constexpr auto term = [](std::string_view key, S R::*member) {
      return ParameterOf<R, S>{
          .key = key, .member = member, .unit = "-", .range = any_number, .role = Role::coefficient, .required = false};
    };
    constexpr auto needed = [](std::string_view key, S R::*member) {
      return ParameterOf<R, S>{
          .key = key, .member = member, .unit = "-", .range = any_number, .role = Role::coefficient};
    };
    return std::array{
        term("X_deltadelta", &R::X_deltadelta),
        needed("Y_delta", &R::Y_delta),
        term("Y_deltadeltadelta", &R::Y_deltadeltadelta),
        term("Y_vdeltadelta", &R::Y_vdeltadelta),
        term("Y_vvdelta", &R::Y_vvdelta),
        term("Y_rdeltadelta", &R::Y_rdeltadelta),
        term("Y_rrdelta", &R::Y_rrdelta),
        term("Y_vrdelta", &R::Y_vrdelta),
        needed("N_delta", &R::N_delta),
        term("N_deltadeltadelta", &R::N_deltadeltadelta),
        term("N_vdeltadelta", &R::N_vdeltadelta),
        term("N_vvdelta", &R::N_vvdelta),
        term("N_rdeltadelta", &R::N_rdeltadelta),
        term("N_rrdelta", &R::N_rrdelta),
        term("N_vrdelta", &R::N_vrdelta),
    };
  }

  static constexpr auto choices() {
    return std::array{Choice<MathematicalRudder>{"kind", &MathematicalRudder::kind, {"mathematical"}}};
  }
};

/// Force of the Taylor expansion, delta positive to port.
///
///     X_R = ½ρL²U² X_deltadelta' δ²
///     Y_R = ½ρL²U² (Y_delta' δ + Y_deltadeltadelta' δ³ + Y_vdeltadelta' v'δ² + Y_rdeltadelta' r'δ²
///                   + Y_vvdelta' v'²δ + Y_vrdelta' v'r'δ + Y_rrdelta' r'²δ)
///     N_R = ½ρL³U² (…), alike
///
/// Source: [Alexandersson2024] eqs (B.1)–(B.3)
template <class S>
PlanarForce<S> rudder_force(const MathematicalRudder<S>& k, const S& L, const PrimeMotion<S>& m, const S& delta) {
  const S vv = m.v * m.v, vr = m.v * m.r, rr = m.r * m.r, dd = delta * delta;
  const S Y = delta * (k.Y_delta + k.Y_deltadeltadelta * dd + k.Y_vvdelta * vv + k.Y_vrdelta * vr + k.Y_rrdelta * rr) +
              dd * (k.Y_vdeltadelta * m.v + k.Y_rdeltadelta * m.r);
  const S N = delta * (k.N_delta + k.N_deltadeltadelta * dd + k.N_vvdelta * vv + k.N_vrdelta * vr + k.N_rrdelta * rr) +
              dd * (k.N_vdeltadelta * m.v + k.N_rdeltadelta * m.r);
  return {.X = m.q * k.X_deltadelta * dd, .Y = m.q * Y, .N = m.q * L * N};
}

}  // namespace swayaw::nonlinear
