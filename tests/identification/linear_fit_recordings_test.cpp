#include <catch.hpp>

#include "files.hpp"
#include "swayaw/core/recording_csv.hpp"
#include "swayaw/identification/linear_fit.hpp"

/// The free-running KVLCC2 models of HSVA and MARIN (SIMMAN 2008).
namespace swayaw {
namespace {

LinearFit fitted(const std::filesystem::path& folder, const std::string& name, double spacing = 0.1) {
  return fit_linear(read_recording(folder / name).recording, {.L = 7.0, .spacing = spacing});
}

TEST_CASE("the KVLCC2 looks stable in her large zigzags and not in the small ones", "[identification][published]") {
  const auto folder = test::benchmark_recordings("kvlcc2");
  if (!folder) return;
  const auto small = fitted(*folder, "hsva_zz10_01_stbd.csv");
  CHECK(small.status == FitStatus::converged);
  CHECK(small.probability_stable < 0.1);
  for (const auto* name :
       {"hsva_zz20_10_port.csv", "hsva_zz20_10_stbd.csv", "hsva_zz30_05_stbd.csv", "marin_zz20_20_stbd.csv"}) {
    INFO(name);
    const auto large = fitted(*folder, name);
    CHECK(large.status == FitStatus::converged);
    CHECK(large.probability_stable > 0.99);
    CHECK(large.amplitude.omega > small.amplitude.omega);
    CHECK(large.transfer.e0.value > small.transfer.e0.value + 0.3);
  }
}

TEST_CASE("what a recording determines does not hang on how densely it is used", "[identification][second-route]") {
  const auto folder = test::benchmark_recordings("kvlcc2");
  if (!folder) return;
  for (const auto* name : {"hsva_zz10_01_stbd.csv", "hsva_zz20_10_stbd.csv"}) {
    INFO(name);
    const auto dense = fitted(*folder, name, 0.1), thin = fitted(*folder, name, 0.25);
    CHECK_THAT(thin.transfer.e0.value, WithinAbs(dense.transfer.e0.value, 2.0 * dense.transfer.e0.standard_error));
    CHECK_THAT(thin.indices.T3w.value, WithinAbs(dense.indices.T3w.value, 2.0 * dense.indices.T3w.standard_error));
    CHECK_THAT(thin.coefficients.c2.value,
               WithinAbs(dense.coefficients.c2.value, 2.0 * dense.coefficients.c2.standard_error));
  }
}

TEST_CASE("zigzags begun to port and to starboard give the same ship within their errors",
          "[identification][second-route]") {
  const auto folder = test::benchmark_recordings("kvlcc2");
  if (!folder) return;
  const auto port = fitted(*folder, "hsva_zz20_10_port.csv"), starboard = fitted(*folder, "hsva_zz20_10_stbd.csv");
  const auto agree = [](const Estimate& a, const Estimate& b) {
    return std::abs(a.value - b.value) < 2.0 * std::hypot(a.standard_error, b.standard_error);
  };
  CHECK(agree(port.transfer.e0, starboard.transfer.e0));
  CHECK(agree(port.indices.Kw, starboard.indices.Kw));
  CHECK(agree(port.indices.T3b, starboard.indices.T3b));
  CHECK(agree(port.indices.T3w, starboard.indices.T3w));
}

}  // namespace
}  // namespace swayaw
