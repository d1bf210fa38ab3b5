#include <catch.hpp>
#include <nlohmann/json.hpp>

#include "files.hpp"
#include "json.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/recording.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/ship_file.hpp"

/// Manoeuvres of the KVLCC2 computed by two independent programs at a tolerance of 1e-12.
namespace swayaw {
namespace {

using nlohmann::json;

json reference_cases() { return test::json_in(test::golden / "mmg_manoeuvres.json").at("cases"); }

json reference_case(const std::string& manoeuvre) {
  for (const auto& c : reference_cases())
    if (c.at("manoeuvre") == manoeuvre) return c;
  throw std::runtime_error("no reference case " + manoeuvre);
}

Ship ship_of(const json& reference) {
  return read_ship(test::ships / (reference.at("ship").get<std::string>() + ".toml"));
}

Side first_of(const json& reference) { return reference.at("first") == "port" ? Side::port : Side::starboard; }

/// The states of the reference are 1e-6 of the largest value of each quantity along the run.
void check_states(const Recording& run, const json& reference) {
  const std::pair<Channel, const char*> columns[] = {{Channel::x, "x_m"},       {Channel::y, "y_m"},
                                                     {Channel::psi, "psi_rad"}, {Channel::u, "u_m_s"},
                                                     {Channel::v, "v_m_s"},     {Channel::r, "r_rad_s"}};
  for (const auto& state : reference.at("states")) {
    const double time = state.at("time_s");
    const auto at = std::ranges::lower_bound(run.time, time - 1e-9) - run.time.begin();
    REQUIRE_THAT(run.time.at(static_cast<std::size_t>(at)), WithinAbs(time, 1e-9));
    for (const auto& [channel, name] : columns) {
      INFO(name << " at " << time << " s");
      CHECK_THAT(run[channel][static_cast<std::size_t>(at)], WithinRel(state.at(name).get<double>(), 1e-6));
    }
  }
}

void check_zigzag(const std::string& name, const ZigzagOrder& angles) {
  const json reference = reference_case(name);
  const Ship ship = ship_of(reference);
  const double end = reference.at("states").back().at("time_s");
  const auto result =
      zigzag(ship, angles, {.speed = reference.at("approach_speed_m_s"), .duration = end, .step = end / 200.0});
  CHECK_THAT(result.propulsion.rev, WithinRel(reference.at("self_propulsion_rev_s").get<double>(), 1e-12));
  check_states(result.run, reference);
  const auto& overshoots = reference.at("overshoots");
  REQUIRE(result.reversals.size() >= overshoots.size());
  for (std::size_t i = 0; i < overshoots.size(); ++i) {
    INFO("reversal " << i + 1);
    CHECK_THAT(result.reversals[i].time, WithinAbs(overshoots[i].at("execute_s").get<double>(), 1e-4));
    CHECK_THAT(result.reversals[i].peak_time.value(), WithinAbs(overshoots[i].at("peak_s").get<double>(), 1e-4));
    CHECK_THAT(degrees(result.reversals[i].overshoot.value()),
               WithinAbs(overshoots[i].at("overshoot_deg").get<double>(), 1e-3));
  }
}

TEST_CASE("20/20 zigzag of the KVLCC2 model agrees with the reference", "[nonlinear][published]") {
  check_zigzag("zigzag 20/20", {.rudder = radians(20), .heading = radians(20), .first = Side::starboard});
}

TEST_CASE("10/10 zigzag of the full-scale KVLCC2 agrees with the reference", "[nonlinear][published]") {
  check_zigzag("zigzag 10/10", {.rudder = radians(10), .heading = radians(10), .first = Side::port});
}

TEST_CASE("35 deg turn of the KVLCC2 model agrees with the reference", "[nonlinear][published]") {
  const json reference = reference_case("turn 35");
  const Ship ship = ship_of(reference);
  const double L = length(ship);
  const auto circle =
      turning_circle(ship, {.rudder = radians(35), .side = first_of(reference)}, {.duration = 400.0, .step = 1.0});
  check_states(circle.run, reference);
  CHECK_THAT(circle.advance.value() / L, WithinAbs(reference.at("advance_L").get<double>(), 1e-5));
  CHECK_THAT(circle.transfer.value() / L, WithinAbs(reference.at("transfer_L").get<double>(), 1e-5));
  CHECK_THAT(circle.time_90.value(), WithinAbs(reference.at("time_90_s").get<double>(), 1e-4));
  CHECK_THAT(circle.tactical_diameter.value() / L, WithinAbs(reference.at("tactical_diameter_L").get<double>(), 1e-5));
  CHECK_THAT(circle.time_180.value(), WithinAbs(reference.at("time_180_s").get<double>(), 1e-4));
  CHECK_THAT(circle.final_diameter.value() / L,
             WithinAbs(reference.at("final_turning_diameter_L").get<double>(), 1e-5));
}

}  // namespace
}  // namespace swayaw
