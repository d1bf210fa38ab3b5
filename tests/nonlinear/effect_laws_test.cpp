#include <algorithm>
#include <catch.hpp>
#include <cmath>
#include <set>
#include <string>

#include "random_effects.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/effects.hpp"
#include "swayaw/nonlinear/instruments/instruments.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/models/force_breakdown.hpp"

/// Laws of every effect in the list, and of single ones beside a second route.
#define EVERY_MODEL MmgShip<double>, PiShip<double>, PuShip<double>, AbkowitzShip<double>

namespace swayaw {
namespace {

using test::RandomEffects;
using test::RandomModels;

// ---------------------------------------------------------------- the list

TEST_CASE("every effect has words of its own, a place, a scope and units", "[nonlinear][limit]") {
  std::set<std::string_view> ids, phrases, labels;
  for (const auto id : effect_ids()) {
    INFO(id);
    const auto effect = make_effect(id);
    const auto& text = text_of(effect);
    CHECK(ids.insert(id).second);
    CHECK(phrases.insert(text.phrase).second);
    CHECK(labels.insert(text.label).second);
    CHECK_FALSE(text.law.empty());
    CHECK_FALSE(text.confused_with.empty());
    CHECK_FALSE(name_of(place_of(effect)).empty());
    for_each_parameter(effect, [](const auto& p, double) {
      INFO(p.key);
      CHECK(p.prior > 0.0);
      CHECK(p.law >= 0.0);
      std::string ending = "_" + std::string(p.unit);  // of m/s: _m_s
      std::ranges::replace(ending, '/', '_');
      if (p.unit != "-" && !p.unit.starts_with("1/")) CHECK(p.key.ends_with(ending));
      if (p.direction) CHECK(p.unit == "rad");
    });
  }
}

TEST_CASE("an effect that begins and ends acts between, and the wind with it", "[nonlinear][limit]") {
  const auto bare = test::with_areas(test::mmg(test::kvlcc2_l7()));
  const auto& model = std::get<MmgShip<double>>(bare.model);
  const auto ship = with_effect(with_effect(bare, Gust<>{4.0, 0.3, 10.0, 20.0}),
                                UnknownForce<>{.Y_0 = 1e-3, .onset = 15.0, .end = 30.0});
  const auto acting = acting_ship(ship, model);
  const auto at = [&](double time) {
    const auto now = acting.at(time);
    return std::pair{now.surroundings.windy, now.added.any()};
  };
  CHECK(at(9.9) == std::pair{false, false});
  CHECK(at(10.0) == std::pair{true, false});
  CHECK(at(15.0) == std::pair{true, true});
  CHECK(at(20.0) == std::pair{false, true});
  CHECK(at(30.0) == std::pair{false, false});
}

// ---------------------------------------------------------------- other values

/// The parameter of the ship that one of an effect replaces, by the names of the ship file.
const Parameter* place_of_value(std::span<const Parameter> of_ship, const Effect& effect, std::size_t index) {
  const Parameter* found = nullptr;
  std::size_t next = 0;
  for_each_parameter(effect, [&](const auto& p, double) {
    if (next++ != index) return;
    for (const auto& s : of_ship)
      if ((s.key == p.replaces[0] || s.key == p.replaces[1]) &&
          (s.table == p.table || (s.table == "inertia" && p.table == "added_mass")))
        found = &s;
  });
  return found;
}

TEMPLATE_TEST_CASE("what an effect replaces stands in the ship, and nothing else has moved",
                   "[nonlinear][second-route]", EVERY_MODEL) {
  RandomModels random(91);
  const auto ship = test::ship_of(random.ship<TestType>());
  const auto before = parameters_of(ship);
  int replaced = 0;
  for_each_kind([&]<class Kind>() {
    if constexpr (puts_values<Kind>() && !requires { Kind::takes_rudder_lift; }) {
      for (const auto& p : parameters_of(ship, Kind{})) {
        INFO(Kind::id << " " << p.key);
        const double value =
            p.range.contains(p.null + 0.5 * p.deviation) ? p.null + 0.5 * p.deviation : p.null - 0.5 * p.deviation;
        Effect effect = Kind{};
        parameter_value(effect, p.index) = value;
        const auto after = parameters_of(with_effects_applied(with_effect(ship, effect)));
        const auto* place = place_of_value(after, effect, p.index);
        REQUIRE(place);
        CHECK(place->value == value);
        for (const auto& other : after)
          if (other.index != place->index) CHECK(other.value == before[other.index].value);
        ++replaced;
      }
    }
  });
  CHECK(replaced >= 10);
}

TEST_CASE("added resistance is a share of the resistance", "[nonlinear][second-route]") {
  const auto bare = test::kvlcc2_l7();
  const auto& m = test::mmg(bare);
  const ShipState<double> ahead{0.0, 0.0, 0.0, {1.1, 0.0, 0.0}};
  const Controls<double> controls{.delta = 0.0, .rev = 10.0};
  const auto X = [&](const Ship& ship) { return force_breakdown(ship, ahead, controls).total.X; };
  const double resistance = 0.5 * m.water.rho * m.particulars.L * m.particulars.d * 1.1 * 1.1 * m.hull.R_0;
  CHECK_THAT(X(bare) - X(with_effect(bare, AddedResistance<>{0.3})), WithinRel(0.3 * resistance, 1e-10));
}

TEST_CASE("shallow water changes the hull by the formulas of the documentation", "[nonlinear][second-route]") {
  const auto bare = test::kvlcc2_l7();
  const auto deep = test::mmg(bare);
  const auto applied = with_effects_applied(with_effect(bare, ShallowWater<>{.depth_over_draught = 1.5, .yaw = 2.0}));
  const auto& shallow = std::get<MmgShip<double>>(applied.model);
  const double x = 1.0 / 1.5, G = std::pow(x, 2.5) / std::pow(1.0 - x, 0.8);
  CHECK_THAT(shallow.hull.Y_v / deep.hull.Y_v, WithinRel(1.0 + 0.75 * G, 1e-12));
  CHECK_THAT(shallow.hull.N_r / deep.hull.N_r, WithinRel(1.0 + 0.35 * 2.0 * G, 1e-12));
  CHECK_THAT(shallow.hull.Y_vrr / deep.hull.Y_vrr, WithinRel(1.0 + 0.6 * G, 1e-12));
  CHECK_THAT(shallow.added_mass.m_y / deep.added_mass.m_y, WithinRel(1.0 + 0.45 * G, 1e-12));
  CHECK_THAT(shallow.hull.R_0 / deep.hull.R_0, WithinRel(1.0 + 0.12 * G, 1e-12));
}

// ---------------------------------------------------------------- forces

/// What an effect alone adds.
PlanarForce<double> added_by(const Effect& effect, const MmgShip<double>& model, const ShipState<double>& state,
                             const Controls<double>& controls) {
  const std::vector<Effect> effects{effect};
  return added_force(model, acting_effects(model, std::span<const Effect>(effects)), state, Hidden<double>{}, controls);
}

TEST_CASE("waves drift a ship by where they come from", "[nonlinear][second-route]") {
  const auto model = test::mmg(test::kvlcc2_l7());
  const double F = 12.0, L = model.particulars.L;
  const WaveDrift<> waves{.from = 1.0, .force = F, .ahead = 0.5, .moment = 0.1};
  const auto at = [&](double psi) { return added_by(waves, model, {0.0, 0.0, psi, {1.0, 0.1, 0.02}}, {}); };
  const auto head = at(1.0), beam = at(1.0 - 0.5 * pi), quarter = at(1.0 - 0.25 * pi);  // from starboard
  CHECK_THAT(head.X, WithinRel(-0.5 * F, 1e-14));
  CHECK_THAT(head.Y, WithinAbs(0.0, 1e-14));
  CHECK_THAT(beam.Y, WithinRel(-F, 1e-14));
  CHECK_THAT(beam.N, WithinAbs(0.0, 1e-13));
  CHECK_THAT(quarter.Y, WithinRel(-0.5 * F, 1e-14));
  CHECK_THAT(quarter.N, WithinRel(0.1 * F * L, 1e-14));
}

TEST_CASE("the side force of a propeller is a share of a thrust that is known", "[nonlinear][second-route]") {
  const auto model = test::mmg(test::kvlcc2_l7());
  const Controls<double> controls{.delta = 0.1, .thrust = {30.0, 0.0}, .by_thrust = true};
  const auto f = added_by(PropellerSideForce<>{0.04, 0.5}, model, {0.0, 0.0, 0.0, {1.0, 0.1, 0.02}}, controls);
  CHECK_THAT(f.Y, WithinRel(0.04 * 30.0 + 0.5, 1e-14));
  CHECK_THAT(f.N, WithinRel(model.propeller.x_P * model.particulars.L * f.Y, 1e-14));
}

TEST_CASE("a memory that has forgotten nothing holds its share of the damping back", "[nonlinear][second-route]") {
  const auto model = test::mmg(test::kvlcc2_l7());
  const PlanarMotion<double> m{1.0, 0.1, 0.02};
  const auto& [p, h] = std::tie(model.particulars, model.hull);
  const double U = std::hypot(m.u, m.v), q = 0.5 * model.water.rho * p.L * p.d * U;
  // v_s = r_s = 0: −share D(v, r)
  const auto f = added_by(FluidMemory<>{5.0, 0.4}, model, {0.0, 0.0, 0.0, m}, {});
  CHECK_THAT(f.Y, WithinRel(-0.4 * q * (h.Y_v * m.v + h.Y_r * m.r * p.L), 1e-12));
  CHECK_THAT(f.N, WithinRel(-0.4 * q * p.L * (h.N_v * m.v + h.N_r * m.r * p.L), 1e-12));
}

TEST_CASE("streams add as vectors", "[nonlinear][second-route]") {
  auto ship = test::kvlcc2_l7();
  ship.surroundings.current = {.speed = 0.3, .to = 0.0};
  const auto sum = surroundings_at(with_effect(ship, SteadyCurrent<>{0.4, 0.5 * pi}), 0.0).current;
  CHECK_THAT(sum.speed, WithinRel(0.5, 1e-14));
  CHECK_THAT(sum.to, WithinRel(std::atan2(0.4, 0.3), 1e-14));
}

// ---------------------------------------------------------------- instruments

TEST_CASE("an instrument shows at a time what it records of a run", "[nonlinear][second-route]") {
  const auto truth =
      zigzag(test::kvlcc2_l7(), {.rudder = radians(10), .heading = radians(10)}, {.duration = 30.0, .step = 0.05}).run;
  const std::vector<Effect> instruments{HeadingBias<>{0.03},
                                        GyroBias<>{0.002},
                                        LogScale<>{1.1},
                                        VelocityAxes<>{0.04},
                                        AntennaLeverArm<>{2.0, -0.3},
                                        ChannelDelay<>{Channel::r, 0.05},
                                        ChannelDelay<>{Channel::x, -0.02},
                                        ClockDrift<>{.channel = Channel::psi, .rate = 0.003},
                                        ClockDrift<>{.channel = Channel::u, .rate = 0.0, .at = 10.0, .by = 0.04},
                                        ChannelFilter<>{.channel = Channel::r, .time = 0.05},
                                        ChannelFilter<>{.channel = Channel::v, .time = 0.1, .causal = 0.0}};
  int kinds = 0;
  for_each_kind([&]<class Kind>() { kinds += IsInstrument<Kind> && find<Kind>(std::span<const Effect>(instruments)); });
  CHECK(kinds == 8);
  const std::size_t i = truth.samples() / 2;
  const auto value = [&](Channel c) { return truth[c][i]; };
  const ShipState<double> state{value(Channel::x),
                                value(Channel::y),
                                value(Channel::psi),
                                {value(Channel::u), value(Channel::v), value(Channel::r)}};
  const auto rate = [&](Channel c) {
    return (truth[c][i + 1] - truth[c][i - 1]) / (truth.time[i + 1] - truth.time[i - 1]);
  };
  const PlanarAcceleration<double> acceleration{rate(Channel::u), rate(Channel::v), rate(Channel::r)};
  for (const auto& instrument : instruments) {
    const auto wrong = instruments_of(std::span(&instrument, 1));
    const auto record = as_recorded(truth, wrong);
    const auto ago = [&](double delay) {
      return kinematics(moved_back(state, Current<double>{}, acceleration, delay), Current<double>{});
    };
    for (const auto channel : {Channel::x, Channel::y, Channel::psi, Channel::u, Channel::v, Channel::r}) {
      INFO(id_of(instrument) << " " << short_name(channel));
      CHECK_THAT(observe(channel, wrong, ago, {truth.time[i], truth.time.front()}),
                 WithinAbs(record[channel][i], 2e-5));
    }
  }
}

}  // namespace
}  // namespace swayaw
