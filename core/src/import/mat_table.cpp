#include "mat_table.hpp"

#include "swayaw/core/import.hpp"
#include "swayaw/core/refusal.hpp"

#ifdef SWAYAW_MATIO
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "../mat/mat_variable.hpp"
#include "../run_keys.hpp"
#include "swayaw/core/detail/csv_text.hpp"
#endif

namespace swayaw::inline core {

std::string table_of_mat(const std::filesystem::path& file) { return detail::read_mat_table(file).text; }

}  // namespace swayaw::core

namespace swayaw::inline core::detail {

#ifndef SWAYAW_MATIO

MatTable read_mat_table(const std::filesystem::path& file) {
  throw FileError({file, 1, 1}, "MATLAB files need a swayaw built with libmatio; or give the columns as text");
}

#else
namespace {

struct MatColumn {
  std::string name;
  std::vector<double> values;
  std::vector<double> time = {};  ///< of its own, in place of a column of the file
};

// ---------------------------------------------------------------- the file

class MatReader {
 public:
  explicit MatReader(const std::filesystem::path& file) : file_(file) {}

  MatTable read() {
    read_variables();
    for (const auto& matrix : matrices_) add_matrix(matrix);
    if (columns_.empty()) refuse("no numbers in columns: no variable is a vector, a matrix or a struct of vectors");
    join_times();
    keep_one_length();
    return {table(), std::move(notes_)};
  }

 private:
  struct Matrix {
    std::string name;
    std::size_t rows, columns;
    std::vector<double> values;
  };

  [[noreturn]] void refuse(std::string_view what) const { throw FileError({file_, 1, 1}, what); }

  void read_variables() {
    for_each_variable(file_, [&](const matvar_t& variable) { add(variable, variable.name); });
  }

  void add(const matvar_t& variable, const std::string& name) {
    if (variable.class_type == MAT_C_STRUCT) return add_struct(variable, name);
    if (std::ranges::count(run_keys, name) > 0 && add_fact(variable, name)) return;
    if (auto names = names_in(variable); names.size() > 1) return names_.push_back(std::move(names));
    if (!is_vector(variable) && !is_matrix(variable)) return;
    auto values = numbers_of(variable);
    if (values.empty()) notes_.push_back(fmt::format("variable {} holds no real numbers; left out", shown(name)));
    else if (is_vector(variable)) columns_.push_back({name, std::move(values)});
    else matrices_.push_back({name, variable.dims[0], variable.dims[1], std::move(values)});
  }

  /// What recordings say above their columns. @return whether it is one text or number
  bool add_fact(const matvar_t& variable, const std::string& name) {
    const auto text = text_of(&variable);
    const auto numbers = text.empty() ? numbers_of(variable) : std::vector<double>{};
    if (text.empty() && numbers.size() != 1) return false;
    facts_ += fmt::format("# {} = {}\n", name,
                          !text.empty()        ? in_quotes(text)
                          : variable.isLogical ? (numbers.front() != 0.0 ? "true" : "false")
                                               : fmt::format("{}", numbers.front()));
    return true;
  }

  // -------------------------------------------------------------- structs

  void add_struct(const matvar_t& variable, const std::string& name) {
    if (count_of(variable) == 1 && add_timeseries(variable, name)) return;
    for (const auto& each : field_names(variable)) {
      if (count_of(variable) > 1) add_field_of_array(variable, each.c_str());
      else if (const auto* value = field(variable, each.c_str())) add(*value, each);
    }
  }

  /// A struct of Time and Data, as timeseries become when they are saved as structs.
  bool add_timeseries(const matvar_t& variable, const std::string& name) {
    const auto either = [&](const char* capital, const char* small) {
      const auto* found = field(variable, capital);
      return found != nullptr ? found : field(variable, small);
    };
    const auto *time = either("Time", "time"), *data = either("Data", "data");
    if (time == nullptr || data == nullptr) return false;
    MatColumn column{name, numbers_of(*data), numbers_of(*time)};
    if (const auto said = text_of(either("Name", "name")); !said.empty()) column.name = said;
    const bool fits = column.values.size() > 1 && column.values.size() == column.time.size();
    if (fits) columns_.push_back(std::move(column));
    return fits;
  }

  /// A number in each element of an array of structs.
  void add_field_of_array(const matvar_t& variable, const char* name) {
    MatColumn column{name, {}};
    for (std::size_t k = 0; k < count_of(variable); ++k) {
      const auto* value = field(variable, name, k);
      const auto numbers = value != nullptr ? numbers_of(*value) : std::vector<double>{};
      if (numbers.size() > 1) return;
      column.values.push_back(numbers.empty() ? std::nan("") : numbers.front());
    }
    columns_.push_back(std::move(column));
  }

  // -------------------------------------------------------------- matrices

  /// Columns of a matrix; its rows, where the names are as many as those.
  void add_matrix(const Matrix& matrix) {
    const auto fits = [&](std::size_t count) {
      return [count](const std::vector<std::string>& names) { return names.size() == count; };
    };
    auto names = std::ranges::find_if(names_, fits(matrix.columns));
    const bool by_rows = names == names_.end() && std::ranges::any_of(names_, fits(matrix.rows));
    if (by_rows) names = std::ranges::find_if(names_, fits(matrix.rows));
    const auto count = by_rows ? matrix.rows : matrix.columns, length = by_rows ? matrix.columns : matrix.rows;
    for (std::size_t k = 0; k < count; ++k) {
      MatColumn column{names != names_.end() ? (*names)[k] : fmt::format("{}_{}", matrix.name, k + 1), {}};
      for (std::size_t i = 0; i < length; ++i)
        column.values.push_back(matrix.values[by_rows ? k + i * count : i + k * length]);
      columns_.push_back(std::move(column));
    }
  }

  // -------------------------------------------------------------- one table

  /// Columns with times of their own come to all of these times.
  void join_times() {
    std::vector<double> all;
    for (const auto& column : columns_) all.insert(all.end(), column.time.begin(), column.time.end());
    std::erase_if(all, [](double time) { return !std::isfinite(time); });
    if (all.empty()) return;
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    for (auto& column : columns_)
      if (!column.time.empty()) column.values = at_times(column, all);
    columns_.insert(columns_.begin(), {"Time", std::move(all)});
  }

  static std::vector<double> at_times(const MatColumn& column, const std::vector<double>& all) {
    std::vector<double> values(all.size(), std::nan(""));
    for (std::size_t i = 0; i < column.time.size(); ++i)
      if (std::isfinite(column.time[i]))
        values[static_cast<std::size_t>(std::ranges::lower_bound(all, column.time[i]) - all.begin())] =
            column.values[i];
    return values;
  }

  /// The length that most columns have; of lengths that are equally frequent the greater.
  void keep_one_length() {
    std::map<std::size_t, std::size_t> columns_of;
    for (const auto& column : columns_) ++columns_of[column.values.size()];
    const auto most = std::ranges::max_element(columns_of, [](const auto& a, const auto& b) {
      return std::pair(a.second, a.first) < std::pair(b.second, b.first);
    });
    const auto length = most->first;
    for (const auto& column : columns_)
      if (column.values.size() != length)
        notes_.push_back(fmt::format("variable {} has {} numbers and most have {}; left out", shown(column.name),
                                     column.values.size(), length));
    std::erase_if(columns_, [&](const auto& column) { return column.values.size() != length; });
  }

  std::string table() const {
    fmt::memory_buffer out;
    auto to = fmt::appender(out);
    fmt::format_to(to, "{}", facts_);
    std::map<std::string, int> met;
    for (const auto& column : columns_) {
      const int before = met[column.name]++;
      const auto name = before > 0 ? fmt::format("{}_{}", column.name, before + 1) : column.name;
      fmt::format_to(to, "{}{}", &column == &columns_.front() ? "" : ",", cell_naming(name));
    }
    for (std::size_t i = 0; i < columns_.front().values.size(); ++i) {
      out.push_back('\n');
      for (const auto& column : columns_) {
        if (&column != &columns_.front()) out.push_back(',');
        if (std::isfinite(column.values[i])) fmt::format_to(to, "{}", column.values[i]);
      }
    }
    out.push_back('\n');
    return fmt::to_string(out);
  }

  std::filesystem::path file_;
  std::string facts_;
  std::vector<MatColumn> columns_;
  std::vector<Matrix> matrices_;
  std::vector<std::vector<std::string>> names_;  ///< lists of names met
  std::vector<std::string> notes_;
};

}  // namespace

MatTable read_mat_table(const std::filesystem::path& file) { return MatReader(file).read(); }
#endif

}  // namespace swayaw::core::detail
