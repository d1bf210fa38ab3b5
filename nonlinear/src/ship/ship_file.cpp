#include "swayaw/nonlinear/ship_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/detail/spelling.hpp"
#include "swayaw/core/parts_reader.hpp"
#include "swayaw/core/parts_writer.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/core/ship_text.hpp"
#include "swayaw/nonlinear/effects.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"
#include "swayaw/nonlinear/models/mmg/mmg_labels.hpp"
#include "swayaw/nonlinear/surroundings/windage_sources.hpp"

namespace swayaw::inline nonlinear {
namespace {

// ---------------------------------------------------------------- what a model asks beyond its lists

void require_consistent(const MmgShip<double>& ship, const PartsReader& file) {
  if (!ship.engine.torque_limited()) return;
  if (ship.engine.Q_max == 0.0) file.fail("engine", "kind", "a torque limited engine needs torque_limit_kN_m");
  if (ship.propeller.q_0 == 0.0)
    file.fail("engine", "kind", "a torque limited engine needs the torque curve kq in [propeller]");
}

/// PI and PU ships.
template <class PrimeShip>
void require_consistent(const PrimeShip& ship, const PartsReader& file) {
  const auto& [p, propeller] = std::tie(ship.particulars, ship.propeller);
  constexpr std::string_view rule = "one of inertia_z_kg_m2 and radius_of_gyration_m is needed in [particulars]";
  if (p.I_z == 0.0 && p.k_zz == 0.0) file.fail("particulars", "", fmt::format("{}; none is there", rule));
  if (p.I_z > 0.0 && p.k_zz > 0.0)
    file.fail("particulars", "radius_of_gyration_m", fmt::format("{}; both are there", rule));
  if (p.I_z > 0.0 && p.I_z <= ship.water.rho * p.nabla * p.x_G * p.x_G)
    file.fail("particulars", "inertia_z_kg_m2",
              "inertia_z_kg_m2 in [particulars] is about midship and must be larger than m x_G2");
  if (!propeller.wake_changes()) return;
  for (const auto* key : {"x_m", "wake_C1", "wake_C2_positive", "wake_C2_negative"})
    if (!file.has("propeller", key))
      file.fail("propeller", "wake", fmt::format("wake = \"mmg\" needs {} in [propeller]", key));
}

void require_consistent(const AbkowitzShip<double>&, const PartsReader&) {}

/// Unit forces at rest accelerate her along themselves, and by finite amounts: the matrix of masses and added masses
/// has an inverse.
template <class Model>
void require_inertia(const Model& model, const PartsReader& file) {
  const double L = model.particulars.L;
  const double mass = model.water.rho * L * L * L;  // unit of mass
  const auto answer = [&](const PlanarForce<double>& unit) {
    const PlanarForce<double> force{mass * unit.X, mass * unit.Y, mass * unit.N};
    return acceleration(model, PlanarMotion<double>{0.0, 0.0, 0.0}, force);
  };
  const auto surge = answer({1.0, 0.0, 0.0}), sway = answer({0.0, 1.0, 0.0}), yaw = answer({0.0, 0.0, L});
  const auto is_positive = [](double number) { return std::isfinite(number) && number > 0.0; };
  if (!is_positive(surge.u))
    file.fail("", "model", "mass and added mass in surge are not positive together, so no force can drive her");
  if (!is_positive(sway.v) || !is_positive(L * yaw.r) || !is_positive(L * (sway.v * yaw.r - yaw.v * sway.r)))
    file.fail("", "model",
              "mass, added masses and inertia in sway and yaw are singular or negative, so no motion answers a force");
}

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

/// The numbers of the effect from its table; those that need not be given may be missing.
void read_numbers(Effect& effect, const FileEffect& given, const PartsReader& file) {
  std::vector<std::string_view> keys;
  for_each_parameter(effect, [&](const auto& p, double&) { keys.push_back(p.key); });
  for (const auto& number : given.numbers)
    if (const auto& key = number.first; std::ranges::count(keys, key) == 0)
      file.fail(given, key,
                fmt::format("{} is not a number of {}{}", key, given.kind, core::detail::did_you_mean(key, keys)));
  bool some = false;
  for_each_parameter(effect, [&](const auto& p, double& number) {
    const auto found = std::ranges::find(given.numbers, p.key, &std::pair<std::string, double>::first);
    if (found == given.numbers.end() && p.required) file.fail(given, fmt::format("{} needs {}", given.kind, p.key));
    some = some || found != given.numbers.end();
    number = found == given.numbers.end() ? p.fallback : found->second;
    if (found != given.numbers.end() && !p.range.contains(number))
      file.fail(given, p.key, fmt::format("{} in [[effect]] cannot be {}", p.key, number));
  });
  if (!some) file.fail(given, fmt::format("{} has no numbers", given.kind));
}

void read_channel(Effect& effect, const FileEffect& given, const PartsReader& file) {
  auto* place = channel_of(effect);
  if (!place && !given.channel.empty()) file.fail(given, "channel", fmt::format("{} has no channel", given.kind));
  if (!place) return;
  if (given.channel.empty()) file.fail(given, fmt::format("{} needs channel", given.kind));
  const auto channel = channel_named(given.channel);
  if (!channel) file.fail(given, "channel", fmt::format("channel \"{}\" is not known", given.channel));
  *place = *channel == Channel::y ? Channel::x : *channel;
}

Effect read_effect(const FileEffect& given, const PartsReader& file) {
  auto effect = effect_named(given.kind);
  if (!effect)
    file.fail(given, "kind",
              fmt::format("effect {} is not understood by this version{}", given.kind,
                          core::detail::did_you_mean(given.kind, effect_ids())));
  read_numbers(*effect, given, file);
  read_channel(*effect, given, file);
  if (const auto needed = lacks(*effect); !needed.empty()) file.fail(given, fmt::format("{}: {}", given.kind, needed));
  return *effect;
}

std::vector<Effect> read_effects(const ShipModel& model, const Windage<double>& windage, const PartsReader& file) {
  std::vector<Effect> effects;
  for (const auto& given : file.effects()) {
    const auto effect = read_effect(given, file);
    if (place_of(effect) == EffectPlace::air && !feels_wind(windage))
      file.fail(given, "wind needs frontal and lateral area of the ship, in [windage] or [particulars]");
    if (const auto why = cannot_act(model, effect); !why.empty()) file.fail(given, why);
    if (std::ranges::any_of(effects, [&](const Effect& e) { return exclude_each_other(e, effect); }))
      file.fail(given, fmt::format("{} is given twice", given.kind));
    effects.push_back(effect);
  }
  return effects;
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
  add_parameters(keys.parameters, "windage", table.windage);
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
    if (list->size() != rows)
      file.fail("windage", key, fmt::format("{} in [windage] has {} numbers, angle_deg {}", key, list->size(), rows));
  WindTable coefficients;
  for (std::size_t i = 0; i < rows; ++i)
    coefficients.push_back({table.angle[i], table.C_X[i], table.C_Y[i], table.C_N[i]});
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
  require_inertia(model, file);
  Surroundings<double> around{
      .windage = own_windage ? windage_of(table, file) : windage_of(model), .wind = {}, .current = {}};
  auto effects = read_effects(model, around.windage, file);
  return {.name = std::move(head.name),
          .model = model,
          .confidence = std::move(head.confidence),
          .surroundings = around,
          .effects = std::move(effects)};
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
  if (std::holds_alternative<WindSeries<>>(table.windage.given))
    throw Refusal("wind coefficients that are a Fourier series cannot be written to a ship file");
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

/// @throws std::domain_error  if a number is not finite or not in its range
FileEffect written(const Effect& effect) {
  FileEffect result{.kind = std::string(id_of(effect)), .numbers = {}, .line = 0, .column = 0, .channel = {}};
  if (const auto* channel = channel_of(effect)) result.channel = short_name(*channel);
  for_each_parameter(effect, [&](const auto& p, double number) {
    const bool is_fallback = number == p.fallback || (std::isnan(number) && std::isnan(p.fallback));
    if (!p.required && is_fallback) return;
    if (!std::isfinite(number) || !p.range.contains(number))
      throw std::domain_error(fmt::format("{} of {} cannot be {}", p.key, result.kind, number));
    result.numbers.emplace_back(p.key, number);
  });
  return result;
}

/// Wind and current of the surroundings are written as effects too, together with those that are.
std::vector<FileEffect> effects_of(const Ship& ship) {
  std::vector<FileEffect> effects;
  auto calm = ship;
  std::erase_if(calm.effects, [](const Effect& e) { return std::holds_alternative<Gust<>>(e); });
  const auto around = surroundings_at(calm, 0.0);
  const bool own_wind = ship.surroundings.windy, own_current = ship.surroundings.current.speed != 0.0;
  if (own_wind) effects.push_back(written(SteadyWind<>{around.wind.speed, around.wind.from}));
  if (own_current) effects.push_back(written(SteadyCurrent<>{around.current.speed, around.current.to}));
  for (const auto& effect : ship.effects) {
    const bool merged = (own_wind && std::holds_alternative<SteadyWind<>>(effect)) ||
                        (own_current && std::holds_alternative<SteadyCurrent<>>(effect));
    if (!merged) effects.push_back(written(effect));
  }
  return effects;
}

template <class Model>
std::string text_as(const Ship& ship, Model model, std::string_view remark) {
  auto keys = file_keys(model);
  WindageTable table{.windage = ship.surroundings.windage, .type = {}, .angle = {}, .C_X = {}, .C_Y = {}, .C_N = {}};
  add_lists(table);
  const bool own = !table.angle.empty() || !same_numbers(table.windage, windage_of(model));
  if (own) add_keys(keys, table);
  return ship_text(model_name(model), {ship.name, ship.confidence}, keys, effects_of(ship), remark);
}

}  // namespace

std::string ship_text(const Ship& ship, std::string_view remark) {
  return std::visit([&](const auto& model) { return text_as(ship, model, remark); }, ship.model);
}

void write_ship(const std::filesystem::path& file, const Ship& ship, std::string_view remark) {
  const auto units = [](auto model) { return units_of(file_keys(model)); };
  write_ship_text(file, ship_text(ship, remark), std::visit(units, ship.model));
}

Ship read_ship(const std::filesystem::path& file) { return parse_ship(read_ship_text(file), file); }

}  // namespace swayaw::nonlinear
