#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <span>

#include "swayaw/core/dual.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"
#include "swayaw/nonlinear/simulation/equations_of_motion.hpp"

/// Rates of a ship with her effects, and their derivatives by the state. Not installed.
namespace swayaw::inline identification::detail {

/// The state with derivatives by psi, u, v and r, on which alone rates and forces depend.
inline ShipState<Dual<4>> in_duals(const ShipState<double>& s) {
  using D = Dual<4>;
  return {D(s.x), D(s.y), D(s.psi, 0), {D(s.motion.u, 1), D(s.motion.v, 2), D(s.motion.r, 3)}};
}

template <class S>
Hidden<S> hidden_in(const Hidden<double>& hidden) {
  Hidden<S> result;
  std::ranges::transform(hidden, result.begin(), [](double x) { return S(x); });
  return result;
}

/// Compiled in a file of its own for each model, where the compiler finds room to inline the dual numbers.
template <class Model>
class LinearizedShip {
 public:
  explicit LinearizedShip(const ActingShip<Model>& acting)
      : ship_(acting.model),
        dual_(cast<D>(acting.model)),
        around_(acting.surroundings),
        dual_around_(cast<D>(around_)),
        added_(acting.added),
        dual_added_(cast<D>(added_)) {}

  struct At {
    Eigen::Matrix<double, 6, 1> rate;  ///< of x, y, psi, u, v, r
    Eigen::Matrix<double, 6, 4> A;     ///< its derivatives by psi, u, v, r
  };

  /// Rates and their derivatives.
  At at(const ShipState<double>& state, const Hidden<double>& hidden, const Controls<double>& controls) const;

  /// Rates alone.
  StateVector<double> rates(const ShipState<double>& state, const Hidden<double>& hidden,
                            const Controls<double>& controls) const;

  /// From now on the wind blows, and the forces act, as the change says.
  void apply(const Change& change) {
    change.apply(around_, added_);
    change.apply(around_, dual_added_);
    dual_around_ = cast<D>(around_);
  }

  bool hides_states() const { return added_.hidden(); }
  Hidden<double> steady_hidden(const PlanarMotion<double>& m) const { return swayaw::steady_hidden(added_, m); }
  Hidden<double> rates_of_hidden(const PlanarMotion<double>& m, const Hidden<double>& h) const {
    return hidden_rates(added_, m, h);
  }

 private:
  using D = Dual<4>;

  [[gnu::noinline]] StateVector<D> with_effects(const ShipState<double>& state, const Hidden<double>& hidden,
                                                const Controls<double>& controls) const;

  Model ship_;
  decltype(cast<D>(std::declval<Model>())) dual_;
  Surroundings<double> around_;
  Surroundings<D> dual_around_;
  ActingEffects<double> added_;
  ActingEffects<D> dual_added_;
};

template <class Model>
StateVector<double> LinearizedShip<Model>::rates(const ShipState<double>& state, const Hidden<double>& hidden,
                                                 const Controls<double>& controls) const {
  const auto branch = branch_at(ship_, state.motion, driven(added_, state.motion, controls));
  if (!added_.any()) return rates_of(ship_, around_, state, controls, branch);
  return rates_of(ship_, around_, added_, state, hidden, controls, branch);
}

template <class Model>
auto LinearizedShip<Model>::with_effects(const ShipState<double>& state, const Hidden<double>& hidden,
                                         const Controls<double>& controls) const -> StateVector<D> {
  const auto branch = branch_at(ship_, state.motion, driven(added_, state.motion, controls));
  return rates_of(dual_, dual_around_, dual_added_, in_duals(state), hidden_in<D>(hidden), cast<D>(controls), branch);
}

template <class Model>
[[gnu::flatten]] auto LinearizedShip<Model>::at(const ShipState<double>& state, const Hidden<double>& hidden,
                                                const Controls<double>& controls) const -> At {
  const auto f = added_.any() ? with_effects(state, hidden, controls)
                              : rates_of(dual_, dual_around_, in_duals(state), cast<D>(controls),
                                         branch_at(ship_, state.motion, controls));
  At at;
  for (int i = 0; i < 6; ++i) {
    at.rate[i] = f[static_cast<std::size_t>(i)].a;
    at.A.row(i) = f[static_cast<std::size_t>(i)].v.transpose();
  }
  return at;
}

extern template class LinearizedShip<MmgShip<double>>;
extern template class LinearizedShip<PiShip<double>>;
extern template class LinearizedShip<PuShip<double>>;
extern template class LinearizedShip<AbkowitzShip<double>>;

}  // namespace swayaw::identification::detail
