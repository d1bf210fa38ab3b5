#pragma once

#include <exception>

#include "casters.hpp"

/// Long work: told to a function of Python, ended by it, by its exceptions and by Ctrl-C.
namespace swayaw::python {

/// Whoever listens to a work that runs without the interpreter's lock. An exception, of the listener or of Ctrl-C, ends
/// the work at its next word; `rethrow` raises it when the work has come back.
class Listener {
 public:
  explicit Listener(py::object function) : function_(std::move(function)) {}

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

  void rethrow() const {
    if (trouble_) std::rethrow_exception(trouble_);
  }

 private:
  py::object function_;
  std::exception_ptr trouble_;
};

/// Does a work that tells its listener, without the interpreter's lock.
template <class Work>
auto listened_to(Listener& listener, const Work& work) {
  auto result = [&] {
    const py::gil_scoped_release unlocked;
    return work();
  }();
  listener.rethrow();
  return result;
}

}  // namespace swayaw::python
