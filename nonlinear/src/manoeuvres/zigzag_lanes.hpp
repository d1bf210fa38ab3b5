#pragma once

#include <array>
#include <limits>

#include "../simulation/dormand_prince.hpp"
#include "swayaw/core/pack.hpp"
#include "swayaw/nonlinear/models/mmg/mmg_forces.hpp"
#include "swayaw/nonlinear/simulation/equations_of_motion.hpp"
#include "zigzag_kernel.hpp"

/// The zigzag of MMG ships over packs. Only for the units of the batch kernels; see zigzag_kernel.hpp.
///
/// Each lane moves its own ship as EventStepper does (docs/simulation.md), with its own time and its own Dormand–Prince
/// step. All lanes try a step at once. A lane whose error is too large tries a shorter one next time; a lane that runs
/// over an event tries one that ends there; a lane that has finished takes the next ship.
namespace swayaw::inline nonlinear::mmg_batch {

template <class Arch>
class ZigzagLanes {
  using P = xsimd::batch<double, Arch>;
  using M = xsimd::batch_bool<double, Arch>;
  using Tableau = detail::DormandPrince;

 public:
  /// @param next  the ship of the job that is loaded next; shared by packs that run side by side
  ZigzagLanes(const ZigzagJob& job, std::size_t& next) : job_(job), next_(next) {
    for (std::size_t lane = 0; lane < lanes; ++lane) ship_of_[lane] = nobody;
    ship_.added_mass.surge_coupling.index = job.surge_coupling;
    ship_.engine.kind.index = job.engine;
    for (std::size_t lane = 0; lane < lanes; ++lane) take_numbers(lane, 0);
    load(M(true));
  }

  /// Runs two packs side by side: each waits for its own results only, so the processor works on both at once.
  static void run(ZigzagLanes& x, ZigzagLanes& y) {
    while (x.under_way_ + y.under_way_ > 0) {
      x.begin_step();
      y.begin_step();
      for (int s = 1; s < 7; ++s) {
        x.stage(s);
        y.stage(s);
      }
      x.end_step();
      y.end_step();
    }
  }

 private:
  static constexpr std::size_t lanes = P::size, branches = MmgShip<P>::branch_count,
                               numbers = parameter_count<MmgShip<P>>();
  static constexpr std::size_t nobody = std::numeric_limits<std::size_t>::max();
  static constexpr double never = std::numeric_limits<double>::infinity();

  /// psi, u, v, r.
  using State = std::array<P, 4>;

  static P select(const M& m, const P& a, const P& b) { return xsimd::select(m, a, b); }
  static M choose(const M& m, const M& a, const M& b) { return (m & a) | (~m & b); }
  static M exchanged(const M& a, const M& who) {
    return choose(who, ~a, a);
  }  // xsimd 8.1 has an or for the xor of masks
  static State select(const M& m, const State& a, const State& b) {
    return {select(m, a[0], b[0]), select(m, a[1], b[1]), select(m, a[2], b[2]), select(m, a[3], b[3])};
  }

  static PlanarMotion<P> motion_of(const State& y) { return {y[1], y[2], y[3]}; }

  // ---------------------------------------------------------------- ships come and go

  /// Numbers of the job's ship into a lane.
  void take_numbers(std::size_t lane, std::size_t ship) {
    for (std::size_t n = 0; n < numbers; ++n) number_[n][lane] = job_.numbers[ship * numbers + n];
    speed_[lane] = job_.speed[ship];
    rev_of_[lane] = job_.rev[ship];
    end_of_[lane] = job_.end[ship];
  }

  /// The next ships into these lanes, as long as there are any; a lane without a ship idles.
  void load(const M& who) {
    const auto free = lanes_of(who);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      if (!free[lane]) continue;
      under_way_ -= ship_of_[lane] != nobody;
      ship_of_[lane] = next_ < job_.count ? next_++ : nobody;
      if (ship_of_[lane] == nobody) continue;
      ++under_way_;
      take_numbers(lane, ship_of_[lane]);
    }
    read_numbers();
    begin_approach(who);
  }

  void read_numbers() {
    std::size_t n = 0;
    for_each_value(ship_, [&](P& number) { number = P::load_aligned(number_[n++].data()); });
    rev_ = P::load_aligned(rev_of_.data());
    end_ = P::load_aligned(end_of_.data());
  }

  /// Straight ahead on heading 0 with the first rudder order.
  void begin_approach(const M& who) {
    const P U = P::load_aligned(speed_.data()), L = ship_.particulars.L;
    time_unit_ = L / U;
    weight_ = {P(1.0 / job_.tolerance), P(1.0 / job_.tolerance) / U, P(1.0 / job_.tolerance) / U,
               P(1.0 / job_.tolerance) * time_unit_};
    y_ = select(who, State{P(0.0), U, P(0.0), P(0.0)}, y_);
    t_ = select(who, P(0.0), t_);
    h_ = select(who, P(0.02) * time_unit_, h_);
    turn_ = select(who, P(job_.turn), turn_);
    done_ = select(who, P(0.0), done_);
    to_heading_ = to_heading_ | who;
    flipped_ = flipped_ & ~who;
    pending_ = select(who, P(0.0), pending_);
    rudder_ = swayaw_select(who, RudderMotion<P>::moving(P(0.0), P(0.0), P(0.0)), rudder_);
    order(who, -turn_ * P(job_.rudder));
    const auto g = branch_functions(ship_, motion_of(y_), Controls<P>{P(0.0), rev_});
    for (std::size_t i = 0; i < branches; ++i) {
      branch_[i] = choose(who, g[i] > P(0.0), branch_[i]);
      g_[i] = select(who, g[i], g_[i]);
    }
    watched_ = select(who, watch(y_), watched_);
    k_[0] = select(who, rates(t_, y_), k_[0]);
  }

  void order(const M& who, const P& angle) {
    rudder_ = swayaw_select(who, RudderMotion<P>::ordered(ship_.steering_gear, t_, rudder_.at(t_), angle), rudder_);
    kink_ = select(who, rudder_.next_kink(t_), kink_);
  }

  static RudderMotion<P> swayaw_select(const M& who, const RudderMotion<P>& a, const RudderMotion<P>& b) {
    using swayaw::select;
    return select(who, a, b);
  }

  // ---------------------------------------------------------------- one step of every lane

  /// Inlined as a whole: with the forces called one by one packs of eight took 13 % longer.
  [[gnu::flatten]] State rates(const P& t, const State& y) const {
    const ShipState<P> state{P(0.0), P(0.0), y[0], motion_of(y)};
    const auto a = acceleration_of(ship_, StillSurroundings{}, NoEffects{}, state, NoEffects{},
                                   Controls<P>{rudder_.at(t), rev_}, branch_);
    return {y[3], a.u, a.v, a.r};
  }

  /// What is waited for: the heading, less where the rudder is reversed, or the yaw rate.
  P watch(const State& y) const { return select(to_heading_, turn_ * y[0] - P(job_.heading), y[3] * time_unit_); }

  void begin_step() {
    const P room = xsimd::min(kink_, end_) - t_;
    redone_ = pending_ > P(0.0);
    arrives_ = ~redone_ & (h_ >= room);
    step_ = select(redone_, cut_, xsimd::min(h_, room));
  }

  void stage(int s) {
    for (std::size_t i = 0; i < 4; ++i) {
      P sum = k_[0][i] * P(Tableau::a[s][0]);
      for (int j = 1; j < s; ++j) sum = xsimd::fma(k_[j][i], P(Tableau::a[s][j]), sum);
      end_state_[i] = xsimd::fma(step_, sum, y_[i]);
    }
    k_[s] = rates(xsimd::fma(step_, P(Tableau::c[s]), t_), end_state_);
  }

  void end_step() {
    const P error = error_of_step();
    const M good = (error <= P(1.0)) | redone_;
    adapt(error, good);
    const M settled = good & ~change_of_branch(good);
    accept(settled & ~event(settled));
  }

  P error_of_step() const {
    P worst(0.0);
    for (std::size_t i = 0; i < 4; ++i) {
      P sum = k_[0][i] * P(Tableau::e[0]);
      for (int j = 2; j < 7; ++j) sum = xsimd::fma(k_[j][i], P(Tableau::e[j]), sum);
      const P size = xsimd::abs(step_ * sum * weight_[i]);
      worst = select(size <= worst, worst, size);  // not a number is the worst
    }
    return worst;
  }

  /// log x to 1 %, for the step control.
  static P coarse_log(const P& x) {
    using I = xsimd::as_integer_t<P>;
    const I bits = xsimd::bitwise_cast<I>(x);
    const I bias = xsimd::bitwise_cast<I>(P(4503599627370496.0));  // 2⁵² + exponent
    const P exponent = xsimd::bitwise_cast<P>(((bits >> 52) & I(2047)) | bias) - P(4503599627370496.0 + 1023.0);
    const P m = xsimd::bitwise_cast<P>((bits & I((1LL << 52) - 1)) | I(1023LL << 52)) - P(1.0);
    const P log2 = exponent + m * xsimd::fnma(P(1.0 / 3), m, P(4.0 / 3));
    return P(0.69314718055994531) * log2;
  }

  /// h ← h min(5, max(0.2, 0.9 error^(−1/5))); a step that was cut short does not make the next one shorter.
  void adapt(const P& error, const M& good) {
    const P bounded = select(error < P(1e10), xsimd::max(error, P(1e-10)), P(1e10));
    const P above = P(0.2) * coarse_log(bounded) + coarse_log(P(5.0 / 0.9));
    const P next = step_ * xsimd::max(P(0.2), P(5.0) * decay(xsimd::max(above, P(0.0))));
    h_ = select(redone_, h_, select(good & arrives_, xsimd::max(h_, next), next));
  }

  // ---------------------------------------------------------------- events

  struct Dense {
    State rise, bend, third, fourth;
  };

  /// y(θ) = y_0 + θ (rise + (1 − θ) (bend + θ (third + (1 − θ) fourth)))
  Dense dense() const {
    Dense p;
    for (std::size_t i = 0; i < 4; ++i) {
      p.rise[i] = end_state_[i] - y_[i];
      p.bend[i] = step_ * k_[0][i] - p.rise[i];
      p.third[i] = p.rise[i] - step_ * k_[6][i] - p.bend[i];
      P sum = k_[0][i] * P(Tableau::d[0]);
      for (int j = 2; j < 7; ++j) sum = xsimd::fma(k_[j][i], P(Tableau::d[j]), sum);
      p.fourth[i] = step_ * sum;
    }
    return p;
  }

  P at(const Dense& p, const P& s, std::size_t i) const {
    const P rest = P(1.0) - s;
    return xsimd::fma(
        s, xsimd::fma(rest, xsimd::fma(s, xsimd::fma(rest, p.fourth[i], p.third[i]), p.bend[i]), p.rise[i]), y_[i]);
  }

  /// Root of a function on [0, 1], by false position. Source: [Anderson1973]
  struct Bracket {
    P a, fa, b, fb;

    P guess() const { return b - fb * (b - a) / (fb - fa); }

    void narrow(const M& who, const P& x, const P& f) {
      const M other = f * fb < P(0.0);
      const P shrink = P(1.0) - f / fb;
      const P scaled = fa * select(shrink > P(0.0), shrink, P(0.5));
      a = select(who & other, b, a);
      fa = select(who, select(other, fb, scaled), fa);
      b = select(who, x, b);
      fb = select(who, f, fb);
    }
  };

  /// Where both ends of a step are on the wrong side of a branch function, the step is tried once more on the other
  /// branch.
  M change_of_branch(const M& good) {
    g_end_ = branch_functions(ship_, motion_of(end_state_), Controls<P>{P(0.0), rev_});
    M changed(false);
    for (std::size_t i = 0; i < branches; ++i) {
      const P side = select(branch_[i], P(1.0), P(-1.0));
      const M wrong = good & ~flipped_ & (g_end_[i] * side < P(0.0)) & ~(g_[i] * side > P(0.0)) &
                      (pending_ != P(pending_branch(i)));
      branch_[i] = exchanged(branch_[i], wrong);
      changed = changed | wrong;
    }
    flipped_ = flipped_ | changed;
    return changed;
  }

  static constexpr double pending_watch = 1.0;
  static constexpr double pending_branch(std::size_t i) { return 2.0 + static_cast<double>(i); }

  /// Lanes that ran over an event, which is not the one they are to end at; they are to end there.
  M event(const M& good) {
    const P watched = watch(end_state_);
    const M fires = good & (pending_ != P(pending_watch)) & (watched_ != P(0.0)) & (watched_ * watched <= P(0.0));
    std::array<M, branches> crosses;
    M leaves(false);
    for (std::size_t i = 0; i < branches; ++i) {
      const P side = select(branch_[i], P(1.0), P(-1.0));
      crosses[i] = good & (pending_ != P(pending_branch(i))) & (g_end_[i] * side < P(0.0)) & (g_[i] * side > P(0.0));
      leaves = leaves | crosses[i];
    }
    watched_end_ = watched;
    if (!xsimd::any(fires | leaves)) return M(false);
    const Dense p = dense();
    P first(2.0), which(0.0);
    if (xsimd::any(fires)) {
      first = select(fires, watch_root(p, fires, watched), first);
      which = select(fires, P(pending_watch), which);
    }
    if (xsimd::any(leaves)) leave_branch(p, leaves, crosses, first, which);
    const M cut = fires | leaves;
    cut_ = select(cut, first * step_, cut_);
    pending_ = select(cut, which, pending_);
    return cut;
  }

  P watch_root(const Dense& p, const M& fires, const P& watched) const {
    Bracket bracket{P(0.0), watched_, P(1.0), watched};
    M seeking = fires & (watched != P(0.0));
    P root(1.0);
    for (int i = 0; i < 30 && xsimd::any(seeking); ++i) {
      const P x = bracket.guess();
      const State y{at(p, x, 0), P(0.0), P(0.0), at(p, x, 3)};
      const P f = watch(y);
      const M there = (xsimd::abs(x - root) < P(1e-9)) | (f == P(0.0));
      bracket.narrow(seeking, x, f);
      root = select(seeking, x, root);
      seeking = seeking & ~there;
    }
    return root;
  }

  /// The first branch that is left. The forces are continuous there, so a root to 1e-4 of a step makes an error of 1e-8
  /// of the kink.
  void leave_branch(const Dense& p, const M& leaves, const std::array<M, branches>& crosses, P& first, P& which) const {
    Bracket bracket{P(0.0), P(1.0), P(1.0), P(-1.0)};
    P estimate(2.0), index(0.0);
    for (std::size_t i = 0; i < branches; ++i) {
      const P here = g_[i] / (g_[i] - g_end_[i]);
      const M earlier = crosses[i] & (here < estimate);
      estimate = select(earlier, here, estimate);
      index = select(earlier, P(pending_branch(i)), index);
      bracket.fa = select(earlier, g_[i], bracket.fa);
      bracket.fb = select(earlier, g_end_[i], bracket.fb);
    }
    for (int round = 0; round < 3; ++round) {
      const P x = bracket.guess();
      const State y{P(0.0), at(p, x, 1), at(p, x, 2), at(p, x, 3)};
      const auto g = branch_functions(ship_, motion_of(y), Controls<P>{P(0.0), rev_});
      P f = bracket.fb;
      for (std::size_t i = 0; i < branches; ++i) f = select(index == P(pending_branch(i)), g[i], f);
      bracket.narrow(leaves & (f != P(0.0)), x, f);
    }
    const P root = bracket.guess();
    const M before = leaves & (root < first);
    first = select(before, root, first);
    which = select(before, index, which);
  }

  // ---------------------------------------------------------------- after a step

  void accept(const M& taken) {
    const M to_end = taken & arrives_;
    t_ = select(to_end, xsimd::min(kink_, end_), select(taken, t_ + step_, t_));
    y_ = select(taken, end_state_, y_);
    k_[0] = select(taken, k_[6], k_[0]);
    for (std::size_t i = 0; i < branches; ++i) {
      g_[i] = select(taken, g_end_[i], g_[i]);
      branch_[i] = exchanged(branch_[i], taken & (pending_ == P(pending_branch(i))));
    }
    watched_ = select(taken, watched_end_, watched_);
    flipped_ = flipped_ & ~taken;
    const M seen = taken & (pending_ == P(pending_watch));
    pending_ = select(taken, P(0.0), pending_);
    kink_ = select(to_end, rudder_.next_kink(t_), kink_);
    if (xsimd::any(seen)) note(seen);
    const M complete = done_ >= P(static_cast<double>(job_.reversals)), over = t_ >= end_,
            lost = ~(h_ > P(1e-8) * time_unit_);
    if (xsimd::any(complete | over | lost)) unload(complete, over, lost);
  }

  /// The heading at which the rudder is reversed, or a heading peak.
  void note(const M& seen) {
    const M reversal = seen & to_heading_, peak = seen & ~to_heading_;
    if (xsimd::any(reversal)) {
      store(reversal, t_, job_.time);
      order(reversal, turn_ * P(job_.rudder));
    }
    if (xsimd::any(peak)) {
      store(peak, t_, job_.peak);
      store(peak, turn_ * y_[0] - P(job_.heading), job_.overshoot);
      turn_ = select(peak, -turn_, turn_);
      done_ = select(peak, done_ + P(1.0), done_);
    }
    to_heading_ = exchanged(to_heading_, seen);
    watched_ = select(seen, watch(y_), watched_);
  }

  void unload(const M& complete, const M& over, const M& lost) {
    const auto is_complete = lanes_of(complete), is_over = lanes_of(over), is_lost = lanes_of(lost);
    const auto peaks = numbers_of(done_);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      if (ship_of_[lane] == nobody || !(is_complete[lane] || is_over[lane] || is_lost[lane])) continue;
      job_.peaks[job_.row[ship_of_[lane]]] = static_cast<unsigned char>(peaks[lane]);
      job_.left[ship_of_[lane]] = is_complete[lane] ? Left::complete
                                  : is_over[lane]   ? Left::time_over
                                                    : Left::unbounded;
    }
    load(complete | over | lost);
  }

  void store(const M& who, const P& value, double* table) const {
    const auto wanted = lanes_of(who);
    const auto row = numbers_of(done_), values = numbers_of(value);
    for (std::size_t lane = 0; lane < lanes; ++lane)
      if (wanted[lane] && ship_of_[lane] != nobody)
        table[static_cast<std::size_t>(row[lane]) * job_.rows + job_.row[ship_of_[lane]]] = values[lane];
  }

  struct alignas(64) Numbers {
    double number[lanes];
    double operator[](std::size_t i) const { return number[i]; }
    double& operator[](std::size_t i) { return number[i]; }
    const double* data() const { return number; }
  };

  static Numbers numbers_of(const P& x) {
    Numbers result;
    x.store_aligned(result.number);
    return result;
  }

  struct Flags {
    bool flag[lanes];
    bool operator[](std::size_t i) const { return flag[i]; }
  };

  static Flags lanes_of(const M& who) {
    const auto ones = numbers_of(select(who, P(1.0), P(0.0)));
    Flags result;
    for (std::size_t i = 0; i < lanes; ++i) result.flag[i] = ones[i] > 0.0;
    return result;
  }

  const ZigzagJob& job_;
  std::size_t& next_;
  std::size_t under_way_ = 0;  ///< lanes with a ship
  std::size_t ship_of_[lanes];
  std::array<Numbers, numbers> number_;
  Numbers speed_, rev_of_, end_of_;
  MmgShip<P> ship_{};
  P rev_, end_, time_unit_;
  State weight_;
  // where the ship is, and what she is about
  P t_ = P(0.0), h_ = P(1.0), turn_ = P(1.0), done_ = P(0.0), kink_ = P(never);
  State y_{P(0.0), P(1.0), P(0.0), P(0.0)};
  M to_heading_ = M(true), flipped_ = M(false);
  Branch<P, branches> branch_{M(false), M(false), M(false)};
  std::array<P, branches> g_{P(0.0), P(0.0), P(0.0)}, g_end_;
  P watched_ = P(0.0), watched_end_;
  RudderMotion<P> rudder_;
  // the step
  P step_, cut_ = P(0.0), pending_ = P(0.0);  ///< the event at which the step is to end, 0 for none
  M redone_, arrives_;  ///< it ends at that event; it ends at a kink of the rudder's motion or at the end
  State end_state_, k_[7];
};

template <class Arch>
void run_lanes(const ZigzagJob& job) {
  if (job.count == 0) return;
  std::size_t next = 0;
  ZigzagLanes<Arch> x(job, next), y(job, next);
  ZigzagLanes<Arch>::run(x, y);
}

}  // namespace swayaw::nonlinear::mmg_batch
