#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "commands.hpp"
#include "input.hpp"
#include "linear_output.hpp"
#include "simulate_output.hpp"
#include "swayaw/core/steered_thrust.hpp"
#include "swayaw/core/version.hpp"
#include "swayaw/nonlinear/estimates/estimate_spread.hpp"
#include "swayaw/nonlinear/manoeuvres/imo_criteria.hpp"
#include "swayaw/nonlinear/surroundings/windage_sources.hpp"
#include "terminal.hpp"

/// swayaw estimate: a ship from main dimensions.
namespace swayaw::app {
namespace {

// ---------------------------------------------------------------- what is asked

/// Froude number U/sqrt(g L) of a ship whose speed is not told: the middle of 0.12 to 0.22, where the estimate was
/// tried on random merchant ships (docs/estimates.md).
constexpr double assumed_froude = 0.17;
constexpr double tried_froude_low = 0.12, tried_froude_high = 0.22;
constexpr double gravity = 9.80665;  ///< [m/s^2]

/// Smaller craft are scale models or boats, whose steering gear SOLAS does not rule: its ships begin at 500 gross tons,
/// some 40 m [m].
constexpr double smallest_ship = 40.0;

/// Radii of gyration over L outside of which a number was probably not meant so; ships have 0.22 to 0.27.
constexpr double least_yaw_radius = 0.15, most_yaw_radius = 0.40;

/// A resistance that is so many times the estimate, or less than it by that, was probably not meant in newtons: that of
/// KVLCC2 is 3.1 times, of KCS 2.3 times the estimate, which has no waves.
constexpr double odd_resistance = 5.0;

/// A word of --ship-type and the drag in wind that it means.
struct TypeWord {
  std::string_view word;
  std::string_view drag;  ///< of blendermann_ships
};
constexpr std::array type_words{
    TypeWord{"tanker", "tanker_loaded"},
    TypeWord{"bulk carrier", "cargo_vessel_loaded"},
    TypeWord{"general cargo", "cargo_vessel_loaded"},
    TypeWord{"container", "container_ship_loaded"},
    TypeWord{"ferry", "ferry"},
    TypeWord{"ro-ro", "car_carrier"},
    TypeWord{"gas carrier", "gas_tanker"},
    TypeWord{"supply", "offshore_supply_vessel"},
    TypeWord{"research", "research_vessel"},
    TypeWord{"fishing", "fishing_vessel"},
    TypeWord{"passenger", "passenger_liner"},
};

/// Craft for which a hull in calm water at low Froude number, moved by propeller and rudder, is no model.
struct OtherCraft {
  std::string_view word;
  std::string_view why;
};
constexpr std::string_view lifted =
    "is carried by her speed; the formulas are for displacement hulls at low Froude number";
constexpr std::string_view two_hulls = "has hulls side by side; the formulas are for one hull";
constexpr std::string_view under_sail =
    "is driven and heeled by her sails; the formulas are for a hull upright under screw";
constexpr std::array other_craft{
    OtherCraft{"speed_boat", lifted},
    OtherCraft{"planing", lifted},
    OtherCraft{"hydrofoil", lifted},
    OtherCraft{"hovercraft", lifted},
    OtherCraft{"catamaran", two_hulls},
    OtherCraft{"trimaran", two_hulls},
    OtherCraft{"swath", two_hulls},
    OtherCraft{"sailing", under_sail},
    OtherCraft{"submarine", "has no free surface; the formulas are for ships afloat"},
    OtherCraft{"barge", "has no propeller and rudder of her own"},
};

std::string small_letters(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// @throws Refusal  naming the craft
void refuse_other_craft(const EstimateArguments& a) {
  if (a.azimuth) throw Refusal(fmt::format("--azimuth: an azimuth drive {}", no_steered_thrust));
  if (names_steered_thrust(a.ship_type))
    throw Refusal(fmt::format("--ship-type {}: it {}", a.ship_type, no_steered_thrust));
  for (const auto& craft : other_craft)
    if (small_letters(a.ship_type).find(craft.word) != std::string::npos)
      throw Refusal(fmt::format("--ship-type {}: such a craft {}", a.ship_type, craft.why));
}

/// The type of blendermann_ships that is meant; a loaded tanker's drag where none is told, as in ship files.
/// @throws Refusal  listing the types
std::string_view drag_type(const std::string& told) {
  if (told.empty()) return "tanker_loaded";
  const auto type = small_letters(told);
  const auto word = std::ranges::find(type_words, type, &TypeWord::word);
  if (word != type_words.end()) return word->drag;
  const auto known = std::ranges::find(blendermann_ships, type, &BlendermannShip::type);
  if (known != blendermann_ships.end()) return known->type;
  std::vector<std::string_view> words;
  for (const auto& t : type_words) words.push_back(t.word);
  throw Refusal(
      fmt::format("--ship-type \"{}\" is not known; known are {}, and the types of [windage] in docs/formats.md", told,
                  fmt::join(words, ", ")));
}

// ---------------------------------------------------------------- the answer

struct Estimate {
  HullDimensions<double> hull;
  double speed;
  EstimatedShip guess;
  std::vector<CoefficientSpread> spread;
  Ship ship;
  std::optional<LinearShip> linear;
  std::vector<Criterion> criteria;  ///< to starboard; the ship is the same to port
  std::string not_sailed;           ///< why there are none
};

EstimateOptions options_for(const EstimateArguments& a, const HullDimensions<double>& hull, double speed) {
  EstimateOptions o;
  o.hull = hull.trim == 0.0 ? HullFormula::yoshimura_masumoto : HullFormula::kijima;
  o.rho = a.density;
  o.x_G = a.x_g;
  if (a.yaw_radius) o.k_zz_prime = *a.yaw_radius / hull.L;
  o.rudder_area = a.rudder_area;
  o.rudder_height = a.rudder_height;
  o.propeller_diameter = a.propeller_diameter;
  o.wake_fraction = a.wake;
  o.thrust_deduction = a.thrust_deduction;
  // R_0' = R/(½ρLdU²)
  if (a.resistance) o.resistance = *a.resistance / (0.5 * a.density * hull.L * hull.d * speed * speed);
  o.screws = a.screws;
  o.rudders = a.rudders;
  return o;
}

/// Areas above water: given, or those of a hull with straight sides and one block on its deck.
///
///     A_L = L_OA (D − d) + l h,   A_F = B (D − d + h),   x_A = l h x/A_L
Windage<double> windage_for(const EstimateArguments& a, const HullDimensions<double>& hull, EstimatedShip& guess) {
  const double length = a.length_over_all.value_or(hull.L);
  const double side = a.superstructure_length.value_or(0.0) * a.superstructure_height.value_or(0.0);
  if (a.depth && *a.depth <= hull.d)
    throw Refusal(
        fmt::format("--depth {} m, from keel to deck, must be more than the draught of {} m", *a.depth, hull.d));
  const double freeboard = a.depth ? *a.depth - hull.d : 0.0;
  const double lateral = a.lateral_area.value_or(a.depth ? length * freeboard + side : 0.0);
  const double frontal =
      a.frontal_area.value_or(a.depth ? hull.B * (freeboard + a.superstructure_height.value_or(0.0)) : 0.0);
  const auto windage = windage_from({.frontal = frontal, .lateral = lateral, .length = length}, drag_type(a.ship_type));
  if (!windage) {
    guess.assumptions.push_back(
        "areas above water not known: she feels no wind; --frontal-area and --lateral-area tell them, or --depth with "
        "--superstructure-length and --superstructure-height");
    return {};
  }
  auto result = *windage;
  if (!a.lateral_area) result.x_A = side * a.superstructure_x.value_or(0.0) / lateral;
  guess.ship.particulars.A_front = frontal;
  guess.ship.particulars.A_lateral = lateral;
  guess.assumptions.push_back(
      fmt::format("above water: frontal area {:.4g} m2{}, lateral area {:.4g} m2{} with its centroid {:.4g} m forward "
                  "of midship, drag "
                  "of the type {} (Blendermann)",
                  frontal, a.frontal_area ? "" : " of a box", lateral, a.lateral_area ? "" : " of a box", result.x_A,
                  drag_type(a.ship_type)));
  return result;
}

void add_warnings(const EstimateArguments& a, double speed, const HullDimensions<double>& hull, EstimatedShip& guess) {
  const double froude = speed / std::sqrt(gravity * hull.L);
  if (froude < tried_froude_low || froude > tried_froude_high)
    guess.warnings.push_back(fmt::format(
        "Froude number {:.3g} lies outside {} to {}, where the estimate was tried; waves are not in the resistance",
        froude, tried_froude_low, tried_froude_high));
  if (hull.L < smallest_ship)
    guess.warnings.push_back(fmt::format(
        "a length of {:.4g} m: the rudder rate of {:.2g} deg/s is that of a ship under SOLAS, scale models turn "
        "it faster; rate_deg_s in [rudder] of the file is to be put right",
        hull.L, degrees(guess.ship.steering_gear.rate)));
  if (a.yaw_radius && (*a.yaw_radius < least_yaw_radius * hull.L || *a.yaw_radius > most_yaw_radius * hull.L))
    guess.warnings.push_back(
        fmt::format("yaw radius of gyration {:.4g} m is {:.3g} of the length; ships have about 0.25", *a.yaw_radius,
                    *a.yaw_radius / hull.L));
  const double friction = estimated_resistance(hull, speed), R_0 = guess.ship.hull.R_0;
  if (R_0 > odd_resistance * friction || odd_resistance * R_0 < friction)
    guess.warnings.push_back(
        fmt::format("the resistance is {:.3g} times the estimate without waves; newtons are meant", R_0 / friction));
  if (std::abs(a.x_g) > 0.05 * hull.L)
    guess.warnings.push_back(
        fmt::format("centre of gravity {:.4g} m from midship is {:.2g} of the length; ships have less than 0.05", a.x_g,
                    a.x_g / hull.L));
}

void sail(Estimate& e) {
  try {
    e.linear = linear_ship(e.ship, linearize(e.ship, straight_course(e.ship, e.speed)));
    e.criteria = imo_criteria(e.ship).criteria;
    std::erase_if(e.criteria, [](const Criterion& c) { return c.side != Side::starboard; });
  } catch (const Refusal& trouble) {
    e.not_sailed = trouble.what();
  }
}

Estimate estimate_for(const EstimateArguments& a) {
  const HullDimensions<double> hull{.L = *a.length, .B = *a.beam, .d = *a.draught, .C_B = *a.block, .trim = a.trim};
  if (!(hull.d < hull.B && hull.B < hull.L))
    throw Refusal(fmt::format(
        "the length must be more than the beam, and the beam more than the draught; got L {} m, B {} m, d {} m", hull.L,
        hull.B, hull.d));
  const double speed = a.speed.value_or(assumed_froude * std::sqrt(gravity * hull.L));
  const auto options = options_for(a, hull, speed);
  auto guess = estimated_mmg_ship(hull, speed, options);
  if (!a.speed)
    guess.assumptions.insert(guess.assumptions.begin(),
                             fmt::format("service speed {:.4g} m/s: Froude number {}", speed, assumed_froude));
  add_warnings(a, speed, hull, guess);
  auto spread = estimate_spread(hull, guess, options);
  const auto windage = windage_for(a, hull, guess);
  Ship ship{.name = a.name,
            .model = guess.ship,
            .confidence = confidence_of(spread),
            .surroundings = {.windage = windage, .wind = {}, .current = {}}};
  Estimate e{.hull = hull,
             .speed = speed,
             .guess = std::move(guess),
             .spread = std::move(spread),
             .ship = std::move(ship),
             .linear = {},
             .criteria = {},
             .not_sailed = {}};
  sail(e);
  return e;
}

// ---------------------------------------------------------------- words

/// "L 320 m, B 58 m, …".
std::string dimensions_text(const Estimate& e) {
  auto text = fmt::format("L {:.5g} m, B {:.4g} m, d {:.4g} m, C_B {:.4g}", e.hull.L, e.hull.B, e.hull.d, e.hull.C_B);
  if (e.hull.trim != 0.0) text += fmt::format(", trim {:.3g} m", e.hull.trim);
  return text + fmt::format(", {:.4g} m/s, Froude number {:.3f}", e.speed, e.speed / std::sqrt(gravity * e.hull.L));
}

/// "2 formulas", "assumed", and what decided the deviation.
std::string basis_of(const CoefficientSpread& s) {
  if (s.given) return "given; the trust in any published number";
  const auto count = s.distinct();
  const auto formulas = count == 0 ? std::string("assumed") : fmt::format("{} formula{}", count, count == 1 ? "" : "s");
  const bool by_formulas = s.between_formulas >= s.from_measured;
  const double larger = std::max(s.between_formulas, s.from_measured);
  if (larger <= trust_in_published) return formulas + "; 10 % as a published number";
  return formulas + (by_formulas ? "; between the formulas" : "; from the measured ships");
}

std::string values_text(const CoefficientSpread& s) {
  std::vector<std::string> texts;
  for (const auto& f : s.formulas) texts.push_back(fmt::format("{} {:.4g}", f.formula, f.value));
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::string remark_of(const Estimate& e) {
  auto text = fmt::format("Estimated by swayaw {} from {}.\nA first guess; recordings correct it: swayaw identify.",
                          version(), dimensions_text(e));
  for (const auto& warning : e.guess.warnings) text += "\nOutside what the formulas are for: " + warning + ".";
  text += "\nAssumed:";
  for (const auto& line : e.guess.assumptions) text += "\n  " + line;
  text +=
      "\n[confidence]: relative standard deviation, the larger of how far other formulas are from the value and how "
      "far "
      "estimates of KVLCC2 and KCS are from measurement,\n  between 0.1 and 10. What formulas tell:";
  for (const auto& s : e.spread)
    text += fmt::format("\n  {} = {:.4g} +- {:.0f} %: {}{}{}", s.key, s.value, 100.0 * s.relative(), basis_of(s),
                        s.formulas.empty() ? "" : ": ", values_text(s));
  return text;
}

// ---------------------------------------------------------------- JSON

Json spread_json(const std::vector<CoefficientSpread>& spread) {
  Json list = Json::array();
  for (const auto& s : spread) {
    Json formulas = Json::array();
    for (const auto& f : s.formulas) formulas.push_back({{"formula", f.formula}, {"value", number(f.value)}});
    list.push_back({{"key", s.key},
                    {"value", number(s.value)},
                    {"relative_deviation", number(s.relative())},
                    {"formulas", std::move(formulas)},
                    {"distinct_formulas", s.distinct()},
                    {"between_formulas", number(s.between_formulas)},
                    {"from_measured_ships", number(s.from_measured)},
                    {"given", s.given},
                    {"basis", basis_of(s)}});
  }
  return list;
}

Json document_of(const Estimate& e, const EstimateArguments& a) {
  return {{"schema", "swayaw.estimate/1"},
          {"version", version()},
          {"ship", e.ship.name},
          {"out", a.out.string()},
          {"length_m", e.hull.L},
          {"beam_m", e.hull.B},
          {"draught_m", e.hull.d},
          {"block_coefficient", e.hull.C_B},
          {"trim_m", e.hull.trim},
          {"service_speed_m_s", number(e.speed)},
          {"assumptions", e.guess.assumptions},
          {"warnings", e.guess.warnings},
          {"coefficients", spread_json(e.spread)},
          {"indices", e.linear ? indices_json(*e.linear, e.speed) : Json(nullptr)},
          {"criteria", criteria_json(e.criteria)},
          {"not_sailed", e.not_sailed.empty() ? Json(nullptr) : Json(e.not_sailed)}};
}

// ---------------------------------------------------------------- text

/// Below each number what formulas say of it, where they do not agree.
void print_spread(const std::vector<CoefficientSpread>& spread) {
  say("\n  {:<18}{:>12}{:>8}  {}\n", "coefficient", "value", "sd %", "how it is told");
  for (const auto& s : spread) {
    say("  {:<18}{:>12.4g}{:>8.0f}  {}\n", s.key, s.value, 100.0 * s.relative(), basis_of(s));
    if (s.distinct() > 1) say("      {}\n", values_text(s));
  }
}

void print_text(const Estimate& e, const EstimateArguments& a) {
  say("{}: {}\n\nassumed\n", e.ship.name, dimensions_text(e));
  for (const auto& line : e.guess.assumptions) say("  {}\n", line);
  print_spread(e.spread);
  say("\nwhat she does at {:.4g} m/s, the same to both sides\n", e.speed);
  if (e.linear) print_steering(*e.linear, e.speed);
  print_criteria(e.criteria);
  if (!e.not_sailed.empty()) say("  not all of it could be sailed: {}\n", e.not_sailed);
  const auto out = a.out.string();
  say("\nnext\n  her manoeuvres\n    swayaw simulate {} --turn 35 --out turn.csv\n", out);
  say("  a recorded manoeuvre beside hers\n    swayaw trial RUN.csv --ship {}\n", out);
  say("  her numbers from recordings\n    swayaw identify RUN.csv --ship {} --model mmg --prior --out new.toml\n", out);
}

}  // namespace

void estimate(const EstimateArguments& a) {
  refuse_other_craft(a);
  (void)drag_type(a.ship_type);
  const auto result = estimate_for(a);
  for (const auto& warning : result.guess.warnings) say_aside("swayaw: {}\n", warning);
  write_ship(a.out, result.ship, remark_of(result));
  if (a.json) print_document(document_of(result, a));
  else print_text(result, a);
  say_aside("swayaw: ship file written to {}\n", a.out.string());
}

}  // namespace swayaw::app
