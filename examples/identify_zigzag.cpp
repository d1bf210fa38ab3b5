// Which linear equations of sway and yaw explain these zigzags, and which of their constants does each recording
// determine?
//
//   identify_zigzag LENGTH_M RECORDING.csv…           one report for each recording
//   identify_zigzag --table LENGTH_M RECORDING.csv…   one line of a Markdown table for each, with drift and without
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/recording_csv.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/identification/linear_fit.hpp"
#include "swayaw/identification/nomoto_zigzag.hpp"

namespace {

using namespace swayaw;

/// Value and standard error, two digits of the latter.
std::string text(const Estimate& e) {
  if (std::isnan(e.value)) return "-";
  const int decimals = std::clamp(1 - static_cast<int>(std::floor(std::log10(e.standard_error))), 0, 9);
  return fmt::format("{:.{}f} ± {:.{}f}", e.value, decimals, e.standard_error, decimals);
}

using Named = std::pair<const char*, Estimate>;

std::array<Named, 6> named(const SwayYawCoefficients<Estimate>& m) {
  return {Named{"a1", m.a1}, {"b1", m.b1}, {"c1", m.c1}, {"a2", m.a2}, {"b2", m.b2}, {"c2", m.c2}};
}

/// Names of the constants that are determined, weakly determined ones in brackets.
std::string determined(const SwayYawCoefficients<Estimate>& m) {
  std::string names;
  for (const auto& [name, constant] : named(m)) {
    if (constant.verdict() == Verdict::determined) names += fmt::format("{} ", name);
    if (constant.verdict() == Verdict::weakly_determined) names += fmt::format("({}) ", name);
  }
  return names.empty() ? "none" : names.substr(0, names.size() - 1);
}

void line(const char* name, const Estimate& e) {
  fmt::print("  {:<5} {:<22} {}\n", name, text(e), in_words(e.verdict()));
}

void print_report(const Recording& run, const LinearFit& fit) {
  const auto& a = fit.amplitude;
  fmt::print("{}: {} samples, L/U {:.4g} s, rudder up to {:.1f} deg, drift {:.1f} deg, r' {:.2f}\n", run.name,
             fit.samples, fit.scale.L / fit.scale.U, degrees(a.rudder), degrees(a.drift), a.omega);
  for (const auto& [name, e] : named(fit.coefficients)) line(name, e);
  if (fit.time_constants) {
    line("T1'", fit.time_constants->T1);
    line("T2'", fit.time_constants->T2);
  }
  const auto& i = fit.indices;
  for (const auto& [name, e] : {Named{"T3b'", i.T3b}, {"T3w'", i.T3w}, {"Kb", i.Kb}, {"Kw'", i.Kw}}) line(name, e);
  fmt::print("  rudder offset {:.2f} ± {:.1g} deg\n", degrees(fit.rudder_offset.value),
             degrees(fit.rudder_offset.standard_error));
  fmt::print("  known best {}, worst {}\n", fit.best_combination, fit.worst_combination);
  fmt::print("  {} for motions of this size, probability {:.3f}\n", fit.stable ? "stable" : "unstable",
             fit.stable ? fit.probability_stable : 1.0 - fit.probability_stable);
}

/// K' and T' of Nomoto's analysis, if the run has enough peaks.
std::string nomoto(const Recording& run, const PrimeScale& scale) {
  try {
    const auto n = nomoto_zigzag_analysis(run);
    return fmt::format("{:.2f} | {:.2f}", n.K * scale.L / scale.U, n.T * scale.U / scale.L);
  } catch (const Refusal&) {
    return "- | -";
  }
}

void print_row(const Recording& run, const LinearFit& fit, const LinearFit& yaw) {
  const auto& i = fit.indices;
  const auto times = fit.time_constants.value_or(TimeConstants<Estimate>{});
  fmt::print("| {} | {:.0f} | {:.1f} | {:.2f} | {} | {} | {} | {} | {} | {} | {} | {:.2f} | {} | {} | {} |\n", run.name,
             degrees(fit.amplitude.rudder), degrees(fit.amplitude.drift), fit.amplitude.omega, text(times.T1),
             text(times.T2), text(i.T3b), text(i.T3w), text(i.Kb), text(i.Kw), text(fit.transfer.e0),
             fit.probability_stable, determined(fit.coefficients), text(yaw.transfer.e0), nomoto(run, fit.scale));
}

}  // namespace

int main(int count, char** arguments) {
  const bool table = count > 1 && std::string(arguments[1]) == "--table";
  const int first = table ? 2 : 1;
  if (count < first + 2) return fmt::print(stderr, "identify_zigzag [--table] LENGTH_M RECORDING.csv…\n"), 1;
  const double L = std::stod(arguments[first]);
  if (table)
    fmt::print(
        "| run | rudder, deg | drift, deg | r' | T1' | T2' | T3b' | T3w' | Kb | Kw' | e0 | P(stable) | determined "
        "(weakly) | e0, yaw alone | Nomoto K' | Nomoto T' |\n"
        "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | --- | ---: | ---: | ---: "
        "|\n");
  for (int k = first + 1; k < count; ++k) {
    const auto run = read_recording(arguments[k]).recording;
    const auto fit = fit_linear(run, {.L = L});
    if (table) print_row(run, fit, fit_linear(run, {.L = L, .use_drift = false}));
    else print_report(run, fit);
  }
}
