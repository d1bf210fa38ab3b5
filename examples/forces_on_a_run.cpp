// What pushed a recorded ship besides her model: noise found from the run, and yaw moments on the hull by inverse
// dynamics.
#include <fmt/format.h>

#include <cmath>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/recording_csv.hpp"
#include "swayaw/identification/inverse_dynamics.hpp"
#include "swayaw/nonlinear/ship_file.hpp"

int main(int, char** arguments) {
  using namespace swayaw;
  const Ship ship = read_ship(arguments[1]);
  const Recording run = read_recording(arguments[2]).recording;
  const StateEstimate estimate = estimate_states(ship, run);
  fmt::print("{:<10}{:>12}{:>22}{:>18}\n", "channel", "noise", "error / expected", "autocorrelation");
  for (const auto& i : estimate.innovations)
    fmt::print("{:<10}{:>12.3g}{:>22.3f}{:>18.3f}\n", column_name(i.channel), i.noise, i.rms, i.autocorrelation);
  const auto& a = estimate.noise.process_noise.size;
  fmt::print("unmodelled accelerations {:.3g} and {:.3g} m/s2, {:.3g} rad/s2\n", a.u, a.v, a.r);
  fmt::print("{} after {} iterations\n\n", estimate.noise.converged ? "converged" : "not converged",
             estimate.noise.iterations);

  const auto forces = inverse_dynamics(ship, run, estimate);
  fmt::print("{:>8}{:>12}{:>22}{:>26}\n", "time, s", "rudder, deg", "hull moment, N m", "missing dr/dt, deg/s2");
  for (std::size_t k = 0; k < forces.size(); k += forces.size() / 20) {
    const auto& [time, damping, hull] = forces[k];
    const auto& state = estimate.states[k];
    fmt::print("{:>8.1f}{:>12.1f}{:>14.2f} ± {:<5.2f}{:>18.4f} ± {:<6.4f}\n", time, degrees(run[Channel::delta][k]),
               hull.force.N, 2.0 * std::sqrt(hull.covariance[2][2]), degrees(state.unmodelled.r),
               degrees(2.0 * std::sqrt(state.covariance(8, 8))));
  }
}
