// The curves of figures 1 to 9 of Artyszuk 2016: a 10/10 zigzag of the linear model, exact and by the paper's Euler
// method, beside first-order ships with a step and a ramp of the rudder. One CSV file for each figure.
//   example_linear_figures FOLDER
#include <fmt/format.h>
#include <fmt/os.h>

#include <string>
#include <vector>

#include "swayaw/core/angle.hpp"
#include "swayaw/linear/euler_zigzag.hpp"
#include "swayaw/linear/indices.hpp"
#include "swayaw/linear/rudder_history.hpp"

namespace {

using namespace swayaw;

constexpr double length_s = 13.39;  // time to sail a length, table 1
constexpr double until = 25.0;      // ship lengths drawn
constexpr double first_order_until = 6.0;

/// Table 3 as printed, with other T3b and T3w.
SteeringIndices<double> indices(double T3b = 0.154, double T3w = 0.983) {
  return {.T1T2 = 10.491 * 0.298, .T1_plus_T2 = 10.491 + 0.298, .T3b = T3b, .T3w = T3w, .Kb = -3.464, .Kw = -4.896};
}

/// 10/10 zigzag, first to starboard: drift and yaw rate begin positive, the rudder angle negative.
LinearZigzagOrder ten_ten(double rate_deg_s, double longest) {
  return {.rudder = radians(10),
          .heading = radians(10),
          .rate = radians(rate_deg_s) * length_s,
          .reversals = 1000,
          .longest = longest};
}

struct Sample {
  double s, delta;
  LinearState<double> x;
};

struct Curve {
  std::string name;
  SwayYawCoefficients<double> ship;
  std::vector<Sample> samples;
};

Curve sampled(std::string name, const SwayYawCoefficients<double>& m, const std::vector<Leg<double>>& legs,
              double end) {
  const LinearResponse<double> ship(m);
  Curve curve{std::move(name), m, {}};
  for (int i = 0; i <= 1250; ++i) {
    const double s = end * i / 1250;
    curve.samples.push_back({s, rudder_at(legs, s), state_at(ship, legs, s)});
  }
  return curve;
}

Curve exact(const std::string& name, const SteeringIndices<double>& i, double rate_deg_s = 2.5) {
  const auto ship = coefficients_from(i);
  return sampled(name + ", exact", ship, linear_zigzag(ship, ten_ten(rate_deg_s, until)).legs, until);
}

Curve euler(const std::string& name, const SteeringIndices<double>& i, double rate_deg_s = 2.5) {
  Curve curve{name + ", Euler", coefficients_from(i), {}};
  for (const auto& step : euler_zigzag(curve.ship, ten_ten(rate_deg_s, until)).steps)
    curve.samples.push_back({step.s, step.delta, step.state});
  return curve;
}

/// First-order drift and yaw, eqs (41) and (42), the first rudder order never taken back.
Curve first_order(const std::string& name, const RudderHistory& history) {
  const auto drift = first_order_drift(indices()), yaw = first_order_yaw(indices());
  const SwayYawCoefficients<double> ship{-1.0 / drift.T, 0.0, drift.K / drift.T, 0.0, -1.0 / yaw.T, yaw.K / yaw.T};
  return sampled(name, ship, legs(LinearResponse<double>(ship), history, first_order_until), first_order_until);
}

void write(const std::string& file, const std::vector<Curve>& curves) {
  auto out = fmt::output_file(file);
  out.print("curve,s,psi_deg,delta_deg,beta_deg,omega,dbeta_ds_deg,domega_ds\n");
  for (const auto& curve : curves)
    for (const auto& [s, delta, x] : curve.samples) {
      const auto d = rates(curve.ship, x, delta);
      out.print("\"{}\",{:.6g},{:.8g},{:.8g},{:.8g},{:.8g},{:.8g},{:.8g}\n", curve.name, s, degrees(x.psi),
                degrees(delta), degrees(x.beta), x.omega, degrees(d.beta), d.omega);
    }
}

}  // namespace

int main(int, char** arguments) {
  const std::string folder = arguments[1];
  const auto ref = indices(), T3b = indices(0.309), T3w = indices(0.154, 0.492), large_T3w = indices(0.154, 1.966);
  const auto both = [](const std::string& name, const SteeringIndices<double>& i, double rate = 2.5) {
    return std::vector{exact(name, i, rate), euler(name, i, rate)};
  };
  const auto together = [](std::vector<Curve> a, const std::vector<Curve>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  };
  const double delta = -radians(10), rate = radians(2.5) * length_s;
  const std::vector step_and_ramp{first_order("1st ORD, delta = const", rudder_step(delta)),
                                  first_order("1st ORD, delta = var", rudder_ramp_and_hold(delta, rate))};
  const std::vector slow_step_and_ramp{step_and_ramp[0],
                                       first_order("1st ORD, delta = var", rudder_ramp_and_hold(delta, rate / 5.0))};

  write(folder + "/figure_1.csv", together(both("REF", ref), both("T3w = 0.492", T3w)));
  write(folder + "/figure_2.csv", both("REF", ref));
  write(folder + "/figure_3.csv", together(together(both("REF", ref), both("T3b = 0.309", T3b)), step_and_ramp));
  write(folder + "/figure_4.csv", together(together(both("REF", ref), both("T3w = 0.492", T3w)), step_and_ramp));
  write(folder + "/figure_5.csv", together(both("REF", ref), step_and_ramp));
  write(folder + "/figure_6.csv", together(both("0.5 deg/s", ref, 0.5), slow_step_and_ramp));
  write(folder + "/figure_7.csv", together(both("2.5 deg/s", ref), both("0.5 deg/s", ref, 0.5)));
  write(folder + "/figure_8.csv",
        together(together(both("REF", ref), together(both("T3b = 0.309", T3b), both("T3w = 0.492", T3w))),
                 step_and_ramp));
  write(folder + "/figure_9.csv",
        together(both("REF", ref), together(both("T3w = 0.492", T3w), both("T3w = 1.966", large_T3w))));

  const auto by_root = linear_zigzag(coefficients_from(ref), ten_ten(2.5, until)).reversals,
             by_step = euler_zigzag(coefficients_from(ref), ten_ten(2.5, until)).reversals;
  for (std::size_t i = 0; i < 3; ++i)
    fmt::print("overshoot {}: exact {:.2f} deg, by Euler's method {:.2f} deg\n", i + 1, degrees(by_root[i].overshoot),
               degrees(by_step[i].overshoot));
}
