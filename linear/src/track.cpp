#include "swayaw/linear/track.hpp"

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "swayaw/linear/rudder_history.hpp"

namespace swayaw::inline linear {
namespace {

struct Way {
  double x;
  double y;
};

Way operator+(const Way& a, const Way& b) { return {a.x + b.x, a.y + b.y}; }

/// Integrals of cos and sin of the course along a leg.
class CourseIntegral {
 public:
  CourseIntegral(const LinearResponse<double>& ship, const Leg<double>& leg) : ship_(ship), leg_(leg) {}

  Way between(double from, double to) const { return refined(from, to, rule(from, to), 16); }

 private:
  Way at(double s) const {
    const auto x = state_after(ship_, leg_.start, leg_.rudder, s);
    return {std::cos(x.psi - x.beta), std::sin(x.psi - x.beta)};
  }

  /// 15 points: exact for polynomials up to degree 29.
  Way rule(double from, double to) const {
    using Gauss = boost::math::quadrature::gauss<double, 15>;
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
    Way sum{0.0, 0.0};
    const auto add = [&](double weight, const Way& w) { sum = sum + Way{weight * half * w.x, weight * half * w.y}; };
    add(Gauss::weights()[0], at(middle));
    for (std::size_t i = 1; i < Gauss::abscissa().size(); ++i) {
      add(Gauss::weights()[i], at(middle - half * Gauss::abscissa()[i]));
      add(Gauss::weights()[i], at(middle + half * Gauss::abscissa()[i]));
    }
    return sum;
  }

  Way refined(double from, double to, const Way& whole, int halvings) const {
    const double middle = 0.5 * (from + to), allowed = 1e-14 * (1.0 + to - from);
    const Way first = rule(from, middle), second = rule(middle, to), both = first + second;
    if (halvings == 0 || std::hypot(both.x - whole.x, both.y - whole.y) <= allowed) return both;
    return refined(from, middle, first, halvings - 1) + refined(middle, to, second, halvings - 1);
  }

  const LinearResponse<double>& ship_;
  const Leg<double>& leg_;
};

}  // namespace

TrackPoint run_along(const LinearResponse<double>& ship, const Leg<double>& leg, double length) {
  const Way way = CourseIntegral(ship, leg).between(0.0, length);
  return {way.x, way.y, state_after(ship, leg.start, leg.rudder, length).psi};
}

std::vector<TrackPoint> track(const LinearResponse<double>& ship, const std::vector<Leg<double>>& legs,
                              const std::vector<double>& times) {
  std::vector<TrackPoint> starts{{0.0, 0.0, 0.0}};
  for (const auto& leg : legs) {
    const auto run = run_along(ship, leg, leg.length);
    starts.push_back({starts.back().x + run.x, starts.back().y + run.y, run.psi});
  }
  std::vector<TrackPoint> points;
  points.reserve(times.size());
  for (const double s : times) {
    const auto& leg = leg_at(legs, s);
    const auto& start = starts[static_cast<std::size_t>(&leg - legs.data())];
    const auto run = run_along(ship, leg, s - leg.from);
    points.push_back({start.x + run.x, start.y + run.y, run.psi});
  }
  return points;
}

}  // namespace swayaw::linear
