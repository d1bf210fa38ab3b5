#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/estimates/estimated_ship.hpp"
#include "swayaw/nonlinear/estimates/kijima.hpp"
#include "swayaw/nonlinear/steady_motion.hpp"

namespace swayaw::inline nonlinear {
namespace {

void require_hull(const HullDimensions<double>& hull) {
  require_positive(hull.L, "ship length L [m]");
  require_positive(hull.B, "beam B [m]");
  require_positive(hull.d, "draught d [m]");
  require_positive(hull.C_B, "block coefficient C_B");
}

/// Collects what was assumed while the ship is put together.
class Assumptions {
 public:
  /// The given number, checked, or the estimate, noted.
  double number(const std::optional<double>& given, double estimate, std::string_view what, std::string_view how) {
    if (given) return require_positive(*given, what);
    notes_.push_back(fmt::format("{} = {:.4g}: {}", what, estimate, how));
    return estimate;
  }
  void note(std::string text) { notes_.push_back(std::move(text)); }
  std::vector<std::string> notes() && { return std::move(notes_); }

 private:
  std::vector<std::string> notes_;
};

/// K_T of KVLCC2, its zero, and its wake change. Source: [Yasukawa2015]
struct ReferencePropeller {
  double k_0 = 0.2931, k_1 = -0.2753, k_2 = -0.1385;
  double C_1 = 2.0, C_2_positive = 1.6, C_2_negative = 1.1;

  double zero_thrust() const { return (-k_1 - std::sqrt(k_1 * k_1 - 4.0 * k_2 * k_0)) / (2.0 * k_2); }
};

/// Diameter over draught: 0.7 for fine ships, 0.5 for full ones.
double diameter_over_draught(double C_B) { return std::clamp(0.7 - (C_B - 0.65) * (0.2 / 0.15), 0.5, 0.7); }

/// Pitch factor p for which J = 2/3 J_0 p at the thrust wanted.
///
///     K_T/J² = c,  K_T = p (k_0 + k_1 j + k_2 j²),  J = p j   →   p = (k_0 + k_1 j + k_2 j²)/(c j²)
double pitch_factor(const ReferencePropeller& reference, double loading) {
  const double j = reference.zero_thrust() * (2.0 / 3.0);
  return std::clamp((reference.k_0 + reference.k_1 * j + reference.k_2 * j * j) / (loading * j * j), 1.0, 1.6);
}

/// K_T/J² = T/(ρ D² u_P²) that carries the ship at her service speed.
double thrust_loading(const HullDimensions<double>& hull, double R_0, const MmgPropeller<double>& p) {
  const double u_P = 1.0 - p.w_P0;  // over U
  return 0.5 * hull.L * hull.d * R_0 / ((1.0 - p.t_P) * p.D * p.D * u_P * u_P);
}

/// Linear size of the one propeller, or rudder, that has the area of so many.
double enlargement(int count) { return std::sqrt(static_cast<double>(count)); }

double taylor_wake(const HullDimensions<double>& hull, int screws) {
  return screws == 2 ? 0.55 * hull.C_B - 0.20 : 0.5 * hull.C_B - 0.05;
}

/// The thrust curve of so many propellers of the diameter D as that of one with the same disc area, at the same shaft
/// speed n. With z screws, J is sqrt(z) times smaller there, and K_T z times:
///
///     K_T(J) = k_0/z + k_1/sqrt(z) J + k_2 J²
void make_one_of(int screws, MmgPropeller<double>& p) {
  p.k_0 /= screws;
  p.k_1 /= enlargement(screws);
}

MmgPropeller<double> propeller_of(const HullDimensions<double>& hull, double R_0, const EstimateOptions& options,
                                  Assumptions& assumed) {
  const ReferencePropeller reference;
  const double C_2 = 0.5 * (reference.C_2_positive + reference.C_2_negative);
  const double size = enlargement(options.screws);
  const bool twin = options.screws == 2;
  MmgPropeller<double> p{};
  p.D = size * assumed.number(options.propeller_diameter, diameter_over_draught(hull.C_B) * hull.d / size,
                              "propeller diameter [m]",
                              twin ? "each, with the disc area of one screw of 0.7 to 0.5 of the draught"
                                   : "0.7 to 0.5 of the draught, by block coefficient");
  p.x_P = -0.48;
  p.w_P0 = assumed.number(options.wake_fraction, taylor_wake(hull, options.screws), "wake fraction w_P0",
                          twin ? "0.55 C_B - 0.20, Taylor for two screws" : "C_B/2 - 0.05, Taylor");
  p.t_P = assumed.number(options.thrust_deduction, 0.6 * p.w_P0, "thrust deduction t_P", "0.6 w_P0");
  const double pitch = pitch_factor(reference, thrust_loading(hull, R_0, p));
  p.k_0 = reference.k_0 * pitch;
  p.k_1 = reference.k_1;
  p.k_2 = reference.k_2 / pitch;
  make_one_of(options.screws, p);
  p.C_1 = reference.C_1;
  p.C_2_positive = p.C_2_negative = C_2;
  assumed.note(
      fmt::format("thrust curve of KVLCC2 with its pitch times {:.3g}; its wake change, C_1 = {:.3g}, C_2 = {:.3g} on "
                  "both sides; x_P' = {:.3g}",
                  pitch, p.C_1, C_2, p.x_P));
  if (twin)
    assumed.note(fmt::format(
        "two screws that turn together stand as one propeller of the same disc area, diameter {:.4g} m, with their "
        "thrust and race at their shaft speed",
        p.D));
  return p;
}

MmgRudder<double> rudder_of(const HullDimensions<double>& hull, const MmgPropeller<double>& propeller,
                            const EstimateOptions& options, Assumptions& assumed) {
  const auto i = yoshimura_masumoto_interaction(hull, propeller.w_P0);
  const double A_R =
      assumed.number(options.rudder_area, dnv_rudder_area(hull), "rudder area [m2]",
                     options.rudders == 2 ? "rule of Det Norske Veritas, both together" : "rule of Det Norske Veritas");
  const double size = enlargement(options.screws);  // a rudder behind each of two screws grows with its screw
  const double H_R = size * assumed.number(options.rudder_height, std::max(0.75 * hull.d, propeller.D) / size,
                                           "rudder span [m]", "0.75 of the draught, at least the propeller diameter");
  const double side_by_side = static_cast<double>(options.rudders) / options.screws;  // in one race
  if (options.rudders == 2)
    assumed.note(fmt::format(
        "two rudders that turn together stand as one of their total area, {:.4g} m2, with the slope of each", A_R));
  assumed.note(
      "hull, propeller and rudder interaction of Yoshimura and Masumoto; x_R' = -0.5; slope of the normal force after "
      "Fujii");
  return {
      .A_R = A_R,
      .H_R = H_R,
      .x_R = -0.5,
      .t_R = i.t_R,
      .a_H = i.a_H,
      .x_H = i.x_H,
      .l_R = i.l_R,
      .gamma_R_negative = i.gamma_R,
      .gamma_R_positive = i.gamma_R,
      .epsilon = i.epsilon,
      .kappa = i.kappa,
      .f_alpha = fujii_slope(H_R * H_R * side_by_side / A_R),
  };
}

void require_drives(const EstimateOptions& options) {
  const auto one_or_two = [](int count) { return count == 1 || count == 2; };
  if (!one_or_two(options.screws) || !one_or_two(options.rudders))
    throw Refusal(fmt::format("the estimate knows one or two screws and rudders, not {} and {}", options.screws,
                              options.rudders));
  if (options.screws == 2 && options.rudders == 1)
    throw Refusal(
        "one rudder between two screws stands outside their races, and the model's rudder stands in a race: no "
        "estimate is made of such a ship");
}

MmgHull<double> hull_of(const HullDimensions<double>& hull, const MmgAddedMass<double>& added,
                        const EstimateOptions& options) {
  const double x_G_prime = options.x_G / hull.L;
  if (options.hull == HullFormula::kijima) return kijima_hull(hull, added, x_G_prime);
  if (hull.trim != 0.0)
    throw Refusal(fmt::format(
        "the formulas of Yoshimura and Masumoto are for even keel, got a trim of {} m; those of Kijima take a trim",
        hull.trim));
  return yoshimura_masumoto_hull(hull, added, x_G_prime);
}

}  // namespace

std::vector<std::string> outside(const HullDimensions<double>& hull, const HullRange& range) {
  require_hull(hull);
  std::vector<std::string> sentences;
  const auto check = [&](std::string_view name, double value, const HullRange::Span& span) {
    if (!(value >= span.low && value <= span.high))
      sentences.push_back(fmt::format("{} = {:.4g} lies outside {:.4g} to {:.4g}", name, value, span.low, span.high));
  };
  check("C_B", hull.C_B, range.C_B);
  check("L/B", hull.L / hull.B, range.L_over_B);
  check("B/d", hull.B / hull.d, range.B_over_d);
  check("trim/d", hull.trim / hull.d, range.trim_over_d);
  if (hull.trim != 0.0)
    check("d (1 - C_B)/B of a ship with trim", hull.d * (1.0 - hull.C_B) / hull.B, range.fineness_trimmed);
  return sentences;
}

double dnv_rudder_area(const HullDimensions<double>& hull) {
  require_hull(hull);
  const double beam = hull.B / hull.L;
  return 0.01 * hull.L * hull.d * (1.0 + 25.0 * beam * beam);
}

double fujii_slope(double aspect_ratio) {
  require_positive(aspect_ratio, "aspect ratio of the rudder");
  return 6.13 * aspect_ratio / (aspect_ratio + 2.25);
}

double estimated_resistance(const HullDimensions<double>& hull, double speed, double nu) {
  require_hull(hull);
  const double Reynolds =
      require_positive(speed, "speed [m/s]") * hull.L / require_positive(nu, "kinematic viscosity [m2/s]");
  const double decades = require_positive(std::log10(Reynolds) - 2.0, "decades of the Reynolds number above 100");
  const double C_F = 0.075 / (decades * decades);
  const double slender = hull.L / hull.B;
  const double k = -0.095 + 25.6 * hull.C_B / (slender * slender * std::sqrt(hull.B / hull.d));
  const double wetted = 1.025 * (hull.C_B * hull.B + 1.7 * hull.d) / hull.d;  // S/(L d)
  return ((1.0 + k) * C_F + 0.0004) * wetted;
}

EstimatedShip estimated_mmg_ship(const HullDimensions<double>& hull, double service_speed,
                                 const EstimateOptions& options) {
  require_hull(hull);
  require_positive(service_speed, "service speed [m/s]");
  require_positive(options.rho, "density of the water [kg/m3]");
  require_drives(options);
  Assumptions assumed;
  const bool kijima = options.hull == HullFormula::kijima;
  assumed.note(
      kijima ? "hull derivatives of Kijima, squares replaced by cubes; surge derivatives of Yoshimura and Masumoto"
             : "hull derivatives of Yoshimura and Masumoto");
  assumed.note("added masses of Zhou");
  const auto added = zhou_added_mass(hull);
  auto derivatives = hull_of(hull, added, options);
  derivatives.R_0 = assumed.number(options.resistance, estimated_resistance(hull, service_speed, options.nu),
                                   "resistance R_0'", "friction with form factor, no waves");
  const auto propeller = propeller_of(hull, derivatives.R_0, options, assumed);
  const auto rudder = rudder_of(hull, propeller, options, assumed);
  assumed.note(fmt::format("centre of gravity {:.4g} m forward of midship, yaw radius of gyration {:.3g} L",
                           options.x_G, options.k_zz_prime));
  assumed.note("rudder to 35 deg, 65 deg in 28 s (SOLAS)");
  EstimatedShip result{
      .ship =
          {
              .water = {.rho = options.rho},
              .particulars = {.L = hull.L,
                              .B = hull.B,
                              .d = hull.d,
                              .nabla = displaced_volume(hull),
                              .x_G = options.x_G,
                              .k_zz = require_positive(options.k_zz_prime, "yaw radius of gyration over L") * hull.L,
                              .U_0 = service_speed,
                              .A_front = 0.0,
                              .A_lateral = 0.0},
              .added_mass = added,
              .hull = derivatives,
              .propeller = propeller,
              .rudder = rudder,
              .steering_gear = {.rate = radians(65.0) / 28.0, .max_angle = radians(35.0), .lag = 0.0, .dead_band = 0.0},
              .engine = {},
          },
      .assumptions = std::move(assumed).notes(),
      .warnings = outside(hull, kijima ? loaded_ships : merchant_ships),
  };
  self_propulsion_rev(result.ship, service_speed);  // refuses a propeller that cannot hold the speed
  return result;
}

}  // namespace swayaw::nonlinear
