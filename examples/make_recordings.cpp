// Makes the example recordings: a KVLCC2 model whose rudder is weaker and whose hull is rougher than its ship file
// says, measured with noise at the resolution of a towing tank.
#include <cmath>
#include <filesystem>
#include <random>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/recording_csv.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/ship_file.hpp"

namespace {

using namespace swayaw;

/// The ship that was really sailed.
Ship weak_rudder(Ship ship) {
  auto& model = std::get<MmgShip<double>>(ship.model);
  model.rudder.f_alpha *= 0.82;
  model.hull.R_0 *= 1.05;
  return ship;
}

/// Deviation of the noise and resolution of an instrument.
struct Instrument {
  Channel channel;
  double noise;
  double resolution;
};

constexpr Instrument instruments[] = {
    {Channel::x, 0.004, 1e-4},
    {Channel::y, 0.004, 1e-4},
    {Channel::psi, radians(0.03), 1e-6},
    {Channel::u, 0.003, 1e-5},
    {Channel::v, 0.003, 1e-5},
    {Channel::r, radians(0.04), 1e-7},
    {Channel::delta, radians(0.05), 1e-6},
    {Channel::rev, 0.005, 1e-4},
};

Recording measured(const Recording& truth, unsigned seed) {
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal;
  Recording run;
  run.facts = truth.facts;
  run.facts.remarks = {
      {"source",
       "\"simulated; the rudder is 18 % weaker and the resistance 5 % larger than in ships/kvlcc2_l7.toml\""}};
  for (const double time : truth.time) run.time.push_back(std::round(time * 1e3) / 1e3);
  for (const auto& [channel, noise, resolution] : instruments) {
    auto column = run.fill(channel);
    const double steps = 1.0 / resolution;
    for (std::size_t i = 0; i < column.size(); ++i)
      column[i] = std::round((truth[channel][i] + noise * normal(engine)) * steps) / steps;
  }
  return run;
}

}  // namespace

int main(int, char** arguments) {
  const Ship ship = weak_rudder(read_ship(arguments[1]));
  const std::filesystem::path folder = arguments[2];
  const auto zz = zigzag(ship, {.rudder = radians(10), .heading = radians(10), .first = Side::starboard},
                         {.duration = 120.0, .step = 0.2});
  write_recording(measured(zz.run, 1), folder / "weak_rudder_zz10_10.csv");
  const auto circle =
      turning_circle(ship, {.rudder = radians(35), .side = Side::port}, {.duration = 150.0, .step = 0.2});
  write_recording(measured(circle.run, 2), folder / "weak_rudder_turn35.csv");
}
