#pragma once

#include <filesystem>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "swayaw/core/motion.hpp"
#include "swayaw/identification/regression.hpp"
#include "swayaw/nonlinear/models/controls.hpp"
#include "swayaw/nonlinear/ship.hpp"

/// Captive tests: a carriage moves the model as it likes and measures the force that this takes. docs/captive_tests.md
namespace swayaw::inline identification {

/// A moment of a test. Force(s) of a test are Σ weight × force over its moments: one moment for a steady test, a
/// cycle for a Fourier coefficient of an oscillating one.
struct CaptiveMoment {
  PlanarMotion<double> motion;
  PlanarAcceleration<double> acceleration;
  Controls<double> controls;
  double weight = 1.0;
};

/// One measurement.
struct CaptivePoint {
  std::string run;
  std::vector<std::string> tests;  ///< kinds of test it belongs to: "static_drift", "pure_yaw:velocity"
  std::vector<CaptiveMoment> moments;
  PlanarForce<double> measured;  ///< about midship [N, N m]; not a number where it was not measured
  bool with_inertia = false;     ///< the force that accelerates the model herself is still in it
};

/// Where the parameters of a file come from, and for which ship they are read. Primes stay as they are: forces are
/// those of the ship at the same speed.
struct CaptiveFile {
  double L;                            ///< of the ship [m]
  double rho = 1000.0;                 ///< of her water [kg/m^3]
  std::optional<double> towed_L = {};  ///< of the model in the tank [m], where it was another
  std::optional<double> towed_rho = {};
  std::string test = {};                    ///< kind of all tests, where the file does not say
  std::optional<double> thrust_prime = {};  ///< T/(½ρL²U²) where the file does not say
};

/// Reads a table with a header. Units show in the names of its columns.
///
///     motion    U_m_s with beta_deg or beta_rad, or u_m_s and v_m_s;  r_prime or r_rad_s
///     controls  delta_deg or delta_rad;  T_prime or thrust_N, else rev_s
///     measured  X_prime, Y_prime, N_prime over ½ρL²U² and ½ρL³U², or X_N, Y_N, N_N_m;  R_N, the resistance without
///     propeller test      test_type, several joined by +;  run
///
/// Oscillating tests have freq_hz and amplitudes vdot_prime_amp, or r_prime_amp and rdot_prime_amp; displacement goes
/// as the sine. They give points of three kinds, "pure_yaw:velocity" from Y_out_prime and N_out_prime (cosine),
/// "pure_yaw:acceleration" from Y_in_prime, N_in_prime (sine), and "pure_yaw:second" from Y_in2_prime, N_in2_prime
/// (cosine of twice the phase), all with the inertia of the model in them. Their X is left out: docs/captive_tests.md
/// tells why.
///
/// @throws FileError  naming the column that is missing, or the cell that is no number
std::vector<CaptivePoint> read_captive(const std::filesystem::path& file, const CaptiveFile& options);

/// Which points.
struct CaptiveSelection {
  std::vector<std::string> tests = {};                          ///< of one of these kinds; empty: of every kind
  double max_drift = std::numeric_limits<double>::infinity();   ///< |beta| [rad]
  double max_rudder = std::numeric_limits<double>::infinity();  ///< |delta| [rad]
  double min_rudder = 0.0;                                      ///< [rad]
  double min_speed = 0.0;                                       ///< [m/s]
  std::vector<std::string> without_runs = {};
};

std::vector<CaptivePoint> selected(std::span<const CaptivePoint> points, const CaptiveSelection& selection);

/// Force that a point would measure of this ship: hull, propeller and rudder, less what accelerates the entrained
/// water, and less what accelerates the ship herself where that is in the measurement.
PlanarForce<double> captive_force(const Ship& ship, const CaptivePoint& point);

/// Model less measurement, over points that have been measured; not a number where there are none. Forces count as
/// primes, over ½ρL²U² and ½ρL³U².
struct CaptiveError {
  std::size_t points;
  PlanarForce<double> rms;       ///< of model less measured
  PlanarForce<double> measured;  ///< rms of what was measured

  /// rms of the error over that of the measurement. Near self-propulsion X is a small difference of large forces and
  /// its share large.
  PlanarForce<double> relative() const;
};

CaptiveError captive_error(const Ship& ship, std::span<const CaptivePoint> points,
                           const CaptiveSelection& selection = {});

/// Relative rms of X, Y and N over steady drift with the rudder amidships.
PlanarForce<double> captive_error(const Ship& ship, std::span<const CaptivePoint> points, double max_drift);

enum class ForceComponent { X, Y, N };

/// "X", "Y", "N"
std::string_view in_words(ForceComponent component);

/// Some coefficients from some tests; what the rest of the ship does is taken off the measurement first.
struct CaptiveStep {
  CaptiveSelection points;
  ForceComponent component;
  std::vector<std::string> coefficients;
};

/// Steps in their order: what one has found is known to the next.
struct CaptivePlan {
  std::vector<CaptiveStep> steps;
  CaptiveSelection validation;  ///< points that no step may use
};

struct CaptiveStepReport {
  CaptiveStep step;
  std::size_t points;
  Regression fit;           ///< of primes; coefficients in SI or as the primes they are
  CaptiveError validation;  ///< of the ship with what is found so far
};

struct CaptiveFit {
  Ship ship;  ///< with the coefficients found
  std::vector<CaptiveStepReport> steps;
  CaptiveError validation;  ///< after the last step
};

/// Step by step. Coefficients that the plan finds count as 0 until they are found; a step that does not determine one
/// leaves it 0. Features are derivatives of the force model by its coefficients.
///
/// Standard errors of a step take what earlier steps found for exact.
///
/// Source: [Alexandersson2024] section 3.1, tables 2, 3
///
/// @throws Refusal  if the model lacks a coefficient, its force is not linear in the coefficients of a step, points are
/// both
///                  fitted and kept for validation, or a step has too few points
CaptiveFit fit_captive(const Ship& ship, std::span<const CaptivePoint> points, const CaptivePlan& plan,
                       const RegressionOptions& options = {});

/// Terms of the hull.
enum class HullTerms { linear, cubic };

/// The steps of Alexandersson et al. 2024, table 3, and like ones for the sway force of yawing, cubic terms and added
/// mass: those whose coefficients the model has and whose tests are among the points. Kinds of test: static_rudder,
/// resistance, static_drift, circle or pure_yaw, circle_drift or yaw_drift, pure_sway; kept for validation:
/// static_drift_rudder.
///
/// @param max_drift  of the points that are used [rad]
CaptivePlan captive_plan(const Ship& ship, std::span<const CaptivePoint> points, HullTerms terms, double max_drift);

}  // namespace swayaw::identification
