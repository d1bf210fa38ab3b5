#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "swayaw/core/file_limits.hpp"

/// Variables of MATLAB files as values, for recordings, ships and linear models (docs/matlab.md).
namespace swayaw::inline core {

struct MatValue;
struct MatVariable;

/// Real numbers of any class, column by column as MATLAB has them.
struct MatNumbers {
  std::size_t rows;
  std::size_t columns;
  std::vector<double> values;
};

/// Values of different kinds: a cell array, or an array of structs.
struct MatCell {
  std::vector<MatValue> values;
  bool is_row = false;  ///< in a row of several; else a column
};

struct MatStruct {
  std::vector<MatVariable> fields;
};

/// What a file holds and no other kind stands for: complex numbers, objects, functions, arrays of more dimensions.
struct MatOther {
  std::string what;  ///< "complex numbers"
};

struct MatValue {
  std::variant<MatNumbers, bool, std::string, MatCell, MatStruct, MatOther> is;
};

/// A variable of a file, or a field of a struct.
struct MatVariable {
  std::string name;
  MatValue value;
};

/// One number; a column of numbers.
MatValue mat_number(double value);
MatValue mat_column(std::vector<double> values);

/// Texts in a cell array.
MatValue mat_texts(const std::vector<std::string>& texts);

/// The name as MATLAB allows it: letters, digits and '_', a letter first, no more than 63; others become '_'.
std::string mat_name(std::string_view name);

/// Whether the file's ending is that of MATLAB files.
bool is_mat(const std::filesystem::path& file);

/// All variables of a file, versions 4 to 7.3.
/// @throws FileError  if it is none, too large (`largest_file`), or swayaw was built without libmatio
std::vector<MatVariable> read_mat(const std::filesystem::path& file, FileUse use = FileUse::samples);

/// Writes them, all or nothing, in version 5, which MATLAB and Octave load.
/// @throws FileError  if the file cannot be written, or swayaw was built without libmatio
void write_mat(const std::filesystem::path& file, const std::vector<MatVariable>& variables);

}  // namespace swayaw::core
