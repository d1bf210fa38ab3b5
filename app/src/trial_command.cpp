#include <cmath>

#include "commands.hpp"
#include "input.hpp"
#include "json.hpp"
#include "page_writing.hpp"
#include "simulate_output.hpp"
#include "swayaw/app/report.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/version.hpp"
#include "swayaw/identification/trial.hpp"
#include "terminal.hpp"
#include "trial_page.hpp"
#include "trial_table.hpp"

namespace swayaw::app {
namespace {

// ---------------------------------------------------------------- page

/// Every so many samples, so that the page stays small.
std::size_t stride_of(std::size_t samples) { return std::max<std::size_t>(1, samples / 1500); }

Json thinned(std::span<const double> values, double unit, std::size_t stride, double zero = 0.0) {
  Json list = Json::array();
  for (std::size_t i = 0; i < values.size(); i += stride) list.push_back(number((values[i] - zero) / unit));
  return list;
}

/// The track without its drift, from the execute on; before it as recorded.
Json without_drift(std::span<const double> position, std::span<const double> time, double drift, double execute,
                   std::size_t stride) {
  Json list = Json::array();
  for (std::size_t i = 0; i < position.size(); i += stride)
    list.push_back(number(position[i] - drift * (time[i] - execute)));
  return list;
}

Json series_json(const JudgedRun& run) {
  const auto& r = run.recording;
  const auto stride = stride_of(r.samples());
  const double degree = radians(1.0), execute = run.trial.approach.execute.value;
  const Channel rudder = r.has(Channel::delta) ? Channel::delta : Channel::delta_order;
  Json series{{"time_s", thinned(r.time, 1.0, stride)},
              {"heading_deg", thinned(r[Channel::psi], degree, stride, run.trial.approach.heading.value)},
              {"rudder_deg", thinned(r[rudder], degree, stride)}};
  if (r.has(Channel::x) && r.has(Channel::y)) {
    series["x_m"] = thinned(r[Channel::x], 1.0, stride);
    series["y_m"] = thinned(r[Channel::y], 1.0, stride);
    if (run.trial.turn && run.trial.turn->drift) {
      const auto& d = *run.trial.turn->drift;
      series["x_corrected_m"] = without_drift(r[Channel::x], r.time, d.north.value, execute, stride);
      series["y_corrected_m"] = without_drift(r[Channel::y], r.time, d.east.value, execute, stride);
    }
  }
  if (const auto& fit = run.trial.steering.least_squares) {
    series["fit_time_s"] = thinned(fit->time, 1.0, 1);
    series["fit_heading_deg"] = thinned(fit->heading, degree, 1);
  }
  const Recording* simulated = run.simulated.zigzag ? &run.simulated.zigzag->run
                               : run.simulated.turn ? &run.simulated.turn->run
                                                    : nullptr;
  if (simulated != nullptr) {
    const auto thin = stride_of(simulated->samples());
    series["simulated"] = {{"time_s", thinned(simulated->time, 1.0, thin, -execute)},
                           {"heading_deg", thinned((*simulated)[Channel::psi], degree, thin)},
                           {"x_m", thinned((*simulated)[Channel::x], 1.0, thin)},
                           {"y_m", thinned((*simulated)[Channel::y], 1.0, thin)}};
  }
  return series;
}

void write_report(const Json& document, const std::vector<JudgedRun>& runs, const TrialQuestion& question,
                  const std::filesystem::path& file) {
  Json data = only(document, {"version", "length_m"});
  for (std::size_t i = 0; i < runs.size(); ++i) {
    auto run = only(document["runs"][i], {"run", "manoeuvre", "first", "approach_heading_rad", "approach_speed_m_s",
                                          "approach_speed_source", "execute_s", "peak_s", "steps", "notes"});
    run["rows"] = rows_json(rows_of(runs[i].trial, runs[i].simulated, question.L));
    run["plots"] = series_json(runs[i]);
    run["execute"] = runs[i].trial.approach.execute.value;
    data["runs"].push_back(std::move(run));
  }
  write_page(file, trial_page(first_screen(runs, question), for_page(data)));
}

// ---------------------------------------------------------------- text

/// A heading in degrees from 0 to 360.
double compass(double heading) {
  const double angle = degrees(wrapped(heading));
  return angle < -0.5 ? angle + 360.0 : angle;
}

std::string cell(const MaybeTold& told) { return told ? shown(*told) : "-"; }

/// Width in columns of a terminal: "±" is one.
std::string padded(const std::string& text, std::size_t width) {
  std::size_t columns = 0;
  for (const char c : text) columns += (static_cast<unsigned char>(c) & 0xC0U) != 0x80U ? 1U : 0U;
  return columns < width ? std::string(width - columns, ' ') + text : text;
}

void print_rows(const std::vector<TrialRow>& rows, bool corrected, bool simulated) {
  say("  {:<34}{}{}{}\n", "", padded("recorded", 20), corrected ? padded("corrected", 20) : "",
      simulated ? padded("simulated", 12) : "");
  for (const auto& row : rows) {
    say("  {:<34}{}", row.name, padded(cell(row.recorded), 20));
    if (corrected) say("{}", padded(row.corrected ? cell(row.corrected) : "", 20));
    if (simulated) say("{:>12}", row.simulated ? fmt::format("{:.4g}", *row.simulated) : "");
    say("  {}", row.unit);
    if (row.in_lengths) say("  {:.3f} L", *row.in_lengths);
    say("\n");
  }
}

void print_moves(const TrialResult& t) {
  if (t.rudder.empty()) return;
  say("  rudder, deg to port:");
  for (const auto& m : t.rudder) {
    say(" {:.1f} at {:.1f} s", degrees(m.to) + 0.0, m.start.value);
    if (m.rate) say(" ({:.2f} deg/s)", degrees(*m.rate));
    if (&m != &t.rudder.back()) say(",");
  }
  say("\n");
}

void print_reversals(const TrialResult& t) {
  if (!t.zigzag || t.zigzag->reversals.empty()) return;
  say("  {:<12}{}{}{}{}\n", "reversal", padded("at H, s", 16), padded("peak, s", 16), padded("rudder back, s", 16),
      padded("heading then, deg", 18));
  for (std::size_t k = 0; k < t.zigzag->reversals.size(); ++k) {
    const auto& r = t.zigzag->reversals[k];
    const MaybeTold then =
        r.heading_then ? MaybeTold(Told{degrees(r.heading_then->value), degrees(r.heading_then->standard_error)})
                       : std::nullopt;
    say("  {:<12}{}{}{}{}\n", fmt::format("{} {}", k + 1, name_of(r.side)), padded(cell(r.execute), 16),
        padded(cell(r.peak_time), 16), padded(cell(r.rudder_start), 16), padded(cell(then), 18));
  }
}

void print_imo(const TrialResult& t) {
  if (t.imo.empty()) return;
  say("  {:<24}{:<12}{}{:>10}  {:<5}{}\n", "MSC.137(76)", "to", padded("value", 18), "limit", "", "verdict");
  for (const auto& c : t.imo)
    say("  {:<24}{:<12}{}{:>10.3f}  {:<5}{}\n", c.name, name_of(c.side), padded(cell(c.value), 18), c.limit, c.unit,
        verdict_of(c));
}

void print_second_order(const SteeringTrial& k) {
  if (!k.second) return;
  const auto& s = *k.second;
  const auto open = [](const char* name, const MaybeTold& x, bool told) {
    if (told) return;
    if (!x) say("  {} cannot be told: the two time constants are not both real\n", name);
    else
      say("  {} cannot be told: between {:.3g} and {:.3g} s\n", name, x->value - 2.0 * x->standard_error,
          x->value + 2.0 * x->standard_error);
  };
  open("T1", s.T1, s.T1_told);
  open("T2", s.T2, s.T2_told);
  open("T3", s.T3, s.T3_told);
}

void print_run(const JudgedRun& run, const std::optional<double>& L) {
  const auto& t = run.trial;
  say("{}: {}{}", t.run, t.manoeuvre.name, t.manoeuvre.said ? "" : " (told from rudder and heading)");
  if (t.zigzag) say(", first to {}", name_of(t.zigzag->first));
  if (t.turn) say(" to {}, {:.0f} deg in all", name_of(t.turn->side), degrees(t.turn->heading_change));
  say("\n");
  if (t.approach.speed) say("  approach {} m/s {},", shown(*t.approach.speed), in_words(t.approach.speed_source));
  say("{} heading {} deg", t.approach.speed ? "" : " ",
      shown({compass(t.approach.heading.value), degrees(t.approach.heading.standard_error)}));
  if (t.zigzag || t.turn)
    say(", execute at {} s{}", shown(t.approach.execute), t.approach.execute_said ? "" : " by the rudder");
  say("\n");
  print_moves(t);
  print_reversals(t);
  print_rows(rows_of(t, run.simulated, L), t.turn && t.turn->corrected, !run.simulated.json.is_null());
  print_second_order(t.steering);
  if (t.zigzag)
    say("  K is positive where rudder to starboard turns to starboard; inside swayaw it has the other sign\n");
  print_imo(t);
  for (const auto& note : t.notes) say("  {}\n", note);
}

/// "± is one standard error" and what is in it, once.
constexpr std::string_view errors_in_words =
    "± is one standard error of instrument noise, rounding and sampling; wind, waves and the helmsman are not in it";

}  // namespace

void trial(const TrialArguments& a) {
  std::optional<AnyShip> ship;
  if (!a.ship.empty()) ship = load_ship(a.ship);
  TrialOptions options{.L = a.length, .U = a.speed};
  const Ship* sailing = ship ? std::get_if<Ship>(&*ship) : nullptr;
  if (sailing != nullptr) options.max_rudder = turning_rudder(*sailing);
  if (ship && !options.L) options.L = sailing != nullptr ? length(*sailing) : std::get<LinearShip>(*ship).particulars.L;
  if (ship && sailing == nullptr)
    say_aside("swayaw: {}: a linear ship tells her length; she is not simulated\n", a.ship.string());
  std::vector<JudgedRun> runs;
  std::vector<TrialResult> trials;
  std::vector<std::string> not_judged;
  for (const auto& file : a.runs) {
    JudgedRun run{load_run(file, a.rudder_positive), {}, {}};
    try {
      run.trial = judge_trial(run.recording, options);
    } catch (const Refusal& refusal) {  // the others are
      not_judged.emplace_back(refusal.what());
      continue;
    }
    if (sailing != nullptr) {
      say_other_speed(*sailing, run.trial);
      run.simulated = simulated_trial(*sailing, run.trial);
    }
    trials.push_back(run.trial);
    runs.push_back(std::move(run));
  }
  if (runs.empty()) throw Refusal(fmt::format("{}", fmt::join(not_judged, "; ")));
  for (const auto& why : not_judged) say_aside("swayaw: {}; the other runs are judged without it\n", why);
  const auto summary = summary_of(trials);
  Json document{{"schema", "swayaw.trial/1"},
                {"version", version()},
                {"ship", sailing != nullptr ? Json(sailing->name) : Json(nullptr)},
                {"length_m", number(options.L)},
                {"runs", Json::array()},
                {"not_judged", not_judged},
                {"imo",
                 {{"verdict", in_words(summary)},
                  {"failed", summary.failed},
                  {"cannot_tell", summary.open},
                  {"not_told", summary.missing}}}};
  for (const auto& run : runs) document["runs"].push_back(trial_json(run.trial, run.simulated));
  if (a.report.wanted())
    write_report(document, runs,
                 {.ship = sailing != nullptr ? sailing->name : "",
                  .L = options.L,
                  .L_source = a.length ? "as given" : "of the ship file",
                  .si = a.report.si,
                  .only_speed = sailing != nullptr ? only_speed(*sailing) : std::nullopt,
                  .not_judged = not_judged},
                 a.report.file);
  if (a.json) return print_document(document);
  for (const auto& run : runs) print_run(run, options.L), say("\n");
  say("{}\n", in_words(summary));
  say("{}\n", errors_in_words);
  if (options.L && *options.L < shortest_ship_of_criteria)
    say("the criteria are for ships of 100 m and more; the limits of a scale model's L/V are not those of her ship\n");
}

}  // namespace swayaw::app
