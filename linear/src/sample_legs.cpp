#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "batch_kernel.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/linear/batch.hpp"

namespace swayaw::inline linear {
using namespace detail;
namespace {

using State = LinearState<double>;

static_assert(sizeof(State) == 3 * sizeof(double));

/// The exact map of a state over a step, linear in state, rudder angle and turn of the rudder over the step.
class StepMap {
 public:
  StepMap(const LinearResponse<double>& ship, double step) {
    const auto basis = response_basis(ship.p, step);
    by_beta_ = state_after(ship, {1.0, 0.0, 0.0}, {0.0, 0.0}, basis);
    by_omega_ = state_after(ship, {0.0, 1.0, 0.0}, {0.0, 0.0}, basis);
    by_angle_ = state_after(ship, {0.0, 0.0, 0.0}, {1.0, 0.0}, basis);
    by_turn_ = state_after(ship, {0.0, 0.0, 0.0}, {0.0, 1.0 / step}, basis);
  }

  State operator()(const State& x, double angle, double turn) const {
    const auto sum = [&](double State::*of) {
      return by_beta_.*of * x.beta + by_omega_.*of * x.omega + by_angle_.*of * angle + by_turn_.*of * turn;
    };
    return {sum(&State::beta), sum(&State::omega), x.psi + sum(&State::psi)};
  }

 private:
  State by_beta_, by_omega_, by_angle_, by_turn_;
};

batch::BlockMap block_map(const LinearResponse<double>& ship, double step) {
  const StepMap one(ship, step);
  batch::BlockMap map;
  const auto column = [&](double* to, State x, double angle, double turn) {
    for (std::size_t k = 0; k <= batch::block; ++k, to += 3) {
      to[0] = x.beta, to[1] = x.omega, to[2] = x.psi;
      x = one(x, angle + static_cast<double>(k) * turn, turn);
    }
  };
  column(map.by_beta, {1.0, 0.0, 0.0}, 0.0, 0.0);
  column(map.by_omega, {0.0, 1.0, 0.0}, 0.0, 0.0);
  column(map.by_psi, {0.0, 0.0, 1.0}, 0.0, 0.0);
  column(map.by_angle, {0.0, 0.0, 0.0}, 1.0, 0.0);
  column(map.by_turn, {0.0, 0.0, 0.0}, 0.0, 1.0);
  return map;
}

/// States from the one at the time `start` of a leg on.
void sample_leg(const LinearResponse<double>& ship, const batch::BlockMap& map, batch::SampleKernel kernel,
                const Leg<double>& leg, double start, double step, std::span<State> states) {
  const auto x = state_after(ship, leg.start, leg.rudder, start);
  const std::size_t blocks = states.size() / batch::block;
  batch::SampleJob job{.beta = x.beta,
                       .omega = x.omega,
                       .psi = x.psi,
                       .angle = leg.rudder.value + leg.rudder.rate * start,
                       .turn = leg.rudder.rate * step,
                       .blocks = blocks,
                       .states = &states.data()->beta};
  kernel(map, job);
  // the last block not whole
  std::array<State, batch::block> rest;
  job.blocks = 1;
  job.states = &rest.data()->beta;
  kernel(map, job);
  std::copy_n(rest.begin(), states.size() % batch::block,
              states.begin() + static_cast<std::ptrdiff_t>(blocks * batch::block));
}

}  // namespace

void sample_legs(const SwayYawCoefficients<double>& ship, std::span<const Leg<double>> legs, double step,
                 std::span<State> states) {
  if (legs.empty()) throw std::domain_error("no legs to sample");
  require_positive(step, "step [ship lengths]");
  const LinearResponse<double> response(ship);
  const auto map = block_map(response, step);
  const auto kernel = batch::best_samples();
  std::size_t next = 0;
  for (std::size_t i = 0; i < legs.size() && next < states.size(); ++i) {
    const double until = std::ceil((legs[i].from + legs[i].length) / step);
    const std::size_t end = i + 1 < legs.size() && until < static_cast<double>(states.size())
                                ? static_cast<std::size_t>(until)
                                : states.size();
    if (next >= end) continue;
    sample_leg(response, map, kernel, legs[i], static_cast<double>(next) * step - legs[i].from, step,
               states.subspan(next, end - next));
    next = end;
  }
}

}  // namespace swayaw::linear
