#pragma once

#include <cmath>
#include <string_view>

#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/effects.hpp"
#include "swayaw/nonlinear/models.hpp"
#include "swayaw/nonlinear/shallow_water.hpp"

/// Effects that change numbers of a model, in any scalar.
namespace swayaw {

/// Calls visit(key, number) for every number of a table.
template <class Model, class Visit>
void for_each_in_table(Model& model, std::string_view table, Visit&& visit) {
  const auto visit_part = [&](const auto& section) {
    if (section.table != table && !(table == "added_mass" && section.table == "inertia")) return;
    auto& part = model.*section.part;
    for (const auto& p : part.parameters()) visit(p, part.*p.member);
  };
  std::apply([&](const auto&... section) { (visit_part(section), ...); }, std::remove_const_t<Model>::sections());
}

/// The number of the model that a number of an effect replaces, or nullptr.
template <class Model, class Part, class S>
S* replaced(Model& model, const EffectParameter<Part, S>& parameter) {
  S* found = nullptr;
  for_each_in_table(model, parameter.table, [&](const auto& p, auto& number) {
    if (p.key == parameter.replaces[0] || (!parameter.replaces[1].empty() && p.key == parameter.replaces[1]))
      found = const_cast<S*>(&number);
  });
  return found;
}

/// Multiplies all coefficients of a table.
template <class Model, class S>
void scale_coefficients(Model& model, std::string_view table, const S& factor) {
  for_each_in_table(model, table, [&](const auto& p, auto& number) {
    if (p.role == Role::coefficient) number = number * factor;
  });
}

/// Puts other values in the place of numbers of the model, those that are given.
/// @return  key of a value that the model has no place for; empty if there is none
template <class Model, class Kind>
std::string_view put_values(Model& model, const Kind& effect) {
  for (const auto& p : effect.parameters()) {
    const auto& value = effect.*p.member;
    if (p.table.empty() || std::isnan(value_of(value))) continue;
    auto* place = replaced(model, p);
    if (!place) return p.key;
    *place = value;
  }
  return {};
}

/// Whether the numbers of an effect are other values of numbers of a model.
template <class Kind>
constexpr bool puts_values() {
  return !Kind::parameters()[0].table.empty();
}

// ---------------------------------------------------------------- factors

template <class S>
void change(MmgShip<S>& ship, const RudderEffectiveness<S>& e) {
  ship.rudder.f_alpha = ship.rudder.f_alpha * e.factor;
}

template <class S>
void change(PiShip<S>& ship, const RudderEffectiveness<S>& e) {
  ship.rudder.lift_factor = ship.rudder.lift_factor * e.factor;
}

template <class S>
void change(PuShip<S>& ship, const RudderEffectiveness<S>& e) {
  scale_coefficients(ship, "rudder", e.factor);
}

template <class S>
void change(AbkowitzShip<S>& ship, const RudderEffectiveness<S>& e) {
  scale_coefficients(ship, "rudder", e.factor);
}

template <class S>
void change(MmgShip<S>& ship, const AddedResistance<S>& e) {
  ship.hull.R_0 = ship.hull.R_0 * (1.0 + e.relative_increase);
}

template <PrimeShip Ship>
void change(Ship& ship, const AddedResistance<typename Ship::Scalar>& e) {
  ship.hull.X_0 = ship.hull.X_0 * (1.0 + e.relative_increase);
  ship.hull.X_u = ship.hull.X_u * (1.0 + e.relative_increase);
}

// ---------------------------------------------------------------- finite depth

template <class Ship, class S>
ShallowWaterFactors<S> shallow_factors(const Ship& ship, const ShallowWater<S>& e) {
  const auto& p = ship.particulars;
  return shallow_water_factors(S(p.nabla / (p.L * p.B * p.d)), e.depth_over_draught, e.growth());
}

template <class Hull, class S>
void change_hull(Hull& h, const ShallowWaterFactors<S>& f) {
  for (S* linear : {&h.Y_v, &h.N_v}) *linear = *linear * f.sway;
  for (S* linear : {&h.Y_r, &h.N_r}) *linear = *linear * f.yaw;
  for (S* cubic : {&h.Y_vvv, &h.Y_vvr, &h.Y_vrr, &h.Y_rrr, &h.N_vvv, &h.N_vvr, &h.N_vrr, &h.N_rrr})
    *cubic = *cubic * f.cubic;
}

/// 1 − t and 1 − w of a propeller.
template <class S>
void change_wake(S& t, S& w, const ShallowWaterFactors<S>& f) {
  t = 1.0 - (1.0 - t) * f.one_minus_t;
  w = 1.0 - (1.0 - w) * f.one_minus_w;
}

template <class S>
void change(MmgShip<S>& ship, const ShallowWater<S>& e) {
  const auto f = shallow_factors(ship, e);
  ship.hull.R_0 = ship.hull.R_0 * f.R_0;
  change_hull(ship.hull, f);
  ship.added_mass.m_x = ship.added_mass.m_x * f.m_x;
  ship.added_mass.m_y = ship.added_mass.m_y * f.m_y;
  ship.added_mass.J_z = ship.added_mass.J_z * f.J_z;
  change_wake(ship.propeller.t_P, ship.propeller.w_P0, f);
  ship.rudder.gamma_R_negative = ship.rudder.gamma_R_negative * f.gamma_R;
  ship.rudder.gamma_R_positive = ship.rudder.gamma_R_positive * f.gamma_R;
}

template <PrimeShip Ship>
void change(Ship& ship, const ShallowWater<typename Ship::Scalar>& e) {
  const auto f = shallow_factors(ship, e);
  ship.hull.X_0 = ship.hull.X_0 * f.R_0;
  ship.hull.X_u = ship.hull.X_u * f.R_0;
  change_hull(ship.hull, f);
  ship.added_mass.X_udot = ship.added_mass.X_udot * f.m_x;
  ship.added_mass.Y_vdot = ship.added_mass.Y_vdot * f.m_y;
  ship.added_mass.N_rdot = ship.added_mass.N_rdot * f.J_z;
  change_wake(ship.propeller.t_P, ship.propeller.w_f, f);
  if constexpr (requires { ship.rudder.kappa_v; }) {
    ship.rudder.kappa_v = ship.rudder.kappa_v * f.gamma_R;
    ship.rudder.kappa_r = ship.rudder.kappa_r * f.gamma_R;
  }
}

/// A wake that a file keeps constant begins to change.
template <class Model, class S>
void let_wake_change(Model& model, const WakeChange<S>&) {
  if constexpr (requires { model.propeller.wake; }) model.propeller.wake.index = 1;
}

template <class Model, class Kind>
void let_wake_change(Model&, const Kind&) {}

// ---------------------------------------------------------------- all of them

/// Whether effects of that kind change numbers of a model.
template <class Kind>
constexpr bool changes_numbers() {
  using K = std::remove_cvref_t<Kind>;
  return Kind::place == EffectPlace::force && (puts_values<K>() || K::id == "rudder_effectiveness" ||
                                               K::id == "added_resistance" || K::id == "shallow_water");
}

/// Changes the numbers of the model as the effect says; nothing for effects that act otherwise.
/// @return  what the model has no place for, "" if it has: a key, or the effect itself
template <class Model, class S>
std::string_view change_numbers(Model& model, const EffectIn<S>& effect) {
  const auto change_kind = [&]<class Kind>(const Kind& e) -> std::string_view {
    if constexpr (!changes_numbers<Kind>()) {
      return {};
    } else if constexpr (puts_values<Kind>()) {
      let_wake_change(model, e);
      return put_values(model, e);
    } else if constexpr (requires { change(model, e); }) {
      change(model, e);
      return {};
    } else {
      return e.id;
    }
  };
  return std::visit(change_kind, effect);
}

}  // namespace swayaw
