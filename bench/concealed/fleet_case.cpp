#include "fleet_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <stdexcept>

#include "day.hpp"
#include "fair_ship.hpp"
#include "on_board_instruments.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/mismatch/compare.hpp"

namespace swayaw::concealed {
namespace {

constexpr double first_day = 20454.0;  ///< 2026-01-01
constexpr double year = 365.0;         ///< [days]

/// A sister: the same ship with what yards and service make of her.
TrueShip sister_of(TrueShip ship, RandomSource& random) {
  constexpr double spread = 0.02;
  for (double* value : {&ship.Y_v, &ship.Y_r, &ship.N_v, &ship.N_r, &ship.C_D, &ship.R_0, &ship.f_alpha, &ship.a_H,
                        &ship.gamma, &ship.w_0, &ship.m_y, &ship.J_z})
    *value *= 1.0 + spread * random.normal();
  return ship;
}

/// Something that happens to ships, of a size that an owner wants to know of.
std::optional<TrueChange> change_by_chance(RandomSource& random, const TrueShip& ship) {
  const std::size_t kind = random.below(6);
  TrueChange change{
      .effect = {}, .shape = ChangeShape::sudden, .size = 0.0, .since = first_day + year * random.uniform(0.25, 0.8)};
  switch (kind) {
    case 0: change.effect = "rudder_offset", change.size = random.sign() * radians(random.uniform(0.8, 2.0)); break;
    case 1: change.effect = "rudder_effectiveness", change.size = -random.uniform(0.12, 0.3); break;
    case 2: change.effect = "added_resistance", change.size = random.uniform(0.15, 0.4); break;
    case 3: change.effect = "log_scale", change.size = random.sign() * random.uniform(0.03, 0.08); break;
    case 4:
      change.effect = "gyro_bias", change.size = random.sign() * random.uniform(0.006, 0.015) / ship.time_unit();
      break;
    default: change.effect = "heading_bias", change.size = random.sign() * radians(random.uniform(1.0, 3.0));
  }
  if (change.effect == "added_resistance") change.shape = ChangeShape::gradual, change.since -= 0.2 * year;
  return change;
}

void put(Concealment& hidden, const TrueChange& change, double share) {
  const double size = share * change.size;
  if (change.effect == "rudder_offset") hidden.rudder_offset = size;
  else if (change.effect == "rudder_effectiveness") hidden.lift = size;
  else if (change.effect == "added_resistance") hidden.resistance = size;
  else if (change.effect == "log_scale") hidden.log_scale = size;
  else if (change.effect == "gyro_bias") hidden.gyro_bias = size;
  else hidden.heading_bias = size;
}

std::vector<Manoeuvre> manoeuvres_of(RandomSource& random, std::size_t day) {
  const bool port = random.below(2) == 0;
  const double heading = random.uniform(0.0, 2.0 * std::numbers::pi);
  const std::array all{zigzag(10, 10, port, heading), turn(35, port, heading), zigzag(20, 20, port, heading),
                       turn(20, !port, heading)};
  return {all[day % all.size()], day % 2 == 0 ? passage(wrapped(heading + 2.0), radians(10.0))
                                              : zigzag(15, 10, !port, wrapped(heading + 2.4))};
}

}  // namespace

FleetCase fleet_by_chance(std::uint64_t seed, bool quiet) {
  RandomSource random(seed_of(seed, 0xf1ee7));
  constexpr std::array structures{"cross_flow", "polynomial", "twin_screw", "tanker", "container"};
  FleetCase fleet{
      .structure = structures[random.below(structures.size())], .ship = {}, .runs = {}, .changes = {}, .vessels = {}};
  auto class_ship = true_ship(fleet.structure, random.bits());
  class_ship.droop = 0.0;
  constexpr std::array forms{FileForm::mmg, FileForm::mmg, FileForm::pi};
  const double error = random.uniform(0.03, 0.08);
  const auto fair = fair_ship(class_ship, forms[random.below(forms.size())], error);
  fleet.ship = slightly_wrong(fair.ship, random.bits());
  fleet.ship.name = fmt::format("class of {:.0f} m", class_ship.L);
  const std::size_t count = 2 + random.below(3);
  for (std::size_t vessel = 0; vessel < count; ++vessel) {
    const auto name = fmt::format("ship_{}", vessel + 1);
    fleet.vessels.push_back(name);
    const auto ship = sister_of(class_ship, random);
    std::optional<TrueChange> change;
    if (const bool happens = random.below(2) == 0; happens && !quiet) change = change_by_chance(random, ship);
    Concealment at_the_end{};
    if (change) put(at_the_end, *change, 1.0);
    const auto board = instruments_by_chance(random, ship, at_the_end);
    const std::size_t days = 6 + random.below(7);
    const double last = first_day + year * (static_cast<double>(days) - 0.5) / static_cast<double>(days);
    for (std::size_t i = 0; i < days; ++i) {
      const double date =
          first_day + year * (static_cast<double>(i) + random.uniform(0.1, 0.9)) / static_cast<double>(days);
      const auto weather = day_by_chance(random, ship);
      auto hidden = weather.calm();
      // no two days are alike: trim, draught, a rudder indicator that is set again
      hidden.resistance += 0.02 * random.normal(), hidden.rudder_offset += radians(0.05) * random.normal();
      if (change && date >= change->since) {
        Concealment now{};
        put(now, *change,
            change->shape == ChangeShape::sudden ? 1.0
                                                 : std::min(1.0, (date - change->since) / (last - change->since)));
        hidden.resistance += now.resistance, hidden.rudder_offset += now.rudder_offset, hidden.lift = now.lift;
        hidden.log_scale = now.log_scale, hidden.gyro_bias = now.gyro_bias, hidden.heading_bias = now.heading_bias;
      }
      std::size_t number = 0;
      for (const auto& manoeuvre : manoeuvres_of(random, i)) {
        Manoeuvre longer = manoeuvre;
        longer.lengths += 0.8;  // filters look ahead
        const auto track =
            true_track(ship, hidden, longer,
                       {.turbulence = weather.turbulence, .gust_memory = weather.gust_memory, .seed = random.bits()});
        auto run = recorded_on_board(ship, hidden, manoeuvre, board, track, random);
        run.name = fmt::format("{}/{}_{}.csv", name, date_text(date), ++number);
        run.facts.remarks.push_back({"start_utc", fmt::format("\"{}T09:0{}:00Z\"", date_text(date), number)});
        fleet.runs.push_back({name, std::move(run)});
      }
    }
    fleet.changes.push_back(std::move(change));
  }
  return fleet;
}

}  // namespace swayaw::concealed
