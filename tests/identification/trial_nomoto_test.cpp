#include <algorithm>
#include <catch.hpp>
#include <cmath>
#include <vector>

#include "files.hpp"
#include "linear_recordings.hpp"
#include "recorded_trials.hpp"
#include "swayaw/core/recording_csv.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/identification/trial.hpp"
#include "swayaw/linear/indices.hpp"
#include "swayaw/linear/zigzag.hpp"

/// K and T of a judged zigzag beside those that Nomoto worked out of a zigzag by hand, written here a second time.
namespace swayaw {
namespace {

using test::ship_time;

/// T dr/dt + r = K (delta + offset), rudder positive to starboard.
struct ByHand {
  double K, T, offset;
};

/// A moment of the zigzag: heading off the first one, yaw rate, ∫ delta dt with delta positive to starboard.
struct Mark {
  double time, psi, r, integral;
};

/// Samples of a zigzag with a yaw rate, and the curve between them.
class Zigzag1960 {
 public:
  /// @param exact  the curve between samples is drawn through headings and yaw rates; else marks are samples
  Zigzag1960(const Recording& run, bool exact) : run_(run), exact_(exact), integral_(run.samples(), 0.0) {
    for (std::size_t i = 1; i < run.samples(); ++i)
      integral_[i] = integral_[i - 1] - 0.5 * (delta(i - 1) + delta(i)) * (time(i) - time(i - 1));
  }

  /// Where the yaw rate is zero: at the outermost heading of each excursion that comes back.
  std::vector<Mark> peaks() const {
    std::vector<Mark> result;
    const double half = 0.5 * largest();
    std::size_t top = 0;
    for (std::size_t i = 1; i < run_.samples(); ++i) {
      if (psi(i) * psi(i - 1) < 0.0) {
        if (std::abs(psi(top)) > half) result.push_back(yaw_rate_zero_near(top));
        top = i;
      }
      if (std::abs(psi(i)) > std::abs(psi(top))) top = i;
    }
    return result;
  }

  /// Where the heading is back at the first one, after each peak.
  std::vector<Mark> passages(const std::vector<Mark>& peaks) const {
    std::vector<Mark> result;
    for (const auto& peak : peaks)
      for (std::size_t i = 1; i < run_.samples(); ++i)
        if (time(i - 1) > peak.time && psi(i - 1) * peak.psi > 0.0 && psi(i) * peak.psi <= 0.0) {
          result.push_back(heading_zero_in(i));
          break;
        }
    return result;
  }

 private:
  double time(std::size_t i) const { return run_.time[i]; }
  double psi(std::size_t i) const { return run_[Channel::psi][i] - run_[Channel::psi][0]; }
  double r(std::size_t i) const { return run_[Channel::r][i]; }
  double delta(std::size_t i) const { return run_[Channel::delta][i]; }

  double largest() const {
    double most = 0.0;
    for (std::size_t i = 0; i < run_.samples(); ++i) most = std::max(most, std::abs(psi(i)));
    return most;
  }

  /// The parabola r = r0 + b s + c s², s from 0 to 1 between samples i − 1 and i, whose ends and integral are recorded.
  Mark at(std::size_t i, double s) const {
    const double h = time(i) - time(i - 1), mean = (psi(i) - psi(i - 1)) / h;
    const double c = exact_ ? -6.0 * (mean - 0.5 * (r(i - 1) + r(i))) : 0.0, b = r(i) - r(i - 1) - c;
    const double psi_s =
        exact_ ? psi(i - 1) + h * s * (r(i - 1) + s * (b / 2.0 + s * c / 3.0)) : (1.0 - s) * psi(i - 1) + s * psi(i);
    const double way = h * s * (delta(i - 1) + 0.5 * s * (delta(i) - delta(i - 1)));
    return {time(i - 1) + s * h, psi_s, r(i - 1) + s * (b + s * c), integral_[i - 1] - way};
  }

  /// Where `value` of the mark changes its sign between two samples, by halving.
  template <class F>
  Mark zero_in(std::size_t i, F&& value) const {
    double low = 0.0, high = 1.0;
    const double sign = value(at(i, low));
    for (int k = 0; k < 60; ++k) {
      const double middle = 0.5 * (low + high);
      (value(at(i, middle)) * sign > 0.0 ? low : high) = middle;
    }
    return at(i, low);
  }

  Mark heading_zero_in(std::size_t i) const {
    return zero_in(i, [](const Mark& m) { return m.psi; });
  }

  Mark yaw_rate_zero_near(std::size_t top) const {
    for (const std::size_t i : {top, top + 1})
      if (exact_ && r(i - 1) * r(i) < 0.0) return zero_in(i, [](const Mark& m) { return m.r; });
    return at(top, 1.0);
  }

  const Recording& run_;
  bool exact_;
  std::vector<double> integral_;
};

/// [psi] = K (∫ delta dt + offset [t]) between zeros of the yaw rate; swings to port and to starboard are summed apart
/// and give K and the offset. From a zero of the yaw rate to the passage of the first heading T r + [psi] = K (…) gives
/// T.
ByHand worked_by_hand(const Recording& run, bool exact) {
  const Zigzag1960 zigzag(run, exact);
  const auto peaks = zigzag.peaks();
  const auto passages = zigzag.passages(peaks);
  if (peaks.size() < 3) throw Refusal("fewer than three peaks");
  double psi[2] = {}, I[2] = {}, t[2] = {};
  for (std::size_t k = 1; k < peaks.size(); ++k) {
    psi[k % 2] += peaks[k].psi - peaks[k - 1].psi;
    I[k % 2] += peaks[k].integral - peaks[k - 1].integral;
    t[k % 2] += peaks[k].time - peaks[k - 1].time;
  }
  // psi_0 = K I_0 + K offset t_0, psi_1 = K I_1 + K offset t_1
  const double determinant = I[0] * t[1] - I[1] * t[0];
  const double K = (psi[0] * t[1] - psi[1] * t[0]) / determinant,
               K_offset = (I[0] * psi[1] - I[1] * psi[0]) / determinant;
  double T = 0.0;
  for (std::size_t k = 0; k < passages.size(); ++k) {
    const auto &from = peaks[k], &to = passages[k];
    const double left = K * (to.integral - from.integral) + K_offset * (to.time - from.time) - (to.psi - from.psi);
    T += left / (to.r - from.r) / static_cast<double>(passages.size());
  }
  return {K, T, K_offset / K};
}

/// K and T of the trial over those by hand: the least and the largest of a set of zigzags.
struct Ratios {
  double K_least = HUGE_VAL, K_most = 0.0, T_least = HUGE_VAL, T_most = 0.0;
  int zigzags = 0;

  void add(const NomotoTold& told, const ByHand& hand) {
    const double K = told.K.value / hand.K, T = told.T.value / hand.T;
    K_least = std::min(K_least, K), K_most = std::max(K_most, K);
    T_least = std::min(T_least, T), T_most = std::max(T_most, T);
    ++zigzags;
  }
};

struct Both {
  Ratios least_squares, worked;

  void add(const TrialResult& trial, const ByHand& hand) {
    least_squares.add(*trial.steering.least_squares, hand);
    worked.add(*trial.steering.worked, hand);
  }
};

std::ostream& operator<<(std::ostream& out, const Ratios& r) {
  return out << r.zigzags << " zigzags, K " << r.K_least << " to " << r.K_most << ", T " << r.T_least << " to "
             << r.T_most;
}

std::ostream& operator<<(std::ostream& out, const Both& both) {
  return out << "least squares " << both.least_squares << "; Nomoto's method " << both.worked;
}

// ---------------------------------------------------------------- ships whose K and T are known

TEST_CASE("of a first-order ship the hand's K, T and offset are those of the trial", "[identification][second-route]") {
  test::RandomLinearShips random(91);
  for (int k = 0; k < 12; ++k) {
    const double K = random.uniform(-3.0, -0.8), T = random.uniform(0.5, 4.0);
    const auto run = test::recorded(first_order_ship(K, T), {.lengths = 40.0, .step = 0.0105, .rudder_offset = 0.01});
    const auto trial = judge_trial(run, {.L = test::ship_length});
    const auto hand = worked_by_hand(run, true);
    INFO("K' " << K << " T' " << T);
    REQUIRE(trial.steering.least_squares);
    CHECK_THAT(hand.K * ship_time, WithinRel(-K, 1e-6));
    CHECK_THAT(trial.steering.least_squares->K.value, WithinRel(hand.K, 1e-6));
    CHECK_THAT(trial.steering.least_squares->T.value, WithinRel(hand.T, 1e-6));
    CHECK_THAT(trial.steering.least_squares->offset.value, WithinAbs(hand.offset, 1e-7));
    CHECK_THAT(trial.steering.worked->K.value, WithinRel(hand.K, 1e-5));
    CHECK_THAT(trial.steering.worked->T.value, WithinRel(hand.T, 1e-5));
  }
}

// ---------------------------------------------------------------- ships that are not of first order

/// Ships whose T by hand is at least 0.3 L/U; with less, as of most PI ships, T is told by no method.
constexpr double least_T = 0.3;

Both second_order_ships() {
  test::RandomLinearShips random(92);
  Both both;
  for (int k = 0; k < 40; ++k) {
    const double T1 = random.uniform(1.0, 8.0), T2 = random.uniform(0.2, 0.4), T3 = random.uniform(0.5, 1.0),
                 K = random.uniform(-3.0, -1.0);
    const auto ship = coefficients_from(SteeringIndices<double>{T1 * T2, T1 + T2, 0.15, T3, 0.7 * K, K});
    const auto run = test::recorded(ship, {.lengths = 40.0});
    both.add(judge_trial(run, {.L = test::ship_length}), worked_by_hand(run, true));
  }
  return both;
}

template <class Model>
Both nonlinear_ships(unsigned seed) {
  test::RandomModels random(seed);
  Both both;
  for (int k = 0; k < 200 && both.worked.zigzags < 20; ++k) {
    const auto ship = test::trial_ship<Model>(random);
    if (!ship) continue;
    const double L = length(*ship), U = service_speed(*ship), angle = radians(k % 2 == 0 ? 10.0 : 20.0);
    try {
      const auto z = zigzag(*ship, {angle, angle}, {.step = 0.02 * L / U});
      if (z.reversals.size() < 4 || !z.reversals.back().overshoot || !test::is_zigzag(z.run)) continue;
      const auto hand = worked_by_hand(z.run, true);
      if (hand.T > least_T * L / U) both.add(judge_trial(z.run, {.L = L}), hand);
    } catch (const Refusal&) {}  // runs away
  }
  return both;
}

TEST_CASE("Nomoto's K of the trial is that by hand, and least squares differs as far as the ship is not of first order",
          "[identification][second-route]") {
  struct Known {
    const char* ships;
    Both both;
    Ratios bounds;  ///< of least squares, as measured on these ships
  };
  const Known known[] = {
      {"second order", second_order_ships(), {1.0, 1.10, 1.0, 1.12}},
      {"MMG", nonlinear_ships<MmgShip<double>>(31), {0.81, 1.10, 0.93, 1.13}},
      {"PU", nonlinear_ships<PuShip<double>>(33), {0.91, 1.10, 0.84, 1.40}},
      {"Abkowitz", nonlinear_ships<AbkowitzShip<double>>(34), {0.62, 1.04, 0.71, 1.09}},
  };
  for (const auto& [ships, both, bounds] : known) {
    INFO(ships << ": " << both);
    CHECK(both.least_squares.K_least >= bounds.K_least);
    CHECK(both.least_squares.K_most <= bounds.K_most);
    CHECK(both.least_squares.T_least >= bounds.T_least);
    CHECK(both.least_squares.T_most <= bounds.T_most);
    // samples in place of the curve between them
    CHECK(both.worked.K_least >= 0.995);
    CHECK(both.worked.K_most <= 1.005);
    CHECK(both.worked.T_least >= 0.55);
    CHECK(both.worked.T_most <= 1.11);
    CHECK(both.worked.zigzags >= 5);
  }
}

// ---------------------------------------------------------------- recordings

Both recorded_zigzags(const std::filesystem::path& folder, double L) {
  Both both;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".csv") continue;
    const auto run = read_recording(entry.path()).recording;
    try {
      const auto trial = judge_trial(run, {.L = L});
      if (trial.steering.worked) both.add(trial, worked_by_hand(run, false));
    } catch (const Refusal&) {}  // no zigzag, or fewer than three peaks
  }
  return both;
}

TEST_CASE("K and T of recorded zigzags beside those by hand", "[identification][published]") {
  struct Known {
    const char* folder;
    double L;
    Ratios bounds;  ///< of least squares, as measured
  };
  const Known known[] = {{"kvlcc2", 7.0, {0.97, 1.10, 1.04, 1.16}},
                         {"kcs", 230.0, {0.93, 0.96, 1.01, 1.04}},
                         {"esso_osaka", 3.0, {0.99, 1.16, 1.14, 1.74}}};
  for (const auto& [name, L, bounds] : known) {
    const auto folder = test::benchmark_recordings(name);
    if (!folder) continue;
    const auto both = recorded_zigzags(*folder, L);
    INFO(name << ": " << both);
    CHECK(both.least_squares.K_least >= bounds.K_least);
    CHECK(both.least_squares.K_most <= bounds.K_most);
    CHECK(both.least_squares.T_least >= bounds.T_least);
    CHECK(both.least_squares.T_most <= bounds.T_most);
    CHECK(both.worked.zigzags >= 1);
  }
}

}  // namespace
}  // namespace swayaw
