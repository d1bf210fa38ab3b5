#include "effect_forms.hpp"

#include <algorithm>
#include <cmath>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/model_scale.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/identification/data_compatibility.hpp"
#include "swayaw/nonlinear/linearization.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"

namespace swayaw::inline mismatch::detail {
namespace {

/// The form of one kind as that of an effect.
template <class Kind>
EffectForm as_effect(SearchForm<Kind> form) {
  EffectForm result{.id = std::move(form.id),
                    .coordinates = std::move(form.coordinates),
                    .at = [at = std::move(form.at)](std::span<const double> c) { return Effect(at(c)); },
                    .starts = std::move(form.starts),
                    .window = std::move(form.window)};
  if (form.with_terms)
    result.with_terms = [with_terms = std::move(form.with_terms)](std::span<const std::size_t> kept) {
      return as_effect(with_terms(kept));
    };
  return result;
}

/// The form that the kind tells, or the usual one.
template <class Kind>
EffectForm form_of(const Kind& null, const SearchContext& context) {
  if constexpr (requires { search_form(null, context); }) return as_effect(search_form(null, context));
  else return as_effect(usual_form(null, context));
}

/// The same where the clock of the runs does not begin at 0.
EffectForm counted_from(EffectForm form, double begin) {
  form.begin = begin;
  form.at = [at = std::move(form.at), begin](std::span<const double> c) {
    auto effect = at(c);
    std::visit(
        [begin]<class Kind>(Kind& e) {
          if constexpr (BeginsAndEnds<Kind>) e.onset += begin, e.end += begin;
        },
        effect);
    return effect;
  };
  return form;
}

/// One of each channel: of the rudder, and of those seen, where a position has one receiver.
template <class Kind>
void add_forms_by_channel(std::vector<EffectForm>& forms, Kind null, const SearchContext& context,
                          std::span<const Channel> channels) {
  std::vector<Channel> all{Channel::delta};
  std::ranges::copy_if(channels, std::back_inserter(all), [](Channel c) { return c != Channel::y; });
  for (const auto channel : all) {
    if constexpr (requires { Kind::is_searched_in(channel); })
      if (!Kind::is_searched_in(channel)) continue;
    null.channel = channel;
    forms.push_back(form_of(null, context));
  }
}

}  // namespace

// ---------------------------------------------------------------- parts of the runs

std::vector<double> EffectForm::in_part(std::span<const double> c, std::size_t part) const {
  const auto size = common();
  std::vector<double> there(c.begin(), c.begin() + static_cast<std::ptrdiff_t>(size));
  if (part >= parts.size()) return there;
  for (std::size_t i = 0; i < size; ++i) there[i] += c[(part + 1) * size + i];
  return there;
}

std::size_t EffectForm::part_of(const Recording& run) const {
  if (parts.empty()) return 0;
  return static_cast<std::size_t>(std::ranges::find(parts, part_name(scope, run)) - parts.begin());
}

std::string part_name(Scope scope, const Recording& run) {
  if (scope == Scope::run) return run.name;
  const auto group = scope == Scope::group ? group_of(run) : "all";
  return group.empty() ? "no group" : group;
}

EffectForm differing(const EffectForm& form, Scope scope, std::span<const PreparedRun> runs) {
  EffectForm result = form;
  result.scope = scope;
  for (const auto& run : runs)
    if (const auto name = part_name(scope, *run.run); std::ranges::count(result.parts, name) == 0)
      result.parts.push_back(name);
  for (std::size_t part = 0; part < result.parts.size(); ++part)
    for (const auto& c : form.coordinates) result.coordinates.push_back(c);
  for (auto& start : result.starts) start.resize(result.coordinates.size(), 0.0);
  return result;
}

Eigen::MatrixXd part_map(const EffectForm& form, std::size_t part) {
  const auto size = static_cast<Eigen::Index>(form.common());
  Eigen::MatrixXd map = Eigen::MatrixXd::Zero(size, std::ssize(form.coordinates));
  map.leftCols(size).setIdentity();
  if (part < form.parts.size()) map.middleCols((static_cast<Eigen::Index>(part) + 1) * size, size).setIdentity();
  return map;
}

Eigen::MatrixXd mean_part_map(const EffectForm& form) {
  Eigen::MatrixXd sum = part_map(form, 0);
  for (std::size_t part = 1; part < form.parts.size(); ++part) sum += part_map(form, part);
  return sum / static_cast<double>(std::max<std::size_t>(1, form.parts.size()));
}

std::vector<double> mean_of_parts(const EffectForm& form, std::span<const double> c) {
  const Eigen::VectorXd mean = mean_part_map(form) * Eigen::Map<const Eigen::VectorXd>(c.data(), std::ssize(c));
  return {mean.begin(), mean.end()};
}

std::vector<Effect> effects_in_parts(const EffectForm& form, std::span<const double> c) {
  std::vector<Effect> effects;
  for (std::size_t part = 0; part < std::max<std::size_t>(1, form.parts.size()); ++part)
    effects.push_back(form.at(form.in_part(c, part)));
  return effects;
}

std::vector<EffectForm> differing_surroundings(std::span<const EffectForm> forms, std::span<const PreparedRun> runs) {
  std::vector<EffectForm> result;
  for (const auto& form : forms) {
    if (form.id != SteadyWind<>::id && form.id != SteadyCurrent<>::id) continue;
    for (const auto scope : {Scope::group, Scope::run})
      if (auto other = differing(form, scope, runs); other.parts.size() > 1) result.push_back(std::move(other));
  }
  return result;
}

EffectForm with_spread(EffectForm form, double factor) {
  for (std::size_t i = form.common(); i < form.coordinates.size(); ++i) form.coordinates[i].deviation *= factor;
  return form;
}

std::optional<EffectForm> ordinary_lift_loss(const Ship& ship) {
  const auto parameters = parameters_of(ship, RudderGap<>{});
  const auto s = std::ranges::find(parameters, "s", &Parameter::key);
  if (s == parameters.end() || s->null != 0.0) return std::nullopt;
  auto form = as_effect(usual_lift_loss());
  form.coordinates.front().step = 0.2, form.coordinates.front().high = HUGE_VAL;
  return form;
}

std::optional<Channel> channel_of(const EffectForm& form) {
  const std::vector<double> c(form.coordinates.size(), 0.0);
  const auto effect = form.at(c);
  const auto* channel = channel_of(effect);
  return channel ? std::optional(*channel) : std::nullopt;
}

std::optional<std::vector<double>> coordinates_of(const Ship& ship, const EffectForm& form, const Effect& effect) {
  const auto wanted = parameters_of(ship, effect);
  std::vector<double> c(form.common(), 0.0);
  const auto in_all_parts = [&](std::vector<double> found) {
    found.resize(form.coordinates.size(), 0.0);
    return found;
  };
  const auto at_null = parameters_of(ship, form.at(c));
  if (c.size() == 1) {
    const auto p = std::ranges::find(wanted, form.coordinates.front().name, &Parameter::key);
    if (p == wanted.end()) return std::nullopt;
    const auto i = static_cast<std::size_t>(p - wanted.begin());
    c[0] = 1.0;
    const double unit = parameters_of(ship, form.at(c))[i].value - at_null[i].value;
    return in_all_parts({(p->value - at_null[i].value) / unit});
  }
  if (c.size() != 2 || form.coordinates[0].name != "north") return std::nullopt;
  c = {1.0, 0.0};
  const auto unit = parameters_of(ship, form.at(c));
  double size = 0.0, direction = 0.0;
  for (std::size_t i = 0; i < wanted.size(); ++i)
    if (wanted[i].direction) direction = wanted[i].value;
    else if (wanted[i].decides && size == 0.0) size = wanted[i].value / unit[i].value;
  return in_all_parts({size * std::cos(direction), size * std::sin(direction)});
}

int axis_of_term(std::string_view name) {
  if (name == "Y_u" || name == "N_u") return asymmetric_axis;
  if (name == "Y_Rg" || name == "Y_Rw") return rudder_sides_axis;
  if (name == "X_uu") return straight_ahead_axis;
  return name[0] == 'X' ? 0 : name[0] == 'Y' ? 1 : 2;
}

namespace {

/// Root mean squares over the runs.
struct MotionSizes {
  double u = 0.0, v = 0.0, r = 0.0, delta = 0.0;  ///< u/U_0 − 1, v/U_0, rL/U_0, delta
};

MotionSizes sizes_of(const Ship& ship, std::span<const Recording> runs) {
  const double U = service_speed(ship), L = length(ship);
  const auto rms = [&](Channel channel, double unit, double about) {
    double sum = 0.0, count = 0.0;
    for (const auto& run : runs)
      for (const double x : run[channel])
        if (!std::isnan(x)) sum += std::pow(x / unit - about, 2), ++count;
    return count > 0.0 ? std::sqrt(sum / count) : 0.0;
  };
  MotionSizes s;
  for (const auto channel : {Channel::u, Channel::speed_through_water, Channel::speed_over_ground})
    if (s.u == 0.0) s.u = rms(channel, U, 1.0);
  s.r = rms(Channel::r, U / L, 0.0);
  for (const auto channel : {Channel::delta, Channel::delta_order})
    if (s.delta == 0.0) s.delta = rms(channel, 1.0, 0.0);
  s.u = std::max(s.u, 0.1), s.r = std::max(s.r, 0.1), s.delta = std::max(s.delta, 0.05);
  s.v = 0.4 * s.r;
  return s;
}

/// Slopes of the lift of her rudder, straight ahead at service speed, in ½ρL²U_0² and ½ρL³U_0² [1/rad].
struct RudderSlopes {
  double Y, N;
};

/// Mean of 40 simulated ships of five structures.
constexpr RudderSlopes usual_slopes{.Y = 3e-3, .N = 1.4e-3};

RudderSlopes rudder_slopes(const Ship& ship) try {
  constexpr double least = 0.1;  // of the usual: no form is exact
  const double U = service_speed(ship);
  const auto d = sname(linearize_transient(ship, {{U, 0.0, 0.0}, self_propulsion(ship, U)}));
  return {std::max(std::abs(d.Y_delta), least * usual_slopes.Y), std::max(std::abs(d.N_delta), least * usual_slopes.N)};
} catch (const Refusal&) {  // nothing drives her
  return usual_slopes;
}

/// A force of another form. What follows the motion of the hull is at order 1 as large as a tenth of her own force; at
/// service speed, straight ahead, X is a part of her resistance, and what follows the rudder a part of its lift. Of 40
/// simulated ships with nothing hidden (`swayaw_concealed`, plan on_board_clean, seed 41) terms of the hull had 0.3 to
/// 0.7 of that, the first term of the rudder 0.16 and 0.23 of its lift, what is lost beyond 15 and 28 deg and the drag
/// of the rudder 0.13 to 0.2 of the slope. As large as a tenth of the force on the hull as well, these hid a rudder
/// that is weak by a third. X straight ahead is told by the speed at which she begins a run and her shaft: in 41 ships
/// of seed 44 with a recorded shaft the file lacked 0.09 of 1e-3, root mean square, 0.85 and 0.96 of what its own
/// deviations of resistance and propeller allow in MMG and PI form, and 0.04 of 1e-3 in Abkowitz form, which has no
/// shaft. More than that, a third of the resistance, hid a resistance twice as large.
EffectForm force_form(const Ship& ship, std::span<const Recording> runs) {
  const auto m = sizes_of(ship, runs);
  const double Y = 1e-3 * (m.r / 0.3), X = 0.3 * Y, N = 0.2 * Y;  // a tenth of m u r, m' = 0.01
  constexpr double straight_ahead = 5e-5, of_lift = 0.2;
  const auto lift = rudder_slopes(ship);
  const double Y_R = of_lift * lift.Y, N_R = of_lift * lift.N;
  struct Term {
    std::string_view key;
    double usual;
  };
  constexpr double small = 0.05;  // of a force that differs from side to side: about half a degree of rudder
  // what a rudder differs by from side to side: γ_R of the KVLCC2 is 0.40 and 0.64, of the KCS 0.34 and 0.49.
  // Most files have a wake for each side, so that less is left of that: 0.006 and 0.009 in two simulated ships
  constexpr double of_flow = 0.1, of_wake = 0.01;
  const double u = 1.0, v = m.v, r = m.r, d = m.delta, beta_R = v + 0.9 * r, beta_P = v + 0.48 * r;
  const std::array terms{Term{"X_u", X / m.u},
                         Term{"X_uu", straight_ahead},
                         Term{"X_vv", X / (v * v)},
                         Term{"X_vr", X / (v * r)},
                         Term{"X_rr", X / (r * r)},
                         Term{"X_dd", Y_R},
                         Term{"Y_v", Y / (u * v)},
                         Term{"Y_r", Y / (u * r)},
                         Term{"Y_vv", Y / (v * v)},
                         Term{"Y_rr", Y / (r * r)},
                         Term{"Y_vr", Y / (v * r)},
                         Term{"Y_rv", Y / (v * r)},
                         Term{"Y_d", Y_R},
                         Term{"Y_d15", Y_R},
                         Term{"Y_a28", Y_R},
                         Term{"Y_u", small * Y / u},
                         Term{"N_v", N / (u * v)},
                         Term{"N_r", N / (u * r)},
                         Term{"N_vv", N / (v * v)},
                         Term{"N_rr", N / (r * r)},
                         Term{"N_vr", N / (v * r)},
                         Term{"N_rv", N / (v * r)},
                         Term{"N_d", N_R},
                         Term{"N_d15", N_R},
                         Term{"N_a28", N_R},
                         Term{"N_u", small * N / u},
                         Term{"Y_Rg", of_flow * Y / (u * beta_R)},
                         Term{"Y_Rw", of_wake * Y / (beta_P * d)}};
  EffectForm form{.id = std::string(form_id), .coordinates = {}, .at = {}, .starts = {}};
  const auto parameters = parameters_of(ship, ModelForm<>{});
  std::vector<std::pair<std::size_t, double>> moves;
  for (const auto& term : terms) {
    form.coordinates.push_back({.name = std::string(term.key), .step = 0.1});
    moves.emplace_back(std::ranges::find(parameters, term.key, &Parameter::key)->index, term.usual);
  }
  form.at = [moves = std::move(moves)](std::span<const double> c) {
    ModelForm<> force;
    for (std::size_t i = 0; i < moves.size(); ++i) parameter_value(force, moves[i].first) = c[i] * moves[i].second;
    return Effect(force);
  };
  return form;
}

/// How many times its usual size an ordinary error may be; what is larger is a finding, and not taken in silence.
constexpr double most_ordinary = 3.0;

/// One effect with a parameter of usual size, each coordinate counted in it.
template <class Kind>
void add_ordinary(std::vector<EffectForm>& forms, const Ship& ship, Kind null, std::string_view key, double usual) {
  const auto parameters = parameters_of(ship, null);
  const auto p = std::ranges::find(parameters, key, &Parameter::key);
  if (p == parameters.end()) return;
  const bool signless = p->range.low >= 0.0 && p->null == 0.0;
  forms.push_back(
      {.id = std::string(Kind::id),
       .coordinates =
           {{.name = std::string(key), .step = 0.1, .low = signless ? 0.0 : -most_ordinary, .high = most_ordinary}},
       .at =
           [null, index = p->index, about = p->null, usual](std::span<const double> c) {
             Kind effect = null;
             parameter_value(effect, index) = about + usual * c[0];
             return Effect(effect);
           },
       .starts = {}});
}

/// How many times its usual size an ordinary stream or wind may be on each axis: to its practical floor, beyond which
/// it is an effect, to be named. With a normal tail instead, streams of 0.035 to 0.05 U were found to 2 % and taken for
/// ordinary ones in four of seven cases as on board. Ordinary ones of such cases have up to 1.5 times, winds 1.9.
constexpr double most_of_a_day = 2.0;

/// The heading with which runs begin in the mean [rad], north where none is recorded.
double first_heading(std::span<const Recording> runs) {
  double north = 0.0, east = 0.0;
  for (const auto& run : runs) {
    const auto psi = run[Channel::psi];
    const auto first = std::ranges::find_if(psi, [](double value) { return std::isfinite(value); });
    if (first != psi.end()) north += std::cos(*first), east += std::sin(*first);
  }
  return std::atan2(east, north);
}

/// Parts of what has a direction along an axis and across it, of usual size.
/// @param axis  that turns with the runs, so that limits are the same wherever they were sailed [rad]
template <class Kind>
void add_ordinary_parts(std::vector<EffectForm>& forms, const Ship& ship, std::string_view size,
                        std::string_view direction, double usual, double axis) {
  const Kind null{};
  const auto parameters = parameters_of(ship, null);
  const auto p = std::ranges::find(parameters, size, &Parameter::key),
             q = std::ranges::find(parameters, direction, &Parameter::key);
  if (p == parameters.end()) return;
  const auto part = [](std::string name) {
    return Coordinate{.name = std::move(name), .step = 0.1, .low = -most_of_a_day, .high = most_of_a_day};
  };
  forms.push_back({.id = std::string(Kind::id),
                   .coordinates = {part("along"), part("across")},
                   .at =
                       [null, a = p->index, b = q->index, usual, axis](std::span<const double> c) {
                         Kind effect = null;
                         parameter_value(effect, a) = usual * std::hypot(c[0], c[1]);
                         parameter_value(effect, b) = wrapped(axis + std::atan2(c[1], c[0]));
                         return Effect(effect);
                       },
                   .starts = {}});
}

}  // namespace

double filter_delay(const Ship& ship) {
  constexpr double widest = 2.0;             // [s]
  constexpr double share_of_motion = 0.125;  // of L/U
  return length(ship) < longest_model ? std::min(widest, share_of_motion * time_unit_of(ship)) : widest;
}

std::vector<EffectForm> ordinary_forms(const Ship& ship, std::span<const Recording> runs,
                                       std::span<const Channel> channels) {
  const double U = service_speed(ship), L = length(ship);
  const auto seen = [&](std::initializer_list<Channel> some) {
    return std::ranges::any_of(some, [&](Channel c) { return std::ranges::count(channels, c) > 0; });
  };
  // of a receiver of positions and of what measures velocities, however long the ship
  constexpr double receiver_delay = 0.4;  // [s]
  std::vector<EffectForm> forms{force_form(ship, runs)};
  // Late by all that a filter may make it: held at three of its usual sizes, 0.6 s, the gyro of a ship of 65 m, behind
  // a lag of 2.0 s, left a compass whose clock ran (two cases as on board of seed 53).
  const auto add_smoothed = [&](Channel channel, double usual_delay) {
    add_ordinary(forms, ship, ChannelDelay<>{channel, {}}, "delay_s", usual_delay);
    forms.back().decided_in = std::max(1.0, filter_delay(ship) / (beyond_the_ordinary * usual_delay));
    forms.back().coordinates.front().high = std::max(most_ordinary, filter_delay(ship) / usual_delay);
  };
  if (seen({Channel::r})) {
    add_ordinary(forms, ship, GyroBias<>{}, "bias_rad_s", 3e-4);
    add_ordinary(forms, ship, GyroScale<>{}, "scale", 0.01);
    add_smoothed(Channel::r, 0.02 * L / U);
  }
  if (seen({Channel::u, Channel::speed_through_water})) add_ordinary(forms, ship, LogScale<>{}, "scale", 0.01);
  for (const auto velocity : {Channel::u, Channel::v, Channel::speed_through_water})
    if (seen({velocity})) add_smoothed(velocity, std::max(receiver_delay, 0.02 * L / U));
  // Those of R/V Gunnerus are turned by 2 deg. Beside none that is ordinary a force of waves stood for them in two of
  // three choices of three of her zigzags, beside a third of a degree in one of one; beside one degree they are found,
  // −2.4 to −2.8 deg, in three of three, and no waves. Beside a track the ordinary error of the compass stands for
  // both: it turns the way by velocity alike.
  constexpr double askew = radians(1.0);
  if (seen({Channel::v}) && !seen({Channel::x})) add_ordinary(forms, ship, VelocityAxes<>{}, "angle_rad", askew);
  if (seen({Channel::x})) {
    add_ordinary(forms, ship, HeadingBias<>{}, "bias_rad", radians(0.2));
    add_ordinary(forms, ship, ChannelDelay<>{Channel::x, {}}, "delay_s", std::max(receiver_delay, 0.03 * L / U));
  }
  if (seen({Channel::psi})) add_ordinary(forms, ship, ChannelDelay<>{Channel::psi, {}}, "delay_s", 0.02 * L / U);
  add_ordinary(forms, ship, RudderOffset<>{}, "offset_rad", radians(0.2));
  // of a single screw that turns one way: half a degree of neutral rudder
  if (cannot_act(ship.model, PropellerSideForce<>{}).empty())
    add_ordinary(forms, ship, PropellerSideForce<>{}, "share_of_thrust", 0.02);
  // the wash of the rudder, and what her roll does to it, come a little late or early
  add_ordinary(forms, ship, ChannelDelay<>{Channel::delta, {}}, "delay_s", 0.04 * L / U);
  add_ordinary(forms, ship, SteeringGearLag<>{}, "lag_s", 0.05 * L / U);
  const double axis = first_heading(runs);
  add_ordinary_parts<SteadyCurrent<>>(forms, ship, "current_speed_m_s", "current_to_rad", 0.01 * U, axis);
  add_ordinary_parts<SteadyWind<>>(forms, ship, "wind_speed_m_s", "wind_from_rad", 0.1 * U, axis);
  return forms;
}

Eigen::MatrixXd parameter_slopes(const Ship& ship, const EffectForm& form, const Eigen::VectorXd& c) {
  constexpr double step = 1e-4;
  const auto size = c.size();
  const auto parameters_at = [&](const Eigen::VectorXd& p) {
    return parameters_of(ship, form.at({p.data(), static_cast<std::size_t>(size)}));
  };
  Eigen::MatrixXd slopes(std::ssize(parameters_at(c)), size);
  for (Eigen::Index k = 0; k < size; ++k) {
    Eigen::VectorXd up = c, down = c;
    up[k] += step, down[k] -= step;
    const auto a = parameters_at(up), b = parameters_at(down);
    for (std::size_t i = 0; i < a.size(); ++i) {
      const double change = a[i].value - b[i].value;
      slopes(static_cast<Eigen::Index>(i), k) = (a[i].direction ? wrapped(change) : change) / (2.0 * step);
    }
  }
  return slopes;
}

EffectForm unknown_map(const Ship& ship) {
  const UnknownForce<> null;
  auto terms = parameters_of(ship, null);
  std::erase_if(terms, [](const Parameter& p) { return !p.decides || p.key == "drag"; });
  return as_effect(by_parameters(null, std::span<const Parameter>(terms)));
}

std::vector<EffectForm> effect_forms(const Ship& ship, std::span<const Channel> channels, double duration,
                                     double begin) {
  std::vector<EffectForm> forms;
  for_each_kind([&]<class Kind>() {
    const Kind null{};
    const auto parameters = parameters_of(ship, null);
    if (parameters.empty() || Kind::id == form_id) return;
    const SearchContext context{.parameters = parameters,
                                .time_unit = time_unit_of(ship),
                                .duration = duration,
                                .rudder_rate = steering_gear(ship).rate};
    if constexpr (requires { null.channel; }) add_forms_by_channel(forms, null, context, channels);
    else if constexpr (BeginsAndEnds<Kind>) forms.push_back(counted_from(form_of(null, context), begin));
    else forms.push_back(form_of(null, context));
    if constexpr (requires { drag_form(null, context); }) forms.push_back(as_effect(drag_form(null, context)));
  });
  return forms;
}

bool is_finding(const Ship& ship, const Effect& effect) {
  const auto parameters = parameters_of(ship, effect);
  return !parameters.empty() && !is_ordinary(effect, parameters) &&
         std::ranges::any_of(parameters,
                             [](const Parameter& p) { return p.decides && !(std::abs(p.value - p.null) <= p.floor); });
}

bool is_finding(const Ship& ship, const EffectForm& form, std::span<const double> c) {
  return std::ranges::any_of(effects_in_parts(form, c), [&](const Effect& e) { return is_finding(ship, e); });
}

bool is_at_its_end(const EffectForm& form, std::span<const double> coordinates) {
  constexpr double near = 0.02;  // of its prior deviation
  if (form.coordinates.size() != 1) return false;
  const auto& c = form.coordinates.front();
  const bool has_two_signs = c.low < 0.0;
  return !(coordinates.front() < c.high - near) || (has_two_signs && !(coordinates.front() > c.low + near));
}

}  // namespace swayaw::mismatch::detail
