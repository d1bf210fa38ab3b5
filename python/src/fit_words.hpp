#pragma once

#include "casters.hpp"
#include "swayaw/identification/captive.hpp"
#include "swayaw/identification/fit_report.hpp"

namespace swayaw::python {

template <>
struct Words<Verdict> : NamedWords<Verdict, 3, in_words> {};
template <>
struct Words<FitStatus> : NamedWords<FitStatus, 3, in_words> {};
template <>
struct Words<ForceComponent> : NamedWords<ForceComponent, 3, in_words> {};

}  // namespace swayaw::python
