#include "mat_table.hpp"
#include "swayaw/core/import.hpp"

namespace swayaw::inline core {

Import import_mat(const std::filesystem::path& file, const ImportOptions& options) {
  const auto table = detail::read_mat_table(file);
  auto result = import_table_text(table.text, file, options);
  result.notes.insert(result.notes.begin(), table.notes.begin(), table.notes.end());
  return result;
}

}  // namespace swayaw::core
