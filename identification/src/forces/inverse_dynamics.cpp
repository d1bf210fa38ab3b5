#include "swayaw/identification/inverse_dynamics.hpp"

#include <fmt/format.h>

#include "swayaw/core/dual.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"
#include "swayaw/nonlinear/replay.hpp"

namespace swayaw::inline identification {
namespace {

using D = Dual<7>;  // of psi, u, v, r and the unmodelled accelerations

constexpr std::size_t first = 2;  ///< place of psi in the covariance; u, v, r and the unmodelled accelerations follow

ShipState<D> in_seven(const ShipState<double>& s) {
  return {D(s.x), D(s.y), D(s.psi, 0), {D(s.motion.u, 1), D(s.motion.v, 2), D(s.motion.r, 3)}};
}

PlanarForce<D> operator-(const PlanarForce<D>& a, const PlanarForce<D>& b) { return {a.X - b.X, a.Y - b.Y, a.N - b.N}; }

/// J P Jᵀ
EstimatedForce estimated(const PlanarForce<D>& f, const StateCovariance& P) {
  EstimatedForce result{.force = {f.X.a, f.Y.a, f.N.a}, .covariance = {}};
  const auto Q = P.of<7>(first);
  const std::array<Eigen::Matrix<double, 7, 1>, 3> J{f.X.v, f.Y.v, f.N.v};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) result.covariance[i][k] = J[i].dot(Q * J[k]);
  return result;
}

/// Forces on one model of a ship.
template <class Model>
class Dynamics {
 public:
  Dynamics(const Model& model, const Surroundings<double>& around)
      : ship_(model), dual_(cast<D>(model)), around_(cast<D>(around)) {}

  InverseDynamics at(const EstimatedState& estimate, const Controls<double>& controls) const {
    const auto s = in_seven(estimate.state);
    const auto parts = forces(dual_, s.motion, cast<D>(controls), branch_at(ship_, estimate.state.motion, controls));
    const auto wind = wind_load(around_, s);
    auto a = acceleration(dual_, s.motion, parts.total() + wind);
    a.u += D(estimate.unmodelled.u, 4);
    a.v += D(estimate.unmodelled.v, 5);
    a.r += D(estimate.unmodelled.r, 6);
    const auto damping = force_of(dual_, s.motion, a) - wind;
    auto hull = damping;
    for (const auto& part : parts.parts())
      if (part.name != "hull") hull = hull - part.force;
    return {.time = estimate.time,
            .damping = estimated(damping, estimate.covariance),
            .hull = estimated(hull, estimate.covariance)};
  }

 private:
  Model ship_;
  decltype(cast<D>(std::declval<Model>())) dual_;
  Surroundings<D> around_;
};

}  // namespace

std::vector<InverseDynamics> inverse_dynamics(const Ship& ship, const Recording& run, const StateEstimate& estimate) {
  if (run.samples() != estimate.states.size())
    throw Refusal(
        fmt::format("{}: {} samples, but {} in the estimate", run.name, run.samples(), estimate.states.size()));
  const RecordedControls controls(ship, run);
  const auto acting = with_effects_applied(in_depth(ship, recorded_depth(run)).value_or(ship));
  std::vector<InverseDynamics> result;
  result.reserve(run.samples());
  const auto of_model = [&](const auto& model) {
    const Dynamics dynamics(model, acting.surroundings);
    for (const auto& state : estimate.states) result.push_back(dynamics.at(state, controls.at(state.time)));
  };
  std::visit(of_model, acting.model);
  return result;
}

}  // namespace swayaw::identification
