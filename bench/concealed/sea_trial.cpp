#include "sea_trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "random_source.hpp"
#include "swayaw/core/angle.hpp"

namespace swayaw::concealed {
namespace {

constexpr double settling = 12.0;  ///< [L/U] before the record begins

// ---------------------------------------------------------------- helm

/// Who stands at the wheel: rudder orders, positive to port.
class Helm {
 public:
  Helm(const Manoeuvre& m, double time_unit) : m_(m), T_(time_unit), side_(m.rudder >= 0.0 ? 1.0 : -1.0) {}

  double order(double time, const States& q) {
    if (time < 0.9999 * T_) return steered(q, m_.approach);  // whatever the rounding of the steps
    if (m_.kind == Manoeuvre::Kind::passage) return steered(q, course(time));
    // a rudder to port turns the heading down
    const double turned = -side_ * (q[State::psi] - m_.approach);
    if (m_.kind == Manoeuvre::Kind::zigzag && turned >= m_.heading) side_ = -side_;
    return side_ * std::abs(m_.rudder);
  }

 private:
  double steered(const States& q, double course) const {
    return std::clamp(1.0 * (q[State::psi] - course) + 2.0 * T_ * q[State::r], -0.17, 0.17);
  }

  /// Eight lengths to each course: away, farther, back over the first one.
  double course(double time) const {
    constexpr std::array legs{1.0, 2.0, 0.5, -1.0, 0.0};
    return m_.approach + m_.heading * legs[std::min(legs.size() - 1, static_cast<std::size_t>(time / (6.0 * T_)))];
  }

  const Manoeuvre& m_;
  double T_, side_;
};

/// From the order to the indicator, which is recorded, and on to the rudder: play, lag, offset.
class Gear {
 public:
  Gear(double rate, const Concealment& hidden) : rate_(rate), hidden_(hidden) {}

  void move(double order, double h) {
    shown_ += std::clamp(order - shown_, -rate_ * h, rate_ * h);
    const double half = 0.5 * hidden_.rudder_play;
    played_ = std::clamp(played_, shown_ - half, shown_ + half);
    true_ = hidden_.rudder_lag > 0.0 ? played_ + (true_ - played_) * std::exp(-h / hidden_.rudder_lag) : played_;
  }

  double shown() const { return shown_; }
  double rudder() const { return true_ + hidden_.rudder_offset; }

 private:
  double rate_;
  const Concealment& hidden_;
  double shown_ = 0.0, played_ = 0.0, true_ = 0.0;
};

// ---------------------------------------------------------------- water

States plus(const States& a, double h, const States& b) {
  States sum;
  for (std::size_t i = 0; i < state_count; ++i) sum[i] = a[i] + h * b[i];
  return sum;
}

/// One step of the classical method; the rudder is that of the beginning, the middle and the end.
States stepped(const TrueShip& ship, const Concealment& hidden, const States& q, Moment now,
               const std::array<double, 3>& delta, double h) {
  const auto rate = [&](const States& s, double part, double rudder) {
    Moment moment = now;
    moment.time += part * h;
    moment.delta = rudder;
    return rates(ship, hidden, s, moment);
  };
  const auto a = rate(q, 0.0, delta[0]), b = rate(plus(q, 0.5 * h, a), 0.5, delta[1]);
  const auto c = rate(plus(q, 0.5 * h, b), 0.5, delta[1]), d = rate(plus(q, h, c), 1.0, delta[2]);
  States sum = q;
  for (std::size_t i = 0; i < state_count; ++i) sum[i] += h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]);
  return sum;
}

// ---------------------------------------------------------------- instruments

double deviation(Channel channel, const TrueShip& s) {
  switch (channel) {
    case Channel::x:
    case Channel::y: return 0.0007 * s.L;
    case Channel::psi: return radians(0.06);
    case Channel::r: return 0.005 * s.U_0 / s.L;
    case Channel::speed_through_water: return 0.01 * s.U_0;
    case Channel::delta: return radians(0.03);
    default: return 0.0;
  }
}

Recording recorded(const TrueShip& s, const Concealment& h, const Manoeuvre& m, const TrialOptions& o,
                   const TrueTrack& track, RandomSource& random) {
  Recording run{.name = m.name, .facts = {}, .time = {}, .channels = {}, .extra = {}};
  run.facts.manoeuvre = m.name;
  run.facts.execute = seven_digits(s.time_unit());
  const double dt = seven_digits(o.sample * s.time_unit());
  for (int i = 0; i * o.sample <= m.lengths; ++i) run.time.push_back(seven_digits(i * dt));
  for (const auto channel :
       {Channel::x, Channel::y, Channel::psi, Channel::r, Channel::speed_through_water, Channel::delta, Channel::rev}) {
    const auto truth = shown(channel, track, h);
    const bool late = channel == h.late || (channel == Channel::y && h.late == Channel::x);
    const auto values = run.fill(channel);
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = seven_digits(value_at(track, truth, run.time[i] - (late ? h.delay : 0.0)) +
                               o.noise * deviation(channel, s) * random.normal());
  }
  return run;
}

/// The true track from the settled approach to the end.
TrueTrack simulated(const TrueShip& s, const Concealment& h, const Manoeuvre& m, const TrialOptions& o,
                    RandomSource& random) {
  const double T = s.time_unit(), step = seven_digits(o.sample * T) / o.steps,
               unit = 0.0012 * o.disturbance * s.U_0 * s.U_0 / s.L;
  const double memory = 0.7 * T / step;
  Wandering d_u(memory, random), d_v(memory, random), d_r(memory, random), gusts(o.gust_memory * T / step, random);
  Moment now{.time = 0.0, .delta = 0.0, .order = self_propulsion(s, s.U_0), .disturbance = {}, .turbulence = 0.0};
  States q{};
  q[State::psi] = m.approach, q[State::u] = s.U_0, q[State::shaft] = now.order.rev,
  q[State::engine_torque] = now.order.torque;
  Helm helm(m, T);
  Gear gear(s.rudder_rate, h);
  const auto before = static_cast<long>(settling * T / step), kept = static_cast<long>(T / step),
             after = static_cast<long>((m.lengths + 0.1) * T / step);
  TrueTrack track{.from = -static_cast<double>(kept) * step, .step = step, .states = {}, .delta = {}};
  for (long i = -before; i <= after; ++i) {
    if (i == 0) {  // the record begins where she is now, what is late shows where she was
      for (auto& past : track.states) past[State::x] -= q[State::x], past[State::y] -= q[State::y];
      q[State::x] = q[State::y] = 0.0;
    }
    if (i >= -kept) track.states.push_back(q), track.delta.push_back(gear.shown());
    now.time = static_cast<double>(i) * step;
    now.disturbance = {0.3 * unit * d_u.next(), unit * d_v.next(), 1.5 * unit / s.L * d_r.next()};
    now.turbulence = o.turbulence * o.disturbance * gusts.next();
    const double order = helm.order(now.time, q);
    std::array<double, 3> delta{gear.rudder()};
    for (std::size_t half = 1; half < 3; ++half) gear.move(order, 0.5 * step), delta[half] = gear.rudder();
    q = stepped(s, h, q, now, delta, step);
  }
  return track;
}

std::string side_letter(bool to_port) { return to_port ? "p" : "s"; }

}  // namespace

Manoeuvre zigzag(int rudder_deg, int heading_deg, bool to_port, double approach) {
  return {.kind = Manoeuvre::Kind::zigzag,
          .name = fmt::format("zz{}_{}_{}", rudder_deg, heading_deg, side_letter(to_port)),
          .rudder = (to_port ? 1.0 : -1.0) * radians(rudder_deg),
          .heading = radians(heading_deg),
          .approach = approach};
}

Manoeuvre turn(int rudder_deg, bool to_port, double approach) {
  return {.kind = Manoeuvre::Kind::turn,
          .name = fmt::format("turn{}_{}", rudder_deg, side_letter(to_port)),
          .rudder = (to_port ? 1.0 : -1.0) * radians(rudder_deg),
          .approach = approach};
}

Manoeuvre passage(double approach, double first_change) {
  return {.kind = Manoeuvre::Kind::passage,
          .name = "passage",
          .heading = first_change,
          .approach = approach,
          .lengths = 28.0};
}

double seven_digits(double value) { return std::stod(fmt::format("{:.7g}", value)); }

double value_at(const TrueTrack& track, std::span<const double> values, double time) {
  const double place = std::clamp((time - track.from) / track.step, 0.0, static_cast<double>(values.size() - 1));
  const auto i = std::min(static_cast<std::size_t>(place), values.size() - 2);
  return values[i] + (place - static_cast<double>(i)) * (values[i + 1] - values[i]);
}

std::vector<double> shown(Channel channel, const TrueTrack& track, const Concealment& h) {
  if (channel == Channel::delta) return track.delta;
  std::vector<double> values;
  for (const auto& q : track.states) {
    const double c = std::cos(q[State::psi]), e = std::sin(q[State::psi]), drift = h.current_to - q[State::psi];
    const double u_ground = q[State::u] + h.current_speed * std::cos(drift) - h.antenna_y * q[State::r],
                 v_ground = q[State::v] + h.current_speed * std::sin(drift) + h.antenna_x * q[State::r];
    switch (channel) {
      case Channel::x: values.push_back(q[State::x] + h.antenna_x * c - h.antenna_y * e); break;
      case Channel::y: values.push_back(q[State::y] + h.antenna_x * e + h.antenna_y * c); break;
      case Channel::psi: values.push_back(q[State::psi] + h.heading_bias + h.compass_cosine * c); break;
      case Channel::r: values.push_back(q[State::r] + h.gyro_bias); break;
      case Channel::u:
      case Channel::speed_through_water: values.push_back(q[State::u] * (1.0 + h.log_scale)); break;
      case Channel::v: values.push_back(q[State::v]); break;
      case Channel::u_ground: values.push_back(u_ground); break;
      case Channel::v_ground: values.push_back(v_ground); break;
      case Channel::speed_over_ground: values.push_back(std::hypot(u_ground, v_ground)); break;
      case Channel::phi: values.push_back(q[State::phi]); break;
      default: values.push_back(q[State::shaft]);
    }
  }
  return values;
}

TrueTrack true_track(const TrueShip& ship, const Concealment& hidden, const Manoeuvre& manoeuvre,
                     const TrialOptions& options) {
  RandomSource random(options.seed);
  return simulated(ship, hidden, manoeuvre, options, random);
}

Recording simulate(const TrueShip& ship, const Concealment& hidden, const Manoeuvre& manoeuvre,
                   const TrialOptions& options) {
  RandomSource random(options.seed);
  const auto track = simulated(ship, hidden, manoeuvre, options, random);
  return recorded(ship, hidden, manoeuvre, options, track, random);
}

namespace {

/// How far the heading goes beyond the angle at which the rudder was first reversed.
double first_overshoot(const Recording& run, double angle) {
  const auto psi = run[Channel::psi];
  double most = 0.0;
  for (std::size_t i = 0; i < psi.size() && -psi[i] >= most - 0.5 * angle; ++i) most = std::max(most, -psi[i]);
  return most - angle;
}

}  // namespace

Character character_of(const TrueShip& ship) {
  const TrialOptions still{.noise = 0.0, .disturbance = 0.0};
  const auto circle = simulate(ship, {}, turn(35, true, 0.0), still);
  const auto psi = circle[Channel::psi], stw = circle[Channel::speed_through_water];
  const auto reversed = std::ranges::find_if(psi, [](double a) { return a <= -pi; }) - psi.begin();
  const double diameter =
      reversed < std::ssize(psi) ? std::abs(circle[Channel::y][static_cast<std::size_t>(reversed)]) / ship.L : HUGE_VAL;
  return {first_overshoot(simulate(ship, {}, zigzag(10, 10, true, 0.0), still), radians(10)),
          first_overshoot(simulate(ship, {}, zigzag(20, 20, true, 0.0), still), radians(20)), diameter,
          stw.back() / stw.front()};
}

}  // namespace swayaw::concealed
