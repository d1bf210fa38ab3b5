#include "swayaw/identification/force_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "bare_ship.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/identification/inverse_dynamics.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/replay.hpp"

namespace swayaw {
namespace {

constexpr std::array components{ForceComponent::X, ForceComponent::Y, ForceComponent::N};

double in(ForceComponent component, const PlanarForce<double>& f) {
  return component == ForceComponent::X ? f.X : component == ForceComponent::Y ? f.Y : f.N;
}

/// ½ρL²U² [N], and times L for the moment.
double unit_of(ForceComponent component, const Ship& ship, double U) {
  const double rho = std::visit([](const auto&model) { return model.water.rho; }, ship.model), L = length(ship);
  const double q = 0.5 * rho * L * L * U * U;
  return component == ForceComponent::N ? q * L : q;
}

/// Force of the ship, and its derivatives by numbers: a column X, Y, N for each.
struct ForceAndFeatures {
  PlanarForce<double> force;
  Eigen::Matrix3Xd by_number;
};

/// In portions of as many numbers as a dual has derivatives.
ForceAndFeatures force_and_features(const Ship& ship, std::span<const Parameter> numbers,
                                    const PlanarMotion<double>& motion, const Controls<double>& controls) {
  constexpr int lanes = 8;
  using D = Dual<lanes>;
  ForceAndFeatures result{{}, Eigen::Matrix3Xd(3, static_cast<Eigen::Index>(numbers.size()))};
  const auto add_portion = [&](const auto& model, std::size_t from) {
    const auto portion = numbers.subspan(from, std::min<std::size_t>(lanes, numbers.size() - from));
    const auto f =
        forces(seeded<lanes>(model, portion), PlanarMotion<D>{D(motion.u), D(motion.v), D(motion.r)}, cast<D>(controls))
            .total();
    result.force = {f.X.a, f.Y.a, f.N.a};
    const auto columns = static_cast<Eigen::Index>(portion.size());
    auto block = result.by_number.middleCols(static_cast<Eigen::Index>(from), columns);
    block.row(0) = f.X.v.head(columns).transpose();
    block.row(1) = f.Y.v.head(columns).transpose();
    block.row(2) = f.N.v.head(columns).transpose();
  };
  const auto add_all = [&](const auto& model) {
    for (std::size_t from = 0; from < numbers.size(); from += lanes) add_portion(model, from);
  };
  std::visit(add_all, ship.model);
  return result;
}

// ---------------------------------------------------------------- which number acts where

/// A moving ship with rudder, to see what a number does.
struct Probe {
  PlanarMotion<double> motion;
  Controls<double> controls;
};

Probe probe_of(const Ship& ship) {
  const double U = service_speed(ship), T = 5e-4 * unit_of(ForceComponent::X, ship, U);
  return {{U, -0.1 * U, 0.2 * U / length(ship)}, {.delta = 0.2, .thrust = {T, T}, .by_thrust = true}};
}

/// The equations in which the force depends on a number.
std::vector<ForceComponent> acts_in(const Eigen::Vector3d& by_number, double scale) {
  std::vector<ForceComponent> result;
  for (Eigen::Index i = 0; i < 3; ++i)
    if (std::abs(by_number[i]) > 1e-12 * scale) result.push_back(components[static_cast<std::size_t>(i)]);
  return result;
}

/// Where each number acts, which is one equation, and linearly.
std::vector<ForceComponent> equations_of(const Ship& at_zero, std::span<const Parameter> numbers) {
  const auto [motion, controls] = probe_of(at_zero);
  const auto zero = force_and_features(at_zero, numbers, motion, controls);
  const auto ones = with_values(at_zero, numbers, std::vector<double>(numbers.size(), 1.0));
  const auto one = force_and_features(ones, numbers, motion, controls);
  std::vector<ForceComponent> result;
  for (std::size_t j = 0; j < numbers.size(); ++j) {
    const Eigen::Vector3d slope = zero.by_number.col(static_cast<Eigen::Index>(j)),
                          other = one.by_number.col(static_cast<Eigen::Index>(j));
    const double scale = slope.cwiseAbs().maxCoeff() + other.cwiseAbs().maxCoeff();
    if (!(scale > 0.0)) throw Refusal(fmt::format("{} does not act on the force of {}", numbers[j].name, at_zero.name));
    if ((slope - other).cwiseAbs().maxCoeff() > 1e-9 * scale)
      throw Refusal(fmt::format("the force is not linear in {}, which is found on trajectories only (--refine)",
                                numbers[j].name));
    const auto where = acts_in(slope, scale);
    if (where.size() > 1)
      throw Refusal(fmt::format("{} acts in more than one force equation and is found on trajectories only (--refine)",
                                numbers[j].name));
    result.push_back(where.front());
  }
  return result;
}

// ---------------------------------------------------------------- rows

/// What is known of a ship at a sample.
struct Known {
  Ship ship;     ///< as given, with which the states were estimated
  Ship at_zero;  ///< without the coefficients to be found
};

/// Rows of the three equations at one sample: features over their units, and what they have to explain.
struct Rows {
  Eigen::Matrix3Xd X;
  Eigen::Vector3d y;
};

Rows rows_at(const Known& known, std::span<const Parameter> numbers, const PlanarMotion<double>& motion,
             const PlanarAcceleration<double>& unmodelled, const Controls<double>& controls) {
  const auto [force, by_number] = force_and_features(known.at_zero, numbers, motion, controls);
  const auto damping = std::visit(
      [&](const auto& model) {
        const auto a = acceleration(model, motion, forces(model, motion, controls).total());
        return force_of(model, motion,
                        PlanarAcceleration<double>{a.u + unmodelled.u, a.v + unmodelled.v, a.r + unmodelled.r});
      },
      known.ship.model);
  Rows rows{by_number, {}};
  const double U = speed(motion);
  for (Eigen::Index i = 0; i < 3; ++i) {
    const auto component = components[static_cast<std::size_t>(i)];
    const double unit = unit_of(component, known.ship, U);
    rows.X.row(i) /= unit;
    rows.y[i] = (in(component, damping) - in(component, force)) / unit;
  }
  return rows;
}

/// Changes of (features, y) of an equation with u, v, r and the unmodelled acceleration.
using Slopes = Eigen::Matrix<double, Eigen::Dynamic, 6>;

std::array<Slopes, 3> slopes_at(const Known& known, std::span<const Parameter> numbers, const EstimatedState& s,
                                const Controls<double>& controls) {
  const double U = speed(s.state.motion), L = length(known.ship);
  const std::array<double, 6> step{1e-5 * U,         1e-5 * U,         1e-5 * U / L,
                                   1e-5 * U * U / L, 1e-5 * U * U / L, 1e-5 * U * U / (L * L)};
  std::array<Slopes, 3> slopes;
  for (auto& slope : slopes) slope.resize(static_cast<Eigen::Index>(numbers.size()) + 1, 6);
  for (Eigen::Index k = 0; k < 6; ++k) {
    const auto moved = [&](double h) {
      std::array<double, 6> z{s.state.motion.u, s.state.motion.v, s.state.motion.r,
                              s.unmodelled.u,   s.unmodelled.v,   s.unmodelled.r};
      z[static_cast<std::size_t>(k)] += h;
      return rows_at(known, numbers, {z[0], z[1], z[2]}, {z[3], z[4], z[5]}, controls);
    };
    const double h = step[static_cast<std::size_t>(k)];
    const auto up = moved(h), down = moved(-h);
    for (Eigen::Index i = 0; i < 3; ++i) {
      auto& slope = slopes[static_cast<std::size_t>(i)];
      slope.col(k).head(up.X.cols()) = (up.X.row(i) - down.X.row(i)).transpose() / (2.0 * h);
      slope(up.X.cols(), k) = (up.y[i] - down.y[i]) / (2.0 * h);
    }
  }
  return slopes;
}

Eigen::Matrix<double, 6, 6> covariance_of(const EstimatedState& s) {
  Eigen::Matrix<double, 6, 6> P;
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t k = 0; k < 6; ++k)
      P(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = s.covariance(3 + i, 3 + k);
  return P;
}

// ---------------------------------------------------------------- equations

/// Rows of all runs, equation by equation.
class Equations {
 public:
  Equations(const Ship& ship, std::span<const Parameter> numbers)
      : numbers_(numbers),
        known_{ship, with_values(ship, numbers, std::vector<double>(numbers.size(), 0.0))},
        acts_in_(equations_of(known_.at_zero, numbers)) {}

  void add(const Recording& run, const StateEstimate& estimate) {
    const RecordedControls controls(known_.ship, run);
    run_starts_.push_back(static_cast<Eigen::Index>(rows_.size()));
    for (const auto& s : estimate.states) {
      const auto c = controls.at(s.time);
      rows_.push_back(rows_at(known_, numbers_, s.state.motion, s.unmodelled, c));
      const auto P = covariance_of(s);
      const auto slopes = slopes_at(known_, numbers_, s, c);
      std::array<Eigen::MatrixXd, 3> covariance;
      for (std::size_t i = 0; i < 3; ++i) covariance[i] = slopes[i] * P * slopes[i].transpose();
      errors_.push_back(std::move(covariance));
    }
  }

  /// Places of the numbers that act in an equation.
  std::vector<std::size_t> numbers_in(ForceComponent component) const {
    std::vector<std::size_t> places;
    for (std::size_t j = 0; j < numbers_.size(); ++j)
      if (acts_in_[j] == component) places.push_back(j);
    return places;
  }

  Design design(ForceComponent component) const {
    const auto places = numbers_in(component);
    const auto i = static_cast<Eigen::Index>(component);
    Design d{.names = {},
             .X = Eigen::MatrixXd(static_cast<Eigen::Index>(rows_.size()), static_cast<Eigen::Index>(places.size())),
             .y = Eigen::VectorXd(static_cast<Eigen::Index>(rows_.size())),
             .runs = run_starts_};
    for (const auto j : places) d.names.push_back(numbers_[j].name);
    for (Eigen::Index k = 0; k < d.X.rows(); ++k) {
      const auto& row = rows_[static_cast<std::size_t>(k)];
      for (Eigen::Index j = 0; j < d.X.cols(); ++j)
        d.X(k, j) = row.X(i, static_cast<Eigen::Index>(places[static_cast<std::size_t>(j)]));
      d.y[k] = row.y[i];
    }
    return d;
  }

  std::vector<Eigen::MatrixXd> errors(ForceComponent component) const {
    auto kept = numbers_in(component);
    kept.push_back(numbers_.size());  // that of y
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
  std::span<const Parameter> numbers_;
  Known known_;
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

std::vector<Prior> priors_of(std::span<const Parameter> numbers, const Design& design) {
  std::vector<Prior> priors;
  for (const auto& n : numbers)
    if (std::ranges::count(design.names, n.name) > 0 && n.deviation > 0.0)
      priors.push_back({n.name, n.value, n.deviation});
  return priors;
}

std::vector<double> attenuations(const Regression& fit) {
  std::vector<double> result;
  for (const auto& c : fit.coefficients) result.push_back(std::abs(c.attenuation));
  return result;
}

}  // namespace

ForceFit fit_forces(const Ship& ship, std::span<const Recording> runs, std::vector<StateEstimate> states,
                    const ForceFitOptions& options) {
  if (options.numbers.empty()) throw Refusal("no coefficient is to be found");
  require_known_effects(ship, "force fit", true);
  const auto numbers = parameters_of(ship, options.numbers);
  Equations equations(ship, numbers);
  for (std::size_t i = 0; i < runs.size(); ++i) equations.add(runs[i], states[i]);
  ForceFit result{.ship = ship, .equations = {}, .range = range_of(runs, states, ship), .states = std::move(states)};
  for (const auto component : components) {
    const auto design = equations.design(component);
    if (design.names.empty()) continue;
    RegressionOptions how{.standard_errors = StandardErrors::newey_west, .ridge = options.ridge};
    if (options.priors) how.priors = priors_of(numbers, design);
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
  for (const auto& run : runs) states.push_back(estimate_states(ship, run, options.states));
  return fit_forces(ship, runs, std::move(states), options);
}

}  // namespace swayaw
