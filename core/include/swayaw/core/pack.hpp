#pragma once

#include <xsimd/xsimd.hpp>

#include "swayaw/core/scalar.hpp"

/// Packs: many ships at once, one a lane. What a lane gives depends on that lane alone, so a ship may have any
/// neighbours. This header, and no other, needs xsimd.
namespace swayaw::inline core {

/// As many doubles as the instruction set of this translation unit handles at once.
using Pack = xsimd::batch<double>;

/// Elementary functions in the ranges a ship needs, in basic arithmetic only: the same for every instruction set up to
/// the rounding of fused multiply-adds. Polynomials after fdlibm (Sun Microsystems, 1993).
template <class Arch>
struct Elementary<xsimd::batch<double, Arch>> {
  using P = xsimd::batch<double, Arch>;
  using Bits = xsimd::as_integer_t<P>;

  /// Adding it rounds a number to an integer, which its last bits then hold.
  static constexpr double shifter = 6755399441055744.0;  // 3 · 2⁵¹

  /// For |x| < 10⁵, to 2e-16.
  static SinCos<P> sin_cos(const P& x) {
    // x = n π/2 + r, |r| ≤ π/4
    const P shifted = xsimd::fma(x, P(6.36619772367581382433e-01), P(shifter)), n = shifted - P(shifter);
    const P r =
        xsimd::fnma(n, P(2.02226624879595063154e-21),
                    xsimd::fnma(n, P(6.07710050630396597660e-11), xsimd::fnma(n, P(1.57079632673412561417e+00), x)));
    const P z = r * r;
    const P s =
        xsimd::fma(r * z,
                   polynomial(z, -1.66666666666666324348e-01, 8.33333333332248946124e-03, -1.98412698298579493134e-04,
                              2.75573137070700676789e-06, -2.50507602534068634195e-08, 1.58969099521155010221e-10),
                   r);
    const P c =
        xsimd::fma(z * z,
                   polynomial(z, 4.16666666666666019037e-02, -1.38888888888741095749e-03, 2.48015872894767294178e-05,
                              -2.75573143513906633035e-07, 2.08757232129817482790e-09, -1.13596475577881948265e-11),
                   xsimd::fnma(P(0.5), z, P(1.0)));
    // odd n exchange the two; the second last bit of n, and of n + 1, is the sign
    const Bits quadrant = xsimd::bitwise_cast<Bits>(shifted);
    const auto odd = xsimd::bitwise_cast<P>((quadrant & Bits(1)) << 62) > P(1.0);
    const P sign_sin = xsimd::bitwise_cast<P>((quadrant & Bits(2)) << 62);
    const P sign_cos = xsimd::bitwise_cast<P>(((quadrant + Bits(1)) & Bits(2)) << 62);
    return {xsimd::select(odd, c, s) ^ sign_sin, xsimd::select(odd, s, c) ^ sign_cos};
  }

  /// exp(−x) for x ≥ 0, to 3e-16; beyond 700 as at 700.
  static P decay(const P& x) {
    const P z = xsimd::max(-x, P(-700.0));
    // exp(z) = 2ⁿ exp(r), |r| ≤ ½ ln 2
    const P shifted = xsimd::fma(z, P(1.4426950408889634), P(shifter)), n = shifted - P(shifter);
    const P scale = xsimd::bitwise_cast<P>((xsimd::bitwise_cast<Bits>(shifted) + Bits(1023)) << 52);
    const P r = xsimd::fnma(n, P(1.9082149292705877e-10), xsimd::fnma(n, P(6.93147180369123816490e-1), z));
    const P high = polynomial(r, 1.0 / 40320.0, 1.0 / 362880.0, 1.0 / 3628800.0, 1.0 / 39916800.0, 1.0 / 479001600.0,
                              1.0 / 6227020800.0);
    const P low = polynomial(r, 0.5, 1.0 / 6.0, 1.0 / 24.0, 1.0 / 120.0, 1.0 / 720.0, 1.0 / 5040.0);
    const P r2 = r * r;
    const P rise = xsimd::fma(r2, xsimd::fma(r2 * r2 * r2, high, low), r);  // exp(r) − 1
    return xsimd::fma(scale, rise, scale);
  }

  /// Angle of (x, y), to 3e-16; 0 for the origin.
  static P angle_of(const P& y, const P& x) {
    const P ax = xsimd::abs(x), ay = xsimd::abs(y);
    const P large = xsimd::max(ax, ay), small = xsimd::min(ax, ay);
    // atan(small/large), beyond π/8 as π/4 + atan((small − large)/(small + large))
    const auto wide = small > P(0.41421356237309503) * large;
    const P over = xsimd::max(xsimd::select(wide, small + large, large), P(1e-300));
    const P t = xsimd::select(wide, small - large, small) / over;
    const P z = t * t, z2 = z * z;
    const P low = polynomial(z, 3.33333333333329318027e-01, -1.99999999998764832476e-01, 1.42857142725034663711e-01,
                             -1.11111104054623557880e-01, 9.09088713343650656196e-02, -7.69187620504482999495e-02);
    const P high = polynomial(z, 6.66107313738753120669e-02, -5.83357013379057348645e-02, 4.97687799461593236017e-02,
                              -3.65315727442169155270e-02, 1.62858201153657823623e-02, 0.0);
    const P first =
        xsimd::fnma(t * z, xsimd::fma(z2 * z2 * z2, high, low), t) + xsimd::select(wide, P(0.25 * pi), P(0.0));
    const P upper = xsimd::select(ay > ax, P(0.5 * pi) - first, first);
    return xsimd::select(x < P(0.0), P(pi) - upper, upper) ^ (y & P(-0.0));
  }

 private:
  static constexpr double pi = 3.14159265358979323846;

  /// c_0 + c_1 x + … + c_5 x⁵
  static P polynomial(const P& x, double c_0, double c_1, double c_2, double c_3, double c_4, double c_5) {
    const P x2 = x * x;
    const P low = xsimd::fma(x, P(c_1), P(c_0)), middle = xsimd::fma(x, P(c_3), P(c_2)),
            high = xsimd::fma(x, P(c_5), P(c_4));
    return xsimd::fma(x2, xsimd::fma(x2, high, middle), low);
  }
};

}  // namespace swayaw::core
