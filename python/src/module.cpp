#include "module.hpp"

#include <pybind11/pybind11.h>

#include "swayaw/core/refusal.hpp"

namespace swayaw::python {
namespace {

namespace py = pybind11;

/// The classes of exceptions, kept as long as the interpreter.
py::object& refusal() {
  static auto& type = *new py::object;
  return type;
}
py::object& file_error() {
  static auto& type = *new py::object;
  return type;
}

py::object exception(py::module_& m, const char* name, const char* doc, py::handle base) {
  auto type = py::reinterpret_steal<py::object>(
      PyErr_NewExceptionWithDoc(("swayaw." + std::string(name)).c_str(), doc, base.ptr(), nullptr));
  m.attr(name) = type;
  return type;
}

void raise_file_error(const FileError& trouble) {
  const auto error = file_error()(trouble.what());
  error.attr("file") = py::str(trouble.place().file.string());
  error.attr("line") = trouble.place().line;
  error.attr("column") = trouble.place().column;
  PyErr_SetObject(file_error().ptr(), error.ptr());
}

void add_errors(py::module_& m) {
  refusal() = exception(m, "Refusal", "A question that the data or the model cannot answer; its text says why.",
                        PyExc_ValueError);
  file_error() =
      exception(m, "FileError", "A file that cannot be read: \"FILE:LINE:COLUMN: what is wrong\".", refusal());
  py::register_exception_translator([](std::exception_ptr trouble) {
    try {
      if (trouble) std::rethrow_exception(trouble);
    } catch (const FileError& e) {
      raise_file_error(e);
    } catch (const Refusal& e) {
      PyErr_SetString(refusal().ptr(), e.what());
    }
  });
}

}  // namespace
}  // namespace swayaw::python

PYBIND11_MODULE(_swayaw, m) {
  using namespace swayaw::python;
  m.doc() = "Ship steering dynamics: simulate, compare, explain.";
  m.attr("__module__") = "swayaw";  // where people find the classes
  add_errors(m);
  add_core(m);
  add_linear(m);
  add_linear_motion(m);
  add_ships(m);
  add_estimates(m);
  add_manoeuvres(m);
  add_criteria(m);
  add_motion(m);
  add_checks(m);
  add_trials(m);
  add_regression(m);
  add_states(m);
  add_fits(m);
  add_captive(m);
  add_trajectories(m);
  add_tuning(m);
  add_batches(m);
  add_estimation(m);
  add_comparison(m);
  add_findings(m);
  add_budget(m);
  add_diagnosis_result(m);
  add_diagnosis(m);
  add_fleets(m);
#ifdef SWAYAW_SWEEPS
  add_sweeps(m);
#endif
}
