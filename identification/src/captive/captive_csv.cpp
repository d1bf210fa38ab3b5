#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/detail/csv_text.hpp"
#include "swayaw/core/recording.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/identification/captive.hpp"

namespace swayaw::inline identification {
namespace {

/// Pieces of a text between separators, without blanks around them.
std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> pieces;
  while (pieces.empty() || text.data() != nullptr) pieces.emplace_back(detail::trimmed(detail::take(text, separator)));
  return pieces;
}

std::vector<std::string> cells_of(std::string_view line) {
  std::vector<std::string> cells;
  for (const auto cell : detail::cells_of(line)) cells.emplace_back(detail::unquoted(cell));
  return cells;
}

/// A row of the table, whose cells are asked for by name.
class Row {
 public:
  Row(const std::vector<std::string>& names, std::vector<std::string> cells, FilePlace place)
      : names_(names), cells_(std::move(cells)), place_(std::move(place)) {
    if (cells_.size() != names_.size())
      throw FileError(place_, fmt::format("{} cells in a table of {} columns", cells_.size(), names_.size()));
  }

  bool has(std::string_view name) const { return std::ranges::count(names_, name) > 0; }

  std::string text(std::string_view name) const { return has(name) ? cells_[place_of(name)] : ""; }

  double number(std::string_view name) const {
    if (!has(name)) lacks(name);
    const auto& cell = cells_[place_of(name)];
    if (detail::is_missing(cell)) return missing;
    if (const auto value = detail::number_in(cell)) return *value;
    throw FileError(place_, fmt::format("{}: \"{}\" is not a number", name, cell));
  }

  /// The first of these columns that is there, times its factor.
  std::optional<double> first_of(std::initializer_list<std::pair<std::string_view, double>> columns) const {
    for (const auto& [name, factor] : columns)
      if (has(name)) return number(name) * factor;
    return std::nullopt;
  }

  /// What a row cannot do without.
  void require_finite(std::initializer_list<double> numbers, std::string_view what) const {
    if (!std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); }))
      throw FileError(place_, fmt::format("{} of this row is missing, or is no finite number", what));
  }

  [[noreturn]] void lacks(std::string_view what) const {
    throw FileError({.file = place_.file}, fmt::format("captive tests need {}", what));
  }

 private:
  std::size_t place_of(std::string_view name) const {
    return static_cast<std::size_t>(std::ranges::find(names_, name) - names_.begin());
  }

  const std::vector<std::string>& names_;
  std::vector<std::string> cells_;
  FilePlace place_;
};

/// Units of the forces of a row: of primes, and of newtons measured on a model of another size.
struct Units {
  double prime;   ///< ½ρL²U² of the ship
  double newton;  ///< that over the one of the towed model
  double L, towed_L;

  Units(const CaptiveFile& o, double U) : L(o.L), towed_L(o.towed_L.value_or(o.L)) {
    prime = 0.5 * o.rho * L * L * U * U;
    newton = prime / (0.5 * o.towed_rho.value_or(o.rho) * towed_L * towed_L * U * U);
  }
};

/// @throws FileError  where a cell that tells the motion is missing, or tells one beyond all numbers
PlanarMotion<double> motion_of(const Row& row, double L) {
  const double beta = row.first_of({{"beta_rad", 1.0}, {"beta_deg", radians(1.0)}}).value_or(0.0);
  const auto U = row.first_of({{"U_m_s", 1.0}});
  if (!U && !row.has("u_m_s")) row.lacks("U_m_s, or u_m_s and v_m_s");
  const double u = U ? *U * std::cos(beta) : row.number("u_m_s");
  const double v = U ? -*U * std::sin(beta) : row.first_of({{"v_m_s", 1.0}}).value_or(0.0);
  const PlanarMotion<double> motion{u, v,
                                    row.first_of({{"r_prime", std::hypot(u, v) / L}, {"r_rad_s", 1.0}}).value_or(0.0)};
  row.require_finite({motion.u, motion.v, motion.r}, "the motion");
  return motion;
}

Controls<double> controls_of(const Row& row, const Units& units, const CaptiveFile& options) {
  const double delta = row.first_of({{"delta_rad", 1.0}, {"delta_deg", radians(1.0)}}).value_or(0.0);
  const auto by_thrust = [&](double T) {
    return Controls<double>{.delta = delta, .thrust = {0.5 * T, 0.5 * T}, .by_thrust = true};
  };
  if (row.has("R_N")) return by_thrust(0.0);
  if (const auto T = row.first_of({{"T_prime", units.prime}, {"thrust_N", units.newton}})) return by_thrust(*T);
  if (options.thrust_prime) return by_thrust(*options.thrust_prime * units.prime);
  if (!row.has("rev_s")) row.lacks("T_prime, thrust_N or rev_s");
  return {.delta = delta, .rev = row.number("rev_s")};
}

PlanarForce<double> measured_of(const Row& row, const Units& units) {
  if (row.has("R_N")) return {-row.number("R_N") * units.newton, missing, missing};
  const double moment = units.newton * units.L / units.towed_L;
  return {row.first_of({{"X_prime", units.prime}, {"X_N", units.newton}}).value_or(missing),
          row.first_of({{"Y_prime", units.prime}, {"Y_N", units.newton}}).value_or(missing),
          row.first_of({{"N_prime", units.prime * units.L}, {"N_N_m", moment}}).value_or(missing)};
}

std::vector<std::string> tests_of(const Row& row, const CaptiveFile& options) {
  for (const auto* name : {"test_type", "test"})
    if (row.has(name)) return split(row.text(name), '+');
  return {options.test};
}

CaptivePoint steady_point(const Row& row, const CaptiveFile& options) {
  const auto motion = motion_of(row, options.L);
  const Units units(options, speed(motion));
  return {.run = row.text("run"),
          .tests = tests_of(row, options),
          .moments = {{motion, {}, controls_of(row, units, options)}},
          .measured = measured_of(row, units)};
}

// ---------------------------------------------------------------- oscillating tests

/// Fourier coefficient of a cycle: cosine of the phase, sine, or cosine of twice the phase.
struct Harmonic {
  const char* name;
  const char* column;
  double (*weight)(double phase);
};

constexpr std::array<Harmonic, 3> harmonics{{
    {"velocity", "out", [](double phase) { return 2.0 * std::cos(phase); }},
    {"acceleration", "in", [](double phase) { return 2.0 * std::sin(phase); }},
    {"second", "in2", [](double phase) { return 2.0 * std::cos(2.0 * phase); }},
}};

/// Phases of a cycle: exact for forces up to the 20th harmonic.
constexpr int phases = 24;

/// Velocities go as the cosine of the phase, accelerations as the sine.
struct Oscillation {
  double v = 0.0, r = 0.0, dv = 0.0, dr = 0.0;  ///< amplitudes
};

Oscillation oscillation_of(const Row& row, const CaptiveFile& o, double U) {
  if (row.has("r_prime_amp"))
    return {.r = row.number("r_prime_amp") * U / o.L, .dr = row.number("rdot_prime_amp") * U * U / (o.L * o.L)};
  // v' = v_a cos, dv'/ds' = −v_a ω' sin with ω' = 2π f L/U of the towed model
  const double omega = 2.0 * std::numbers::pi * row.number("freq_hz") * o.towed_L.value_or(o.L) / U;
  const double dv = row.number("vdot_prime_amp");
  return {.v = -dv / omega * U, .dv = dv * U * U / o.L};
}

std::vector<CaptiveMoment> cycle(const PlanarMotion<double>& mean, const Oscillation& a,
                                 const Controls<double>& controls, const Harmonic& harmonic) {
  std::vector<CaptiveMoment> moments;
  for (int k = 0; k < phases; ++k) {
    const double phase = 2.0 * std::numbers::pi * k / phases, c = std::cos(phase), s = std::sin(phase);
    moments.push_back({{mean.u, mean.v + a.v * c, mean.r + a.r * c},
                       {0.0, a.dv * s, a.dr * s},
                       controls,
                       harmonic.weight(phase) / phases});
  }
  return moments;
}

/// The T_prime of an oscillating test is an amplitude, so that the thrust of these tests is that of the options, or
/// follows from the shaft.
void add_oscillating_points(const Row& row, const CaptiveFile& options, std::vector<CaptivePoint>& points) {
  const auto mean = motion_of(row, options.L);
  const double U = speed(mean);
  const Units units(options, U);
  const auto a = oscillation_of(row, options, U);
  row.require_finite({a.v, a.r, a.dv, a.dr}, "the oscillation");
  const auto controls = controls_of(row, units, options);
  for (const auto& h : harmonics) {
    const auto column = [&](const char* force) { return fmt::format("{}_{}_prime", force, h.column); };
    if (!row.has(column("Y"))) continue;
    points.push_back(
        {.run = row.text("run"),
         .tests = {fmt::format("{}:{}", tests_of(row, options).front(), h.name)},
         .moments = cycle(mean, a, controls, h),
         .measured = {missing, row.number(column("Y")) * units.prime, row.number(column("N")) * units.prime * units.L},
         .with_inertia = true});
  }
}

}  // namespace

std::vector<CaptivePoint> read_captive(const std::filesystem::path& file, const CaptiveFile& options) {
  require_positive(options.L, "ship length L [m]");
  std::vector<std::string> names;
  std::vector<CaptivePoint> points;
  std::size_t number = 0;
  const auto text = read_text(file);
  for (std::string_view rest = text; !rest.empty();) {
    const auto line = detail::trimmed(detail::take(rest, '\n'));
    ++number;
    if (line.empty() || line.front() == '#') continue;
    if (names.empty()) {
      names = cells_of(line);
      continue;
    }
    const Row row(names, cells_of(line), {file, number, 1});
    if (row.has("freq_hz")) add_oscillating_points(row, options, points);
    else points.push_back(steady_point(row, options));
  }
  if (points.empty()) throw FileError({.file = file}, "no captive tests");
  return points;
}

}  // namespace swayaw::identification
