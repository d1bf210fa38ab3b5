#include "swayaw/nonlinear/acting_ship.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "swayaw/nonlinear/steady_motion.hpp"

namespace swayaw {
namespace {

std::string_view name_of(const MmgShip<double>&) { return "mmg"; }
std::string_view name_of(const PiShip<double>&) { return "pi"; }
std::string_view name_of(const PuShip<double>&) { return "pu"; }
std::string_view name_of(const AbkowitzShip<double>&) { return "abkowitz"; }

/// Added forces that a polynomial without draught, beam, thrust or shaft speed has no numbers for.
constexpr std::array<std::string_view, 4> not_of_abkowitz{CrossFlowDrag<>::id, PropellerSideForce<>::id,
                                                          RollCoupling<>::id, ShaftSpeedDrop<>::id};

template <class Model>
std::string cannot_act_on(const Model& model, const Effect& effect) {
  auto changed = model;
  const auto lacking = change_numbers(changed, effect);
  if (!lacking.empty() && lacking != id_of(effect))
    return fmt::format("{}: a ship of model \"{}\" has no {}", id_of(effect), name_of(model), lacking);
  const bool no_force =
      std::is_same_v<Model, AbkowitzShip<double>> && std::ranges::count(not_of_abkowitz, id_of(effect)) > 0;
  const bool no_shaft = id_of(effect) == ShaftSpeedDrop<>::id && !takes_shaft_speed(model);
  if (!lacking.empty() || no_force || no_shaft)
    return fmt::format("{} cannot act on a ship of model \"{}\"", id_of(effect), name_of(model));
  return {};
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

/// Wind that blows all the time, and those gusts that blow at that time.
Surroundings<double> with_wind(Surroundings<double> around, const Ship& ship, double time) {
  std::vector<Wind<double>> winds;
  if (around.windy) winds.push_back(around.wind);
  for (const auto& effect : ship.effects) {
    if (is_null(effect)) continue;
    if (const auto* steady = std::get_if<SteadyWind<>>(&effect)) winds.push_back({steady->speed, steady->from});
    if (const auto* gust = std::get_if<Gust<>>(&effect); gust && gust->onset <= time && time < gust->end)
      winds.push_back({gust->speed, gust->from});
  }
  if (winds.empty()) return around;
  around.windy = true;
  around.wind = winds.front();
  if (winds.size() == 1) return around;
  WindVector sum;
  for (const auto& w : winds) sum.add(w.speed, w.from);
  around.wind = {sum.speed(), std::atan2(-sum.east, -sum.north)};
  return around;
}

Surroundings<double> with_current(Surroundings<double> around, const Ship& ship) {
  const auto* stream = find<SteadyCurrent<>>(std::span<const Effect>(ship.effects));
  if (!stream || stream->speed == 0.0) return around;
  auto& c = around.current;
  if (c.speed == 0.0) {
    c = {stream->speed, stream->to};
    return around;
  }
  WindVector sum;
  sum.add(-c.speed, c.to);
  sum.add(-stream->speed, stream->to);
  c = {sum.speed(), std::atan2(sum.east, sum.north)};
  return around;
}

/// Numbers of the model as the effects change them.
template <class Model>
void change_model(Model& model, const Ship& ship) {
  for (const auto& effect : ship.effects) {
    if (const auto why = cannot_act_on(model, effect); !why.empty()) throw Refusal(why);
    if (!is_null(effect)) change_numbers(model, effect);
  }
}

/// The effects that do something.
std::vector<Effect> active(const Ship& ship) {
  std::vector<Effect> effects;
  std::ranges::copy_if(ship.effects, std::back_inserter(effects), [](const Effect& e) { return !is_null(e); });
  return effects;
}

bool unknown_acts(const Ship& ship, double time) {
  const auto* unknown = find<UnknownForce<>>(std::span<const Effect>(ship.effects));
  return unknown && !is_null(Effect(*unknown)) && unknown->onset <= time && time < unknown->end;
}

constexpr double before_all = -std::numeric_limits<double>::infinity();

}  // namespace

std::string cannot_act(const ShipModel& model, const Effect& effect) {
  return std::visit([&](const auto& m) { return cannot_act_on(m, effect); }, model);
}

Surroundings<double> surroundings_at(const Ship& ship, double time) {
  return with_current(with_wind(ship.surroundings, ship, time), ship);
}

std::vector<Change> changes_of(const Ship& ship) {
  std::vector<double> times;
  for (const auto& effect : ship.effects) {
    if (is_null(effect)) continue;
    if (const auto* gust = std::get_if<Gust<>>(&effect)) times.insert(times.end(), {gust->onset, gust->end});
    if (const auto* unknown = std::get_if<UnknownForce<>>(&effect))
      times.insert(times.end(), {unknown->onset, unknown->end});
  }
  std::erase_if(times, [](double time) { return !std::isfinite(time); });
  std::ranges::sort(times);
  std::vector<Change> changes;
  for (const double time : times) {
    const auto around = surroundings_at(ship, time);
    changes.push_back({time, around.wind, around.windy, unknown_acts(ship, time)});
  }
  return changes;
}

RudderActuator rudder_actuator(const Ship& ship) {
  RudderActuator a;
  for (const auto& effect : ship.effects) {
    if (const auto* play = std::get_if<SteeringGearBacklash<>>(&effect)) a.width = play->width;
    if (const auto* lag = std::get_if<SteeringGearLag<>>(&effect)) a.lag = lag->lag, a.rate = lag->rate;
    if (const auto* offset = std::get_if<RudderOffset<>>(&effect)) a.offset = offset->offset;
    if (const auto* late = std::get_if<ChannelDelay<>>(&effect); late && late->channel == Channel::delta)
      a.record_delay = late->delay;
  }
  return a;
}

std::vector<Effect> sensor_effects(const Ship& ship) {
  auto effects = active(ship);
  std::erase_if(effects, [](const Effect& e) { return place_of(e) != EffectPlace::sensor; });
  return effects;
}

template <class Model>
ActingShip<Model> acting_ship(const Ship& ship, const Model& model) {
  ActingShip<Model> acting{
      .model = model, .surroundings = ship.surroundings, .changes = {}, .added = {}, .rudder = {}, .sensors = {}};
  if (ship.effects.empty()) return acting;
  change_model(acting.model, ship);
  acting.surroundings = surroundings_at(ship, before_all);
  acting.changes = changes_of(ship);
  const auto effects = active(ship);
  acting.added = added_forces(acting.model, std::span<const Effect>(effects));
  acting.added.mapped = unknown_acts(ship, before_all);
  acting.rudder = rudder_actuator(ship);
  acting.sensors = sensor_effects(ship);
  return acting;
}

template ActingShip<MmgShip<double>> acting_ship(const Ship&, const MmgShip<double>&);
template ActingShip<PiShip<double>> acting_ship(const Ship&, const PiShip<double>&);
template ActingShip<PuShip<double>> acting_ship(const Ship&, const PuShip<double>&);
template ActingShip<AbkowitzShip<double>> acting_ship(const Ship&, const AbkowitzShip<double>&);

Ship with_effects_applied(const Ship& ship) {
  Ship result = ship;
  std::visit([&](auto& model) { change_model(model, ship); }, result.model);
  auto calm = ship;
  std::erase_if(calm.effects, [](const Effect& e) { return std::holds_alternative<Gust<>>(e); });
  result.surroundings = surroundings_at(calm, 0.0);
  const auto held = []<class Kind>(const Kind&) {
    return changes_numbers<Kind>() || Kind::id == SteadyWind<>::id || Kind::id == SteadyCurrent<>::id;
  };
  std::erase_if(result.effects, [&](const Effect& e) { return std::visit(held, e); });
  return result;
}

Ship without_sensor_effects(const Ship& ship) {
  Ship result = ship;
  std::erase_if(result.effects, [](const Effect& e) { return place_of(e) == EffectPlace::sensor; });
  return result;
}

Ship with_effect(const Ship& ship, const Effect& effect) {
  Ship result = ship;
  result.effects.push_back(effect);
  return result;
}

// ---------------------------------------------------------------- numbers of effects, on a ship

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

/// What a number of an effect is where the effect leaves it as it is; nothing where the model has no place for it.
template <class Part>
std::optional<double> own_number(const ShipModel& model, const AddedForces<double>& defaults,
                                 const EffectParameter<Part, double>& p) {
  if (p.key == "GM_m") return defaults.coupling.GM;
  if (p.key == "lever_m") return defaults.coupling.lever;
  return std::visit(
      [&](auto m) -> std::optional<double> {
        const auto* place = replaced(m, p);
        return place ? std::optional(*place) : std::nullopt;
      },
      model);
}

}  // namespace

std::vector<Parameter> parameters_of(const Ship& ship, const Effect& effect) {
  if (!cannot_act(ship.model, effect).empty()) return {};
  const auto defaults =
      std::visit([](const auto& m) { return added_forces(m, std::span<const Effect>{}); }, ship.model);
  std::vector<Parameter> parameters;
  std::size_t index = 0;
  for_each_parameter(effect, [&](const auto& p, double value) {
    const std::size_t place = index++;
    std::optional<double> own = std::isnan(p.null) || !p.table.empty() ? own_number(ship.model, defaults, p) : 0.0;
    if (!own) return;
    const double one = one_of(p.scale, ship, *own), null = std::isnan(p.null) ? *own : p.null;
    const double floor = p.scale == ShipUnit::wind ? p.floor * service_speed(ship) : p.floor * one;
    parameters.push_back({.name = std::string(p.key),
                          .table = id_of(effect),
                          .key = p.key,
                          .unit = "-",
                          .index = place,
                          .value = std::isnan(value) ? null : value,
                          .range = p.range,
                          .null = null,
                          .deviation = p.prior * one,
                          .floor = floor,
                          .law = p.law,
                          .decides = p.decides});
  });
  return parameters;
}

}  // namespace swayaw
