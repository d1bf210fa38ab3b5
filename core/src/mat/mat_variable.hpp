#pragma once

#ifdef SWAYAW_MATIO
#include <matio.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "swayaw/core/file_limits.hpp"

/// What libmatio reads, as numbers and texts. Not installed.
namespace swayaw::inline core::detail {

/// f(variable) for each variable of a file that has a name.
/// @throws FileError  if it is no MATLAB file, or larger than files of that use may be, compressed or not
void for_each_variable(const std::filesystem::path& file, const std::function<void(const matvar_t&)>& f,
                       FileUse use = FileUse::samples);

std::size_t count_of(const matvar_t& variable);

/// Real numbers in the order of MATLAB, column by column; none for anything else.
std::vector<double> numbers_of(const matvar_t& variable);

/// One text in UTF-8 for each row of a matrix of characters, without blanks around it.
std::vector<std::string> rows_of_text(const matvar_t& variable);

/// The text of a variable that is one row; else empty.
std::string text_of(const matvar_t* variable);

/// Texts of a cell array, or the rows of a matrix of characters.
std::vector<std::string> names_in(const matvar_t& variable);

bool is_vector(const matvar_t& variable);
bool is_matrix(const matvar_t& variable);

/// Names of the fields of a struct, in their order.
std::vector<std::string> field_names(const matvar_t& variable);

/// A field of an element of an array of structs; nullptr where it is empty.
const matvar_t* field(const matvar_t& variable, const char* name, std::size_t element = 0);

}  // namespace swayaw::core::detail
#endif
