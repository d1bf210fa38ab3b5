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

template <class T>
std::string type_name() {
  if constexpr (std::is_same_v<T, std::vector<double>>) return "numpy.ndarray";
  else {
    static constexpr auto name = py::detail::make_caster<T>::name;
    return annotation(name.text, decltype(name)::types().data());
  }
}

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
  auto& value = record.cast<typename Of::Class&>().*Member;
  if constexpr (std::is_same_v<typename Of::Type, std::vector<double>>) return view(value, record);
  else return py::cast(value, py::return_value_policy::reference_internal, record);
}

template <auto Member>
void set(void* record, py::handle value) {
  using Of = MemberOf<Member>;
  auto& place = static_cast<typename Of::Class*>(record)->*Member;
  if constexpr (std::is_same_v<typename Of::Type, std::string_view>) place = kept(value.cast<std::string>());
  else if constexpr (std::is_same_v<typename Of::Type, std::vector<std::string_view>>) {
    place.clear();
    for (const auto& text : value.cast<std::vector<std::string>>()) place.push_back(kept(text));
  } else if constexpr (std::is_same_v<typename Of::Type, std::vector<double>>)
    place = numbers_in(value.cast<Array>(), "a field");
  else place = value.cast<typename Of::Type>();
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

  py::class_<T>& of() { return class_; }

 private:
  template <auto Member>
  Record& add(const char* name, const char* doc, bool required) {
    add_field(class_,
              {name, type_name<typename detail::MemberOf<Member>::Type>(), detail::get<Member>, detail::set<Member>,
               required},
              doc);
    return *this;
  }

  py::class_<T> class_;
};

}  // namespace swayaw::python
