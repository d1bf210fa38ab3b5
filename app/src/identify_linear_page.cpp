#include "identify_linear_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "page_writing.hpp"
#include "sentences.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/linear/response.hpp"
#include "swayaw/mismatch/quantity.hpp"
#include "user_units.hpp"

namespace swayaw::app {
namespace {

/// Coefficients come first in the rows, then the indices that follow from them.
constexpr std::size_t coefficients_of_ship = 6;

std::string words_for(const LinearRow& row) { return std::string(row.name) == "T1_plus_T2" ? "T1 + T2" : row.name; }

Tone tone_of(const Estimate& e) {
  switch (e.verdict()) {
    case Verdict::determined: return Tone::good;
    case Verdict::weakly_determined: return Tone::look;
    case Verdict::not_determined: break;
  }
  return Tone::bad;
}

std::vector<std::string> with_tone(const LinearAnswer& a, Tone tone) {
  std::vector<std::string> names;
  for (const auto& row : a.rows)
    if (tone_of(row.estimate) == tone) names.push_back(words_for(row));
  return names;
}

std::size_t determined(const LinearAnswer& a) {
  return static_cast<std::size_t>(std::count_if(a.rows.begin(), a.rows.begin() + coefficients_of_ship,
                                                [](const auto& row) { return tone_of(row.estimate) == Tone::good; }));
}

// ---------------------------------------------------------------- heading

/// Root mean square variation of the headings.
double variation_of_heading(const std::vector<Recording>& runs) {
  double sum = 0.0;
  for (const auto& run : runs) sum += std::pow(variation_of(run, Quantity::heading), 2);
  return std::sqrt(sum / static_cast<double>(runs.size()));
}

/// Heading of a linear ship with the recorded rudder and speed, from the start that was fitted.
Curve simulated_heading(const LinearAnswer& a, const SwayYawCoefficients<double>& coefficients, const Recording& run,
                        const LinearState<Estimate>& start, std::string name, Stroke stroke) {
  const LinearResponse<double> ship(coefficients);
  const Interpolant rudder(run, Channel::delta), u(run, Channel::u), v(run, Channel::v);
  const auto rate = [&](double t) { return std::hypot(u(t), v(t)) / a.L; };
  const double offset = std::isfinite(a.fit.rudder_offset.value) ? a.fit.rudder_offset.value : 0.0;
  LinearState<double> x{start.beta.value, start.omega.value, start.psi.value};
  Curve curve{.name = std::move(name), .x = {}, .y = {}, .stroke = stroke};
  for (std::size_t i = 0; i < run.samples(); ++i) {
    const double t = run.time[i];
    if (i > 0) {
      // s' = ∫ U/L dt, trapezoidal
      const double before = run.time[i - 1], s = 0.5 * (rate(before) + rate(t)) * (t - before);
      const double delta = rudder(before);
      x = state_after(ship, x, RudderLine<double>{delta + offset, (rudder(t) - delta) / s}, s);
    }
    curve.x.push_back(t);
    curve.y.push_back(degrees(x.psi));
  }
  return curve;
}

PagePicture picture_of_run(const LinearAnswer& a, const Recording& run, const LinearState<Estimate>& start,
                           const UserUnits& units) {
  const auto& m = a.fit.coefficients;
  const SwayYawCoefficients<double> found{m.a1.value, m.b1.value, m.c1.value, m.a2.value, m.b2.value, m.c2.value};
  Panel heading{.x = {.quantity = "Time", .unit = "s"},
                .y = {.quantity = "Heading", .unit = "deg"},
                .curves = {over_time(run, Channel::psi, "recorded", {.colour = ink::heading, .width = 2.6})}};
  if (a.before)
    heading.curves.push_back(
        simulated_heading(a, *a.before, run, start, "before", {.colour = ink::drift, .width = 1.8, .dashed = true}));
  heading.curves.push_back(
      simulated_heading(a, found, run, start, "found", {.colour = ink::yaw, .width = 2.0, .dashed = true}));
  return picture_of({.title = run.name, .panels = {std::move(heading)}},
                    fmt::format("Heading of {} over time: recorded, and of the linear ship.", run.name),
                    "Linear ship with the recorded rudder and speed from start to end, never restarted.", units);
}

/// The run in which the rudder is put over most.
std::size_t largest_run(const std::vector<Recording>& runs) {
  const auto amplitude = [](const Recording& run) {
    double most = 0.0;
    for (const double delta : run[Channel::delta]) most = std::isfinite(delta) ? std::max(most, std::abs(delta)) : most;
    return most;
  };
  return static_cast<std::size_t>(std::ranges::max_element(runs, {}, amplitude) - runs.begin());
}

// ---------------------------------------------------------------- words

std::string headline_of(const LinearAnswer& a, const std::vector<Recording>& runs, const UserUnits& units) {
  const double off = a.fit.whole_run.psi;
  const auto heading =
      std::isfinite(off) ? fmt::format("Over whole runs the linear ship's heading is off by {}, {} of its variation. ",
                                       units.angle(off), percent_of(off / variation_of_heading(runs)))
                         : std::string();
  return fmt::format("{}{} of {} coefficients can be trusted. {}.", heading, determined(a), coefficients_of_ship,
                     capital(a.stability));
}

Tone tone_of(const LinearAnswer& a) { return determined(a) == coefficients_of_ship ? Tone::good : Tone::look; }

std::string trusted_words(const LinearAnswer& a) {
  const auto good = with_tone(a, Tone::good);
  return good.empty() ? "None to better than 10 %." : listed(good) + ", each to 10 % or better.";
}

std::string open_words(const LinearAnswer& a) {
  const auto open = with_tone(a, Tone::bad), weak = with_tone(a, Tone::look);
  std::string words = open.empty() ? "None is undetermined." : listed(open) + ".";
  return weak.empty() ? words : words + fmt::format(" By the sign only: {}.", listed(weak));
}

std::optional<double> value_before(const LinearAnswer& a, std::size_t row) {
  if (!a.before || row >= coefficients_of_ship) return std::nullopt;
  const auto& m = *a.before;
  return std::array{m.a1, m.b1, m.c1, m.a2, m.b2, m.c2}[row];
}

PageTable table_of(const LinearAnswer& a) {
  PageTable table{.caption = "Dimensionless coefficients, and the indices that follow",
                  .columns = {"", "Before", "Found ± std error", "Change", "Verdict"},
                  .rows = {}};
  for (std::size_t i = 0; i < a.rows.size(); ++i) {
    const auto& [name, e] = a.rows[i];
    const auto before = value_before(a, i);
    table.rows.push_back({words_for(a.rows[i]),
                          before ? with_error(*before) : "",
                          with_error(e.value, std::isfinite(e.standard_error) ? e.standard_error : 0.0),
                          before && *before != 0.0 ? fmt::format("{:+.0f} %", 100.0 * (e.value / *before - 1.0)) : "",
                          {std::string(in_words(e.verdict())), tone_of(e)}});
  }
  return table;
}

std::vector<std::string> assumed_of(const LinearAnswer& a, const IdentifyArguments& arguments) {
  std::vector<std::string> lines{
      fmt::format("Ship file {}: length {:.4g} m and steering gear.", arguments.ship.string(), a.L),
      "Small motions at the recorded speed; wind, even measured, has no place in a linear ship.",
      fmt::format(
          "Random forces act on her, and the recorded rudder has an unknown zero: it is {}.",
          UserUnits(arguments.report.si, a.L).angle(a.fit.rudder_offset.value, a.fit.rudder_offset.standard_error)),
      "Standard errors hold for motions of this size."};
  if (a.before) lines.emplace_back("Before: the ship file, linearized about the straight course at service speed.");
  return lines;
}

}  // namespace

Page linear_page(const LinearAnswer& a, const std::vector<Recording>& runs, const IdentifyArguments& arguments) {
  const UserUnits units(arguments.report.si, a.L);
  const auto shown = largest_run(runs);
  Page page{.kicker = "Linear ship from recordings",
            .title = a.name,
            .headline = headline_of(a, runs, units),
            .tone = tone_of(a)};
  page.answers = {{"Which coefficients can I trust?", trusted_words(a)},
                  {"Which not?", open_words(a)},
                  {"Does she predict runs that were not used?",
                   "Not tried: no run is held out from a linear fit. swayaw compare with the file written and a run "
                   "of like size tells."},
                  {"What was fitted?",
                   fmt::format("Sway and yaw together in {}, so that each measurement is predicted best from those "
                               "before it ({}).",
                               counted(runs.size(), "run"), in_words(a.fit.status))}};
  page.picture = picture_of_run(a, runs[shown], a.fit.starts[shown], units);
  page.table = table_of(a);
  page.assumed = assumed_of(a, arguments);
  page.footnotes = {made_by()};
  return page;
}

}  // namespace swayaw::app
