#pragma once

#include <array>
#include <cmath>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "swayaw/core/scalar.hpp"
#include "swayaw/nonlinear/effects/effect.hpp"
#include "swayaw/nonlinear/models/models.hpp"

/// Changes of the parameters of a model, in any scalar.
namespace swayaw::inline nonlinear {

/// Calls visit(parameter, value) for every parameter of a table.
template <class Model, class Visit>
void for_each_in_table(Model& model, std::string_view table, Visit&& visit) {
  const auto visit_part = [&](const auto& section) {
    if (section.table != table && !(table == "added_mass" && section.table == "inertia")) return;
    auto& part = model.*section.part;
    for (const auto& p : parameter_list<std::remove_cvref_t<decltype(part)>>) visit(p, part.*p.member);
  };
  std::apply([&](const auto&... section) { (visit_part(section), ...); }, std::remove_const_t<Model>::sections());
}

/// The value of a table of the model under one of two names, "" for none; nullptr if it is not there.
template <class Model, class S = typename std::remove_const_t<Model>::Scalar>
S* value_named(Model& model, std::string_view table, const std::array<std::string_view, 2>& names) {
  S* found = nullptr;
  for_each_in_table(model, table, [&](const auto& p, auto& value) {
    if (p.key == names[0] || (!names[1].empty() && p.key == names[1])) found = const_cast<S*>(&value);
  });
  return found;
}

/// The value of the model that a parameter of an effect replaces, or nullptr.
template <class Model, class Part, class S>
S* replaced(Model& model, const ParameterOf<Part, S>& parameter) {
  return value_named(model, parameter.table, parameter.replaces);
}

/// Multiplies all coefficients of a table.
template <class Model, class S>
void scale_coefficients(Model& model, std::string_view table, const S& factor) {
  for_each_in_table(model, table, [&](const auto& p, auto& value) {
    if (p.role == Role::coefficient) value = value * factor;
  });
}

/// Puts other values in the place of parameters of the model, those that are given.
/// @return  key of a value that the model has no place for; empty if there is none
template <class Model, class Kind>
std::string_view put_values(Model& model, const Kind& effect) {
  for (const auto& p : parameter_list<Kind>) {
    const auto& value = effect.*p.member;
    if (p.table.empty() || std::isnan(value_of(value))) continue;
    auto* place = replaced(model, p);
    if (!place) return p.key;
    *place = value;
  }
  return {};
}

/// Whether the parameters of an effect are other values of parameters of a model.
template <class Kind>
constexpr bool puts_values() {
  return !Kind::parameters()[0].table.empty();
}

/// Changes the parameters of a model as an effect says; nothing for effects that act otherwise.
/// @return  key of a value that the model has no place for; empty if there is none
template <class Model, class Kind>
std::string_view change_model(Model& model, const Kind& effect) {
  if constexpr (requires { prepare(model, effect); }) prepare(model, effect);
  if constexpr (puts_values<Kind>()) return put_values(model, effect);
  else if constexpr (requires { change(model, effect); }) change(model, effect);
  return {};
}

}  // namespace swayaw::nonlinear
