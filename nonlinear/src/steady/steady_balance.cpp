#include "steady_balance.hpp"

#include "swayaw/core/dual.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"

namespace swayaw::inline nonlinear::detail {

using D = Dual<4>;

class SteadyEquations::OfModel {
 public:
  virtual ~OfModel() = default;
  virtual PlanarAcceleration<D> at(const PlanarMotion<D>& m, const D& delta) const = 0;
};

template <class Model>
class SteadyEquations::InDuals : public OfModel {
 public:
  InDuals(const ActingShip<Model>& acting, const Controls<double>& propulsion)
      : ship_(cast<D>(acting.model)), added_(cast<D>(acting.added)), propulsion_(cast<D>(propulsion)) {}

  PlanarAcceleration<D> at(const PlanarMotion<D>& m, const D& delta) const override {
    return acceleration(ship_, m, steady_force(ship_, added_, m, with_rudder(propulsion_, delta)));
  }

 private:
  decltype(cast<D>(std::declval<Model>())) ship_;
  ActingEffects<D> added_;
  Controls<D> propulsion_;
};

SteadyEquations::SteadyEquations(const Ship& ship, const Controls<double>& propulsion) : L_(length(ship)) {
  visit_acting(ship, [&]<class Model>(const ActingShip<Model>& acting) {
    equations_ = std::make_unique<const InDuals<Model>>(acting, propulsion);
    L_ = acting.model.particulars.L;
  });
}

SteadyEquations::~SteadyEquations() = default;

double SteadyEquations::L() const { return L_; }

SteadyBalance SteadyEquations::at(const PlanarMotion<double>& m, double delta) const {
  const auto a = equations_->at({D(m.u, 0), D(m.v, 1), D(m.r, 2)}, D(delta, 3));
  SteadyBalance balance{{a.u.a, a.v.a, a.r.a}, {}};
  balance.jacobian << a.u.v.transpose(), a.v.v.transpose(), a.r.v.transpose();
  return balance;
}

}  // namespace swayaw::nonlinear::detail
