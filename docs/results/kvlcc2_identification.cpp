// The tables of docs/results/kvlcc2_identification.md.
//   kvlcc2_identification SHIPS_FOLDER FOLDER_WITH_KVLCC2_RECORDINGS FOLDER_FOR_TABLES
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/recording_csv.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/identification/captive.hpp"
#include "swayaw/identification/identify.hpp"
#include "swayaw/mismatch/compare.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/models/force_breakdown.hpp"
#include "swayaw/nonlinear/ship_file.hpp"

namespace {

using namespace swayaw;
namespace fs = std::filesystem;

const std::vector<std::string> trained_on{"hsva_zz10_10_port", "hsva_zz10_10_stbd", "hsva_zz20_10_port",
                                          "hsva_zz20_10_stbd"};
const std::vector<std::string> held_out{"hsva_zz05_01_stbd", "hsva_zz10_01_stbd",  "hsva_zz15_05_stbd",
                                        "hsva_zz30_05_stbd", "marin_zz10_10_port", "marin_zz20_20_stbd"};

/// A form of the model and the coefficients that it has.
struct Form {
  std::string name;
  Ship ship;
  ForceFitOptions options;
};

std::vector<Form> forms(const fs::path& ships) {
  const auto pi_ship = read_ship(ships / "kvlcc2_pi.toml"), pu_ship = in_model(pi_ship, "pu");
  const auto with = [](std::string name, const Ship& ship, std::vector<std::string> also, bool Y_r) {
    Form form{std::move(name), ship, {.parameters = usual_parameters(ship)}};
    if (!Y_r) std::erase(form.options.parameters, "Y_r");
    form.options.parameters.insert(form.options.parameters.end(), also.begin(), also.end());
    return form;
  };
  return {with("PI", pi_ship, {}, true), with("PI + vvr", pi_ship, {"Y_vvr", "N_vvr"}, true),
          with("PU", pu_ship, {}, false), with("PU + Y_r", pu_ship, {}, true),
          with("PU + Y_r, vvr", pu_ship, {"Y_vvr", "N_vvr"}, true)};
}

std::vector<Recording> recordings(const fs::path& folder, const std::vector<std::string>& names) {
  std::vector<Recording> runs;
  for (const auto& name : names) runs.push_back(read_recording(folder / (name + ".csv")).recording);
  return runs;
}

const Coefficient* coefficient(const ForceFit& fit, const std::string& name) {
  for (const auto& equation : fit.equations)
    for (const auto& c : equation.fit.coefficients)
      if (c.name == name) return &c;
  return nullptr;
}

std::string thousandths(double value, int digits = 2) { return fmt::format("{:.{}f}", 1e3 * value, digits); }

/// "-8.56 ± 0.17", or a dash.
std::string cell(const ForceFit& fit, const std::string& name) {
  const auto* c = coefficient(fit, name);
  return c ? fmt::format("{} ± {}{}", thousandths(c->estimate.value), thousandths(c->estimate.standard_error),
                         c->undetermined ? " (not determined)" : "")
           : "–";
}

double most(const ForceFit& fit, ForceComponent component, double (*measure)(const Regression&)) {
  return measure(std::ranges::find(fit.equations, component, &ForceEquation::component)->fit);
}

double condition(const Regression& r) { return r.condition_number; }

double inflation(const Regression& r) {
  double largest = 0.0;
  for (const auto& c : r.coefficients) largest = std::max(largest, c.variance_inflation);
  return largest;
}

using Points = std::vector<CaptivePoint>;

/// Steady drift with the rudder amidships in the towing tank of HMRI, as of a ship that long.
Points captive(const fs::path& folder, const Ship& ship) {
  return selected(read_captive(folder / "captive" / "hmri_static.csv",
                               {.L = length(ship), .towed_L = 320.0 / 46.426, .thrust_prime = 0.00122033}),
                  {.tests = {"static_drift"}});
}

std::string per_cent(double share) { return fmt::format("{:.0f} %", 100.0 * share); }

// ---------------------------------------------------------------- tables

std::string coefficients_table(const std::vector<Form>& all, const std::vector<ForceFit>& fits,
                               const fs::path& folder) {
  std::string text =
      "| form | Y_v | Y_r | N_v | N_r | condition Y / N | variance inflation Y / N | captive error Y / N, 12 deg | 30 "
      "deg | straight course |\n"
      "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | --- |\n";
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& fit = fits[i];
    const auto points = captive(folder, fit.ship);
    const auto small = captive_error(fit.ship, points, radians(12.0)),
               large = captive_error(fit.ship, points, radians(30.0));
    text +=
        fmt::format("| {} | {} | {} | {} | {} | {:.0f} / {:.0f} | {:.2g} / {:.2g} | {} / {} | {} / {} | {} |\n",
                    all[i].name, cell(fit, "Y_v"), cell(fit, "Y_r"), cell(fit, "N_v"), cell(fit, "N_r"),
                    most(fit, ForceComponent::Y, condition), most(fit, ForceComponent::N, condition),
                    most(fit, ForceComponent::Y, inflation), most(fit, ForceComponent::N, inflation), per_cent(small.Y),
                    per_cent(small.N), per_cent(large.Y), per_cent(large.N), stability_verdict(fit).words);
  }
  return text;
}

/// The same coefficients from other choices of runs.
std::string resamples_table(const std::vector<Form>& all, const std::vector<ForceFit>& fits,
                            const std::vector<Recording>& runs) {
  std::string head = "| runs |", rule = "| --- |";
  std::map<std::string, std::string> lines;
  std::vector<std::string> order;
  for (const std::size_t i : {std::size_t{0}, std::size_t{2}}) {
    head += fmt::format(" {0} Y_v | {0} N_v | {0} N_r |", all[i].name);
    rule += " ---: | ---: | ---: |";
    for (const auto& sample : resample(all[i].ship, runs, fits[i], all[i].options)) {
      if (std::ranges::count(order, sample.runs) == 0) order.push_back(sample.runs);
      for (const auto* name : {"Y_v", "N_v", "N_r"}) {
        const auto place = static_cast<std::size_t>(std::ranges::find(all[i].options.parameters, name) -
                                                    all[i].options.parameters.begin());
        lines[sample.runs] += fmt::format(" {} |", sample.values[place] ? thousandths(*sample.values[place]) : "–");
      }
    }
  }
  std::string text = head + "\n" + rule + "\n";
  for (const auto& name : order) text += fmt::format("| {} |{}\n", name, lines[name]);
  return text;
}

/// Root mean square of heading errors in windows of 30 s.
double window_error(const Ship& ship, const std::vector<Recording>& runs) {
  std::vector<Comparison> comparisons;
  for (const auto& run : runs)
    comparisons.push_back(compare(ship, run, {.window_lengths = 30.0 * service_speed(ship) / length(ship)}));
  const auto errors = pooled(comparisons);
  return std::ranges::find(errors, Quantity::heading, &QuantityError::quantity)->window_rms;
}

std::string window_cell(const Ship& ship, const std::vector<Recording>& runs) {
  try {
    return fmt::format("{:.2f}", degrees(window_error(ship, runs)));
  } catch (const Refusal&) {
    return "cannot be sailed";
  }
}

std::string windows_table(const std::vector<Form>& all, const std::vector<ForceFit>& fits,
                          const std::vector<Recording>& runs, const std::vector<Recording>& others) {
  std::string text = "| form | runs used |", rule = "| --- | ---: |";
  for (const auto& run : others) {
    text += fmt::format(" {} |", fs::path(run.name).stem().string());
    rule += " ---: |";
  }
  text += "\n" + rule + "\n";
  for (std::size_t i = 0; i < all.size(); ++i) {
    text += fmt::format("| {} | {} |", all[i].name, window_cell(fits[i].ship, runs));
    for (const auto& run : others) text += fmt::format(" {} |", window_cell(fits[i].ship, {run}));
    text += "\n";
  }
  return text;
}

/// States from position and heading with assumed noise: the most likely one, and 10 and 100 times its variance.
std::string drift_table(const std::vector<Form>& all, const std::vector<Recording>& runs) {
  const std::array snr{0.1, 1.0, 10.0};
  const std::array names{"Y_v", "Y_r", "N_v", "N_r"};
  std::string text = "| form | coefficient | SNR 0.1 | 1 | 10 | spread |\n| --- | --- | ---: | ---: | ---: | ---: |\n";
  for (const std::size_t i : {std::size_t{0}, std::size_t{2}, std::size_t{3}}) {
    auto options = all[i].options;
    options.states.channels = {Channel::x, Channel::y, Channel::psi};
    std::vector<NoiseEstimate> likely;
    for (const auto& run : runs) likely.push_back(estimate_states(all[i].ship, run, options.states).noise);
    std::vector<ForceFit> fits;
    for (const double ratio : snr) {
      std::vector<StateEstimate> states;
      for (std::size_t k = 0; k < runs.size(); ++k) {
        auto assumed = options.states;
        assumed.process_noise = likely[k].process_noise;
        for (const auto c : assumed.channels)
          assumed.noise[index_of(c)] = *likely[k].noise[index_of(c)] * std::sqrt(10.0 / ratio);
        states.push_back(estimate_states(all[i].ship, runs[k], assumed));
      }
      fits.push_back(fit_forces(all[i].ship, runs, std::move(states), options));
    }
    for (const auto* name : names) {
      if (!coefficient(fits[0], name)) continue;
      std::array<double, 3> value{};
      for (std::size_t k = 0; k < fits.size(); ++k) value[k] = coefficient(fits[k], name)->estimate.value;
      const auto [low, high] = std::ranges::minmax(value);
      text += fmt::format("| {} | {} | {} | {} | {} | {:.1f} % |\n", all[i].name, name, thousandths(value[0]),
                          thousandths(value[1]), thousandths(value[2]), 100.0 * (high - low) / std::abs(value[2]));
    }
  }
  return text;
}

/// Force Y' and moment N' at a point, in thousandths.
std::string force_cells(const Ship& ship, const CaptivePoint& point, const PlanarForce<double>& f) {
  const double U = speed(point.moments.front().motion), L = length(ship), q = 500.0 * L * L * U * U;
  return fmt::format("{} | {}", thousandths(f.Y / q), thousandths(f.N / (q * L)));
}

/// rms of N_v' v', of N_r' r' and of their sum over the recorded zigzags.
std::string share_cells(const ForceFit& fit) {
  const auto parameters = parameters_of(fit.ship, std::array<std::string, 2>{"N_v", "N_r"});
  double drift = 0.0, yaw = 0.0, both = 0.0, count = 0.0;
  for (const auto& run : fit.states)
    for (const auto& s : run.states) {
      const double U = speed(s.state.motion);
      const double v = parameters[0].value * s.state.motion.v / U,
                   r = parameters[1].value * s.state.motion.r * length(fit.ship) / U;
      drift += v * v, yaw += r * r, both += (v + r) * (v + r), count += 1.0;
    }
  const auto rms = [&](double sum) { return thousandths(std::sqrt(sum / count)); };
  return fmt::format("{} | {} | {}", rms(drift), rms(yaw), rms(both));
}

/// An idealized wind state: steady drift without yaw rate and rudder, as wind on the beam holds it; and what drift and
/// yaw rate make of the hull's moment in the recorded zigzags.
std::string wind_state_table(const std::vector<Form>& all, const std::vector<ForceFit>& fits, const fs::path& folder) {
  constexpr double beta = radians(9.0);  // as HMRI tested
  const auto points = captive(folder, fits[0].ship);
  const auto point = *std::ranges::find_if(
      points, [](const auto& p) { return std::abs(drift_angle(p.moments.front().motion) - beta) < 1e-6; });
  std::string text =
      "| | Y | N | drift's share of hull N, rms | yaw rate's | both |\n| --- | ---: | ---: | ---: | ---: | ---: |\n";
  text += fmt::format("| measured by HMRI | {} | | | |\n", force_cells(fits[0].ship, point, point.measured));
  for (std::size_t i = 0; i < all.size(); ++i)
    text += fmt::format("| {} | {} | {} |\n", all[i].name,
                        force_cells(fits[i].ship, point, captive_force(fits[i].ship, point)), share_cells(fits[i]));
  return text;
}

std::string angles(const std::vector<double>& overshoots) {
  std::string text;
  for (std::size_t i = 0; i < std::min<std::size_t>(3, overshoots.size()); ++i)
    text += fmt::format("{}{:.1f}", i ? ", " : "", degrees(overshoots[i]));
  return text;
}

std::string zigzag_table(const std::vector<Form>& all, const std::vector<ForceFit>& fits,
                         const std::vector<Recording>& runs) {
  std::string text = "| run | recorded |", rule = "| --- | --- |";
  for (const auto& form : all) {
    text += fmt::format(" {} |", form.name);
    rule += " --- |";
  }
  text += "\n" + rule + "\n";
  for (const auto& run : runs) {
    const auto order = zigzag_order(run);
    if (!order) continue;
    text += fmt::format("| {} | {} |", fs::path(run.name).stem().string(), angles(recorded_overshoots(run, *order)));
    for (const auto& fit : fits) {
      const auto simulated = simulated_overshoots(fit.ship, run, *order, 3);
      text += fmt::format(" {} |", simulated ? angles(*simulated) : "cannot be sailed");
    }
    text += "\n";
  }
  return text;
}

/// The verdict from runs of growing amplitude, PI with Y_r.
std::string stability_table(const Form& form, const fs::path& folder) {
  std::string text = "| run | e0 | largest drift, deg | largest r' | verdict |\n| --- | ---: | ---: | ---: | --- |\n";
  for (const auto* name : {"hsva_zz05_01_stbd", "hsva_zz10_01_stbd", "hsva_zz15_05_stbd", "hsva_zz30_05_stbd"}) {
    const auto verdict = stability_verdict(fit_forces(form.ship, recordings(folder, {name}), form.options));
    constexpr std::array words{"stable", "unstable", "not told"};
    text += fmt::format("| {} | {:.2f} ± {:.2f} | {:.1f} | {:.2f} | {} |\n", name, verdict.e0, verdict.standard_error,
                        degrees(verdict.range.drift), verdict.range.omega,
                        words[static_cast<std::size_t>(verdict.straight_course)]);
  }
  return text;
}

}  // namespace

int main(int count, char** words) {
  if (count != 4) return 2;
  const fs::path ships = words[1], folder = words[2], tables = words[3];
  const auto all = forms(ships);
  const auto runs = recordings(folder, trained_on), others = recordings(folder, held_out);
  std::vector<ForceFit> fits;
  for (const auto& form : all) fits.push_back(fit_forces(form.ship, runs, form.options));
  write_text(tables / "coefficients.md", coefficients_table(all, fits, folder));
  write_text(tables / "resamples.md", resamples_table(all, fits, runs));
  write_text(tables / "windows.md", windows_table(all, fits, runs, others));
  write_text(tables / "drift.md", drift_table(all, runs));
  write_text(tables / "wind_state.md", wind_state_table(all, fits, folder));
  write_text(tables / "zigzags.md", zigzag_table(all, fits, runs));
  write_text(tables / "stability.md", stability_table(all[0], folder));
}
