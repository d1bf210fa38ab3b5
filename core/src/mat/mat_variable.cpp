#include "mat_variable.hpp"

#ifdef SWAYAW_MATIO
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <memory>
#include <new>
#include <string_view>
#include <system_error>

#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/detail/csv_text.hpp"
#include "swayaw/core/refusal.hpp"
#include "trial_reading.hpp"

namespace swayaw::inline core::detail {
namespace {

template <class Number>
void append(const matvar_t& variable, std::size_t count, std::vector<double>& values) {
  const auto* data = static_cast<const Number*>(variable.data);
  for (std::size_t i = 0; i < count; ++i) values.push_back(static_cast<double>(data[i]));
}

/// A character of 16 bits in UTF-8; '?' for half of one.
void append_character(std::string& text, unsigned code) {
  if (code < 0x80) text += static_cast<char>(code);
  else if (code >= 0xD800 && code < 0xE000) text += '?';
  else {
    if (code < 0x800) text += static_cast<char>(0xC0 | code >> 6);
    else text += {static_cast<char>(0xE0 | code >> 12), static_cast<char>(0x80 | (code >> 6 & 0x3F))};
    text += static_cast<char>(0x80 | (code & 0x3F));
  }
}

/// Why a file is not read. Octave saves a text of its own unless it is told otherwise.
std::string_view what_else_it_is(const std::filesystem::path& file) {
  std::string begin(19, '\0');
  std::ifstream(file, std::ios::binary).read(begin.data(), static_cast<std::streamsize>(begin.size()));
  return begin == "# Created by Octave" ? "a text file of Octave; save('-v7', ...) makes a MATLAB file"
                                        : "not a MATLAB file of version 4 to 7.3, or it cannot be read";
}

/// Bytes of the data of a variable whose description was read; a number, for a file may claim any dimensions.
double bytes_of(const matvar_t& variable) {
  double count = 1.0;
  for (int i = 0; i < variable.rank; ++i) count *= static_cast<double>(variable.dims[i]);
  const bool has_parts = variable.class_type == MAT_C_STRUCT || variable.class_type == MAT_C_CELL;
  if (!has_parts) return count * static_cast<double>(Mat_SizeOfClass(variable.class_type));
  double bytes = static_cast<double>(variable.nbytes);
  const auto* parts = static_cast<matvar_t* const*>(variable.data);
  for (std::size_t i = 0; parts != nullptr && i < variable.nbytes / sizeof(matvar_t*); ++i)
    if (parts[i] != nullptr) bytes += bytes_of(*parts[i]);
  return bytes;
}

/// What MATLAB compressed may be a thousand times as large when it is read.
void require_size(const std::filesystem::path& file, double bytes, FileUse use) {
  if (const auto most = static_cast<double>(largest_file(use)); bytes > most)
    throw FileError({.file = file}, fmt::format("its variables have {:.4g} MB, and up to {:.4g} MB are read here; "
                                                "--max-file-size {:.0f}MB reads it",
                                                1e-6 * bytes, 1e-6 * most, std::ceil(1e-6 * bytes)));
}

/// Numbers of a variable may be stored as bytes, an eighth of a double, and these compressed to a 1032nd, the least
/// that deflate makes of them. A variable that claims more than that of the file is not there: libmatio makes room for
/// it, and leaves what it does not find as the memory was.
void require_room_in_file(const std::filesystem::path& file, const mat_t& mat, const matvar_t& variable, double bytes) {
  std::error_code unknown;
  const auto size = static_cast<double>(std::filesystem::file_size(file, unknown));
  const bool compressed =
      variable.compression != MAT_COMPRESSION_NONE || Mat_GetVersion(const_cast<mat_t*>(&mat)) == MAT_FT_MAT73;
  if (unknown || bytes <= 8.0 * size * (compressed ? 1032.0 : 1.0)) return;
  throw FileError({file, 1, 1}, fmt::format("is damaged: a variable claims {:.4g} MB, and the file has {:.4g} MB",
                                            1e-6 * bytes, 1e-6 * size));
}

/// Whether there are numbers, texts or parts in it.
bool has_values(const matvar_t& variable) {
  return variable.class_type != MAT_C_SPARSE && variable.class_type != MAT_C_FUNCTION &&
         variable.class_type != MAT_C_OBJECT && variable.class_type != MAT_C_OPAQUE;
}

std::atomic<bool> out_of_memory{false};

bool speaks_of_memory(const char* message) {
  const std::string_view words(message);
  return words.find("memory") != std::string_view::npos || words.find("allocat") != std::string_view::npos;
}

void read_variables(const std::filesystem::path& file, const std::function<void(const matvar_t&)>& f, FileUse use) {
  // what is wrong is said by what could not be read, but for memory, without which the library goes on
  out_of_memory = false;
  Mat_LogInitFunc("swayaw", [](int, char* message) {
    if (speaks_of_memory(message)) out_of_memory = true;
  });
  const std::unique_ptr<mat_t, int (*)(mat_t*)> mat(Mat_Open(file.c_str(), MAT_ACC_RDONLY), &Mat_Close);
  if (!mat) throw FileError({file, 1, 1}, what_else_it_is(file));
  using Variable = std::unique_ptr<matvar_t, void (*)(matvar_t*)>;
  double bytes = 0.0;
  while (const auto variable = Variable(Mat_VarReadNextInfo(mat.get()), &Mat_VarFree)) {
    if (has_values(*variable)) {
      require_room_in_file(file, *mat, *variable, bytes_of(*variable));
      require_size(file, bytes += bytes_of(*variable), use);
      Mat_VarReadDataAll(mat.get(), variable.get());
    }
    if (out_of_memory) throw std::bad_alloc();
    if (variable->name != nullptr && *variable->name != '\0') f(*variable);
  }
}

}  // namespace

void for_each_variable(const std::filesystem::path& file, const std::function<void(const matvar_t&)>& f, FileUse use) {
  require_regular_file(file, use);
  require_harmless(file, [&] { read_variables(file, f, use); });
  read_variables(file, f, use);
}

std::size_t count_of(const matvar_t& variable) {
  std::size_t count = 1;
  for (int i = 0; i < variable.rank; ++i) count *= variable.dims[i];
  return variable.rank > 0 ? count : 0;
}

std::vector<double> numbers_of(const matvar_t& variable) {
  std::vector<double> values;
  const auto count = count_of(variable);
  if (variable.data == nullptr || variable.isComplex != 0 || count == 0) return values;
  if (variable.nbytes < count * static_cast<std::size_t>(variable.data_size)) return values;
  switch (variable.class_type) {
    case MAT_C_DOUBLE: append<double>(variable, count, values); break;
    case MAT_C_SINGLE: append<float>(variable, count, values); break;
    case MAT_C_INT8: append<std::int8_t>(variable, count, values); break;
    case MAT_C_UINT8: append<std::uint8_t>(variable, count, values); break;
    case MAT_C_INT16: append<std::int16_t>(variable, count, values); break;
    case MAT_C_UINT16: append<std::uint16_t>(variable, count, values); break;
    case MAT_C_INT32: append<std::int32_t>(variable, count, values); break;
    case MAT_C_UINT32: append<std::uint32_t>(variable, count, values); break;
    case MAT_C_INT64: append<std::int64_t>(variable, count, values); break;
    case MAT_C_UINT64: append<std::uint64_t>(variable, count, values); break;
    default: break;
  }
  return values;
}

std::vector<std::string> rows_of_text(const matvar_t& variable) {
  if (variable.class_type != MAT_C_CHAR || variable.data == nullptr || variable.rank != 2) return {};
  const std::size_t rows = variable.dims[0], length = variable.dims[1];
  const auto size = static_cast<std::size_t>(variable.data_size);
  if (variable.nbytes < rows * length * size || (size != 1 && size != 2)) return {};
  const auto* bytes = static_cast<const unsigned char*>(variable.data);
  std::vector<std::string> texts(rows);
  for (std::size_t i = 0; i < rows * length; ++i) {
    std::uint16_t wide = 0;
    if (size == 2) std::memcpy(&wide, bytes + 2 * i, 2);
    if (size == 2) append_character(texts[i % rows], wide);
    else texts[i % rows] += static_cast<char>(bytes[i]);
  }
  for (auto& text : texts) text = std::string(trimmed(text.substr(0, text.find('\0'))));
  return texts;
}

std::string text_of(const matvar_t* variable) {
  const auto rows = variable == nullptr ? std::vector<std::string>{} : rows_of_text(*variable);
  return rows.size() == 1 ? rows.front() : std::string{};
}

std::vector<std::string> names_in(const matvar_t& variable) {
  if (variable.class_type != MAT_C_CELL || variable.data == nullptr) return rows_of_text(variable);
  std::vector<std::string> names;
  const auto* cells = static_cast<matvar_t* const*>(variable.data);
  for (std::size_t i = 0; i < count_of(variable); ++i) names.push_back(text_of(cells[i]));
  const bool all = std::ranges::none_of(names, [](const auto& name) { return name.empty(); });
  return all ? names : std::vector<std::string>{};
}

bool is_vector(const matvar_t& variable) {
  return variable.rank == 2 && (variable.dims[0] == 1 || variable.dims[1] == 1) && count_of(variable) > 1;
}

bool is_matrix(const matvar_t& variable) { return variable.rank == 2 && variable.dims[0] > 1 && variable.dims[1] > 1; }

std::vector<std::string> field_names(const matvar_t& variable) {
  const auto count = Mat_VarGetNumberOfFields(const_cast<matvar_t*>(&variable));
  char* const* names = Mat_VarGetStructFieldnames(&variable);
  return names == nullptr || variable.data == nullptr ? std::vector<std::string>{}
                                                      : std::vector<std::string>(names, names + count);
}

const matvar_t* field(const matvar_t& variable, const char* name, std::size_t element) {
  const bool is_whole = variable.data != nullptr && Mat_VarGetStructFieldnames(&variable) != nullptr;
  return is_whole ? Mat_VarGetStructFieldByName(const_cast<matvar_t*>(&variable), name, element) : nullptr;
}

}  // namespace swayaw::core::detail
#endif
