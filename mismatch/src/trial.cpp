#include "trial.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "swayaw/core/parallel.hpp"
#include "swayaw/core/refusal.hpp"

namespace swayaw {

// ---------------------------------------------------------------- what instruments show

double shown(Channel channel, const Instant& now, std::span<const Effect> sensors) {
  const auto& [s, rate, phi] = now;
  double value = 0.0, slope = 0.0;
  switch (channel) {
    case Channel::x: value = s.x, slope = rate[0]; break;
    case Channel::y: value = s.y, slope = rate[1]; break;
    case Channel::psi: value = s.psi, slope = rate[2]; break;
    case Channel::u:
    case Channel::speed_through_water: value = s.motion.u, slope = rate[3]; break;
    case Channel::v: value = s.motion.v, slope = rate[4]; break;
    case Channel::r: value = s.motion.r, slope = rate[5]; break;
    case Channel::u_ground: value = rate[0] * std::cos(s.psi) + rate[1] * std::sin(s.psi), slope = rate[3]; break;
    case Channel::v_ground: value = rate[1] * std::cos(s.psi) - rate[0] * std::sin(s.psi), slope = rate[4]; break;
    case Channel::speed_over_ground: value = std::hypot(rate[0], rate[1]), slope = rate[3]; break;
    case Channel::course_over_ground: value = std::atan2(rate[1], rate[0]), slope = rate[2]; break;
    case Channel::phi: value = phi; break;
    default: break;
  }
  const ChannelReading<double> reading{channel, s, slope};
  for (const auto& effect : sensors) value = shown(effect, reading, value);
  return value;
}

// ---------------------------------------------------------------- trial

namespace {

constexpr std::array seeable{Channel::x,
                             Channel::y,
                             Channel::psi,
                             Channel::r,
                             Channel::u,
                             Channel::v,
                             Channel::speed_through_water,
                             Channel::u_ground,
                             Channel::v_ground,
                             Channel::speed_over_ground,
                             Channel::course_over_ground,
                             Channel::phi};

/// Standard deviation of white noise from third differences, by their median: robust against what moves slowly and
/// against outliers.
double noise_of(std::span<const double> values, double least) {
  std::vector<double> sizes;
  for (std::size_t i = 3; i < values.size(); ++i) {
    const double third = values[i] - 3.0 * values[i - 1] + 3.0 * values[i - 2] - values[i - 3];
    if (std::isfinite(third)) sizes.push_back(std::abs(third));
  }
  if (sizes.size() < 10) return least;
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::ranges::nth_element(sizes, middle);
  return std::max(least, *middle / (0.6745 * std::sqrt(20.0)));
}

/// The least that is believed of an instrument, whatever the smoothness of its record.
double least_noise(Channel channel, double L, double U) {
  switch (channel) {
    case Channel::x:
    case Channel::y: return 1e-4 * L;
    case Channel::psi:
    case Channel::course_over_ground:
    case Channel::phi: return 2e-4;
    case Channel::r: return 2e-4 * U / L;
    default: return 2e-4 * U;
  }
}

PreparedRun prepared(const Ship& ship, const Recording& run, std::span<const Channel> channels) {
  const double L = length(ship), U = service_speed(ship);
  PreparedRun result{.run = &run,
                     .channels = {},
                     .start = recorded_state(ship, run, run.time.front()),
                     .tau = L / U,
                     .longest = 0.04 * L};
  for (const auto channel : channels)
    if (run.has(channel)) result.channels.push_back({channel, noise_of(run[channel], least_noise(channel, L, U))});
  return result;
}

constexpr std::array scales{0.1, 0.25, 0.6, 1.5, 4.0, 10.0, 25.0, 60.0, 150.0, 400.0};

/// Calls f(run, predictor, first row) for each run of a ship, on all cores.
template <class F>
void for_each_run(const Trial& trial, const Ship& ship, F&& f) {
  std::vector<Eigen::Index> rows{0};
  for (const auto& run : trial.runs) rows.push_back(rows.back() + run.rows());
  const auto of_model = [&]<class Model>(const Model& model) {
    in_parallel(trial.runs.size(), 0, [&](std::size_t i) {
      Predictor<Model> predictor(ship, model, trial.runs[i]);
      f(i, predictor, rows[i]);
    });
  };
  std::visit(of_model, ship.model);
}

std::vector<FilterPass> passes_of(const Trial& trial, const Ship& ship, const Noise& noise) {
  std::vector<FilterPass> passes(trial.runs.size());
  for_each_run(trial, ship, [&](std::size_t i, auto& predictor, Eigen::Index) {
    passes[i] = predictor.filter(imperfection(trial.ship, noise), noise);
  });
  return passes;
}

Eigen::VectorXd residuals_of(const Trial& trial, const Ship& ship, const std::vector<FilterPass>& passes) {
  Eigen::VectorXd e(trial.rows());
  for_each_run(trial, ship, [&](std::size_t i, auto& predictor, Eigen::Index row) {
    predictor.innovations(passes[i], e.segment(row, trial.runs[i].rows()));
  });
  return e;
}

/// The same, huge where the ship cannot sail or her motion runs away.
Eigen::VectorXd residuals_if_any(const Trial& trial, const Hypothesis& hypothesis, const Point& point,
                                 const std::vector<FilterPass>& passes) {
  try {
    return residuals_of(trial, ship_at(trial, hypothesis, point), passes);
  } catch (const Refusal&) {
    return Eigen::VectorXd::Constant(trial.rows(), 1e6);
  }
}

double total(const std::vector<FilterPass>& passes) {
  double sum = 0.0;
  for (const auto& pass : passes) sum += pass.log_likelihood;
  return sum;
}

/// Limits, steps and prior of all coordinates of a hypothesis.
struct Space {
  Eigen::VectorXd mean, low, high, step;
  Eigen::MatrixXd precision;

  Point clamped(const Point& p) const { return p.cwiseMax(low).cwiseMin(high); }
  double prior(const Point& p) const { return (p - mean).dot(precision * (p - mean)); }
};

/// The coordinates (value − mean)/deviation at which a coefficient of the baseline has its least and its largest value.
std::pair<double, double> reach(const Parameter& p) {
  constexpr double clear = 1e-3;  // deviations from an end that is itself refused
  const double low = (p.range.low - p.value) / p.deviation + (p.range.above_low ? clear : 0.0);
  return {low, (p.range.high - p.value) / p.deviation};
}

/// Its value at a coordinate, rounding kept out of what is refused.
double value_at(const Parameter& p, double c) {
  return std::clamp(p.value + p.deviation * c, p.range.low, p.range.high);
}

Space space_of(const Trial& trial, const Hypothesis& hypothesis) {
  const auto base = trial.baseline_size();
  Eigen::Index size = base;
  for (const auto* form : hypothesis) size += static_cast<Eigen::Index>(form->coordinates.size());
  Space space{Eigen::VectorXd::Zero(size), Eigen::VectorXd::Constant(size, -HUGE_VAL),
              Eigen::VectorXd::Constant(size, HUGE_VAL), Eigen::VectorXd::Constant(size, 0.2),
              Eigen::MatrixXd::Zero(size, size)};
  space.mean.head(base) = trial.mean;
  space.precision.topLeftCorner(base, base) = trial.precision;
  for (std::size_t k = 0; k < trial.numbers.size(); ++k) {
    const auto [low, high] = reach(trial.numbers[k]);
    space.low[static_cast<Eigen::Index>(k)] = low, space.high[static_cast<Eigen::Index>(k)] = high;
  }
  if (trial.lift_loss) space.low[base - 1] = trial.lift_loss->coordinates.front().low;
  Eigen::Index i = base;
  for (const auto* form : hypothesis)
    for (const auto& c : form->coordinates) {
      space.mean[i] = c.centre, space.low[i] = c.low, space.high[i] = c.high, space.step[i] = c.step;
      space.precision(i, i) = 1.0 / (c.deviation * c.deviation);
      ++i;
    }
  return space;
}

bool takes_lift(const EffectForm* form) { return takes_rudder_lift(form->id); }

/// d(residuals)/d(point), columns from..to.
void differences(const Trial& trial, const Hypothesis& hypothesis, const Space& space, const Point& point,
                 const std::vector<FilterPass>& passes, const Eigen::VectorXd& residuals, Eigen::Index from,
                 Eigen::MatrixXd& slopes) {
  in_parallel(static_cast<std::size_t>(point.size() - from), 0, [&](std::size_t k) {
    const auto i = from + static_cast<Eigen::Index>(k);
    Point moved = point;
    const double step = point[i] + space.step[i] > space.high[i] ? -space.step[i] : space.step[i];
    moved[i] += step;
    slopes.col(i) = (residuals_if_any(trial, hypothesis, moved, passes) - residuals) / step;
  });
}

double log_determinant(const Eigen::MatrixXd& positive) { return positive.ldlt().vectorD().array().abs().log().sum(); }

}  // namespace

OrdinaryImperfection imperfection(const Ship& ship, const Noise& noise) {
  const double U = service_speed(ship), L = length(ship), a = 0.002 * noise.scale * U * U / L;
  return {0.3 * a * noise.axes[0], a * noise.axes[1], 1.5 * a / L * noise.axes[2]};
}

Eigen::Index Trial::rows() const {
  Eigen::Index sum = 0;
  for (const auto& run : runs) sum += run.rows();
  return sum;
}

std::vector<Channel> seen_channels(std::span<const Recording> runs) {
  std::vector<Channel> seen;
  for (const auto channel : seeable)
    if (std::ranges::any_of(runs, [&](const Recording& run) { return run.has(channel); })) seen.push_back(channel);
  return seen;
}

std::vector<PreparedRun> prepared_runs(const Ship& ship, std::span<const Recording> runs,
                                       std::span<const Channel> channels) {
  std::vector<PreparedRun> result;
  for (const auto& run : runs) result.push_back(prepared(ship, run, channels));
  return result;
}

Trial trial_of(const Ship& ship, std::span<const Recording> runs, std::span<const Channel> channels) {
  Trial trial{
      .ship = ship, .numbers = {}, .lift_loss = ordinary_lift_loss(ship), .mean = {}, .precision = {}, .runs = {}};
  for (const auto& n : parameters_of(ship))
    if (n.role == Role::coefficient && n.deviation > 0.0) trial.numbers.push_back(n);
  const auto size = trial.baseline_size();
  trial.mean = Eigen::VectorXd::Zero(size);
  trial.precision = Eigen::MatrixXd::Identity(size, size);
  if (trial.lift_loss)
    trial.precision(size - 1, size - 1) = 1.0 / std::pow(trial.lift_loss->coordinates.front().deviation, 2);
  trial.runs = prepared_runs(ship, runs, channels);
  return trial;
}

Trial doubted(Trial trial, double factor) {
  trial.precision /= factor * factor;
  return trial;
}

Point in_range(const Trial& trial, const Hypothesis& hypothesis, const Point& point) {
  return space_of(trial, hypothesis).clamped(point);
}

Ship ship_at(const Trial& trial, const Hypothesis& hypothesis, const Point& point) {
  std::vector<double> values;
  for (std::size_t i = 0; i < trial.numbers.size(); ++i)
    values.push_back(value_at(trial.numbers[i], point[static_cast<Eigen::Index>(i)]));
  Ship ship = with_values(trial.ship, trial.numbers, values);
  Eigen::Index next = trial.baseline_size();
  if (trial.lift_loss && std::ranges::none_of(hypothesis, takes_lift)) {
    const double loss = std::max(0.0, point[next - 1]);
    ship.effects.push_back(trial.lift_loss->at({&loss, 1}));
  }
  for (const auto* form : hypothesis) {
    const auto size = form->coordinates.size();
    ship.effects.push_back(form->at({point.data() + next, size}));
    next += static_cast<Eigen::Index>(size);
  }
  return ship;
}

Point with_start(const Point& before, std::span<const double> last_start) {
  Point point(before.size() + static_cast<Eigen::Index>(last_start.size()));
  point << before, Eigen::Map<const Eigen::VectorXd>(last_start.data(), static_cast<Eigen::Index>(last_start.size()));
  return point;
}

double log_likelihood(const Trial& trial, const Ship& ship, const Noise& noise) {
  try {
    return total(passes_of(trial, ship, noise));
  } catch (const Refusal&) {
    return -HUGE_VAL;
  }
}

std::vector<std::vector<double>> log_likelihoods(const Trial& trial, const Ship& ship, const Noise& noise) {
  std::vector<std::vector<double>> runs;
  for (auto& pass : passes_of(trial, ship, noise)) runs.push_back(std::move(pass.log_likelihoods));
  return runs;
}

namespace {

/// Climbs a number along its grid from where it is. @return whether it moved
template <class Set>
bool climbed(const Trial& trial, const Ship& ship, Likelihood& best, int first, int last, int here, double worth,
             Set&& set) {
  int at = here;
  const auto better = [&](int i) {
    if (i < first || i > last) return false;
    Noise noise = best.noise;
    set(noise, i);
    const double value = log_likelihood(trial, ship, noise);
    if (!(value > best.log_likelihood + worth)) return false;
    best = {value, noise};
    at = i;
    return true;
  };
  for (const int way : {-1, 1}) {
    while (better(at + way)) {}
    if (at != here) break;
  }
  return at != here;
}

bool scale_climbed(const Trial& trial, const Ship& ship, Likelihood& best) {
  const auto nearest =
      std::ranges::min_element(scales, {}, [&](double s) { return std::abs(std::log(s / best.noise.scale)); });
  return climbed(trial, ship, best, 0, static_cast<int>(scales.size()) - 1, static_cast<int>(nearest - scales.begin()),
                 0.0, [](Noise& noise, int i) { noise.scale = scales[static_cast<std::size_t>(i)]; });
}

/// The imperfection of each axis and its memory by powers of two; each must gain by it.
bool axes_climbed(const Trial& trial, const Ship& ship, Likelihood& best) {
  bool moved = false;
  const auto climb = [&](int first, int last, auto&& of) {
    moved |= climbed(trial, ship, best, first, last, static_cast<int>(std::lround(std::log2(of(best.noise)))), 5.0,
                     [&](Noise& noise, int i) { of(noise) = std::ldexp(1.0, i); });
  };
  for (std::size_t k = 0; k < 3; ++k) climb(-6, 6, [k](Noise& noise) -> double& { return noise.axes[k]; });
  climb(-5, 4, [](Noise& noise) -> double& { return noise.memory; });
  return moved;
}

/// Noise of the channels by powers of two; a channel must gain by it.
bool factors_climbed(const Trial& trial, const Ship& ship, Likelihood& best, bool all) {
  bool moved = false;
  for (const auto channel : seeable) {
    if (std::ranges::none_of(trial.runs, [&](const PreparedRun& r) {
          return std::ranges::count(r.channels, channel, &SeenChannel::channel) > 0;
        }))
      continue;
    const double factor = best.noise.factor[index_of(channel)];
    if (!all && factor == 1.0) continue;
    moved |= climbed(trial, ship, best, 0, 12, static_cast<int>(std::lround(std::log2(factor))), 5.0,
                     [&](Noise& noise, int i) { noise.factor[index_of(channel)] = std::ldexp(1.0, i); });
  }
  return moved;
}

}  // namespace

Likelihood best_noise(const Trial& trial, const Ship& ship, const Noise& start, bool every_channel) {
  Likelihood best{log_likelihood(trial, ship, start), start};
  scale_climbed(trial, ship, best);
  for (int i = 0; i < 3 && factors_climbed(trial, ship, best, every_channel); ++i) scale_climbed(trial, ship, best);
  for (int i = 0; i < 3 && best.noise.apart && axes_climbed(trial, ship, best); ++i)
    factors_climbed(trial, ship, best, every_channel);
  return best;
}

MapFit fit(const Trial& trial, const Hypothesis& hypothesis, const Point& start, Noise noise,
           const Eigen::MatrixXd* known, int rounds) {
  const Space space = space_of(trial, hypothesis);
  const auto base = trial.baseline_size();
  Point point = space.clamped(start);
  Eigen::MatrixXd slopes(trial.rows(), point.size());
  MapFit best;
  double density = -HUGE_VAL;  // of the posterior, logarithm
  for (int round = 0; round < rounds; ++round) {
    const auto ship = ship_at(trial, hypothesis, point);
    const auto passes = passes_of(trial, ship, noise);
    Eigen::VectorXd e = residuals_of(trial, ship, passes);
    double cost = e.squaredNorm() + space.prior(point), damping = 1e-3;
    Eigen::Index fresh = 0;  // the first column to renew
    if (known && round == 0) slopes.leftCols(fresh = known->cols()) = *known;
    for (int iteration = 0; iteration < 10; ++iteration, fresh = base) {
      differences(trial, hypothesis, space, point, passes, e, fresh, slopes);
      const Eigen::MatrixXd A = slopes.transpose() * slopes + space.precision;
      const Eigen::VectorXd b = -slopes.transpose() * e - space.precision * (point - space.mean);
      double gain = 0.0;
      for (int attempt = 0; attempt < 6 && gain == 0.0; ++attempt, damping = std::max(8.0 * damping, 1e-3)) {
        Eigen::MatrixXd damped = A;
        damped.diagonal() *= 1.0 + damping;
        const Eigen::VectorXd step = damped.ldlt().solve(b);
        if (!step.allFinite()) continue;
        const Point moved = space.clamped(point + step);
        const Eigen::VectorXd there = residuals_if_any(trial, hypothesis, moved, passes);
        const double cost_there = there.squaredNorm() + space.prior(moved);
        if (!(cost_there < cost)) continue;
        gain = cost - cost_there;
        point = moved, e = there, cost = cost_there;
        damping = std::max(damping / 40.0, 1e-7);
      }
      if (gain < 0.05) break;
    }
    const auto [log_likelihood, found] =
        best_noise(trial, ship_at(trial, hypothesis, point), noise, hypothesis.empty());
    const Eigen::MatrixXd A = slopes.transpose() * slopes + space.precision;
    const double here = log_likelihood - 0.5 * space.prior(point), gain = here - density;
    // the last round is the one whose slopes belong to the noise that was found, so it stands unless it is clearly the
    // worse
    if (gain > -0.5)
      best = {point, here + 0.5 * (log_determinant(space.precision) - log_determinant(A)), found, A.inverse()};
    if (!(gain > 0.5) && found == noise) break;
    if (!std::isfinite(here)) break;  // the filter cannot follow
    density = std::max(density, here), noise = found;
  }
  return best;
}

Screen screen_of(const Trial& trial, const Hypothesis& accepted, const MapFit& null) {
  const auto ship = ship_at(trial, accepted, null.point);
  Screen screen{.baseline = null.point,
                .passes = passes_of(trial, ship, null.noise),
                .residuals = {},
                .slopes = {},
                .inverse = {},
                .pull = {}};
  const Space space = space_of(trial, accepted);
  screen.residuals = residuals_of(trial, ship, screen.passes);
  screen.slopes.resize(trial.rows(), null.point.size());
  differences(trial, accepted, space, null.point, screen.passes, screen.residuals, 0, screen.slopes);
  screen.inverse = (screen.slopes.transpose() * screen.slopes + space.precision).inverse();
  screen.pull = space.precision * (null.point - space.mean);
  return screen;
}

double linear_evidence(const Trial& trial, const Hypothesis& accepted, const Screen& screen) {
  const Space space = space_of(trial, accepted);
  const Eigen::MatrixXd A = screen.slopes.transpose() * screen.slopes + space.precision;
  const Eigen::VectorXd g =
      screen.slopes.transpose() * screen.residuals + space.precision * (screen.baseline - space.mean);
  const double cost = screen.residuals.squaredNorm() + space.prior(screen.baseline) - g.dot(A.ldlt().solve(g));
  return 0.5 * (log_determinant(space.precision) - log_determinant(A) - cost);
}

Promise promise(const Trial& trial, const Hypothesis& accepted, const Screen& screen, const EffectForm& form,
                std::span<const double> start, int iterations) {
  Hypothesis hypothesis = accepted;
  hypothesis.push_back(&form);
  const Space space = space_of(trial, hypothesis);
  const auto base = screen.baseline.size(), size = static_cast<Eigen::Index>(form.coordinates.size());
  const auto prior = [&](const Point& p) {
    double sum = 0.0;
    for (Eigen::Index i = base; i < p.size(); ++i) sum += space.precision(i, i) * std::pow(p[i] - space.mean[i], 2);
    return sum;
  };
  const double before = screen.cost(screen.residuals);
  Point point = space.clamped(with_start(screen.baseline, start));
  Eigen::VectorXd e = residuals_of(trial, ship_at(trial, hypothesis, point), screen.passes);
  double cost = screen.cost(e) + prior(point), damping = 1e-3;
  Eigen::MatrixXd slopes(trial.rows(), point.size());
  Eigen::MatrixXd A = Eigen::MatrixXd::Identity(size, size);
  for (int iteration = 0; iteration < iterations; ++iteration) {
    differences(trial, hypothesis, space, point, screen.passes, e, base, slopes);
    const Eigen::MatrixXd J = slopes.rightCols(size), MJ = screen.projected(J);
    const Eigen::MatrixXd Lambda = space.precision.bottomRightCorner(size, size);
    A = J.transpose() * MJ + Lambda;
    const Eigen::VectorXd b = -J.transpose() * screen.answered(e) - Lambda * (point - space.mean).tail(size);
    double gain = 0.0;
    for (int attempt = 0; attempt < 4 && gain == 0.0; ++attempt, damping = std::max(10.0 * damping, 1e-3)) {
      Eigen::MatrixXd damped = A;
      damped.diagonal() *= 1.0 + damping;
      Point moved = point;
      moved.tail(size) += damped.ldlt().solve(b);
      if (!moved.allFinite()) continue;
      moved = space.clamped(moved);
      const Eigen::VectorXd there = residuals_if_any(trial, hypothesis, moved, screen.passes);
      const double cost_there = screen.cost(there) + prior(moved);
      if (!(cost_there < cost)) continue;
      gain = cost - cost_there;
      point = moved, e = there, cost = cost_there;
      damping = std::max(damping / 100.0, 1e-7);
    }
    if (gain < 0.5) break;
  }
  const double occam = 0.5 * (log_determinant(space.precision.bottomRightCorner(size, size)) - log_determinant(A));
  return {0.5 * (before - cost) + occam, {point.data() + base, point.data() + point.size()}, A.inverse()};
}

Eigen::MatrixXd information(const Trial& trial, const Screen& screen, const EffectForm& form) {
  constexpr double step = 0.1;
  const auto size = static_cast<Eigen::Index>(form.coordinates.size());
  Eigen::MatrixXd J(trial.rows(), size);
  std::vector<double> null;
  for (const auto& c : form.coordinates) null.push_back(c.centre);
  for (Eigen::Index i = 0; i < size; ++i) {
    auto moved = null;
    moved[static_cast<std::size_t>(i)] += step;
    J.col(i) = (residuals_of(trial, ship_at(trial, {&form}, with_start(screen.baseline, moved)), screen.passes) -
                screen.residuals) /
               step;
  }
  return J.transpose() * screen.projected(J);
}

}  // namespace swayaw
