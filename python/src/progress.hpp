#pragma once

#include <exception>

#include "casters.hpp"

/// Long work: told to a function of Python, ended by it, by its exceptions and by Ctrl-C.
namespace swayaw::python {

/// Whoever listens to a work that runs without the interpreter's lock. An exception, of the listener or of Ctrl-C, ends
/// the work at its next word; `end` raises it.
class Listener {
 public:
  /// @param function  None for the line of a notebook, where there is one; False for nobody
  /// @param work      its name
  Listener(py::object function, const char* work) : function_(std::move(function)) {
    if (function_.is_none()) function_ = line_ = py::module_::import("swayaw.notebook").attr("line")(work);
    if (function_.is(py::bool_(false))) function_ = py::none();
  }

  /// @return false if the work shall end with what it has
  template <class... Words>
  bool tell(const Words&... words) {
    const py::gil_scoped_acquire locked;
    if (trouble_) return false;
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      return function_.is_none() || !function_(words...).is(py::bool_(false));
    } catch (...) {
      trouble_ = std::current_exception();
      return false;
    }
  }

  /// The work has come back.
  void end() const {
    if (!line_.is_none()) line_.attr("end")();
    if (trouble_) std::rethrow_exception(trouble_);
  }

 private:
  py::object function_;
  py::object line_ = py::none();
  std::exception_ptr trouble_;
};

/// Does a work that tells its listener, without the interpreter's lock.
template <class Work>
auto listened_to(Listener& listener, const Work& work) {
  auto result = [&] {
    const py::gil_scoped_release unlocked;
    return work();
  }();
  listener.end();
  return result;
}

}  // namespace swayaw::python
