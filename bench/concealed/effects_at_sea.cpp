#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>

#include "concealed_case.hpp"
#include "random_source.hpp"
#include "swayaw/core/angle.hpp"

namespace swayaw::concealed {
namespace {

using Three = std::array<double, 3>;  ///< weak, moderate, strong
using Numbers = std::vector<LabelNumber>;

/// What a recipe works with. Level 0 is weak, 1 moderate, 2 strong; between and beyond them sizes go in equal ratios.
struct Kitchen {
  Concealment& h;
  double level;
  const TrueShip& s;
  const MmgShip<double>& file;
  RandomSource& random;
  Label& label;

  double size(const Three& sizes) const {
    const auto below = static_cast<std::size_t>(std::clamp(std::floor(level), 0.0, 1.0));
    const double on = level - static_cast<double>(below);
    return on == 0.0   ? sizes[below]
           : on == 1.0 ? sizes[below + 1]
                       : sizes[below] * std::pow(sizes[below + 1] / sizes[below], on);
  }
  double either_way(const Three& sizes) {
    const double sign = random.sign();
    return sign * size(sizes);
  }
  double direction() { return random.uniform(0.0, 2.0 * pi); }
};

/// Gives departures of coefficients; they are told as values of the ship file.
Numbers changed(std::initializer_list<std::tuple<const char*, double, double>> list) {
  Numbers parameters;
  for (const auto& [key, file, change] : list)
    if (change != 0.0) parameters.push_back({key, file + change});
  return parameters;
}

Numbers wind(Kitchen& k) {
  k.h.wind_speed = k.size({0.8, 1.3, 2.0}) * k.s.U_0, k.h.wind_from = k.direction();
  return {{"wind_speed_m_s", k.h.wind_speed}, {"wind_from_rad", k.h.wind_from}};
}

Numbers gust(Kitchen& k) {
  const double T = k.s.time_unit();
  k.h.gust_speed = k.size({1.2, 1.8, 2.6}) * k.s.U_0, k.h.gust_from = k.direction();
  k.h.gust_onset = k.random.uniform(5.0, 11.0) * T, k.h.gust_end = k.h.gust_onset + k.random.uniform(5.0, 9.0) * T;
  return {{"wind_speed_m_s", k.h.gust_speed},
          {"wind_from_rad", k.h.gust_from},
          {"onset_s", k.h.gust_onset},
          {"end_s", k.h.gust_end}};
}

Numbers current(Kitchen& k) {
  k.h.current_speed = k.size({0.035, 0.07, 0.12}) * k.s.U_0, k.h.current_to = k.direction();
  return {{"current_speed_m_s", k.h.current_speed}, {"current_to_rad", k.h.current_to}};
}

Numbers waves(Kitchen& k) {
  k.h.wave_force = k.size({0.003, 0.007, 0.014}) * 0.5 * 1025.0 * k.s.L * k.s.d * k.s.U_0 * k.s.U_0,
  k.h.wave_from = k.direction();
  return {{"force_N", k.h.wave_force}, {"wave_from_rad", k.h.wave_from}};
}

Numbers shallow(Kitchen& k) {
  const double depth = k.size({2.2, 1.7, 1.35});
  k.h.draught_over_depth = 1.0 / depth;
  return {{"depth_over_draught", depth}};
}

Numbers linear_derivatives(Kitchen& k) {
  const Three size{0.08, 0.18, 0.30};
  auto& h = k.h;
  const auto& f = k.file.hull;
  h.Y_v = k.either_way(size) * k.s.Y_v, h.Y_r = k.either_way(size) * k.s.Y_r,
  h.N_v = k.either_way(size) * 0.5 * k.s.N_v, h.N_r = k.either_way(size) * k.s.N_r;
  return changed({{"Y_v", f.Y_v, h.Y_v}, {"Y_r", f.Y_r, h.Y_r}, {"N_v", f.N_v, h.N_v}, {"N_r", f.N_r, h.N_r}});
}

Numbers cubic_damping(Kitchen& k) {
  auto& h = k.h;
  const auto& f = k.file.hull;
  h.Y_vvr = k.either_way({0.12, 0.30, 0.55}), h.Y_vrr = k.either_way({0.12, 0.30, 0.55}),
  h.N_vvr = -k.size({0.05, 0.12, 0.22}), h.N_vrr = k.size({0.02, 0.05, 0.10});
  return changed({{"Y_vvr", f.Y_vvr, h.Y_vvr},
                  {"Y_vrr", f.Y_vrr, h.Y_vrr},
                  {"N_vvr", f.N_vvr, h.N_vvr},
                  {"N_vrr", f.N_vrr, h.N_vrr}});
}

Numbers cross_flow(Kitchen& k) {
  k.h.cross_flow = k.size({0.2, 0.45, 0.9});
  return {{"drag_coefficient", k.h.cross_flow}};
}

Numbers resistance(Kitchen& k) {
  k.h.resistance = k.size({0.15, 0.35, 0.7});
  return {{"relative_increase", k.h.resistance}};
}

Numbers loss_in_turn(Kitchen& k) {
  auto& h = k.h;
  const auto& f = k.file.hull;
  h.X_vv = -k.size({0.04, 0.10, 0.20}), h.X_rr = -k.size({0.006, 0.014, 0.028}), h.X_vr = k.size({0.01, 0.025, 0.05});
  return changed({{"X_vv", f.X_vv, h.X_vv}, {"X_rr", f.X_rr, h.X_rr}, {"X_vr", f.X_vr, h.X_vr}});
}

Numbers added_mass(Kitchen& k) {
  k.h.m_y = k.either_way({0.12, 0.25, 0.45}) * k.s.m_y, k.h.J_z = k.either_way({0.12, 0.25, 0.45}) * k.s.J_z;
  return changed({{"m_y", k.file.added_mass.m_y, k.h.m_y}, {"J_z", k.file.added_mass.J_z, k.h.J_z}});
}

Numbers rudder_lift(Kitchen& k) {
  k.h.lift = k.either_way({0.08, 0.18, 0.32});
  return {{"factor", 1.0 + k.h.lift}};
}

Numbers rudder_hull(Kitchen& k) {
  k.h.a_H = k.either_way({0.08, 0.16, 0.28});
  return changed({{"a_H", k.file.rudder.a_H, k.h.a_H}});
}

Numbers stall(Kitchen& k) {
  k.h.stall_angle = k.size({0.40, 0.31, 0.22});
  return {{"stall_angle_rad",
           k.h.stall_angle + 0.5 * stall_span}};  // where half of the loss has come, as docs/effects.md counts it
}

/// Parameters of the law of docs/effects.md, 1 + s (|δ| − δ_lim)², that is nearest to the true curve from 0 to 35 deg.
Numbers nearest_gap(double from, double strength) {
  double least = HUGE_VAL;
  Numbers best;
  for (double limit = 0.0; limit < from + 0.05; limit += 1e-3) {
    double xy = 0.0, xx = 0.0, yy = 0.0;
    for (double delta = 0.0; delta < radians(35.0); delta += 1e-3) {
      const double beyond = std::max(0.0, delta - limit), x = beyond * beyond,
                   y = kept_through_gap(delta, from, strength) - 1.0;
      xy += x * y, xx += x * x, yy += y * y;
    }
    const double s = xy / xx, error = yy - s * xy;
    if (error < least) least = error, best = {{"delta_lim_rad", limit}, {"s", s}};
  }
  return best;
}

Numbers gap(Kitchen& k) {
  k.h.gap_angle = k.size({0.30, 0.22, 0.14}), k.h.gap_strength = -k.size({3.0, 5.0, 8.0});
  return nearest_gap(k.h.gap_angle, k.h.gap_strength);
}

Numbers straightening(Kitchen& k) {
  k.h.straightening = k.either_way({0.15, 0.30, 0.50});
  const auto& f = k.file.rudder;
  return changed({{"gamma_R_negative", f.gamma_R_negative, k.h.straightening * f.gamma_R_negative},
                  {"gamma_R_positive", f.gamma_R_positive, k.h.straightening * f.gamma_R_positive}});
}

Numbers race(Kitchen& k) {
  k.h.kappa = k.either_way({0.10, 0.20, 0.35});
  return changed({{"kappa", k.file.rudder.kappa, k.h.kappa}});
}

Numbers side_force(Kitchen& k) {
  k.h.side_force = k.either_way({0.008, 0.018, 0.035});
  return {{"share_of_thrust", k.h.side_force}};
}

Numbers wake(Kitchen& k) {
  k.h.wake_positive = k.either_way({0.15, 0.30, 0.45}), k.h.wake_negative = k.either_way({0.15, 0.30, 0.45});
  const auto& f = k.file.propeller;
  return changed(
      {{"C2_positive", f.C_2_positive, k.h.wake_positive}, {"C2_negative", f.C_2_negative, k.h.wake_negative}});
}

Numbers shaft_drop(Kitchen& k) {
  k.h.shaft_drop = k.size({0.04, 0.08, 0.15});
  return {{"relative_drop", k.h.shaft_drop}};
}

Numbers offset(Kitchen& k) {
  k.h.rudder_offset = k.either_way({radians(0.6), radians(1.2), radians(2.5)});
  return {{"offset_rad", k.h.rudder_offset}};
}

Numbers lag(Kitchen& k) {
  k.h.rudder_lag = k.size({0.05, 0.12, 0.25}) * k.s.time_unit();
  return {{"lag_s", k.h.rudder_lag}};
}

Numbers play(Kitchen& k) {
  k.h.rudder_play = k.size({radians(1.0), radians(2.0), radians(3.5)});
  return {{"width_rad", k.h.rudder_play}};
}

/// A heel that in a turn with r' = 0.4 moves the ship like some share of her rudder.
/// A hard turn heels her by 5 to 10 deg: with more stability only forces by heel ten times those of [Son1982] would be
/// felt.
Numbers roll(Kitchen& k) {
  const double heel = k.random.uniform(0.08, 0.18);
  k.h.GM = 0.5 * k.s.d * 0.4 * k.s.U_0 * k.s.U_0 / k.s.L / (9.81 * heel);
  k.h.N_phi = -k.size({0.0006, 0.0014, 0.0028}) / heel, k.h.Y_phi = 0.8 * k.h.N_phi;
  return {{"GM_m", k.h.GM}, {"Y_phi", k.h.Y_phi}, {"N_phi", k.h.N_phi}};
}

Numbers memory(Kitchen& k) {
  k.h.memory_tau = k.random.uniform(0.4, 0.8) * k.s.time_unit(), k.h.memory_share = k.size({0.15, 0.30, 0.50});
  return {{"tau_s", k.h.memory_tau}, {"share", k.h.memory_share}};
}

Numbers heading(Kitchen& k) {
  k.h.heading_bias = k.either_way({radians(0.7), radians(1.5), radians(3.0)});
  return {{"bias_rad", k.h.heading_bias}};
}

Numbers gyro(Kitchen& k) {
  k.h.gyro_bias = k.either_way({0.004, 0.010, 0.020}) / k.s.time_unit();
  return {{"bias_rad_s", k.h.gyro_bias}};
}

Numbers log_factor(Kitchen& k) {
  k.h.log_scale = k.either_way({0.02, 0.05, 0.10});
  return {{"scale", 1.0 + k.h.log_scale}};
}

Numbers antenna(Kitchen& k) {
  k.h.antenna_x = k.either_way({0.05, 0.15, 0.40}) * k.s.L, k.h.antenna_y = 0.2 * k.random.sign() * k.s.B;
  return {{"x_m", k.h.antenna_x}, {"y_m", k.h.antenna_y}};
}

Numbers delay(Kitchen& k) {
  constexpr std::array channels{Channel::psi, Channel::r, Channel::x, Channel::delta};
  k.h.late = channels[k.random.below(channels.size())], k.h.delay = k.size({0.05, 0.12, 0.25}) * k.s.time_unit();
  k.label.channel = short_name(k.h.late);
  return {{"delay_s", k.h.delay}};
}

// ---------------------------------------------------------------- not in the table

template <double Concealment::*number>
Numbers grown(Kitchen& k, const Three& sizes) {
  k.h.*number = k.size(sizes);
  return {};
}

Numbers kelp(Kitchen& k) {
  k.h.kelp = k.size({0.004, 0.008, 0.016});
  k.h.kelp_place = 0.3 * k.s.B * k.random.sign();
  return {{"drag_y_m", k.h.kelp_place}};
}
Numbers fouled_side(Kitchen& k) { return grown<&Concealment::fouled_side>(k, {0.3, 0.6, 1.2}); }
Numbers sloshing(Kitchen& k) { return grown<&Concealment::sloshing>(k, {0.02, 0.05, 0.10}); }
Numbers compass(Kitchen& k) {
  return grown<&Concealment::compass_cosine>(k, {radians(1.0), radians(2.0), radians(4.0)});
}
Numbers blade(Kitchen& k) { return grown<&Concealment::broken_blade>(k, {0.0010, 0.0025, 0.0060}); }
Numbers bank(Kitchen& k) { return grown<&Concealment::bank>(k, {0.003, 0.007, 0.015}); }
Numbers tow_line(Kitchen& k) {
  k.h.tow_onset = k.random.uniform(5.0, 11.0) * k.s.time_unit();
  return grown<&Concealment::tow_line>(k, {0.003, 0.006, 0.012});
}

Numbers tug(Kitchen& k) {
  k.h.tug_onset = k.random.uniform(5.0, 11.0) * k.s.time_unit();
  k.h.tug_end = k.h.tug_onset + k.random.uniform(4.0, 9.0) * k.s.time_unit();
  k.h.tug_place = 0.35 * k.random.sign();
  k.h.tug = k.either_way({0.004, 0.008, 0.016});
  return {{"onset_s", k.h.tug_onset}, {"end_s", k.h.tug_end}};
}

using Recipe = Numbers (*)(Kitchen&);

constexpr std::array<std::pair<std::string_view, Recipe>, 38> recipes{{
    {"steady_wind", wind},
    {"gust", gust},
    {"steady_current", current},
    {"wave_drift", waves},
    {"shallow_water", shallow},
    {"hull_linear_derivatives", linear_derivatives},
    {"hull_nonlinear_damping", cubic_damping},
    {"cross_flow_drag", cross_flow},
    {"added_resistance", resistance},
    {"speed_loss_in_turn", loss_in_turn},
    {"added_mass", added_mass},
    {"rudder_effectiveness", rudder_lift},
    {"rudder_hull_interaction", rudder_hull},
    {"rudder_stall", stall},
    {"rudder_gap", gap},
    {"flow_straightening", straightening},
    {"propeller_race", race},
    {"propeller_side_force", side_force},
    {"wake_change", wake},
    {"shaft_speed_drop", shaft_drop},
    {"rudder_offset", offset},
    {"steering_gear_lag", lag},
    {"steering_gear_backlash", play},
    {"roll_coupling", roll},
    {"fluid_memory", memory},
    {"heading_bias", heading},
    {"gyro_bias", gyro},
    {"log_scale", log_factor},
    {"antenna_lever_arm", antenna},
    {"channel_delay", delay},
    {"unknown_kelp", kelp},
    {"unknown_tow_line", tow_line},
    {"unknown_fouled_side", fouled_side},
    {"unknown_sloshing", sloshing},
    {"unknown_compass", compass},
    {"unknown_blade", blade},
    {"unknown_bank", bank},
    {"unknown_tug", tug},
}};

constexpr std::size_t known_count = 30, unknown_count = 7;

/// What makes sense to hide from instruments as on board: kinds whose numbers are not those of a ship file, which has
/// terms of another form, but for the cubic terms of the hull, as the labelled cases have them; and the three that no
/// effect is like and that harbours know.
constexpr std::array<std::string_view, 21> on_board_names{"steady_wind",      "rudder_effectiveness",
                                                          "gyro_bias",        "added_resistance",
                                                          "steady_current",   "propeller_side_force",
                                                          "wave_drift",       "rudder_offset",
                                                          "cross_flow_drag",  "hull_nonlinear_damping",
                                                          "channel_delay",    "steering_gear_lag",
                                                          "shallow_water",    "gust",
                                                          "heading_bias",     "roll_coupling",
                                                          "shaft_speed_drop", "log_scale",
                                                          "fluid_memory",     "antenna_lever_arm",
                                                          "rudder_stall"};
constexpr std::array<std::string_view, 3> on_board_unknown_names{"unknown_tug", "unknown_kelp", "unknown_bank"};

constexpr auto kind_names = [] {
  std::array<std::string_view, recipes.size()> names;
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = recipes[i].first;
  return names;
}();

}  // namespace

std::string_view name_of(Severity severity) {
  constexpr std::array names{"weak", "moderate", "strong"};
  return names[static_cast<std::size_t>(severity)];
}

std::span<const std::string_view> known_kinds() { return std::span(kind_names).first(known_count); }
std::span<const std::string_view> unknown_kinds() { return std::span(kind_names).subspan(known_count, unknown_count); }
std::span<const std::string_view> on_board_kinds() { return on_board_names; }
std::span<const std::string_view> on_board_unknown_kinds() { return on_board_unknown_names; }

Label conceal(Concealment& hidden, std::string_view kind, Severity severity, const TrueShip& truth,
              const MmgShip<double>& file, RandomSource& random) {
  auto label = conceal(hidden, kind, static_cast<double>(severity), truth, file, random);
  label.severity = severity;
  return label;
}

Label conceal(Concealment& hidden, std::string_view kind, double level, const TrueShip& truth,
              const MmgShip<double>& file, RandomSource& random) {
  for (const auto& [name, recipe] : recipes) {
    if (name != kind) continue;
    Label label{.effect = std::string(kind), .severity = Severity::moderate, .parameters = {}, .channel = {}};
    Kitchen kitchen{hidden, level, truth, file, random, label};
    label.parameters = recipe(kitchen);
    return label;
  }
  throw std::domain_error("no effect \"" + std::string(kind) + "\" can be hidden");
}

}  // namespace swayaw::concealed
