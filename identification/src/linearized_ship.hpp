#pragma once

#include <Eigen/Core>

#include "swayaw/core/dual.hpp"
#include "swayaw/nonlinear/equations_of_motion.hpp"
#include "swayaw/nonlinear/ship.hpp"

/// Rates of a ship and their derivatives by the state. Not installed.
namespace swayaw {

template <class D>
Surroundings<D> cast_around(const Surroundings<double>& around) {
  return {.windage = cast_part<D>(around.windage),
          .wind = {D(around.wind.speed), D(around.wind.from)},
          .current = {D(around.current.speed), D(around.current.to)},
          .windy = around.windy};
}

/// The state with derivatives by psi, u, v and r, on which alone rates and forces depend.
inline ShipState<Dual<4>> in_duals(const ShipState<double>& s) {
  using D = Dual<4>;
  return {D(s.x), D(s.y), D(s.psi, 0), {D(s.motion.u, 1), D(s.motion.v, 2), D(s.motion.r, 3)}};
}

/// Compiled in a file of its own for each model, where the compiler finds room to inline the dual numbers.
template <class Model>
class LinearizedShip {
 public:
  LinearizedShip(const Model& ship, const Surroundings<double>& around)
      : ship_(ship), dual_(cast<D>(ship)), around_(cast_around<D>(around)) {}

  struct At {
    Eigen::Matrix<double, 6, 1> rate;  ///< of x, y, psi, u, v, r
    Eigen::Matrix<double, 6, 4> A;     ///< its derivatives by psi, u, v, r
  };

  At at(const ShipState<double>& state, const Controls<double>& controls) const;

 private:
  using D = Dual<4>;

  Model ship_;
  decltype(cast<D>(std::declval<Model>())) dual_;
  Surroundings<D> around_;
};

template <class Model>
[[gnu::flatten]] auto LinearizedShip<Model>::at(const ShipState<double>& state, const Controls<double>& controls) const
    -> At {
  const auto f = rates_of(dual_, around_, in_duals(state), cast<D>(controls), branch_at(ship_, state.motion, controls));
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

}  // namespace swayaw
