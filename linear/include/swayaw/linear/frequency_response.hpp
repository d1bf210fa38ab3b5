#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <vector>

#include "swayaw/core/angle.hpp"
#include "swayaw/linear/dimensional.hpp"

/// Drift, yaw rate and heading under a rudder that swings sinusoidally.
///
/// To delta = cos(nu s') belongs one periodic motion, beta = Re[H exp(j nu s')], likewise omega' and psi; nu in radians
/// per ship length. A stable ship settles into it from every start. An unstable or neutral ship has it too and leaves
/// it when disturbed.
namespace swayaw::inline linear {

/// Transfer function from the rudder to one motion, of the Laplace variable p:
///
///     H(p) = (n1 p + n0) / [p^integrals (p² + e1 p + e0)]
template <class S = double>
struct RudderTransfer {
  S n0, n1, e0, e1;
  int integrals;  ///< 0 for drift and yaw rate, 1 for heading
};

template <class S>
RudderTransfer<S> rudder_to_drift(const SwayYawTransfer<S>& h) {
  return {h.nb0, h.nb1, h.e0, h.e1, 0};
}

template <class S>
RudderTransfer<S> rudder_to_yaw(const SwayYawTransfer<S>& h) {
  return {h.nw0, h.nw1, h.e0, h.e1, 0};
}

/// psi/delta = (omega'/delta)/p.
template <class S>
RudderTransfer<S> rudder_to_heading(const SwayYawTransfer<S>& h) {
  return {h.nw0, h.nw1, h.e0, h.e1, 1};
}

/// A complex number of any scalar.
template <class S = double>
struct Phasor {
  S re;
  S im;
};

inline std::complex<double> as_complex(const Phasor<double>& z) { return {z.re, z.im}; }

/// H(j nu) = (n0 + j nu n1)(e0 − nu² − j nu e1) / [(e0 − nu²)² + nu² e1²], divided by j nu for the heading.
/// Valid for nu > 0 unless the ship swings undamped at nu (e1 = 0, nu² = e0); at nu = 0 the static gain where there is
/// one.
template <class S>
Phasor<S> response_at(const RudderTransfer<S>& t, const S& nu) {
  const S nu2 = nu * nu, real = t.e0 - nu2;
  const S over = 1.0 / (real * real + nu2 * t.e1 * t.e1);
  const Phasor<S> h{(t.n0 * real + nu2 * t.n1 * t.e1) * over, nu * (t.n1 * real - t.n0 * t.e1) * over};
  if (t.integrals == 0) return h;
  return {h.im / nu, -h.re / nu};  // (re + j im)/(j nu)
}

/// |H(j nu)|, amplitude of the motion over that of the rudder: angle per angle, or omega' per radian.
template <class S>
S gain(const RudderTransfer<S>& t, const S& nu) {
  const S nu2 = nu * nu, real = t.e0 - nu2;
  const S g = sqrt((t.n0 * t.n0 + nu2 * t.n1 * t.n1) / (real * real + nu2 * t.e1 * t.e1));
  return t.integrals == 0 ? g : S(g / nu);
}

/// Phase of H(j nu) [rad], continuous in nu > 0 without any unwrapping:
///
///     arg(n0 + j nu n1) − arg(e0 − nu² + j nu e1) − integrals π/2,
///
/// since the imaginary parts keep their sign. The numerator starts from 0 for n0 ≥ 0 and from −π for n0 < 0, so drift
/// and yaw of a stable ship start from −π (a rudder to port turns to port) and her heading from −3π/2.
template <class S>
S phase(const RudderTransfer<S>& t, const S& nu) {
  const double side = value_of(t.n0) < 0.0 ? -1.0 : 1.0;
  const S numerator = atan2(side * nu * t.n1, side * t.n0) + (side < 0.0 ? -pi : 0.0);
  return numerator - atan2(nu * t.e1, t.e0 - nu * nu) - t.integrals * (0.5 * pi);
}

/// One point of a Bode diagram.
struct BodePoint {
  double frequency;        ///< radians per ship length
  double frequency_rad_s;  ///< the same [rad/s], nu U/L
  double gain;             ///< amplitude over rudder amplitude
  double phase;            ///< [rad], continuous along the diagram
};

/// Bode diagram at the given frequencies, radians per ship length.
/// @throws std::domain_error  if a frequency, the length or the speed is not positive
std::vector<BodePoint> bode(const RudderTransfer<double>& t, const std::vector<double>& frequencies,
                            const PrimeScale& scale);

/// `count` frequencies from `low` to `high`, equal ratios apart.
/// @throws std::domain_error  if a bound is not positive or there are fewer than 2
std::vector<double> logarithmic_frequencies(double low, double high, std::size_t count);

/// Highest frequency with that gain, radians per ship length: the largest root x = nu² of
///
///     x^integrals [x² + (e1² − 2 e0) x + e0²] = (n0² + n1² x)/gain²
///
/// @return nothing when the gain is nowhere that high
/// @throws std::domain_error  if the gain is not positive
std::optional<double> highest_frequency_with_gain(const RudderTransfer<double>& t, double gain);

/// Frequency above which the gain stays below 1/√2 of the static gain |n0/e0|. Drift and yaw of every ship with a
/// static gain have exactly one: the product of the two roots is negative.
/// @return nothing for the heading, a neutral ship and n0 = 0
std::optional<double> bandwidth(const RudderTransfer<double>& t);

/// Where a helmsman's loop has gain 1.
struct Crossover {
  double frequency;     ///< radians per ship length
  double phase_margin;  ///< by which the phase of the loop is above −π [rad], in [−π, π]
};

/// Crossover of the loop of a helmsman who orders delta = k (psi − wanted): −k psi/delta at its highest frequency with
/// gain 1.
/// @return nothing when the loop has gain 1 nowhere
/// @throws std::domain_error  if k is not positive
std::optional<Crossover> crossover(const SwayYawTransfer<double>& h, double k);

}  // namespace swayaw::linear
