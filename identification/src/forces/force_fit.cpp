#include "swayaw/identification/force_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "force_component.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/identification/inverse_dynamics.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"
#include "swayaw/nonlinear/replay.hpp"

namespace swayaw::inline identification {
using namespace detail;
namespace {

/// Force of a model whose parameters are as effects change them, and whose shaft turns as the engine drives it. What
/// effects add is no force of the model: it is in the states of the filter, and on both sides of an equation.
template <class Model, class S>
class OwnForce {
 public:
  explicit OwnForce(const Ship& ship) : OwnForce(acting_ship(ship, std::get<Model>(ship.model))) {}

  const auto& model() const { return model_; }

  PlanarForce<S> at(const PlanarMotion<S>& motion, const Controls<S>& controls) const {
    return forces(model_, motion, driven(added_, motion, controls)).total();
  }

 private:
  explicit OwnForce(const ActingShip<Model>& acting) : model_(cast<S>(acting.model)), added_(cast<S>(acting.added)) {}

  decltype(cast<S>(std::declval<Model>())) model_;
  ActingEffects<S> added_;
};

/// Force of the ship, and what one more of each number adds to it: a column X, Y, N for each.
template <class S>
struct ForceAndFeatures {
  PlanarForce<S> force;
  Eigen::Matrix<S, 3, Eigen::Dynamic> by_parameter;
};

/// The force of a ship as a linear function of parameters, about values of theirs.
template <class Model, class S>
class LinearForce {
 public:
  LinearForce(const Ship& ship, std::span<const Parameter> parameters, std::vector<double> values)
      : base_(with_values(ship, parameters, values)) {
    for (double& value : values) {
      value += 1.0;
      one_more_.emplace_back(with_values(ship, parameters, values));
      value -= 1.0;
    }
  }

  ForceAndFeatures<S> at(const PlanarMotion<S>& motion, const Controls<S>& controls) const {
    ForceAndFeatures<S> result{base_.at(motion, controls), {3, static_cast<Eigen::Index>(one_more_.size())}};
    for (Eigen::Index j = 0; const auto& more : one_more_) {
      const auto f = more.at(motion, controls);
      result.by_parameter.col(j++) << f.X - result.force.X, f.Y - result.force.Y, f.N - result.force.N;
    }
    return result;
  }

 private:
  OwnForce<Model, S> base_;
  std::vector<OwnForce<Model, S>> one_more_;
};

// ---------------------------------------------------------------- which number acts where

/// A moving ship with rudder, to see what a number does.
struct Probe {
  PlanarMotion<double> motion;
  Controls<double> controls;
};

Probe probe_of(const Ship& ship) {
  const double U = service_speed(ship), T = 5e-4 * force_unit(ship, U, ForceComponent::X);
  return {{U, -0.1 * U, 0.2 * U / length(ship)}, {.delta = 0.2, .thrust = {T, T}, .by_thrust = true}};
}

/// The equations in which the force depends on a number.
std::vector<ForceComponent> acts_in(const Eigen::Vector3d& by_parameter, double scale) {
  std::vector<ForceComponent> result;
  for (Eigen::Index i = 0; i < 3; ++i)
    if (std::abs(by_parameter[i]) > 1e-12 * scale) result.push_back(force_components[static_cast<std::size_t>(i)]);
  return result;
}

/// What one more of each number adds to the force of the probe, where each of them has that value.
Eigen::Matrix3Xd features_of_probe(const Ship& ship, std::span<const Parameter> parameters, double value) {
  const auto probe = probe_of(ship);
  const auto of_model = [&]<class Model>(const Model&) {
    const std::vector<double> values(parameters.size(), value);
    return LinearForce<Model, double>(ship, parameters, values).at(probe.motion, probe.controls).by_parameter;
  };
  return std::visit(of_model, ship.model);
}

/// Where each number acts, which is one equation, and linearly.
std::vector<ForceComponent> equations_of(const Ship& ship, std::span<const Parameter> parameters) {
  const auto zero = features_of_probe(ship, parameters, 0.0), one = features_of_probe(ship, parameters, 1.0);
  std::vector<ForceComponent> result;
  for (std::size_t j = 0; j < parameters.size(); ++j) {
    const Eigen::Vector3d slope = zero.col(static_cast<Eigen::Index>(j)), other = one.col(static_cast<Eigen::Index>(j));
    const double scale = slope.cwiseAbs().maxCoeff() + other.cwiseAbs().maxCoeff();
    if (!(scale > 0.0)) throw Refusal(fmt::format("{} does not act on the force of {}", parameters[j].name, ship.name));
    if ((slope - other).cwiseAbs().maxCoeff() > 1e-9 * scale)
      throw Refusal(
          fmt::format("the force is not linear in {}, which is found on trajectories only (--fit trajectories)",
                      parameters[j].name));
    const auto where = acts_in(slope, scale);
    if (where.size() > 1)
      throw Refusal(
          fmt::format("{} acts in more than one force equation and is found on trajectories only (--fit trajectories)",
                      parameters[j].name));
    result.push_back(where.front());
  }
  return result;
}

// ---------------------------------------------------------------- rows

/// Changes of (features, y) of an equation with u, v, r and the unmodelled acceleration.
using Slopes = Eigen::Matrix<double, Eigen::Dynamic, 6>;

/// Rows of the three equations at one sample: features over their units, and what they have to explain.
struct Rows {
  Eigen::Matrix3Xd X;
  Eigen::Vector3d y;
  std::array<Slopes, 3> slopes;
};

/// Rows at the samples of a run.
template <class Model>
class RowsOf {
 public:
  using D = Dual<6>;

  /// @param ship  as given, with which the states were estimated
  RowsOf(const Ship& ship, std::span<const Parameter> parameters)
      : ship_(ship), as_given_(ship), at_zero_(ship, parameters, std::vector<double>(parameters.size(), 0.0)) {}

  Rows at(const EstimatedState& s, const Controls<double>& controls) const {
    const auto& m = s.state.motion;
    const PlanarMotion<D> motion{D(m.u, 0), D(m.v, 1), D(m.r, 2)};
    const auto in_duals = cast<D>(controls);
    const auto [force, by_parameter] = at_zero_.at(motion, in_duals);
    auto a = acceleration(as_given_.model(), motion, as_given_.at(motion, in_duals));
    a.u += D(s.unmodelled.u, 3), a.v += D(s.unmodelled.v, 4), a.r += D(s.unmodelled.r, 5);
    const auto damping = force_of(as_given_.model(), motion, a);
    const auto n = by_parameter.cols();
    Rows rows{Eigen::Matrix3Xd(3, n), {}, {}};
    for (Eigen::Index i = 0; i < 3; ++i) {
      const auto component = force_components[static_cast<std::size_t>(i)];
      const D unit = force_unit(ship_, speed(motion), component),
              y = (component_of(damping, component) - component_of(force, component)) / unit;
      auto& slopes = rows.slopes[static_cast<std::size_t>(i)];
      slopes.resize(n + 1, 6);
      for (Eigen::Index j = 0; j < n; ++j) {
        const D x = by_parameter(i, j) / unit;
        rows.X(i, j) = x.a, slopes.row(j) = x.v.transpose();
      }
      rows.y[i] = y.a, slopes.row(n) = y.v.transpose();
    }
    return rows;
  }

 private:
  const Ship& ship_;
  OwnForce<Model, D> as_given_;
  LinearForce<Model, D> at_zero_;
};

// ---------------------------------------------------------------- equations

/// Rows of all runs, equation by equation.
class Equations {
 public:
  Equations(const Ship& ship, std::span<const Parameter> parameters)
      : ship_(ship), parameters_(parameters), acts_in_(equations_of(ship, parameters)) {}

  void add(const Recording& run, const StateEstimate& estimate) {
    const RecordedControls controls(ship_, run);
    run_starts_.push_back(static_cast<Eigen::Index>(rows_.size()));
    const auto of_model = [&]<class Model>(const Model&) {
      const RowsOf<Model> rows(ship_, parameters_);
      for (const auto& s : estimate.states) rows_.push_back(rows.at(s, controls.at(s.time)));
    };
    std::visit(of_model, ship_.model);
    for (const auto& s : estimate.states) {
      const auto& rows = rows_[errors_.size()];
      const auto P = s.covariance.of<6>(3);  // u, v, r and the unmodelled acceleration
      auto& covariance = errors_.emplace_back();
      for (std::size_t i = 0; i < 3; ++i) covariance[i] = rows.slopes[i] * P * rows.slopes[i].transpose();
    }
  }

  /// Places of the parameters that act in an equation.
  std::vector<std::size_t> parameters_in(ForceComponent component) const {
    std::vector<std::size_t> places;
    for (std::size_t j = 0; j < parameters_.size(); ++j)
      if (acts_in_[j] == component) places.push_back(j);
    return places;
  }

  Design design(ForceComponent component) const {
    const auto places = parameters_in(component);
    const auto i = static_cast<Eigen::Index>(component);
    Design d{.names = {},
             .X = Eigen::MatrixXd(static_cast<Eigen::Index>(rows_.size()), static_cast<Eigen::Index>(places.size())),
             .y = Eigen::VectorXd(static_cast<Eigen::Index>(rows_.size())),
             .runs = run_starts_};
    for (const auto j : places) d.names.push_back(parameters_[j].name);
    for (Eigen::Index k = 0; k < d.X.rows(); ++k) {
      const auto& row = rows_[static_cast<std::size_t>(k)];
      for (Eigen::Index j = 0; j < d.X.cols(); ++j)
        d.X(k, j) = row.X(i, static_cast<Eigen::Index>(places[static_cast<std::size_t>(j)]));
      d.y[k] = row.y[i];
    }
    return d;
  }

  std::vector<Eigen::MatrixXd> errors(ForceComponent component) const {
    auto kept = parameters_in(component);
    kept.push_back(parameters_.size());  // that of y
    std::vector<Eigen::MatrixXd> result;
    for (const auto& e : errors_) {
      Eigen::MatrixXd c(static_cast<Eigen::Index>(kept.size()), static_cast<Eigen::Index>(kept.size()));
      for (Eigen::Index a = 0; a < c.rows(); ++a)
        for (Eigen::Index b = 0; b < c.cols(); ++b)
          c(a, b) =
              e[static_cast<std::size_t>(component)](static_cast<Eigen::Index>(kept[static_cast<std::size_t>(a)]),
                                                     static_cast<Eigen::Index>(kept[static_cast<std::size_t>(b)]));
      result.push_back(std::move(c));
    }
    return result;
  }

 private:
  const Ship& ship_;  ///< with which the states were estimated
  std::span<const Parameter> parameters_;
  std::vector<ForceComponent> acts_in_;
  std::vector<Rows> rows_;
  std::vector<std::array<Eigen::MatrixXd, 3>> errors_;
  std::vector<Eigen::Index> run_starts_;
};

MotionRange range_of(std::span<const Recording> runs, std::span<const StateEstimate> states, const Ship& ship) {
  MotionRange range{0.0, 0.0, 0.0};
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const RecordedControls controls(ship, runs[i]);
    for (const auto& s : states[i].states) {
      range.drift = std::max(range.drift, std::abs(drift_angle(s.state.motion)));
      range.omega = std::max(range.omega, std::abs(s.state.motion.r) * length(ship) / speed(s.state.motion));
      range.rudder = std::max(range.rudder, std::abs(controls.at(s.time).delta));
    }
  }
  return range;
}

std::vector<Prior> priors_of(std::span<const Parameter> parameters, const Design& design) {
  std::vector<Prior> priors;
  for (const auto& n : parameters)
    if (std::ranges::count(design.names, n.name) > 0 && n.deviation > 0.0)
      priors.push_back({n.name, n.value, n.deviation});
  return priors;
}

/// Coefficients are those of the water in which the runs were sailed: the measured depth does not act besides.
StateEstimate states_in_any_depth(const Ship& ship, const Recording& run, const EstimationOptions& options) {
  if (!in_depth(ship, recorded_depth(run))) return estimate_states(ship, run, options);
  auto deep = run;
  deep.facts.water_depth.reset(), deep.channels[index_of(Channel::depth)].clear();
  return estimate_states(ship, deep, options);
}

std::vector<double> attenuations(const Regression& fit) {
  std::vector<double> result;
  for (const auto& c : fit.coefficients) result.push_back(std::abs(c.attenuation));
  return result;
}

}  // namespace

ForceFit fit_forces(const Ship& ship, std::span<const Recording> runs, std::vector<StateEstimate> states,
                    const ForceFitOptions& options) {
  if (options.parameters.empty()) throw Refusal("no coefficient is to be found");
  const auto parameters = parameters_of(ship, options.parameters);
  Equations equations(ship, parameters);
  for (std::size_t i = 0; i < runs.size(); ++i) equations.add(runs[i], states[i]);
  ForceFit result{.ship = ship, .equations = {}, .range = range_of(runs, states, ship), .states = std::move(states)};
  for (const auto component : force_components) {
    const auto design = equations.design(component);
    if (design.names.empty()) continue;
    RegressionOptions how{.standard_errors = StandardErrors::newey_west, .ridge = options.ridge};
    if (options.priors) how.priors = priors_of(parameters, design);
    auto with_errors = how;
    with_errors.feature_errors.covariance = equations.errors(component);
    result.equations.push_back({component, regress(design, how), attenuations(regress(design, with_errors))});
    for (const auto& c : result.equations.back().fit.coefficients) {
      if (!std::isfinite(c.estimate.value)) continue;
      const std::array name{c.name};
      result.ship = with_values(result.ship, parameters_of(ship, name), std::array{c.estimate.value});
    }
  }
  return result;
}

ForceFit fit_forces(const Ship& ship, std::span<const Recording> runs, const ForceFitOptions& options) {
  std::vector<StateEstimate> states;
  for (const auto& run : runs) states.push_back(states_in_any_depth(ship, run, options.states));
  return fit_forces(ship, runs, std::move(states), options);
}

}  // namespace swayaw::identification
