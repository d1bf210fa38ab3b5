#include "effect_forms.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "swayaw/core/angle.hpp"
#include "swayaw/nonlinear/rudder_lift_loss.hpp"

namespace swayaw {

bool is_direction(const Parameter& n) { return n.key.ends_with("from_rad") || n.key.ends_with("to_rad"); }

namespace {

const Parameter& number_named(std::span<const Parameter> numbers, std::string_view key) {
  return *std::ranges::find(numbers, key, &Parameter::key);
}

// ---------------------------------------------------------------- one coordinate, one number

/// A number of an effect as a function of a coordinate.
struct Move {
  Coordinate coordinate;
  std::size_t index;
  std::function<double(double)> value;
};

/// From null in prior deviations, within the number's range.
Move from_null(const Parameter& n) {
  const double low =
      n.range.low > -HUGE_VAL ? (n.range.low - n.null) / n.deviation + (n.range.above_low ? 1e-3 : 0.0) : -HUGE_VAL;
  const double high = n.range.high < HUGE_VAL ? (n.range.high - n.null) / n.deviation : HUGE_VAL;
  return {{.name = std::string(n.key), .low = low, .high = high}, n.index, [n](double c) {
            return n.null + n.deviation * c;
          }};
}

/// A positive number that is known but for a factor: exp(c) times its null value.
Move by_factor(const Parameter& n, double deviation) {
  return {{.name = std::string(n.key), .deviation = deviation, .step = 0.05, .low = -4.0, .high = 4.0},
          n.index,
          [n](double c) { return n.null * std::exp(c); }};
}

EffectForm by_moves(const Effect& null, std::vector<Move> moves, std::vector<std::vector<double>> starts) {
  EffectForm form{.id = std::string(id_of(null)), .coordinates = {}, .at = {}, .starts = std::move(starts)};
  for (const auto& m : moves) form.coordinates.push_back(m.coordinate);
  form.at = [null, moves = std::move(moves)](std::span<const double> c) {
    Effect effect = null;
    for (std::size_t i = 0; i < moves.size(); ++i) parameter_value(effect, moves[i].index) = moves[i].value(c[i]);
    return effect;
  };
  return form;
}

EffectForm by_numbers(const Effect& null, std::span<const Parameter> numbers) {
  std::vector<Move> moves;
  for (const auto& n : numbers) moves.push_back(from_null(n));
  const std::vector<double> start(moves.size(), 0.0);
  auto form = by_moves(null, std::move(moves), {start});
  if (numbers.size() < 2) return form;
  form.with_terms = [null, all = std::vector(numbers.begin(), numbers.end())](std::span<const std::size_t> kept) {
    std::vector<Parameter> some;
    for (const auto i : kept) some.push_back(all[i]);
    return by_numbers(null, some);
  };
  return form;
}

// ---------------------------------------------------------------- directions

/// North and east part of what has a size and a direction, over its usual size; then further numbers.
EffectForm by_parts(const Effect& null, const Parameter& size, const Parameter& direction,
                    std::vector<Move> further = {}) {
  EffectForm form{.id = std::string(id_of(null)), .coordinates = {{"north"}, {"east"}}, .at = {}, .starts = {}};
  for (const auto& m : further) form.coordinates.push_back(m.coordinate);
  for (int i = 0; i < 4; ++i) {
    form.starts.push_back({std::cos(0.4 + 0.5 * pi * i), std::sin(0.4 + 0.5 * pi * i)});
    for (const auto& m : further) form.starts.back().push_back(m.coordinate.centre);
  }
  form.at = [null, a = size.index, b = direction.index, unit = size.deviation,
             further = std::move(further)](std::span<const double> c) {
    Effect effect = null;
    parameter_value(effect, a) = unit * std::hypot(c[0], c[1]);
    parameter_value(effect, b) = std::atan2(c[1], c[0]);
    for (std::size_t i = 0; i < further.size(); ++i)
      parameter_value(effect, further[i].index) = further[i].value(c[2 + i]);
    return effect;
  };
  return form;
}

/// The same for a time that is looked for in the whole run.
EffectForm in_window(EffectForm form, const Ship& ship, double duration) {
  const double T = length(ship) / service_speed(ship), whole = duration / T;
  const auto steady = form.at;
  for (const auto* name : {"onset", "end"})
    form.coordinates.push_back({.name = name, .centre = 0.5 * whole, .deviation = whole, .low = 0.0, .high = whole});
  form.at = [steady, T](std::span<const double> c) {
    auto effect = steady(c.first(2));
    auto& gust = std::get<Gust<double>>(effect);
    gust.onset = c[2] * T;
    gust.end = std::max(c[3], c[2] + 0.05) * T;
    return effect;
  };
  std::vector<std::vector<double>> starts;
  for (const auto& parts : form.starts)
    for (const double from : {0.1, 0.3, 0.5, 0.7})
      starts.push_back({parts[0], parts[1], from * whole, (from + 0.25) * whole});
  form.starts = std::move(starts);
  return form;
}

EffectForm wave_form(const Effect& null, std::span<const Parameter> numbers) {
  auto ahead = from_null(number_named(numbers, "ahead")), moment = from_null(number_named(numbers, "moment"));
  return by_parts(null, number_named(numbers, "force_N"), number_named(numbers, "wave_from_rad"),
                  {std::move(ahead), std::move(moment)});
}

// ---------------------------------------------------------------- forms of their own

/// Draught over depth, and how much of the usual growth she shows: all of it, and each kind.
EffectForm shallow_form(const Effect& null) {
  EffectForm form{.id = std::string(id_of(null)),
                  .coordinates = {{.name = "draught over depth", .deviation = 0.5, .low = 0.0, .high = 0.9}},
                  .at = {},
                  .starts = {}};
  for (const auto* kind : {"growth", "sway", "yaw", "cubic", "mass", "resistance"})
    form.coordinates.push_back({.name = kind, .deviation = 0.35, .low = -0.7, .high = 0.7});
  form.coordinates.push_back({.name = "wake", .centre = 0.5, .deviation = 0.5, .low = 0.0, .high = 2.0});
  form.at = [](std::span<const double> c) {
    if (c[0] < 0.02) return Effect(ShallowWater<double>{});
    const auto grown = [&](std::size_t i) { return std::exp(c[1] + c[i]); };
    return Effect(ShallowWater<double>{1.0 / c[0], grown(2), grown(3), grown(4), grown(5), grown(6), c[7]});
  };
  for (const double x : {0.45, 0.7}) form.starts.push_back({x, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.5});
  return form;
}

EffectForm stall_form(const Effect& null, std::span<const Parameter> numbers) {
  const auto& [angle, depth, width] = std::tie(numbers[0], numbers[1], numbers[2]);
  Move at{{.name = "stall angle", .centre = 0.6, .deviation = 0.5, .low = 0.08, .high = 0.5 * pi},
          angle.index,
          [](double c) { return c; }};
  return by_moves(null, {std::move(at), from_null(depth), by_factor(width, 0.5)}, {{0.25, 0.0, 0.0}, {0.4, 0.0, 0.0}});
}

/// About the ship's own gap.
EffectForm gap_form(const Effect& null, std::span<const Parameter> numbers) {
  const double from = numbers[0].null, loss = -numbers[1].null;
  EffectForm form{
      .id = std::string(id_of(null)),
      .coordinates = {{.name = "from", .centre = from, .deviation = 0.3, .low = 0.0, .high = std::max(0.5, from)},
                      {.name = "loss", .centre = loss, .low = 0.0, .high = 10.0 + loss}},
      .at =
          [](std::span<const double> c) {
            return Effect(RudderGap<double>{c[0], -c[1]});
          },
      .starts = {{from + 0.1, loss + 0.3}}};
  return form;
}

/// Lag over its usual size, and how many times slower than the ship's gear the rudder moves; 0 for no limit.
EffectForm gear_form(const Effect& null, const Ship& ship, const Parameter& lag) {
  EffectForm form{.id = std::string(id_of(null)),
                  .coordinates = {{.name = "lag", .low = 0.0}, {.name = "slowness", .deviation = 0.7, .low = 0.0}},
                  .at = {},
                  .starts = {{0.3, 0.5}, {1.0, 0.1}}};
  form.at = [unit = lag.deviation, rate = steering_gear(ship).rate](std::span<const double> c) {
    SteeringGearLag<double> gear{.lag = unit * c[0]};
    if (c[1] > 0.02) gear.rate = rate / c[1];
    return Effect(gear);
  };
  return form;
}

/// Heel: its moment and damping are known but for factors. The lever counts with GM alone.
EffectForm roll_form(const Effect& null, std::span<const Parameter> numbers) {
  auto GM = by_factor(number_named(numbers, "GM_m"), 1.0), zeta = by_factor(number_named(numbers, "zeta"), 0.7);
  auto Y = from_null(number_named(numbers, "Y_phi")), N = from_null(number_named(numbers, "N_phi"));
  return by_moves(null, {std::move(GM), std::move(Y), std::move(N), std::move(zeta)},
                  {{0.0, 0.1, -0.1, 0.0}, {-1.2, 0.1, -0.1, 0.0}});
}

EffectForm memory_form(const Effect& null, std::span<const Parameter> numbers, double T) {
  Move tau{
      {.name = "tau", .centre = 0.5, .deviation = 0.5, .low = 0.02, .high = 10.0}, 0, [T](double c) { return c * T; }};
  return by_moves(null, {std::move(tau), from_null(numbers[1])}, {{0.5, 0.5}});
}

std::vector<EffectForm> delays(const Effect& null, const Parameter& delay, std::span<const Channel> channels) {
  std::vector<Channel> late{Channel::delta};
  std::ranges::copy_if(channels, std::back_inserter(late), [](Channel c) { return c != Channel::y; });
  std::vector<EffectForm> forms;
  for (const auto channel : late) {
    auto form = by_numbers(null, {&delay, 1});
    form.at = [null, channel, unit = delay.deviation](std::span<const double> c) {
      Effect effect = null;
      std::get<ChannelDelay<double>>(effect).channel = channel;
      std::get<ChannelDelay<double>>(effect).delay = unit * c[0];
      return effect;
    };
    forms.push_back(std::move(form));
  }
  return forms;
}

/// A constant force on the ship from a time to a time, as of a tug.
EffectForm push_form(const Effect& null, std::span<const Parameter> numbers, double T, double duration) {
  const double whole = duration / T;
  std::vector<Move> moves;
  for (const auto* key : {"X_0", "Y_0", "N_0"}) moves.push_back(from_null(number_named(numbers, key)));
  for (const auto* key : {"onset_s", "end_s"})
    moves.push_back({{.name = key, .centre = 0.5 * whole, .deviation = whole, .low = 0.0, .high = whole},
                     number_named(numbers, key).index,
                     [T](double c) { return c * T; }});
  auto form = by_moves(null, std::move(moves), {});
  for (const double from : {0.1, 0.3, 0.5, 0.7})
    form.starts.push_back({0.0, 0.0, 0.0, from * whole, (from + 0.25) * whole});
  form.at = [at = std::move(form.at), T](std::span<const double> c) {
    auto effect = at(c);
    auto& push = std::get<UnknownForce<double>>(effect);
    push.end = std::max(push.end, push.onset + 0.05 * T);
    return effect;
  };
  return form;
}

EffectForm begun_at(EffectForm form, std::vector<std::vector<double>> starts) {
  form.starts = std::move(starts);
  return form;
}

/// The form of any effect but a delay.
EffectForm form_of(const Effect& null, std::span<const Parameter> numbers, const Ship& ship, double duration) {
  const auto id = id_of(null);
  if (id == "wave_drift") return wave_form(null, numbers);
  if (id == UnknownForce<>::id) return push_form(null, numbers, length(ship) / service_speed(ship), duration);
  if (id == "shallow_water") return shallow_form(null);
  if (id == "rudder_stall") return stall_form(null, numbers);
  if (id == "rudder_gap") return gap_form(null, numbers);
  if (id == "steering_gear_lag") return gear_form(null, ship, numbers.front());
  if (id == "roll_coupling") return roll_form(null, numbers);
  if (id == "fluid_memory") return memory_form(null, numbers, length(ship) / service_speed(ship));
  if (id == "steering_gear_backlash") return begun_at(by_numbers(null, numbers), {{0.3}});
  if (id == "propeller_side_force")
    return by_numbers(null, numbers.first(1));  // a constant force is a rudder offset's twin
  const auto size = std::ranges::find_if(numbers, &Parameter::decides),
             toward = std::ranges::find_if(numbers, is_direction);
  if (toward == numbers.end()) return by_numbers(null, numbers);
  const auto parts = by_parts(null, *size, *toward);
  if (id == "gust") return in_window(parts, ship, duration);
  return id == "steady_current" ? begun_at(parts, {{0.0, 0.0}}) : parts;
}

}  // namespace

std::optional<EffectForm> ordinary_lift_loss(const Ship& ship) {
  const Effect null = make_effect("rudder_gap");
  const auto numbers = parameters_of(ship, null);
  if (numbers.empty() || number_named(numbers, "s").null != 0.0) return std::nullopt;
  EffectForm form{.id = "rudder_gap",
                  .coordinates = {{.name = "loss", .deviation = 0.2, .step = 0.02, .low = 0.0, .high = 1.0}},
                  .at = {},
                  .starts = {{0.0}}};
  form.at = [](std::span<const double> c) { return Effect(RudderGap<double>{0.0, -c[0]}); };
  return form;
}

Eigen::MatrixXd number_slopes(const Ship& ship, const EffectForm& form, const Eigen::VectorXd& c) {
  constexpr double step = 1e-4;
  const auto size = c.size();
  const auto numbers_at = [&](const Eigen::VectorXd& p) {
    return parameters_of(ship, form.at({p.data(), static_cast<std::size_t>(size)}));
  };
  Eigen::MatrixXd slopes(std::ssize(numbers_at(c)), size);
  for (Eigen::Index k = 0; k < size; ++k) {
    Eigen::VectorXd up = c, down = c;
    up[k] += step, down[k] -= step;
    const auto a = numbers_at(up), b = numbers_at(down);
    for (std::size_t i = 0; i < a.size(); ++i) {
      const double change = a[i].value - b[i].value;
      slopes(static_cast<Eigen::Index>(i), k) = (is_direction(a[i]) ? wrapped(change) : change) / (2.0 * step);
    }
  }
  return slopes;
}

EffectForm unknown_map(const Ship& ship) {
  const Effect null = make_effect(UnknownForce<>::id);
  auto terms = parameters_of(ship, null);
  std::erase_if(terms, [](const Parameter& n) { return !n.decides; });
  return by_numbers(null, terms);
}

std::vector<EffectForm> effect_forms(const Ship& ship, std::span<const Channel> channels, double duration) {
  std::vector<EffectForm> forms;
  for (const auto id : effect_ids()) {
    const Effect null = make_effect(id);
    const auto numbers = parameters_of(ship, null);
    if (numbers.empty()) continue;
    if (id == "channel_delay") std::ranges::move(delays(null, numbers.front(), channels), std::back_inserter(forms));
    else forms.push_back(form_of(null, numbers, ship, duration));
  }
  return forms;
}

namespace {

/// A rudder that loses less than this share of its lift at 35 deg does what every rudder does.
constexpr double ordinary_loss = 0.1;

/// Whether a stall or a gap costs more lift than that, or another gap than the ship's own changes it by more.
bool is_lift_lost(const Ship& ship, const Effect& effect) {
  const double alpha = radians(35.0);
  if (const auto* stall = std::get_if<RudderStall<double>>(&effect))
    return 1.0 - stall_factor(Stall<double>{stall->angle, stall->depth, stall->width}, alpha) > ordinary_loss;
  if (!std::holds_alternative<RudderGap<double>>(effect)) return true;
  const auto numbers = parameters_of(ship, effect);
  const auto left = [&](double Parameter::*value) {
    return open_gap_factor(numbers[0].*value, numbers[1].*value, alpha);
  };
  return std::abs(left(&Parameter::null) - left(&Parameter::value)) > ordinary_loss;
}

}  // namespace

bool is_finding(const Ship& ship, const Effect& effect) {
  return is_lift_lost(ship, effect) && std::ranges::any_of(parameters_of(ship, effect), [](const Parameter& n) {
           return n.decides && !(std::abs(n.value - n.null) <= n.floor);
         });
}

}  // namespace swayaw
