#include "trial_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "simulate_output.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"
#include "terminal.hpp"

namespace swayaw::app {
namespace {

constexpr double degree = radians(1.0);

MaybeTold scaled(const MaybeTold& told, double unit) {
  if (!told) return std::nullopt;
  return Told{told->value / unit, told->standard_error / std::abs(unit)};
}

/// Rows of one run, told in `unit`s.
class Rows {
 public:
  explicit Rows(const std::optional<double>& L) : L_(L) {}

  void add(std::string name, std::string unit_name, double unit, const MaybeTold& told,
           const std::optional<double>& simulated = {}) {
    if (!told && !simulated) return;
    rows_.push_back({std::move(name),
                     std::move(unit_name),
                     scaled(told, unit),
                     {},
                     simulated ? std::optional(*simulated / unit) : std::nullopt,
                     {}});
  }

  void add_length(std::string name, const MaybeTold& recorded, const MaybeTold& corrected,
                  const std::optional<double>& simulated) {
    if (!recorded && !corrected && !simulated) return;
    const auto& best = corrected ? corrected : recorded;
    rows_.push_back({std::move(name), "m", recorded, corrected, simulated,
                     best && L_ ? std::optional(best->value / *L_) : std::nullopt});
  }

  std::vector<TrialRow> take() { return std::move(rows_); }

 private:
  std::optional<double> L_;
  std::vector<TrialRow> rows_;
};

const Reversal* simulated_reversal(const SimulatedTrial& s, std::size_t k) {
  return s.zigzag && k < s.zigzag->reversals.size() ? &s.zigzag->reversals[k] : nullptr;
}

void add_zigzag(Rows& rows, const TrialResult& trial, const SimulatedTrial& s) {
  const auto& z = *trial.zigzag;
  for (std::size_t k = 0; k < z.reversals.size(); ++k) {
    const auto& r = z.reversals[k];
    const auto* other = simulated_reversal(s, k);
    const auto which = fmt::format("{}, {}", k + 1, name_of(r.side));
    rows.add("overshoot " + which, "deg", degree, r.overshoot, other != nullptr ? other->overshoot : std::nullopt);
    rows.add("overshoot time " + which, "s", 1.0, r.overshoot_time,
             other != nullptr && other->peak_time ? std::optional(*other->peak_time - other->time) : std::nullopt);
  }
  rows.add("period", "s", 1.0, z.period, s.zigzag ? s.zigzag->period : std::nullopt);
  rows.add("reach", "s", 1.0, z.reach);
  rows.add_length("way to the first reversal", z.initial_turning, {},
                  s.zigzag ? s.zigzag->initial_turning : std::nullopt);
}

void add_turn(Rows& rows, const TrialResult& trial, const SimulatedTrial& s) {
  const auto& t = *trial.turn;
  const CircleTold none{};
  const auto& c = t.corrected ? *t.corrected : none;
  const auto* circle = s.turn ? &*s.turn : nullptr;
  const auto length = [&](const char* name, MaybeTold CircleTold::*member,
                          std::optional<double> TurningCircle::*index) {
    rows.add_length(name, t.recorded.*member, c.*member, circle != nullptr ? circle->*index : std::nullopt);
  };
  length("advance", &CircleTold::advance, &TurningCircle::advance);
  length("transfer", &CircleTold::transfer, &TurningCircle::transfer);
  length("tactical diameter", &CircleTold::tactical_diameter, &TurningCircle::tactical_diameter);
  length("final diameter", &CircleTold::final_diameter, &TurningCircle::final_diameter);
  length("way to 10 deg", &CircleTold::initial_turning, &TurningCircle::initial_turning);
  rows.add("time to 90 deg", "s", 1.0, t.time_90, circle != nullptr ? circle->time_90 : std::nullopt);
  rows.add("time to 180 deg", "s", 1.0, t.time_180, circle != nullptr ? circle->time_180 : std::nullopt);
  rows.add("time to 270 deg", "s", 1.0, t.time_270);
  rows.add("time to 360 deg", "s", 1.0, t.time_360);
  const auto* steady = circle != nullptr && circle->steady ? &*circle->steady : nullptr;
  const auto of = [&](double value) { return steady != nullptr ? std::optional(value) : std::nullopt; };
  const PlanarMotion<double> m = steady != nullptr ? *steady : PlanarMotion<double>{};
  rows.add("final yaw rate", "deg/s", degree, t.final_yaw_rate, of(m.r));
  rows.add("final speed", "m/s", 1.0, t.final_speed, of(speed(m)));
  rows.add("final over approach speed", "%", 0.01, t.speed_kept,
           of(circle != nullptr ? speed(m) / circle->approach_speed : 0.0));
  rows.add("final drift angle", "deg", degree, t.final_drift, of(drift_angle(m)));
  rows.add("yaw rate over rudder, steady", "1/s", 1.0, t.gain);
  rows.add("yaw rate left after the pull-out", "deg/s", degree, t.residual_yaw_rate);
  if (!t.drift) return;
  rows.add("drift of the track, speed", "m/s", 1.0, t.drift->speed);
  rows.add("drift of the track, towards", "deg", degree, t.drift->direction);
}

void add_steering(Rows& rows, const SteeringTrial& k) {
  if (k.worked) {
    rows.add("K, Nomoto's method", "1/s", 1.0, k.worked->K);
    rows.add("T, Nomoto's method", "s", 1.0, k.worked->T);
  }
  if (k.least_squares) {
    rows.add("K, least squares", "1/s", 1.0, k.least_squares->K);
    rows.add("T, least squares", "s", 1.0, k.least_squares->T);
    rows.add("rudder offset, to starboard", "deg", degree, k.least_squares->offset);
  }
  rows.add("K'", "", 1.0, k.K_prime);
  rows.add("T'", "", 1.0, k.T_prime);
  if (k.second) {
    const auto& s = *k.second;
    const auto if_told = [&](const char* name, const char* unit, const MaybeTold& x, bool told) {
      if (told) rows.add(name, unit, 1.0, x);
    };
    if_told("K, second order", "1/s", s.K, s.K_told);
    if_told("T1", "s", s.T1, s.T1_told);
    if_told("T2", "s", s.T2, s.T2_told);
    if_told("T3", "s", s.T3, s.T3_told);
  }
  rows.add("P, recorded", "", 1.0, k.P);
}

void add_steady(Rows& rows, const SteadyTrial& s) {
  rows.add("mean rudder, to port", "deg", degree, s.helm);
  rows.add("mean yaw rate", "deg/s", degree, s.yaw_rate);
  rows.add("mean speed", "m/s", 1.0, s.speed);
  rows.add("mean drift angle", "deg", degree, s.drift);
  rows.add("track off the heading, to starboard", "deg", degree, s.leeway);
}

void add_spiral(Rows& rows, const SpiralTrial& s) {
  for (const auto& step : s.steps)
    rows.add(fmt::format("yaw rate at rudder {:.1f} deg {}", degrees(std::abs(step.delta)),
                         step.delta > 0.0 ? "port" : "starboard"),
             "deg/s", degree, step.yaw_rate);
  if (s.loop_width) rows.add("loop, width", "deg", degree, Told{*s.loop_width, missing});
  rows.add("loop, height", "deg/s", degree, s.loop_height);
}

// ---------------------------------------------------------------- JSON

Json nomoto_json(const std::optional<NomotoTold>& n) {
  if (!n) return nullptr;
  return {{"K_1_s", told_json(n->K)},
          {"T_s", told_json(n->T)},
          {"rudder_offset_rad", told_json(n->offset)},
          {"residual_deg", number(degrees(n->residual))}};
}

Json second_json(const std::optional<SecondOrderTold>& s) {
  if (!s) return nullptr;
  return {{"K_1_s", told_json(s->K)},
          {"T1T2_s2", told_json(s->T1T2)},
          {"T1_plus_T2_s", told_json(s->T1_plus_T2)},
          {"T1_s", told_json(s->T1)},
          {"T2_s", told_json(s->T2)},
          {"T3_s", told_json(s->T3)},
          {"told", {{"K", s->K_told}, {"T1", s->T1_told}, {"T2", s->T2_told}, {"T3", s->T3_told}}}};
}

Json steering_json(const SteeringTrial& k) {
  return {{"rudder_positive", "starboard"},
          {"worked", nomoto_json(k.worked)},
          {"least_squares", nomoto_json(k.least_squares)},
          {"second_order", second_json(k.second)},
          {"K_prime", told_json(k.K_prime)},
          {"T_prime", told_json(k.T_prime)},
          {"P", told_json(k.P)},
          {"P_of_K_and_T", number(k.P_of_fit)}};
}

Json imo_json(const std::vector<JudgedCriterion>& criteria) {
  Json list = Json::array();
  for (const auto& c : criteria)
    list.push_back({{"name", c.name},
                    {"side", name_of(c.side)},
                    {"value", told_json(c.value)},
                    {"limit", c.limit},
                    {"unit", c.unit},
                    {"pass", c.pass ? Json(*c.pass) : Json(nullptr)},
                    {"verdict", verdict_of(c)}});
  return list;
}

Json moves_json(const std::vector<RudderMove>& moves) {
  Json list = Json::array();
  for (const auto& m : moves)
    list.push_back({{"start_s", told_json(m.start)},
                    {"from_rad", number(m.from)},
                    {"to_rad", number(m.to)},
                    {"rate_deg_s", m.rate ? number(degrees(*m.rate)) : Json(nullptr)}});
  return list;
}

void add_zigzag_json(Json& json, const TrialResult& trial) {
  const auto& z = *trial.zigzag;
  json["first"] = name_of(z.first);
  Json execute = Json::array({told_json(trial.approach.execute)});
  for (const auto& r : z.reversals) execute.push_back(told_json(r.execute));
  json["execute_s"] = std::move(execute);
  const auto list = [&](const char* key, MaybeTold TrialReversal::*member, double unit) {
    Json values = Json::array();
    for (const auto& r : z.reversals) values.push_back(told_json(r.*member, unit));
    json[key] = std::move(values);
  };
  list("peak_s", &TrialReversal::peak_time, 1.0);
  list("overshoot_deg", &TrialReversal::overshoot, degree);
  list("overshoot_time_s", &TrialReversal::overshoot_time, 1.0);
  list("rudder_start_s", &TrialReversal::rudder_start, 1.0);
  list("heading_at_rudder_start_deg", &TrialReversal::heading_then, degree);
  list("overshoot_from_rudder_start_deg", &TrialReversal::beyond_start, degree);
  json["period_s"] = told_json(z.period);
  json["reach_s"] = told_json(z.reach);
  json["initial_turning_m"] = told_json(z.initial_turning);
}

Json circle_lengths(const CircleTold& c) {
  return {{"advance_m", told_json(c.advance)},
          {"transfer_m", told_json(c.transfer)},
          {"tactical_diameter_m", told_json(c.tactical_diameter)},
          {"final_diameter_m", told_json(c.final_diameter)},
          {"initial_turning_m", told_json(c.initial_turning)}};
}

Json drift_json(const std::optional<DriftTold>& d) {
  if (!d) return nullptr;
  return {{"speed_m_s", told_json(d->speed)},
          {"to_rad", told_json(d->direction)},
          {"north_m_s", told_json(d->north)},
          {"east_m_s", told_json(d->east)},
          {"pairs", d->pairs}};
}

void add_turn_json(Json& json, const TurnTrial& t) {
  json["first"] = name_of(t.side);
  json["heading_change_deg"] = number(degrees(t.heading_change));
  json["lengths"] = t.corrected ? "corrected" : "recorded";
  json.update(circle_lengths(t.corrected ? *t.corrected : t.recorded));
  json["recorded"] = circle_lengths(t.recorded);
  json["corrected"] = t.corrected ? circle_lengths(*t.corrected) : Json(nullptr);
  json["current"] = drift_json(t.drift);
  json["time_90_s"] = told_json(t.time_90);
  json["time_180_s"] = told_json(t.time_180);
  json["time_270_s"] = told_json(t.time_270);
  json["time_360_s"] = told_json(t.time_360);
  json["final_speed_m_s"] = told_json(t.final_speed);
  json["final_drift_rad"] = told_json(t.final_drift);
  json["final_yaw_rate_rad_s"] = told_json(t.final_yaw_rate);
  json["speed_kept"] = told_json(t.speed_kept);
  json["steady_gain_1_s"] = told_json(t.gain);
  json["residual_yaw_rate_rad_s"] = told_json(t.residual_yaw_rate);
}

void add_spiral_json(Json& json, const SpiralTrial& s) {
  Json steps = Json::array();
  for (const auto& step : s.steps)
    steps.push_back({{"delta_rad", number(step.delta)},
                     {"from_s", step.from},
                     {"to_s", step.to},
                     {"yaw_rate_rad_s", told_json(step.yaw_rate)}});
  json["steps"] = std::move(steps);
  json["loop_width_rad"] = number(s.loop_width);
  json["loop_height_rad_s"] = told_json(s.loop_height);
}

void add_steady_json(Json& json, const SteadyTrial& s) {
  json["helm_rad"] = told_json(s.helm);
  json["yaw_rate_rad_s"] = told_json(s.yaw_rate);
  json["speed_m_s"] = told_json(s.speed);
  json["drift_rad"] = told_json(s.drift);
  json["leeway_rad"] = told_json(s.leeway);
}

/// Decimals to the second digit of the error, but no more than five digits of the value.
int decimals_of(const Told& told) {
  const auto places = [](double x, int digits) {
    return digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(x))));
  };
  const int of_value = told.value != 0.0 ? places(told.value, 5) : 4;
  return std::clamp(told.standard_error > 0.0 ? std::min(places(told.standard_error, 2), of_value) : of_value, 0, 8);
}

}  // namespace

std::vector<TrialRow> rows_of(const TrialResult& trial, const SimulatedTrial& simulated,
                              const std::optional<double>& L) {
  Rows rows(L);
  if (trial.zigzag) add_zigzag(rows, trial, simulated);
  if (trial.turn) add_turn(rows, trial, simulated);
  if (trial.spiral) add_spiral(rows, *trial.spiral);
  if (trial.steady) add_steady(rows, *trial.steady);
  rows.add("time to 10 deg", "s", 1.0, trial.time_10);
  add_steering(rows, trial.steering);
  return rows.take();
}

Json told_json(const MaybeTold& told, double unit) {
  if (!told || !std::isfinite(told->value)) return nullptr;
  return {{"value", number(told->value / unit)}, {"standard_error", number(told->standard_error / unit)}};
}

Json trial_json(const TrialResult& trial, const SimulatedTrial& simulated) {
  Json json{{"run", trial.run},
            {"manoeuvre", trial.manoeuvre.name},
            {"manoeuvre_said", trial.manoeuvre.said},
            {"approach_speed_m_s", told_json(trial.approach.speed)},
            {"approach_speed_source", in_words(trial.approach.speed_source)},
            {"approach_heading_rad", told_json(trial.approach.heading)},
            {"approach_s", number(trial.approach.before)},
            {"rudder_before_rad", number(trial.approach.rudder)}};
  if (trial.zigzag) add_zigzag_json(json, trial);
  if (trial.turn) json["execute_s"] = told_json(trial.approach.execute), add_turn_json(json, *trial.turn);
  if (trial.spiral) add_spiral_json(json, *trial.spiral);
  if (trial.steady) add_steady_json(json, *trial.steady);
  if (trial.zigzag || trial.turn) {
    json["time_10_s"] = told_json(trial.time_10);
    json["rudder_moves"] = moves_json(trial.rudder);
    json["nomoto"] = steering_json(trial.steering);
    json["turns_against_rudder"] = trial.against_rudder;
    json["imo"] = imo_json(trial.imo);
    json["simulated"] = simulated.json;
  }
  json["notes"] = trial.notes;
  return json;
}

Json rows_json(const std::vector<TrialRow>& rows) {
  Json list = Json::array();
  for (const auto& row : rows)
    list.push_back({{"name", row.name},
                    {"unit", row.unit},
                    {"recorded", told_json(row.recorded)},
                    {"corrected", told_json(row.corrected)},
                    {"simulated", number(row.simulated)},
                    {"in_lengths", number(row.in_lengths)}});
  return list;
}

std::string shown(const Told& told) {
  if (!std::isfinite(told.standard_error)) return fmt::format("{:.4g}", told.value);
  const int decimals = decimals_of(told);
  const double digit = std::pow(10.0, -decimals);
  const double error = told.standard_error > 0.0 ? std::max(told.standard_error, digit) : 0.0;
  return fmt::format("{:.{}f} ± {:.{}f}", told.value + 0.0, decimals, error, decimals);
}

std::string_view verdict_of(const JudgedCriterion& c) {
  if (c.pass) return *c.pass ? "pass" : "fail";
  return c.value ? "cannot tell" : "not reached";
}

std::string in_words(const ImoSummary& s) {
  const auto list = [](const std::vector<std::string>& names) { return fmt::format("{}", fmt::join(names, ", ")); };
  if (!s.any && s.open.empty()) return "MSC.137(76): nothing was judged";
  std::string words = s.failed.empty()
                          ? s.any ? "MSC.137(76): no criterion is failed" : "MSC.137(76): nothing could be decided"
                          : "MSC.137(76): fails " + list(s.failed);
  if (!s.open.empty()) words += "; cannot tell " + list(s.open);
  if (!s.missing.empty()) words += "; not told by these runs: " + list(s.missing);
  return words;
}

std::optional<double> only_speed(const Ship& ship) {
  if (!std::holds_alternative<AbkowitzShip<double>>(ship.model)) return std::nullopt;
  return service_speed(ship);
}

std::string at_only_speed(std::string_view speed) {
  return fmt::format(" at {}, the only speed of an abkowitz ship", speed);
}

void say_other_speed(const Ship& ship, const TrialResult& t) {
  const auto only = only_speed(ship);
  if (!only || !t.approach.speed) return;
  const auto hers = fmt::format("{:.3g} m/s", *only), recorded = fmt::format("{:.3g} m/s", t.approach.speed->value);
  if (hers != recorded)
    say_aside("swayaw: {}: simulated{}, not at the recorded {}\n", t.run, at_only_speed(hers), recorded);
}

SimulatedTrial simulated_trial(const Ship& ship, const TrialResult& t) {
  SimulatedTrial result;
  ManoeuvreOptions options{.speed = only_speed(ship)};
  if (!options.speed && t.approach.speed) options.speed = t.approach.speed->value;
  try {
    if (t.zigzag) {
      const ZigzagOrder order{t.manoeuvre.rudder, t.manoeuvre.heading, t.zigzag->first};
      result.zigzag = zigzag(ship, order, options);
      result.json = zigzag_json(ship, *result.zigzag, order);
    }
    if (t.turn) {
      const TurnOrder order{t.manoeuvre.rudder, t.turn->side};
      result.turn = turning_circle(ship, order, options);
      result.json = circle_json(ship, *result.turn, order);
    }
  } catch (const std::exception& error) {
    say_aside("swayaw: {}: not simulated: {}\n", t.run, error.what());
  }
  return result;
}

}  // namespace swayaw::app
