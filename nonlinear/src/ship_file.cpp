#include "swayaw/nonlinear/ship_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/parts_reader.hpp"

namespace swayaw {
namespace {

template <class Model>
ShipFileHead read_into(Model& model, const PartsReader& file) {
  return file.read(file_numbers(model), file_choices(model));
}

// ---------------------------------------------------------------- what a model asks beyond its lists

void require_consistent(const MmgShip<double>& ship, const PartsReader& file) {
  if (!ship.engine.torque_limited()) return;
  if (ship.engine.Q_max == 0.0) file.fail("engine", "kind", "a torque limited engine needs torque_limit_kN_m");
  if (ship.propeller.q_0 == 0.0) file.fail("engine", "kind", "a torque limited engine needs the torque curve kq in [propeller]");
}

// ---------------------------------------------------------------- effects

/// Where the number of an effect goes.
struct EffectNumber {
  std::string_view key;
  double* value;
};

void read_effect(const FileEffect& effect, std::span<const EffectNumber> numbers, const PartsReader& file) {
  for (const auto& [key, value] : effect.numbers)
    if (std::ranges::find(numbers, key, &EffectNumber::key) == numbers.end())
      file.fail(effect, fmt::format("{} is not a number of {}", key, effect.kind));
  for (const auto& n : numbers) {
    const auto found = std::ranges::find(effect.numbers, n.key, &std::pair<std::string, double>::first);
    if (found == effect.numbers.end()) file.fail(effect, fmt::format("{} needs {}", effect.kind, n.key));
    *n.value = found->second;
  }
}

Surroundings<double> surroundings_of(const PartsReader& file) {
  Surroundings<double> around;
  for (const auto& effect : file.effects()) {
    if (effect.kind == "steady_current")
      read_effect(effect, std::array{EffectNumber{"current_speed_m_s", &around.current.speed}, EffectNumber{"current_to_rad", &around.current.to}}, file);
    else file.fail(effect, fmt::format("effect {} is not understood by this version", effect.kind));
  }
  return around;
}

template <class Model>
Ship read_as(const PartsReader& file) {
  Model model{};
  auto head = read_into(model, file);
  require_consistent(model, file);
  return {.name = std::move(head.name), .model = model, .confidence = std::move(head.confidence), .surroundings = surroundings_of(file)};
}

}  // namespace

Ship parse_ship(std::string_view text, const std::filesystem::path& name) {
  const PartsReader file(text, name);
  file.require_model("mmg");
  return read_as<MmgShip<double>>(file);
}

Ship read_ship(const std::filesystem::path& file) { return parse_ship(read_text(file), file); }

}  // namespace swayaw
