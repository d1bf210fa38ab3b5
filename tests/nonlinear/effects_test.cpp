#include "swayaw/nonlinear/effects.hpp"

#include <algorithm>
#include <catch.hpp>
#include <cmath>

#include "random_effects.hpp"
#include "swayaw/core/dual.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/instruments/instruments.hpp"
#include "swayaw/nonlinear/linearization.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/manoeuvres/spiral.hpp"
#include "swayaw/nonlinear/models/force_breakdown.hpp"
#include "swayaw/nonlinear/published_ships.hpp"
#include "swayaw/nonlinear/replay.hpp"
#include "swayaw/nonlinear/ship_file.hpp"
#include "swayaw/nonlinear/simulation/equations_of_motion.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"

#define EVERY_MODEL MmgShip<double>, PiShip<double>, PuShip<double>, AbkowitzShip<double>

namespace swayaw {
namespace {

using test::RandomEffects;
using test::RandomModels;

/// A ship of each model that ends a zigzag.
template <class Model>
Model sailing_ship() {
  if constexpr (std::is_same_v<Model, MmgShip<double>>) return test::mmg(test::kvlcc2_l7());
  else if constexpr (std::is_same_v<Model, PiShip<double>>) return test::pi_ship("wpcc_pi");
  else if constexpr (std::is_same_v<Model, PuShip<double>>) return test::wpcc_pu();
  else return test::mariner();
}

Recording zigzag_of(const Ship& ship, double lengths = 10.0, double tolerance = 1e-10, double step = 0.01) {
  const double time_unit = time_unit_of(ship);
  return zigzag(ship, {.rudder = radians(10), .heading = radians(10)},
                {.duration = lengths * time_unit, .step = step * time_unit, .tolerance = tolerance})
      .run;
}

double largest_difference(const Recording& a, const Recording& b, Channel channel) {
  REQUIRE(a.samples() == b.samples());
  double largest = 0.0;
  for (std::size_t i = 0; i < a.samples(); ++i) largest = std::max(largest, std::abs(a[channel][i] - b[channel][i]));
  return largest;
}

std::vector<double> numbers_of_effect(const Effect& effect) {
  std::vector<double> numbers;
  for_each_parameter(effect, [&](const auto&, double value) { numbers.push_back(value); });
  return numbers;
}

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

// ---------------------------------------------------------------- the list of effects

TEST_CASE("every effect has a name, lists its numbers and does nothing at first", "[nonlinear][limit]") {
  CHECK(effect_ids().size() == effect_count);
  for (const auto id : effect_ids()) {
    const auto effect = make_effect(id);
    CHECK(id_of(effect) == id);
    CHECK(is_null(effect));
    CHECK(parameter_count(effect) > 0);
  }
  CHECK_THROWS_AS(make_effect("kelp"), std::domain_error);
}

TEMPLATE_TEST_CASE("priors and floors grow with the ship and are never negative", "[nonlinear][limit]", EVERY_MODEL) {
  const auto ship = test::with_areas(sailing_ship<TestType>());
  for (const auto id : effect_ids())
    for (const auto& n : parameters_of(ship, make_effect(id))) {
      INFO(id << " " << n.key);
      CHECK(n.deviation > 0.0);
      CHECK(n.floor >= 0.0);
      CHECK(n.floor < n.deviation);
    }
}

// ---------------------------------------------------------------- null does nothing

TEMPLATE_TEST_CASE("an effect at its null value changes no force, to the last bit", "[nonlinear][limit]", EVERY_MODEL) {
  RandomModels random(71);
  for (int i = 0; i < 20; ++i) {
    const auto bare = test::with_areas(random.ship<TestType>());
    const auto& model = std::get<TestType>(bare.model);
    const ShipState<double> state{0.0, 0.0, random.uniform(-pi, pi), random.motion(model)};
    const auto controls = random.controls(model);
    const auto before = force_breakdown(bare, state, controls);
    for (const auto id : effect_ids()) {
      const auto effect = make_effect(id);
      if (!cannot_act(bare.model, effect).empty()) continue;
      const auto after = force_breakdown(with_effect(bare, effect), state, controls);
      INFO(id);
      CHECK(after.total.X == before.total.X);
      CHECK(after.total.Y == before.total.Y);
      CHECK(after.total.N == before.total.N);
      CHECK(after.acceleration.r == before.acceleration.r);
    }
  }
}

TEST_CASE("all effects at their null values leave a zigzag as it is, to the last bit", "[nonlinear][limit]") {
  auto ship = test::with_areas(sailing_ship<MmgShip<double>>());
  const auto before = zigzag_of(ship);
  for (const auto id : effect_ids()) ship = with_effect(ship, make_effect(id));
  const auto after = zigzag_of(ship);
  for (const Channel channel :
       {Channel::x, Channel::y, Channel::psi, Channel::u, Channel::v, Channel::r, Channel::delta, Channel::rev})
    CHECK(largest_difference(before, after, channel) == 0.0);
}

TEMPLATE_TEST_CASE("an added force vanishes with its size", "[nonlinear][limit]", EVERY_MODEL) {
  RandomModels random(72);
  for (int i = 0; i < 20; ++i) {
    const auto model = random.ship<TestType>();
    const auto motion = random.motion(model);
    const auto controls = random.controls(model);
    for (const auto id : {CrossFlowDrag<>::id, WaveDrift<>::id, RollCoupling<>::id, FluidMemory<>::id}) {
      if (!cannot_act(model, make_effect(id)).empty()) continue;
      const std::vector<Effect> effects{make_effect(id)};
      const auto added = acting_effects(model, std::span<const Effect>(effects));
      const auto f = added_force(model, added, ShipState<double>{0.0, 0.0, 1.0, motion},
                                 Hidden<double>{0.1, 0.0, 0.0, 0.0}, controls);
      CHECK(f.X + f.Y + f.N == 0.0);
    }
  }
}

// ---------------------------------------------------------------- symmetry

TEMPLATE_TEST_CASE("drag, heel and memory are the same to both sides", "[nonlinear][symmetry]", EVERY_MODEL) {
  RandomModels random(73);
  RandomEffects effects(73);
  for (int i = 0; i < 50; ++i) {
    const auto model = random.ship<TestType>();
    const auto ship = test::ship_of(model);
    const auto motion = random.motion(model);
    const auto controls = random.controls(model);
    for (const auto id : {CrossFlowDrag<>::id, RollCoupling<>::id, FluidMemory<>::id}) {
      const auto effect = effects.of_kind(id, ship);
      if (!effect) continue;
      const std::vector<Effect> list{*effect};
      const auto added = acting_effects(model, std::span<const Effect>(list));
      const Hidden<double> hidden{0.1, 0.02, 0.5 * motion.v, 0.3 * motion.r},
          other{-0.1, -0.02, -0.5 * motion.v, -0.3 * motion.r};
      const auto port = added_force(model, added, ShipState<double>{0.0, 0.0, 0.0, motion}, hidden, controls);
      const auto starboard =
          mirrored(added_force(model, added, ShipState<double>{0.0, 0.0, 0.0, mirrored(motion)}, other, controls));
      CHECK(port.X == starboard.X);
      CHECK(port.Y == starboard.Y);
      CHECK(port.N == starboard.N);
      const auto rate = hidden_rates(added, motion, hidden, 0.01),
                 mirror = hidden_rates(added, mirrored(motion), other, -0.01);
      for (std::size_t k = 0; k < hidden_count; ++k) CHECK(rate[k] == -mirror[k]);
    }
  }
}

TEST_CASE("a shaft slows with the speed that the ship loses, as much to both sides", "[nonlinear][symmetry]") {
  const auto ship = test::kvlcc2_l7();
  const auto acting = acting_ship(with_effect(ship, ShaftSpeedDrop<>{0.4}), test::mmg(ship));
  const double U = test::mmg(ship).particulars.U_0;
  const auto rev_at = [&](const PlanarMotion<double>& m) {
    return driven(acting.added, m, Controls<double>{.rev = 10.0}).rev;
  };
  CHECK(rev_at({U, 0.0, 0.0}) == 10.0);
  CHECK_THAT(rev_at({0.5 * U, 0.1, 0.02}), WithinRel(10.0 * (1.0 - 0.4 * 0.5), 1e-14));
  CHECK(rev_at({0.6 * U, 0.2, 0.05}) == rev_at({0.6 * U, -0.2, -0.05}));
}

TEMPLATE_TEST_CASE("a force without a name is what its terms say", "[nonlinear][second-route]", EVERY_MODEL) {
  RandomModels random(74);
  for (int i = 0; i < 20; ++i) {
    const auto model = random.ship<TestType>();
    const auto m = random.motion(model);
    const auto controls = random.controls(model);
    const double psi = random.uniform(-pi, pi), L = model.particulars.L, U = model.particulars.U_0,
                 q = 0.5 * model.water.rho * L * L * U * U;
    const auto force_of = [&](const UnknownForce<double>& map) {
      const std::vector<Effect> effects{map};
      return added_force(model, acting_effects(model, std::span<const Effect>(effects)),
                         ShipState<double>{0.0, 0.0, psi, m}, Hidden<double>{}, controls);
    };
    const double v = m.v / U, r = m.r * L / U;
    const auto f =
        force_of({.X_cos = 0.2, .X_vr = 0.3, .X_dd = 0.1, .Y_0 = 0.4, .Y_vv = -0.5, .N_sin = 0.6, .N_d = -0.7});
    CHECK_THAT(f.X, WithinRel(q * (0.2 * std::cos(psi) + 0.3 * v * r + 0.1 * controls.delta * controls.delta), 1e-12));
    CHECK_THAT(f.Y, WithinRel(q * (0.4 - 0.5 * v * std::abs(v)), 1e-12));
    CHECK_THAT(f.N, WithinRel(q * L * (0.6 * std::sin(psi) - 0.7 * controls.delta), 1e-12));
    const auto g = force_of({.Y_r = 0.2, .N_rr = 0.3});
    CHECK_THAT(g.Y, WithinRel(0.2 * q * r, 1e-12));
    CHECK_THAT(g.N, WithinRel(0.3 * q * L * r * std::abs(r), 1e-12));

    // a drag against the flow past midship, at a point abeam
    const double drag = random.uniform(1e-4, 2e-3), y = random.uniform(-0.1, 0.1) * L, speed = std::hypot(m.u, m.v);
    const auto h = force_of({.drag = drag, .drag_y = y});
    CHECK_THAT(std::hypot(h.X, h.Y), WithinRel(0.5 * model.water.rho * L * L * drag * speed * speed, 1e-12));
    CHECK_THAT(h.X * m.v, WithinAbs(h.Y * m.u, 1e-12 * std::abs(h.X * speed)));
    CHECK(h.X * m.u < 0.0);
    CHECK_THAT(h.N, WithinRel(-y * h.X, 1e-12));
  }
}

TEST_CASE("wind, waves and current turn with the run", "[nonlinear][symmetry]") {
  RandomEffects random(74);
  const auto bare = test::with_areas(sailing_ship<MmgShip<double>>());
  const auto& model = std::get<MmgShip<double>>(bare.model);
  for (const auto id : {SteadyWind<>::id, WaveDrift<>::id, SteadyCurrent<>::id, Gust<>::id})
    for (int i = 0; i < 5; ++i) {
      const auto effect = *random.of_kind(id, bare);
      const double turn = random.uniform(-pi, pi);
      auto turned = effect;
      const std::size_t direction_at = id == WaveDrift<>::id ? 0 : 1;
      parameter_value(turned, direction_at) += turn;
      const auto a = with_effect(bare, effect), b = with_effect(bare, turned);
      const double time = id == Gust<>::id ? std::get<Gust<>>(effect).onset : 0.0, psi = random.uniform(-pi, pi);
      const auto rates = [&](const Ship& ship, double heading) {
        const ShipState<double> state{0.0, 0.0, heading, {1.0, 0.05, 0.02}};
        const auto acting = acting_ship(ship, model);
        const Controls<double> controls{.delta = 0.1, .rev = 10.0};
        return rates_of(acting.model, surroundings_at(ship, time), acting.added, state, Hidden<double>{}, controls,
                        branch_at(acting.model, state.motion, controls));
      };
      const auto before = rates(a, psi), after = rates(b, psi + turn);
      INFO(id);
      CHECK_THAT(after[0], WithinAbs(before[0] * std::cos(turn) - before[1] * std::sin(turn), 1e-12));
      CHECK_THAT(after[1], WithinAbs(before[0] * std::sin(turn) + before[1] * std::cos(turn), 1e-12));
      for (const std::size_t k : {3u, 4u, 5u}) CHECK_THAT(after[k], WithinAbs(before[k], 1e-12));
    }
}

// ---------------------------------------------------------------- second routes

TEST_CASE("the closed form of the cross-flow drag is the sum over strips", "[nonlinear][second-route]") {
  RandomModels random(75);
  const ShipFacts<double> a{.rho = 1025.0, .L = 7.0, .d = 0.4};
  const CrossFlowDrag<double> drag{0.9};
  for (int i = 0; i < 200; ++i) {
    const PlanarMotion<double> m{1.0, random.uniform(-0.5, 0.5), random.uniform(-0.3, 0.3)};
    constexpr int strips = 20000;
    double Y = 0.0, N = 0.0;
    for (int k = 0; k < strips; ++k) {
      const double x = a.L * ((k + 0.5) / strips - 0.5), w = m.v + x * m.r;
      Y -= std::abs(w) * w;
      N -= x * std::abs(w) * w;
    }
    const double q = 0.5 * a.rho * a.d * drag.C_D * a.L / strips;
    const ShipState<double> state{0.0, 0.0, 0.0, m};
    const Controls<double> still{};
    const auto f = force(drag, MmgShip<double>{}, Circumstances<double>{a, state, still, still, {}});
    CHECK_THAT(f.Y, WithinAbs(q * Y, 1e-6 * a.rho));
    CHECK_THAT(f.N, WithinAbs(q * N, 1e-6 * a.rho));
  }
}

template <class Model>
PlanarForce<double> added_at(const Model& model, const ActingEffects<double>& added, const std::array<double, 8>& x,
                             const Controls<double>& controls) {
  return added_force(model, added, ShipState<double>{0.0, 0.0, x[0], {x[1], x[2], x[3]}},
                     Hidden<double>{x[4], x[5], x[6], x[7]}, controls);
}

TEMPLATE_TEST_CASE("duals of added forces agree with differences", "[nonlinear][second-route]", EVERY_MODEL) {
  using D = Dual<8>;
  RandomModels random(76);
  RandomEffects effects(76);
  for (int i = 0; i < 20; ++i) {
    const auto model = random.ship<TestType>();
    const auto motion = random.motion(model);
    const auto controls = random.controls(model);
    std::vector<Effect> list;
    for (const auto id : effect_ids())
      if (const auto effect = effects.of_kind(id, test::ship_of(model));
          effect && place_of(*effect) == EffectPlace::force)
        list.push_back(*effect);
    const auto added = acting_effects(model, std::span<const Effect>(list));
    const std::array<double, 8> x{0.7, motion.u, motion.v, motion.r, 0.1, 0.02, 0.5 * motion.v, 0.4 * motion.r};
    std::array<D, 8> d;
    for (int k = 0; k < 8; ++k) d[static_cast<std::size_t>(k)] = D(x[static_cast<std::size_t>(k)], k);
    const auto f = added_force(cast<D>(model), cast<D>(added), ShipState<D>{D(0.0), D(0.0), d[0], {d[1], d[2], d[3]}},
                               Hidden<D>{d[4], d[5], d[6], d[7]}, cast<D>(controls));
    CHECK_THAT(f.Y.a, WithinRel(added_at(model, added, x, controls).Y, 1e-12));
    for (std::size_t k = 0; k < 8; ++k) {
      const double h = 1e-5 * (std::abs(x[k]) + 1e-3);
      auto up = x, down = x;
      up[k] += h;
      down[k] -= h;
      const auto a = added_at(model, added, up, controls), b = added_at(model, added, down, controls);
      const double size = std::abs(f.Y.a) + std::abs(f.N.a);
      CHECK(f.Y.v[static_cast<int>(k)] * 2.0 * h == Approx(a.Y - b.Y).margin(1e-9 * size));
      CHECK(f.N.v[static_cast<int>(k)] * 2.0 * h == Approx(a.N - b.N).margin(1e-9 * size));
    }
  }
}

TEMPLATE_TEST_CASE("an effect written by hand is the same as changed numbers", "[nonlinear][second-route]",
                   EVERY_MODEL) {
  RandomModels random(77);
  const auto model = random.ship<TestType>();
  const auto ship = with_effect(test::ship_of(model), HullLinearDerivatives<>{.Y_v = -0.4, .N_r = -0.06});
  auto changed = model;
  changed.hull.Y_v = -0.4;
  changed.hull.N_r = -0.06;
  for (int i = 0; i < 20; ++i) {
    const ShipState<double> state{0.0, 0.0, 0.0, random.motion(model)};
    const auto controls = random.controls(model);
    CHECK(force_breakdown(ship, state, controls).total.Y ==
          force_breakdown(test::ship_of(changed), state, controls).total.Y);
    CHECK(force_breakdown(ship, state, controls).total.N ==
          force_breakdown(test::ship_of(changed), state, controls).total.N);
  }
  const auto applied = with_effects_applied(ship);
  CHECK(applied.effects.empty());
  CHECK(std::get<TestType>(applied.model).hull.Y_v == -0.4);
}

TEST_CASE("the effects on the rudder are the numbers of the rudder", "[nonlinear][second-route]") {
  const auto bare = test::kvlcc2_l7();
  const auto model = test::mmg(bare);
  const auto ship = with_effect(with_effect(with_effect(bare, RudderEffectiveness<>{0.8}), RudderStall<>{0.25}),
                                RudderGap<>{0.3, -1.5});
  const auto acting = acting_ship(ship, model);
  CHECK(acting.model.rudder.f_alpha == 0.8 * model.rudder.f_alpha);
  CHECK(acting.model.rudder.alpha_s == 0.25);
  CHECK(acting.model.rudder.s == -1.5);
  const PlanarMotion<double> ahead{1.18, 0.0, 0.0};
  const auto turned = [&](const MmgShip<double>& m, double delta) {
    return forces(m, ahead, Controls<double>{.delta = delta, .rev = 11.0}).rudder.Y;
  };
  // far below the stall angle only the factor acts
  CHECK_THAT(turned(acting.model, 0.01), WithinRel(0.8 * turned(model, 0.01), 1e-3));
  const auto l = [](double alpha) { return 1.0 / (1.0 + std::exp(-(alpha - 0.25) / 0.05)); };
  // straight ahead alpha = delta
  const double stalled = 1.0 - 0.5 * (l(0.45) - l(0.0)) / (1.0 - l(0.0)), gap = 1.0 - 1.5 * 0.15 * 0.15;
  CHECK_THAT(turned(acting.model, 0.45), WithinRel(0.8 * stalled * gap * turned(model, 0.45), 1e-12));
}

TEST_CASE("a stalled or gapped rudder of the lifting line loses its lift by the same factors",
          "[nonlinear][second-route]") {
  const auto model = sailing_ship<PiShip<double>>();
  const auto ship = with_effect(test::ship_of(model), RudderEffectiveness<>{0.9});
  CHECK(acting_ship(ship, model).model.rudder.lift_factor == 0.9);
  const Stall<double> stall{0.3, 0.6, 0.04}, none{0.0, 0.6, 0.04};
  CHECK(stall_factor(stall, 0.0) == 1.0);
  CHECK(stall_factor(none, 1.0) == 1.0);
  CHECK(stall_factor(stall, -0.5) == stall_factor(stall, 0.5));
  CHECK_THAT(stall_factor(stall, 0.3), WithinAbs(1.0 - 0.3, 1e-3));  // half of the loss at alpha_s
  CHECK_THAT(stall_factor(stall, 1.5), WithinAbs(1.0 - 0.6, 1e-9));
}

// ---------------------------------------------------------------- shallow water

TEST_CASE("shallow water goes over into deep water", "[nonlinear][limit]") {
  const auto all = [](const ShallowWaterFactors<double>& f) {
    return std::array{f.sway, f.yaw, f.cubic, f.R_0, f.m_x, f.m_y, f.J_z, f.one_minus_t, f.one_minus_w, f.gamma_R};
  };
  const ShallowWaterGrowth<double> usual;
  for (const double factor : all(shallow_water_factors(0.81, 1e6, usual))) CHECK_THAT(factor, WithinAbs(1.0, 1e-6));
  // damping and added mass grow as the bottom comes nearer, sway most
  double before = 1.0;
  for (const double depth : {2.5, 2.0, 1.5, 1.2}) {
    const auto f = shallow_water_factors(0.81, depth, usual);
    CHECK(f.sway > before);
    CHECK(f.sway > f.cubic);
    CHECK(f.cubic > f.m_y);
    CHECK(f.m_y > f.R_0);
    CHECK(f.R_0 > 1.0);
    before = f.sway;
  }
  CHECK(before > 2.0);
  CHECK(before < 5.0);
}

TEST_CASE("a ship turns wider in shallow water", "[nonlinear][limit]") {
  const auto deep = test::kvlcc2_l7();
  const auto shallow = with_effect(deep, ShallowWater<>{1.5});
  const TurnOrder order{.rudder = radians(35), .side = Side::starboard};
  CHECK(*turning_circle(shallow, order).tactical_diameter > *turning_circle(deep, order).tactical_diameter);
}

// ---------------------------------------------------------------- files

TEMPLATE_TEST_CASE("a ship file holds every effect", "[nonlinear][round-trip]", EVERY_MODEL) {
  RandomEffects random(78);
  const auto bare = test::with_areas(sailing_ship<TestType>());
  auto all = bare;
  int written = 0;
  for (const auto id : effect_ids()) {
    const auto effect = random.of_kind(id, bare);
    if (!effect) continue;
    ++written;
    all = with_effect(all, *effect);
    const auto back = parse_ship(ship_text(with_effect(bare, *effect)), "back.toml");
    INFO(id);
    REQUIRE(back.effects.size() == 1);
    CHECK(back.effects.front().index() == effect->index());
    CHECK(std::ranges::equal(numbers_of_effect(back.effects.front()), numbers_of_effect(*effect), same));
  }
  CHECK(written >= 17);
  CHECK(parse_ship(ship_text(all), "all.toml").effects.size() == all.effects.size());
  CHECK(ship_text(parse_ship(ship_text(all), "all.toml")) == ship_text(all));
}

std::string file_with(const Ship& ship, const std::string& effects) { return ship_text(ship) + effects; }

TEST_CASE("effects of a file are refused in words", "[nonlinear][refusal]") {
  const auto ship = test::with_areas(sailing_ship<MmgShip<double>>());
  const auto refusal = [&](const std::string& lines) -> std::string {
    try {
      parse_ship(file_with(ship, "\n[[effect]]\n" + lines), "s.toml");
    } catch (const FileError& trouble) {
      return trouble.what();
    }
    return "";
  };
  CHECK_THAT(refusal("kind = \"unknown\"\n"), ContainsSubstring("unknown has no numbers"));
  CHECK_THAT(
      refusal("kind = \"rudder_offset\"\noffset_rad = 0.1\n[[effect]]\nkind = \"rudder_offset\"\noffset_rad = 0.2\n"),
      ContainsSubstring("rudder_offset is given twice"));
  CHECK_THAT(refusal("kind = \"rudder_offset\"\noffset_rad = 7\n"),
             ContainsSubstring(":14: offset_rad in [[effect]] cannot be 7"));
  CHECK_THAT(refusal("kind = \"channel_delay\"\ndelay_s = 1\n"), ContainsSubstring("channel_delay needs channel"));
  CHECK_THAT(refusal("kind = \"channel_delay\"\nchannel = \"tide\"\ndelay_s = 1\n"),
             ContainsSubstring("channel \"tide\" is not known"));
  CHECK_THAT(refusal("kind = \"flow_straightening\"\nkappa_v = 1\n"),
             ContainsSubstring("flow_straightening: a ship of model \"mmg\" has no kappa_v"));
  CHECK_THAT(refusal("kind = \"hull_linear_derivatives\"\n"),
             ContainsSubstring("hull_linear_derivatives has no numbers"));
  CHECK(refusal("kind = \"channel_delay\"\nchannel = \"psi\"\ndelay_s = 1\n[[effect]]\nkind = "
                "\"channel_delay\"\nchannel = \"r_rad_s\"\ndelay_s = 1\n")
            .empty());
  const std::string clock = "kind = \"clock_drift\"\nchannel = \"x\"\n", next = "[[effect]]\n" + clock;
  CHECK_THAT(refusal(clock), ContainsSubstring("clock_drift has no numbers"));
  CHECK_THAT(refusal(clock + "by_s = 2\n"), ContainsSubstring("clock_drift: a jump needs at_s and by_s"));
  CHECK_THAT(refusal(clock + "rate = 0.001\nat_s = 20\n"), ContainsSubstring("a jump needs at_s and by_s"));
  CHECK(refusal(clock + "rate = 0.001\n" + next + "at_s = 20\nby_s = 2\n" + next + "at_s = 60\nby_s = -1\n").empty());
  CHECK_THAT(refusal(clock + "at_s = 20\nby_s = 2\n" + next + "at_s = 20\nby_s = -1\n"),
             ContainsSubstring("clock_drift is given twice"));
  CHECK_THAT(refusal("kind = \"channel_filter\"\nchannel = \"r\"\ntime_s = 1\ncausal = 2\n"),
             ContainsSubstring("causal in [[effect]] cannot be 2"));
  const auto abkowitz = test::ship_of(sailing_ship<AbkowitzShip<double>>());
  CHECK_THROWS_WITH(zigzag_of(with_effect(abkowitz, CrossFlowDrag<>{0.5})),
                    "cross_flow_drag cannot act on a ship of model \"abkowitz\"");
  CHECK_THROWS_WITH(zigzag_of(with_effect(abkowitz, AddedResistance<>{0.5})),
                    "added_resistance cannot act on a ship of model \"abkowitz\"");
  CHECK_THROWS_WITH(spiral(with_effect(ship, WaveDrift<>{0.0, 10.0})), ContainsSubstring("no turn is steady in waves"));
  CHECK_THROWS_WITH(spiral(with_effect(ship, UnknownForce<>{.Y_cos = 1e-4})),
                    ContainsSubstring("a force that goes with the heading"));
  CHECK_THROWS_WITH(spiral(with_effect(ship, SteadyWind<>{5.0, 0.0})), ContainsSubstring("no turn is steady in wind"));
}

// ---------------------------------------------------------------- simulation and replay

TEMPLATE_TEST_CASE("a replay of a simulated run with the effect in the file is that run", "[nonlinear][round-trip]",
                   EVERY_MODEL) {
  RandomEffects random(79);
  const auto bare = test::with_areas(sailing_ship<TestType>());
  const double L = length(bare), U = service_speed(bare);
  const auto without = zigzag_of(bare, 10.0, 1e-9);
  for (const auto id : effect_ids()) {
    const auto effect = random.of_kind(id, bare);
    if (!effect) continue;
    INFO(id);
    const auto ship = with_effect(bare, *effect);
    const auto run = zigzag_of(ship, 10.0, 1e-9);
    const auto again = replay(ship, run);
    const double start = 0.5 * L / U;
    REQUIRE(run.time.back() > start);
    CHECK(largest_difference(again, run, Channel::psi) < radians(0.1));
    CHECK(largest_difference(again, run, Channel::x) < 0.01 * L);
    CHECK(largest_difference(again, run, Channel::y) < 0.01 * L);
    CHECK(largest_difference(again, run, Channel::r) < 0.01 * U / L);
    CHECK(largest_difference(again, run, Channel::delta) < radians(0.2));
    double change = 0.0;
    for (const Channel channel :
         {Channel::x, Channel::psi, Channel::u, Channel::v, Channel::r, Channel::delta, Channel::y}) {
      const double unit = channel == Channel::x || channel == Channel::y   ? L
                          : channel == Channel::u || channel == Channel::v ? U
                          : channel == Channel::r                          ? U / L
                                                                           : 1.0;
      change = std::max(change, largest_difference(run, without, channel) / unit);
    }
    if (id != WakeChange<>::id) CHECK(change > 1e-4);
  }
}

TEST_CASE("a gust outside the run does nothing, and nothing before it begins", "[nonlinear][limit]") {
  const auto bare = test::with_areas(sailing_ship<MmgShip<double>>());
  const auto calm = zigzag_of(bare);
  const auto late = zigzag_of(with_effect(bare, Gust<>{10.0, 1.0, 1e4, 2e4}));
  CHECK(largest_difference(calm, late, Channel::y) == 0.0);
  const double onset = 0.5 * calm.time.back();
  const auto gusty = zigzag_of(with_effect(bare, Gust<>{10.0, 1.0, onset, 2.0 * onset}));
  double before = 0.0, after = 0.0;
  for (std::size_t i = 0; i < calm.samples(); ++i) {
    auto& largest = calm.time[i] < onset ? before : after;
    largest = std::max(largest, std::abs(calm[Channel::psi][i] - gusty[Channel::psi][i]));
  }
  CHECK(before < 1e-8);
  CHECK(after > radians(0.1));
}

TEST_CASE("a gust that blows all the time is a steady wind, and winds add as vectors", "[nonlinear][second-route]") {
  const auto bare = test::with_areas(sailing_ship<MmgShip<double>>());
  const auto steady = zigzag_of(with_effect(bare, SteadyWind<>{5.0, 1.0})),
             gust = zigzag_of(with_effect(bare, Gust<>{5.0, 1.0, -1.0, 1e9}));
  CHECK(largest_difference(steady, gust, Channel::psi) == 0.0);
  const auto both =
      surroundings_at(with_effect(with_effect(bare, SteadyWind<>{3.0, 0.0}), Gust<>{4.0, 0.5 * pi, 0.0, 1.0}), 0.5);
  CHECK_THAT(both.wind.speed, WithinRel(5.0, 1e-14));
  CHECK_THAT(both.wind.from, WithinRel(std::atan2(4.0, 3.0), 1e-14));
}

TEST_CASE("heel settles where the centrifugal force holds it, and a memory forgets", "[nonlinear][second-route]") {
  const auto model = sailing_ship<MmgShip<double>>();
  auto roll = make_effect("roll_coupling");
  const PlanarMotion<double> m{1.0, 0.05, 0.1};
  const Controls<double> controls{.delta = -0.3, .rev = 10.0};  // to starboard
  double outward = 0.0;
  for (const double rudder_lever : {0.0, 0.05}) {
    std::get<RollCoupling<>>(roll).rudder_lever = rudder_lever;
    const std::vector<Effect> effects{roll, make_effect("fluid_memory")};
    const auto added = acting_effects(model, std::span<const Effect>(effects));
    const auto steady = steady_hidden(model, added, m, controls);
    const double phi = shown_by(steady, Channel::phi);
    CHECK(phi < 0.0);                              // outward, to port, in a turn to starboard
    if (rudder_lever > 0.0) CHECK(phi > outward);  // less, for the rudder pushes the stern outward from below
    outward = phi;
    const auto rate = hidden_rates(model, added, m, steady, controls);
    for (const double r : rate) CHECK_THAT(r, WithinAbs(0.0, 1e-14));
  }
}

// The roll of a zigzag, by differences of what was sailed: the hidden quantities that carry it need no acceleration.
TEST_CASE("a ship rolls about the force that holds her sideways", "[nonlinear][second-route]") {
  const auto model = sailing_ship<MmgShip<double>>();
  constexpr double GM = 0.04, zeta = 0.15, lever = 0.1;
  const double rudder_lever = GENERATE(0.0, 0.05);
  const auto ship =
      with_effect(test::with_areas(model),
                  RollCoupling<>{.GM = GM, .Y_phi = -0.01, .zeta = zeta, .lever = lever, .rudder_lever = rudder_lever});
  const auto run = zigzag_of(ship, 5.0);
  const auto &phi = run[Channel::phi], &u = run[Channel::u], &v = run[Channel::v], &r = run[Channel::r];
  const double h = run.time[1] - run.time[0], k_xx = 0.4 * model.particulars.B,
               omega = std::sqrt(effect_gravity * GM) / k_xx;
  const auto by_rudder = [&](std::size_t i) {  // Y_R/m
    const auto state =
        ShipState<double>{run[Channel::x][i], run[Channel::y][i], run[Channel::psi][i], {u[i], v[i], r[i]}};
    const auto split = force_breakdown(ship, state, {.delta = run[Channel::delta][i], .rev = run[Channel::rev][i]});
    double Y = 0.0;
    for (const auto& part : split.parts)
      if (part.name == "rudder" || part.name == "rudder_hull_interaction") Y += part.force.Y;
    REQUIRE(Y != 0.0);
    return Y / (model.water.rho * model.particulars.nabla);
  };
  double heaviest = 0.0, most = 0.0;
  for (std::size_t i = 1; i + 1 < run.samples(); ++i) {
    const double p = (phi[i + 1] - phi[i - 1]) / (2.0 * h), dp = (phi[i + 1] - 2.0 * phi[i] + phi[i - 1]) / (h * h),
                 side = (v[i + 1] - v[i - 1]) / (2.0 * h) + u[i] * r[i];
    const double moment = -(lever * side + rudder_lever * by_rudder(i)) / (k_xx * k_xx);
    heaviest = std::max(heaviest, std::abs(moment));
    most = std::max(most, std::abs(dp + 2.0 * zeta * omega * p + omega * omega * phi[i] - moment));
  }
  CHECK(heaviest > 0.0);
  CHECK(most < 1e-2 * heaviest);
}

// KG 18.6 m and GM 5.7 m of the full-scale ship, as the SIMMAN workshops give them.
TEST_CASE("metacentre and side force of a tanker and a container ship are where published data have them",
          "[nonlinear][published]") {
  const auto tanker = ship_facts(std::get<MmgShip<double>>(test::kvlcc2_l7().model));
  CHECK_THAT(metacentre(tanker), WithinRel((18.6 + 5.7) * tanker.L / 320.0, 0.02));
  // [Son1982] as [MSS] tables her: KM, GM and K_v/Y_v L
  const ShipFacts<double> container{.L = 175.0, .B = 25.4, .d = 8.5, .nabla = 21222.0};
  CHECK_THAT(metacentre(container), WithinRel(10.39, 0.06));
  CHECK_THAT(completed(RollCoupling<>{.GM = 0.3}, container).lever, WithinRel(0.0003026 / 0.0116 * 175.0, 0.15));
}

TEST_CASE("a heeling ship in a long turn comes to the steady motion of her effects", "[nonlinear][second-route]") {
  auto ship = test::kvlcc2_l7();
  for (const Effect& effect :
       {Effect(RollCoupling<>{.Y_phi = -0.05, .N_phi = -0.03, .rudder_lever = GENERATE(0.0, 0.05)}),
        Effect(FluidMemory<>{3.0, 0.4}), Effect(CrossFlowDrag<>{0.4}), Effect(PropellerSideForce<>{0.05, 0.0}),
        Effect(ShaftSpeedDrop<>{0.1})})
    ship = with_effect(ship, effect);
  const auto turn = turning_circle(ship, {.rudder = radians(20), .side = Side::port}, {.duration = 1500.0});
  const auto steady = steady_motion(ship, with_rudder(turn.propulsion, radians(20)), {0.8, 0.1, -0.1});
  REQUIRE(steady);
  CHECK_THAT(turn.run[Channel::r].back(), WithinAbs(steady->motion.r, 1e-6));
  CHECK_THAT(turn.run[Channel::u].back(), WithinAbs(steady->motion.u, 1e-6));
  CHECK(turn.run[Channel::phi].back() > 0.0);
}

TEMPLATE_TEST_CASE("what drags on a ship all the time is carried by her propulsion", "[nonlinear][second-route]",
                   MmgShip<double>, PiShip<double>, PuShip<double>) {
  const auto model = sailing_ship<TestType>();
  Ship bare;
  bare.model = model;
  const double L = model.particulars.L;
  RandomModels random(79);
  for (int i = 0; i < 20; ++i) {
    const double U = random.uniform(0.5, 1.0) * model.particulars.U_0;
    const UnknownForce<double> weed{.drag = random.uniform(1e-4, 1e-3), .drag_y = random.uniform(-0.1, 0.1) * L};
    const auto ship = with_effect(bare, weed);
    const auto carried = self_propulsion(ship, U), alone = self_propulsion(bare, U);
    const auto a = force_breakdown(ship, {0.0, 0.0, 0.0, {U, 0.0, 0.0}}, carried).acceleration;
    CHECK_THAT(a.u, WithinAbs(0.0, 1e-13 * U * U / L));
    CHECK(carried.rev + carried.thrust.port > alone.rev + alone.thrust.port);
    CHECK(propulsion(ship, U, {}, {}).rev == carried.rev);
    CHECK(propulsion(ship, U, {}, {}).thrust.port == carried.thrust.port);
    if constexpr (std::is_same_v<TestType, MmgShip<double>>) {
      const double increase = weed.drag * L / (model.particulars.d * model.hull.R_0);
      CHECK_THAT(self_propulsion(with_effect(bare, AddedResistance<>{increase}), U).rev, WithinRel(carried.rev, 1e-13));
    }
    // a tug, or what goes with the heading, finds her propulsion as it was
    for (const auto& other : {UnknownForce<double>{.X_0 = -1e-3, .onset = 10.0, .end = 60.0},
                              UnknownForce<double>{.X_cos = -1e-3}, UnknownForce<double>{.Y_0 = 1e-3, .N_0 = 1e-4}}) {
      const auto beside = self_propulsion(with_effect(bare, other), U);
      CHECK(beside.rev == alone.rev);
      CHECK(beside.thrust.port == alone.thrust.port);
    }
  }
}

TEST_CASE("the parts of a linearized ship with effects add up to differences of her acceleration",
          "[nonlinear][second-route]") {
  const auto ship =
      with_effect(with_effect(test::kvlcc2_l7(), CrossFlowDrag<>{0.6}), RollCoupling<>{.Y_phi = -0.05, .N_phi = -0.03});
  const auto driven_by = self_propulsion(ship, 1.0);
  const auto steady = steady_motion(ship, with_rudder(driven_by, radians(15)), {0.9, 0.05, -0.05});
  REQUIRE(steady);
  const auto linear = linearize(ship, {steady->motion, with_rudder(driven_by, radians(15))});
  const auto acceleration_of = [&](double u, double v, double r) {
    return force_breakdown(ship, {0.0, 0.0, 0.0, {u, v, r}}, with_rudder(driven_by, radians(15))).acceleration;
  };
  const auto& [u, v, r] = steady->motion;
  const double h = 1e-6;
  const auto by_v = acceleration_of(u, v + h, r), by_v_less = acceleration_of(u, v - h, r);
  const auto by_r = acceleration_of(u, v, r + h), by_r_less = acceleration_of(u, v, r - h);
  CHECK_THAT(linear.whole.d[1][1], WithinRel((by_v.v - by_v_less.v) / (2.0 * h), 1e-6));
  CHECK_THAT(linear.whole.d[2][1], WithinRel((by_v.r - by_v_less.r) / (2.0 * h), 1e-6));
  CHECK_THAT(linear.whole.d[2][2], WithinRel((by_r.r - by_r_less.r) / (2.0 * h), 1e-6));
  const auto is_named = [](std::string_view name) {
    return [name](const PartDerivatives& part) { return part.name == name; };
  };
  CHECK(std::ranges::any_of(linear.parts, is_named("cross_flow_drag")));
  CHECK(std::ranges::any_of(linear.parts, is_named("roll_coupling")));
}

// ---------------------------------------------------------------- sensors

TEST_CASE("a run as recorded and put right again is the run", "[nonlinear][round-trip]") {
  const auto truth = zigzag_of(test::with_areas(sailing_ship<MmgShip<double>>()));
  const auto instruments_with = [](const std::vector<Effect>& e) { return instruments_of(std::span<const Effect>(e)); };
  const auto sensors = instruments_with(
      {HeadingBias<>{0.03}, GyroBias<>{0.002}, LogScale<>{1.1}, AntennaLeverArm<>{2.0, -0.3}, VelocityAxes<>{0.04}});
  const auto back = as_it_was(as_recorded(truth, sensors), sensors);
  for (const Channel channel : {Channel::x, Channel::y, Channel::psi, Channel::u, Channel::v, Channel::r})
    CHECK(largest_difference(truth, back, channel) < 1e-12);
  const auto late = instruments_with({ChannelDelay<>{Channel::r, 0.2}, ChannelDelay<>{Channel::x, -0.3}});
  const auto shifted = as_it_was(as_recorded(truth, late), late);
  CHECK(largest_difference(truth, shifted, Channel::r) < 1e-3);
  CHECK(largest_difference(truth, shifted, Channel::x) < 1e-3);
}

TEST_CASE("biases, scales and levers have the signs of the documentation", "[nonlinear]") {
  const auto truth = zigzag_of(test::with_areas(sailing_ship<MmgShip<double>>()));
  const auto seen = [&](const Effect& effect) { return as_recorded(truth, instruments_of(std::span(&effect, 1))); };
  CHECK(seen(HeadingBias<>{0.1})[Channel::psi][5] == truth[Channel::psi][5] + 0.1);
  CHECK(seen(GyroBias<>{0.1})[Channel::r][5] == truth[Channel::r][5] + 0.1);
  CHECK(seen(LogScale<>{1.1})[Channel::u][5] == truth[Channel::u][5] * 1.1);
  CHECK_THAT(seen(AntennaLeverArm<>{2.0, 0.5})[Channel::x][0], WithinAbs(2.0, 1e-12));
  CHECK_THAT(seen(AntennaLeverArm<>{2.0, 0.5})[Channel::y][0], WithinAbs(0.5, 1e-12));
  // axes turned to starboard: her way ahead seems one to port
  CHECK_THAT(seen(VelocityAxes<>{0.1})[Channel::v][5],
             WithinAbs(truth[Channel::v][5] * std::cos(0.1) - truth[Channel::u][5] * std::sin(0.1), 1e-12));
  const double step = truth.time[1] - truth.time[0];
  CHECK_THAT(seen(ChannelDelay<>{Channel::psi, 3.0 * step})[Channel::psi][10],
             WithinAbs(truth[Channel::psi][7], 1e-12));
}

}  // namespace
}  // namespace swayaw
