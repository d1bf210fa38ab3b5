#include <algorithm>
#include <catch.hpp>
#include <cmath>
#include <random>
#include <set>

#include "model_ships.hpp"
#include "random_effects.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"
#include "swayaw/nonlinear/effects/search_form.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"

/// What is asked of an effect by a search: its coordinates, when it acts, what it shows wrong, whether every ship has
/// it.
namespace swayaw {
namespace {

constexpr double duration = 300.0;  ///< of the longest run [s]

std::vector<Ship> ships_of_all_models() {
  return {test::with_areas(test::mmg(test::kvlcc2_l7())), test::with_areas(test::pi_ship("wpcc_pi")),
          test::with_areas(test::wpcc_pu()), test::with_areas(test::mariner())};
}

SearchContext context_of(const Ship& ship, std::span<const Parameter> parameters) {
  return {.parameters = parameters,
          .time_unit = time_unit_of(ship),
          .duration = duration,
          .rudder_rate = steering_gear(ship).rate};
}

template <class Kind>
SearchForm<Kind> form_of(const Kind& null, const SearchContext& context) {
  if constexpr (requires { search_form(null, context); }) return search_form(null, context);
  else return usual_form(null, context);
}

/// Calls visit(ship, form, parameters) for every kind of effect that has a parameter on one of the ships.
template <class Visit>
void for_each_form(const Visit& visit) {
  for (const auto& ship : ships_of_all_models())
    for_each_kind([&]<class Kind>() {
      const auto null = std::get<Kind>(make_effect(Kind::id));
      const auto parameters = parameters_of(ship, null);
      if (parameters.empty()) return;
      INFO(ship.name << ", " << Kind::id);
      visit(ship, form_of(null, context_of(ship, parameters)), parameters);
    });
}

template <class Kind>
void check_in_range(const Ship& ship, const Kind& effect) {
  for (const auto& p : parameters_of(ship, effect)) {
    INFO(p.key << " " << p.value);
    CHECK(p.range.contains(p.value));
  }
}

TEST_CASE("a search of an effect starts within its bounds, at an effect of that kind in its range",
          "[nonlinear][limit]") {
  std::set<std::string> ids;
  for_each_form([&](const Ship& ship, const auto& form, const auto&) {
    ids.insert(form.id);
    CHECK_FALSE(form.starts.empty());
    for (const auto& start : form.starts) {
      REQUIRE(start.size() == form.coordinates.size());
      for (std::size_t i = 0; i < start.size(); ++i) {
        CHECK(form.coordinates[i].low <= start[i]);
        CHECK(start[i] <= form.coordinates[i].high);
      }
      const auto effect = form.at(start);
      CHECK(id_of(effect) == form.id);
      check_in_range(ship, effect);
    }
  });
  CHECK(ids.size() > 30);
}

TEST_CASE("wherever a search moves between its bounds, numbers of an effect stay in their ranges",
          "[nonlinear][limit]") {
  std::mt19937_64 engine(11);
  std::normal_distribution<double> normal;
  for_each_form([&](const Ship& ship, const auto& form, const auto&) {
    for (int draw = 0; draw < 20; ++draw) {
      std::vector<double> c;
      for (const auto& k : form.coordinates)
        c.push_back(std::clamp(k.centre + 3.0 * k.deviation * normal(engine), k.low, k.high));
      check_in_range(ship, form.at(c));
    }
  });
}

/// Of a form at 0.5 along one coordinate: which parameters are not at null.
template <class Form>
std::vector<bool> moved_along(const Ship& ship, const Form& form, std::size_t k) {
  std::vector<double> c(form.coordinates.size(), 0.0);
  c[k] = std::min(0.5, form.coordinates[k].high);
  std::vector<bool> moved;
  for (const auto& p : parameters_of(ship, form.at(c))) moved.push_back(p.value != p.null);
  return moved;
}

TEST_CASE("the part of an effect with one of its terms moves what that term moves, and leaves the others at null",
          "[nonlinear][limit]") {
  int with_terms = 0;
  for_each_form([&](const Ship& ship, const auto& form, const auto&) {
    if (!form.with_terms) return;
    ++with_terms;
    for (std::size_t k = 0; k < form.coordinates.size(); ++k) {
      const auto part = form.with_terms(std::array{k});
      REQUIRE(part.coordinates.size() == 1);
      CHECK(part.coordinates.front().name == form.coordinates[k].name);
      const bool of_sides = part.coordinates.front().name.ends_with(" sides");
      CHECK(std::ranges::count(moved_along(ship, form, k), true) == (of_sides ? 2 : 1));
      CHECK(moved_along(ship, part, 0) == moved_along(ship, form, k));
    }
  });
  CHECK(with_terms > 0);
}

TEST_CASE("two sides of a coefficient are searched by what both change alike and by what they differ by",
          "[nonlinear][round-trip]") {
  const auto ship = test::kvlcc2_l7();
  const FlowStraightening<> none{};
  const auto parameters = parameters_of(ship, none);
  const auto form = form_of(none, context_of(ship, parameters));
  REQUIRE(form.coordinates.size() == 3);
  const auto deviations = [&](const std::array<double, 3>& c) {
    const auto now = parameters_of(ship, form.at(c));
    std::array<double, 3> off{};
    for (std::size_t i = 0; i < 3; ++i) off[i] = (now[i].value - now[i].null) / now[i].deviation;
    return off;
  };
  CHECK(form.coordinates[0].name == "gamma_R of both sides");
  CHECK(form.coordinates[1].name == "gamma_R between sides");
  const auto both = deviations({1.2, 0.0, 0.0}), between = deviations({0.0, 0.6, 0.0}),
             arm = deviations({0.0, 0.0, 0.7});
  CHECK_THAT(both[0], WithinRel(1.2, 1e-12));
  CHECK_THAT(both[1], WithinRel(1.2, 1e-12));
  CHECK(both[2] == 0.0);
  CHECK_THAT(between[0], WithinRel(0.3, 1e-12));
  CHECK_THAT(between[1], WithinRel(-0.3, 1e-12));
  CHECK(between[2] == 0.0);
  CHECK((arm[0] == 0.0 && arm[1] == 0.0));
  CHECK_THAT(arm[2], WithinRel(0.7, 1e-12));
  // every pair of values is somewhere
  const auto alone = deviations({0.45, 0.9, 0.0});
  CHECK_THAT(alone[0], WithinRel(0.9, 1e-12));
  CHECK(std::abs(alone[1]) < 1e-12);
  // what has no other side, or none in this model, is a term by itself
  CHECK(coefficient_of_side("gamma_R_positive") == "gamma_R");
  CHECK(coefficient_of_side("l_R").empty());
  CHECK(terms_of(std::span(parameters).first(1)).size() == 1);
}

TEST_CASE("what has a direction is searched by its north and east parts", "[nonlinear][round-trip]") {
  const auto ship = test::with_areas(test::mmg(test::kvlcc2_l7()));
  const SteadyCurrent<> none{};
  const auto parameters = parameters_of(ship, none);
  const auto form = form_of(none, context_of(ship, parameters));
  const double unit = parameters.front().deviation;
  const auto current = form.at(std::array{-3.0, 4.0});
  CHECK_THAT(current.*parameter_list<SteadyCurrent<>>[0].member, WithinRel(5.0 * unit, 1e-14));
  CHECK_THAT(current.*parameter_list<SteadyCurrent<>>[1].member, WithinRel(std::atan2(4.0, -3.0), 1e-14));
  CHECK(is_null(form.at(std::array{0.0, 0.0})));
}

TEST_CASE("an effect that begins and ends acts from its onset on until its end", "[nonlinear][limit]") {
  for (const auto id : effect_ids()) {
    auto effect = make_effect(id);
    INFO(id);
    CHECK(begins_and_ends(effect) == (id == "gust" || id == "unknown"));
    if (!begins_and_ends(effect)) {
      CHECK_FALSE(acting_time(effect));
      CHECK(acts_at(effect, -1e9));
      CHECK(acts_at(effect, 1e9));
      continue;
    }
    for_each_parameter(effect, [](const auto& p, double& value) {
      if (p.key == "onset_s") value = 10.0;
      if (p.key == "end_s") value = 12.0;
    });
    REQUIRE(acting_time(effect));
    CHECK(acting_time(effect)->onset == 10.0);
    CHECK(acting_time(effect)->end == 12.0);
    CHECK_FALSE(acts_at(effect, 9.999));
    CHECK(acts_at(effect, 10.0));
    CHECK(acts_at(effect, 11.999));
    CHECK_FALSE(acts_at(effect, 12.0));
  }
}

TEST_CASE("only instruments show something wrong, and a late receiver what its channel is of", "[nonlinear][limit]") {
  const std::set<std::string_view> quantities{"position", "heading", "yaw_rate", "speed", "drift"};
  for (const auto id : effect_ids()) {
    const auto effect = make_effect(id);
    INFO(id);
    if (channel_of(effect)) continue;
    if (place_of(effect) == EffectPlace::sensor) CHECK(quantities.contains(shown_wrong(effect)));
    else CHECK(shown_wrong(effect).empty());
  }
  const auto late = [](Channel channel) {
    ChannelDelay<> delay;
    delay.channel = channel;
    return std::string(shown_wrong(delay));
  };
  CHECK(late(Channel::x) == "position");
  CHECK(late(Channel::y) == "position");
  CHECK(late(Channel::psi) == "heading");
  CHECK(late(Channel::r) == "yaw_rate");
  CHECK(late(Channel::u) == "speed");
  CHECK(late(Channel::delta).empty());
}

TEST_CASE("weather and streams are of a day, instruments' zeros of a run, what is built in of the ship",
          "[nonlinear][limit]") {
  const auto scope = [](std::string_view id) { return name_of(scope_of(make_effect(id))); };
  CHECK(scope("steady_wind") == "group");
  CHECK(scope("steady_current") == "group");
  CHECK(scope("gyro_bias") == "run");
  CHECK(scope("gust") == "run");
  CHECK(scope("rudder_gap") == "ship");
  CHECK(scope("hull_linear_derivatives") == "ship");
}

TEST_CASE("gap and stall take lift of the rudder, and a little of it is what every ship has", "[nonlinear][limit]") {
  std::set<std::string_view> takers;
  for (const auto id : effect_ids())
    if (takes_rudder_lift(id)) takers.insert(id);
  CHECK(takers == std::set<std::string_view>{"rudder_gap", "rudder_stall"});

  const auto ship = test::kvlcc2_l7();
  const auto ordinary = [&](const Effect& effect) { return is_ordinary(effect, parameters_of(ship, effect)); };
  const RudderStall<> late{.angle = 1.5, .depth = 0.5, .width = 0.05}, early{.angle = 0.2, .depth = 0.9, .width = 0.05};
  CHECK(ordinary(late));
  CHECK_FALSE(ordinary(early));
  const RudderGap<> closed = std::get<RudderGap<>>(make_effect("rudder_gap")), open{0.05, -1.0};
  CHECK(ordinary(closed));
  CHECK_FALSE(ordinary(open));
  CHECK_FALSE(ordinary(SteadyCurrent<>{}));
}

TEST_CASE("a drag at one side is searched by its size and its moment", "[nonlinear][limit]") {
  const auto ship = test::kvlcc2_l7();
  const auto parameters = parameters_of(ship, UnknownForce<>{});
  const double L = length(ship);
  const auto form =
      drag_form(UnknownForce<>{}, {.parameters = parameters, .time_unit = 1.0, .duration = 1.0, .rudder_rate = 1.0});
  const auto at = [&](double drag, double moment) { return form.at(std::array{drag, moment}); };
  std::mt19937_64 engine(18);
  std::uniform_real_distribution<double> size(0.1, 3.0), place(-2.0, 2.0);
  for (int i = 0; i < 20; ++i) {
    const double drag = size(engine), moment = drag * place(engine);
    const auto found = at(drag, moment);
    CHECK_THAT(found.drag, WithinRel(1e-3 * drag, 1e-12));
    CHECK_THAT(found.drag * found.drag_y, WithinRel(1e-3 * 0.05 * L * moment, 1e-12));
    CHECK(at(drag, -moment).drag_y == -found.drag_y);
    CHECK_FALSE(acting_time(found));
  }
  // never beyond the side of a beamy ship
  CHECK_THAT(at(1.0, 5.0).drag_y, WithinRel(0.1 * L, 1e-12));
  CHECK_THAT(at(1.0, -5.0).drag_y, WithinRel(-0.1 * L, 1e-12));
  CHECK(form.coordinates[0].low > 0.0);
}

TEST_CASE("no turn is steady in waves or under a force that goes with the heading", "[nonlinear][limit]") {
  CHECK(never_steady(make_effect("wave_drift")) == "in waves");
  auto force = make_effect("unknown");
  CHECK(never_steady(force).empty());
  for_each_parameter(force, [](const auto& p, double& value) {
    if (p.key == "N_cos") value = 1e-4;
  });
  CHECK(never_steady(force) == "under a force that goes with the heading or the time");
  CHECK(never_steady(make_effect("rudder_gap")).empty());
}

}  // namespace
}  // namespace swayaw
