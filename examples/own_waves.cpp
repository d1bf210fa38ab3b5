// A simulator with waves of its own: a ship at 50 Hz steered by an autopilot through an irregular sea, whose
// first-order forces are handed to her at each step.
//
// The waves are those of a deep, long-crested sea; their force is that of the undisturbed pressure on a box of the
// ship's length, beam and draught (Froude–Krylov), which a simulator replaces by its own tables. Mean second-order
// forces are an effect of the ship file, wave_drift (docs/effects.md).
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "swayaw/core/angle.hpp"
#include "swayaw/nonlinear/ship_file.hpp"
#include "swayaw/nonlinear/simulator.hpp"

namespace {

using namespace swayaw;

constexpr double g = 9.81;  // [m/s²]

struct Wave {
  double amplitude;  ///< [m]
  double omega;      ///< [rad/s]
  double phase;      ///< [rad]
};

/// S(ω) = 5/16 H² ω_p⁴ ω⁻⁵ exp(−5/4 (ω_p/ω)⁴), the spectrum of Bretschneider [m² s].
double bretschneider(double height, double peak, double omega) {
  const double ratio = std::pow(peak / omega, 4);
  return 5.0 / 16.0 * height * height * ratio / omega * std::exp(-1.25 * ratio);
}

/// Waves whose amplitudes a = sqrt(2 S dω) make up the spectrum between 0.5 and 3 ω_p; frequencies are drawn within
/// their bands, so that the sea does not repeat itself.
std::vector<Wave> sea_of(double height, double period, unsigned seed) {
  std::mt19937_64 engine(seed);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  constexpr int bands = 60;
  const double peak = 2.0 * std::numbers::pi / period, width = 2.5 * peak / bands;
  std::vector<Wave> sea;
  for (int i = 0; i < bands; ++i) {
    const double omega = 0.5 * peak + (i + share(engine)) * width;
    sea.push_back(
        {std::sqrt(2.0 * bretschneider(height, peak, omega) * width), omega, 2.0 * std::numbers::pi * share(engine)});
  }
  return sea;
}

double sinc(double x) { return x == 0.0 ? 1.0 : std::sin(x) / x; }

/// ∫ x sin(κ x) dx over a length l about 0.
double first_moment(double kappa, double l) {
  const double x = 0.5 * kappa * l;
  if (std::abs(x) < 1e-4) return kappa * l * l * l / 12.0;
  return 2.0 * (std::sin(x) - x * std::cos(x)) / (kappa * kappa);
}

struct Box {
  double L, B, d, rho;
};

/// Force of a wave that runs to `to`, from p = ρ g a e^{kz} cos θ with θ = k (x cos to + y sin to) − ω t + phase over
/// the earth. With κ = k cos μ along and σ = k sin μ across the ship, μ = to − psi, and the depth factor D = (1 −
/// e^{−kd})/k, −∫ ∇p dV is
///
///     X = ρ g a κ D L B sinc(κL/2) sinc(σB/2) sin θ,   Y alike with σ
///     N = ρ g a D cos θ (σ B sinc(σB/2) ∫x sin κx dx − κ L sinc(κL/2) ∫y sin σy dy)
PlanarForce<double> force_of(const Wave& wave, double to, const Box& box, const ShipState<double>& s, double time) {
  const double k = wave.omega * wave.omega / g, mu = to - s.psi;
  const double kappa = k * std::cos(mu), sigma = k * std::sin(mu);
  const double theta = k * (s.x * std::cos(to) + s.y * std::sin(to)) - wave.omega * time + wave.phase;
  const double pressure = box.rho * g * wave.amplitude * (1.0 - std::exp(-k * box.d)) / k;
  const double along = box.L * sinc(0.5 * kappa * box.L), across = box.B * sinc(0.5 * sigma * box.B);
  const double moment = sigma * across * first_moment(kappa, box.L) - kappa * along * first_moment(sigma, box.B);
  const double both = pressure * along * across * std::sin(theta);
  return {.X = kappa * both, .Y = sigma * both, .N = pressure * moment * std::cos(theta)};
}

/// Mean square of what is added.
struct Spread {
  double sum = 0.0;
  int count = 0;
  void add(double x) { sum += x * x, ++count; }
  double deviation() const { return std::sqrt(sum / count); }
};

}  // namespace

int main(int, char** arguments) {
  const Ship ship = read_ship(arguments[1]);
  const auto& model = std::get<MmgShip<double>>(ship.model);
  const auto& p = model.particulars;
  const Box box{.L = p.L, .B = p.B, .d = p.d, .rho = model.water.rho};
  const double height = 4.0, period = 11.0, step = 0.02;
  const auto sea = sea_of(height, period, 1);

  fmt::print("a sea of {} m and {} s\n", height, period);
  for (const double to_deg : {0.0, 45.0, 90.0, 135.0, 180.0}) {
    Simulator simulator(ship);
    Spread surface, yaw_rate, heading, rudder;
    while (simulator.time() < 900.0) {
      const auto& s = simulator.state();
      PlanarForce<double> force{0.0, 0.0, 0.0};
      for (const auto& wave : sea) force = force + force_of(wave, radians(to_deg), box, s, simulator.time());
      simulator.set_added_force(force);
      // an autopilot that keeps heading 0: the rudder to port, positive, against a heading to starboard
      simulator.order_rudder(1.0 * s.psi + 0.5 * p.L / p.U_0 * s.motion.r);
      simulator.step(step);

      double elevation = 0.0;  // at a buoy
      for (const auto& wave : sea) elevation += wave.amplitude * std::cos(wave.phase - wave.omega * simulator.time());
      surface.add(elevation), yaw_rate.add(s.motion.r), heading.add(s.psi), rudder.add(simulator.rudder());
    }
    fmt::print(
        "waves that run to {:3.0f} deg: four deviations of the surface {:.2f} m   yaw rate {:.4f} deg/s   heading "
        "{:.2f} "
        "deg   rudder {:.2f} deg   {:.0f} m in 900 s\n",
        to_deg, 4.0 * surface.deviation(), degrees(yaw_rate.deviation()), degrees(heading.deviation()),
        degrees(rudder.deviation()), simulator.state().x);
  }
}
