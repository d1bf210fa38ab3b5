#include "linear_output.hpp"

#include <fmt/format.h>

#include "input.hpp"
#include "swayaw/core/rounding.hpp"
#include "swayaw/linear/linear_recording.hpp"

namespace swayaw::app {

Json coefficients_json(const SwayYawCoefficients<double>& m) {
  Json json = Json::object();
  for (const auto& p : m.parameters()) json[std::string(p.key)] = number(m.*p.member);
  return json;
}

std::string cell(double value) { return std::isfinite(value) ? fmt::format("{:.5g}", value + 0.0) : "-"; }

std::string stability_words(const SwayYawTransfer<double>& h) {
  const bool swings = h.e1 * h.e1 < 4.0 * h.e0;
  if (h.e0 > 0.0 && h.e1 > 0.0)
    return swings ? "course stable: a disturbance dies out in swings" : "course stable: a disturbance dies out";
  if (h.e0 == 0.0 && h.e1 > 0.0) return "neutral: a disturbance neither dies out nor grows";
  return swings ? "course unstable: a disturbance grows in swings" : "course unstable: a disturbance grows";
}

void tell_drift(Page& page, double drift, const UserUnits& units) {
  const bool beyond = std::abs(drift) > largest_linear_drift;
  const auto reached = units.angle(std::abs(drift));
  page.answers.push_back(
      {"Do linear equations hold?", fmt::format("{}: her drift angle reaches {}, and beyond {} they mean nothing",
                                                beyond ? "No" : "Yes", reached, units.ordered(largest_linear_drift))});
  if (!beyond) return;
  page.tone = Tone::look;
  page.headline += fmt::format(" At her drift angle of {} linear equations mean nothing.", reached);
}

std::string_view form_words(const LinearShip& ship) {
  constexpr std::string_view words[] = {"hull and rudder", "coefficients", "indices"};
  return words[ship.form.index()];
}

double speed_of(const LinearShip& ship, const std::optional<double>& asked) {
  return asked.value_or(ship.particulars.U_0);
}

LinearZigzagOrder linear_order(const LinearShip& ship, const std::string& zigzag, const std::string& first,
                               double speed) {
  const auto [rudder, heading] = zigzag_angles(zigzag);
  require_rudder(rudder, ship.steering_gear);
  require_positive(heading, "heading angle [rad]");
  return {.rudder = rudder,
          .heading = heading,
          .rate = ship.steering_gear.rate * ship.particulars.L / speed,
          .first = side_named(first)};
}

Recording zigzag_recording(const LinearShip& ship, const LinearZigzag<double>& zigzag, const LinearZigzagOrder& order,
                           double speed, const std::optional<double>& step) {
  const auto scale = prime_scale(ship, speed);
  auto run = recording_of(coefficients(ship), zigzag.legs, scale, step.value_or(round_down(0.02 * scale.L / scale.U)));
  run.name = ship.name;
  run.facts.execute = 0.0;
  run.facts.manoeuvre =
      fmt::format("{} first {}", name_of(ZigzagAngles{order.rudder, order.heading}), name_of(order.first));
  return run;
}

}  // namespace swayaw::app
