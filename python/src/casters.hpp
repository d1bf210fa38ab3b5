#pragma once

#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "swayaw/core/channel.hpp"
#include "swayaw/core/parameter.hpp"
#include "swayaw/core/side.hpp"

/// What is a word in Python: sides, channels, and every other enumeration, by the names that the library has for them.
namespace swayaw::python {

namespace py = pybind11;

/// The words of an enumeration, in the order of its enumerators.
template <class Enum>
struct Words;

/// Of enumerations that the library names itself.
template <class Enum, std::size_t Count, std::string_view (*Name)(Enum)>
struct NamedWords {
  static std::vector<std::string> list() {
    std::vector<std::string> words;
    for (std::size_t i = 0; i < Count; ++i) words.emplace_back(Name(static_cast<Enum>(i)));
    return words;
  }
};

template <>
struct Words<Side> : NamedWords<Side, 2, name_of> {};
template <>
struct Words<Channel> : NamedWords<Channel, channel_count, short_name> {};
template <>
struct Words<Scope> : NamedWords<Scope, 3, name_of> {};
template <>
struct Words<Role> {
  static std::vector<std::string> list() { return {"fact", "coefficient"}; }
};

template <class Enum>
const std::vector<std::string>& words_of() {
  static const auto words = Words<Enum>::list();
  return words;
}

/// The enumerator of a word. @throws std::domain_error  that lists all words
template <class Enum>
Enum named(const std::string& word) {
  const auto& words = words_of<Enum>();
  for (std::size_t i = 0; i < words.size(); ++i)
    if (words[i] == word) return static_cast<Enum>(i);
  throw std::domain_error(fmt::format("\"{}\" is none of {}", word, fmt::join(words, ", ")));
}

/// A channel has columns besides.
template <>
inline Channel named(const std::string& word) {
  if (const auto channel = channel_named(word)) return *channel;
  throw std::domain_error(fmt::format("\"{}\" is none of {}", word, fmt::join(words_of<Channel>(), ", ")));
}

/// Text that outlives whoever asked for it; results hold names as views of it.
std::string_view kept(std::string text);

// ---------------------------------------------------------------- numbers

using Array = py::array_t<double, py::array::forcecast>;

/// A numpy array on numbers of `owner`, without a copy.
inline py::array view(std::span<const double> values, py::handle owner, bool writable = false) {
  py::array_t<double> array({values.size()}, {sizeof(double)}, values.data(), owner);
  if (!writable) array.attr("flags").attr("writeable") = false;
  return array;
}

/// Numbers that nobody else holds, without a copy.
inline py::array owned(std::vector<double>&& values) {
  auto* kept_values = new std::vector<double>(std::move(values));
  const py::capsule owner(kept_values, [](void* p) { delete static_cast<std::vector<double>*>(p); });
  return py::array_t<double>({kept_values->size()}, {sizeof(double)}, kept_values->data(), owner);
}

/// The numbers of a one-dimensional array. @throws std::domain_error  that names it, for others
std::vector<double> numbers_in(const Array& array, std::string_view name);

/// The rows of a two-dimensional array. @throws std::domain_error  that names it, for others
std::vector<std::vector<double>> rows_in(const Array& array, std::string_view name);

/// Rows of equal length as a matrix.
template <std::size_t Rows, std::size_t Columns>
py::array_t<double> matrix(const std::array<std::array<double, Columns>, Rows>& rows) {
  py::array_t<double> result({Rows, Columns});
  for (std::size_t i = 0; i < Rows; ++i)
    for (std::size_t k = 0; k < Columns; ++k)
      result.mutable_at(static_cast<py::ssize_t>(i), static_cast<py::ssize_t>(k)) = rows[i][k];
  return result;
}

py::array_t<double> matrix(const std::vector<std::vector<double>>& rows);

/// A word for `std::optional<T>` arguments that are left out.
using Maybe = std::optional<double>;

/// The work is done without the interpreter's lock: other threads of Python go on.
using Unlocked = py::call_guard<py::gil_scoped_release>;

}  // namespace swayaw::python

namespace pybind11::detail {

template <class Enum>
  requires std::is_enum_v<Enum> && requires { swayaw::python::Words<Enum>::list(); }
struct type_caster<Enum> {
  PYBIND11_TYPE_CASTER(Enum, const_name("str"));

  bool load(handle source, bool) {
    if (!isinstance<str>(source)) return false;
    value = swayaw::python::named<Enum>(source.cast<std::string>());
    return true;
  }

  static handle cast(Enum word, return_value_policy, handle) {
    return str(swayaw::python::words_of<Enum>().at(static_cast<std::size_t>(word))).release();
  }
};

}  // namespace pybind11::detail
