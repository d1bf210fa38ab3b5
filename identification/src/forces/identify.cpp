#include "swayaw/identification/identify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <numeric>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/linearization.hpp"
#include "swayaw/nonlinear/replay.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"

namespace swayaw::inline identification {

// ---------------------------------------------------------------- models

namespace {

template <class To, class From>
To with_parts_of(const From& ship) {
  To result{};
  result.water = ship.water;
  result.particulars = ship.particulars;
  result.added_mass = ship.added_mass;
  result.hull = ship.hull;
  result.propeller = ship.propeller;
  result.steering_gear = ship.steering_gear;
  return result;
}

constexpr std::array<std::string_view, 4> model_names{"mmg", "pi", "pu", "abkowitz"};  // as in ShipModel

/// Hull terms of the published form.
std::vector<std::string> published_form(const Ship& ship) {
  if (std::holds_alternative<MmgShip<double>>(ship.model))
    return {"R_0", "X_vv", "X_vr", "X_rr", "Y_v", "Y_r", "N_v", "N_r"};
  return {"X_0", "X_u", "X_vv", "X_rr", "X_vr", "Y_v", "Y_r", "N_v", "N_r"};
}

bool has_values(std::span<const Parameter> parameters) {
  return std::ranges::any_of(parameters, [](const Parameter& n) { return n.value != 0.0; });
}

void add_names(std::vector<std::string>& names, std::span<const Parameter> parameters, bool zeros_too) {
  for (const auto& n : parameters)
    if (zeros_too || n.value != 0.0) names.push_back(n.name);
}

}  // namespace

Ship in_model(const Ship& ship, std::string_view model) {
  if (model == model_names[ship.model.index()]) return ship;
  Ship result = ship;
  if (const auto* pi_ship = std::get_if<PiShip<double>>(&ship.model); pi_ship && model == "pu") {
    result.model = with_parts_of<PuShip<double>>(*pi_ship);
    return result;
  }
  throw Refusal(
      fmt::format("{}: a ship of model \"{}\" does not tell what model \"{}\" needs; give a ship file of that model",
                  ship.name, model_names[ship.model.index()], model));
}

std::vector<std::string> usual_parameters(const Ship& ship) {
  const auto hull = coefficients_of(ship, "hull");
  std::vector<std::string> names;
  if (has_values(hull)) add_names(names, hull, false);
  else names = published_form(ship);
  if (!std::holds_alternative<PuShip<double>>(ship.model)) return names;
  const auto rudder = coefficients_of(ship, "rudder");
  add_names(names, rudder, !has_values(rudder));
  return names;
}

// ---------------------------------------------------------------- stability

namespace {

/// 1/(T1' T2') straight ahead at that speed; nothing where the ship does not propel herself.
std::optional<double> constant_term(const Ship& ship, double speed) {
  try {
    const auto linear = linearize(ship, straight_course(ship, speed));
    return transfer_functions(sway_yaw(linear.whole, linear.scale)).e0;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

double mean_speed(const ForceFit& fit) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const auto& run : fit.states)
    for (const auto& s : run.states) {
      sum += speed(s.state.motion);
      ++count;
    }
  return sum / static_cast<double>(count);
}

/// Variance of e0 by that of one equation, gᵀ C g.
double variance_from(const ForceFit& fit, const ForceEquation& equation, double U) {
  const auto& coefficients = equation.fit.coefficients;
  Eigen::VectorXd slope = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(coefficients.size()));
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    const auto& [value, error] = coefficients[i].estimate;
    if (!std::isfinite(error) || !(error > 0.0)) continue;
    const auto number = parameters_of(fit.ship, std::array{coefficients[i].name});
    const auto up = constant_term(with_values(fit.ship, number, std::array{value + error}), U);
    const auto down = constant_term(with_values(fit.ship, number, std::array{value - error}), U);
    if (up && down) slope[static_cast<Eigen::Index>(i)] = (*up - *down) / (2.0 * error);
  }
  return slope.dot(equation.fit.covariance * slope);
}

/// Whether sway force and yaw moment of the hull are linear in v and r.
bool has_linear_hull(const Ship& ship) {
  return std::ranges::all_of(coefficients_of(ship, "hull"), [](const Parameter& n) {
    const bool nonlinear = (n.key.starts_with("Y_") || n.key.starts_with("N_")) && n.key.size() > 3;
    return !nonlinear || n.value == 0.0;
  });
}

std::string range_words(const MotionRange& range) {
  return fmt::format("motions up to {:.1f} deg of drift and r' = {:.2f}", degrees(range.drift), range.omega);
}

}  // namespace

StabilityVerdict stability_verdict(const ForceFit& fit) {
  constexpr double small = 0.25;  // r' of motions for which a linear hull is one
  const double U = mean_speed(fit);
  const auto e0 = constant_term(fit.ship, U);
  StabilityVerdict verdict{.straight_course = StraightCourse::not_told,
                           .e0 = e0.value_or(std::nan("")),
                           .standard_error = 0.0,
                           .range = fit.range,
                           .linear_hull = has_linear_hull(fit.ship),
                           .words = {}};
  if (!e0) {
    verdict.words = fmt::format("not told: the fitted ship does not propel herself at {:.3g} m/s", U);
    return verdict;
  }
  double variance = 0.0;
  for (const auto& equation : fit.equations)
    if (equation.component != ForceComponent::X) variance += variance_from(fit, equation, U);
  verdict.standard_error = std::sqrt(std::max(variance, 0.0));
  const auto parameters = fmt::format("1/(T1' T2') = {:.3g} +- {:.2g}", *e0, verdict.standard_error);
  const auto range = range_words(fit.range);
  if (*e0 > 0.0 && verdict.linear_hull && fit.range.omega > small)
    verdict.words = fmt::format(
        "not told: {}, but a linear hull fitted to {} is a mean over them, and small motions are damped less",
        parameters, range);
  else if (std::abs(*e0) < 2.0 * verdict.standard_error)
    verdict.words = fmt::format("not told: {}, from {}", parameters, range);
  else {
    verdict.straight_course = *e0 > 0.0 ? StraightCourse::stable : StraightCourse::unstable;
    verdict.words =
        fmt::format("{} on a straight course: {}, from {}", *e0 > 0.0 ? "stable" : "unstable", parameters, range);
  }
  return verdict;
}

// ---------------------------------------------------------------- choice of runs

namespace {

using Places = std::vector<std::size_t>;

std::vector<std::optional<double>> values_of(const ForceFit& fit, const std::vector<std::string>& names) {
  std::vector<std::optional<double>> values;
  for (const auto& name : names) {
    std::optional<double> value;
    for (const auto& equation : fit.equations)
      for (const auto& c : equation.fit.coefficients)
        if (c.name == name && std::isfinite(c.estimate.standard_error)) value = c.estimate.value;
    values.push_back(value);
  }
  return values;
}

/// Runs, and what the choice is called.
struct Choice {
  std::string name;
  Places runs;
};

std::vector<Choice> choices(const Ship& ship, std::span<const Recording> runs) {
  Places all(runs.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::vector<Choice> result{{"all runs", all}};
  if (runs.size() < 2) return result;
  for (const auto left_out : all) {
    Places rest = all;
    std::erase(rest, left_out);
    result.push_back({fmt::format("all but {}", runs[left_out].name), rest});
  }
  if (runs.size() > 2)
    for (const auto alone : all) result.push_back({fmt::format("{} alone", runs[alone].name), {alone}});
  std::map<int, Places> by_amplitude;
  for (const auto i : all) by_amplitude[rudder_amplitude(ship, runs[i])].push_back(i);
  for (const auto& [amplitude, places] : by_amplitude)
    if (by_amplitude.size() > 1 && places.size() > 1)
      result.push_back({fmt::format("rudder {} deg alone", amplitude), places});
  return result;
}

}  // namespace

int rudder_amplitude(const Ship& ship, const Recording& run) {
  const RecordedControls controls(ship, run);
  double most = 0.0;
  for (const double time : run.time) most = std::max(most, std::abs(controls.rudder(time)));
  return static_cast<int>(std::lround(degrees(most)));
}

std::vector<Resample> resample(const Ship& ship, std::span<const Recording> runs, const ForceFit& fit,
                               const ForceFitOptions& options) {
  std::vector<Resample> result;
  for (const auto& [name, places] : choices(ship, runs)) {
    std::vector<Recording> some;
    std::vector<StateEstimate> states;
    for (const auto i : places) {
      some.push_back(runs[i]);
      states.push_back(fit.states[i]);
    }
    result.push_back({name, values_of(fit_forces(ship, some, std::move(states), options), options.parameters)});
  }
  return result;
}

// ---------------------------------------------------------------- zigzags

std::optional<ZigzagOrder> zigzag_order(const Recording& run) {
  const std::string_view text = run.facts.manoeuvre;
  constexpr std::string_view word = "zigzag ";
  if (!text.starts_with(word)) return std::nullopt;
  double rudder = 0.0, heading = 0.0;
  const auto* end = text.data() + text.size();
  const auto first = std::from_chars(text.data() + word.size(), end, rudder);
  if (first.ec != std::errc{} || first.ptr == end || *first.ptr != '/') return std::nullopt;
  if (std::from_chars(first.ptr + 1, end, heading).ec != std::errc{} || !(rudder > 0.0) || !(heading > 0.0))
    return std::nullopt;
  const auto channel = run.has(Channel::delta) ? Channel::delta : Channel::delta_order;
  const auto moved =
      std::ranges::find_if(run[channel], [&](double delta) { return std::abs(delta) > 0.5 * radians(rudder); });
  if (moved == run[channel].end()) return std::nullopt;
  return ZigzagOrder{radians(rudder), radians(heading), *moved > 0.0 ? Side::port : Side::starboard};
}

std::vector<double> recorded_overshoots(const Recording& run, const ZigzagOrder& order) {
  const auto delta = run[run.has(Channel::delta) ? Channel::delta : Channel::delta_order];
  const auto psi = run[Channel::psi];
  const double half = 0.5 * order.rudder, start = *std::ranges::find_if(psi, [](double p) { return std::isfinite(p); });
  std::vector<double> peaks;
  double side = 0.0;  // of the rudder, 0 before the first order
  double farthest = -HUGE_VAL,
         end = 0;  // heading to the side that the ship is still turning to, and where the run leaves it
  bool reversed = false;
  for (std::size_t i = 0; i < psi.size(); ++i) {
    if (std::isfinite(delta[i]) && std::abs(delta[i]) > half && delta[i] * side <= 0.0) {
      if (reversed) peaks.push_back(farthest - order.heading);
      reversed = side != 0.0;
      side = delta[i] > 0.0 ? 1.0 : -1.0;
      farthest = -HUGE_VAL;
    }
    // after a reversal the ship goes on to the side of the rudder before it, which is that of the rudder now: + delta
    // turns to port
    if (!std::isfinite(psi[i])) continue;
    end = side * (psi[i] - start);
    farthest = std::max(farthest, end);
  }
  if (reversed && farthest > end) peaks.push_back(farthest - order.heading);
  return peaks;
}

std::optional<std::vector<double>> simulated_overshoots(const Ship& ship, const Recording& run,
                                                        const ZigzagOrder& order, std::size_t most) {
  const auto mean = [&](Channel channel) {
    double sum = 0.0;
    std::size_t count = 0;
    for (const double value : run[channel])
      if (std::isfinite(value)) sum += value, ++count;
    return sum / static_cast<double>(count);
  };
  ManoeuvreOptions options{.speed = speed(recorded_state(ship, run, run.time.front()).motion), .sampled = false};
  if (run.has(Channel::rev) && takes_shaft_speed(ship)) options.rev = mean(Channel::rev);
  else if (run.has(Channel::thrust)) options.thrust = mean(Channel::thrust);
  try {
    std::vector<double> overshoots;
    for (const auto& reversal : zigzag(ship, order, options).reversals)
      if (reversal.overshoot && overshoots.size() < most) overshoots.push_back(*reversal.overshoot);
    return overshoots;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace swayaw::identification
