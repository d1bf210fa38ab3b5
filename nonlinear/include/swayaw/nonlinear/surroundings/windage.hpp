#pragma once

#include <array>
#include <string_view>
#include <variant>

#include "swayaw/core/parameter.hpp"
#include "swayaw/nonlinear/surroundings/periodic_curve.hpp"

/// What the wind takes hold of: areas and coefficients over the angle of attack alpha.
///
/// alpha is where the air comes from, seen from the moving ship: 0 ahead, pi/2 on the starboard beam, pi astern.
/// C_X < 0 in wind from ahead, C_Y < 0 in wind from starboard. docs/wind.md tells formulas, signs and sources.
namespace swayaw::inline nonlinear {

/// C_X, C_Y, C_N at one angle, or their curves over all angles, in body axes about midship:
///
///     X = ½ρV_A² A_F C_X,   Y = ½ρV_A² A_L C_Y,   N = ½ρV_A² A_L L_OA C_N
template <class T = double>
struct WindCoefficients {
  T X, Y, N;
};

template <class S = double>
using WindSeries = WindCoefficients<FourierSeries<S>>;
using WindSpline = WindCoefficients<PeriodicSpline>;

/// What the wind takes hold of; with areas 0 she feels no wind. Drag coefficients that are not given are those of a
/// loaded tanker.
template <class S = double>
struct Windage {
  S rho = S(1.225);        ///< density of the air [kg/m^3], [ISO2533] at sea level and 15 °C
  S A_F = S(0.0);          ///< frontal projected area above water [m^2]
  S A_L = S(0.0);          ///< lateral projected area above water [m^2]
  S L_OA = S(0.0);         ///< length over all [m]
  S x_A = S(0.0);          ///< centroid of the lateral area forward of midship [m]
  S C_Dt = S(0.70);        ///< transverse drag, on the lateral area
  S C_Dl_bow = S(0.90);    ///< longitudinal drag in wind from ahead, on the frontal area
  S C_Dl_stern = S(0.55);  ///< the same in wind from astern
  S delta = S(0.40);       ///< cross-force parameter
  /// Given coefficients; where there are some they act, and the four numbers above are not read.
  std::variant<std::monostate, WindSeries<S>, WindSpline> given{};

  static constexpr auto parameters() {
    using P = ParameterOf<Windage, S>;
    constexpr auto drag = [](std::string_view key, S Windage::*member, Range range, double fallback) {
      return P{.key = key,
               .member = member,
               .unit = "-",
               .range = range,
               .role = Role::coefficient,
               .required = false,
               .fallback = fallback};
    };
    return std::array{
        P{.key = "air_density_kg_m3",
          .member = &Windage::rho,
          .unit = "kg/m3",
          .range = positive,
          .required = false,
          .fallback = 1.225},
        P{"frontal_area_m2", &Windage::A_F, "m2", positive},
        P{"lateral_area_m2", &Windage::A_L, "m2", positive},
        P{"length_over_all_m", &Windage::L_OA, "m", positive},
        P{.key = "lateral_centroid_m",
          .member = &Windage::x_A,
          .unit = "m",
          .range = any_number,
          .role = Role::coefficient,
          .required = false},
        drag("transverse_drag", &Windage::C_Dt, positive, 0.70),
        drag("bow_drag", &Windage::C_Dl_bow, non_negative, 0.90),
        drag("stern_drag", &Windage::C_Dl_stern, non_negative, 0.55),
        drag("cross_force", &Windage::delta, fraction, 0.40),
    };
  }
};

/// a/b, and 0 for a ship without areas or length, whose load is 0.
template <class S>
S ratio(const S& a, const S& b) {
  const auto known = b > S(0.0);
  return select(known, S(a / select(known, b, S(1.0))), S(0.0));
}

/// Coefficients from areas and drag.
///
///     D = 1 − ½ delta (1 − C_Dl A_F/(A_L C_Dt)) sin²(2 alpha),   C_Dl of bow or stern, where the wind comes from
///     C_X = −C_Dl cos(alpha)/D,   C_Y = −C_Dt sin(alpha)/D,   C_N = (x_A/L_OA − 0.18 (|alpha| − pi/2)) C_Y
///
/// C_X has a kink on the beam unless bow and stern drag agree.
/// Source: [Blendermann1994], in the form of [MSS] blendermann94.m, where the angle counts to port
template <class S>
WindCoefficients<S> blendermann_coefficients(const Windage<S>& w, const S& alpha) {
  const S c = cos(alpha), s = sin(alpha);
  const S off_bow = select(alpha < S(0.0), S(-alpha), alpha);  // |alpha|
  const S C_Dl = select(c < S(0.0), w.C_Dl_stern, w.C_Dl_bow);
  const S sine = 2.0 * s * c;  // sin(2 alpha)
  const S D = 1.0 - 0.5 * w.delta * (1.0 - ratio(S(C_Dl * w.A_F), S(w.A_L * w.C_Dt))) * sine * sine;
  const S C_Y = -w.C_Dt * s / D;
  return {.X = -C_Dl * c / D, .Y = C_Y, .N = (ratio(w.x_A, w.L_OA) - 0.18 * (off_bow - 0.5 * pi)) * C_Y};
}

/// Values of three curves.
template <class Curve, class S>
WindCoefficients<S> coefficients_at(const WindCoefficients<Curve>& curves, const S& alpha) {
  return {value_at(curves.X, alpha), value_at(curves.Y, alpha), value_at(curves.N, alpha)};
}

/// C_X, C_Y, C_N of the ship; alpha in [−pi, pi].
template <class S>
WindCoefficients<S> coefficients_at(const Windage<S>& windage, const S& alpha) {
  if (const auto* series = std::get_if<WindSeries<S>>(&windage.given)) return coefficients_at(*series, alpha);
  if (const auto* spline = std::get_if<WindSpline>(&windage.given)) return coefficients_at(*spline, alpha);
  return blendermann_coefficients(windage, alpha);
}

template <class To, class From>
FourierSeries<To> cast_series(const FourierSeries<From>& f) {
  return {To(f.a_0), {f.a.begin(), f.a.end()}, {f.b.begin(), f.b.end()}};
}

/// The same windage with another scalar, given coefficients included.
template <class To, class From>
Windage<To> cast_part(const Windage<From>& windage) {
  Windage<To> result{};
  constexpr auto source = Windage<From>::parameters();
  constexpr auto target = Windage<To>::parameters();
  for (std::size_t i = 0; i < source.size(); ++i) result.*target[i].member = To(windage.*source[i].member);
  if (const auto* series = std::get_if<WindSeries<From>>(&windage.given))
    result.given = WindSeries<To>{cast_series<To>(series->X), cast_series<To>(series->Y), cast_series<To>(series->N)};
  if (const auto* spline = std::get_if<WindSpline>(&windage.given)) result.given = *spline;
  return result;
}

}  // namespace swayaw::nonlinear
