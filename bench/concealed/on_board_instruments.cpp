#include "on_board_instruments.hpp"

#include <algorithm>
#include <cmath>

#include "swayaw/core/angle.hpp"

namespace swayaw::concealed {
namespace {

/// To the nearest step.
double in_steps(double value, double step) { return step > 0.0 ? step * std::round(value / step) : value; }

/// White errors of what shows the motion besides the fixes: those of good instruments.
double scatter_of(Channel channel, const TrueShip& s) {
  switch (channel) {
    case Channel::psi:
    case Channel::delta: return radians(0.02);
    case Channel::r: return 0.002 * s.U_0 / s.L;
    case Channel::u:
    case Channel::v:
    case Channel::u_ground:
    case Channel::v_ground:
    case Channel::speed_through_water:
    case Channel::speed_over_ground: return 0.02;
    case Channel::phi: return radians(0.02);
    default: return 0.0;
  }
}

/// One run in the making.
struct Desk {
  const TrueShip& ship;
  const Concealment& hidden;
  const OnBoardInstruments& board;
  const TrueTrack& track;
  RandomSource& random;
  Recording& run;

  double late(Channel channel) const {
    const bool is = channel == hidden.late || (channel == Channel::y && hidden.late == Channel::x);
    return is ? hidden.delay : 0.0;
  }

  double scatter(Channel channel) { return board.scatter * scatter_of(channel, ship) * random.normal(); }

  std::vector<double> smooth(Channel channel) const {
    return smoothed(shown(channel, track, hidden), track.step, board.smoothing, board.smoothing_width);
  }
};

/// Fixes once a second, from two seconds before the run on; between them straight lines.
void record_position(Desk& d, bool wild_fix) {
  const double end = d.run.time.back();
  const auto fixes = static_cast<std::size_t>(end) + 5;
  const std::size_t wild = fixes / 4 + d.random.below(fixes / 2);
  for (const auto channel : {Channel::x, Channel::y}) {
    const auto truth = shown(channel, d.track, d.hidden);
    const auto error = fix_errors(d.board.fix, fixes, d.random);
    std::vector<double> fix(fixes);
    const auto time_of = [&](std::size_t i) { return static_cast<double>(i) - 2.0 + d.board.fix_phase; };
    for (std::size_t i = 0; i < fixes; ++i)
      fix[i] = value_at(d.track, truth, time_of(i) - d.late(channel) - d.board.clock) + error[i];
    if (wild_fix) fix[wild] += d.random.sign() * d.random.uniform(0.1, 0.25) * d.ship.L;
    const auto values = d.run.fill(channel);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double place = d.run.time[i] - time_of(0), before = std::floor(place), share = place - before;
      const auto k = static_cast<std::size_t>(before);
      values[i] = seven_digits((1.0 - share) * fix[k] + share * fix[k + 1]);
    }
  }
}

/// Compass readings at the sampling rate, `margin` of them before and after the run.
std::vector<double> compass(Desk& d, std::ptrdiff_t margin) {
  const auto truth = shown(Channel::psi, d.track, d.hidden);
  std::vector<double> readings;
  for (std::ptrdiff_t i = -margin; i < std::ssize(d.run.time) + margin; ++i)
    readings.push_back(in_steps(value_at(d.track, truth, static_cast<double>(i) / d.board.rate - d.late(Channel::psi)) +
                                    d.board.compass_zero + d.scatter(Channel::psi),
                                d.board.compass_step));
  return readings;
}

/// r = Σ k g_k (ψ_{+k} − ψ_{−k})/(2Δ Σ k² g_k), g the Gaussian: exact for a steady turn.
double slope(std::span<const double> readings, std::size_t middle, std::ptrdiff_t reach, double width, double rate) {
  double sum = 0.0, weight = 0.0;
  for (std::ptrdiff_t k = 1; k <= reach; ++k) {
    const double t = static_cast<double>(k) / rate, g = std::exp(-0.5 * t * t / (width * width));
    const auto at = [&](std::ptrdiff_t i) {
      return readings[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(middle) + i)];
    };
    sum += static_cast<double>(k) * g * (at(k) - at(-k)), weight += static_cast<double>(k * k) * g;
  }
  return 0.5 * rate * sum / weight;
}

/// Heading from the compass, yaw rate from the gyro or from that heading.
void record_turning(Desk& d) {
  const auto reach = static_cast<std::ptrdiff_t>(std::max(1.0, std::round(3.0 * d.board.slope_width * d.board.rate)));
  const auto readings = compass(d, reach);
  const auto psi = d.run.fill(Channel::psi), r = d.run.fill(Channel::r);
  const auto truth = d.smooth(Channel::r);
  for (std::size_t i = 0; i < psi.size(); ++i) {
    const std::size_t here = i + static_cast<std::size_t>(reach);
    psi[i] = seven_digits(readings[here]);
    const double gyro = d.board.gyro_scale * value_at(d.track, truth, d.run.time[i] - d.late(Channel::r)) +
                        d.board.gyro_zero + d.scatter(Channel::r);
    r[i] = seven_digits(d.board.gyro ? gyro : slope(readings, here, reach, d.board.slope_width, d.board.rate));
  }
}

void record_smoothed(Desk& d, Channel channel, double scale = 1.0) {
  const auto truth = d.smooth(channel);
  const auto values = d.run.fill(channel);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = seven_digits(scale * value_at(d.track, truth, d.run.time[i] - d.late(channel)) + d.scatter(channel));
}

void record_speed(Desk& d) {
  const bool water = d.board.sway == SwayRecord::through_water;
  if (water) record_smoothed(d, Channel::u, d.board.log_scale), record_smoothed(d, Channel::v);
  if (d.board.sway == SwayRecord::over_ground)
    record_smoothed(d, Channel::u_ground), record_smoothed(d, Channel::v_ground);
  if (water) return;
  if (d.board.log) record_smoothed(d, Channel::speed_through_water, d.board.log_scale);
  else record_smoothed(d, Channel::speed_over_ground);
}

void record_rudder(Desk& d) {
  const auto truth = shown(Channel::delta, d.track, d.hidden);
  const auto values = d.run.fill(Channel::delta);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = seven_digits(in_steps(value_at(d.track, truth, d.run.time[i] - d.late(Channel::delta)) +
                                          d.board.rudder_zero + d.scatter(Channel::delta),
                                      d.board.rudder_step));
}

/// One or two losses of the receiver, 3 to 15 s long, not while the run begins.
void lose_fixes(Desk& d) {
  const auto losses = 1 + d.random.below(2);
  for (std::size_t loss = 0; loss < losses; ++loss) {
    const double from = d.random.uniform(0.2, 0.9) * d.run.time.back(), to = from + d.random.uniform(3.0, 15.0);
    for (const auto channel :
         {Channel::x, Channel::y, Channel::u_ground, Channel::v_ground, Channel::speed_over_ground})
      if (d.run.has(channel))
        for (std::size_t i = 0; i < d.run.samples(); ++i)
          if (d.run.time[i] >= from && d.run.time[i] < to) d.run.fill(channel)[i] = missing;
  }
}

}  // namespace

OnBoardInstruments instruments_by_chance(RandomSource& random, const TrueShip& s, const Concealment& hidden) {
  const double yaw_rate = s.U_0 / s.L;
  OnBoardInstruments i{
      .rate = random.below(4) == 0 ? 2.0 : 1.0,
      .fix = {.slow = random.uniform(0.3, 1.0),
              .memory = random.uniform(30.0, 90.0),
              .white = random.uniform(0.03, 0.1)},
      .fix_phase = random.uniform(0.0, 1.0),
      .clock = random.sign() * random.uniform(0.2, 1.0),
      .compass_zero = random.sign() * radians(random.uniform(0.0, 0.25)),
      .compass_step = radians(0.1),
      .rudder_zero = random.sign() * radians(random.uniform(0.0, 0.25)),
      .rudder_step = radians(0.1),
      .gyro = random.below(3) > 0,
      .gyro_scale = 1.0 + random.sign() * random.uniform(0.005, 0.015),
      .gyro_zero = random.sign() * random.uniform(0.0005, 0.0018) * yaw_rate,
      .slope_width = random.uniform(1.0, 2.0),
      .log_scale = 1.0 + random.sign() * random.uniform(0.01, 0.02),
      .log = random.below(2) == 0,
      .sway = std::array{SwayRecord::none, SwayRecord::over_ground, SwayRecord::through_water}[random.below(3)],
      .smoothing = std::array{Smoothing::none, Smoothing::symmetric, Smoothing::causal}[random.below(3)],
      .smoothing_width = random.uniform(0.5, 2.0),
      .shaft = random.below(3) > 0,
      .heel = (s.GM > 0.0 || hidden.GM > 0.0) && random.below(2) == 0};
  if (random.below(4) > 0) i.clock = 0.0;
  const bool late = hidden.delay != 0.0;
  if (late && hidden.late == Channel::x) i.clock = 0.0;
  if (late && hidden.late == Channel::r && i.smoothing == Smoothing::causal) i.smoothing = Smoothing::symmetric;
  if ((late && (hidden.late == Channel::r || hidden.late == Channel::psi)) || hidden.gyro_bias != 0.0) i.gyro = true;
  if (hidden.gyro_bias != 0.0) i.gyro_zero = 0.0;
  if (hidden.heading_bias != 0.0) i.compass_zero = 0.0;
  if (hidden.rudder_offset != 0.0) i.rudder_zero = 0.0;
  if (hidden.log_scale != 0.0) i.log_scale = 1.0, i.log = true;
  return i;
}

OnBoardInstruments faultless(OnBoardInstruments i) {
  return {.rate = i.rate,
          .fix = {.slow = 0.0, .memory = 1.0, .white = 0.0},
          .slope_width = i.slope_width,
          .log = i.log,
          .sway = i.sway,
          .shaft = i.shaft,
          .heel = i.heel,
          .gaps = false,
          .scatter = 0.0};
}

std::vector<double> fix_errors(const FixErrors& e, std::size_t fixes, RandomSource& random) {
  Wandering slow(e.memory, random);
  std::vector<double> errors(fixes);
  for (auto& error : errors) error = e.slow * slow.next() + e.white * random.normal();
  return errors;
}

std::vector<double> smoothed(std::vector<double> values, double step, Smoothing kind, double width) {
  if (kind == Smoothing::none) return values;
  if (kind == Smoothing::causal) {  // dy/dt = (x − y)/τ
    const double stays = std::exp(-step / width);
    for (std::size_t i = 1; i < values.size(); ++i) values[i] = stays * values[i - 1] + (1.0 - stays) * values[i];
    return values;
  }
  const auto reach = static_cast<std::ptrdiff_t>(std::ceil(3.0 * width / step));
  std::vector<double> result(values.size());
  for (std::ptrdiff_t i = 0; i < std::ssize(values); ++i) {
    const std::ptrdiff_t here = std::min({reach, i, std::ssize(values) - 1 - i});  // alike on both sides
    double sum = 0.0, weight = 0.0;
    for (std::ptrdiff_t k = -here; k <= here; ++k) {
      const double t = static_cast<double>(k) * step / width, g = std::exp(-0.5 * t * t);
      sum += g * values[static_cast<std::size_t>(i + k)], weight += g;
    }
    result[static_cast<std::size_t>(i)] = sum / weight;
  }
  return result;
}

Recording recorded_on_board(const TrueShip& s, const Concealment& h, const Manoeuvre& m,
                            const OnBoardInstruments& board, const TrueTrack& track, RandomSource& random,
                            bool wild_fix) {
  Recording run{.name = m.name, .facts = {}, .time = {}, .channels = {}, .extra = {}};
  run.facts.manoeuvre = m.name;
  run.facts.execute = seven_digits(s.time_unit());
  for (int i = 0; i / board.rate <= m.lengths * s.time_unit(); ++i) run.time.push_back(i / board.rate);
  Desk desk{s, h, board, track, random, run};
  record_position(desk, wild_fix);
  record_turning(desk);
  record_speed(desk);
  record_rudder(desk);
  if (board.shaft) record_smoothed(desk, Channel::rev);
  if (board.heel) record_smoothed(desk, Channel::phi);
  if (board.gaps) lose_fixes(desk);
  return run;
}

}  // namespace swayaw::concealed
