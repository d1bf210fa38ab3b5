#pragma once

#include "casters.hpp"
#include "swayaw/nonlinear/effects.hpp"

namespace swayaw::python {

/// An effect is a variant in C++ and one class in Python.
struct AnyEffect {
  Effect value;
};

}  // namespace swayaw::python

namespace pybind11::detail {

template <>
struct type_caster<swayaw::Effect> {
  PYBIND11_TYPE_CASTER(swayaw::Effect, const_name("swayaw.Effect"));

  bool load(handle source, bool) {
    if (!isinstance<swayaw::python::AnyEffect>(source)) return false;
    value = source.cast<const swayaw::python::AnyEffect&>().value;
    return true;
  }

  static handle cast(const swayaw::Effect& effect, return_value_policy, handle) {
    return pybind11::cast(swayaw::python::AnyEffect{effect}).release();
  }
};

}  // namespace pybind11::detail
