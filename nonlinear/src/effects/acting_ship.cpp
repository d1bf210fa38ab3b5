#include "swayaw/nonlinear/effects/acting_ship.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"

namespace swayaw::inline nonlinear {
namespace {

std::string_view name_of(const MmgShip<double>&) { return "mmg"; }
std::string_view name_of(const PiShip<double>&) { return "pi"; }
std::string_view name_of(const PuShip<double>&) { return "pu"; }
std::string_view name_of(const AbkowitzShip<double>&) { return "abkowitz"; }

/// Whether effects of that kind act on a model; its parameters apart.
template <class Model, class Kind>
bool acts_on(const Model& model, const Kind&) {
  if constexpr (requires { Kind::acts_on(model); }) return Kind::acts_on(model);
  else return true;
}

/// Whether the model has parameters that an effect of that kind changes, or needs none.
template <class Model, class Kind>
constexpr bool can_change = !ChangesModel<Kind> || puts_values<Kind>() || requires(Model & model, const Kind& e) {
  change(model, e);
};

template <class Model>
std::string cannot_act_on(const Model& model, const Effect& effect) {
  auto changed = model;
  const auto lacking = std::visit([&](const auto& e) { return change_model(changed, e); }, effect);
  if (!lacking.empty())
    return fmt::format("{}: a ship of model \"{}\" has no {}", id_of(effect), name_of(model), lacking);
  const auto can = [&]<class Kind>(const Kind& e) { return can_change<Model, Kind> && acts_on(model, e); };
  if (std::visit(can, effect)) return {};
  return fmt::format("{} cannot act on a ship of model \"{}\"", id_of(effect), name_of(model));
}

/// Velocity of the air as a vector to the north and the east.
struct WindVector {
  double north = 0.0, east = 0.0;

  void add(double speed, double from) {
    north -= speed * std::cos(from);
    east -= speed * std::sin(from);
  }

  double speed() const { return std::hypot(north, east); }
};

template <class Kind>
constexpr bool gives_steady_wind = GivesWind<Kind> && !BeginsAndEnds<Kind>;

/// Wind that blows all the time, and those gusts that blow at that time.
Surroundings<double> with_wind(Surroundings<double> around, const Ship& ship, double time) {
  std::vector<Wind<double>> winds;
  if (around.windy) winds.push_back(around.wind);
  const auto add = [&]<class Kind>(const Kind& e) {
    if constexpr (GivesWind<Kind>)
      if (acts_at(e, time)) winds.push_back(wind(e));
  };
  for (const auto& effect : ship.effects)
    if (!is_null(effect)) std::visit(add, effect);
  if (winds.empty()) return around;
  around.windy = true;
  around.wind = winds.front();
  if (winds.size() == 1) return around;
  WindVector sum;
  for (const auto& w : winds) sum.add(w.speed, w.from);
  around.wind = {sum.speed(), std::atan2(-sum.east, -sum.north)};
  return around;
}

/// The sum of two streams.
Current<double> both(const Current<double>& a, const Current<double>& b) {
  if (b.speed == 0.0) return a;
  if (a.speed == 0.0) return b;
  WindVector sum;
  sum.add(-a.speed, a.to);
  sum.add(-b.speed, b.to);
  return {sum.speed(), std::atan2(sum.east, sum.north)};
}

Surroundings<double> with_current(Surroundings<double> around, const Ship& ship) {
  const auto add = [&]<class Kind>(const Kind& e) {
    if constexpr (GivesCurrent<Kind>) around.current = both(around.current, current(e));
  };
  for (const auto& effect : ship.effects) std::visit(add, effect);
  return around;
}

/// The model with its parameters as the effects change them.
/// @throws Refusal  as cannot_act tells
template <class Model>
Model with_changes(const Model& model, const Ship& ship) {
  for (const auto& effect : ship.effects)
    if (const auto why = cannot_act_on(model, effect); !why.empty()) throw Refusal(why);
  return changed_by<Model>(active_effects(ship), model);
}

/// The ship without wind that comes and goes.
Ship without_gusts(const Ship& ship) {
  auto calm = ship;
  const auto is_gust = []<class Kind>(const Kind&) { return GivesWind<Kind> && BeginsAndEnds<Kind>; };
  std::erase_if(calm.effects, [&](const Effect& e) { return std::visit(is_gust, e); });
  return calm;
}

constexpr double before_all = -std::numeric_limits<double>::infinity();

}  // namespace

std::vector<Effect> active_effects(const Ship& ship) {
  std::vector<Effect> effects;
  std::ranges::copy_if(ship.effects, std::back_inserter(effects), [](const Effect& e) { return !is_null(e); });
  return effects;
}

std::string cannot_act(const ShipModel& model, const Effect& effect) {
  return std::visit([&](const auto& m) { return cannot_act_on(m, effect); }, model);
}

Surroundings<double> surroundings_at(const Ship& ship, double time) {
  return with_current(with_wind(ship.surroundings, ship, time), ship);
}

std::uint32_t acting_at(std::span<const Effect> effects, double time) {
  std::uint32_t acting = 0;
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    const auto take = [&]<class Kind>(std::size_t i, std::type_identity<Kind>) {
      for (const auto& effect : effects)
        if (const auto* e = std::get_if<Kind>(&effect); e && !is_null(effect) && acts_at(*e, time))
          acting |= std::uint32_t{1} << i;
    };
    (take(I, std::type_identity<ActingKind<I>>{}), ...);
  }
  (std::make_index_sequence<acting_count>());
  return acting;
}

std::vector<Change> changes_of(const Ship& ship) {
  std::vector<double> times;
  const auto add = [&]<class Kind>(const Kind& e) {
    if constexpr (BeginsAndEnds<Kind>) times.insert(times.end(), {e.onset, e.end});
  };
  for (const auto& effect : ship.effects)
    if (!is_null(effect)) std::visit(add, effect);
  std::erase_if(times, [](double time) { return !std::isfinite(time); });
  std::ranges::sort(times);
  std::vector<Change> changes;
  for (const double time : times) {
    const auto around = surroundings_at(ship, time);
    changes.push_back({time, around.wind, around.windy, acting_at(ship.effects, time)});
  }
  return changes;
}

RudderActuator rudder_actuator(const Ship& ship) {
  RudderActuator actuator;
  const auto add = [&]<class Kind>(const Kind& e) {
    if constexpr (ActuatesRudder<Kind>) actuate(e, actuator);
  };
  for (const auto& effect : ship.effects) std::visit(add, effect);
  return actuator;
}

Instruments<double> instruments_of(const Ship& ship) { return instruments_of(std::span<const Effect>(ship.effects)); }

template <class Model>
ActingShip<Model> acting_ship(const Ship& ship, const Model& model) {
  ActingShip<Model> acting{
      .model = model, .surroundings = ship.surroundings, .changes = {}, .added = {}, .rudder = {}, .instruments = {}};
  if (ship.effects.empty()) return acting;
  acting.model = with_changes(model, ship);
  acting.surroundings = surroundings_at(ship, before_all);
  acting.changes = changes_of(ship);
  const auto effects = active_effects(ship);
  acting.added = acting_effects(acting.model, std::span<const Effect>(effects));
  acting.added.acting = acting_at(effects, before_all);
  acting.rudder = rudder_actuator(ship);
  acting.instruments = instruments_of(ship);
  return acting;
}

template ActingShip<MmgShip<double>> acting_ship(const Ship&, const MmgShip<double>&);
template ActingShip<PiShip<double>> acting_ship(const Ship&, const PiShip<double>&);
template ActingShip<PuShip<double>> acting_ship(const Ship&, const PuShip<double>&);
template ActingShip<AbkowitzShip<double>> acting_ship(const Ship&, const AbkowitzShip<double>&);

Ship with_effects_applied(const Ship& ship) {
  Ship result = ship;
  std::visit([&](auto& model) { model = with_changes(model, ship); }, result.model);
  result.surroundings = surroundings_at(without_gusts(ship), 0.0);
  const auto held = []<class Kind>(const Kind&) {
    return ChangesModel<Kind> || gives_steady_wind<Kind> || GivesCurrent<Kind>;
  };
  std::erase_if(result.effects, [&](const Effect& e) { return std::visit(held, e); });
  return result;
}

Ship with_effect(const Ship& ship, const Effect& effect) {
  Ship result = ship;
  result.effects.push_back(effect);
  return result;
}

// ---------------------------------------------------------------- parameters of effects, on a ship

namespace {

/// One of a unit, on a ship of that length and speed.
double one_of(ShipUnit unit, const Ship& ship, double own) {
  const double L = length(ship), U = service_speed(ship);
  const double rho = std::visit([](const auto& m) { return m.water.rho; }, ship.model);
  switch (unit) {
    case ShipUnit::one: return 1.0;
    case ShipUnit::speed: return U;
    case ShipUnit::wind: return std::sqrt(U * U + 0.1 * effect_gravity * L);
    case ShipUnit::time: return L / U;
    case ShipUnit::length: return L;
    case ShipUnit::yaw_rate: return U / L;
    case ShipUnit::force: return 0.5e-3 * rho * L * L * U * U;
    case ShipUnit::own: break;
  }
  return own == 0.0 ? 1.0 : std::abs(own);
}

ShipFacts<double> facts_of(const ShipModel& model) {
  return std::visit([](const auto& m) { return ship_facts(m); }, model);
}

std::optional<double> value_in(ShipModel model, std::string_view table, const std::array<std::string_view, 2>& names) {
  const auto* place = std::visit([&](auto& m) { return value_named(m, table, names); }, model);
  return place ? std::optional(*place) : std::nullopt;
}

/// What a parameter of an effect is where the effect leaves it as it is; nothing where the model has no place for it.
template <class Kind>
std::optional<double> own_value(const ShipModel& model, const ParameterOf<Kind, double>& p) {
  if (p.table.empty()) return completed(Kind{}, facts_of(model)).*p.member;
  return value_in(model, p.table, p.replaces);
}

/// A parameter of an effect on a ship; nothing where the model has no place for it.
template <class Kind>
std::optional<Parameter> parameter_of(const Ship& ship, const Kind& effect, std::size_t index) {
  const auto& p = parameter_list<Kind>[index];
  const bool of_ship = std::isnan(p.null) || !p.table.empty();
  const auto own = of_ship ? own_value(ship.model, p) : 0.0;
  if (!own) return std::nullopt;
  const double one = one_of(p.scale, ship, *own), null = std::isnan(p.null) ? *own : p.null, value = effect.*p.member;
  return Parameter{.name = std::string(p.key),
                   .table = Kind::id,
                   .key = p.key,
                   .unit = p.unit,
                   .index = index,
                   .value = std::isnan(value) ? null : value,
                   .range = p.range,
                   .scope = Kind::scope,
                   .null = null,
                   .deviation = p.prior * one,
                   .floor = p.floor * (p.scale == ShipUnit::wind ? service_speed(ship) : one),
                   .law = p.law,
                   .decides = p.decides,
                   .direction = p.direction};
}

}  // namespace

std::vector<Parameter> parameters_of(const Ship& ship, const Effect& effect) {
  if (!cannot_act(ship.model, effect).empty()) return {};
  std::vector<Parameter> parameters;
  const auto add = [&]<class Kind>(const Kind& e) {
    for (std::size_t i = 0; i < parameter_list<Kind>.size(); ++i)
      if (auto p = parameter_of(ship, e, i)) parameters.push_back(*std::move(p));
  };
  std::visit(add, effect);
  return parameters;
}

}  // namespace swayaw::nonlinear
