#include <algorithm>
#include <catch.hpp>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "files.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/linear/indices.hpp"
#include "swayaw/linear/zigzag.hpp"

/// The numbers of the reference that no other test looks at.
namespace swayaw {
namespace {

using nlohmann::json;

json reference() {
  std::ifstream file(test::golden / "artyszuk_linear.json");
  return json::parse(file).at("artyszuk");
}

SteeringIndices<double> printed(double T3b = 0.154, double T3w = 0.983) { return {10.491 * 0.298, 10.491 + 0.298, T3b, T3w, -3.464, -4.896}; }

LinearZigzagOrder ten_ten(double rate_deg_s) { return {.rudder = radians(10), .heading = radians(10), .rate = radians(rate_deg_s) * 13.39, .first = Side::port}; }

/// Largest |f| on a leg: samples, then golden sections around the largest.
template <class F>
double largest_on(const Leg<double>& leg, F&& f) {
  constexpr int points = 400;
  int best = 0;
  for (int k = 1; k <= points; ++k)
    if (std::abs(f(leg.length * k / points)) > std::abs(f(leg.length * best / points))) best = k;
  double low = leg.length * std::max(0, best - 1) / points, high = leg.length * std::min(points, best + 1) / points;
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  for (int i = 0; i < 80; ++i) {
    const double a = high - golden * (high - low), b = low + golden * (high - low);
    (std::abs(f(a)) > std::abs(f(b)) ? high : low) = std::abs(f(a)) > std::abs(f(b)) ? b : a;
  }
  return std::max({std::abs(f(0.5 * (low + high))), std::abs(f(0.0)), std::abs(f(leg.length))});
}

/// Largest rates of drift and yaw over the legs before one of them.
struct LargestRates {
  double beta = 0.0;
  double omega = 0.0;
};

LargestRates largest_rates(const SwayYawCoefficients<double>& m, const LinearZigzag<double>& zigzag, std::size_t legs) {
  const LinearResponse<double> ship(m);
  LargestRates largest;
  for (std::size_t i = 0; i < legs; ++i) {
    const auto& leg = zigzag.legs[i];
    const auto rate = [&](double s) { return rates(m, state_after(ship, leg.start, leg.rudder, s), leg.rudder.value + leg.rudder.rate * s); };
    largest.beta = std::max(largest.beta, largest_on(leg, [&](double s) { return rate(s).beta; }));
    largest.omega = std::max(largest.omega, largest_on(leg, [&](double s) { return rate(s).omega; }));
  }
  return largest;
}

TEST_CASE("every reversal, peak and state of the figures agrees with the reference to 1e-9", "[linear][published]") {
  const auto figures = reference().at("figure_numbers_printed_TK");
  const std::tuple<const char*, SteeringIndices<double>, double> cases[] = {
      {"REF", printed(), 2.5},           {"T3b=0.309", printed(0.309), 2.5},    {"T3w=0.492", printed(0.154, 0.492), 2.5},
      {"T3w=1.966", printed(0.154, 1.966), 2.5}, {"T3w=3", printed(0.154, 3.0), 2.5}, {"T3w=5", printed(0.154, 5.0), 2.5},
      {"REF rate0.5", printed(), 0.5},   {"T3w=0.492 rate0.5", printed(0.154, 0.492), 0.5}};
  for (const auto& [name, indices, rate] : cases) {
    INFO(name);
    const auto& wanted = figures.at(name);
    const auto m = coefficients_from(indices);
    const auto zigzag = linear_zigzag(m, ten_ten(rate));
    for (std::size_t k = 0; k < 6; ++k) {
      CHECK_THAT(zigzag.reversals[k].execute, WithinRel(wanted.at("execute_s")[k].get<double>(), 1e-9));
      CHECK_THAT(zigzag.reversals[k].peak, WithinRel(wanted.at("peak_s")[k].get<double>(), 1e-9));
      CHECK_THAT(degrees(zigzag.reversals[k].overshoot), WithinRel(wanted.at("overshoot_deg")[k].get<double>(), 1e-9));
    }
    CHECK_THAT(zigzag.reversals.front().execute, WithinRel(wanted.at("reach_s").get<double>(), 1e-9));
    const auto& first = zigzag.legs[zigzag.reversals.front().leg].start;
    CHECK_THAT(std::abs(degrees(first.beta)), WithinRel(std::abs(wanted.at("beta_at_exec1_deg").get<double>()), 1e-9));
    CHECK_THAT(std::abs(first.omega), WithinRel(std::abs(wanted.at("omega_at_exec1").get<double>()), 1e-9));
    // the reference took the largest rates from samples
    const auto rates_first = largest_rates(m, zigzag, zigzag.reversals.front().leg);
    CHECK_THAT(degrees(rates_first.beta), WithinRel(wanted.at("max_dbeta_ds_deg_firstleg").get<double>(), 1e-6));
    CHECK_THAT(rates_first.omega, WithinRel(wanted.at("max_domega_ds_firstleg").get<double>(), 1e-6));
  }
}

}  // namespace
}  // namespace swayaw
