#pragma once

#include <xsimd/xsimd.hpp>

#include "batch_kernel.hpp"

/// The zigzag over packs. Only for the units of the batch kernels; see batch_kernel.hpp.
///
/// Each lane sails its own ship, leg by leg, as src/zigzag.cpp does. The yaw rate is the sum of two modes
///
///     y_i' = l_i y_i + g_i delta,   omega = y_1 + y_2,   delta = delta0 + rho s
///
/// and with B_i = l_i y_i + g_i delta0, r_i = g_i rho, C_i = l_i B_i + r_i and the moments e, p1, p2, p3 of exp(l_i s)
///
///     psi = psi0 + Σ y_i s + B_i p2 + r_i p3,   psi' = Σ y_i + B_i p1 + r_i p2,   psi'' = Σ B_i e + r_i p1,   psi''' =
///     Σ C_i e.
namespace swayaw::inline linear::batch {

template <class Arch>
class ZigzagPack {
  using P = xsimd::batch<double, Arch>;
  using M = xsimd::batch_bool<double, Arch>;

 public:
  static constexpr std::size_t lanes = P::size;

  ZigzagPack(const ZigzagJob& job, std::size_t first, std::size_t past) : job_(job), first_(first), past_(past) {
    const P a1 = load(job.a1), b1 = load(job.b1), c1 = load(job.c1), a2 = load(job.a2), b2 = load(job.b2),
            c2 = load(job.c2);
    const P mu = (a1 + b2) * P(0.5), det = a1 * b2 - a2 * b1, q = mu * mu - det;
    const P root = xsimd::sqrt(xsimd::max(q, P(0.0)));
    const P fast = select(mu <= P(0.0), mu - root, mu + root), slow = det / fast;
    active_ = (q > P(0.04) * mu * mu) & (xsimd::abs(slow) > P(0.01)) & (xsimd::abs(fast) < P(1e6));
    redo_ = ~active_;
    l1_ = select(active_, slow, P(-1.0));
    l2_ = select(active_, fast, P(-2.0));
    over1_ = P(1.0) / l1_;
    over2_ = P(1.0) / l2_;
    g1_ = (c2 * l1_ + a2 * c1 - a1 * c2) / (l1_ - l2_);  // residue of the transfer function of yaw
    g2_ = c2 - g1_;
    size_ = xsimd::max(xsimd::abs(l1_), xsimd::abs(l2_));
    horizon_ = P(30.0) / xsimd::abs(select(l2_ < P(0.0), l1_, l2_));  // a fast mode that dies out does not shorten it
    over_rate_ = P(1.0 / job.rate);
  }

  /// Sails two packs side by side: each waits for its own results only, so the processor works on both at once.
  static void sail(ZigzagPack& x, ZigzagPack& y) {
    x.cast_off();
    y.cast_off();
    const std::size_t most_legs = 3 * x.job_.reversals + 12;
    for (std::size_t leg = 0; leg < most_legs && (xsimd::any(x.active_) || xsimd::any(y.active_)); ++leg) {
      x.begin_leg();
      y.begin_leg();
      for (int step = 0; step < most_steps; ++step) {
        const bool x_ends = x.step(), y_ends = y.step();
        if (x_ends && y_ends) break;
      }
      x.end_leg();
      y.end_leg();
    }
    x.store();
    y.store();
  }

 private:
  static constexpr int most_steps = 40;

  /// psi (less the heading that is waited for) and its derivatives.
  struct Knot {
    P f0, f1, f2, f3, f4;
  };

  struct Moments {
    P e, p1, p2, p3;
  };

  P load(const double* from) const {
    if (first_ + lanes <= past_) return P::load_unaligned(from + first_);
    alignas(64) double lane[lanes];
    for (std::size_t i = 0; i < lanes; ++i) lane[i] = from[first_ + i < past_ ? first_ + i : past_ - 1];
    return P::load_aligned(lane);
  }

  static P select(const M& m, const P& a, const P& b) { return xsimd::select(m, a, b); }

  /// exp(l s) = 2^n exp(r) with |r| ≤ ½ ln 2; exp(l s) − 1 to full relative accuracy, from which p_{k+1} = (p_k −
  /// s^k/k!)/l.
  static Moments moments(const P& l, const P& over_l, const P& s) {
    const P z = xsimd::max(l * s, P(-700.0));
    // n rounded in the last bits of the shifter, 3 · 2⁵¹; 2^n from the same bits
    using I = xsimd::as_integer_t<P>;
    const P shifter(6755399441055744.0), shifted = xsimd::fma(z, P(1.4426950408889634), shifter), n = shifted - shifter;
    const P scale = xsimd::bitwise_cast<P>((xsimd::bitwise_cast<I>(shifted) + I(1023)) << 52);
    const P r = xsimd::fnma(n, P(1.9082149292705877e-10), xsimd::fnma(n, P(6.93147180369123816490e-1), z));
    const P r2 = r * r, r4 = r2 * r2;
    // exp(r) − 1 − r = r² (1/2! + r/3! + … + r¹¹/13!)
    const P c0 = xsimd::fma(r, P(1.0 / 6.0), P(0.5)), c1 = xsimd::fma(r, P(1.0 / 120.0), P(1.0 / 24.0));
    const P c2 = xsimd::fma(r, P(1.0 / 5040.0), P(1.0 / 720.0)),
            c3 = xsimd::fma(r, P(1.0 / 362880.0), P(1.0 / 40320.0));
    const P c4 = xsimd::fma(r, P(1.0 / 39916800.0), P(1.0 / 3628800.0)),
            c5 = xsimd::fma(r, P(1.0 / 6227020800.0), P(1.0 / 479001600.0));
    const P low = xsimd::fma(r2, c1, c0), middle = xsimd::fma(r2, c3, c2), high = xsimd::fma(r2, c5, c4);
    const P minus_1 = xsimd::fma(r2, xsimd::fma(r4, xsimd::fma(r4, high, middle), low), r);
    const P rise = xsimd::fma(scale, minus_1, scale - P(1.0));
    const P p1 = rise * over_l, p2 = (p1 - s) * over_l;
    return {rise + P(1.0), p1, p2, xsimd::fnma(P(0.5) * s, s, p2) * over_l};
  }

  void order(const M& who, const P& angle) {
    target_ = select(who, angle, target_);
    if (job_.rate <= 1e300) {
      moving_ = select_mask(who, target_ != angle_, moving_);
    } else {
      angle_ = select(who, angle, angle_);
    }
  }

  static M select_mask(const M& who, const M& a, const M& b) { return (who & a) | (~who & b); }

  void cast_off() { order(M(true), P(-job_.turn * job_.rudder)); }

  void begin_leg() {
    const P way = target_ - angle_;
    ramp_ = moving_;
    rho_ = select(moving_, select(way > P(0.0), P(job_.rate), P(-job_.rate)), P(0.0));
    const P limit = xsimd::min(horizon_, P(job_.longest) - now_);
    const P until = xsimd::abs(way) * over_rate_;
    arrives_ = moving_ & (until <= limit);
    end_ = select(arrives_, until, limit);
    B1_ = xsimd::fma(l1_, y1_, g1_ * angle_);
    B2_ = xsimd::fma(l2_, y2_, g2_ * angle_);
    r1_ = g1_ * rho_;
    r2_ = g2_ * rho_;
    C1_ = xsimd::fma(l1_, B1_, r1_);
    C2_ = xsimd::fma(l2_, B2_, r2_);
    goal_ = turn_ * P(job_.heading);
    begin_search();
  }

  void end_leg() {
    give_up(~there_);
    advance();
    note(found_ & active_);
    active_ = active_ & (now_ < P(job_.longest));
  }

  Knot start_knot() const { return {psi_ - goal_, y1_ + y2_, B1_ + B2_, C1_ + C2_, l1_ * C1_ + l2_ * C2_}; }

  Knot at(const P& s, const Moments& a, const Moments& b) const {
    const P u1 = C1_ * a.e, u2 = C2_ * b.e;
    const P w0 = y1_ + y2_;
    return {
        .f0 = (psi_ - goal_) + xsimd::fma(w0, s, xsimd::fma(B1_, a.p2, B2_ * b.p2) + xsimd::fma(r1_, a.p3, r2_ * b.p3)),
        .f1 = w0 + (xsimd::fma(B1_, a.p1, B2_ * b.p1) + xsimd::fma(r1_, a.p2, r2_ * b.p2)),
        .f2 = xsimd::fma(B1_, a.e, B2_ * b.e) + xsimd::fma(r1_, a.p1, r2_ * b.p1),
        .f3 = u1 + u2,
        .f4 = xsimd::fma(l1_, u1, l2_ * u2)};
  }

  /// The values of a knot with those that are 0 replaced by the next derivative, so that their signs are those just
  /// behind.
  static Knot behind(const Knot& k) {
    const P f3 = select(k.f3 == P(0.0), k.f4, k.f3), f2 = select(k.f2 == P(0.0), f3, k.f2);
    const P f1 = select(k.f1 == P(0.0), f2, k.f1);
    return {select(k.f0 == P(0.0), f1, k.f0), f1, f2, f3, k.f4};
  }

  /// Whether between a and b a function, whose derivative passes zero at most once, turns back on its way to zero.
  static M needs_top(const P& a, const P& b, const P& a_slope, const P& b_slope) {
    return (a_slope * b_slope <= P(0.0)) & (a * b > P(0.0)) & (a * a_slope < P(0.0));
  }

  static Knot where(const M& m, const Knot& a, const Knot& b) {
    return {select(m, a.f0, b.f0), select(m, a.f1, b.f1), select(m, a.f2, b.f2), select(m, a.f3, b.f3),
            select(m, a.f4, b.f4)};
  }

  /// The function whose zero is looked for, heading or yaw rate, with three derivatives.
  struct Sought {
    P y, f, g, h;
  };

  Sought sought(const Knot& k) const {
    return {select(to_heading_, k.f0, k.f1), select(to_heading_, k.f1, k.f2), select(to_heading_, k.f2, k.f3),
            select(to_heading_, k.f3, k.f4)};
  }

  /// How far on the parabola that touches the function reaches zero: y + f t + ½ g t² = 0.
  static P parabola_step(const Sought& x) {
    const P root = xsimd::sqrt(xsimd::max(xsimd::fma(x.f, x.f, P(-2.0) * x.y * x.g), P(0.0)));
    return P(-2.0) * x.y / (x.f - select(x.y < P(0.0), -root, root));
  }

  static P probe(const P& from, const Sought& x, const P& end) {
    const P guess = from + P(1.25) * parabola_step(x);
    return select((guess > from) & (guess < end), guess, end);
  }

  void begin_search() {
    const Knot start = start_knot();
    a_ = behind(start);
    before_ = sought(a_).y;
    marching_ = active_;
    there_ = ~active_;
    found_ = M(false);
    low_ = shift_ = P(0.0);
    high_ = end_;
    s_ = probe(P(0.0), sought(start), end_);
  }

  /// A step of each lane towards where its leg ends: the zero that is looked for, else the end. A lane marches until
  /// the zero is between two knots, then closes in on it.
  ///
  /// @return whether the knot of every lane is where its leg ends, or a small shift before or behind it
  [[gnu::always_inline]] bool step() {
    slow_ = moments(l1_, over1_, s_);
    fast_ = moments(l2_, over2_, s_);
    knot_ = at(s_, slow_, fast_);
    const Sought k = sought(knot_);
    const M same = k.y * before_ > P(0.0);
    P next = s_;
    if (xsimd::any(marching_)) next = march(k, same);
    if (!xsimd::all(there_)) close_in(k, same, next);
    return xsimd::all(there_);
  }

  [[gnu::always_inline]] P march(const Sought& k, const M& same) {
    const M top = (ramp_ & needs_top(a_.f2, knot_.f2, a_.f3, knot_.f3)) | needs_top(a_.f1, knot_.f1, a_.f2, knot_.f2) |
                  (to_heading_ & needs_top(a_.f0, knot_.f0, a_.f1, knot_.f1));
    give_up(marching_ & top);
    const M on = marching_ & same;
    there_ = there_ | (on & (s_ >= end_)) | (marching_ & top);
    found_ = found_ | (marching_ & ~same & ~top);
    marching_ = on & ~there_;
    a_ = where(marching_, knot_, a_);
    low_ = select(marching_, s_, low_);
    return xsimd::any(marching_) ? select(marching_, probe(s_, k, end_), s_) : s_;
  }

  /// Householder's method of third order within the bracket, for the lanes that have one.
  [[gnu::always_inline]] void close_in(const Sought& k, const M& same, const P& next) {
    const M rooting = found_ & ~there_;
    low_ = select(rooting & same, s_, low_);
    high_ = select(rooting & ~same, s_, high_);
    const P over_f = P(1.0) / k.f, newton = -k.y * over_f, bend = newton * k.g * over_f,
            twist = newton * newton * k.h * over_f;
    const P by = newton * xsimd::fma(P(0.5), bend, P(1.0)) / xsimd::fma(P(1.0 / 6.0), twist, P(1.0) + bend);
    const P near = s_ + by, error = xsimd::fma(xsimd::abs(by), size_, xsimd::abs(bend));
    const M inside = (near > low_) & (near < high_), exact = error < P(1e-13);
    // the error left is of the fourth order in the step; upon the zero itself rounding may lead out of the bracket
    const M close = rooting & (exact | (inside & (error < P(1e-3))));
    shift_ = select(close & inside, by, shift_);
    there_ = there_ | close;
    const P better = select(inside, near, P(0.5) * (low_ + high_));
    s_ = select(there_, s_, select(rooting, better, next));
  }

  void give_up(const M& who) {
    redo_ = redo_ | (who & active_);
    active_ = active_ & ~who;
  }

  /// From the last knot over the shift to the end of the leg, by Taylor's series: the shift is so small that the third
  /// power is the last that counts.
  void advance() {
    const M arrived = arrives_ & ~found_;
    const P s = s_ + shift_;
    now_ = select(active_, now_ + s, now_);
    const P sixth = shift_ * P(1.0 / 6.0);
    psi_ = goal_ +
           xsimd::fma(shift_, xsimd::fma(shift_, xsimd::fma(sixth, knot_.f3, P(0.5) * knot_.f2), knot_.f1), knot_.f0);
    y1_ = mode_after(l1_, y1_, B1_, r1_, C1_, slow_);
    y2_ = mode_after(l2_, y2_, B2_, r2_, C2_, fast_);
    angle_ = select(arrived, target_, xsimd::fma(rho_, s, angle_));
    moving_ = moving_ & ~arrived;
  }

  P mode_after(const P& l, const P& y, const P& B, const P& r, const P& C, const Moments& m) const {
    const P value = y + xsimd::fma(B, m.p1, r * m.p2), slope = xsimd::fma(B, m.e, r * m.p1), curve = C * m.e;
    return xsimd::fma(shift_, xsimd::fma(shift_, xsimd::fma(shift_ * P(1.0 / 6.0), l * curve, P(0.5) * curve), slope),
                      value);
  }

  /// Reversals and peaks; the next order.
  void note(const M& found) {
    const M reversal = found & to_heading_, peak = found & ~to_heading_;
    if (xsimd::any(reversal)) {
      keep(reversal, now_, execute_);
      order(reversal, turn_ * P(job_.rudder));
    }
    if (xsimd::any(peak)) {
      keep(peak, now_, peak_);
      keep(peak, turn_ * psi_ - P(job_.heading), overshoot_);
      y2_ = select(peak, -y1_, y2_);
      done_ = select(peak, done_ + P(1.0), done_);
      turn_ = select(peak, -turn_, turn_);
      active_ = active_ & (done_ < P(static_cast<double>(job_.reversals)));
    }
    to_heading_ = (to_heading_ & ~reversal) | peak;
  }

  void keep(const M& who, const P& value, P* row) const {
    for (std::size_t r = 0; r < job_.reversals; ++r)
      row[r] = select(who & (done_ == P(static_cast<double>(r))), value, row[r]);
  }

  void store() const {
    const std::size_t ships = first_ + lanes <= past_ ? lanes : past_ - first_;
    alignas(64) double lane[lanes];
    const P count = select(redo_ | active_, P(static_cast<double>(redo)), done_);
    count.store_aligned(lane);
    for (std::size_t i = 0; i < ships; ++i) job_.count[first_ + i] = static_cast<unsigned char>(lane[i]);
    for (std::size_t r = 0; r < job_.reversals; ++r) {
      store(execute_[r], job_.execute + r * job_.ships, ships);
      store(peak_[r], job_.peak + r * job_.ships, ships);
      store(overshoot_[r], job_.overshoot + r * job_.ships, ships);
    }
  }

  void store(const P& value, double* row, std::size_t ships) const {
    if (ships == lanes) return value.store_unaligned(row + first_);
    alignas(64) double lane[lanes];
    value.store_aligned(lane);
    for (std::size_t i = 0; i < ships; ++i) row[first_ + i] = lane[i];
  }

  const ZigzagJob& job_;
  std::size_t first_, past_;
  M active_, redo_;
  P l1_, l2_, over1_, over2_, g1_, g2_, size_, horizon_, over_rate_;
  // where the ship is
  P now_ = P(0.0), psi_ = P(0.0), y1_ = P(0.0), y2_ = P(0.0), angle_ = P(0.0), target_ = P(0.0), turn_ = P(job_.turn),
    done_ = P(0.0);
  M moving_ = M(false), to_heading_ = M(true);
  // the leg
  P rho_, B1_, B2_, r1_, r2_, C1_, C2_, goal_;
  M ramp_, arrives_;
  // where it ends
  P s_, shift_, end_, low_, high_, before_;
  M marching_, there_, found_;
  Knot a_, knot_;
  Moments slow_, fast_;
  // what came of it
  P execute_[most_reversals], peak_[most_reversals], overshoot_[most_reversals];
};

template <class Arch>
void sail_packs(const ZigzagJob& job, std::size_t first, std::size_t last) {
  using Pack = ZigzagPack<Arch>;
  for (std::size_t i = first; i < last; i += 2 * Pack::lanes) {
    Pack x(job, i, last), y(job, i + Pack::lanes < last ? i + Pack::lanes : i, last);
    Pack::sail(x, y);
  }
}

}  // namespace swayaw::linear::batch
