#include <array>
#include <catch.hpp>

#include "linear_recordings.hpp"
#include "swayaw/identification/linear_fit.hpp"
#include "swayaw/linear/indices.hpp"

/// Do the 95 % intervals of a fit hold the truth, over ships of every kind?
namespace swayaw {
namespace {

using test::listed;

template <class T>
std::array<T, 6> listed(const SteeringIndices<T>& i) {
  return {i.T1T2, i.T1_plus_T2, i.T3b, i.T3w, i.Kb, i.Kw};
}

template <class T>
std::array<T, 4> of_yaw(const SwayYawTransfer<T>& h) {
  return {h.e0, h.e1, h.nw0, h.nw1};
}

/// The run with white noise: of heading and drift 0.1 deg, of yaw rate 2 % of the largest.
Recording noisy(Recording run, unsigned seed) {
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal;
  const auto r = run.fill(Channel::r);
  const double angle = radians(0.1), rate = 0.02 * std::max(std::ranges::max(r), -std::ranges::min(r));
  for (double& x : run.fill(Channel::psi)) x += angle * normal(engine);
  for (double& x : r) x += rate * normal(engine);
  for (double& x : run.fill(Channel::v)) x += angle * test::ship_speed * normal(engine);  // v = −U sin(beta)
  return run;
}

/// How often the 95 % interval of each constant holds the truth.
template <std::size_t N>
struct Coverage {
  std::array<int, N> inside{};
  int ships = 0;

  void add(const std::array<Estimate, N>& found, const std::array<double, N>& truth) {
    ++ships;
    for (std::size_t i = 0; i < N; ++i)
      inside[i] += std::abs(found[i].value - truth[i]) < 1.96 * found[i].standard_error;
  }
  double share(std::size_t i) const { return static_cast<double>(inside[i]) / ships; }
};

template <std::size_t N>
void check(const char* what, const Coverage<N>& coverage, double least, double most) {
  for (std::size_t i = 0; i < N; ++i) {
    INFO(what << ", constant " << i << " of " << coverage.ships << " ships");
    CHECK(coverage.share(i) >= least);
    CHECK(coverage.share(i) <= most);
  }
}

TEST_CASE(
    "of 200 ships, 0.1 deg of noise on heading and 2 % on yaw rate, each constant lies in its 95 % interval for 90 to "
    "99 %",
    "[identification][second-route]") {
  Coverage<6> coefficients, indices, stable, unstable;
  unsigned seed = 0;
  for (const auto& [ship, clean] : test::random_zigzags(200)) {
    const auto fit = fit_linear(noisy(clean, ++seed), {.L = test::ship_length});
    REQUIRE(fit.status == FitStatus::converged);
    coefficients.add(listed(fit.coefficients), listed(ship));
    indices.add(listed(fit.indices), listed(steering_indices(ship)));
    (is_stable(ship) ? stable : unstable).add(listed(fit.coefficients), listed(ship));
  }
  REQUIRE(unstable.ships >= 40);
  check("coefficients", coefficients, 0.90, 0.99);
  check("indices", indices, 0.90, 0.99);
  check("coefficients of stable ships", stable, 0.90, 0.99);
  // of so few unstable ships, three standard deviations below 95 % are 86 %
  check("coefficients of unstable ships", unstable, 0.86, 1.0);
}

TEST_CASE("heading and yaw rate alone do the same for the four constants of yaw", "[identification][second-route]") {
  Coverage<4> coverage;
  unsigned seed = 0;
  for (const auto& [ship, clean] : test::random_zigzags(200)) {
    const auto fit = fit_linear(noisy(clean, ++seed), {.L = test::ship_length, .use_drift = false});
    REQUIRE(fit.status == FitStatus::converged);
    coverage.add(of_yaw(fit.transfer), of_yaw(transfer_functions(ship)));
  }
  check("yaw", coverage, 0.90, 0.99);
}

}  // namespace
}  // namespace swayaw
