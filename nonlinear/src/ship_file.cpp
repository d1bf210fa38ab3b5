#include "swayaw/nonlinear/ship_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/parts_reader.hpp"
#include "swayaw/core/parts_writer.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/mmg_labels.hpp"
#include "swayaw/nonlinear/windage_sources.hpp"

namespace swayaw {
namespace {

// ---------------------------------------------------------------- what a model asks beyond its lists

void require_consistent(const MmgShip<double>& ship, const PartsReader& file) {
  if (!ship.engine.torque_limited()) return;
  if (ship.engine.Q_max == 0.0) file.fail("engine", "kind", "a torque limited engine needs torque_limit_kN_m");
  if (ship.propeller.q_0 == 0.0) file.fail("engine", "kind", "a torque limited engine needs the torque curve kq in [propeller]");
}

/// PI and PU ships.
template <class PrimeShip>
void require_consistent(const PrimeShip& ship, const PartsReader& file) {
  const auto& [p, propeller] = std::tie(ship.particulars, ship.propeller);
  constexpr std::string_view rule = "one of inertia_z_kg_m2 and radius_of_gyration_m is needed in [particulars]";
  if (p.I_z == 0.0 && p.k_zz == 0.0) file.fail("particulars", "", fmt::format("{}; none is there", rule));
  if (p.I_z > 0.0 && p.k_zz > 0.0) file.fail("particulars", "radius_of_gyration_m", fmt::format("{}; both are there", rule));
  if (p.I_z > 0.0 && p.I_z <= ship.water.rho * p.nabla * p.x_G * p.x_G)
    file.fail("particulars", "inertia_z_kg_m2", "inertia_z_kg_m2 in [particulars] is about midship and must be larger than m x_G2");
  if (!propeller.wake_changes()) return;
  for (const auto* key : {"x_m", "wake_C1", "wake_C2_positive", "wake_C2_negative"})
    if (!file.has("propeller", key)) file.fail("propeller", "wake", fmt::format("wake = \"mmg\" needs {} in [propeller]", key));
}

void require_consistent(const AbkowitzShip<double>&, const PartsReader&) {}

// ---------------------------------------------------------------- names of a source

/// Puts each number, and the trust in it, under its own name.
void apply_labels(MmgShip<double>& ship, Confidence& confidence) {
  if (ship.hull.labels.index != 0)
    for (auto& [key, deviation] : confidence.named) key = meant_by(key);
  ship.hull = relabelled(ship.hull);
}

template <class Model>
void apply_labels(Model&, Confidence&) {}

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

void read_effects(Surroundings<double>& around, const PartsReader& file) {
  for (const auto& effect : file.effects()) {
    if (effect.kind == "steady_wind") {
      if (around.windage.A_L == 0.0) file.fail(effect, "wind needs frontal and lateral area of the ship, in [windage] or [particulars]");
      read_effect(effect, std::array{EffectNumber{"wind_speed_m_s", &around.wind.speed}, EffectNumber{"wind_from_rad", &around.wind.from}}, file);
      around.windy = around.wind.speed > 0.0;
    } else if (effect.kind == "steady_current")
      read_effect(effect, std::array{EffectNumber{"current_speed_m_s", &around.current.speed}, EffectNumber{"current_to_rad", &around.current.to}}, file);
    else file.fail(effect, fmt::format("effect {} is not understood by this version", effect.kind));
  }
}

// ---------------------------------------------------------------- windage

/// The table [windage] as it stands in the file.
struct WindageTable {
  Windage<double> windage;
  Selection type{.index = -1};
  std::vector<double> angle, C_X, C_Y, C_N;
};

constexpr auto windage_types = [] {
  std::array<std::string_view, blendermann_ships.size()> names;
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = blendermann_ships[i].type;
  return names;
}();

void add_keys(FileKeys& keys, WindageTable& table) {
  add_numbers(keys.numbers, "windage", table.windage);
  keys.choices.push_back({"windage", "type", windage_types, &table.type});
  keys.lists.push_back({"windage", "angle_deg", radians(1.0), &table.angle});
  keys.lists.push_back({"windage", "C_X", 1.0, &table.C_X});
  keys.lists.push_back({"windage", "C_Y", 1.0, &table.C_Y});
  keys.lists.push_back({"windage", "C_N", 1.0, &table.C_N});
}

/// Drag of the type of ship, where the table does not give its own.
void take_type(WindageTable& table, const PartsReader& file) {
  const auto& ship = blendermann_ships[static_cast<std::size_t>(table.type.index)];
  auto& w = table.windage;
  if (!file.has("windage", "transverse_drag")) w.C_Dt = ship.C_Dt;
  if (!file.has("windage", "bow_drag")) w.C_Dl_bow = ship.C_Dl_bow;
  if (!file.has("windage", "stern_drag")) w.C_Dl_stern = ship.C_Dl_stern;
  if (!file.has("windage", "cross_force")) w.delta = ship.delta;
}

WindSpline spline_of(const WindageTable& table, const PartsReader& file) {
  const auto rows = table.angle.size();
  for (const auto& [key, list] : {std::pair{"C_X", &table.C_X}, {"C_Y", &table.C_Y}, {"C_N", &table.C_N}})
    if (list->size() != rows) file.fail("windage", key, fmt::format("{} in [windage] has {} numbers, angle_deg {}", key, list->size(), rows));
  WindTable coefficients;
  for (std::size_t i = 0; i < rows; ++i) coefficients.push_back({table.angle[i], table.C_X[i], table.C_Y[i], table.C_N[i]});
  const bool one_side = std::ranges::max(table.angle) <= pi * (1.0 + 1e-9) && std::ranges::min(table.angle) >= 0.0;
  try {
    return wind_spline(one_side ? both_sides(coefficients) : coefficients);
  } catch (const std::domain_error& trouble) {
    file.fail("windage", "angle_deg", trouble.what());
  }
}

Windage<double> windage_of(WindageTable table, const PartsReader& file) {
  if (table.type.index >= 0) take_type(table, file);
  if (!table.angle.empty()) table.windage.given = spline_of(table, file);
  return table.windage;
}

/// From the areas that [particulars] may have; a ship without them feels no wind.
template <class Model>
Windage<double> windage_of(const Model& model) {
  if constexpr (requires { model.particulars.A_front; }) {
    const auto& p = model.particulars;
    return windage_from({.frontal = p.A_front, .lateral = p.A_lateral, .length = p.L}).value_or(Windage<double>{});
  } else {
    return {};
  }
}

// ---------------------------------------------------------------- the whole

template <class Model>
Ship read_as(const PartsReader& file) {
  Model model{};
  WindageTable table;
  auto keys = file_keys(model);
  const bool own_windage = file.has("windage");
  if (own_windage) add_keys(keys, table);
  auto head = file.read(keys);
  apply_labels(model, head.confidence);
  require_consistent(model, file);
  Surroundings<double> around{.windage = own_windage ? windage_of(table, file) : windage_of(model), .wind = {}, .current = {}};
  read_effects(around, file);
  return {.name = std::move(head.name), .model = model, .confidence = std::move(head.confidence), .surroundings = around};
}

}  // namespace

Ship parse_ship(std::string_view text, const std::filesystem::path& name) {
  const PartsReader file(text, name);
  const auto model = file.model();
  if (model == "pi") return read_as<PiShip<double>>(file);
  if (model == "pu") return read_as<PuShip<double>>(file);
  if (model == "abkowitz") return read_as<AbkowitzShip<double>>(file);
  if (model == "linear") file.fail("", "model", "a ship of a nonlinear model is needed here, got \"linear\"");
  file.require_model("mmg");
  return read_as<MmgShip<double>>(file);
}

// ---------------------------------------------------------------- writing

namespace {

std::string_view model_name(const MmgShip<double>&) { return "mmg"; }
std::string_view model_name(const PiShip<double>&) { return "pi"; }
std::string_view model_name(const PuShip<double>&) { return "pu"; }
std::string_view model_name(const AbkowitzShip<double>&) { return "abkowitz"; }

/// Coefficients over the angle as the lists they were read from.
void add_lists(WindageTable& table) {
  const auto* spline = std::get_if<WindSpline>(&table.windage.given);
  if (std::holds_alternative<WindSeries<>>(table.windage.given)) throw Refusal("wind coefficients that are a Fourier series cannot be written to a ship file");
  if (!spline) return;
  for (std::size_t i = 0; i < spline->X.pieces.size(); ++i) {
    table.angle.push_back(spline->X.pieces[i].start);
    table.C_X.push_back(spline->X.pieces[i].c[0]);
    table.C_Y.push_back(spline->Y.pieces[i].c[0]);
    table.C_N.push_back(spline->N.pieces[i].c[0]);
  }
}

bool same_numbers(const Windage<double>& a, const Windage<double>& b) {
  const auto list = Windage<double>::parameters();
  return std::ranges::all_of(list, [&](const auto& p) { return a.*p.member == b.*p.member; });
}

std::vector<FileEffect> effects_of(const Surroundings<double>& around) {
  std::vector<FileEffect> effects;
  const auto& [speed, from] = around.wind;
  const auto& [drift, to] = around.current;
  if (around.windy) effects.push_back({"steady_wind", {{"wind_speed_m_s", speed}, {"wind_from_rad", from}}, 0, 0});
  if (drift != 0.0) effects.push_back({"steady_current", {{"current_speed_m_s", drift}, {"current_to_rad", to}}, 0, 0});
  return effects;
}

template <class Model>
std::string text_as(const Ship& ship, Model model, std::string_view remark) {
  auto keys = file_keys(model);
  WindageTable table{.windage = ship.surroundings.windage, .type = {}, .angle = {}, .C_X = {}, .C_Y = {}, .C_N = {}};
  add_lists(table);
  const bool own = !table.angle.empty() || !same_numbers(table.windage, windage_of(model));
  if (own) add_keys(keys, table);
  return ship_text(model_name(model), {ship.name, ship.confidence}, keys, effects_of(ship.surroundings), remark);
}

}  // namespace

std::string ship_text(const Ship& ship, std::string_view remark) {
  return std::visit([&](const auto& model) { return text_as(ship, model, remark); }, ship.model);
}

void write_ship(const std::filesystem::path& file, const Ship& ship, std::string_view remark) { write_text(file, ship_text(ship, remark)); }

Ship read_ship(const std::filesystem::path& file) { return parse_ship(read_text(file), file); }

}  // namespace swayaw
