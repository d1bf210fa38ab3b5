// The tables of docs/papers/artyszuk2016.md, computed: one Markdown file for each.
//   artyszuk2016_tables tests/golden/artyszuk_linear.json FOLDER
#include <fmt/format.h>
#include <fmt/os.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "swayaw/core/angle.hpp"
#include "swayaw/linear/euler_zigzag.hpp"
#include "swayaw/linear/indices.hpp"
#include "swayaw/linear/loop.hpp"
#include "swayaw/linear/rudder_history.hpp"
#include "swayaw/linear/ship_parts.hpp"

namespace {

using namespace swayaw;
using Coefficients = SwayYawCoefficients<double>;
using Indices = SteeringIndices<double>;
using Parts = LinearParts<double>;

// ---------------------------------------------------------------- tables 1 to 3

struct Input {
  const char* symbol;
  const char* key;
  const char* printed;
};

constexpr Input table_1[] = {{"L/B", "LB", "5.867"},   {"c_B", "cB", "0.761"},
                             {"k_11", "k11", "0.056"}, {"k_22", "k22", "1.004"},
                             {"r'_z", "rz", "0.247"},  {"r'_66", "r66", "0.225"},
                             {"Y'_b", "Yb", "0.0043"}, {"Y'_w", "Yw", "0.0260"},
                             {"N'_b", "Nb", "0.0024"}, {"N'_w", "Nw", "-0.0630"},
                             {"A'_R", "AR", "0.0177"}, {"w", "w", "0.326"},
                             {"c_Th", "cTh", "2.127"}, {"lift slope per deg", "cLa", "0.0385"},
                             {"a_H", "aH", "0.6"},     {"c_Ry", "cRy", "1.0"},
                             {"x'_Reff", "xR", "-0.5"}};

Parts parts_of(const nlohmann::json& t) {
  return {.hull = {t.at("LB"), t.at("cB"), t.at("k11"), t.at("k22"), t.at("rz"), t.at("r66"), t.at("Yb"), t.at("Yw"),
                   t.at("Nb"), t.at("Nw")},
          .rudder = {t.at("AR"), t.at("w"), t.at("cTh"), t.at("cLa"), t.at("aH"), t.at("cRy"), t.at("xR")}};
}

/// A number of the paper: its name, as printed, and computed from table 1 as printed and unrounded.
struct Number {
  std::string name;
  std::string printed;
  double rounded, unrounded;

  int digits() const { return static_cast<int>(printed.size() - printed.find('.') - 1); }
  bool same(double value) const { return fmt::format("{:.{}f}", value, digits()) == printed; }
};

/// Tables 2 and 3 and the parameters of section 6 in the order of `printed_numbers`.
std::vector<double> numbers_from(const Parts& ship) {
  const auto split = coefficients(ship);
  const auto m = split.total();
  const auto i = steering_indices(m);
  const auto T = time_constants(transfer_functions(m)).value();
  auto twice = i, half = i;
  twice.T3b = 2.0 * i.T3b;
  half.T3w = 0.5 * i.T3w;
  const auto p = coefficients_from(twice), q = coefficients_from(half);
  const auto &h = split.hull, &r = split.rudder;
  return {h.a1,
          h.b1,
          h.a2,
          h.b2,
          r.a1,
          r.b1,
          r.a2,
          r.b2,
          split.centrifugal.b1,
          T.T1,
          T.T2,
          i.T3b,
          i.T3w,
          i.Kb,
          i.Kw,
          m.a1,
          m.b1,
          m.c1,
          m.a2,
          m.b2,
          m.c2,
          twice.T3b,
          p.a1,
          p.b1,
          p.c1,
          p.a2,
          p.b2,
          p.c2,
          half.T3w,
          q.a1,
          q.b1,
          q.c1,
          q.a2,
          q.b2,
          q.c2,
          std::abs(i.Kb) * 10.0,
          std::abs(i.Kw) * radians(10)};
}

constexpr std::array<std::pair<const char*, const char*>, 37> printed_numbers{
    {{"a1, hull", "-0.479"},   {"b1, hull", "-0.050"},   {"a2, hull", "4.843"},
     {"b2, hull", "-2.182"},   {"a1, rudder", "-0.144"}, {"b1, rudder", "-0.072"},
     {"a2, rudder", "-1.291"}, {"b2, rudder", "-0.646"}, {"b1, centrifugal", "0.527"},
     {"T1", "10.491"},         {"T2", "0.298"},          {"T3b", "0.154"},
     {"T3w", "0.983"},         {"Kb", "-3.464"},         {"Kw", "-4.896"},
     {"a1", "-0.622"},         {"b1", "0.405"},          {"c1", "-0.171"},
     {"a2", "3.552"},          {"b2", "-2.827"},         {"c2", "-1.539"},
     {"twice T3b", "0.309"},   {"a1 with it", "-0.046"}, {"b1", "-0.037"},
     {"c1", "-0.342"},         {"a2", "4.366"},          {"b2", "-3.403"},
     {"c2", "-1.539"},         {"half T3w", "0.492"},    {"a1 with it", "-1.458"},
     {"b1", "0.996"},          {"c1", "-0.171"},         {"a2", "2.594"},
     {"b2", "-1.992"},         {"c2", "-0.770"},         {"beta_0 [deg]", "34.6"},
     {"omega'_0", "0.854"}}};

std::vector<Number> parameters(const Parts& rounded, const Parts& unrounded) {
  const auto a = numbers_from(rounded), b = numbers_from(unrounded);
  std::vector<Number> all;
  for (std::size_t i = 0; i < a.size(); ++i)
    all.push_back({printed_numbers[i].first, printed_numbers[i].second, a[i], b[i]});
  return all;
}

/// How many are the printed ones to the last digit.
std::ptrdiff_t matches(const std::vector<Number>& all, double Number::*value) {
  return std::count_if(all.begin(), all.end(), [&](const Number& n) { return n.same(n.*value); });
}

std::string rows(const std::vector<Number>& all, std::size_t from, std::size_t to) {
  std::string text =
      "| | printed | from table 1 as printed | from the unrounded table 1 |\n| --- | ---: | ---: | ---: |\n";
  for (std::size_t i = from; i < to; ++i)
    text += fmt::format("| {} | {} | {:.{}f} | {:.{}f} |\n", all[i].name, all[i].printed, all[i].rounded,
                        all[i].digits(), all[i].unrounded, all[i].digits() + 1);
  return text;
}

std::string table_1_text(const nlohmann::json& unrounded) {
  std::string text = "| | printed | unrounded |\n| --- | ---: | ---: |\n";
  for (const auto& [symbol, key, printed] : table_1)
    text += fmt::format("| {} | {} | {:.6g} |\n", symbol, printed, unrounded.at(key).get<double>());
  return text;
}

// ---------------------------------------------------------------- zigzags

Indices printed_indices(double T3b = 0.154, double T3w = 0.983) {
  return {.T1T2 = 10.491 * 0.298, .T1_plus_T2 = 10.491 + 0.298, .T3b = T3b, .T3w = T3w, .Kb = -3.464, .Kw = -4.896};
}

Coefficients first_order_both() {
  const auto drift = first_order_drift(printed_indices()), yaw = first_order_yaw(printed_indices());
  return {-1.0 / drift.T, 0.0, drift.K / drift.T, 0.0, -1.0 / yaw.T, yaw.K / yaw.T};
}

struct Case {
  const char* name;
  Coefficients ship;
  double rate_deg_s;

  LinearZigzagOrder order(std::size_t reversals = 6) const {
    return {.rudder = radians(10), .heading = radians(10), .rate = radians(rate_deg_s) * 13.39, .reversals = reversals};
  }
};

/// What a figure shows of a zigzag, by either method.
struct Seen {
  std::array<double, 3> execute, overshoot_deg;
  double drift_rate_deg, yaw_rate_rate;  ///< largest derivatives before the first reversal
  double beta_max_deg, omega_max;        ///< until the peak of the sixth reversal
};

template <class Reversals>
Seen with_reversals(const Reversals& r) {
  Seen seen{};
  for (std::size_t i = 0; i < 3; ++i) {
    seen.execute[i] = r[i].execute;
    seen.overshoot_deg[i] = degrees(r[i].overshoot);
  }
  return seen;
}

void look(Seen& seen, const Coefficients& m, double s, const LinearState<double>& x, double delta) {
  const auto d = rates(m, x, delta);
  seen.beta_max_deg = std::max(seen.beta_max_deg, degrees(std::abs(x.beta)));
  seen.omega_max = std::max(seen.omega_max, std::abs(x.omega));
  if (s > seen.execute[0]) return;
  seen.drift_rate_deg = std::max(seen.drift_rate_deg, degrees(std::abs(d.beta)));
  seen.yaw_rate_rate = std::max(seen.yaw_rate_rate, std::abs(d.omega));
}

Seen exactly(const Case& c) {
  const auto z = linear_zigzag(c.ship, c.order());
  const LinearResponse<double> ship(c.ship);
  Seen seen = with_reversals(z.reversals);
  for (const auto& leg : z.legs)
    for (int i = 0; i <= 1000; ++i) {
      const double s = leg.length * i / 1000.0;
      look(seen, c.ship, leg.from + s, state_after(ship, leg.start, leg.rudder, s),
           leg.rudder.value + leg.rudder.rate * s);
    }
  return seen;
}

Seen by_euler(const Case& c) {
  const auto z = euler_zigzag(c.ship, c.order());
  Seen seen = with_reversals(z.reversals);
  for (const auto& step : z.steps) look(seen, c.ship, step.s, step.state, step.delta);
  return seen;
}

std::string zigzag_rows(const std::vector<Case>& cases) {
  std::string text =
      "| | | s' at reversal 1, 2, 3 | overshoot 1, 2, 3 [deg] | largest d(beta)/ds' [deg], d(omega')/ds' before "
      "reversal 1 | largest beta [deg], omega' |\n"
      "| --- | --- | --- | --- | --- | --- |\n";
  for (const auto& c : cases)
    for (const auto& [method, s] : {std::pair{"exact", exactly(c)}, {"Euler", by_euler(c)}})
      text += fmt::format(
          "| {} | {} | {:.3f}, {:.3f}, {:.3f} | {:.2f}, {:.2f}, {:.2f} | {:.3f}, {:.4f} | {:.2f}, {:.4f} |\n", c.name,
          method, s.execute[0], s.execute[1], s.execute[2], s.overshoot_deg[0], s.overshoot_deg[1], s.overshoot_deg[2],
          s.drift_rate_deg, s.yaw_rate_rate, s.beta_max_deg, s.omega_max);
  return text;
}

LoopMeasures<double> loop_of(const Case& c) {
  return drift_yaw_loop(c.ship, limit_cycle(c.ship, c.order()).zigzag).value();
}

std::string loop_rows(const std::vector<Case>& cases) {
  std::string text =
      "| limit cycle, exact | period | area [rad] | largest beta [deg] | largest omega' | omega' at beta = 0 | beta at "
      "omega' = 0 [deg] |\n| --- | ---: | ---: | ---: | ---: | ---: | ---: |\n";
  for (const auto& c : cases) {
    const auto cycle = limit_cycle(c.ship, c.order());
    const auto l = drift_yaw_loop(c.ship, cycle.zigzag).value();
    text += fmt::format("| {} | {:.3f} L, {:.1f} s | {:.5f} | {:.2f} | {:.4f} | {:.4f} | {:.2f} |\n", c.name,
                        *cycle.zigzag.period(), *cycle.zigzag.period() * 13.39, l.area, degrees(l.beta_max),
                        l.omega_max, l.omega_at_beta_zero, degrees(l.beta_at_omega_zero));
  }
  return text;
}

// ---------------------------------------------------------------- T3b and T3w, section 7

std::string straightening_rows(Parts ship) {
  std::string text = "| c_Ry | T1 | T2 | T3b | T3w |\n| ---: | ---: | ---: | ---: | ---: |\n";
  for (const double c_Ry : {0.5, 1.0, 2.0, 5.0}) {
    ship.rudder.c_Ry = c_Ry;
    const auto h = transfer_functions(coefficients(ship).total());
    const auto T = time_constants(h).value();
    const auto i = steering_indices(h);
    text += fmt::format("| {:.1f} | {:.2f} | {:.3f} | {:.6f} | {:.6f} |\n", c_Ry, T.T1, T.T2, i.T3b, i.T3w);
  }
  return text;
}

struct Known {
  const char* name;
  KnownPart part;
  double& (*number)(Parts&);
};

const Known knowns[] = {{"Y'_b", KnownPart::Y_b, [](Parts& p) -> double& { return p.hull.Y_b; }},
                        {"Y'_w", KnownPart::Y_w, [](Parts& p) -> double& { return p.hull.Y_w; }},
                        {"N'_b", KnownPart::N_b, [](Parts& p) -> double& { return p.hull.N_b; }},
                        {"N'_w", KnownPart::N_w, [](Parts& p) -> double& { return p.hull.N_w; }},
                        {"c_Ry", KnownPart::c_Ry, [](Parts& p) -> double& { return p.rudder.c_Ry; }}};

/// Per cent by which `b` changes when `a` is fixed one per cent too high.
double error_percent(const Parts& ship, const Known& a, const Known& b) {
  auto wrong = ship;
  a.number(wrong) *= 1.01;
  auto found = parts_from(coefficients(ship).total(), wrong, a.part);
  return 100.0 * (b.number(found) / b.number(wrong) * (&a == &b ? 1.01 : 1.0) - 1.0);
}

std::string error_rows(const Parts& ship) {
  std::string text = "| fixed 1 % too high |";
  for (const auto& b : knowns) text += fmt::format(" {} |", b.name);
  text += "\n| --- | ---: | ---: | ---: | ---: | ---: |\n";
  for (const auto& a : knowns) {
    text += fmt::format("| {} |", a.name);
    for (const auto& b : knowns) text += fmt::format(" {:+.1f} % |", error_percent(ship, a, b));
    text += "\n";
  }
  return text;
}

// ---------------------------------------------------------------- verdicts

struct Verdict {
  const char* section;
  const char* claim;
  const char* verdict;
  std::string found;
};

double deviation_from_43(double rate_deg_s) {
  const auto i = printed_indices();
  const LinearResponse<double> ship(first_order_both());
  const double beta0 = i.Kb * -radians(10), omega0 = i.Kw * -radians(10),
               power = first_order_drift(i).T / first_order_yaw(i).T;
  const auto all = legs(ship, rudder_ramp_and_hold(-radians(10), radians(rate_deg_s) * 13.39), 100.0);
  double most = 0.0;
  for (double s = 0.0; s < 100.0; s += 0.01) {
    const auto x = state_at(ship, all, s);
    most = std::max(most, std::abs(x.omega / omega0 - 1.0 + std::pow(1.0 - x.beta / beta0, power)));
  }
  return most;
}

/// T3w above which the largest omega' of the limit cycle exceeds that of the reference case again.
double T3w_with_the_same_largest_omega(double wanted) {
  double low = 1.966, high = 5.0;
  while (high - low > 1e-4) {
    const double T3w = 0.5 * (low + high);
    (loop_of({"", coefficients_from(printed_indices(0.154, T3w)), 2.5}).omega_max < wanted ? low : high) = T3w;
  }
  return low;
}

std::vector<Verdict> verdicts(const Parts& rounded, const Parts& unrounded) {
  const auto ref_ship = coefficients_from(printed_indices());
  const Case ref{"REF", ref_ship, 2.5}, slow{"", ref_ship, 0.5}, first{"", first_order_both(), 2.5},
      slow_first{"", first_order_both(), 0.5};
  const Case T3b{"", coefficients_from(printed_indices(0.309)), 2.5},
      T3w{"", coefficients_from(printed_indices(0.154, 0.492)), 2.5};
  const Case wide{"", coefficients_from(printed_indices(0.154, 1.966)), 2.5},
      near{"", coefficients_from(printed_indices(0.983 * 1.0001)), 2.5};
  const auto low_indices = printed_indices(0.0005, 0.001);
  const Case low{"", coefficients_from(low_indices), 2.5},
      low_first{"", first_order_ship(low_indices.Kw, first_order_yaw(low_indices).T), 2.5};
  const auto seen = exactly(ref), seen_first = exactly(first), seen_slow = exactly(slow),
             seen_slow_first = exactly(slow_first), euler = by_euler(ref);
  const auto loop = loop_of(ref), loop_T3b = loop_of(T3b), loop_T3w = loop_of(T3w), loop_wide = loop_of(wide);
  const auto all = parameters(rounded, unrounded);
  const auto matching = matches(all, &Number::unrounded), matching_rounded = matches(all, &Number::rounded);
  const auto split = coefficients(unrounded);
  const auto m = split.total();
  const auto f = factors(rounded);
  const auto percent = [](double part, double whole) { return 100.0 * std::abs(part / whole); };
  const auto above = [](double a, double b) { return 100.0 * (a / b - 1.0); };
  const auto a = linear_zigzag(ref.ship, ref.order()), b = linear_zigzag(T3w.ship, T3w.order());
  const double apart = degrees(std::abs(state_at(LinearResponse<double>(T3w.ship), b.legs, 6.0).beta -
                                        state_at(LinearResponse<double>(ref.ship), a.legs, 6.0).beta));
  return {
      {"3", "r'_z and r'_66 are J/(mL²)", "wrong",
       fmt::format("they are square roots of it; as written a2 of the hull would be {:.2f} instead of 4.84",
                   f.h / (rounded.hull.r_z + rounded.hull.r_66) * rounded.hull.N_b * (180.0 / pi))},
      {"3", "(13), last form", "wrong",
       fmt::format("x'_Reff must be squared: {:+.3f} as printed, {:+.3f} with the square, table 2 says -0.646",
                   f.sway / f.yaw * coefficients(rounded).rudder.a1 * rounded.rudder.x_Reff,
                   coefficients(rounded).rudder.b2)},
      {"4", "T1 > T2 for a stable ship", "half right",
       "for real poles; a stable ship may have a complex pair, which has no T1 and T2 but has their sum and product"},
      {"4", "with the usual signs a1 < 0 and b2 < 0, so the determinant alone decides on stability", "true",
       "as long as the signs are those of section 3"},
      {"5", "the six indices give back the six coefficients, (29)–(34)", "true",
       "to rounding; no ship exists for T3b = T3w unless T3 is T1 or T2"},
      {"5", "a1 and b2 rest on the time constants alone", "true", "no gain enters (29) and (32)"},
      {"5", "the text of step 2 refers to (27) and (28)", "wrong", "(33) and (34) are meant"},
      {"6", "tables 2 and 3 follow from table 1", "true",
       fmt::format("{} of 37 numbers to the last digit from an unrounded table 1 within half a digit of the printed "
                   "one; {} of 37 from the printed one",
                   matching, matching_rounded)},
      {"6", "the rudder contributes up to 30 %", "half right",
       fmt::format("{:.0f} % of a1, {:.0f} % of b1, {:.0f} % of b2, but {:.0f} % of a2", percent(split.rudder.a1, m.a1),
                   percent(split.rudder.b1, m.b1), percent(split.rudder.b2, m.b2), percent(split.rudder.a2, m.a2))},
      {"6", "only in a2 does the rudder oppose the hull", "true", "a1, b1 and b2 of both have the same sign"},
      {"6", "huge sensitivity to T3b and T3w", "half right",
       "large changes, but T3b was doubled and T3w halved. One per cent of either is 0.8 to 1.2 % of a1 and b1 and "
       "0.15 to 0.24 % of a2 and b2"},
      {"6", "T3b and T3w even turn signs", "true",
       fmt::format("b1 is {:.3f}, with T3b doubled {:.3f}", coefficients_from(printed_indices()).b1, T3b.ship.b1)},
      {"6", "Euler's method with ds' = 0.05 is still powerful", "wrong",
       fmt::format(
           "overshoots {:.2f}, {:.2f}, {:.2f} deg are {:.0f}, {:.0f}, {:.0f} % above the exact {:.2f}, {:.2f}, {:.2f}",
           euler.overshoot_deg[0], euler.overshoot_deg[1], euler.overshoot_deg[2],
           above(euler.overshoot_deg[0], seen.overshoot_deg[0]), above(euler.overshoot_deg[1], seen.overshoot_deg[1]),
           above(euler.overshoot_deg[2], seen.overshoot_deg[2]), seen.overshoot_deg[0], seen.overshoot_deg[1],
           seen.overshoot_deg[2])},
      {"6", "beta_0 = 34.6 deg, omega'_0 = 0.854", "true",
       fmt::format(
           "{:.2f} deg, {:.5f} from the printed gains; the sign is dropped, a rudder to port gives both negative",
           34.64, 4.896 * radians(10))},
      {"6", "the zigzag stays much below the steady turn", "true",
       fmt::format("drift up to {:.1f} deg, omega' up to {:.2f}", degrees(loop.beta_max), loop.omega_max)},
      {"6", "T_b is close to T_w", "true",
       fmt::format("T_b/T_w = {:.4f}", first_order_drift(printed_indices()).T / first_order_yaw(printed_indices()).T)},
      {"6", "(43) does not depend on the rudder rate", "true",
       fmt::format("exact for a step; {:.0e} of omega'_0 off at 2.5 deg/s, {:.0e} at 0.5 deg/s", deviation_from_43(2.5),
                   deviation_from_43(0.5))},
      {"6", "d(omega')/ds' has a peak that first order lacks", "true",
       fmt::format("{:.3f} against {:.3f}", seen.yaw_rate_rate, seen_first.yaw_rate_rate)},
      {"6", "first order gives quite different overshoots", "true",
       fmt::format("first overshoot {:.1f} against {:.1f} deg", seen_first.overshoot_deg[0], seen.overshoot_deg[0])},
      {"6", "at 0.5 deg/s second order converges efficiently to first", "half right",
       fmt::format("overshoots {:.1f} and {:.1f} deg, still {:.0f} % apart; {:.0f} % at 2.5 deg/s",
                   seen_slow_first.overshoot_deg[0], seen_slow.overshoot_deg[0],
                   above(seen_slow_first.overshoot_deg[0], seen_slow.overshoot_deg[0]),
                   above(seen_first.overshoot_deg[0], seen.overshoot_deg[0]))},
      {"6", "at 0.5 deg/s the yaw acceleration still jumps and leaves a loop", "true",
       fmt::format("{:.3f} against {:.3f}; area of the loop {:.4f} rad", seen_slow.yaw_rate_rate,
                   seen_slow_first.yaw_rate_rate, loop_of(slow).area)},
      {"6", "very low T3b and T3w: convergence to first order", "wrong",
       fmt::format("T2 remains: first overshoot {:.1f} deg, of first order {:.1f}. The yaw is of first order, exactly, "
                   "when T3w = T2 = 0.298, the drift when T3b = T2",
                   exactly(low).overshoot_deg[0], exactly(low_first).overshoot_deg[0])},
      {"6", "T3b close to T3w: convergence to first order", "wrong",
       fmt::format("the loop collapses to a line, but each motion stays of second order: first overshoot {:.1f} deg as "
                   "before, not {:.1f}",
                   exactly(near).overshoot_deg[0], seen_first.overshoot_deg[0])},
      {"6", "T3b close to T3w gives enormous coefficients", "true", "they grow as 1/(T3b - T3w)"},
      {"6", "T3b does not affect the yaw", "true", "to rounding"},
      {"6", "T3w leaves the drift alone until the first counter-rudder", "true",
       fmt::format("to rounding; thereafter {:.1f} deg apart at s' = 6", apart)},
      {"6", "T3b stretches the loop along the drift axis", "true",
       fmt::format("doubled: beta at omega' = 0 {:.2f} deg instead of {:.2f}, largest omega' unchanged",
                   degrees(loop_T3b.beta_at_omega_zero), degrees(loop.beta_at_omega_zero))},
      {"6", "the impact of T3w is much higher", "true",
       fmt::format("T3w halved takes {:.0f} % of the area, T3b doubled {:.0f} %",
                   100.0 - percent(loop_T3w.area, loop.area), 100.0 - percent(loop_T3b.area, loop.area))},
      {"6", "a larger T3w contracts the loop in beta and expands it in omega'", "half right",
       fmt::format("doubled: largest beta {:.2f} instead of {:.2f} deg, omega' at beta = 0 {:.3f} instead of {:.3f}; "
                   "but the largest omega' falls by {:.0f} % and exceeds its reference only above T3w = {:.2f}",
                   degrees(loop_wide.beta_max), degrees(loop.beta_max), loop_wide.omega_at_beta_zero,
                   loop.omega_at_beta_zero, 100.0 - percent(loop_wide.omega_max, loop.omega_max),
                   T3w_with_the_same_largest_omega(loop.omega_max))},
      {"7", "any of the seven empirical parameters may be fixed", "wrong",
       "five of them: c1 alone gives a_H, and c2/c1 gives x'_Reff"},
      {"7", "better fix Y'_b or N'_b", "half right",
       fmt::format("they are best known, but 1 % in Y'_b is {:+.1f} % in c_Ry and {:+.1f} % in Y'_w, 1 % in N'_b "
                   "{:+.1f} and {:+.1f} %; 1 % in c_Ry is at most {:.1f} % anywhere",
                   error_percent(rounded, knowns[0], knowns[4]), error_percent(rounded, knowns[0], knowns[1]),
                   error_percent(rounded, knowns[2], knowns[4]), error_percent(rounded, knowns[2], knowns[1]),
                   std::max({std::abs(error_percent(rounded, knowns[4], knowns[0])),
                             std::abs(error_percent(rounded, knowns[4], knowns[1])),
                             std::abs(error_percent(rounded, knowns[4], knowns[2])),
                             std::abs(error_percent(rounded, knowns[4], knowns[3]))}))},
  };
}

std::string verdict_rows(const std::vector<Verdict>& all) {
  std::string text = "| section | claim | verdict | found |\n| --- | --- | --- | --- |\n";
  for (const auto& v : all) text += fmt::format("| {} | {} | **{}** | {} |\n", v.section, v.claim, v.verdict, v.found);
  return text;
}

}  // namespace

int main(int, char** arguments) {
  const auto reference = nlohmann::json::parse(std::ifstream(arguments[1])).at("artyszuk");
  const std::string folder = arguments[2];
  const auto& unrounded_table = reference.at("unrounded_table1_that_prints_all_digits").at("table1");
  const auto rounded = parts_of(reference.at("table1_input")), unrounded = parts_of(unrounded_table);
  const auto all = parameters(rounded, unrounded);
  const auto REF = coefficients_from(printed_indices());
  const std::vector<Case> cases{{"REF", REF, 2.5},
                                {"T3b = 0.309", coefficients_from(printed_indices(0.309)), 2.5},
                                {"T3w = 0.492", coefficients_from(printed_indices(0.154, 0.492)), 2.5},
                                {"T3w = 1.966", coefficients_from(printed_indices(0.154, 1.966)), 2.5},
                                {"REF, 0.5 deg/s", REF, 0.5}};
  auto with_first_order = cases;
  with_first_order.push_back({"1st ORD", first_order_both(), 2.5});
  with_first_order.push_back({"1st ORD, 0.5 deg/s", first_order_both(), 0.5});
  const auto write = [&](const char* name, const std::string& text) {
    fmt::output_file(fmt::format("{}/{}.md", folder, name)).print("{}", text);
  };
  write("verdicts", verdict_rows(verdicts(rounded, unrounded)));
  write("table_1", table_1_text(unrounded_table));
  write("table_2", rows(all, 0, 9));
  write("table_3", rows(all, 9, 35));
  write("zigzags", zigzag_rows(with_first_order));
  write("loops", loop_rows(cases));
  write("straightening", straightening_rows(rounded));
  write("errors", error_rows(rounded));
  fmt::print("{} of 37 printed numbers from the unrounded table 1, {} from the printed one\n",
             matches(all, &Number::unrounded), matches(all, &Number::rounded));
  return matches(all, &Number::unrounded) == 37 ? 0 : 1;
}
