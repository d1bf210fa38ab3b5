#include "effect_forms.hpp"

#include <algorithm>
#include <cmath>

#include "swayaw/core/angle.hpp"

namespace swayaw {
namespace {

bool is_direction(const EffectNumber& n) { return n.key.ends_with("from_rad") || n.key.ends_with("to_rad"); }

/// North and east part of what has a size and a direction, over its usual size.
EffectForm by_parts(const Effect& null, const EffectNumber& size, const EffectNumber& direction) {
  EffectForm form{.id = std::string(id_of(null)), .coordinates = {{"north"}, {"east"}}, .at = {}, .starts = {}};
  form.at = [null, a = size.index, b = direction.index, unit = size.prior](std::span<const double> c) {
    Effect effect = null;
    number_of(effect, a) = unit * std::hypot(c[0], c[1]);
    number_of(effect, b) = std::atan2(c[1], c[0]);
    return effect;
  };
  for (int i = 0; i < 4; ++i) form.starts.push_back({std::cos(0.4 + 0.5 * pi * i), std::sin(0.4 + 0.5 * pi * i)});
  return form;
}

/// The same for a time that is looked for in the whole run.
EffectForm in_window(EffectForm form, const Ship& ship, double duration) {
  const double T = length(ship) / service_speed(ship), whole = duration / T;
  const auto steady = form.at;
  for (const auto* name : {"onset", "end"}) form.coordinates.push_back({.name = name, .centre = 0.5 * whole, .deviation = whole, .low = 0.0, .high = whole});
  form.at = [steady, T](std::span<const double> c) {
    auto effect = steady(c.first(2));
    auto& gust = std::get<Gust<double>>(effect);
    gust.onset = c[2] * T;
    gust.end = std::max(c[3], c[2] + 0.05) * T;
    return effect;
  };
  std::vector<std::vector<double>> starts;
  for (const auto& parts : form.starts)
    for (const double from : {0.1, 0.3, 0.5, 0.7}) starts.push_back({parts[0], parts[1], from * whole, (from + 0.25) * whole});
  form.starts = std::move(starts);
  return form;
}

/// A number through a function of one coordinate.
template <class F>
EffectForm one_number(const Effect& null, Coordinate coordinate, std::vector<std::vector<double>> starts, F&& value) {
  return {.id = std::string(id_of(null)), .coordinates = {std::move(coordinate)},
          .at = [null, value](std::span<const double> c) {
            Effect effect = null;
            number_of(effect, 0) = value(c[0]);
            return effect;
          },
          .starts = std::move(starts)};
}

/// Numbers that a fit leaves where they are: they decide little, and no run tells them apart from the others.
bool is_left(std::string_view id, std::string_view key) {
  return (id == "steering_gear_lag" && key == "rate_rad_s") || (id == "propeller_side_force" && key == "constant_N") ||
         (id == "roll_coupling" && key != "Y_phi" && key != "N_phi");
}

/// Each number over its prior deviation.
EffectForm by_numbers(const Effect& null, std::span<const EffectNumber> numbers) {
  EffectForm form{.id = std::string(id_of(null)), .coordinates = {}, .at = {}, .starts = {}};
  std::vector<EffectNumber> moved;
  for (const auto& n : numbers)
    if (n.prior > 0.0 && !is_left(form.id, n.key)) moved.push_back(n);
  for (const auto& n : moved) {
    const double low = n.range.low > -HUGE_VAL ? (n.range.low - n.null) / n.prior + (n.range.above_low ? 1e-3 : 0.0) : -HUGE_VAL;
    const double high = n.range.high < HUGE_VAL ? (n.range.high - n.null) / n.prior : HUGE_VAL;
    form.coordinates.push_back({.name = std::string(n.key), .low = low, .high = high});
  }
  form.at = [null, moved](std::span<const double> c) {
    Effect effect = null;
    for (std::size_t i = 0; i < moved.size(); ++i) number_of(effect, moved[i].index) = moved[i].null + moved[i].prior * c[i];
    return effect;
  };
  form.starts = {std::vector<double>(moved.size(), 0.0)};
  return form;
}

/// Lag and play are 0 or more, and the likelihood has a corner there.
EffectForm begun_at(EffectForm form, std::vector<std::vector<double>> starts) {
  form.starts = std::move(starts);
  return form;
}

EffectForm memory(const Effect& null, std::span<const EffectNumber> numbers, double T) {
  auto form = by_numbers(null, numbers);
  form.coordinates[0] = {.name = "tau", .centre = 0.5, .deviation = 0.5, .low = 0.02, .high = 10.0};
  form.at = [null, T, unit = numbers[1].prior](std::span<const double> c) {
    Effect effect = null;
    number_of(effect, 0) = c[0] * T;
    number_of(effect, 1) = unit * c[1];
    return effect;
  };
  form.starts = {{0.5, 0.5}};
  return form;
}

std::vector<EffectForm> delays(const Effect& null, const EffectNumber& delay, std::span<const Channel> channels) {
  std::vector<Channel> late{Channel::delta};
  std::ranges::copy_if(channels, std::back_inserter(late), [](Channel c) { return c != Channel::y; });
  std::vector<EffectForm> forms;
  for (const auto channel : late) {
    auto form = by_numbers(null, {&delay, 1});
    form.at = [null, channel, unit = delay.prior](std::span<const double> c) {
      Effect effect = null;
      std::get<ChannelDelay<double>>(effect).channel = channel;
      std::get<ChannelDelay<double>>(effect).delay = unit * c[0];
      return effect;
    };
    forms.push_back(std::move(form));
  }
  return forms;
}

}  // namespace

std::optional<EffectForm> ordinary_lift_loss(const Ship& ship) {
  const Effect null = make_effect("rudder_gap");
  if (!cannot_act(ship.model, null).empty()) return std::nullopt;
  EffectForm form{.id = "rudder_gap", .coordinates = {{.name = "loss", .deviation = 0.2, .step = 0.02, .low = 0.0, .high = 1.0}}, .at = {}, .starts = {{0.0}}};
  form.at = [null](std::span<const double> c) {
    Effect effect = null;
    std::get<RudderGap<double>>(effect).s = -c[0];
    return effect;
  };
  return form;
}

std::vector<EffectForm> effect_forms(const Ship& ship, std::span<const Channel> channels, double duration) {
  const double T = length(ship) / service_speed(ship);
  std::vector<EffectForm> forms;
  for (const auto id : effect_ids()) {
    const Effect null = make_effect(id);
    const auto numbers = numbers_of(ship, null);
    if (numbers.empty()) continue;
    const auto size = std::ranges::find_if(numbers, &EffectNumber::decides), toward = std::ranges::find_if(numbers, is_direction);
    if (id == "steady_current") forms.push_back(begun_at(by_parts(null, *size, *toward), {{0.0, 0.0}}));
    else if (id == "gust") forms.push_back(in_window(by_parts(null, *size, *toward), ship, duration));
    else if (toward != numbers.end()) forms.push_back(by_parts(null, *size, *toward));
    else if (id == "shallow_water")
      forms.push_back(one_number(null, {.name = "draught over depth", .deviation = 0.5, .low = 0.0, .high = 0.83}, {{0.6}},
                                 [](double x) { return x > 0.02 ? 1.0 / x : HUGE_VAL; }));
    else if (id == "rudder_stall")
      forms.push_back(one_number(null, {.name = "stall angle", .centre = 0.6, .deviation = 0.5, .low = 0.08, .high = 0.5 * pi}, {{0.25}, {0.4}}, [](double x) { return x; }));
    else if (id == "rudder_gap") {
      EffectForm form = by_numbers(null, numbers);
      form.coordinates = {{.name = "from", .deviation = 0.3, .low = 0.0, .high = 0.5}, {.name = "loss", .low = 0.0, .high = 10.0}};
      form.at = [null](std::span<const double> c) {
        Effect effect = null;
        std::get<RudderGap<double>>(effect) = {c[0], -c[1]};
        return effect;
      };
      forms.push_back(begun_at(std::move(form), {{0.1, 0.3}}));
    } else if (id == "fluid_memory") forms.push_back(memory(null, numbers, T));
    else if (id == "steering_gear_lag" || id == "steering_gear_backlash") forms.push_back(begun_at(by_numbers(null, numbers), {{0.3}}));
    else if (id == "channel_delay") std::ranges::move(delays(null, numbers.front(), channels), std::back_inserter(forms));
    else forms.push_back(by_numbers(null, numbers));
  }
  return forms;
}

bool is_finding(const Ship& ship, const Effect& effect) {
  return std::ranges::any_of(numbers_of(ship, effect), [](const EffectNumber& n) { return n.decides && std::abs(n.value - n.null) > n.floor; });
}

}  // namespace swayaw
