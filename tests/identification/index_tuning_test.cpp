#include "swayaw/identification/index_tuning.hpp"
#include "json.hpp"

#include <algorithm>
#include <catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "random_ships.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/estimates/nawigator.hpp"
#include "swayaw/nonlinear/manoeuvres/index_slopes.hpp"
#include "swayaw/nonlinear/published_ships.hpp"

namespace swayaw {
namespace {

const auto examples = std::filesystem::path(SWAYAW_TEST_EXAMPLES).parent_path() / "indices";

Ship nawigator() { return nawigator_xxi(NawigatorHull::yoshimura_masumoto, SurgeReading::negative_X_vr); }
MeasuredIndices nawigator_turns() { return read_indices(examples / "nawigator_turns.toml", 56.85); }

// ---------------------------------------------------------------- ships whose indices are known

template <class Indices>
MeasuredTrial trial_of(const MeasuredManoeuvre& manoeuvre, const Indices& indices) {
  MeasuredTrial trial{manoeuvre, {}};
  constexpr auto list = Indices::parameters();
  for (std::size_t k = 0; k < list.size(); ++k) {
    const double value = indices.*list[k].member;
    if (!std::isnan(value)) trial.indices.push_back({std::string(list[k].key), k, value, 0.05 * std::abs(value), 1.0});
  }
  return trial;
}

/// What the ship does in two turns and a zigzag to that side.
MeasuredIndices indices_of_ship(const Ship& ship, Side side) {
  MeasuredIndices measured;
  const ManoeuvreOptions options{.sampled = false};
  for (const double rudder : {0.25, 0.6}) {
    const TurnOrder order{rudder, side};
    measured.trials.push_back(trial_of(order, indices_of(turning_circle(ship, order, options), side)));
  }
  const ZigzagOrder order{0.35, 0.35, side};
  measured.trials.push_back(trial_of(order, indices_of(zigzag(ship, order, options))));
  return measured;
}

class TestShips {
 public:
  explicit TestShips(unsigned seed) : random_(seed) {}

  Ship symmetric() {
    auto model = random_.ship();
    model.rudder.gamma_R_positive = model.rudder.gamma_R_negative;
    model.propeller.C_2_positive = model.propeller.C_2_negative;
    model.steering_gear.max_angle = 0.7;
    return {.name = "test ship", .model = model, .confidence = {}, .surroundings = {}};
  }

  /// Every hull number changed by up to that share.
  Ship shaken(const Ship& ship, double share) {
    const auto parameters = coefficients_of(ship, "hull");
    std::vector<double> values;
    for (const auto& n : parameters)
      values.push_back(n.value * (n.key == "R_0" ? 1.0 : 1.0 + random_.uniform(-share, share)));
    return with_values(ship, parameters, values);
  }

 private:
  test::RandomShips random_;
};

constexpr double no_prior = 1e6;

TEST_CASE("indices of a known ship come back when she is tuned on them from numbers off by five per cent",
          "[identification][round-trip]") {
  TestShips ships(20261123);
  for (int i = 0; i < 6; ++i) {
    const Ship truth = ships.symmetric();
    const auto measured = indices_of_ship(truth, Side::starboard);
    const auto t = tune(ships.shaken(truth, 0.05), measured, {.prior = no_prior, .watch = {}});
    INFO("ship " << i << ", " << t.simulations.turns << " turns, error from " << t.before.turns << " to "
                 << t.after.turns);
    CHECK(t.before.turns > 1e-4);
    for (const auto& index : t.indices) {
      INFO(index.measured.name << " " << index.after << " for " << index.measured.value);
      CHECK_THAT(index.after, WithinRel(index.measured.value, 1e-6));
    }
  }
}

TEST_CASE("a symmetric ship is tuned alike on turns to port and to starboard", "[identification][symmetry]") {
  TestShips ships(5);
  const Ship truth = ships.symmetric(), start = ships.shaken(truth, 0.05);
  const auto port = tune(start, indices_of_ship(truth, Side::port), {.watch = {}}),
             starboard = tune(start, indices_of_ship(truth, Side::starboard), {.watch = {}});
  for (std::size_t j = 0; j < port.parameters.size(); ++j)
    CHECK_THAT(port.parameters[j].value, WithinRel(starboard.parameters[j].value, 1e-7));
}

TEST_CASE("a ship with the measured indices stays as she is", "[identification][limit]") {
  TestShips ships(8);
  const Ship ship = ships.symmetric();
  const auto t = tune(ship, indices_of_ship(ship, Side::starboard), {.watch = {}});
  CHECK(t.status == TuningStatus::converged);
  for (const auto& n : t.parameters) CHECK_THAT(n.value, WithinRel(n.number.value, 1e-7));
}

TEST_CASE("the tighter the prior the nearer the numbers stay, and without trust in one it is not moved at all",
          "[identification][limit]") {
  const auto moved = [](double prior) {
    const auto t = tune(nawigator(), nawigator_turns(), {.prior = prior, .watch = {}});
    double sum = 0.0;
    for (const auto& n : t.parameters) sum += std::pow(n.value / n.number.value - 1.0, 2);
    return sum;
  };
  CHECK(moved(0.02) < moved(0.1));
  CHECK(moved(0.1) < moved(0.5));
  Ship ship = nawigator();
  ship.confidence.named.emplace_back("N_vrr", 0.0);
  for (const auto& n : tune(ship, nawigator_turns()).parameters)
    CHECK((n.value == n.number.value) == (n.number.name == "N_vrr"));
}

TEST_CASE("no number changes by more than it may", "[identification][limit]") {
  const auto t = tune(nawigator(), nawigator_turns(), {.prior = no_prior, .most_change = 0.2, .watch = {}});
  int bound = 0;
  for (const auto& n : t.parameters) {
    CHECK(std::abs(n.value / n.number.value - 1.0) <= 0.2 + 1e-12);
    bound += n.at_bound;
  }
  CHECK(bound > 0);
  CHECK(t.after.turns < t.before.turns);
}

// ---------------------------------------------------------------- MV Nawigator XXI

TEST_CASE(
    "the initial hull of MV Nawigator XXI is tuned on her turns within 300 turning circles to an error that brute "
    "force does not reach",
    "[identification][published]") {
  const auto t = tune(nawigator(), nawigator_turns(), {.prior = 1.0, .most_change = 1.0, .watch = {}});
  CHECK(t.status == TuningStatus::converged);
  CHECK_THAT(t.before.turns, WithinRel(0.3383771805699379, 1e-6));
  CHECK(t.after.turns < 0.15);
  CHECK(t.simulations.turns <= 300);
}

TEST_CASE("bounds of 100 per cent and no prior give the optimum of an independent program",
          "[identification][published]") {
  const auto t = tune(nawigator(), nawigator_turns(), {.prior = no_prior, .most_change = 1.0, .watch = {}});
  CHECK(t.after.turns < 0.13940);
  CHECK(t.after.turns > 0.1385);
  CHECK(t.simulations.turns <= 300);
}

TEST_CASE("tuned on turns and the measured zigzag MV Nawigator XXI gets better in both",
          "[identification][published]") {
  const auto t = tune(nawigator(), read_indices(examples / "nawigator.toml", 56.85),
                      {.prior = 1.0, .most_change = 1.0, .watch = {}});
  CHECK(t.after.turns < 0.15);
  CHECK(t.after.zigzags < 0.5 * t.before.zigzags);
  CHECK(t.simulations.turns <= 300);
}

TEST_CASE("the turns of the tuned ship last", "[identification][second-route]") {
  const auto t = tune(nawigator(), nawigator_turns(), {.prior = 1.0, .most_change = 1.0, .watch = {}});
  for (std::size_t k = 0; k < 3; ++k) {
    const auto circle = turning_circle(t.ship, {.rudder = radians(35.0 - 10.0 * static_cast<double>(k))},
                                       {.rev = nawigator_rev, .duration = 3000.0, .sampled = true});
    CHECK(t.decay[k] > 0.1);
    REQUIRE(circle.steady);
    CHECK_THAT(circle.run[Channel::u].back(), WithinRel(t.indices[6 * k].after, 1e-6));
  }
}

TEST_CASE("eighteen turning indices tell six or seven of sixteen combinations of hull numbers to better than a half",
          "[identification][published]") {
  const auto s = index_sensitivity(nawigator(), nawigator_turns(), tuned_parameters(nawigator(), {}));
  const auto combinations = [&](double tolerance) {
    std::vector<double> of_measured;
    for (const auto& trial : nawigator_turns().trials)
      for (const auto& i : trial.indices)
        of_measured.push_back(tolerance * std::abs(i.value / s.indices[of_measured.size()]));
    return determined_combinations(s.exact, of_measured);
  };
  // an independent program, by differences, relative to the measured indices
  const std::array expected{4.6, 1.6, 1.4, 0.48, 0.29, 0.27, 0.13, 0.063, 0.029};
  const std::array half_digit{0.05, 0.05, 0.05, 0.005, 0.005, 0.005, 0.005, 0.0005, 0.0005};
  for (std::size_t i = 0; i < expected.size(); ++i)
    CHECK_THAT(combinations(1.0)[i].singular_value, WithinAbs(expected[i], half_digit[i]));
  const auto determined = [&](double tolerance) {
    return std::ranges::count(combinations(tolerance), true, &IndexCombination::determined);
  };
  CHECK(determined(0.05) == 7);
  CHECK(determined(0.1) == 6);
}

TEST_CASE("ten per cent of each number change the turns of MV Nawigator XXI as an independent program says",
          "[identification][published]") {
  const auto golden = test::json_in(test::golden / "kulbiej2021.json");
  const auto parameters = tuned_parameters(nawigator(), {});
  const auto s = index_sensitivity(nawigator(), nawigator_turns(), parameters);
  const auto& table = golden["sensitivity_10percent"]["table_percent"];
  for (std::size_t j = 0; j < parameters.size(); ++j) {
    auto symbol = parameters[j].name;
    symbol.erase(1, 1);
    for (std::size_t k = 0; k < 6; ++k)
      CHECK_THAT(100.0 * s.ten_per_cent[k][j], WithinAbs(table[symbol]["35"][k].get<double>(), 1e-3));
  }
}

TEST_CASE("exact sensitivities are the limit of finite ones", "[identification][limit]") {
  const auto ship = nawigator();
  const auto parameters = tuned_parameters(ship, {.parameters = {"N_r", "Y_vrr"}, .watch = {}});
  const auto s = index_sensitivity(ship, nawigator_turns(), parameters);
  for (std::size_t k = 0; k < s.exact.size(); ++k)
    for (std::size_t j = 0; j < 2; ++j) CHECK_THAT(10.0 * s.ten_per_cent[k][j], WithinAbs(s.exact[k][j], 0.15));
}

// ---------------------------------------------------------------- ends

TEST_CASE("a tuning that is told to stop gives the best ship so far", "[identification][limit]") {
  int calls = 0;
  const auto watch = [&](const TuningProgress&) { return ++calls < 3; };
  const auto t = tune(nawigator(), nawigator_turns(), {.prior = 1.0, .watch = watch});
  CHECK(t.status == TuningStatus::interrupted);
  CHECK(t.after.turns < t.before.turns);
  const auto at_once = tune(nawigator(), nawigator_turns(), {.watch = [](const TuningProgress&) { return false; }});
  CHECK(at_once.after.turns == at_once.before.turns);
}

TEST_CASE("no more turning circles are sailed than allowed", "[identification][limit]") {
  const auto t = tune(nawigator(), nawigator_turns(), {.prior = 1.0, .most_turns = 20, .watch = {}});
  CHECK(t.status == TuningStatus::simulation_limit);
  CHECK(t.simulations.turns <= 20);
}

TEST_CASE("what cannot be tuned is refused in words", "[identification][refusal]") {
  const auto turns = nawigator_turns();
  CHECK_THROWS_WITH(
      tune(nawigator_xxi(NawigatorHull::n7), turns),
      ContainsSubstring("has no final_u_m_s in the turn 35 to starboard to begin with: no steady turn was found"));
  CHECK_THROWS_WITH(tune(nawigator(), turns, {.parameters = {"N_x"}, .watch = {}}),
                    ContainsSubstring("her model has no number N_x"));
  CHECK_THROWS_WITH(tune(nawigator(), turns, {.parameters = {"x_g_m"}, .watch = {}}), ContainsSubstring("x_g_m is 0"));
  Ship windy = nawigator();
  windy.surroundings.windy = true;
  CHECK_THROWS_AS(tune(windy, turns), Refusal);
  CHECK_THROWS_AS(tune(nawigator(), turns, {.prior = 0.0, .watch = {}}), std::domain_error);
  CHECK_THROWS_AS(tune(nawigator(), turns, {.most_turns = 0, .watch = {}}), std::domain_error);
  CHECK_THROWS_AS(tune(nawigator(), parse_indices("[[turn]]\nrudder_deg = 50\nadvance_L = 3\n", "a", 56.85)),
                  std::domain_error);
  CHECK_THROWS_AS(determined_combinations({{1.0}}, {0.1, 0.2}), std::domain_error);
}

}  // namespace
}  // namespace swayaw
