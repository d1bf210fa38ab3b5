#include <algorithm>
#include <cmath>

#include "relations.hpp"
#include "run_motion.hpp"
#include "swayaw/core/angle.hpp"

namespace swayaw::inline identification::detail {
namespace {

/// A factor and its standard error.
struct Proportional {
  double factor, standard_error;
};

/// Means of a series over blocks of equal time, from its integral.
std::vector<double> block_means(const std::vector<double>& time, const std::vector<double>& integrated, double block) {
  std::vector<double> means;
  double from = time.front();
  std::size_t k = 0;
  const auto at = [&](double t) {
    while (k + 2 < time.size() && time[k + 1] <= t) ++k;
    const double share = (t - time[k]) / (time[k + 1] - time[k]);
    return integrated[k] + share * (integrated[k + 1] - integrated[k]);
  };
  for (double before = at(from); from + block <= time.back(); from += block) {
    const double after = at(from + block);
    means.push_back((after - before) / block);
    before = after;
  }
  return means;
}

/// Yaw rate and rudder as means over blocks.
struct Blocks {
  std::vector<double> r, delta;
  double length;  ///< [s]
};

Blocks blocks_of(const Recording& run, Channel rudder) {
  constexpr double blocks = 80.0, fewest = 3.0;  // of a manoeuvre; samples in each
  constexpr double turned = 0.3;                 // [rad] in a block of a long log, hard over
  const double shorter = std::min((run.time.back() - run.time.front()) / blocks, turned / hard_yaw_rate(run));
  const double length = std::max(shorter, fewest * usual_step(run.time));
  return {block_means(run.time, filled(run, Channel::psi), length),
          block_means(run.time, integral(run.time, filled(run, rudder)), length), length};
}

/// a of r_{k+1} − r_k = a (delta_k − delta_{k−1}), with the errors as large as they are (HC3): one large movement alone
/// tells nothing of its error.
std::optional<Proportional> answer(const Blocks& b) {
  double xx = 0.0, xy = 0.0, scores = 0.0;
  const auto moved = [&](std::size_t k) { return b.delta[k] - b.delta[k - 1]; };
  const auto changed = [&](std::size_t k) { return b.r[k + 1] - b.r[k]; };
  for (std::size_t k = 1; k + 1 < b.r.size(); ++k) {
    xx += moved(k) * moved(k);
    xy += moved(k) * changed(k);
  }
  if (xx == 0.0) return {};
  const double a = xy / xx;
  for (std::size_t k = 1; k + 1 < b.r.size(); ++k) {
    const double leverage = moved(k) * moved(k) / xx;
    scores += std::pow(moved(k) * (changed(k) - a * moved(k)) / std::max(1.0 - leverage, 1e-3), 2);
  }
  return Proportional{a, std::sqrt(scores) / xx};
}

/// Heading turned to the side of the rudder while it was held hard over [rad]: every ship turns with a hard rudder.
double turned_with(const Blocks& b) {
  constexpr std::size_t held = 10;  // blocks, an eighth of the manoeuvre: the yaw rate has settled
  const double hard = 0.5 * std::abs(std::ranges::max(b.delta, {}, [](double d) { return std::abs(d); }));
  double turned = 0.0;
  std::size_t since = 0;
  for (std::size_t k = 0; k < b.r.size(); ++k) {
    const bool over = std::abs(b.delta[k]) > hard && (k == 0 || b.delta[k] * b.delta[k - 1] > 0.0);
    since = over ? since + 1 : 0;
    if (since > held) turned -= std::copysign(b.r[k] * b.length, b.r[k] * b.delta[k]);
  }
  return turned;
}

}  // namespace

std::optional<bool> rudder_is_reversed(const Recording& run) {
  // standard deviations: of 195 recordings of all kinds 192 lie beyond, on the right side, and none beyond 2.4 on the
  // wrong
  constexpr double certain = 3.5;
  constexpr double quarter_turn = 0.5 * pi;  // [rad]
  constexpr double least = radians(2.0);     // of rudder; less shows a neutral angle and not a manoeuvre
  const Channel rudder = run.has(Channel::delta) ? Channel::delta : Channel::delta_order;
  const auto blocks = blocks_of(run, rudder);
  const auto [low, high] = std::ranges::minmax(blocks.delta);
  if (std::max(-low, high) < least) return {};
  if (const double turned = turned_with(blocks); std::abs(turned) > quarter_turn) return turned < 0.0;
  const auto a = answer(blocks);
  if (!a || std::abs(a->factor) < certain * a->standard_error) return {};
  return a->factor > 0.0;
}

}  // namespace swayaw::identification::detail
