#include "swayaw/nonlinear/manoeuvres/steady_run_in_wind.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "../steady/small_matrices.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/dual.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"

namespace swayaw::inline nonlinear {
using namespace detail;
namespace {

using Point = Eigen::Vector4d;  ///< u/U, v/U, delta, psi
using D = Dual<4>;

/// Four equations that are zero on a straight run.
struct Balance {
  Eigen::Vector4d residual;
  Eigen::Matrix4d jacobian;
};

template <class Model>
class StraightRun {
 public:
  StraightRun(const ActingShip<Model>& acting, const Windage<double>& windage, const Wind<double>& wind,
              const WindRunOrder& order, const Controls<double>& propulsion)
      : ship_(cast<D>(acting.model)),
        added_(cast<D>(acting.added)),
        windage_(cast_part<D>(windage)),
        current_(acting.surroundings.current),
        wind_(wind),
        order_(order),
        propulsion_(cast<D>(propulsion)),
        U_(acting.model.particulars.U_0),
        L_(acting.model.particulars.L) {}

  Point still() const { return {1.0, 0.0, 0.0, order_.direction}; }

  /// @param share  of the wind speed
  Balance at(const Point& p, double share) const {
    const PlanarMotion<D> m{U_ * D(p[0], 0), U_ * D(p[1], 1), D(0.0)};
    const D delta(p[2], 2), psi(p[3], 3);
    const auto c = with_rudder(propulsion_, delta);
    const auto ground = over_ground(Current<D>{D(current_.speed), D(current_.to)}, {D(0.0), D(0.0), psi, m});
    const Wind<D> wind{D(share * wind_.speed), D(wind_.from)};
    const auto a =
        acceleration(ship_, m, own_force({D(0.0), D(0.0), psi, m}, c) + wind_force(windage_, wind, ground, psi));
    const double unit = L_ / (U_ * U_);
    const D equations[] = {a.u * unit, a.v * unit, a.r * unit * L_, kept(ground, psi)};
    Balance b;
    for (int i = 0; i < 4; ++i) {
      b.residual[i] = equations[i].a;
      b.jacobian.row(i) = equations[i].v.transpose();
    }
    return b;
  }

  /// Whether she makes way ahead, and over ground to the side kept.
  bool ahead(const Point& p) const {
    const auto ground = ground_at(p);
    const double towards = ground.u * std::cos(p[3] - order_.direction) - ground.v * std::sin(p[3] - order_.direction);
    return p[0] > 0.0 && (order_.kept == Kept::heading || towards > 0.0);
  }

  WindRun run_at(const Point& p, const Windage<double>& windage, double largest) const {
    const auto ground = ground_at(p);
    return {.motion = motion_at(p),
            .psi = p[3],
            .delta = p[2],
            .course = p[3] + std::atan2(ground.v, ground.u),
            .speed_over_ground = speed(ground),
            .wind_force = wind_force(windage, wind_, ground, p[3]),
            .holds = std::abs(p[2]) <= largest};
  }

 private:
  PlanarMotion<double> motion_at(const Point& p) const { return {U_ * p[0], U_ * p[1], 0.0}; }
  PlanarMotion<double> ground_at(const Point& p) const { return over_ground(current_, {0.0, 0.0, p[3], motion_at(p)}); }

  /// Force of the water, with what effects add to it.
  PlanarForce<D> own_force(const ShipState<D>& state, const Controls<D>& controls) const {
    const auto own = forces(ship_, state.motion, controls).total();
    return added_.any()
               ? own + added_force(ship_, added_, state, steady_hidden(ship_, added_, state.motion, controls), controls)
               : own;
  }

  /// psi − psi_0, or the velocity over ground across the course, over U.
  D kept(const PlanarMotion<D>& ground, const D& psi) const {
    const D off = psi - order_.direction;
    if (order_.kept == Kept::heading) return off;
    return (ground.u * sin(off) + ground.v * cos(off)) / U_;
  }

  decltype(cast<D>(std::declval<Model>())) ship_;
  ActingEffects<D> added_;
  Windage<D> windage_;
  Current<double> current_;
  Wind<double> wind_;
  WindRunOrder order_;
  Controls<D> propulsion_;
  double U_, L_;
};

/// Newton's method at a share of the wind. @return whether it came to a run ahead
template <class Equations>
bool correct(const Equations& equations, Point& p, double share) {
  for (int iteration = 0; iteration < 15; ++iteration) {
    const auto b = equations.at(p, share);
    const Point change = solve(b.jacobian, Point(-b.residual));
    const double size = change.cwiseAbs().maxCoeff();
    if (!(size < 0.5)) return false;
    p += change;
    if (size < 1e-13) return equations.ahead(p);
  }
  // where the force has a kink the last steps may alternate
  return equations.at(p, share).residual.cwiseAbs().maxCoeff() < 1e-11 && equations.ahead(p);
}

/// The run at full wind, from still air on.
template <class Equations>
std::optional<Point> raise_wind(const Equations& equations) {
  Point p = equations.still();
  if (!correct(equations, p, 0.0)) return std::nullopt;
  double share = 0.0, step = 0.25;
  while (share < 1.0) {
    Point next = p;
    const double tried = std::min(1.0, share + step);
    if (correct(equations, next, tried) && (next - p).cwiseAbs().maxCoeff() < 0.3) {
      p = next;
      share = tried;
      step *= 1.5;
    } else if ((step *= 0.5) < 1e-4) {
      return std::nullopt;
    }
  }
  return p;
}

template <class Model>
std::optional<WindRun> run_of(const ActingShip<Model>& acting, const Windage<double>& windage, const Wind<double>& wind,
                              const WindRunOrder& order) {
  const auto& model = acting.model;
  const auto propulsion = order.propulsion ? *order.propulsion : self_propulsion(model, model.particulars.U_0);
  const StraightRun<Model> equations(acting, windage, wind, order, propulsion);
  const auto p = raise_wind(equations);
  if (!p) return std::nullopt;
  return equations.run_at(*p, windage, model.steering_gear.max_angle);
}

}  // namespace

std::optional<WindRun> steady_run_in_wind(const Ship& ship, const Windage<double>& windage, const Wind<double>& wind,
                                          const WindRunOrder& order) {
  if (!(wind.speed >= 0.0))
    throw std::domain_error(fmt::format("wind speed [m/s] must not be negative, got {}", wind.speed));
  return visit_acting(ship, [&](const auto& acting) { return run_of(acting, windage, wind, order); });
}

std::vector<WindRunRow> steady_runs_in_wind(const Ship& ship, const Windage<double>& windage, double wind_speed,
                                            std::span<const double> relative, const WindRunOrder& order) {
  std::vector<WindRunRow> rows;
  for (const double angle : relative)
    rows.push_back({angle, steady_run_in_wind(ship, windage, {wind_speed, order.direction + angle}, order)});
  return rows;
}

}  // namespace swayaw::nonlinear
