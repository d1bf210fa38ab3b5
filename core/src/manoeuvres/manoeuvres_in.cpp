#include "swayaw/core/manoeuvres_in.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "rudder_holds.hpp"

namespace swayaw::inline core {
using namespace detail;
namespace {

// ---------------------------------------------------------------- angles in words

/// The angle that was ordered, from that which was measured [deg]: a usual one if it is near. An order that waits for
/// an angle comes late rather than early, by `late` or a tenth.
int nominal(double measured, double late = 0.0) {
  constexpr double most_degrees = 1e6;  // of a column in the wrong unit; an int holds it
  for (const int usual : {1, 2, 3, 5, 10, 15, 20, 25, 30, 35, 40, 45}) {
    const double near = std::max(0.5, std::min(0.15 * usual, 1.5));
    const double latest = usual < 5 || late == 0.0 ? 0.0 : std::max(late, 0.1 * usual);
    if (measured >= usual - near && measured <= usual + std::max(near, latest)) return usual;
  }
  return static_cast<int>(std::lround(std::clamp(measured, 0.0, most_degrees)));
}

std::string_view side_of(double heading_change) { return heading_change > 0.0 ? "starboard" : "port"; }

// ---------------------------------------------------------------- search

/// Thresholds that separate amidships from angles of 20, 10 and 5 deg and more; the greatest first, so that the
/// course-keeping beside a manoeuvre counts for nothing [deg].
constexpr std::array thresholds{14.0, 7.0, 3.5};

constexpr double approach = 60.0;           // [s] of the approach that a piece has
constexpr double longest_settling = 120.0;  // [s] after a manoeuvre

class Search {
 public:
  explicit Search(const Recording& run)
      : run_(run),
        rudder_(rudder_track(run)),
        smooth_(smoothed(rudder_)),
        heading_(heading_track(run)),
        speed_(speed_track(run)) {}

  std::vector<ManoeuvrePiece> pieces() {
    if (rudder_.size() < 2 || heading_.size() < 2) return {};
    for (const double threshold : thresholds) find_zigzags(holds_beyond(rudder_, threshold));
    find_spirals();
    for (const double threshold : thresholds) find_turns(holds_beyond(rudder_, threshold));
    if (found_.empty()) find_slow_zigzag();
    add_margins();
    find_steady_runs();
    std::ranges::sort(found_, {}, &ManoeuvrePiece::begin);
    pair_speed_runs();
    return std::move(found_);
  }

 private:
  bool is_free(double from, double to) const {
    return std::ranges::none_of(found_, [&](const auto& piece) { return piece.begin < to && from < piece.end; });
  }

  bool is_free(const Hold& hold) const { return is_free(hold.from, hold.to); }

  void add(double begin, double end, std::string name, double execute, std::string why) {
    found_.push_back({begin, end, std::move(name), execute, std::move(why)});
  }

  /// Rudder angle in the half minute before an order, as far as it was near amidships [deg].
  double angle_before(double order) const {
    const auto end = std::min(rudder_.from(order), rudder_.size() - 1);
    std::vector<double> values;
    for (std::size_t i = end; i-- > 0 && rudder_.time[i] > order - 0.5 * approach && values.size() < 1000;)
      if (std::abs(rudder_.value[i]) <= 5.0) values.push_back(rudder_.value[i]);
    return values.empty() ? 0.0 : median_of(std::move(values));
  }

  /// Once more from the angle just before, which course-keeping has moved away from amidships.
  double execute_of(const Hold& hold) const {
    const double from_amidships = start_of_change(rudder_, 0.0, hold.level, hold.from);
    const double rough = start_of_change(rudder_, angle_before(from_amidships), hold.level, hold.from);
    const auto end = rudder_.from(rough);
    constexpr std::size_t few = 5;  // samples, whose median has half the noise of one
    if (end < few) return rough;
    const auto last = rudder_.value.begin() + static_cast<std::ptrdiff_t>(end);
    const double before = median_of({last - few, last});
    const bool near = std::abs(before) <= 0.5 * std::abs(hold.level);
    return near ? start_of_change(rudder_, before, hold.level, hold.from) : rough;
  }

  // -------------------------------------------------------------- zigzags

  void find_zigzags(const std::vector<Hold>& holds) {
    for (std::size_t first = 0; first < holds.size();) {
      auto count = chain_from(holds, first);
      count = count >= 3 ? take_zigzag({holds.data() + first, count}) : 1;
      first += std::max<std::size_t>(count, 1);
    }
  }

  /// A zigzag of a ship that turns faster than her rudder moves, which is hardly held: what nearly all of a recording
  /// shows cannot be course-keeping.
  void find_slow_zigzag() {
    held_long_ = false;
    for (const double threshold : thresholds) find_zigzags(holds_beyond(rudder_, threshold));
    const double most = 0.5 * (run_.time.back() - run_.time.front());
    std::erase_if(found_, [&](const auto& piece) { return piece.end - piece.begin < most; });
  }

  /// How many holds from the first on are of one size, to either side in turn.
  std::size_t chain_from(const std::vector<Hold>& holds, std::size_t first) const {
    std::size_t end = first + 1;
    if (!is_free(holds[first])) return 1;
    while (end < holds.size() && is_free(holds[end]) && follows(holds, first, end)) ++end;
    return end - first;
  }

  bool follows(const std::vector<Hold>& holds, std::size_t first, std::size_t k) const {
    const auto &hold = holds[k], &before = holds[k - 1];
    const double size = 0.5 * std::abs(hold.level - before.level);
    const bool opposite = hold.level * before.level < 0.0;
    // a zero that is off by 2 deg; the first reversal may come before a slow rudder has arrived
    const bool arrived = is_held(before) && std::abs(hold.level + before.level) <= std::min(4.0, 0.5 * size);
    const bool late = k == first + 1 && std::abs(before.level) < std::abs(hold.level) &&
                      (!held_long_ || before.duration() < 0.5 * hold.duration());
    const bool equal = arrived || late;
    const bool again = k < first + 3 || std::abs(hold.level - holds[k - 2].level) <= std::max(1.5, 0.15 * size);
    return opposite && equal && again && is_held(hold) && goes_across(before, hold);
  }

  bool is_held(const Hold& hold) const { return hold.flat >= flat_enough || !held_long_; }

  /// From one side to the other without a stay amidships: at a steady rate a third of the way is within 0.3 of the
  /// angle.
  bool goes_across(const Hold& before, const Hold& hold) const {
    if (hold.from - before.to > 1.5 * std::max(before.duration(), hold.duration())) return false;
    const auto from = rudder_.from(before.to), to = rudder_.from(hold.from);
    const double amidships = std::max(0.3 * std::abs(hold.level), 1.5);
    std::size_t there = 0;
    for (std::size_t i = from; i < to; ++i) there += std::abs(rudder_.value[i]) < amidships ? 1 : 0;
    return there <= 2 || 5 * there <= 3 * (to - from);
  }

  /// A zigzag of these holds, or of the first of them.
  /// @return how many holds belong to it; 0 if it is none
  std::size_t take_zigzag(std::span<const Hold> holds) {
    const double execute = execute_of(holds[0]);
    const double course = heading_.at(execute);
    std::vector<double> off;  // heading off the approach at the reversals [deg]
    for (std::size_t k = 0; k + 1 < holds.size(); ++k) {
      const double reversal = start_of_change(rudder_, holds[k].level, holds[k + 1].level, holds[k + 1].from);
      const double now = heading_.at(reversal) - course;
      if (!off.empty() && now * off.back() >= 0.0) break;
      off.push_back(now);
    }
    while (off.size() >= 2 && !is_even(off)) off.pop_back();
    const double size = 0.5 * std::abs(holds[2].level - holds[1].level);
    if (off.size() < 2 || !is_usual(size, switch_angle(off))) return 0;
    if (crossing_share(holds.first(off.size() + 1)) > sinusoid && held_long_) return 0;
    tell_zigzag(holds.first(off.size() + 1), execute, off);
    return off.size() + 1;
  }

  /// Angles at which zigzags are reversed are those of the rudder or up to twice as great; 2.5 leaves room for
  /// helmsmen.
  static bool is_usual(double size, double H) { return H <= 2.5 * size; }

  static double switch_angle(const std::vector<double>& off) {
    double sum = 0.0;
    for (std::size_t k = 1; k < off.size(); ++k) sum += 0.5 * std::abs(off[k] - off[k - 1]);
    return sum / static_cast<double>(off.size() - 1);
  }

  /// Reversals at one angle to either side; a helmsman and an approach that is off make them differ.
  static bool is_even(const std::vector<double>& off) {
    const double H = switch_angle(off);
    return H > 0.5 &&
           std::ranges::all_of(off, [H](double one) { return std::abs(std::abs(one) - H) <= std::max(2.5, 0.5 * H); });
  }

  /// Share of the time in which the rudder moves from one side to the other; without the first hold where there are
  /// more than three, which is shorter than the others.
  static double crossing_share(std::span<const Hold> holds) {
    if (holds.size() > 3) holds = holds.subspan(1);
    double crossing = 0.0, held = 0.0;
    for (std::size_t k = 0; k + 1 < holds.size(); ++k) {
      crossing += holds[k + 1].from - holds[k].to;
      held += holds[k].duration();
    }
    return crossing / (crossing + held);
  }

  void tell_zigzag(std::span<const Hold> holds, double execute, const std::vector<double>& off) {
    double size = 0.0;
    for (std::size_t k = 1; k + 1 < holds.size(); ++k)
      size += 0.5 * std::abs(holds[k + 1].level - holds[k].level) / static_cast<double>(holds.size() - 2);
    const double H = switch_angle(off);
    add(execute, holds.back().to, fmt::format("zigzag {}/{}", nominal(size), nominal(H, late_order)), execute,
        fmt::format("first to {}, {} reversals; rudder held at {:.1f} deg, reversed at {:.1f} deg of heading",
                    side_of(off.front()), off.size(), size, H));
  }

  // -------------------------------------------------------------- turns and pull-outs

  void find_turns(const std::vector<Hold>& holds) {
    for (std::size_t k = 0; k < holds.size(); ++k) {
      const auto& hold = holds[k];
      if (!is_free(hold) || hold.flat < flat_enough) continue;
      const double turned = heading_.at(hold.to) - heading_.at(hold.from);
      const double released = k + 1 < holds.size() ? holds[k + 1].begin : rudder_.time.back();
      if (std::abs(turned) >= 180.0 && is_straight_before(execute_of(hold))) tell_turn(hold, turned);
      if (std::abs(turned) >= 90.0) look_for_pull_out(hold, turned, released);
    }
  }

  /// Not in a turn already, as after the first rudder of a Williamson turn.
  bool is_straight_before(double execute) const {
    const auto [low, high] = heading_.range(execute - 0.5 * approach, execute);
    return high - low <= 6.0;  // [deg]
  }

  void tell_turn(const Hold& hold, double turned) {
    const double execute = execute_of(hold);
    add(execute, hold.to, fmt::format("turn {}", nominal(std::abs(hold.level))), execute,
        fmt::format("to {}, by {:.0f} deg; rudder held at {:.1f} deg", side_of(turned), std::abs(turned),
                    std::abs(hold.level)));
  }

  /// The rudder stays amidships for as long as a third of the turn at least.
  void look_for_pull_out(const Hold& hold, double turned, double next) {
    constexpr double shortest = 20.0;  // [s]
    constexpr double amidships = 2.0;  // [deg]
    const auto is_amidships = [&](std::size_t i) { return std::abs(smooth_.value[i]) <= amidships; };
    std::size_t i = smooth_.from(hold.to);
    while (i < smooth_.size() && !is_amidships(i) && smooth_.time[i] < hold.end + shortest) ++i;
    const std::size_t from = i;
    while (i < smooth_.size() && smooth_.time[i] <= next && is_amidships(i)) ++i;
    if (from == i) return;
    const double until = smooth_.time[i - 1];
    if (until - smooth_.time[from] < std::max(shortest, hold.duration() / 3.0)) return;
    const double put = hold.from - execute_of(hold), released = smooth_.time[from] - hold.to;
    if (released > 2.0 * put + 3.0) return;  // an autopilot eases the rudder; an order moves it as fast as before
    const double execute = start_of_change(rudder_, hold.level, 0.0, rudder_.time[from]);
    const double settled = settled_after(execute + std::max(shortest, hold.duration() / 3.0), until);
    add(execute, settled, fmt::format("pull-out {}", nominal(std::abs(hold.level))), execute,
        fmt::format("from a turn to {} at {:.1f} deg; rudder amidships for {:.0f} s", side_of(turned),
                    std::abs(hold.level), until - rudder_.time[from]));
  }

  // -------------------------------------------------------------- spirals

  /// Stretches of at least so long in which the rudder stays near its mean; neighbours at one angle are one.
  std::vector<Hold> levels() const {
    constexpr double shortest = 10.0;  // [s]
    constexpr double near = 1.8;       // [deg]: steps of spirals are 5 deg, at least 4
    std::vector<Hold> result;
    std::size_t last = 0;  // where the last level begins
    for (std::size_t begin = 0; begin < smooth_.size();) {
      double sum = 0.0;
      std::size_t end = begin;
      const auto mean_of = [&] { return sum / static_cast<double>(end - begin); };
      while (end < smooth_.size() && (end == begin || std::abs(smooth_.value[end] - mean_of()) <= near))
        sum += smooth_.value[end++];
      if (smooth_.time[end - 1] - smooth_.time[begin] < shortest) {
        ++begin;
        continue;
      }
      const auto hold = hold_between(smooth_, begin, end);
      const bool goes_on = !result.empty() && std::abs(hold.level - result.back().level) < near &&
                           hold.begin - result.back().end < shortest;
      if (goes_on) result.back() = hold_between(smooth_, last, end);
      else result.push_back(hold), last = begin;
      begin = end;
    }
    return result;
  }

  void find_spirals() {
    const auto all = levels();
    for (std::size_t first = 0; first + 1 < all.size();) {
      std::size_t end = first + 1;
      while (end < all.size() && is_step(all[end - 1], all[end])) ++end;
      if (is_spiral({all.data() + first, end - first})) tell_spiral({all.data() + first, end - first});
      first = end;
    }
  }

  /// To a neighbouring angle, and soon, from an angle that was held.
  bool is_step(const Hold& before, const Hold& hold) const {
    const double step = std::abs(hold.level - before.level);
    const bool soon = hold.from - before.to <= 0.5 * std::max(hold.duration(), before.duration());
    return step >= 2.0 && step <= 12.0 && soon && drift_in(before) <= 0.25 * step && drift_in(hold) <= 0.25 * step;
  }

  /// How far the rudder moves from the first third of a hold to the last [deg]; a slow ramp moves by two thirds of a
  /// step.
  double drift_in(const Hold& hold) const {
    const double third = hold.duration() / 3.0;
    return std::abs(smooth_.mean(hold.to - third, hold.to) - smooth_.mean(hold.from, hold.from + third));
  }

  /// Five angles in one direction, across amidships.
  bool is_spiral(std::span<const Hold> steps) const {
    if (!is_free(steps.front().from, steps.back().to)) return false;
    std::size_t longest = 0, one_way = 1;
    double lowest = 0.0, highest = 0.0;
    for (std::size_t k = 1; k < steps.size(); ++k) {
      const bool same =
          k >= 2 && (steps[k].level - steps[k - 1].level) * (steps[k - 1].level - steps[k - 2].level) > 0.0;
      one_way = same ? one_way + 1 : 2;
      longest = std::max(longest, one_way);
    }
    for (const auto& step : steps) lowest = std::min(lowest, step.level), highest = std::max(highest, step.level);
    return longest >= 5 && lowest < -4.0 && highest > 4.0;
  }

  void tell_spiral(std::span<const Hold> steps) {
    double largest = 0.0;
    for (const auto& step : steps) largest = std::max(largest, std::abs(step.level));
    const double turned = heading_.at(steps.front().to) - heading_.at(steps.front().from);
    const double execute = execute_of(steps.front());
    add(execute, steps.back().to, fmt::format("spiral {}", nominal(largest)), execute,
        fmt::format("first to {}, {} rudder angles held, the largest {:.1f} deg", side_of(turned), steps.size(),
                    largest));
  }

  // -------------------------------------------------------------- margins

  /// The approach before, and what follows until the heading is steady, as far as neighbours leave room; of a pull-out
  /// the end of its turn.
  void add_margins() {
    std::ranges::sort(found_, {}, &ManoeuvrePiece::begin);
    for (std::size_t k = 0; k < found_.size(); ++k) {
      auto& piece = found_[k];
      const double before = k > 0 ? found_[k - 1].end : run_.time.front();
      const bool in_turn = piece.manoeuvre.starts_with("pull-out");
      piece.begin = in_turn ? piece.begin - 0.5 * approach : std::max(piece.begin - approach, before);
      piece.begin = std::max(piece.begin, run_.time.front());
      const double next = k + 1 < found_.size() ? found_[k + 1].begin : run_.time.back();
      const double room = std::max(piece.end, next - (k + 1 < found_.size() ? 0.5 * approach : 0.0));
      piece.end = std::min(settled_after(piece.end, std::min(piece.end + longest_settling, run_.time.back())), room);
      piece.end = std::max(piece.end, piece.begin);
    }
  }

  /// When the heading has kept within 2 deg for half a minute, or at `last`.
  double settled_after(double end, double last) const {
    constexpr double window = 30.0, step = 2.0, steady = 2.0;  // [s], [s], [deg]
    constexpr double given_up = 3600.0;                        // [s]: a heading that swings for an hour goes on
    for (int k = 0; end + k * step + window < last && k * step < given_up; ++k) {
      const double t = end + k * step;
      const auto [low, high] = heading_.range(t, t + window);
      if (high - low <= steady) return t + window;
    }
    return last;
  }

  // -------------------------------------------------------------- steady runs

  /// Means over blocks of time, so that waves and noise count little.
  struct Block {
    double time, heading, speed;
  };

  std::vector<Block> blocks() const {
    constexpr double length = 10.0;  // [s]: the roll and pitch of ships, shorter than their turning
    std::vector<Block> result;
    double k = 0.0;
    for (double t = run_.time.front(); t + length <= run_.time.back(); t = run_.time.front() + k * length) {
      result.push_back({t, heading_.mean(t, t + length), speed_.mean(t, t + length)});
      k = std::isnan(result.back().heading) ? block_of_next(t + length, length, k) : k + 1.0;
      if (!(run_.time.front() + k * length > t)) break;  // numbers so large that they tell no seconds
    }
    return result;
  }

  /// The block of the first heading from a time on: a gap of years is no longer than one of a minute.
  double block_of_next(double time, double length, double k) const {
    const auto next = heading_.from(time);
    if (next == heading_.size()) return std::numeric_limits<double>::infinity();
    return std::max(k + 1.0, std::floor((heading_.time[next] - run_.time.front()) / length));
  }

  /// Heading within 2 deg to either side, speed within 3 %, as long as it goes on; a block without samples ends it.
  void find_steady_runs() {
    const auto all = blocks();
    for (std::size_t begin = 0; begin < all.size();) {
      double low = 1e9, high = -1e9, slow = 1e9, fast = -1e9;
      std::size_t end = begin;
      for (; end < all.size(); ++end) {
        const auto& block = all[end];
        low = std::min(low, block.heading), high = std::max(high, block.heading);
        slow = std::fmin(slow, block.speed), fast = std::fmax(fast, block.speed);
        const bool straight = high - low <= 4.0, no_speed = fast < slow;
        const bool steady = straight && (no_speed || fast - slow <= 0.06 * fast);
        if (std::isnan(block.heading) || !steady || !is_free(block.time, block.time + 10.0)) break;
      }
      begin = add_steady_run(all, begin, end) ? end : begin + 1;
    }
  }

  bool add_steady_run(const std::vector<Block>& all, std::size_t begin, std::size_t end) {
    constexpr double shortest = 180.0;  // [s]: a mile at 20 kn, and the time in which logs are averaged at trials
    if (end == begin) return false;
    const double from = all[begin].time, to = all[end - 1].time + 10.0;
    if (to - from < shortest) return false;
    const double speed = speed_.mean(from, to);
    const auto course = std::fmod(heading_.mean(from, to), 360.0);
    auto why =
        fmt::format("heading {:.1f} deg within 2 deg for {:.0f} s", course < 0.0 ? course + 360.0 : course, to - from);
    if (!std::isnan(speed)) why += fmt::format(", {:.2f} m/s within 3 %", speed);
    found_.push_back({from, to, "steady run", std::nullopt, std::move(why)});
    return true;
  }

  // -------------------------------------------------------------- speed runs

  /// Steady runs on opposite headings with nothing but a turn between; of several on one heading the longest.
  void pair_speed_runs() {
    std::vector<ManoeuvrePiece*> legs;  // one for each heading
    const auto pair_legs = [&] {
      for (std::size_t k = 0; k + 1 < legs.size(); ++k)
        if (are_reciprocal(*legs[k], *legs[k + 1])) name_speed_runs(*legs[k], *legs[k + 1]), ++k;
      legs.clear();
    };
    for (auto& piece : found_) {
      if (piece.manoeuvre.starts_with("turn")) continue;
      if (piece.manoeuvre != "steady run") pair_legs();
      else if (legs.empty() || !are_alike(*legs.back(), piece)) legs.push_back(&piece);
      else if (length(piece) > length(*legs.back())) legs.back() = &piece;
    }
    pair_legs();
  }

  static void name_speed_runs(ManoeuvrePiece& first, ManoeuvrePiece& second) {
    first.manoeuvre = second.manoeuvre = "speed run";
    first.why += fmt::format("; on the opposite heading from {:.0f} s", second.begin);
    second.why += fmt::format("; on the opposite heading from {:.0f} s", first.begin);
  }

  static double length(const ManoeuvrePiece& piece) { return piece.end - piece.begin; }

  bool are_alike(const ManoeuvrePiece& a, const ManoeuvrePiece& b) const {
    const double between = heading_.mean(b.begin, b.end) - heading_.mean(a.begin, a.end);
    return std::abs(std::remainder(between, 360.0)) <= 5.0;
  }

  bool are_reciprocal(const ManoeuvrePiece& a, const ManoeuvrePiece& b) const {
    const double between = heading_.mean(b.begin, b.end) - heading_.mean(a.begin, a.end);
    const bool opposite = std::abs(std::remainder(between - 180.0, 360.0)) <= 5.0;
    const auto rev = track_of(run_, Channel::rev, 1.0);
    const double first = rev.mean(a.begin, a.end), second = rev.mean(b.begin, b.end);
    const bool same_rev = std::isnan(first + second) || std::abs(first - second) <= 0.03 * std::abs(first);
    const double ratio = length(a) / length(b);
    return opposite && same_rev && ratio > 1.0 / 3.0 && ratio < 3.0;
  }

  // Zigzags of model tests whose order was 5 deg are reversed at 6.0 and 6.3 deg.
  static constexpr double late_order = 1.5;  // [deg]
  // Share of the samples of a held rudder that are at its level: ramps of the steering gear take the rest.
  static constexpr double flat_enough = 0.55;
  // A rudder that swings as a sinusoid is on its way between the sides for 0.46 of the time or more.
  static constexpr double sinusoid = 0.4;

  const Recording& run_;
  Track rudder_, smooth_, heading_, speed_;
  std::vector<ManoeuvrePiece> found_;
  bool held_long_ = true;  ///< a rudder angle counts as held only if it is for longer than the rudder moves
};

}  // namespace

std::vector<ManoeuvrePiece> manoeuvres_in(const Recording& run) { return Search(run).pieces(); }

}  // namespace swayaw::core
