#include <algorithm>
#include <cmath>

#include "relations.hpp"
#include "run_motion.hpp"

namespace swayaw::inline identification::detail {
namespace {

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

}  // namespace

std::optional<InstrumentError> rudder_sign(const Recording& run) {
  constexpr double blocks = 80.0, fewest = 3.0;  // of a manoeuvre; samples in each
  const Channel rudder = run.has(Channel::delta) ? Channel::delta : Channel::delta_order;
  const double duration = run.time.back() - run.time.front();
  const double block = std::max(duration / blocks, fewest * usual_step(run.time));
  const auto r = block_means(run.time, filled(run, Channel::psi), block);
  const auto delta = block_means(run.time, integral(run.time, filled(run, rudder)), block);
  // r_{k+1} − r_k = a (delta_k − delta_{k−1}), the errors as large as they are
  double xx = 0.0, xy = 0.0;
  for (std::size_t k = 1; k + 1 < r.size(); ++k) {
    const double moved = delta[k] - delta[k - 1];
    xx += moved * moved;
    xy += moved * (r[k + 1] - r[k]);
  }
  if (xx == 0.0) return {};
  const double a = xy / xx;
  double scores = 0.0;
  for (std::size_t k = 1; k + 1 < r.size(); ++k) {
    const double moved = delta[k] - delta[k - 1], left = r[k + 1] - r[k] - a * moved;
    scores += moved * moved * left * left;
  }
  return InstrumentError{rudder, InstrumentErrorKind::sign, a, std::sqrt(scores) / xx};
}

}  // namespace swayaw::identification::detail
