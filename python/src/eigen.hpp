#pragma once

#include <Eigen/Core>

#include "record.hpp"

/// Matrices of Eigen as arrays of numpy.
namespace swayaw::python {

inline py::array array_of(const Eigen::MatrixXd& m) {
  py::array_t<double> result({m.rows(), m.cols()});
  for (Eigen::Index i = 0; i < m.rows(); ++i)
    for (Eigen::Index k = 0; k < m.cols(); ++k) result.mutable_at(i, k) = m(i, k);
  return result;
}

/// @throws std::domain_error  that names it, unless it has two dimensions
inline Eigen::MatrixXd matrix_in(const Array& array, std::string_view name) {
  if (array.ndim() != 2)
    throw std::domain_error(fmt::format("{} must have two dimensions, got {}", name, array.ndim()));
  const auto values = array.unchecked<2>();
  return Eigen::MatrixXd::NullaryExpr(values.shape(0), values.shape(1), [&](auto i, auto k) { return values(i, k); });
}

/// @throws std::domain_error  that names it, unless it has one dimension
inline Eigen::VectorXd vector_in(const Array& array, std::string_view name) {
  const auto numbers = numbers_in(array, name);
  return Eigen::VectorXd::Map(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}

template <>
struct Form<Eigen::MatrixXd> {
  static std::string type() { return "numpy.ndarray"; }
  static py::object get(Eigen::MatrixXd& value, py::handle) { return array_of(value); }
  static void set(Eigen::MatrixXd& place, py::handle value) { place = matrix_in(value.cast<Array>(), "a field"); }
};

template <>
struct Form<Eigen::VectorXd> {
  static std::string type() { return "numpy.ndarray"; }
  static py::object get(Eigen::VectorXd& value, py::handle record) {
    return view({value.data(), static_cast<std::size_t>(value.size())}, record);
  }
  static void set(Eigen::VectorXd& place, py::handle value) { place = vector_in(value.cast<Array>(), "a field"); }
};

}  // namespace swayaw::python
