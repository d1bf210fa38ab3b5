#include "swayaw/core/mat_file.hpp"

#include <algorithm>
#include <cstdint>
#include <memory>

#include "mat_variable.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/core/version.hpp"

namespace swayaw::inline core {

MatValue mat_number(double value) { return {MatNumbers{1, 1, {value}}}; }

MatValue mat_column(std::vector<double> values) { return {MatNumbers{values.size(), 1, std::move(values)}}; }

MatValue mat_texts(const std::vector<std::string>& texts) {
  MatCell cell{};
  for (const auto& text : texts) cell.values.push_back({text});
  return {std::move(cell)};
}

std::string mat_name(std::string_view name) {
  constexpr std::size_t longest = 63;
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto is_allowed = [&](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_'; };
  std::string result = !name.empty() && is_letter(name.front()) ? "" : "x";
  for (const char c : name)
    if ((c & 0xC0) != 0x80) result += is_allowed(c) ? c : '_';  // one '_' for a character of several bytes
  return result.substr(0, longest);
}

bool is_mat(const std::filesystem::path& file) { return file.extension() == ".mat"; }

#ifndef SWAYAW_MATIO

std::vector<MatVariable> read_mat(const std::filesystem::path& file, FileUse) {
  throw FileError({file, 1, 1}, "MATLAB files need a swayaw built with libmatio");
}

void write_mat(const std::filesystem::path& file, const std::vector<MatVariable>&) {
  throw FileError({.file = file}, "MATLAB files need a swayaw built with libmatio");
}

#else
namespace {

using namespace detail;

// ---------------------------------------------------------------- reading

MatValue value_of(const matvar_t& variable);

bool is_row(const matvar_t& variable) { return variable.rank == 2 && variable.dims[0] == 1 && variable.dims[1] > 1; }

MatStruct element_of(const matvar_t& variable, std::size_t element) {
  MatStruct result;
  for (const auto& name : field_names(variable))
    if (const auto* value = field(variable, name.c_str(), element)) result.fields.push_back({name, value_of(*value)});
  return result;
}

MatValue struct_of(const matvar_t& variable) {
  // of any number, none of which holds a thing: a damaged file of 550 bytes has four billion of them
  if (field_names(variable).empty()) return {MatStruct{}};
  if (count_of(variable) == 1) return {element_of(variable, 0)};
  MatCell elements{.values = {}, .is_row = is_row(variable)};
  for (std::size_t k = 0; k < count_of(variable); ++k) elements.values.push_back({element_of(variable, k)});
  return {std::move(elements)};
}

MatValue cell_of(const matvar_t& variable) {
  MatCell cell{.values = {}, .is_row = is_row(variable)};
  const auto* values = static_cast<matvar_t* const*>(variable.data);
  for (std::size_t i = 0; values != nullptr && i < count_of(variable); ++i)
    cell.values.push_back(values[i] != nullptr ? value_of(*values[i]) : MatValue{MatNumbers{0, 0, {}}});
  return {std::move(cell)};
}

MatValue text_value_of(const matvar_t& variable) {
  const auto rows = rows_of_text(variable);
  if (rows.size() == 1) return {rows.front()};
  return count_of(variable) == 0 ? MatValue{std::string{}} : mat_texts(rows);
}

MatValue number_value_of(const matvar_t& variable) {
  if (variable.rank != 2) return {MatOther{"an array of more than two dimensions"}};
  if (count_of(variable) == 0) return {MatNumbers{variable.dims[0], variable.dims[1], {}}};
  auto values = numbers_of(variable);
  if (values.empty()) return {MatOther{variable.isComplex != 0 ? "complex numbers" : "numbers that cannot be read"}};
  if (variable.isLogical != 0 && values.size() == 1) return {values.front() != 0.0};
  return {MatNumbers{variable.dims[0], variable.dims[1], std::move(values)}};
}

MatValue value_of(const matvar_t& variable) {
  switch (variable.class_type) {
    case MAT_C_STRUCT: return struct_of(variable);
    case MAT_C_CELL: return cell_of(variable);
    case MAT_C_CHAR: return text_value_of(variable);
    case MAT_C_EMPTY: return {MatNumbers{0, 0, {}}};
    case MAT_C_SPARSE: return {MatOther{"a sparse matrix"}};
    case MAT_C_FUNCTION: return {MatOther{"a function"}};
    case MAT_C_OBJECT:
    case MAT_C_OPAQUE: return {MatOther{"an object of a class that only MATLAB reads"}};
    default: return number_value_of(variable);
  }
}

// ---------------------------------------------------------------- writing

/// Characters of 16 bits, as MATLAB keeps them; '?' for those that need more.
std::vector<std::uint16_t> wide_text(std::string_view text) {
  std::vector<std::uint16_t> wide;
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = [&](std::size_t k) { return i + k < text.size() ? static_cast<unsigned char>(text[i + k]) : 0U; };
    const std::size_t size = byte(0) < 0x80 ? 1 : byte(0) < 0xE0 ? 2 : byte(0) < 0xF0 ? 3 : 4;
    const unsigned code = size == 1   ? byte(0)
                          : size == 2 ? (byte(0) & 0x1F) << 6 | (byte(1) & 0x3F)
                          : size == 3 ? (byte(0) & 0x0F) << 12 | (byte(1) & 0x3F) << 6 | (byte(2) & 0x3F)
                                      : '?';
    wide.push_back(static_cast<std::uint16_t>(code));
    i += size;
  }
  return wide;
}

matvar_t* made(const char* name, const MatValue& value);

/// An array of `rows` x `columns`, whose data libmatio copies, or owns if they are variables.
matvar_t* array(const char* name, matio_classes kind, matio_types type, std::size_t rows, std::size_t columns,
                const void* data, int options = 0) {
  std::size_t dims[2] = {rows, columns};
  return Mat_VarCreate(name, kind, type, 2, dims, const_cast<void*>(data), options);
}

struct MadeBy {
  const char* name;

  matvar_t* operator()(const MatNumbers& n) const {
    return array(name, MAT_C_DOUBLE, MAT_T_DOUBLE, n.rows, n.columns, n.values.data());
  }
  matvar_t* operator()(bool value) const {
    const std::uint8_t byte = value ? 1 : 0;
    return array(name, MAT_C_UINT8, MAT_T_UINT8, 1, 1, &byte, MAT_F_LOGICAL);
  }
  matvar_t* operator()(const std::string& text) const {
    const auto wide = wide_text(text);
    return array(name, MAT_C_CHAR, MAT_T_UINT16, wide.empty() ? 0 : 1, wide.size(), wide.data());
  }
  matvar_t* operator()(const MatCell& cell) const {
    std::vector<matvar_t*> values;
    for (const auto& value : cell.values) values.push_back(made(nullptr, value));
    const auto count = values.size();
    return array(name, MAT_C_CELL, MAT_T_CELL, cell.is_row ? 1 : count, cell.is_row ? count : 1, values.data());
  }
  matvar_t* operator()(const MatStruct& record) const {
    std::vector<matvar_t*> fields;
    for (const auto& field : record.fields) fields.push_back(made(field.name.c_str(), field.value));
    fields.push_back(nullptr);
    return array(name, MAT_C_STRUCT, MAT_T_STRUCT, 1, 1, fields.data());
  }
  matvar_t* operator()(const MatOther&) const { return array(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 0, 0, nullptr); }
};

matvar_t* made(const char* name, const MatValue& value) { return std::visit(MadeBy{name}, value.is); }

bool write_variable(mat_t& mat, const MatVariable& variable) {
  const std::unique_ptr<matvar_t, void (*)(matvar_t*)> made_one(made(variable.name.c_str(), variable.value),
                                                                &Mat_VarFree);
  return made_one && Mat_VarWrite(&mat, made_one.get(), MAT_COMPRESSION_NONE) == 0;
}

}  // namespace

std::vector<MatVariable> read_mat(const std::filesystem::path& file, FileUse use) {
  std::vector<MatVariable> variables;
  for_each_variable(
      file,
      [&](const matvar_t& each) {
        variables.push_back({each.name, value_of(each)});
      },
      use);
  return variables;
}

void write_mat(const std::filesystem::path& file, const std::vector<MatVariable>& variables) {
  write_draft(file, [&](const std::filesystem::path& draft) {
    Mat_LogInitFunc("swayaw", [](int, char*) {});
    const auto heading = "MATLAB 5.0 MAT-file, swayaw " + std::string(version());
    const std::unique_ptr<mat_t, int (*)(mat_t*)> mat(Mat_CreateVer(draft.c_str(), heading.c_str(), MAT_FT_MAT5),
                                                      &Mat_Close);
    return mat && std::ranges::all_of(variables, [&](const auto& each) { return write_variable(*mat, each); });
  });
}
#endif

}  // namespace swayaw::core
