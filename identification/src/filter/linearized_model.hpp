#pragma once

#include <algorithm>

#include "linearized_ship.hpp"
#include "swayaw/nonlinear/simulation/equations_of_motion.hpp"

/// A linearized ship of one model. Not installed.
namespace swayaw::inline identification::detail {

template <class Model>
class LinearizedModel final : public LinearizedShip {
 public:
  explicit LinearizedModel(const ActingShip<Model>& acting)
      : LinearizedShip(acting), ship_(acting.model), dual_(cast<D>(acting.model)) {}

  At at(const ShipState<double>& state, const Hidden<double>& hidden, const Controls<double>& controls) const override;

  StateVector<double> rates(const ShipState<double>& state, const Hidden<double>& hidden,
                            const Controls<double>& controls) const override {
    const auto branch = branch_at(ship_, state.motion, driven(added_, state.motion, controls));
    if (!added_.any()) return rates_of(ship_, around_, state, controls, branch);
    return rates_of(ship_, around_, added_, state, hidden, controls, branch);
  }

  Hidden<double> steady_hidden(const PlanarMotion<double>& motion, const Controls<double>& controls) const override {
    return swayaw::steady_hidden(ship_, added_, motion, controls);
  }

  double sway_by_rudder(const PlanarMotion<double>& motion, const Controls<double>& controls) const override {
    return swayaw::sway_by_rudder(ship_, added_, motion, controls);
  }

 private:
  [[gnu::noinline]] StateVector<D> with_effects(const ShipState<double>& state, const Hidden<double>& hidden,
                                                const Controls<double>& controls) const {
    const auto branch = branch_at(ship_, state.motion, driven(added_, state.motion, controls));
    Hidden<D> constant;
    std::ranges::transform(hidden, constant.begin(), [](double x) { return D(x); });
    return rates_of(dual_, dual_around_, dual_added_, in_duals(state), constant, cast<D>(controls), branch);
  }

  Model ship_;
  decltype(cast<D>(std::declval<Model>())) dual_;
};

template <class Model>
[[gnu::flatten]] auto LinearizedModel<Model>::at(const ShipState<double>& state, const Hidden<double>& hidden,
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

extern template class LinearizedModel<MmgShip<double>>;
extern template class LinearizedModel<PiShip<double>>;
extern template class LinearizedModel<PuShip<double>>;
extern template class LinearizedModel<AbkowitzShip<double>>;

}  // namespace swayaw::identification::detail
