#pragma once

#include "swayaw/nonlinear/effects/search_form.hpp"
#include "swayaw/nonlinear/models/models.hpp"

namespace swayaw::inline nonlinear {

/// A share of the linear damping of sway and yaw that follows the motion late.
///
///     force = share (D(v_s, r_s) − D(v, r)) with the linear damping D of the hull
///     d(v_s)/dt = (v − v_s)/tau,   d(r_s)/dt = (r − r_s)/tau
template <class S = double>
struct FluidMemory {
  S tau{1.0};  ///< lag [s]
  S share{};

  static constexpr std::string_view id = "fluid_memory";
  static constexpr EffectPlace place = EffectPlace::force;
  static constexpr Scope scope = Scope::ship;
  static constexpr EffectText text{
      .phrase = "forces that follow the motion late",
      .label = "fluid memory",
      .law = "share · (D(v_s, r_s) − D(v, r)), D the linear damping of sway and yaw, dv_s/dt = (v − v_s)/τ, r_s alike",
      .confused_with = "steering gear lag: odd in δ'"};

  /// The motion that the damping remembers [m/s, rad/s].
  static constexpr std::array hidden{HiddenQuantity{"v_s", ShipUnit::speed}, HiddenQuantity{"r_s", ShipUnit::yaw_rate}};

  static constexpr auto parameters() {
    using P = ParameterOf<FluidMemory, S>;
    return std::array{P{.key = "tau_s",
                        .member = &FluidMemory::tau,
                        .unit = "s",
                        .range = positive,
                        .null = 1.0,
                        .prior = 1.0,
                        .scale = ShipUnit::time,
                        .decides = false},
                      P{.key = "share",
                        .member = &FluidMemory::share,
                        .range = {-2.0, 2.0},
                        .required = false,
                        .fallback = 0.3,
                        .prior = 0.3,
                        .floor = 0.05}};
  }
};

/// Linear damping of the hull by a sway and a yaw rate, at the speed U.
template <class S>
PlanarForce<S> linear_damping(const MmgShip<S>& ship, const S& U, const S& v, const S& r) {
  const auto& [p, h] = std::tie(ship.particulars, ship.hull);
  const S q = 0.5 * ship.water.rho * p.L * p.d * U;
  return {.X = S(0.0), .Y = q * (h.Y_v * v + h.Y_r * r * p.L), .N = q * p.L * (h.N_v * v + h.N_r * r * p.L)};
}

template <PrimeShip Ship>
PlanarForce<typename Ship::Scalar> linear_damping(const Ship& ship, const typename Ship::Scalar& U,
                                                  const typename Ship::Scalar& v, const typename Ship::Scalar& r) {
  using S = typename Ship::Scalar;
  const auto& h = ship.hull;
  const S L = ship.particulars.L, q = 0.5 * ship.water.rho * L * L * U;
  return {.X = S(0.0), .Y = q * (h.Y_v * v + h.Y_r * r * L), .N = q * L * (h.N_v * v + h.N_r * r * L)};
}

template <class S>
PlanarForce<S> linear_damping(const AbkowitzShip<S>& ship, const S& U, const S& v, const S& r) {
  const auto& h = ship.hull;
  const S L = ship.particulars.L,
          q = 0.5 * ship.water.rho * L * L * (ship.particulars.primes_at_nominal_speed() ? ship.particulars.U_0 : U);
  return {.X = S(0.0), .Y = q * (h.Y_v * v + h.Y_r * r * L), .N = q * L * (h.N_v * v + h.N_r * r * L)};
}

template <class Model, class S>
PlanarForce<S> force(const FluidMemory<S>& e, const Model& model, const Circumstances<S>& now) {
  const auto& m = now.state.motion;
  const auto f = linear_damping(model, speed(m), S(now.hidden[0] - m.v), S(now.hidden[1] - m.r));
  return {.X = S(0.0), .Y = e.share * f.Y, .N = e.share * f.N};
}

template <class S>
std::array<S, 2> hidden_rates(const FluidMemory<S>& e, const ShipFacts<S>&, const PlanarMotion<S>& m,
                              std::span<const S> hidden) {
  return {(m.v - hidden[0]) / e.tau, (m.r - hidden[1]) / e.tau};
}

template <class S>
std::array<S, 2> steady_hidden(const FluidMemory<S>&, const ShipFacts<S>&, const PlanarMotion<S>& m) {
  return {m.v, m.r};
}

inline SearchForm<FluidMemory<>> search_form(const FluidMemory<>& null, const SearchContext& context) {
  ParameterMove tau{{.name = "tau", .centre = 0.5, .deviation = 0.5, .low = 0.02, .high = 10.0},
                    context["tau_s"].index,
                    [unit = context.time_unit](double c) { return c * unit; }};
  return by_moves(null, {std::move(tau), from_null(context["share"])}, {{0.5, 0.5}});
}

}  // namespace swayaw::nonlinear
