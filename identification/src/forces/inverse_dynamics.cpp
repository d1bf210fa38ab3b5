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

/// Forces on one model of a ship. Those that effects and a gust add are in the states of the filter already: they stand
/// on both sides.
template <class Model>
class Dynamics {
 public:
  explicit Dynamics(const ActingShip<Model>& acting)
      : ship_(acting.model),
        dual_(cast<D>(acting.model)),
        around_(cast<D>(acting.surroundings)),
        added_(acting.added),
        dual_added_(cast<D>(acting.added)) {}

  InverseDynamics at(const EstimatedState& estimate, const Controls<double>& controls) const {
    const auto s = in_seven(estimate.state);
    const auto parts = forces(dual_, s.motion, driven(dual_added_, s.motion, cast<D>(controls)),
                              branch_at(ship_, estimate.state.motion, driven(added_, estimate.state.motion, controls)));
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
  ActingEffects<double> added_;
  ActingEffects<D> dual_added_;
};

}  // namespace

std::vector<InverseDynamics> inverse_dynamics(const Ship& ship, const Recording& run, const StateEstimate& estimate) {
  if (run.samples() != estimate.states.size())
    throw Refusal(
        fmt::format("{}: {} samples, but {} in the estimate", run.name, run.samples(), estimate.states.size()));
  const RecordedControls controls(ship, run);
  std::vector<InverseDynamics> result;
  result.reserve(run.samples());
  visit_acting(in_depth(ship, recorded_depth(run)).value_or(ship), [&](const auto& acting) {
    const Dynamics dynamics(acting);
    for (const auto& state : estimate.states) result.push_back(dynamics.at(state, controls.at(state.time)));
  });
  return result;
}

}  // namespace swayaw::identification
