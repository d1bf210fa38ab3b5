#include "rivals.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "random_source.hpp"
#include "shortest_solution.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"
#include "swayaw/nonlinear/models/force_breakdown.hpp"
#include "swayaw/nonlinear/replay.hpp"

namespace swayaw::concealed {
namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

constexpr double half_window = 0.48, stride = 0.24;  ///< [L/U]

/// How many samples to either side count for a slope, and every how many one is taken.
struct Grid {
  std::ptrdiff_t reach, step;
};

Grid grid_of(const Recording& run, double time_unit) {
  const double dt = (run.time.back() - run.time.front()) / static_cast<double>(run.samples() - 1);
  const auto samples = [&](double lengths) {
    return std::max<std::ptrdiff_t>(1, std::lround(lengths * time_unit / dt));
  };
  return {std::max<std::ptrdiff_t>(3, samples(half_window)), samples(stride)};
}

/// Value and two derivatives at the middle of samples, by a cubic through them.
struct Jet {
  double value, rate, second;
};

Jet local_cubic(std::span<const double> time, std::span<const double> values, std::size_t middle,
                std::ptrdiff_t reach) {
  Matrix A(2 * reach + 1, 4);
  Vector b(2 * reach + 1);
  const double unit = time[middle + static_cast<std::size_t>(reach)] - time[middle];
  for (std::ptrdiff_t i = -reach; i <= reach; ++i) {
    const auto k = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(middle) + i);
    const double t = (time[k] - time[middle]) / unit;
    A.row(i + reach) << 1.0, t, t * t, t * t * t;
    b[i + reach] = values[k];
  }
  const Vector c = shortest_solution(A, b);
  return {c[0], c[1] / unit, 2.0 * c[2] / (unit * unit)};
}

/// A moment of a run: how the ship moves, what drives her, and how she is accelerated.
struct Sample {
  ShipState<double> state;
  Controls<double> controls;
  double delta_rate;
  Eigen::Vector3d acceleration;
};

/// Samples of a channel, straight lines across what is missing.
std::vector<double> complete(const Recording& run, Channel channel) {
  const Interpolant line(run, channel);
  std::vector<double> values;
  for (const double t : run.time) values.push_back(line(t));
  return values;
}

std::vector<Sample> samples_of(const Ship& ship, const Recording& run) {
  const auto [reach, step] = grid_of(run, time_unit_of(ship));
  const RecordedControls controls(ship, run);
  constexpr std::array channels{Channel::x, Channel::y, Channel::psi, Channel::r, Channel::delta};
  std::array<std::vector<double>, channels.size()> values;
  for (std::size_t i = 0; i < channels.size(); ++i) values[i] = complete(run, channels[i]);
  std::vector<Sample> samples;
  for (std::ptrdiff_t i = reach; i + reach < std::ssize(run.time); i += step) {
    std::array<Jet, channels.size()> jets;
    for (std::size_t k = 0; k < jets.size(); ++k)
      jets[k] = local_cubic(run.time, values[k], static_cast<std::size_t>(i), reach);
    const auto& [x, y, psi, yaw, delta] = jets;
    const double c = std::cos(psi.value), s = std::sin(psi.value), r = yaw.value;
    const double u = x.rate * c + y.rate * s, v = -x.rate * s + y.rate * c;
    auto now = controls.at(run.time[static_cast<std::size_t>(i)]);
    now.delta = delta.value;
    samples.push_back({{x.value, y.value, psi.value, {u, v, r}},
                       now,
                       delta.rate,
                       {x.second * c + y.second * s + r * v, -x.second * s + y.second * c - r * u, yaw.rate}});
  }
  return samples;
}

Eigen::Vector3d acceleration(const Ship& ship, const Sample& s) {
  const auto a = force_breakdown(ship, s.state, s.controls).acceleration;
  return {a.u, a.v, a.r};
}

/// Accelerations of all samples, one axis after the other.
Vector stacked(const std::vector<Sample>& samples, auto&& of_sample) {
  const auto n = static_cast<Eigen::Index>(samples.size());
  Vector all(3 * n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector3d a = of_sample(samples[static_cast<std::size_t>(i)]);
    for (Eigen::Index axis = 0; axis < 3; ++axis) all[axis * n + i] = a[axis];
  }
  return all;
}

// ---------------------------------------------------------------- regression on what effects add

/// Small effects of a kind, whose sum with any weights stands for the kind.
std::vector<Effect> unit_effects(const Ship& ship, const Effect& null) {
  std::vector<Effect> units;
  const auto parameters = parameters_of(ship, null);
  const auto direction = std::ranges::find_if(parameters, [](const auto& n) { return n.key.ends_with("from_rad"); });
  if (direction != parameters.end()) {
    for (const double from : {0.0, 0.5 * pi, pi, 1.5 * pi}) {
      Effect effect = null;
      parameter_value(effect, parameters.front().index) = parameters.front().deviation;
      for (const auto& n : parameters)
        if (n.decides && n.index != direction->index) parameter_value(effect, n.index) = n.deviation;
      parameter_value(effect, direction->index) = from;
      units.push_back(effect);
    }
    return units;
  }
  const auto of_value = [&](const Parameter& n, double value) {
    Effect effect = null;
    parameter_value(effect, n.index) = value;
    if (id_of(null) == "rudder_gap") std::get<RudderGap<double>>(effect).delta_lim = 0.2;
    units.push_back(effect);
  };
  for (const auto& n : parameters) {
    if (!n.decides || !(n.deviation > 0.0)) continue;
    if (id_of(null) == "shallow_water") of_value(n, 1.6);
    else if (id_of(null) == "rudder_stall") of_value(n, 0.3);
    else if (id_of(null) == "rudder_gap") of_value(n, -n.deviation);
    else of_value(n, std::min(n.range.high, n.null + 0.5 * n.deviation));
  }
  return units;
}

/// What an effect adds to the accelerations; nothing where it acts on instruments only, or out of sight.
Matrix columns_of(const Ship& ship, const std::vector<Sample>& samples, const Vector& without, const Effect& null) {
  const auto n = without.size();
  const auto with_rudder = [&](auto&& moved) {
    Matrix column(n, 1);
    column.col(0) =
        stacked(samples, [&](Sample s) { return s.controls.delta += moved(s), acceleration(ship, s); }) - without;
    return column;
  };
  if (id_of(null) == "rudder_offset") return with_rudder([](const Sample&) { return 0.02; });
  if (id_of(null) == "steering_gear_lag") return with_rudder([](const Sample& s) { return -s.delta_rate; });
  const auto place = place_of(null);
  if (place == EffectPlace::sensor || place == EffectPlace::actuator || place == EffectPlace::water ||
      id_of(null) == "gust")
    return Matrix(n, 0);
  const auto units = unit_effects(ship, null);
  Matrix columns(n, static_cast<Eigen::Index>(units.size()));
  for (std::size_t i = 0; i < units.size(); ++i) {
    const Ship changed = with_effect(ship, units[i]);
    columns.col(static_cast<Eigen::Index>(i)) =
        stacked(samples, [&](const Sample& s) { return acceleration(changed, s); }) - without;
  }
  return columns;
}

/// Everything in units of the residual's own size on its axis.
void scale_axes(Vector& residual, std::vector<Matrix*> columns) {
  const auto n = residual.size() / 3;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double size = std::sqrt(residual.segment(axis * n, n).squaredNorm() / static_cast<double>(n));
    residual.segment(axis * n, n) /= size;
    for (auto* m : columns) m->middleRows(axis * n, n) /= size;
  }
}

std::vector<std::string> by_bic(const Ship& ship, const std::vector<Sample>& samples, const Vector& without,
                                Vector residual) {
  struct Scored {
    std::string id;
    double gain;
  };
  std::vector<std::pair<std::string, Matrix>> all;
  for (const auto id : effect_ids()) {
    if (id == "model_form") continue;  // no name: it is the form of the file
    try {
      all.emplace_back(id, columns_of(ship, samples, without, make_effect(id)));
    } catch (const Refusal&) {  // the ship cannot have it
    }
  }
  std::vector<Matrix*> columns;
  for (auto& [id, m] : all) columns.push_back(&m);
  scale_axes(residual, columns);
  const double n = static_cast<double>(residual.size());
  std::vector<Scored> scored;
  for (const auto& [id, A] : all) {
    if (A.cols() == 0) continue;
    const Vector left = residual - A * shortest_solution(A, residual);
    scored.push_back(
        {id, n * std::log(residual.squaredNorm() / left.squaredNorm()) - static_cast<double>(A.cols()) * std::log(n)});
  }
  std::ranges::sort(scored, std::greater{}, &Scored::gain);
  std::vector<std::string> names;
  for (const auto& s : scored)
    if (s.gain > 10.0 && names.size() < 3) names.push_back(s.id);
  return names;
}

// ---------------------------------------------------------------- sparse regression on monomials

/// A term on an axis and the effect that it speaks for.
struct Term {
  double (*value)(const Sample&, double L, double U_0);
  std::array<std::string_view, 3> effect;  ///< where it stands in surge, sway, yaw
};

double v_of(const Sample& s) { return s.state.motion.v / speed(s.state.motion); }
double r_of(const Sample& s, double L) { return s.state.motion.r * L / speed(s.state.motion); }

const std::array<Term, 16> library{{
    {[](const Sample&, double, double) { return 1.0; }, {"added_resistance", "propeller_side_force", "rudder_offset"}},
    {[](const Sample& s, double, double U_0) { return s.state.motion.u / U_0 - 1.0; },
     {"added_resistance", "propeller_side_force", "propeller_side_force"}},
    {[](const Sample& s, double, double) { return v_of(s); },
     {"steady_current", "hull_linear_derivatives", "hull_linear_derivatives"}},
    {[](const Sample& s, double L, double) { return r_of(s, L); },
     {"wake_change", "hull_linear_derivatives", "hull_linear_derivatives"}},
    {[](const Sample& s, double, double) { return s.controls.delta; },
     {"rudder_offset", "rudder_effectiveness", "rudder_effectiveness"}},
    {[](const Sample& s, double, double) { return std::pow(s.controls.delta, 3); },
     {"rudder_effectiveness", "rudder_stall", "rudder_stall"}},
    {[](const Sample& s, double, double) { return s.controls.delta * s.controls.delta; },
     {"rudder_effectiveness", "rudder_gap", "rudder_gap"}},
    {[](const Sample& s, double, double) { return v_of(s) * v_of(s); },
     {"speed_loss_in_turn", "flow_straightening", "flow_straightening"}},
    {[](const Sample& s, double L, double) { return r_of(s, L) * r_of(s, L); },
     {"speed_loss_in_turn", "flow_straightening", "flow_straightening"}},
    {[](const Sample& s, double L, double) { return v_of(s) * r_of(s, L); },
     {"speed_loss_in_turn", "flow_straightening", "flow_straightening"}},
    {[](const Sample& s, double, double) { return std::abs(v_of(s)) * v_of(s); },
     {"speed_loss_in_turn", "cross_flow_drag", "cross_flow_drag"}},
    {[](const Sample& s, double L, double) { return v_of(s) * v_of(s) * r_of(s, L); },
     {"speed_loss_in_turn", "hull_nonlinear_damping", "hull_nonlinear_damping"}},
    {[](const Sample& s, double L, double) { return v_of(s) * r_of(s, L) * r_of(s, L); },
     {"speed_loss_in_turn", "hull_nonlinear_damping", "hull_nonlinear_damping"}},
    {[](const Sample& s, double, double) { return s.delta_rate; },
     {"steering_gear_lag", "steering_gear_lag", "steering_gear_lag"}},
    {[](const Sample& s, double, double) { return std::cos(s.state.psi); },
     {"steady_wind", "steady_wind", "steady_wind"}},
    {[](const Sample& s, double, double) { return std::sin(s.state.psi); },
     {"steady_wind", "steady_wind", "steady_wind"}},
}};

/// Terms that survive: each time the weights are fitted, those that move the residual by less than a share of its size
/// are dropped.
std::vector<std::pair<double, std::size_t>> survivors(const Matrix& terms, const Vector& residual) {
  std::vector<std::size_t> kept;
  for (Eigen::Index i = 0; i < terms.cols(); ++i) kept.push_back(static_cast<std::size_t>(i));
  const double enough = 0.3 * residual.norm();
  while (!kept.empty()) {
    Matrix A(terms.rows(), static_cast<Eigen::Index>(kept.size()));
    for (std::size_t i = 0; i < kept.size(); ++i)
      A.col(static_cast<Eigen::Index>(i)) = terms.col(static_cast<Eigen::Index>(kept[i]));
    const Vector weights = shortest_solution(A, residual);
    std::vector<std::pair<double, std::size_t>> left;
    for (std::size_t i = 0; i < kept.size(); ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      if (const double share = std::abs(weights[k]) * A.col(k).norm(); share > enough)
        left.emplace_back(share / residual.norm(), kept[i]);
    }
    if (left.size() == kept.size()) {
      const double explained = 1.0 - (residual - A * weights).squaredNorm() / residual.squaredNorm();
      return explained > 0.15 ? left : std::vector<std::pair<double, std::size_t>>{};
    }
    kept.clear();
    for (const auto& [share, place] : left) kept.push_back(place);
  }
  return {};
}

std::vector<std::string> by_sparse_terms(const Ship& ship, const std::vector<Sample>& samples, const Vector& residual) {
  const auto n = static_cast<Eigen::Index>(samples.size());
  const double L = length(ship), U_0 = service_speed(ship);
  Matrix terms(n, static_cast<Eigen::Index>(library.size()));
  for (Eigen::Index i = 0; i < n; ++i)
    for (std::size_t k = 0; k < library.size(); ++k)
      terms(i, static_cast<Eigen::Index>(k)) = library[k].value(samples[static_cast<std::size_t>(i)], L, U_0);
  std::vector<std::pair<double, std::string>> found;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const auto& [share, term] : survivors(terms, residual.segment(static_cast<Eigen::Index>(axis) * n, n)))
      found.emplace_back(share, library[term].effect[axis]);
  std::ranges::sort(found, std::greater{}, &std::pair<double, std::string>::first);
  std::vector<std::string> names;
  for (const auto& [share, name] : found)
    if (names.size() < 3 && std::ranges::count(names, name) == 0) names.push_back(name);
  return names;
}

// ---------------------------------------------------------------- all candidates in one regression

constexpr double told = 16.0;  ///< χ² over degrees of freedom of an effect that is named: four standard deviations
constexpr double form_share = 0.1;  ///< of the whole force: deviation of each term of the form of the hull

/// Columns of the regression that belong together; their weights have the prior N(0, 1).
struct Block {
  std::string name;  ///< of an effect; empty for what is not named
  Matrix columns;
};

/// What the coefficients of the file, moved by their deviations, add to the accelerations.
Block baseline(const Ship& ship, const std::vector<Sample>& samples, const Vector& without) {
  std::vector<Vector> columns;
  for (const auto& n : parameters_of(ship)) {
    if (n.role != Role::coefficient || !(n.deviation > 0.0)) continue;
    const double value = n.value + n.deviation;
    const Ship moved = with_values(ship, std::span(&n, 1), std::span(&value, 1));
    columns.push_back(stacked(samples, [&](const Sample& s) { return acceleration(moved, s); }) - without);
  }
  Matrix m(without.size(), static_cast<Eigen::Index>(columns.size()));
  for (std::size_t i = 0; i < columns.size(); ++i) m.col(static_cast<Eigen::Index>(i)) = columns[i];
  return {"", m};
}

/// A free function of the motion on each axis, the same in all runs, each term in the size of a share of the whole.
Block form_of(const Ship& ship, const std::vector<Sample>& samples, const Vector& whole) {
  const auto n = static_cast<Eigen::Index>(samples.size());
  const double L = length(ship), U_0 = service_speed(ship);
  constexpr Eigen::Index terms = 10;
  Matrix m = Matrix::Zero(3 * n, 3 * terms);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto& s = samples[static_cast<std::size_t>(i)];
    const double u = s.state.motion.u / U_0, v = s.state.motion.v / U_0, r = s.state.motion.r * L / U_0,
                 d = s.controls.delta;
    const std::array<double, terms> even{1.0,   u,     u * u, v * v,         v * r,
                                         r * r, d * d, d * r, d * d * u * u, std::abs(d) * std::abs(r) * u},
        odd{u * v,           u * r, v * std::abs(v), r * std::abs(r), v * std::abs(r),
            r * std::abs(v), d * u, d * u * u,       d * d * d,       v * v * v};
    for (Eigen::Index k = 0; k < terms; ++k) {
      m(i, k) = even[static_cast<std::size_t>(k)];
      m(n + i, terms + k) = m(2 * n + i, 2 * terms + k) = odd[static_cast<std::size_t>(k)];
    }
  }
  for (Eigen::Index k = 0; k < m.cols(); ++k)
    if (const double size = m.col(k).norm(); size > 0.0)
      m.col(k) *= form_share * whole.segment(k / terms * n, n).norm() / size;
  return {"", m};
}

/// Accelerations without those samples where any is five times as far off as usual: a wild fix.
std::vector<Eigen::Index> rows_of_sense(const Vector& residual) {
  const auto n = residual.size() / 3;
  std::vector<bool> keep(static_cast<std::size_t>(n), true);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    std::vector<double> sizes;
    for (Eigen::Index i = 0; i < n; ++i) sizes.push_back(std::abs(residual[axis * n + i]));
    auto sorted = sizes;
    std::ranges::sort(sorted);
    const double usual = 1.48 * sorted[sorted.size() / 2];
    for (std::size_t i = 0; i < sizes.size(); ++i)
      if (sizes[i] > 5.0 * usual) keep[i] = false;
  }
  std::vector<Eigen::Index> rows;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    for (Eigen::Index i = 0; i < n; ++i)
      if (keep[static_cast<std::size_t>(i)]) rows.push_back(axis * n + i);
  return rows;
}

/// One linear regression of the accelerations that the file does not give on what every effect would add, over all
/// runs, beside the coefficients of the file with their confidence and a free function of the motion. Samples overlap
/// by half, so they count half. Named are effects that χ² tells from 0, the surest first.
std::vector<std::string> by_pooled_regression(const Ship& ship, const std::vector<Sample>& samples,
                                              const Vector& without, const Vector& residual) {
  std::vector<Block> blocks{baseline(ship, samples, without), form_of(ship, samples, without)};
  for (const auto id : effect_ids()) {
    if (id == "model_form" || id == "unknown") continue;  // the free function of the motion is there already
    try {
      if (Matrix m = columns_of(ship, samples, without, make_effect(id)); m.cols() > 0 && m.allFinite())
        blocks.push_back({std::string(id), std::move(m)});
    } catch (const Refusal&) {  // the ship cannot have it
    }
  }
  Eigen::Index width = 0;
  for (const auto& b : blocks) width += b.columns.cols();
  const auto rows = rows_of_sense(residual);
  const auto n = static_cast<Eigen::Index>(rows.size()), each = n / 3;
  Matrix A(n, width);
  Eigen::Index place = 0;
  for (const auto& b : blocks)
    A.middleCols(place, b.columns.cols()) = b.columns(rows, Eigen::all), place += b.columns.cols();
  Vector b = residual(rows);
  // noise of each axis by what the regression leaves; twice is enough
  Vector noise = Vector::Ones(3);
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    noise[axis] = std::sqrt(2.0 * b.segment(axis * each, each).squaredNorm() / static_cast<double>(each));
  Matrix covariance;
  Vector weights;
  for (int round = 0; round < 3; ++round) {
    Matrix scaled = A;
    Vector target = b;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      scaled.middleRows(axis * each, each) /= noise[axis], target.segment(axis * each, each) /= noise[axis];
    covariance = (scaled.transpose() * scaled + Matrix::Identity(width, width)).inverse();
    weights = covariance * (scaled.transpose() * target);
    const Vector left = b - A * weights;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      noise[axis] = std::sqrt(2.0 * left.segment(axis * each, each).squaredNorm() / static_cast<double>(each));
  }
  std::vector<std::pair<double, std::string>> found;
  place = 0;
  for (const auto& block : blocks) {
    const auto k = block.columns.cols();
    const Vector w = weights.segment(place, k);
    const double chi2 = w.dot(covariance.block(place, place, k, k).ldlt().solve(w)) / static_cast<double>(k);
    if (!block.name.empty() && chi2 > told) found.emplace_back(chi2, block.name);
    place += k;
  }
  std::ranges::sort(found, std::greater{}, &std::pair<double, std::string>::first);
  std::vector<std::string> names;
  for (const auto& [chi2, name] : found)
    if (names.size() < 3) names.push_back(name);
  return names;
}

std::vector<std::string> at_random(std::uint64_t seed) {
  RandomSource random(seed);
  const auto ids = effect_ids();
  const auto place = random.below(ids.size() + 1);
  return place == ids.size() ? std::vector<std::string>{} : std::vector<std::string>{std::string(ids[place])};
}

}  // namespace

std::vector<RivalAnswer> rivals_on(const Riddle& riddle, std::uint64_t seed) {
  std::vector<Sample> samples;
  for (const auto& run : riddle.train)
    for (const auto& s : samples_of(riddle.ship, run)) samples.push_back(s);
  const Vector without = stacked(samples, [&](const Sample& s) { return acceleration(riddle.ship, s); });
  const Vector residual = stacked(samples, [](const Sample& s) { return s.acceleration; }) - without;
  return {{"nothing", {}},
          {"random", at_random(seed)},
          {"ols_bic", by_bic(riddle.ship, samples, without, residual)},
          {"sparse", by_sparse_terms(riddle.ship, samples, residual)},
          {"pooled", by_pooled_regression(riddle.ship, samples, without, residual)}};
}

}  // namespace swayaw::concealed
