#pragma once

#include <array>
#include <string_view>

#include "swayaw/linear/indices.hpp"
#include "swayaw/linear/ship_parts.hpp"

/// From the indices to the coefficients of the coupled equations and on to hull and rudder, with what each result owes
/// to each input.
namespace swayaw::inline linear {

/// Inputs of an inversion. T1 and T2 vary with T1T2 and T1 + T2 as they make them; "known" is the known number of the
/// ship.
inline constexpr std::array<std::string_view, 9> inversion_inputs{"T1",  "T2", "T1T2", "T1_plus_T2", "T3b",
                                                                  "T3w", "Kb", "Kw",   "known"};

/// A result and its elasticities d ln(value)/d ln(input), in the order of `inversion_inputs`; not a number where there
/// is none: for T1 and T2 of a complex pair, for a value of 0, for indices that are infinite.
struct InvertedNumber {
  std::string_view name;
  double value;
  std::array<double, 9> elasticity;
};

/// Results of an inversion: a1 … c2, and with hull and rudder a_H, c_Ry, x'_Reff, Y_b, Y_w, N_b, N_w.
struct Inversion {
  std::array<InvertedNumber, 6> coefficients;
  std::array<InvertedNumber, 7> parts;
  LinearParts<double> ship;  ///< hull and rudder that have the coefficients
};

/// Coefficients with exact elasticities to the indices, by dual numbers through `coefficients_from`.
///
/// @param indices  of the same ship
std::array<InvertedNumber, 6> inverted_coefficients(const SwayYawCoefficients<double>& m,
                                                    const SteeringIndices<double>& indices);

/// Coefficients, hull and rudder with exact elasticities to indices and known number.
///
/// @param formal  all numbers but the seven are taken from it, and the known one
/// @throws Refusal  if c1 = 0, or the known number does not determine c_Ry
Inversion inverted(const SwayYawCoefficients<double>& m, const SteeringIndices<double>& indices,
                   const LinearParts<double>& formal, KnownPart known);

/// How well a choice of the known number determines hull and rudder.
struct KnownCondition {
  KnownPart known;
  double
      by_known;  ///< largest |elasticity| of Y_b, Y_w, N_b, N_w, c_Ry to the known number, itself included: at least 1
  double worst;  ///< relative error of the worst of them for independent relative errors of 1 in a1 … c2 and the known
                 ///< number
};

/// All choices in the order of `KnownPart`; infinite where the number does not determine c_Ry.
std::array<KnownCondition, 5> known_conditions(const SwayYawCoefficients<double>& m, const LinearParts<double>& formal);

/// The choice with the least `worst`.
KnownPart best_known(const std::array<KnownCondition, 5>& conditions);

/// "Y_b", "Y_w", "N_b", "N_w", "c_Ry".
std::string_view name_of(KnownPart known);

}  // namespace swayaw::linear
