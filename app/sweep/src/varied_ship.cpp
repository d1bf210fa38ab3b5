#include "varied_ship.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ranges>

#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"

namespace swayaw::app {
namespace {

constexpr std::string_view approach_speed = "speed_m_s";

/// Calls visit(table, parameter, value) for every number of a linear ship, in the order of her file.
template <class L, class Visit>
void for_each_linear_number(L& ship, Visit&& visit) {
  const auto visit_part = [&](std::string_view table, auto& part) {
    for (const auto& parameter : parameter_list<std::remove_cvref_t<decltype(part)>>)
      visit(table, parameter, part.*parameter.member);
  };
  visit_part("particulars", ship.particulars);
  std::visit(
      [&](auto& form) {
        using Form = std::remove_cvref_t<decltype(form)>;
        if constexpr (std::is_same_v<Form, LinearParts<double>>)
          visit_part("hull", form.hull), visit_part("rudder", form.rudder);
        else visit_part(std::is_same_v<Form, SwayYawCoefficients<double>> ? "linear" : "nomoto", form);
      },
      ship.form);
  visit_part("rudder", ship.steering_gear);
}

Range in_units(Range range, double si) {
  range.low /= si, range.high /= si;
  return range;
}

}  // namespace

VariedShip::VariedShip(const SweepPlan& plan, const std::string& file)
    : text_(ship_text(file)), ship_(parse_any_ship(text_, file)), speed_(plan.speed) {
  name_ = std::visit([](const auto& ship) { return ship.name; }, ship_);
  const auto known = parameters();
  for (const auto& v : plan.variations) {
    const auto found =
        std::ranges::find_if(known, [&](const Known& k) { return k.name == v.name || k.qualified == v.name; });
    if (found == known.end()) {
      std::vector<std::string_view> names;
      for (const auto& k : known) names.push_back(k.name);
      throw FileError(
          v.place, fmt::format("{} has no parameter {}{}", name_, v.name, core::detail::did_you_mean(v.name, names)));
    }
    add(*found, law_of(*found, v, plan.design));
  }
  if (!plan.confidence) return;
  for (const auto& k : known)
    if (k.sd > 0.0 && std::ranges::find(columns_, k.name, &SweepColumn::name) == columns_.end())
      add(k, normal_law(k.value, k.sd, k.range));
}

std::vector<VariedShip::Known> VariedShip::parameters() const {
  std::vector<Known> known;
  const auto add = [&](std::string name, std::string_view table, std::string_view key, std::string_view unit,
                       double value, double sd, const Range& range, const Target& target) {
    known.push_back({std::move(name), fmt::format("{}.{}", table, key), std::string(unit), value, sd, range, target});
  };
  const auto add_speed = [&](double own) {
    add(std::string(approach_speed), "approach", approach_speed, "m/s", speed_.value_or(own), 0.0, positive,
        {.kind = Target::Kind::speed});
  };
  if (const auto* linear = std::get_if<LinearShip>(&ship_)) {
    std::size_t index = 0;
    for_each_linear_number(*linear, [&](std::string_view table, const auto& p, double value) {
      const double own = value / p.si;
      auto name = std::string(p.key);
      if (std::ranges::find(known, name, &Known::name) != known.end()) name = fmt::format("{}.{}", table, name);
      const double sd = p.role == Role::coefficient ? linear->confidence.of(p.key) * std::abs(own) : 0.0;
      add(std::move(name), table, p.key, p.unit, own, sd, p.range,
          {.kind = Target::Kind::linear, .index = index++, .si = p.si});
    });
    add_speed(linear->particulars.U_0);
    return known;
  }
  const auto& ship = std::get<Ship>(ship_);
  for (const auto& p : parameters_of(ship))
    add(p.name, p.table, p.key, p.unit, p.value / p.si, p.role == Role::coefficient ? p.deviation / p.si : 0.0,
        in_units(p.range, p.si), {.kind = Target::Kind::model, .index = p.index, .si = p.si});
  for (std::size_t e = 0; e < ship.effects.size(); ++e)
    for (const auto& p : parameters_of(ship, ship.effects[e])) {
      const auto id = id_of(ship.effects[e]);
      add(fmt::format("{}.{}", id, p.key), id, p.key, p.unit, p.value / p.si, 0.0, in_units(p.range, p.si),
          {.kind = Target::Kind::effect, .effect = e, .index = p.index, .si = p.si});
    }
  add_speed(service_speed(ship));
  return known;
}

void VariedShip::add(const Known& known, Law law) {
  laws_.push_back(std::move(law));
  columns_.push_back({known.name, known.unit, true});
  targets_.push_back(known.target);
}

Law VariedShip::law_of(const Known& known, const Variation& v, SweepDesign design) const {
  const auto require = [&](double value) {
    if (!known.range.contains(value))
      throw FileError(v.place, fmt::format("{} of {} cannot be {:g} {}", v.name, name_, value, known.unit));
  };
  if (!v.values.empty()) {
    std::ranges::for_each(v.values, require);
    return values_law(v.values);
  }
  if (v.from) {
    require(*v.from), require(*v.to);
    if (design != SweepDesign::grid) return uniform_law(*v.from, *v.to);
    std::vector<double> values(v.steps);
    for (std::size_t i = 0; i < v.steps; ++i)
      values[i] = v.steps == 1
                      ? *v.from
                      : *v.from + (*v.to - *v.from) * static_cast<double>(i) / static_cast<double>(v.steps - 1);
    return values_law(std::move(values));
  }
  const double sd = v.sd ? *v.sd : *v.relative_sd * std::abs(known.value);
  if (!(sd > 0.0))
    throw FileError(v.place,
                    fmt::format("{} of {} is 0, of which there is no share; give sd in its unit", v.name, name_));
  return normal_law(known.value, sd, known.range);
}

bool VariedShip::speed_varies() const {
  return std::ranges::any_of(targets_, [](const Target& t) { return t.kind == Target::Kind::speed; });
}

void VariedShip::put(ShipAtPoint& point, std::span<const double> values) const {
  const auto put_number = [&](Target::Kind kind, std::size_t place, double& number) {
    for (std::size_t i = 0; i < targets_.size(); ++i)
      if (targets_[i].kind == kind && targets_[i].index == place) number = values[i] * targets_[i].si;
  };
  std::size_t place = 0;
  if (auto* linear = std::get_if<LinearShip>(&point.ship)) {
    for_each_linear_number(*linear, [&](std::string_view, const auto&, double& number) {
      put_number(Target::Kind::linear, place++, number);
    });
  } else {
    auto& ship = std::get<Ship>(point.ship);
    std::visit(
        [&](auto& model) {
          for_each_value(model, [&](double& number) { put_number(Target::Kind::model, place++, number); });
        },
        ship.model);
    for (std::size_t i = 0; i < targets_.size(); ++i)
      if (const auto& t = targets_[i]; t.kind == Target::Kind::effect)
        parameter_value(ship.effects[t.effect], t.index) = values[i] * t.si;
  }
  for (std::size_t i = 0; i < targets_.size(); ++i)
    if (targets_[i].kind == Target::Kind::speed) point.speed = values[i];
}

}  // namespace swayaw::app
