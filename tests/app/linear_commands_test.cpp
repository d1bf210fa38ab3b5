#include <catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "files.hpp"
#include "json.hpp"
#include "program.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/recording_csv.hpp"

/// `swayaw indices`, `invert`, `loop` and `simulate` on linear ships, from the outside.
namespace swayaw {
namespace {

using nlohmann::json;
using test::document;
using test::refusal;
using test::run;
using test::Scratch;

const std::string parts_ship = test::ship_file("tanker97.toml");
const std::string abc_ship = test::ship_file("tanker97_abc.toml");
const std::string nomoto_ship = test::ship_file("tanker97_nomoto.toml");
const std::string mmg_ship = test::ship_file("kvlcc2_l7.toml");

/// The reference counts 13.39 s to the ship length.
const std::string reference_speed = "--speed 7.274085138162808";

json golden() { return test::json_in(test::golden / "artyszuk_linear.json").at("artyszuk"); }

/// A ship file with that form in the folder.
std::string written(const Scratch& folder, const std::string& form) {
  const auto file = folder / "ship.toml";
  write_text(file, "name = \"a\"\nmodel = \"linear\"\n[particulars]\nlength_m = 100\nservice_speed_m_s = 8\n" + form +
                       "\n[rudder]\nrate_deg_s = 2.5\nmax_angle_deg = 35\n");
  return file.string();
}

/// What a command says of a ship with that form.
struct Told {
  int code;
  json document;
  std::string err;
};

Told told(const std::string& form, const std::string& command, const std::string& rest = "") {
  const Scratch folder;
  const auto ship = written(folder, form);
  const auto outcome = run(folder, command + " " + ship + " " + rest + " --json");
  return {outcome.code, outcome.out.empty() ? json() : test::json_of(outcome.out), outcome.err};
}

std::string coefficients_form(double a1, double b1, double c1, double a2, double b2, double c2) {
  const auto line = [](const char* key, double value) { return std::string(key) + " = " + json(value).dump() + "\n"; };
  return "[linear]\n" + line("a1", a1) + line("b1", b1) + line("c1", c1) + line("a2", a2) + line("b2", b2) +
         line("c2", c2);
}

std::string nomoto_form(double T3b, double T3w, double Kb, double Kw) {
  const auto text = [](double value) { return json(value).dump(); };
  return "[nomoto]\nT1 = 10\nT2 = 0.3\nT3b = " + text(T3b) + "\nT3w = " + text(T3w) + "\nKb = " + text(Kb) +
         "\nKw = " + text(Kw) + "\n";
}

void check_near(const json& found, const json& wanted, double tolerance = 1e-9) {
  REQUIRE(found.is_number());
  CHECK_THAT(found.get<double>(), WithinRel(wanted.get<double>(), tolerance));
}

// ---------------------------------------------------------------- indices

void check_record(const json& found, const json& record) {
  for (const char* key : {"a1", "b1", "c1", "a2", "b2", "c2"}) check_near(found.at(key), record.at("abc").at(key));
  for (const char* key : {"T1", "T2", "T3b", "T3w", "Kb", "Kw"}) check_near(found.at(key), record.at(key));
  check_near(found.at("T1T2"), record.at("P"));
  check_near(found.at("T1_plus_T2"), record.at("S"));
  CHECK(found.at("stable") == record.at("stable"));
  CHECK(found.at("complex_poles") == record.at("complex_poles"));
}

TEST_CASE("indices of hull and rudder, and of coefficients, agree with the reference", "[app][published]") {
  check_record(document("indices " + parts_ship), golden().at("from_table1_record"));
  check_record(document("indices " + abc_ship), golden().at("printed_abc_record"));
}

TEST_CASE("indices splits hull and rudder as the reference does", "[app][published]") {
  const auto wanted = golden().at("from_table1");
  const auto parts = document("indices " + parts_ship).at("parts");
  check_near(parts.at("hull").at("a2"), wanted.at("a2H"));
  check_near(parts.at("rudder").at("b2"), wanted.at("b2R"));
  check_near(parts.at("rudder").at("c1"), wanted.at("c1"));
  check_near(parts.at("centrifugal").at("b1"), wanted.at("b1C"));
}

TEST_CASE("speed changes the numbers with dimension only", "[app]") {
  auto slow = document("indices " + nomoto_ship + " --speed 3.636"), fast = document("indices " + nomoto_ship);
  CHECK_THAT(slow.at("dimensional").at("T1_s").get<double>(), WithinRel(10.491 * 97.4 / 3.636, 1e-12));
  check_near(slow.at("dimensional").at("T3w_s"), 2.0 * fast.at("dimensional").at("T3w_s").get<double>());
  check_near(slow.at("dimensional").at("K_r_per_s"), 0.5 * fast.at("dimensional").at("K_r_per_s").get<double>());
  slow.erase("dimensional");
  fast.erase("dimensional");
  CHECK(slow == fast);
}

TEST_CASE("complex poles have no T1 and T2 but product and sum", "[app]") {
  const auto record = golden().at("degenerate_examples").at("complex_poles");
  const auto [code, found, err] = told(coefficients_form(-1.0, 0.5, -0.2, -2.0, -1.2, -1.0), "indices");
  REQUIRE(code == 0);
  CHECK(found.at("T1").is_null());
  CHECK(found.at("T2").is_null());
  CHECK(found.at("dimensional").at("T1_s").is_null());
  CHECK(found.at("complex_poles") == true);
  CHECK(found.at("stable") == true);
  check_near(found.at("T1T2"), record.at("P"));
  check_near(found.at("T1_plus_T2"), record.at("S"));
  check_near(found.at("Kw"), record.at("Kw"));
}

TEST_CASE("an unstable ship has a negative T1 and positive gains", "[app]") {
  const auto record = golden().at("degenerate_examples").at("unstable");
  const auto found = told(coefficients_form(-0.5, 0.5, -0.17, 4.0, -2.0, -1.4), "indices").document;
  check_record(found, record);
  CHECK(found.at("stable") == false);
}

TEST_CASE("infinite numbers of a neutral ship, or one without Kb, are null", "[app][limit]") {
  const auto neutral = told(coefficients_form(-0.5, 0.5, -0.2, 2.0, -2.0, -1.0), "indices").document;
  for (const char* key : {"T1", "T1T2", "T1_plus_T2", "Kb", "Kw", "T_b"}) CHECK(neutral.at(key).is_null());
  CHECK(neutral.at("T2").is_number());
  CHECK(neutral.at("stable") == false);
  const auto no_drift = told(coefficients_form(-1.0, 0.0, 0.0, 0.0, -0.1, -0.5), "indices").document;
  CHECK(no_drift.at("T3b").is_null());
  CHECK(no_drift.at("Kb") == 0.0);
  CHECK(no_drift.at("condition_number").is_null());
}

TEST_CASE("indices without coupled equations are told all the same", "[app][limit]") {
  const auto [code, found, err] = told(nomoto_form(0.5, 0.5, -3, -4), "indices");
  REQUIRE(code == 0);
  CHECK(found.at("a1").is_null());
  CHECK(found.at("T_w") == 10.3 - 0.5);
  CHECK(found.at("stable") == true);
}

TEST_CASE("indices prints a table with the verdict in words and the rudder's share", "[app]") {
  const Scratch scratch;
  const auto outcome = run(scratch, "indices " + parts_ship);
  CHECK(outcome.code == 0);
  CHECK_THAT(outcome.out, ContainsSubstring("The ship is course stable"));
  CHECK_THAT(outcome.out, ContainsSubstring("rudder share            23 %     -18 %"));
}

TEST_CASE("a nonlinear ship is linearized first, and that is said", "[app]") {
  const Scratch scratch;
  for (const auto& command : {"indices " + mmg_ship, "loop " + mmg_ship + " --zigzag 10/10"}) {
    const auto outcome = run(scratch, command + " --json");
    CHECK(outcome.code == 0);
    CHECK_THAT(outcome.err, ContainsSubstring("linearized about the straight course"));
  }
  CHECK_THAT(refusal("replay " + nomoto_ship + " run.csv --out o.csv"),
             ContainsSubstring("a ship of a nonlinear model is needed here, got \"linear\""));
}

// ---------------------------------------------------------------- invert

TEST_CASE("invert of the printed indices agrees with the reference", "[app][published]") {
  const auto found = document("invert " + nomoto_ship);
  const auto reference = golden();
  for (const auto& [key, value] : reference.at("printed_TK_to_abc").items())
    check_near(found.at("coefficients").at(key), value);
  CHECK(found.at("parts").is_null());
  CHECK(found.at("known").is_null());
  CHECK_THAT(found.at("elasticity").at("a1").at("T3w").get<double>(), WithinAbs(-1.09, 0.01));
  CHECK(found.at("warnings").empty());
}

TEST_CASE("invert down to hull and rudder agrees with the reference", "[app][published]") {
  const auto cases = golden().at("section7").at("from_printed_abc");
  const std::pair<const char*, const char*> keys[] = {{"a_H", "aH"},         {"c_Ry", "cRy"}, {"x_R_eff_prime", "xR"},
                                                      {"Y_b_per_deg", "Yb"}, {"Y_w", "Yw"},   {"N_b_per_deg", "Nb"},
                                                      {"N_w", "Nw"}};
  for (const auto& [known, name] : {std::pair{"Y_b", "Yb"}, std::pair{"N_w", "Nw"}, std::pair{"c_Ry", "cRy"}}) {
    const auto found = document("invert " + abc_ship + " --parts " + parts_ship + " --known " + known);
    CHECK(found.at("known") == known);
    for (const auto& [key, golden_key] : keys) check_near(found.at("parts").at(key), cases.at(name).at(golden_key));
    CHECK(found.at("elasticity").at("Y_w").at("known").is_number());
    CHECK(found.at("condition").at("best_known") == "Y_w");
  }
}

TEST_CASE("a ship of hull and rudder is her own source of the other numbers", "[app][round-trip]") {
  const auto found = document("invert " + parts_ship);
  CHECK(found.at("known") == "c_Ry");
  check_near(found.at("parts").at("a_H"), 0.6);
  check_near(found.at("parts").at("Y_w"), 0.026);
  check_near(found.at("parts").at("N_w"), -0.063);
}

TEST_CASE("T3b near T3w is warned of, equal is refused, in words", "[app][refusal]") {
  const auto near = told(nomoto_form(0.5, 0.51, -3, -4), "invert");
  CHECK(near.code == 0);
  CHECK_THAT(near.err, ContainsSubstring("near each other"));
  CHECK_THAT(near.err, ContainsSubstring("cannot be told apart"));
  CHECK(near.document.at("warnings").size() == 2);
  const auto equal = told(nomoto_form(0.5, 0.5, -3, -4), "invert");
  CHECK(equal.code == 1);
  CHECK_THAT(equal.err, ContainsSubstring("T3b and T3w are both 0.5"));
  CHECK_THAT(told(nomoto_form(0.5, 0.8, 0, -4), "invert").err, ContainsSubstring("Kb is 0"));
  CHECK_THAT(refusal("invert " + nomoto_ship + " --known Y_b"), ContainsSubstring("--parts"));
  CHECK_THAT(refusal("invert " + nomoto_ship + " --parts " + abc_ship), ContainsSubstring("has no [hull]"));
}

// ---------------------------------------------------------------- loop

TEST_CASE("the zigzag of the loop agrees with the reference, the loop with its ninth cycle", "[app][published]") {
  const auto wanted = golden().at("figure_numbers_printed_TK").at("REF");
  const auto found = document("loop " + nomoto_ship + " --zigzag 10/10 --first port " + reference_speed);
  REQUIRE(found.at("overshoot_deg").size() == 6);
  for (std::size_t k = 0; k < 6; ++k) check_near(found.at("overshoot_deg")[k], wanted.at("overshoot_deg")[k], 1e-9);
  const auto& limit = wanted.at("limit_loop");
  check_near(found.at("area"), limit.at("area_rad"), 2e-3);
  check_near(found.at("omega_max"), limit.at("omega_max"), 2e-3);
  check_near(found.at("omega_at_beta_zero"), limit.at("omega_at_beta0"), 2e-3);
  CHECK(found.at("settled") == true);
  for (const char* key : {"length", "width", "inclination_rad", "beta_max_rad", "beta_at_omega_zero_rad",
                          "distance_from_line", "period", "limit_overshoot_deg"})
    CHECK(found.at(key).is_number());
}

TEST_CASE("T3b moves the loop and leaves the yaw as it is", "[app]") {
  const auto found = document("loop " + nomoto_ship + " --zigzag 10/10");
  const auto& by_T3b = found.at("sensitivity").at("T3b");
  CHECK(by_T3b.at("area").get<double>() < -0.01);
  CHECK_THAT(by_T3b.at("omega_max").get<double>(), WithinAbs(0.0, 1e-12));
  for (const auto& x : by_T3b.at("overshoot_deg")) CHECK_THAT(x.get<double>(), WithinAbs(0.0, 1e-10));
  CHECK(found.at("sensitivity").at("T3w").at("overshoot_deg")[0].get<double>() < -1.0);
}

TEST_CASE("sensitivities of the loop are differences between ships", "[app][second-route]") {
  const auto area = [](double T3w) {
    return told(nomoto_form(0.15, T3w, -3, -4), "loop", "--zigzag 20/10").document.at("area").get<double>();
  };
  const auto found = told(nomoto_form(0.15, 0.98, -3, -4), "loop", "--zigzag 20/10").document;
  CHECK_THAT(found.at("sensitivity").at("T3w").at("area").get<double>(),
             WithinRel((area(0.9801) - area(0.9799)) / 0.0002, 1e-5));
}

TEST_CASE("a ship without inverse has a loop without sensitivities, said in words", "[app][limit]") {
  for (const auto& form :
       {coefficients_form(-1.0, 0.0, 0.0, 0.0, -0.1, -0.5), coefficients_form(-0.5, 0.5, -0.2, 2.0, -2.0, -1.0)}) {
    const auto [code, found, err] = told(form, "loop", "--zigzag 10/10");
    REQUIRE(code == 0);
    CHECK(found.at("sensitivity").is_null());
    CHECK(found.at("area").is_number());
    CHECK_THAT(err, ContainsSubstring("no sensitivities"));
  }
}

TEST_CASE("with T3b = T3w the loop is a line, and the yaw as with any T3b", "[app][limit]") {
  const auto line = told(nomoto_form(0.98, 0.98, -3, -4), "loop", "--zigzag 10/10"),
             loop = told(nomoto_form(0.15, 0.98, -3, -4), "loop", "--zigzag 10/10");
  REQUIRE(line.code == 0);
  CHECK_THAT(line.err, ContainsSubstring("the loop is a line"));
  CHECK(line.document.at("area") == 0.0);
  CHECK(line.document.at("sensitivity").is_null());
  check_near(line.document.at("omega_max"), loop.document.at("omega_max"));
  check_near(line.document.at("beta_max_rad"), 0.75 * line.document.at("omega_max").get<double>());
  for (std::size_t k = 0; k < 6; ++k)
    check_near(line.document.at("overshoot_deg")[k], loop.document.at("overshoot_deg")[k]);
  const auto zigzag = told(nomoto_form(0.98, 0.98, -3, -4), "simulate", "--zigzag 10/10");
  check_near(zigzag.document.at("overshoot_deg")[0], line.document.at("overshoot_deg")[0]);
  CHECK(told(nomoto_form(0.98, 0.98, -3, -4), "simulate", "--zigzag 10/10 --out /dev/null").code == 1);
}

TEST_CASE("a zigzag without a cycle has no loop", "[app][refusal]") {
  const auto unstable = told(coefficients_form(-0.5, 0.5, -0.17, 4.0, -2.0, -1.4), "loop", "--zigzag 10/10");
  CHECK(unstable.code == 1);
  CHECK_THAT(unstable.err, ContainsSubstring("a loop needs 3 (the ship is course unstable"));
  CHECK_THAT(refusal("loop " + nomoto_ship + " --zigzag 40/10"), ContainsSubstring("beyond the ship's largest"));
  CHECK_THAT(refusal("loop " + nomoto_ship + " --zigzag 10/0"), ContainsSubstring("heading angle"));
}

// ---------------------------------------------------------------- simulate

TEST_CASE("simulate sails the exact zigzag of a linear ship", "[app][published]") {
  const auto wanted = golden().at("zigzag_exact").at("REF_printed_abc_rate2.5");
  const auto found = document("simulate " + abc_ship + " --zigzag 10/10 --first port " + reference_speed);
  CHECK(found.at("manoeuvre") == "zigzag 10/10");
  CHECK(found.at("first") == "port");
  CHECK(found.at("rev_s").is_null());
  CHECK(found.at("execute_s").front() == 0.0);
  REQUIRE(found.at("execute_s").size() == 5);
  REQUIRE(found.at("overshoot_deg").size() == 4);
  for (std::size_t k = 0; k < 4; ++k) {
    check_near(found.at("overshoot_deg")[k], wanted.at("overshoot_deg")[k]);
    check_near(found.at("execute_s")[k + 1], wanted.at("execute_s")[k].get<double>() * 13.39);
    check_near(found.at("peak_s")[k], wanted.at("peak_s")[k].get<double>() * 13.39);
  }
  check_near(found.at("period_s"),
             (wanted.at("execute_s")[3].get<double>() - wanted.at("execute_s")[1].get<double>()) * 13.39);
}

TEST_CASE("the time series of a linear zigzag is a recording", "[app][round-trip]") {
  const Scratch scratch;
  const auto file = (scratch / "run.csv").string();
  for (const std::string& command :
       {"simulate " + abc_ship + " --zigzag 10/10", "loop " + abc_ship + " --zigzag 10/10"}) {
    REQUIRE(run(scratch, command + " --out " + file).code == 0);
    const auto recording = read_recording(file).recording;
    CHECK(recording.facts.manoeuvre == "zigzag 10/10 first starboard");
    CHECK(recording.has(Channel::x));
    CHECK(recording.samples() > 1000);
    CHECK(*std::ranges::max_element(recording[Channel::delta]) == radians(10));
  }
}

TEST_CASE("a duration ends the zigzag of a linear ship, with its last order unanswered", "[app]") {
  const auto whole = document("simulate " + abc_ship + " --zigzag 10/10");
  const auto until = 0.5 * (whole.at("execute_s")[3].get<double>() + whole.at("peak_s")[2].get<double>());
  const auto part = document("simulate " + abc_ship + " --zigzag 10/10 --duration " + std::to_string(until));
  CHECK(part.at("execute_s").size() == 4);
  CHECK(part.at("overshoot_deg").size() == 2);
}

TEST_CASE("the turn of a stable linear ship is told by its steady values", "[app]") {
  const auto found = document("simulate " + nomoto_ship + " --turn 20");
  CHECK_THAT(found.at("final_drift_rad").get<double>(), WithinRel(3.464 * radians(20), 1e-12));
  CHECK_THAT(found.at("final_yaw_rate_rad_s").get<double>(), WithinRel(4.896 * radians(20) * 7.272 / 97.4, 1e-12));
  CHECK_THAT(found.at("final_diameter_m").get<double>(), WithinRel(2.0 * 97.4 / (4.896 * radians(20)), 1e-12));
  CHECK(found.at("advance_m").is_null());
  const auto unstable = told(coefficients_form(-0.5, 0.5, -0.17, 4.0, -2.0, -1.4), "simulate", "--turn 20");
  CHECK(unstable.code == 1);
  CHECK_THAT(unstable.err, ContainsSubstring("course unstable"));
}

TEST_CASE("invert tells how sure the coefficients of uncertain indices are", "[app][linear]") {
  const Scratch scratch;
  auto text = read_text(test::ships / "tanker97_nomoto.toml");
  const auto uncertainty_with = [&](const std::string& confidence) {
    write_text(scratch / "ship.toml", text + "\n[confidence]\n" + confidence + "\n");
    const auto outcome = run(scratch, "invert " + (scratch / "ship.toml").string() + " --json");
    REQUIRE(outcome.code == 0);
    return test::json_of(outcome.out).at("uncertainty");
  };
  const auto sure = uncertainty_with("coefficients = 0.01"), unsure = uncertainty_with("coefficients = 0.02");
  CHECK_THAT(unsure.at("standard_error").at("a1").get<double>(),
             WithinRel(2.0 * sure.at("standard_error").at("a1").get<double>(), 1e-9));
  CHECK(sure.at("interval_95").at("b1")[0] < sure.at("interval_95").at("b1")[1]);
  CHECK(uncertainty_with("T3b = 6.0").at("separation") < 1.0);
  CHECK(document("invert " + abc_ship).at("uncertainty").is_null());
}

}  // namespace
}  // namespace swayaw
