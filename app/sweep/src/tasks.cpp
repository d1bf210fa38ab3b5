#include "tasks.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "swayaw/core/angle.hpp"
#include "swayaw/linear/batch.hpp"
#include "swayaw/linear/zigzag.hpp"
#include "swayaw/nonlinear/linearization.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/simulation/batch.hpp"

namespace swayaw::app {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Ship lengths after which a zigzag is given up, as in `swayaw simulate`.
constexpr double longest_zigzag = 200.0;

double or_none(const std::optional<double>& value) { return value.value_or(none); }

/// Columns of the results of a block, after those that vary.
class Results {
 public:
  Results(SweepBlock& block, std::size_t varied) : block_(block), varied_(varied) {}

  double& at(std::size_t result, std::size_t item) { return block_.at(varied_ + result, item); }
  void note(std::size_t item, std::string why) { block_.notes.emplace_back(block_.first + item, std::move(why)); }

 private:
  SweepBlock& block_;
  std::size_t varied_;
};

/// Calls visit(point) for the ship at every item of a block, one after the other.
template <class Visit>
void for_each_point(const VariedShip& ship, SweepBlock& block, Visit&& visit) {
  auto point = ship.at_rest();
  std::vector<double> values(ship.laws().size());
  for (std::size_t i = 0; i < block.count; ++i) {
    for (std::size_t d = 0; d < values.size(); ++d) values[d] = block.at(d, i);
    ship.put(point, values);
    visit(i, point);
  }
}

/// The same where a question that has no answer becomes a note.
template <class Visit>
void for_each_answer(const VariedShip& ship, SweepBlock& block, Results results, Visit&& visit) {
  for_each_point(ship, block, [&](std::size_t i, const ShipAtPoint& point) {
    try {
      visit(i, point);
    } catch (const Refusal& e) {
      results.note(i, e.what());
    } catch (const std::domain_error& e) {
      results.note(i, e.what());
    }
  });
}

// ---------------------------------------------------------------- zigzag

double speed_of(const LinearShip& ship, const std::optional<double>& speed) {
  return speed.value_or(ship.particulars.U_0);
}

LinearZigzagOrder linear_order(const SweepPlan& plan, const LinearShip& ship, double speed) {
  if (plan.rudder > ship.steering_gear.max_angle)
    throw Refusal(fmt::format("{}: the rudder goes to {:.6g} deg", ship.name, degrees(ship.steering_gear.max_angle)));
  return {.rudder = plan.rudder,
          .heading = plan.heading,
          .rate = ship.steering_gear.rate * ship.particulars.L / speed,
          .first = plan.first,
          .reversals = plan.overshoots,
          .longest = longest_zigzag};
}

void linear_zigzag_of(const SweepPlan& plan, const LinearShip& ship, const std::optional<double>& speed, std::size_t i,
                      Results& results) {
  const double U = speed_of(ship, speed), t = ship.particulars.L / U;
  const auto zigzag = linear_zigzag(yaw_coefficients(ship), linear_order(plan, ship, U));
  for (std::size_t k = 0; k < std::min(plan.overshoots, zigzag.reversals.size()); ++k) {
    results.at(2 * k, i) = degrees(zigzag.reversals[k].overshoot);
    results.at(2 * k + 1, i) = zigzag.reversals[k].execute * t;
  }
}

/// Whether one order serves all ships of a block, so that they sail in packs.
bool one_order(const VariedShip& ship) {
  constexpr std::array<std::string_view, 4> of_the_order{"length_m", "service_speed_m_s", "rate_deg_s",
                                                         "max_angle_deg"};
  return !ship.speed_varies() && std::ranges::none_of(ship.columns(), [&](const SweepColumn& c) {
    return std::ranges::find(of_the_order, c.name) != of_the_order.end();
  });
}

void linear_zigzags(const SweepPlan& plan, const VariedShip& varied, const LinearShip& ship, SweepBlock& block,
                    Results results) {
  SwayYawCoefficients<std::vector<double>> columns;
  for (auto* column : {&columns.a1, &columns.b1, &columns.c1, &columns.a2, &columns.b2, &columns.c2})
    column->assign(block.count, none);
  for_each_answer(varied, block, results, [&](std::size_t i, const ShipAtPoint& point) {
    const auto m = yaw_coefficients(std::get<LinearShip>(point.ship));
    columns.a1[i] = m.a1, columns.b1[i] = m.b1, columns.c1[i] = m.c1;
    columns.a2[i] = m.a2, columns.b2[i] = m.b2, columns.c2[i] = m.c2;
  });
  const double U = speed_of(ship, plan.speed), t = ship.particulars.L / U;
  const auto table = zigzag_batch({columns.a1, columns.b1, columns.c1, columns.a2, columns.b2, columns.c2},
                                  linear_order(plan, ship, U), {.threads = 1});
  for (std::size_t k = 0; k < plan.overshoots; ++k)
    for (std::size_t i = 0; i < block.count; ++i) {
      results.at(2 * k, i) = degrees(table.overshoot[table.at(k, i)]);
      results.at(2 * k + 1, i) = table.execute[table.at(k, i)] * t;
    }
}

const MmgShip<double>* calm_mmg(const VariedShip& varied) {
  const auto* ship = std::get_if<Ship>(&varied.ship());
  return ship && ship->effects.empty() ? std::get_if<MmgShip<double>>(&ship->model) : nullptr;
}

/// Whether the rudder of every ship of a block goes as far as is ordered.
bool packs_serve(const SweepPlan& plan, const VariedShip& varied) {
  if (const auto* linear = std::get_if<LinearShip>(&varied.ship()))
    return one_order(varied) && plan.rudder <= linear->steering_gear.max_angle;
  const auto* ship = calm_mmg(varied);
  return ship && one_order(varied) && plan.rudder <= steering_gear(std::get<Ship>(varied.ship())).max_angle;
}

void mmg_zigzags(const SweepPlan& plan, const VariedShip& varied, SweepBlock& block, Results results) {
  std::vector<MmgShip<double>> ships;
  ships.reserve(block.count);
  for_each_point(varied, block, [&](std::size_t, const ShipAtPoint& point) {
    ships.push_back(std::get<MmgShip<double>>(std::get<Ship>(point.ship).model));
  });
  ZigzagBatchOptions options{.reversals = plan.overshoots, .speed = plan.speed, .tolerance = plan.tolerance};
  options.batch.threads = 1;
  const auto table =
      zigzag_batch(ships, {.rudder = plan.rudder, .heading = plan.heading, .first = plan.first}, options);
  for (std::size_t i = 0; i < block.count; ++i) {
    for (std::size_t k = 0; k < plan.overshoots; ++k) {
      results.at(2 * k, i) = degrees(table.overshoot[table.at(k, i)]);
      results.at(2 * k + 1, i) = table.time[table.at(k, i)];
    }
    if (table.end[i] != ZigzagEnd::complete) results.note(i, std::string(in_words(table.end[i])));
  }
}

ManoeuvreOptions options_of(const SweepPlan& plan, const std::optional<double>& speed) {
  return {.speed = speed, .tolerance = plan.tolerance, .sampled = false};
}

void zigzag_of(const SweepPlan& plan, const Ship& ship, const std::optional<double>& speed, std::size_t i,
               Results& results) {
  auto options = options_of(plan, speed);
  if (plan.overshoots > 4)  // it ends after the fourth unless told how long it lasts
    options.duration = longest_zigzag * length(ship) / speed.value_or(service_speed(ship));
  const auto found = zigzag(ship, {.rudder = plan.rudder, .heading = plan.heading, .first = plan.first}, options);
  for (std::size_t k = 0; k < std::min(plan.overshoots, found.reversals.size()); ++k) {
    const auto& reversal = found.reversals[k];
    results.at(2 * k, i) = reversal.overshoot ? degrees(*reversal.overshoot) : none;
    results.at(2 * k + 1, i) = reversal.time;
  }
}

void zigzags(const SweepPlan& plan, const VariedShip& varied, SweepBlock& block, Results results) {
  if (packs_serve(plan, varied)) {
    if (const auto* linear = std::get_if<LinearShip>(&varied.ship()))
      return linear_zigzags(plan, varied, *linear, block, results);
    return mmg_zigzags(plan, varied, block, results);
  }
  for_each_answer(varied, block, results, [&](std::size_t i, const ShipAtPoint& point) {
    if (const auto* linear = std::get_if<LinearShip>(&point.ship))
      linear_zigzag_of(plan, *linear, point.speed, i, results);
    else zigzag_of(plan, std::get<Ship>(point.ship), point.speed, i, results);
  });
}

// ---------------------------------------------------------------- turn

void turns(const SweepPlan& plan, const VariedShip& varied, SweepBlock& block, Results results) {
  for_each_answer(varied, block, results, [&](std::size_t i, const ShipAtPoint& point) {
    const auto& ship = std::get<Ship>(point.ship);
    const auto turn = turning_circle(ship, {.rudder = plan.rudder, .side = plan.first}, options_of(plan, point.speed));
    const std::array<double, 9> row{or_none(turn.advance),
                                    or_none(turn.transfer),
                                    or_none(turn.tactical_diameter),
                                    or_none(turn.time_90),
                                    or_none(turn.time_180),
                                    or_none(turn.final_diameter),
                                    turn.steady ? speed(*turn.steady) : none,
                                    turn.steady ? degrees(drift_angle(*turn.steady)) : none,
                                    turn.steady ? degrees(turn.steady->r) : none};
    for (std::size_t k = 0; k < row.size(); ++k) results.at(k, i) = row[k];
    if (turn.way_lost) results.note(i, fmt::format("the ship no longer moves ahead at {:.1f} s", *turn.way_lost));
  });
}

// ---------------------------------------------------------------- indices

void indices_of(const VariedShip& varied, SweepBlock& block, Results results) {
  for_each_answer(varied, block, results, [&](std::size_t i, const ShipAtPoint& point) {
    const auto* linear = std::get_if<LinearShip>(&point.ship);
    std::optional<LinearShip> small_motions;
    if (!linear) {
      const auto& ship = std::get<Ship>(point.ship);
      small_motions =
          linear_ship(ship, linearize(ship, straight_course(ship, point.speed.value_or(service_speed(ship)))));
      linear = &*small_motions;
    }
    const auto h = transfer_functions(*linear);
    const auto n = indices(*linear);
    const auto T = time_constants(h).value_or(TimeConstants<double>{none, none});
    const std::array<double, 11> row{n.T1T2,
                                     n.T1_plus_T2,
                                     T.T1,
                                     T.T2,
                                     n.T3b,
                                     n.T3w,
                                     n.Kb,
                                     n.Kw,
                                     first_order_drift(n).T,
                                     first_order_yaw(n).T,
                                     h.e0 > 0.0 && h.e1 > 0.0 ? 1.0 : 0.0};
    for (std::size_t k = 0; k < row.size(); ++k) results.at(k, i) = row[k];
  });
}

}  // namespace

std::vector<SweepColumn> results_of(const SweepPlan& plan) {
  std::vector<SweepColumn> columns;
  const auto add = [&](std::string name, const char* unit) { columns.push_back({std::move(name), unit, false}); };
  switch (plan.task) {
    case SweepTask::zigzag:
      for (std::size_t k = 1; k <= plan.overshoots; ++k) {
        add(fmt::format("overshoot_{}_deg", k), "deg");
        add(fmt::format("reversal_{}_s", k), "s");
      }
      break;
    case SweepTask::turn:
      for (const char* name : {"advance_m", "transfer_m", "tactical_diameter_m"}) add(name, "m");
      for (const char* name : {"time_90_s", "time_180_s"}) add(name, "s");
      add("final_diameter_m", "m");
      add("final_speed_m_s", "m/s");
      add("final_drift_deg", "deg");
      add("final_yaw_rate_deg_s", "deg/s");
      break;
    case SweepTask::indices:
      for (const char* name : {"T1T2", "T1_plus_T2", "T1", "T2", "T3b", "T3w", "Kb", "Kw", "T_b", "T_w", "stable"})
        add(name, "-");
      break;
    case SweepTask::trial:
    case SweepTask::identify:
    case SweepTask::diagnose: break;
  }
  return columns;
}

std::size_t block_size_of(const SweepPlan& plan, const VariedShip& ship) {
  // measured: 0.15 µs a linear ship in packs, 13 µs an MMG ship in packs, 0.3 ms a ship alone, 0.1 ms its indices
  if (std::holds_alternative<LinearShip>(ship.ship())) return 8192;
  if (plan.task == SweepTask::zigzag && packs_serve(plan, ship)) return 512;
  return 64;
}

void fill_results(const SweepPlan& plan, const VariedShip& ship, SweepBlock& block) {
  const Results results(block, ship.laws().size());
  switch (plan.task) {
    case SweepTask::zigzag: return zigzags(plan, ship, block, results);
    case SweepTask::turn: return turns(plan, ship, block, results);
    case SweepTask::indices: return indices_of(ship, block, results);
    case SweepTask::trial:
    case SweepTask::identify:
    case SweepTask::diagnose: break;  // of recordings: case_tasks.hpp
  }
}

}  // namespace swayaw::app
