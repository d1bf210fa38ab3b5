#pragma once

#include <string>
#include <type_traits>
#include <vector>

#include "casters.hpp"

/// Value types of the library as classes of Python: fields with a type and a sentence each, a constructor by position
/// or name where people make them, pickling. `swayaw/records.py` adds repr, equality and `_asdict` for all of them.
namespace swayaw::python {

/// One field of a record; the same for all types.
struct Field {
  const char* name;
  std::string type;  ///< as an annotation: "float", "Optional[swayaw.Recording]"
  py::object (*get)(py::handle record);
  void (*set)(void* record, py::handle value);
  bool required;
};

/// Adds the property and notes the field in `_fields` and `__annotations__` of the class.
void add_field(py::handle type, Field field, const char* doc);

enum class Made { by_library, by_anyone };

/// Pickling, and for records that anyone makes a constructor by position and name. The same code for all types: a
/// template would take the compiler half a second for each.
///
/// @param blank  makes a record of default values
void add_makers(py::handle type, void* (*blank)(), Made made);

/// The annotation that pybind11 would write: % stands for a class that is registered.
std::string annotation(const char* text, const std::type_info* const* types);

/// How a field is told to Python: as pybind11 does it, or else for some types.
template <class T>
struct Form {
  static std::string type() {
    static constexpr auto name = py::detail::make_caster<T>::name;
    return annotation(name.text, decltype(name)::types().data());
  }
  static py::object get(T& value, py::handle record) {
    return py::cast(value, py::return_value_policy::reference_internal, record);
  }
  static void set(T& place, py::handle value) { place = value.cast<T>(); }
};

/// Numbers as an array on them.
template <>
struct Form<std::vector<double>> {
  static std::string type() { return "numpy.ndarray"; }
  static py::object get(std::vector<double>& value, py::handle record) { return view(value, record); }
  static void set(std::vector<double>& place, py::handle value) { place = numbers_in(value.cast<Array>(), "a field"); }
};

/// Rows of equal length as a matrix.
template <>
struct Form<std::vector<std::vector<double>>> {
  static std::string type() { return "numpy.ndarray"; }
  static py::object get(std::vector<std::vector<double>>& value, py::handle) { return matrix(value); }
  static void set(std::vector<std::vector<double>>& place, py::handle value) {
    place = rows_in(value.cast<Array>(), "a field");
  }
};

template <std::size_t Rows, std::size_t Columns>
struct Form<std::array<std::array<double, Columns>, Rows>> {
  static std::string type() { return "numpy.ndarray"; }
  static py::object get(std::array<std::array<double, Columns>, Rows>& value, py::handle) { return matrix(value); }
  static void set(std::array<std::array<double, Columns>, Rows>& place, py::handle value) {
    place = value.cast<std::array<std::array<double, Columns>, Rows>>();
  }
};

/// Texts that the library holds as views.
template <>
struct Form<std::string_view> {
  static std::string type() { return "str"; }
  static py::object get(std::string_view& value, py::handle) { return py::cast(value); }
  static void set(std::string_view& place, py::handle value) { place = kept(value.cast<std::string>()); }
};

template <>
struct Form<std::vector<std::string_view>> {
  static std::string type() { return "List[str]"; }
  static py::object get(std::vector<std::string_view>& value, py::handle) { return py::cast(value); }
  static void set(std::vector<std::string_view>& place, py::handle value) {
    place.clear();
    for (const auto& text : value.cast<std::vector<std::string>>()) place.push_back(kept(text));
  }
};

namespace detail {

template <auto Member>
struct MemberOf;
template <class T, class M, M T::*Member>
struct MemberOf<Member> {
  using Class = T;
  using Type = M;
};

template <auto Member>
py::object get(py::handle record) {
  using Of = MemberOf<Member>;
  return Form<typename Of::Type>::get(record.cast<typename Of::Class&>().*Member, record);
}

template <auto Member>
void set(void* record, py::handle value) {
  using Of = MemberOf<Member>;
  Form<typename Of::Type>::set(static_cast<typename Of::Class*>(record)->*Member, value);
}

}  // namespace detail

/// A value type as a class.
template <class T>
class Record {
 public:
  Record(py::module_& m, const char* name, const char* doc, Made made = Made::by_library) : class_(m, name, doc) {
    class_.attr("_fields") = py::tuple();
    class_.attr("__annotations__") = py::dict();
    add_makers(
        class_, [] { return static_cast<void*>(new T{}); }, made);
  }

  /// A field that a constructor must be given.
  template <auto Member>
  Record& field(const char* name, const char* doc) {
    return add<Member>(name, doc, true);
  }

  /// A field with a default.
  template <auto Member>
  Record& optional(const char* name, const char* doc) {
    return add<Member>(name, doc, false);
  }

  /// A field that is no member: by a function that tells it, `py::object (*)(T&)`, and one that takes it back, `void
  /// (*)(T&, py::handle)`. Fields are set in their order.
  template <auto Get, auto Set>
  Record& told(const char* name, const char* type, const char* doc) {
    add_field(class_,
              {name, type, [](py::handle record) -> py::object { return Get(record.cast<T&>()); },
               [](void* record, py::handle value) { Set(*static_cast<T*>(record), value); }, true},
              doc);
    return *this;
  }

  py::class_<T>& of() { return class_; }

 private:
  template <auto Member>
  Record& add(const char* name, const char* doc, bool required) {
    add_field(class_,
              {name, Form<typename detail::MemberOf<Member>::Type>::type(), detail::get<Member>, detail::set<Member>,
               required},
              doc);
    return *this;
  }

  py::class_<T> class_;
};

}  // namespace swayaw::python
