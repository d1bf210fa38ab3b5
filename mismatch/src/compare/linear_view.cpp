#include "swayaw/mismatch/linear_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/identification/nomoto_zigzag.hpp"
#include "swayaw/nonlinear/replay.hpp"

namespace swayaw::inline mismatch {
namespace {

struct Path {
  std::vector<double> beta, r_prime;
  double speed;  ///< mean [m/s]
};

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

Path path_of(const std::vector<PlanarMotion<double>>& motions, double L) {
  Path path{{}, {}, 0.0};
  for (const auto& m : motions) {
    const double U = std::isfinite(m.v) ? std::hypot(m.u, m.v) : m.u;
    path.beta.push_back(drift_angle(m)), path.r_prime.push_back(m.r * L / U);
    path.speed += U / static_cast<double>(motions.size());
  }
  return path;
}

/// Area by the shoelace formula over the number of periods, half the changes of sign of the yaw rate.
double loop_area(const Path& p) {
  double area = 0.0;
  int changes = 0;
  for (std::size_t i = 1; i < p.beta.size(); ++i) {
    area += 0.5 * (p.beta[i] + p.beta[i - 1]) * (p.r_prime[i] - p.r_prime[i - 1]);
    if (p.r_prime[i] * p.r_prime[i - 1] < 0.0) ++changes;
  }
  return changes < 2 ? missing : -area / (0.5 * changes);
}

ZigzagView view_of(const Recording& run, const Path& path, double L) {
  const auto n = nomoto_zigzag_analysis(run);
  return {n.K * L / path.speed, n.T * path.speed / L, n.delta_r, loop_area(path)};
}

/// Motion as recorded; without a sway velocity there is no drift and no loop, and the log tells the speed.
std::vector<PlanarMotion<double>> motions_of(const Recording& run, double service_speed) {
  const auto u = run.has(Channel::u) ? Channel::u : Channel::speed_through_water;
  const bool whole = run.has(Channel::v) && run.has(Channel::r);
  std::vector<PlanarMotion<double>> motions;
  for (std::size_t i = 0; i < run.samples(); ++i)
    motions.push_back({run.has(u) ? run[u][i] : service_speed, whole ? run[Channel::v][i] : missing,
                       whole ? run[Channel::r][i] : missing});
  return motions;
}

std::optional<LinearView> view_of_run(const Ship& model, const Recording& run) try {
  const double L = length(model), U = service_speed(model);
  const auto simulated = replay(model, run);
  double amplitude = 0.0;
  for (const double delta : run[run.has(Channel::delta) ? Channel::delta : Channel::delta_order])
    amplitude = std::max(amplitude, std::isfinite(delta) ? std::abs(delta) : 0.0);
  return LinearView{run.name, amplitude, view_of(run, path_of(motions_of(run, U), L), L),
                    view_of(simulated, path_of(motions_of(simulated, U), L), L)};
} catch (const std::exception&) {  // no zigzag, or one that she cannot sail
  return std::nullopt;
}

double mean_of(std::span<const LinearView> views, auto&& value) {
  double sum = 0.0;
  for (const auto& v : views) sum += value(v) / static_cast<double>(views.size());
  return sum;
}

}  // namespace

std::vector<LinearView> linear_view(const Ship& model, std::span<const Recording> runs) {
  std::vector<LinearView> views;
  for (const auto& run : runs)
    if (const auto view = view_of_run(model, run)) views.push_back(*view);
  return views;
}

namespace {

// Below these a difference is not worth words: see linear_view.hpp. No decision hangs on them.
constexpr double told_offset = radians(0.3);  ///< rudder
constexpr double told_ratio = 0.1;            ///< of K and of the area of the loop
constexpr double harder = 1.5;                ///< amplitude over the gentlest, as 15/15 is beside 10/10

}  // namespace

std::string words_of(std::span<const LinearView> views) {
  if (views.empty()) return {};
  std::vector<std::string> said;
  const double offset = mean_of(views, [](const LinearView& v) { return v.recorded.delta_r - v.model.delta_r; });
  if (std::abs(offset) > told_offset)
    said.push_back(fmt::format("a constant acts like a rudder offset to {}", offset > 0.0 ? "port" : "starboard"));
  const auto gain = [](const LinearView& v) { return v.recorded.K / v.model.K; };
  const auto [gentle, hard] = std::ranges::minmax_element(views, {}, &LinearView::amplitude);
  if (hard->amplitude > harder * gentle->amplitude && std::abs(gain(*hard) - gain(*gentle)) > told_ratio)
    said.push_back(
        fmt::format("the gain K is {:.2f} times the model's in the gentlest zigzag and {:.2f} in the hardest, which a "
                    "nonlinear term does",
                    gain(*gentle), gain(*hard)));
  else if (const double K = mean_of(views, gain); std::abs(K - 1.0) > told_ratio)
    said.push_back(fmt::format(
        "the gain K is {:.2f} times the model's whatever the amplitude, which a linear coefficient or the rudder does",
        K));
  const double loop = mean_of(views, [](const LinearView& v) { return v.recorded.loop_area / v.model.loop_area; });
  if (std::isfinite(loop) && std::abs(loop - 1.0) > told_ratio)
    said.push_back(fmt::format(
        "the drift-yaw loop has {:.2f} times the model's area, which T3 or a force that follows late does", loop));
  std::string words;
  for (const auto& s : said) words += (words.empty() ? "By K, T and the drift-yaw loop: " : "; ") + s;
  return words.empty() ? words : words + ".";
}

}  // namespace swayaw::mismatch
