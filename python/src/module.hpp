#pragma once

#include <pybind11/pybind11.h>

/// The parts of the module, in the order in which they are added: each knows the classes of those before it.
namespace swayaw::python {

void add_core(pybind11::module_& m);
void add_linear(pybind11::module_& m);
void add_linear_motion(pybind11::module_& m);
void add_ships(pybind11::module_& m);
void add_estimates(pybind11::module_& m);
void add_manoeuvres(pybind11::module_& m);
void add_criteria(pybind11::module_& m);
void add_motion(pybind11::module_& m);
void add_checks(pybind11::module_& m);
void add_trials(pybind11::module_& m);
void add_regression(pybind11::module_& m);
void add_states(pybind11::module_& m);
void add_fits(pybind11::module_& m);
void add_captive(pybind11::module_& m);
void add_trajectories(pybind11::module_& m);
void add_tuning(pybind11::module_& m);
void add_batches(pybind11::module_& m);
void add_estimation(pybind11::module_& m);
void add_comparison(pybind11::module_& m);
void add_findings(pybind11::module_& m);
void add_budget(pybind11::module_& m);
void add_diagnosis_result(pybind11::module_& m);
void add_diagnosis(pybind11::module_& m);
void add_fleets(pybind11::module_& m);
void add_sweeps(pybind11::module_& m);

}  // namespace swayaw::python
