#include <algorithm>

#include "effect.hpp"
#include "module.hpp"
#include "record.hpp"
#include "ship_values.hpp"
#include "swayaw/core/detail/spelling.hpp"
#include "swayaw/core/parts_reader.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"
#include "swayaw/nonlinear/published_ships.hpp"
#include "swayaw/nonlinear/ship_file.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"
#include "swayaw/nonlinear/surroundings/windage_sources.hpp"

namespace swayaw::python {

template <>
struct Words<EffectPlace> : NamedWords<EffectPlace, 5, name_of> {};

namespace {

// ---------------------------------------------------------------- parameters

double in_unit(const Parameter& p, double value) { return value / p.si; }

std::pair<double, double> range_of(const Parameter& p) { return {p.range.low / p.si, p.range.high / p.si}; }

py::dict by_name(const std::vector<Parameter>& parameters) {
  py::dict result;
  for (const auto& p : parameters) result[py::str(p.name)] = p;
  return result;
}

Ship with_named_values(const Ship& ship, const std::map<std::string, double>& named_values) {
  std::vector<std::string> names;
  std::vector<double> given;
  for (const auto& [name, value] : named_values) names.push_back(name), given.push_back(value);
  const auto parameters = parameters_of(ship, names);
  return with_values(ship, parameters, si_values(parameters, given));
}

/// All of a parameter, for pickling.
using ParameterState =
    std::tuple<std::string, std::string, std::string, std::string, std::size_t, double,
               std::tuple<double, double, bool, bool>, double, Role, Scope, std::array<double, 4>, bool, bool>;

ParameterState state_of(const Parameter& p) {
  return {p.name,
          std::string(p.table),
          std::string(p.key),
          std::string(p.unit),
          p.index,
          p.value,
          {p.range.low, p.range.high, p.range.above_low, p.range.not_zero},
          p.si,
          p.role,
          p.scope,
          {p.null, p.deviation, p.floor, p.law},
          p.decides,
          p.direction};
}

Parameter parameter_from(const ParameterState& state) {
  const auto& [name, table, key, unit, index, value, range, si, role, scope, prior, decides, direction] = state;
  const auto& [low, high, above_low, not_zero] = range;
  return {.name = name,
          .table = kept(table),
          .key = kept(key),
          .unit = kept(unit),
          .index = index,
          .value = value,
          .range = {.low = low, .high = high, .above_low = above_low, .not_zero = not_zero},
          .si = si,
          .role = role,
          .scope = scope,
          .null = prior[0],
          .deviation = prior[1],
          .floor = prior[2],
          .law = prior[3],
          .decides = decides,
          .direction = direction};
}

void add_parameters(py::module_& m) {
  py::class_<Parameter>(m, "Parameter",
                        "A number of a ship or of an effect: value, unit, range, and what is known of it.")
      .def_property_readonly(
          "name", [](const Parameter& p) { return p.name; }, "Key of the ship file, with its table where two have it.")
      .def_property_readonly(
          "table", [](const Parameter& p) { return p.table; }, "Of the ship file; of an effect its id.")
      .def_property_readonly(
          "value", [](const Parameter& p) { return in_unit(p, p.value); }, "In `unit`.")
      .def_property_readonly(
          "value_si", [](const Parameter& p) { return p.value; }, "In SI.")
      .def_property_readonly(
          "unit", [](const Parameter& p) { return p.unit; }, "As in ship files, \"-\" for none.")
      .def_property_readonly("range", &range_of, "Lowest and highest value that a ship file accepts, in `unit`.")
      .def_property_readonly(
          "deviation", [](const Parameter& p) { return in_unit(p, p.deviation); },
          "Standard deviation before any recording, in `unit`; 0 for a fact.")
      .def_property_readonly(
          "null", [](const Parameter& p) { return in_unit(p, p.null); },
          "Mean before any recording, in `unit`: of an effect where it does nothing.")
      .def_property_readonly(
          "role", [](const Parameter& p) { return p.role; }, "\"coefficient\" if it can be fitted, \"fact\" if not.")
      .def_property_readonly(
          "scope", [](const Parameter& p) { return p.scope; }, "Whose it is: \"ship\", \"group\" of runs or \"run\".")
      .def("__float__", [](const Parameter& p) { return in_unit(p, p.value); })
      .def(py::pickle(&state_of, &parameter_from))
      .def("__repr__", [](const Parameter& p) {
        const auto [low, high] = range_of(p);
        return fmt::format("Parameter({}={}, unit={}, range=({}, {}))", p.name, in_unit(p, p.value), p.unit, low, high);
      });
}

// ---------------------------------------------------------------- effects

std::vector<std::string_view> keys_of(Effect& effect) {
  std::vector<std::string_view> keys;
  for_each_parameter(effect, [&](const auto& p, double&) { keys.push_back(p.key); });
  return keys;
}

/// As a ship file is read: what is needed must be there, what is there must be known and in its range.
void set_numbers(Effect& effect, const std::map<std::string, double>& numbers) {
  const auto id = id_of(effect);
  const auto keys = keys_of(effect);
  for (const auto& [key, value] : numbers)
    if (std::ranges::count(keys, key) == 0)
      throw std::domain_error(
          fmt::format("{} is not a number of {}{}", key, id, core::detail::did_you_mean(key, keys)));
  for_each_parameter(effect, [&](const auto& p, double& number) {
    const auto found = numbers.find(std::string(p.key));
    if (found == numbers.end() && p.required) throw std::domain_error(fmt::format("{} needs {}", id, p.key));
    number = found == numbers.end() ? p.fallback : found->second;
    if (found != numbers.end() && !p.range.contains(number))
      throw std::domain_error(fmt::format("{} of {} cannot be {}", p.key, id, number));
  });
}

void set_channel(Effect& effect, const std::optional<Channel>& channel) {
  auto* place = channel_of(effect);
  if (!place && channel) throw std::domain_error(fmt::format("{} has no channel", id_of(effect)));
  if (place && !channel) throw std::domain_error(fmt::format("{} needs channel", id_of(effect)));
  if (place) *place = *channel == Channel::y ? Channel::x : *channel;
}

Effect effect_from(const std::string& id, const std::map<std::string, double>& numbers,
                   const std::optional<Channel>& channel) {
  auto effect = effect_named(id);
  if (!effect)
    throw std::domain_error(
        fmt::format("there is no effect \"{}\"{}", id, core::detail::did_you_mean(id, effect_ids())));
  set_numbers(*effect, numbers);
  set_channel(*effect, channel);
  if (const auto needed = lacks(*effect); !needed.empty()) throw std::domain_error(fmt::format("{}: {}", id, needed));
  return *effect;
}

/// The channel stands among the numbers in Python, as it does in a ship file.
Effect effect_from_keywords(const std::string& id, const py::kwargs& keywords) {
  std::map<std::string, double> numbers;
  std::optional<Channel> channel;
  for (const auto& [key, value] : keywords) {
    if (key.cast<std::string>() == "channel") channel = value.cast<Channel>();
    else numbers[key.cast<std::string>()] = value.cast<double>();
  }
  return effect_from(id, numbers, channel);
}

py::dict numbers_of(const Effect& effect) {
  py::dict numbers;
  for_each_parameter(effect, [&](const auto& p, double number) { numbers[py::str(p.key)] = number; });
  if (const auto* channel = channel_of(effect)) numbers["channel"] = *channel;
  return numbers;
}

/// @throws Refusal  if she has one of its kind, or it cannot act on her
Ship with_one_more(const Ship& ship, const Effect& effect) {
  if (std::ranges::any_of(ship.effects, [&](const Effect& e) { return exclude_each_other(e, effect); }))
    throw Refusal(fmt::format("{} has the effect {} already", ship.name, id_of(effect)));
  if (place_of(effect) == EffectPlace::air && !feels_wind(ship.surroundings.windage))
    throw Refusal("wind needs frontal and lateral area of the ship, in [windage] or [particulars]");
  if (const auto why = cannot_act(ship.model, effect); !why.empty()) throw Refusal(why);
  return with_effect(ship, effect);
}

/// @param type  the class, which ships know already
void add_effects(py::module_& m, py::class_<AnyEffect>& type) {
  type.def(py::init([](const std::string& id, const py::kwargs& numbers) {
             return AnyEffect{effect_from_keywords(id, numbers)};
           }),
           py::arg("id"),
           "From its id and its numbers by their keys in ship files: Effect(\"steady_wind\", wind_speed_m_s=11.2, "
           "wind_from_rad=2.09). Raises ValueError for numbers that are not known, missing or out of range.")
      .def_property_readonly("id", [](const AnyEffect& e) { return id_of(e.value); })
      .def_property_readonly(
          "numbers", [](const AnyEffect& e) { return numbers_of(e.value); }, "By their keys, units in the names.")
      .def_property_readonly(
          "place", [](const AnyEffect& e) { return place_of(e.value); }, "air, water, force, actuator or sensor.")
      .def_property_readonly("scope", [](const AnyEffect& e) { return scope_of(e.value); })
      .def_property_readonly(
          "label", [](const AnyEffect& e) { return label_of(e.value); }, "\"steady wind\", \"late channel (rudder)\"")
      .def_property_readonly(
          "law", [](const AnyEffect& e) { return text_of(e.value).law; }, "What it does, as Markdown.")
      .def_property_readonly(
          "is_null", [](const AnyEffect& e) { return is_null(e.value); }, "Whether it does nothing.")
      .def(
          "parameters", [](const AnyEffect& e, const Ship& ship) { return by_name(parameters_of(ship, e.value)); },
          py::arg("ship"), "Its parameters on a ship by name, with range and prior; none if it cannot act on her.")
      .def("__eq__",
           [](const AnyEffect& a, const AnyEffect& b) {
             return id_of(a.value) == id_of(b.value) && numbers_of(a.value).equal(numbers_of(b.value));
           })
      .def("__repr__",
           [](const AnyEffect& e) {
             std::string text = fmt::format("Effect(\"{}\"", id_of(e.value));
             for (const auto& [key, value] : numbers_of(e.value))
               text += fmt::format(", {}={}", key.cast<std::string>(), py::repr(value).cast<std::string>());
             return text + ")";
           })
      .def(py::pickle([](const AnyEffect& e) { return py::make_tuple(id_of(e.value), numbers_of(e.value)); },
                      [](const py::tuple& state) {
                        return AnyEffect{effect_from_keywords(state[0].cast<std::string>(), py::kwargs(state[1]))};
                      }));
  m.def(
      "effect_ids", [] { return std::vector<std::string_view>(effect_ids().begin(), effect_ids().end()); },
      "Names of all effects, as in ship files.");
  m.def(
      "effect_named",
      [](const std::string& id) {
        const auto effect = effect_named(id);
        if (!effect) throw std::domain_error(fmt::format("there is no effect \"{}\"", id));
        return AnyEffect{*effect};
      },
      py::arg("id"),
      "The effect of that name where it does nothing."
      "\n\nid: as in ship files; ValueError for one that is not known.");
}

// ---------------------------------------------------------------- ships

std::string_view model_of_ship(const Ship& ship) {
  static_assert(std::variant_size_v<ShipModel> + 1 == ship_models.size());
  return ship_models[ship.model.index() + 1];  // "linear" comes first
}

void add_ship(py::module_& m) {
  using Drive = Controls<double>;
  using Thrusts = Sides<double>;
  Record<Thrusts>(m, "Thrust", "Thrust of the propellers by side; of a single propeller the sum counts.",
                  Made::by_anyone)
      .field<&Thrusts::port>("port", "[N]")
      .field<&Thrusts::starboard>("starboard", "[N]");
  Record<Drive>(m, "Controls", "What the bridge and the engine room do to the ship.", Made::by_anyone)
      .optional<&Drive::delta>("delta", "Rudder angle, positive to port [rad].")
      .optional<&Drive::rev>("rev", "Shaft speed [1/s].")
      .optional<&Drive::thrust>("thrust", "In place of the shaft speed [N].")
      .optional<&Drive::by_thrust>("by_thrust", "Whether the thrust counts.");

  py::class_<Ship>(m, "Ship", R"(A ship of a nonlinear model, what surrounds her, and what her model leaves out.

She is a value: `with_values` and `with_effect` give another ship. Two ships are equal when their files are.)")
      .def_readwrite("name", &Ship::name)
      .def_property_readonly("model", &model_of_ship, "\"mmg\", \"pi\", \"pu\" or \"abkowitz\".")
      .def_property_readonly("length", &length, "Between perpendiculars [m].")
      .def_property_readonly("service_speed", &service_speed,
                             "At which she approaches a manoeuvre unless told otherwise [m/s].")
      .def_property_readonly(
          "feels_wind", [](const Ship& ship) { return feels_wind(ship.surroundings.windage); },
          "Whether she shows the wind anything: without areas above water no wind acts on her.")
      .def_property_readonly("time_unit", &time_unit_of, "In which she sails her length at service speed, L/U [s].")
      .def_property_readonly("steering_gear", &steering_gear, "What her steering gear can do.")
      .def_property_readonly(
          "parameters", [](const Ship& ship) { return by_name(parameters_of(ship)); },
          "All parameters of her model by name, as Parameter.")
      .def_property_readonly(
          "effects", [](const Ship& ship) { return ship.effects; }, "What her model leaves out, as Effect.")
      .def("with_values", &with_named_values, py::arg("values"),
           "The ship with other values of parameters, by name, in the units of the ship file: "
           "ship.with_values({\"N_v\": -0.14}). Raises Refusal for a name she does not have, ValueError out of range.")
      .def(
          "with_effect", [](const Ship& ship, const AnyEffect& e) { return with_one_more(ship, e.value); },
          py::arg("effect"), "The ship with one more effect. Raises Refusal where it cannot act on her.")
      .def(
          "with_effect",
          [](const Ship& ship, const std::string& id, const py::kwargs& numbers) {
            return with_one_more(ship, effect_from_keywords(id, numbers));
          },
          py::arg("id"), "The same from id and numbers: ship.with_effect(\"steady_current\", …).")
      .def(
          "without_effects",
          [](Ship ship) {
            ship.effects.clear();
            return ship;
          },
          "The ship as her model has her.")
      .def("text", py::overload_cast<const Ship&, std::string_view>(&ship_text), py::arg("remark") = "",
           "The text of her ship file, which parse_ship reads back to the same ship.")
      .def(
          "save",
          [](const Ship& ship, const std::filesystem::path& file, std::string_view remark) {
            write_ship(file, ship, remark);
          },
          py::arg("file"), py::arg("remark") = "", "Writes her ship file, whole or not at all.")
      .def("__eq__", [](const Ship& a, const Ship& b) { return ship_text(a) == ship_text(b); })
      .def("__hash__", [](const Ship& ship) { return std::hash<std::string>()(ship_text(ship)); })
      .def(py::pickle([](const Ship& ship) { return ship_text(ship); },
                      [](const std::string& text) { return parse_ship(text, "pickled ship"); }));

  m.def("parse_ship", &parse_ship, py::arg("text"), py::arg("name") = "ship",
        "A ship of a nonlinear model from the text of a ship file; `name` stands for the file in messages."
        "\n\ntext: of a ship file. name: of the file. Raises FileError \"NAME:LINE:COLUMN: what is wrong\".");
  m.def("read_ship", &read_ship, py::arg("file"),
        "A ship of a nonlinear model from a ship file. Raises FileError \"FILE:LINE:COLUMN: what is wrong\"."
        "\n\nfile: of one of the models mmg, pi, pu and abkowitz.");
  m.def("published_ship", &published_ship, py::arg("name"),
        "The published ship of a nonlinear model with that name. Raises Refusal that lists the names."
        "\n\nname: of `published_ships`, \"kvlcc2\".");
  m.def(
      "published_ships",
      [] {
        std::vector<std::string_view> names;
        for (const auto& ship : published_ships()) names.push_back(ship.name);
        return names;
      },
      "Names of all published ships, linear ones among them.");
  m.def(
      "published_text",
      [](std::string_view name) {
        const auto text = published_text(name);
        if (!text) throw Refusal(fmt::format("there is no published ship \"{}\"", name));
        return *text;
      },
      py::arg("name"),
      "The ship file of that name."
      "\n\nname: of `published_ships`; Refusal for another.");
  m.def("_model_of", &model_of, py::arg("text"), py::arg("name"));
  m.def(
      "self_propulsion",
      [](const Ship& ship, Maybe speed) { return self_propulsion(ship, speed.value_or(service_speed(ship))); },
      py::arg("ship"), py::arg("speed") = py::none(),
      "Rudder amidships and the shaft speed, or thrust, that carries her straight ahead at that speed [m/s]."
      " What of her effects drags on her all the time, on every heading, is carried, too."
      "\n\nship: of any nonlinear model. speed: the service speed unless given. Raises Refusal if she cannot propel "
      "herself at it.");
}

}  // namespace

std::vector<double> si_values(std::span<const Parameter> parameters, std::span<const double> given) {
  std::vector<double> values;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto& p = parameters[i];
    if (!std::isfinite(given[i]) || !scaled(p.range, 1.0 / p.si).contains(given[i]))
      throw std::domain_error(fmt::format("{} in [{}] cannot be {}", p.key, p.table, given[i]));
    values.push_back(given[i] * p.si);
  }
  return values;
}

void add_ships(py::module_& m) {
  add_parameters(m);
  py::class_<AnyEffect> effect(m, "Effect",
                               "Physics that a model leaves out, as a value; docs/effects.md tells all kinds.");
  add_ship(m);
  add_effects(m, effect);
}

}  // namespace swayaw::python
