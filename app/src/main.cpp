#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include <unistd.h>

#include "child_process.hpp"
#include "commands.hpp"
#include "help.hpp"
#include "swayaw/core/detail/spelling.hpp"
#include "swayaw/core/file_limits.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/core/steered_thrust.hpp"
#include "swayaw/core/version.hpp"
#include "terminal.hpp"

/// The program. Exit code 0: done; 1: the data or the question is bad; 2: wrong usage.
namespace swayaw::app {
namespace {

constexpr int done = 0, bad_data = 1, wrong_usage = 2;
constexpr std::array<std::string_view, 19> commands{
    "check",  "compare",   "completion", "diagnose", "estimate", "fleet",    "forces", "identify", "import", "indices",
    "invert", "linearize", "loop",       "replay",   "ship",     "simulate", "sweep",  "trial",    "tune"};

const CLI::Validator zigzag_form(
    [](std::string& text) {
      const auto slash = text.find('/');
      double rudder = 0.0, heading = 0.0;
      const bool two_numbers = slash != std::string::npos && CLI::detail::lexical_cast(text.substr(0, slash), rudder) &&
                               CLI::detail::lexical_cast(text.substr(slash + 1), heading);
      return two_numbers ? std::string{} : "\"" + text + "\" is not of the form D/H, two angles in degrees like 20/10";
    },
    "D/H");

/// Bytes of a size like 4GB; 0 where the text is none.
std::uint64_t bytes_in(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, double>, 6> units{
      {{"", 1.0}, {"B", 1.0}, {"kB", 1e3}, {"MB", 1e6}, {"GB", 1e9}, {"TB", 1e12}}};
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const auto unit = std::ranges::find(units, text.substr(static_cast<std::size_t>(end - text.data())),
                                      &std::pair<std::string_view, double>::first);
  const double bytes = error == std::errc{} && unit != units.end() ? number * unit->second : 0.0;
  return bytes >= 1.0 && bytes < 1e18 ? static_cast<std::uint64_t>(bytes) : 0;
}

const CLI::Validator file_size(
    [](std::string& text) {
      const auto bytes = bytes_in(text);
      if (bytes == 0) return "\"" + text + "\" is not a size like 4GB, in B, kB, MB, GB or TB";
      text = std::to_string(bytes);
      return std::string{};
    },
    "");

const CLI::Validator side_name = CLI::IsMember({"port", "starboard"});

void add_ship(CLI::App& command, std::filesystem::path& ship) {
  command.add_option("SHIP", ship, "ship file (TOML or .mat), or the name of a published ship, such as kvlcc2")
      ->required();
}

CLI::Option& add_svg(CLI::App& command, std::filesystem::path& svg, const std::string& what) {
  return *command.add_option("--svg", svg, "plot to this file (SVG, drawn by gnuplot): " + what);
}

void add_report(CLI::App& command, ReportArguments& report) {
  auto* page = command.add_option("--report", report.file, "write an HTML page that needs no network");
  command
      .add_option_function<std::string>(
          "--units", [&report](const std::string& units) { report.si = units == "si"; },
          "units on the first screen of the page: knots, degrees and ship lengths, or si")
      ->check(CLI::IsMember({"ship", "si"}))
      ->default_str("ship")
      ->needs(page);
}

void add_shaft(CLI::App& command, std::string& shaft) {
  command
      .add_option("--shaft", shaft,
                  "shaft speed: recorded, or the model's self-propulsion point at the recorded starting speed")
      ->check(CLI::IsMember({"recorded", "self-propulsion"}))
      ->capture_default_str();
}

/// --rudder and --rudder-step go with some manoeuvres only.
void require_sense(const SimulateArguments& a, bool step_given) {
  if (a.rudder && !a.spiral && !a.reverse_spiral && !a.williamson)
    throw CLI::ValidationError("--rudder", "goes with --spiral, --reverse-spiral or --williamson");
  if (step_given && !a.spiral) throw CLI::ValidationError("--rudder-step", "goes with --spiral");
}

void add_simulate(CLI::App& app, SimulateArguments& a) {
  auto& command = *app.add_subcommand("simulate", "run a standard manoeuvre and print its indices");
  add_ship(command, a.ship);
  auto& manoeuvre = *command.add_option_group("manoeuvre", "one of");
  manoeuvre.add_option("--zigzag", a.zigzag, "zigzag, rudder D and heading H in degrees")->check(zigzag_form);
  manoeuvre.add_option("--turn", a.turn, "turning circle, rudder in degrees")->check(CLI::PositiveNumber);
  auto* spiral = manoeuvre.add_flag("--spiral", a.spiral, "Dieudonne spiral, and all steady turns");
  auto* reverse_spiral =
      manoeuvre.add_flag("--reverse-spiral", a.reverse_spiral, "Bech spiral: the rudder that holds each yaw rate");
  auto* pullout = manoeuvre.add_option("--pullout", a.pullout, "pull-out from turns to both sides, rudder in degrees")
                      ->check(CLI::PositiveNumber);
  manoeuvre.add_flag("--williamson", a.williamson, "Williamson turn");
  auto* imo = manoeuvre.add_flag("--imo", a.imo, "steering criteria of IMO resolution MSC.137(76), both sides");
  auto* straight = manoeuvre.add_option(
      "--straight", a.straight,
      "steady run on this course in degrees, in wind and current of the ship file: drift and helm");
  manoeuvre.require_option(1);
  command
      .add_option("--rudder", a.rudder,
                  "largest rudder angle in degrees of a spiral (default: 25) or Williamson turn (default: 35), or the "
                  "ship's largest")
      ->check(CLI::PositiveNumber);
  auto* step = command.add_option("--rudder-step", a.rudder_step, "degrees between the rudder angles of the spiral")
                   ->check(CLI::PositiveNumber)
                   ->capture_default_str();
  command.add_option("--first", a.first, "side turned to first; of the pull-outs the one that --out writes")
      ->check(side_name)
      ->capture_default_str()
      ->excludes(reverse_spiral)
      ->excludes(imo)
      ->excludes(straight);
  command.add_option("--speed", a.speed, "approach speed in m/s (default: service speed)")->check(CLI::PositiveNumber);
  auto* rev = command.add_option("--rev", a.rev, "shaft speed in 1/s (default: self-propulsion at the approach speed)")
                  ->check(CLI::PositiveNumber);
  command.add_option("--thrust", a.thrust, "thrust of all propellers in N, in place of a shaft speed")
      ->check(CLI::PositiveNumber)
      ->excludes(rev);
  command.add_option("--duration", a.duration, "seconds (default: until the indices are known)")
      ->check(CLI::PositiveNumber)
      ->excludes(spiral)
      ->excludes(reverse_spiral)
      ->excludes(pullout)
      ->excludes(imo)
      ->excludes(straight);
  command.add_option("--step", a.step, "seconds between samples of the time series")->check(CLI::PositiveNumber);
  command.add_option("--tolerance", a.tolerance, "error of an integration step, relative to ship length and speed")
      ->check(CLI::Range(1e-13, 1e-2))
      ->capture_default_str();
  auto* out = command.add_option("--out", a.out, "time series to this file (CSV or .mat)")
                  ->excludes(reverse_spiral)
                  ->excludes(imo)
                  ->excludes(straight);
  command.add_flag("--forces", a.forces, "forces by part in the time series")->needs(out);
  add_svg(command, a.svg, "heading and rudder, or the track of a turn")
      .excludes(spiral)
      ->excludes(reverse_spiral)
      ->excludes(imo)
      ->excludes(straight);
  add_report(command, a.report);
  command.add_flag("--json", a.json, "print one JSON document");
  command.callback([&a, step] {
    require_sense(a, step->count() > 0);
    simulate(a);
  });
}

void add_rudder_positive(CLI::App& command, std::string& side) {
  command.add_option("--rudder-positive", side, "side to which rudder angles are positive, whatever the files say")
      ->check(side_name);
}

void add_ignored(CLI::App& command, Ignored& ignored) {
  command.add_flag("--ignore-wind", ignored.wind, "as if the true wind (wind_speed, wind_from) had not been measured");
  command.add_flag("--ignore-depth", ignored.depth, "as if the depth (water_depth_m, depth_m) had not been measured");
}

void add_replay(CLI::App& app, ReplayArguments& a) {
  auto& command = *app.add_subcommand("replay", "simulate a recorded run with its rudder and shaft speed");
  add_ship(command, a.ship);
  command.add_option("RUN", a.run, "recording (CSV or .mat)")->required();
  add_shaft(command, a.shaft);
  command.add_option("--out", a.out, "time series to this file (CSV or .mat)")->required();
  command.add_flag("--forces", a.forces, "forces by part in the time series");
  add_rudder_positive(command, a.rudder_positive);
  add_ignored(command, a.ignored);
  command.add_flag("--json", a.json, "print one JSON document");
  command.callback([&a] { replay(a); });
}

/// Of commands that check the instruments of their recordings before they begin.
void add_reading(CLI::App& command, Reading& reading) {
  add_rudder_positive(command, reading.rudder_positive);
  add_ignored(command, reading.ignored);
  command.add_flag("--no-check", reading.no_check,
                   "believe the recordings: signs, units and clocks are not checked first");
}

void add_check(CLI::App& app, CheckArguments& a) {
  auto& command = *app.add_subcommand(
      "check",
      "signs, units, clocks, zeros, scales and axes of recorded channels, by kinematics alone: no ship needed");
  command.add_option("runs", a.runs, "recordings (CSV or .mat)")->required();
  add_rudder_positive(command, a.rudder_positive);
  add_report(command, a.report);
  command.add_option("--out", a.out,
                     "the recording without the errors that were told (CSV or .mat); of one recording only");
  command.add_flag("--json", a.json, "print one JSON document");
  command.callback([&a] {
    if (!a.out.empty() && a.runs.size() > 1) throw CLI::ValidationError("--out", "goes with one recording");
    check(a);
  });
}

void add_compare(CLI::App& app, CompareArguments& a) {
  auto& command = *app.add_subcommand("compare", "say where simulation and recordings differ");
  add_ship(command, a.ship);
  command.add_option("RUN", a.runs, "recordings (CSV or .mat)")->required();
  add_shaft(command, a.shaft);
  command.add_option("--window", a.window_lengths, "ship lengths of way between restarts from the recorded state")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  add_report(command, a.report);
  auto* json = command.add_flag("--json", a.json, "print one JSON document");
  command.add_flag("--markdown", a.markdown, "print Markdown tables")->excludes(json);
  add_reading(command, a.reading);
  command.callback([&a] { compare(a); });
}

void add_forces(CLI::App& app, ForcesArguments& a) {
  auto& command = *app.add_subcommand("forces", "forces by part at a motion of the ship");
  add_ship(command, a.ship);
  command
      .add_option(
          "--state", a.state,
          "u=,v= [m/s],r= [rad/s],delta= [rad, positive to port],psi= [rad] and rev= [1/s] or thrust= [N]; u is needed")
      ->required();
  command.add_flag("--json", a.json, "print one JSON document");
  command.callback([&a] { forces(a); });
}

const CLI::Validator mat_ending(
    [](std::string& file) {
      return file.ends_with(".mat") ? std::string{} : "\"" + file + "\" must end in .mat, as MATLAB files do";
    },
    "");

void add_linear_model(CLI::App& command, std::filesystem::path& out) {
  command.add_option("--out", out, "matrices A, B, C, D and Nomoto's transfer function to this file (.mat)")
      ->check(mat_ending);
}

void add_linearize(CLI::App& app, LinearizeArguments& a) {
  auto& command = *app.add_subcommand("linearize", "linear coefficients of a nonlinear ship by part, and her indices");
  add_ship(command, a.ship);
  command
      .add_option(
          "--speed", a.speed,
          "speed in m/s straight ahead, self-propelled unless --rev or --thrust is given (default: service speed)")
      ->check(CLI::PositiveNumber);
  auto* rev = command.add_option("--rev", a.rev, "shaft speed in 1/s; without --speed at the speed that it gives")
                  ->check(CLI::PositiveNumber);
  command.add_option("--thrust", a.thrust, "thrust of all propellers in N, likewise")
      ->check(CLI::PositiveNumber)
      ->excludes(rev);
  command.add_option("--rudder", a.rudder, "about the steady turn at this rudder angle in degrees, positive to port");
  command.add_option("--side", a.side, "side turned to, where the forces have a kink (default: mean, and both)")
      ->check(side_name);
  command.add_flag("--json", a.json, "print one JSON document");
  add_linear_model(command, a.out);
  command.callback([&a] { linearize(a); });
}

void add_indices(CLI::App& app, IndicesArguments& a) {
  auto& command = *app.add_subcommand("indices", "coefficients, time constants, gains and stability of a linear ship");
  add_ship(command, a.ship);
  command.add_option("--speed", a.speed, "speed in m/s of the numbers with dimension (default: service speed)")
      ->check(CLI::PositiveNumber);
  add_svg(command, a.svg, "Bode diagram of drift and yaw");
  add_report(command, a.report);
  command.add_flag("--json", a.json, "print one JSON document");
  add_linear_model(command, a.out);
  command.callback([&a] { indices(a); });
}

void add_ship_command(CLI::App& app, ShipArguments& a) {
  auto& command = *app.add_subcommand("ship", "parameters of a ship: value, unit, range, how far they are trusted");
  add_ship(command, a.ship);
  command.add_option("--out", a.out, "ship file (TOML, or .mat: a struct for each table)");
  command.add_flag("--json", a.json, "print one JSON document");
  command.callback([&a] { describe_ship(a); });
}

void add_invert(CLI::App& app, InvertArguments& a) {
  auto& command = *app.add_subcommand("invert", "from time constants and gains to coefficients, hull and rudder");
  add_ship(command, a.ship);
  command.add_option("--known", a.known, "the number that is known beforehand (default: c_Ry)")
      ->check(CLI::IsMember({"Y_b", "Y_w", "N_b", "N_w", "c_Ry"}));
  command.add_option("--parts", a.parts,
                     "ship file with [hull] and [rudder] for all numbers that do not follow (default: SHIP)");
  command.add_flag("--json", a.json, "print one JSON document");
  command.callback([&a] { invert(a); });
}

void add_loop(CLI::App& app, LoopArguments& a) {
  auto& command = *app.add_subcommand("loop", "drift-yaw loop of a zigzag and what T3b and T3w do to it");
  add_ship(command, a.ship);
  command.add_option("--zigzag", a.zigzag, "rudder D and heading H in degrees")->check(zigzag_form)->required();
  command.add_option("--first", a.first, "side turned to first")->check(side_name)->capture_default_str();
  command
      .add_option(
          "--speed", a.speed,
          "speed in m/s, which turns the rate of the steering gear into one per ship length (default: service speed)")
      ->check(CLI::PositiveNumber);
  command.add_option("--out", a.out, "time series to this file (CSV or .mat)");
  add_report(command, a.report);
  add_svg(command, a.svg, "drift angle and yaw rate, with the line of a first-order ship");
  command.add_flag("--json", a.json, "print one JSON document");
  command.callback([&a] { loop(a); });
}

void add_trial(CLI::App& app, TrialArguments& a) {
  auto& command =
      *app.add_subcommand("trial", "judge recorded manoeuvres: overshoots, K and T, turning circle, MSC.137(76)");
  command.add_option("RUN", a.runs, "recordings (CSV or .mat), one manoeuvre each")->required();
  command.add_option(
      "--ship", a.ship,
      "ship file (TOML), or the name of a published ship: the same manoeuvre simulated beside each number");
  command.add_option("--speed", a.speed, "approach speed in m/s, in place of the recorded one")
      ->check(CLI::PositiveNumber);
  command.add_option("--length", a.length, "ship length in m (default: that of the ship)")->check(CLI::PositiveNumber);
  add_report(command, a.report);
  add_rudder_positive(command, a.rudder_positive);
  command.add_flag("--json", a.json, "print one JSON document");
  command.callback([&a] { trial(a); });
}

void add_tune(CLI::App& app, TuneArguments& a) {
  auto& command = *app.add_subcommand("tune", "coefficients of a ship from measured indices of her manoeuvres");
  add_ship(command, a.ship);
  command.add_option("--indices", a.indices, "measured indices (TOML)")->required();
  command
      .add_option("--numbers", a.parameters,
                  "keys of the ship file that may change, N_v,N_r (default: hull derivatives)")
      ->delimiter(',');
  command
      .add_option("--prior", a.prior,
                  "relative standard deviation of each number beforehand (default: [confidence] of the ship file)")
      ->check(CLI::PositiveNumber);
  command.add_option("--bound", a.most_change, "largest relative change of each number (default: none)")
      ->check(CLI::PositiveNumber);
  command.add_option("--turns", a.most_turns, "turning circles to be sailed at most")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command.add_option("--out", a.out, "ship file of the tuned ship (TOML or .mat)")->required();
  add_report(command, a.report);
  command.add_flag("--json", a.json, "print one JSON document");
  command.callback([&a] { tune(a); });
}

void add_identify(CLI::App& app, IdentifyArguments& a) {
  auto& command = *app.add_subcommand("identify", "coefficients of a ship from recordings");
  command.add_option("runs", a.runs, "recordings (CSV or .mat)")->required();
  command.add_option("--ship", a.ship, "ship file to begin with (TOML), or the name of a published ship")->required();
  command.add_option("--model", a.model, "model of the ship to be found")
      ->required()
      ->check(CLI::IsMember({"mmg", "pi", "pu", "linear"}));
  command.add_option("--holdout", a.holdout, "recordings that are not used but predicted");
  command
      .add_option("--find", a.find,
                  "keys of the ship file to find, Y_v,N_v (default: those of the hull that are not 0)")
      ->delimiter(',');
  command.add_option("--also", a.also, "further keys to find, Y_vvr,N_vvr")->delimiter(',');
  command.add_option("--keep", a.keep, "keys that keep their value, X_0,X_u")->delimiter(',');
  command.add_option("--channels", a.channels, "columns to use, x_m,y_m,psi_rad (default: all that tell the motion)")
      ->delimiter(',');
  command
      .add_option(
          "--fit", a.fit,
          "what is fitted: forces of inverse dynamics, trajectories, or trajectories where the model explains them")
      ->check(CLI::IsMember({"auto", "forces", "trajectories"}))
      ->capture_default_str();
  command.add_flag("--prior", a.prior, "numbers of the ship file count as measurements, with its [confidence]");
  command.add_option("--ridge", a.ridge, "shrink coefficients as if so many samples had said 0")
      ->check(CLI::NonNegativeNumber);
  command.add_flag("--resample", a.resample,
                   "the same from other choices of runs: one left out, one alone, one rudder amplitude alone");
  command.add_option("--out", a.out, "ship file of the identified ship (TOML or .mat)");
  add_reading(command, a.reading);
  add_report(command, a.report);
  command.add_flag("--json", a.json, "print one JSON document");
  command.callback([&a] { identify(a); });
}

void add_sweep(CLI::App& app, SweepArguments& a) {
  auto& command =
      *app.add_subcommand("sweep", "manoeuvres of many ships: draws, grids and sensitivities of a plan; resumable");
  command.add_option("PLAN", a.plan, "what varies and what is done (TOML, docs/sweep.md)")->required();
  command.add_option("--out", a.out, "folder of the results; those that are there already are not made again")
      ->required();
  command.add_option("--csv", a.csv, "every item in a line, to this file (CSV)");
  command.add_option("--threads", a.threads, "how many work at once (default: one on each core)")
      ->check(CLI::Range(1, 4096));
  add_report(command, a.report);
  command.add_flag("--json", a.json, "print one JSON document");
  command.callback([&a] { sweep(a); });
}

void add_diagnose(CLI::App& app, DiagnoseArguments& a) {
  auto& command = *app.add_subcommand("diagnose", "say what a model leaves out, and whether held-out runs gain by it");
  add_ship(command, a.ship);
  command.add_option("runs", a.runs, "recordings (CSV or .mat)")->required();
  command.add_option("--reference", a.reference,
                     "recordings in which nothing is hidden: they calibrate the model first");
  command.add_option("--holdout", a.holdout, "recordings that are not used but predicted");
  command.add_option("--save-model", a.save_model, "ship file with the effects found (TOML or .mat)");
  add_report(command, a.report);
  add_reading(command, a.reading);
  command.add_flag("--json", a.json, "print one JSON document");
  command.callback([&a] { diagnose(a); });
}

void add_fleet(CLI::App& app, FleetArguments& a) {
  auto& command = *app.add_subcommand(
      "fleet", "sisters over months: what they have in common, what changed on whom, and since when");
  add_ship(command, a.ship);
  command.add_option("runs", a.runs, "recordings with start_utc (CSV or .mat), of each vessel in a folder of her own")
      ->required();
  command.add_option("--save-models", a.save_models, "folder for ship files of the class and of every vessel today");
  add_report(command, a.report);
  add_reading(command, a.reading);
  command.add_flag("--json", a.json, "print one JSON document");
  command.callback([&a] { fleet(a); });
}

/// Options that are missing, all in one message.
void require_dimensions(const EstimateArguments& a) {
  std::vector<std::string_view> missing;
  if (!a.length) missing.push_back("--length (between perpendiculars, m)");
  if (!a.beam) missing.push_back("--beam (m)");
  if (!a.draught) missing.push_back("--draught (mean, m)");
  if (!a.block) missing.push_back("--block (displaced volume over length, beam and draught)");
  if (a.out.empty()) missing.push_back("--out (the ship file to be written)");
  if (!missing.empty()) throw CLI::ValidationError("missing", fmt::format("{}", fmt::join(missing, ", ")));
}

void add_estimate(CLI::App& app, EstimateArguments& a) {
  auto& command = *app.add_subcommand("estimate", "a ship from her main dimensions, and how far the formulas agree");
  const auto positive_number = [&](const char* option, auto& value, const char* what) {
    return command.add_option(option, value, what)->check(CLI::PositiveNumber);
  };
  positive_number("--length", a.length, "length between perpendiculars in m; needed");
  positive_number("--beam", a.beam, "beam in m; needed");
  positive_number("--draught", a.draught, "mean draught in m; needed");
  positive_number("--block", a.block, "block coefficient; needed")->check(CLI::Range(0.0, 1.0));
  positive_number("--speed", a.speed, "service speed in m/s (default: by Froude number)");
  command.add_option("--trim", a.trim, "draught aft less draught forward in m")->capture_default_str();
  command.add_option("--x-g", a.x_g, "centre of gravity forward of midship in m")->capture_default_str();
  positive_number("--yaw-radius", a.yaw_radius, "yaw radius of gyration in m (default: a quarter of the length)");
  positive_number("--rudder-area", a.rudder_area, "movable area of all rudders together in m2");
  positive_number("--rudder-height", a.rudder_height, "span of each rudder in m");
  positive_number("--propeller-diameter", a.propeller_diameter, "diameter of each propeller in m");
  command.add_option("--wake", a.wake, "wake fraction at the propeller")->check(CLI::Range(-0.5, 0.95));
  command.add_option("--thrust-deduction", a.thrust_deduction, "thrust deduction fraction")
      ->check(CLI::Range(-0.5, 0.95));
  positive_number("--resistance", a.resistance, "resistance at the service speed in N");
  positive_number("--density", a.density, "density of the water in kg/m3")->capture_default_str();
  command.add_option("--screws", a.screws, "1, or 2 that turn together")->capture_default_str();
  command.add_option("--rudders", a.rudders, "1, or 2 that turn together")->capture_default_str();
  command.add_flag("--azimuth", a.azimuth, "the ship has azimuth thrusters or pods: refused, no model here has them");
  command.add_option("--ship-type", a.ship_type, "tanker, container, ferry, ro-ro, general cargo, ...: drag in wind");
  positive_number("--frontal-area", a.frontal_area, "projected area above water from ahead in m2");
  positive_number("--lateral-area", a.lateral_area, "the same from the side in m2");
  positive_number("--length-over-all", a.length_over_all, "length over all in m, lever of the wind's moment");
  auto* depth = positive_number("--depth", a.depth, "from keel to deck in m, where areas above water are not known");
  positive_number("--superstructure-length", a.superstructure_length, "of what stands on the deck, in m")->needs(depth);
  positive_number("--superstructure-height", a.superstructure_height, "its height above the deck in m")->needs(depth);
  command.add_option("--superstructure-x", a.superstructure_x, "its middle forward of midship in m")->needs(depth);
  command.add_option("--name", a.name, "name of the ship")->capture_default_str();
  command.add_option("--out", a.out, "ship file to be written (TOML or .mat); needed");
  command.add_flag("--json", a.json, "print one JSON document");
  command.callback([&a] {
    if (!a.azimuth && !names_steered_thrust(a.ship_type)) require_dimensions(a);
    estimate(a);
  });
}

void add_import(CLI::App& app, ImportArguments& a) {
  auto& command = *app.add_subcommand("import", "logs and spreadsheets to a recording; says what it takes for what");
  command
      .add_option("FILE", a.files,
                  "tables of text, logs of NMEA 0183, or a MATLAB file; several of a kind are joined by time")
      ->required();
  command.add_option("--out", a.out, "recording (CSV or .mat)")->required();
  command.add_flag("--split", a.split, "also a recording for each manoeuvre that is found in it");
  command.add_option("--columns", a.columns, "what the files do not say themselves: names, units, zone, signs (TOML)");
  command.add_flag("--json", a.json, "print one JSON document");
  command.callback([&a] { import_run(a); });
}

/// How large files may be, of every command but the one that reads none.
void add_file_limit(CLI::App& app) {
  const auto words =
      fmt::format("largest file that is read, like 4GB (default: {}GB of samples, {}MB of a ship or a plan)",
                  usual_samples_size / 1'000'000'000, usual_description_size / 1'000'000);
  for (auto* command : app.get_subcommands([](const CLI::App* one) { return one->get_name() != "estimate"; }))
    command->add_option_function<std::uint64_t>("--max-file-size", set_largest_file, words)
        ->transform(file_size)
        ->type_name("SIZE");
}

/// Says what was probably meant by a command that does not exist. @return whether there was one
bool refuse_unknown_command(int count, char** words) {
  if (count < 2 || words[1][0] == '-') return false;
  const std::string_view typed = words[1];
  if (std::ranges::count(commands, typed) > 0) return false;
  const auto hint = core::detail::did_you_mean(typed, commands);
  say_aside("swayaw: there is no command \"{}\"{}\n", typed, hint.empty() ? "; try swayaw --help" : hint);
  return true;
}

int run(int count, char** words) {
  if (refuse_unknown_command(count, words)) return wrong_usage;
  CLI::App app(
      "Ship steering dynamics: simulate manoeuvres, explain linear steering, and say where a model and a recording "
      "differ.",
      "swayaw");
  narrow_help(app);
  app.set_version_flag("--version", "swayaw " + std::string(version()));
  app.require_subcommand(1);
  SimulateArguments simulate_arguments;
  ReplayArguments replay_arguments;
  CheckArguments check_arguments;
  CompareArguments compare_arguments;
  ForcesArguments forces_arguments;
  LinearizeArguments linearize_arguments;
  IndicesArguments indices_arguments;
  ShipArguments ship_arguments;
  InvertArguments invert_arguments;
  LoopArguments loop_arguments;
  TrialArguments trial_arguments;
  TuneArguments tune_arguments;
  EstimateArguments estimate_arguments;
  IdentifyArguments identify_arguments;
  DiagnoseArguments diagnose_arguments;
  FleetArguments fleet_arguments;
  SweepArguments sweep_arguments;
  ImportArguments import_arguments;
  add_simulate(app, simulate_arguments);
  add_replay(app, replay_arguments);
  add_check(app, check_arguments);
  add_compare(app, compare_arguments);
  add_forces(app, forces_arguments);
  add_linearize(app, linearize_arguments);
  add_indices(app, indices_arguments);
  add_ship_command(app, ship_arguments);
  add_invert(app, invert_arguments);
  add_loop(app, loop_arguments);
  add_trial(app, trial_arguments);
  add_tune(app, tune_arguments);
  add_estimate(app, estimate_arguments);
  add_identify(app, identify_arguments);
  add_diagnose(app, diagnose_arguments);
  add_fleet(app, fleet_arguments);
  add_sweep(app, sweep_arguments);
  add_import(app, import_arguments);
  add_file_limit(app);
  add_examples(app);
  app.add_subcommand("completion",
                     "a script that completes commands and options: eval \"$(swayaw completion)\" in bash")
      ->callback([&app] { fmt::print("{}", completion_script(app)); });
  try {
    app.parse(count, words);
    return done;
  } catch (const CLI::Success& request) {
    return app.exit(request);
  } catch (const CLI::ParseError& error) {
    say_aside("swayaw: {}; try swayaw {}--help\n", error.what(),
              count > 1 && words[1][0] != '-' ? std::string(words[1]) + " " : "");
    return wrong_usage;
  }
}

}  // namespace
}  // namespace swayaw::app

int main(int count, char** words) {
  swayaw::app::take_part();
  try {
    return swayaw::app::run(count, words);
  } catch (const swayaw::FileError& error) {
    swayaw::app::say_aside("{}\n", error.what());
    if (::isatty(STDERR_FILENO) == 1) swayaw::app::print_aside(swayaw::app::with_caret(error.place()));
    return swayaw::app::bad_data;
  } catch (const std::exception& error) {
    swayaw::app::say_aside("swayaw: {}\n", error.what());
    return swayaw::app::bad_data;
  }
}
