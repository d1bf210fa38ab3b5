#include "swayaw/nonlinear/ship_file.hpp"

#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/parts_reader.hpp"

namespace swayaw {

Ship parse_ship(std::string_view text, const std::filesystem::path& name) {
  const PartsReader file(text, name);
  file.require_model("mmg");
  MmgShip<double> model{};
  auto head = file.read(file_numbers(model));
  return {.name = std::move(head.name), .model = model, .confidence = std::move(head.confidence)};
}

Ship read_ship(const std::filesystem::path& file) { return parse_ship(read_text(file), file); }

}  // namespace swayaw
