#include <algorithm>
#include <catch.hpp>
#include <cmath>

#include "files.hpp"
#include "swayaw/app/sweep/reduce.hpp"
#include "swayaw/app/sweep/run.hpp"

namespace swayaw::app {
namespace {

SweepPlan parsed(const std::string& text) { return parse_sweep_plan(text, test::ships / "plan.toml"); }

SweepSummary swept(const SweepWork& work, SweepStore& store) {
  run_sweep(work, store, 2, [](const SweepCount&) { return true; });
  return summary_of(store, work);
}

std::size_t place_of(const SweepWork& work, const std::string& column) {
  const auto found = std::ranges::find(work.columns(), column, &SweepColumn::name);
  REQUIRE(found != work.columns().end());
  return static_cast<std::size_t>(found - work.columns().begin());
}

TEST_CASE("quantiles and extremes are those of the sorted values", "[sweep]") {
  const test::Scratch scratch;
  const SweepWork work(
      parsed("task = \"indices\"\nships = [\"tanker97_nomoto.toml\"]\ndraws = 10001\nconfidence = true\n"));
  SweepStore store(scratch / "out", work);
  const auto summary = swept(work, store);
  for (const auto& s : summary.columns) {
    auto sorted = store.column(0, s.column);
    const auto values = sorted;
    std::erase_if(sorted, [](double x) { return !std::isfinite(x); });
    CHECK(s.count == sorted.size());
    CHECK(s.count + s.missing == 10001);
    std::ranges::sort(sorted);
    if (s.missing > 0) continue;
    for (std::size_t q = 0; q < summary_quantiles.size(); ++q) {
      const double place = 10000.0 * summary_quantiles[q];
      CHECK(s.quantile[q] == sorted[static_cast<std::size_t>(std::lround(place))]);
    }
    CHECK(s.low == sorted.front());
    CHECK(s.high == sorted.back());
    CHECK(values[s.highest[0].item] == s.high);
    CHECK(s.highest[1].value == sorted[9999]);
    CHECK(s.lowest[2].value == sorted[2]);
    std::size_t in_bins = 0;
    for (const auto n : s.histogram) in_bins += n;
    CHECK(in_bins == s.count);
  }
}

TEST_CASE("sensitivity indices are those of closed forms and quadrature", "[sweep]") {
  const test::Scratch scratch;
  const SweepWork work(
      parsed("task = \"indices\"\nships = [\"tanker97_nomoto.toml\"]\ndesign = \"sobol\"\npairs = 20000\n"
             "[vary]\nT1T2 = { from = 1.0, to = 3.0 }\nT1_plus_T2 = { from = 5.0, to = 7.0 }\n"
             "Kw = { from = 1.0, to = 2.0 }\n"));
  SweepStore store(scratch / "out", work);
  const auto summary = swept(work, store);
  CHECK(summary.pairs_left_out == 0);
  // the yaw gain is drawn alone: all of its variance is its own, and none of the others'
  const auto gain = place_of(work, "Kw");
  for (const auto& s : summary.sobol) {
    if (s.result != gain) continue;
    const double truth = work.columns()[s.parameter].name == "Kw_given" ? 1.0 : 0.0;
    CHECK_THAT(s.total, WithinAbs(truth, 0.02));
    CHECK(s.first_low <= truth + 1e-12);
    CHECK(s.first_high >= truth - 1e-12);
  }
  // T_w = T1 + T2 − T3w of the first order: the sum alone
  const auto T_w = place_of(work, "T_w");
  for (const auto& s : summary.sobol)
    if (s.result == T_w) CHECK_THAT(s.total, WithinAbs(work.columns()[s.parameter].name == "T1_plus_T2_given", 0.02));
  // the larger time constant depends on both: T1 = (s + sqrt(s² − 4p))/2, whose indices by quadrature on a grid
  const auto T1 = [](double p, double s) { return 0.5 * (s + std::sqrt(s * s - 4.0 * p)); };
  constexpr int n = 400;
  std::vector<double> over_p(n, 0.0), over_s(n, 0.0);
  double mean = 0.0, squares = 0.0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double x = T1(1.0 + 2.0 * (i + 0.5) / n, 5.0 + 2.0 * (j + 0.5) / n);
      over_s[i] += x / n, over_p[j] += x / n;
      mean += x / (n * n), squares += x * x / (n * n);
    }
  const auto variance = [&](const std::vector<double>& values) {
    double sum = 0.0;
    for (const double x : values) sum += (x - mean) * (x - mean) / n;
    return sum;
  };
  const double all = squares - mean * mean;
  for (const auto& s : summary.sobol) {
    if (s.result != place_of(work, "T1")) continue;
    const auto name = work.columns()[s.parameter].name;
    const double truth = name == "T1T2_given"         ? variance(over_s) / all
                         : name == "T1_plus_T2_given" ? variance(over_p) / all
                                                      : 0.0;
    CHECK_THAT(s.first, WithinAbs(truth, 0.03));
    if (truth == 0.0) continue;
    CHECK(s.first_low < s.first);
    CHECK(s.first_high > s.first);
  }
}

}  // namespace
}  // namespace swayaw::app
