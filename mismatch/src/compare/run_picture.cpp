#include "swayaw/mismatch/run_picture.hpp"

#include <algorithm>
#include <cmath>

#include "swayaw/core/detail/matrices.hpp"
#include "swayaw/core/parallel.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/identification/map_fit.hpp"
#include "swayaw/identification/state_estimate.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"
#include "swayaw/nonlinear/replay.hpp"

namespace swayaw::inline mismatch {
namespace {

constexpr std::size_t most_points = 500;

// ---------------------------------------------------------------- force

/// M of M a = F, from the accelerations that unit forces give the resting ship.
template <class Model>
Eigen::Matrix3d mass_matrix(const Model& model) {
  Eigen::Matrix3d mobility;
  for (int i = 0; i < 3; ++i) {
    const auto a = acceleration(model, PlanarMotion<double>{},
                                PlanarForce<double>{i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0});
    mobility.col(i) << a.u, a.v, a.r;
  }
  return core::detail::inverse(mobility);
}

Eigen::Vector3d deviations(const Eigen::Matrix3d& covariance) {
  return covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
}

PlanarAcceleration<double> as_acceleration(const Eigen::Vector3d& a) { return {a[0], a[1], a[2]}; }

PlanarForce<double> as_force(const Eigen::Vector3d& f) { return {f[0], f[1], f[2]}; }

MissingForce missing_force_of(const EstimatedState& state, const Eigen::Matrix3d& M) {
  const Eigen::Vector3d a(state.unmodelled.u, state.unmodelled.v, state.unmodelled.r);
  const auto spread = state.covariance.of<3>(6);
  return {.motion = state.state.motion,
          .acceleration = as_acceleration(a),
          .acceleration_deviation = as_acceleration(deviations(spread)),
          .force = as_force(M * a),
          .force_deviation = as_force(deviations(M * spread * M.transpose()))};
}

// ---------------------------------------------------------------- fewer points

/// Samples evenly through a run, the first and the last among them.
std::vector<std::size_t> kept_samples(std::size_t samples) {
  const std::size_t points = std::min(samples, most_points);
  std::vector<std::size_t> kept{0};
  for (std::size_t i = 1; i < points; ++i) kept.push_back(i * (samples - 1) / (points - 1));
  return kept;
}

template <class Value>
std::vector<Value> thinned(const std::vector<Value>& values, const std::vector<std::size_t>& kept) {
  std::vector<Value> result;
  if (!values.empty())
    for (const auto i : kept) result.push_back(values[i]);
  return result;
}

/// Of values at some times, those nearest to others.
template <class Value>
std::vector<Value> near_to(const std::vector<Value>& values, std::span<const double> times,
                           std::span<const double> others) {
  std::vector<Value> result;
  std::size_t k = 0;
  for (const double time : others) {
    while (k + 1 < times.size() && std::abs(times[k + 1] - time) <= std::abs(times[k] - time)) ++k;
    result.push_back(values[k]);
  }
  return result;
}

/// Samples to keep; where one is missing, the next that is there before the next one kept, so that a slow channel
/// stays.
Recording thinned(const Recording& run, const std::vector<std::size_t>& kept) {
  Recording result{.name = run.name, .facts = run.facts, .time = thinned(run.time, kept), .channels = {}, .extra = {}};
  for (std::size_t c = 0; c < channel_count; ++c) {
    const auto& values = run.channels[c];
    if (values.empty()) continue;
    for (std::size_t k = 0; k < kept.size(); ++k) {
      const auto end = values.begin() + static_cast<std::ptrdiff_t>(k + 1 < kept.size() ? kept[k + 1] : run.samples());
      const auto there = std::find_if(values.begin() + static_cast<std::ptrdiff_t>(kept[k]), end,
                                      [](double x) { return !std::isnan(x); });
      result.channels[c].push_back(there == end ? swayaw::missing : *there);
    }
  }
  return result;
}

// ---------------------------------------------------------------- pictures

/// What an estimate or a replay gives, or nothing where the ship or the run does not allow it.
template <class F>
auto unless_refused(F&& f) -> std::optional<decltype(f())> {
  try {
    return f();
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

/// A run with every channel that shows her motion.
PreparedRun prepared(const Ship& ship, const Recording& run, bool lean) {
  const auto channels = recorded_channels({&run, 1}, motion_channels());
  return (lean ? lean_runs : prepared_runs)(ship, {&run, 1}, channels).front();
}

}  // namespace

std::vector<MissingForce> missing_force(const Ship& ship, const Recording& run, const Noise& noise) {
  return missing_force(ship, prepared(ship, run, false), noise);
}

std::vector<MissingForce> missing_force(const Ship& ship, const PreparedRun& prepared, const Noise& noise) {
  EstimationOptions options{.channels = prepared.channels,  // whose noise is known
                            .process_noise = ProcessNoise{process_noise(ship, noise)},
                            .memory = noise.memory};
  for (const auto channel : prepared.channels)
    options.noise[index_of(channel)] = prepared.deviation[index_of(channel)] * noise.factor[index_of(channel)];
  for (const auto channel : {Channel::x, Channel::y})  // what positions wander, as if it were white
    if (auto& size = options.noise[index_of(channel)]) *size = std::hypot(*size, noise.walk * length(ship));
  const auto M = visit_acting(ship, [](const auto& acting) { return mass_matrix(acting.model); });
  std::vector<MissingForce> result;
  for (const auto& state : estimate_states(ship, *prepared.run, options).states)
    result.push_back(missing_force_of(state, M));
  return result;
}

PlanarForce<double> ordinary_force(const Ship& ship) {
  Noise noise;
  noise.scale = 1.0;
  const auto size = process_noise(ship, noise);
  const Eigen::Matrix3d spread = Eigen::Vector3d(size.u * size.u, size.v * size.v, size.r * size.r).asDiagonal();
  return visit_acting(ship, [&](const auto& acting) {
    const auto M = mass_matrix(acting.model);
    return as_force(deviations(M * spread * M.transpose()));
  });
}

RunPicture run_picture(const Ship& given, const Ship& refitted, const Ship& after, const Recording& run,
                       const Noise& noise) {
  const auto kept = kept_samples(run.samples());
  const auto lacking = [&](const Ship& ship) {
    return unless_refused([&] {
             const auto samples = prepared(ship, run, noise.with_memory);
             return near_to(missing_force(ship, samples, noise), samples.run->time, thinned(run.time, kept));
           })
        .value_or(std::vector<MissingForce>{});
  };
  const auto replayed = [&](const Ship& ship) {
    return unless_refused([&] { return thinned(replay(ship, run), kept); });
  };
  return {.run = run.name,
          .recorded = thinned(run, kept),
          .missing_before = lacking(refitted),
          .missing_after = lacking(after),
          .given = replayed(given),
          .refitted = replayed(refitted),
          .after = replayed(after)};
}

std::vector<RunPicture> run_pictures(const Ship& given, const ShipInRun& refitted, const ShipInRun& after,
                                     std::span<const Recording> runs, const Noise& noise) {
  std::vector<RunPicture> pictures(runs.size());
  in_parallel(runs.size(), 0, [&](std::size_t i) {
    pictures[i] = run_picture(given, refitted(runs[i]), after(runs[i]), runs[i], noise);
  });
  return pictures;
}

}  // namespace swayaw::mismatch
