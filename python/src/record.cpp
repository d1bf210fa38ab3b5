#include "record.hpp"

#include <algorithm>
#include <deque>
#include <set>
#include <typeindex>
#include <unordered_map>

namespace swayaw::python {
namespace {

/// Fields of all records, by class.
std::vector<Field>& fields_of(py::handle type) {
  static std::unordered_map<PyObject*, std::vector<Field>> all;
  return all[type.ptr()];
}

py::str name_of_class(py::handle type) { return type.attr("__name__"); }

const Field* named_field(const std::vector<Field>& fields, const std::string& name) {
  const auto found = std::ranges::find_if(fields, [&](const Field& f) { return name == f.name; });
  return found == fields.end() ? nullptr : &*found;
}

void set_field(const Field& field, void* record, py::handle value) {
  try {
    field.set(record, value);
  } catch (const py::cast_error&) {
    throw py::type_error(
        fmt::format("{} must be {}, got {}", field.name, field.type, py::repr(value).cast<std::string>()));
  }
}

/// Values of all fields, in their order.
py::tuple values_of_fields(py::handle record) {
  py::list values;
  for (const auto& field : fields_of(py::type::handle_of(record))) values.append(field.get(record));
  return py::tuple(values);
}

/// Sets all fields from such values.
void set_fields(py::handle type, void* record, const py::tuple& values) {
  const auto& fields = fields_of(type);
  if (values.size() != fields.size())
    throw std::domain_error("this was pickled by another version of swayaw, with other fields");
  for (std::size_t i = 0; i < fields.size(); ++i) set_field(fields[i], record, values[i]);
}

/// Sets fields by position and name.
/// @throws py::type_error  for one too many, unknown, twice or missing
void set_fields(py::handle type, void* record, const py::args& args, const py::kwargs& kwargs) {
  const auto& fields = fields_of(type);
  const auto name = name_of_class(type).cast<std::string>();
  if (args.size() > fields.size())
    throw py::type_error(fmt::format("{} has {} fields, got {}", name, fields.size(), args.size()));
  for (std::size_t i = 0; i < args.size(); ++i) set_field(fields[i], record, args[i]);
  for (const auto& [key, value] : kwargs) {
    const auto* field = named_field(fields, key.cast<std::string>());
    if (field == nullptr || field < fields.data() + args.size())
      throw py::type_error(fmt::format("{} {} {}", name, field == nullptr ? "has no field" : "was given twice",
                                       key.cast<std::string>()));
    set_field(*field, record, value);
  }
  for (std::size_t i = args.size(); i < fields.size(); ++i)
    if (fields[i].required && !kwargs.contains(fields[i].name))
      throw py::type_error(fmt::format("{} needs {}", name, fields[i].name));
}

/// A method of a class.
template <class F, class... Extra>
void add_method(py::handle type, const char* name, F&& f, const Extra&... extra) {
  py::setattr(type, name, py::cpp_function(std::forward<F>(f), py::name(name), py::is_method(type), extra...));
}

}  // namespace

std::string_view kept(std::string text) {
  static std::set<std::string, std::less<>> texts;
  return *texts.insert(std::move(text)).first;
}

std::vector<double> numbers_in(const Array& array, std::string_view name) {
  if (array.ndim() != 1) throw std::domain_error(fmt::format("{} must have one dimension, got {}", name, array.ndim()));
  const auto values = array.unchecked<1>();
  std::vector<double> numbers(static_cast<std::size_t>(values.shape(0)));
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = values(static_cast<py::ssize_t>(i));
  return numbers;
}

std::vector<std::vector<double>> rows_in(const Array& array, std::string_view name) {
  if (array.ndim() != 2)
    throw std::domain_error(fmt::format("{} must have two dimensions, got {}", name, array.ndim()));
  const auto values = array.unchecked<2>();
  std::vector<std::vector<double>> rows(static_cast<std::size_t>(values.shape(0)));
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (py::ssize_t k = 0; k < values.shape(1); ++k) rows[i].push_back(values(static_cast<py::ssize_t>(i), k));
  return rows;
}

py::array_t<double> matrix(const std::vector<std::vector<double>>& rows) {
  const std::size_t columns = rows.empty() ? 0 : rows.front().size();
  py::array_t<double> result({rows.size(), columns});
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t k = 0; k < columns; ++k)
      result.mutable_at(static_cast<py::ssize_t>(i), static_cast<py::ssize_t>(k)) = rows[i][k];
  return result;
}

std::string annotation(const char* text, const std::type_info* const* types) {
  std::string result;
  for (const char* c = text; *c != '\0'; ++c) {
    if (*c == '{' || *c == '}') continue;
    if (*c != '%') {
      result += *c;
      continue;
    }
    const auto* info = py::detail::get_type_info(std::type_index(**types++));
    if (info == nullptr) throw std::logic_error("a field of a class that is not registered yet");
    const py::handle type(reinterpret_cast<PyObject*>(info->type));
    result += fmt::format("{}.{}", type.attr("__module__").cast<std::string>(),
                          type.attr("__qualname__").cast<std::string>());
  }
  return result;
}

void add_field(py::handle type, Field field, const char* doc) {
  const py::cpp_function get([get = field.get](py::handle self) { return get(self); }, py::is_method(type));
  const auto property = py::handle(reinterpret_cast<PyObject*>(&PyProperty_Type));
  type.attr(field.name) = property(get, py::none(), py::none(), py::str(doc));
  type.attr("_fields") = py::tuple(type.attr("_fields")) + py::make_tuple(field.name);
  type.attr("__annotations__")[field.name] = field.type;
  fields_of(type).push_back(std::move(field));
}

void add_makers(py::handle type, void* (*blank)(), Made made) {
  using Place = py::detail::value_and_holder;
  add_method(type, "__getstate__", &values_of_fields);
  add_method(
      type, "__setstate__",
      [type, blank](Place& place, const py::tuple& values) {
        place.value_ptr() = blank();  // its holder, made after this, frees it
        set_fields(type, place.value_ptr(), values);
      },
      py::detail::is_new_style_constructor());
  if (made == Made::by_anyone)
    add_method(
        type, "__init__",
        [type, blank](Place& place, const py::args& args, const py::kwargs& kwargs) {
          place.value_ptr() = blank();
          set_fields(type, place.value_ptr(), args, kwargs);
        },
        py::detail::is_new_style_constructor());
}

}  // namespace swayaw::python
