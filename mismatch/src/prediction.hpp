#pragma once

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/dual.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/mismatch/noise.hpp"
#include "swayaw/nonlinear/acting_ship.hpp"
#include "swayaw/nonlinear/replay.hpp"

/// One-step predictions of a recorded run by a ship with effects. Not installed.
namespace swayaw {

/// A channel that the diagnosis looks at, with the standard deviation of its white noise.
struct SeenChannel {
  Channel channel;
  double noise;
};

/// A recorded run, prepared once.
struct PreparedRun {
  const Recording* run;
  std::vector<SeenChannel> channels;
  ShipState<double> start;
  double tau;      ///< memory of the ordinary imperfection, L/U [s]
  double longest;  ///< way made in one step of the integration [m]

  std::size_t samples() const { return run->samples(); }
  Eigen::Index rows() const { return static_cast<Eigen::Index>(samples() * channels.size()); }
};

/// Standard deviation of the accelerations that every model leaves out.
struct OrdinaryImperfection {
  double u, v, r;  ///< [m/s², m/s², rad/s²]
};

/// x, y, psi, u, v, r and the unmodelled accelerations.
inline constexpr int filter_states = 9;
using FilterState = Eigen::Matrix<double, filter_states, 1>;
using FilterCovariance = Eigen::Matrix<double, filter_states, filter_states>;

/// What the filter made of a run: gains and whitening of each sample, which stay while parameters change a little.
struct FilterPass {
  double tau = 0.0;                     ///< memory of the imperfection [s]
  std::vector<Eigen::MatrixXd> gain;    ///< 9 × channels
  std::vector<Eigen::MatrixXd> whiten;  ///< L⁻¹ of S = L Lᵀ; rows of missing samples are 0
  double log_likelihood = 0.0;
  std::vector<double> log_likelihoods;  ///< of each sample
  std::vector<FilterState> filtered;
};

/// A moment of a ship.
struct Instant {
  ShipState<double> state;
  StateVector<double> rate;  ///< of x, y, psi; of u, v, r where something is late
  double phi = 0.0;          ///< heel
};

/// What a smoother needs of a pass, sample after sample.
struct FilterTrace {
  std::vector<FilterState> predicted;  ///< before the sample is taken in
  std::vector<FilterCovariance> predicted_covariance;
  std::vector<FilterCovariance> filtered_covariance;
  std::vector<FilterCovariance> transition;  ///< d(predicted)/d(filtered at the sample before)
};

/// A true motion as the instruments show it: value of a channel.
double shown(Channel channel, const Instant& now, std::span<const Effect> sensors);

/// Predicts sample after sample.
template <class Model>
class Predictor {
 public:
  Predictor(const Ship& ship, const Model& model, const PreparedRun& run)
      : run_(run),
        acting_(acting_ship(ship, model)),
        controls_(ship, *run.run),
        dual_(cast<D>(acting_.model)),
        dual_added_(cast<D>(acting_.added)) {
    for (const double time : run.run->time) at_samples_.push_back(controls_.at(time));
  }

  /// Extended Kalman filter. S = H P Hᵀ + R of all channels together.
  /// @throws Refusal  if the motion runs away
  FilterPass filter(const OrdinaryImperfection& size, const Noise& noise, FilterTrace* trace = nullptr) {
    FilterPass pass;
    tau_ = pass.tau = run_.tau * noise.memory;
    noise_.clear();
    for (const auto& [channel, deviation] : run_.channels)
      noise_.push_back(deviation * noise.factor[index_of(channel)]);
    start();
    FilterCovariance P = start_covariance(size);
    const auto n = run_.samples();
    pass.gain.reserve(n), pass.whiten.reserve(n), pass.log_likelihoods.reserve(n);
    for (std::size_t k = 0; k < n; ++k) {
      if (trace) trace->transition.push_back(FilterCovariance::Identity());
      if (k > 0) P = sail_with_covariance(k, P, size, trace ? &trace->transition.back() : nullptr);
      if (trace) trace->predicted.push_back(x_), trace->predicted_covariance.push_back(P);
      take_in(k, P, pass);
      if (trace) trace->filtered_covariance.push_back(P);
    }
    return pass;
  }

  /// Whitened innovations with the gains of a pass.
  void innovations(const FilterPass& pass, Eigen::Ref<Eigen::VectorXd> out) {
    tau_ = pass.tau;
    start();
    const auto m = static_cast<Eigen::Index>(run_.channels.size());
    Eigen::VectorXd e(m);
    for (std::size_t k = 0; k < run_.samples(); ++k) {
      if (k > 0) sail(k);
      errors(k, e);
      out.segment(static_cast<Eigen::Index>(k) * m, m).noalias() = pass.whiten[k] * e;
      x_.noalias() += pass.gain[k] * e;
    }
  }

 private:
  using D = Dual<4>;  // of psi, u, v, r

  void start() {
    const auto& s = run_.start;
    x_.setZero();
    x_.head<6>() << s.x, s.y, s.psi, s.motion.u, s.motion.v, s.motion.r;
    hidden_ = steady_hidden(acting_.added, s.motion);
    next_change_ = 0;
    around_ = acting_.surroundings;
    acting_.added.acting = dual_added_.acting = acting_at_first_;
  }

  FilterCovariance start_covariance(const OrdinaryImperfection& size) const {
    const double L = acting_.model.particulars.L, U = acting_.model.particulars.U_0;
    FilterCovariance P = FilterCovariance::Zero();
    P.diagonal() << L * L / 16, L * L / 16, 1.0 / 16, U * U / 16, U * U / 16, U * U / (16 * L * L), size.u * size.u,
        size.v * size.v, size.r * size.r;
    return P;
  }

  ShipState<double> state() const { return {x_[0], x_[1], x_[2], {x_[3], x_[4], x_[5]}}; }

  /// Rates of the nine states and of what goes on out of sight.
  std::pair<FilterState, Hidden<double>> rates(const FilterState& x, const Hidden<double>& hidden,
                                               const Controls<double>& c) const {
    const ShipState<double> s{x[0], x[1], x[2], {x[3], x[4], x[5]}};
    const auto driven_by = driven(acting_.added, s.motion, c);
    const auto r =
        rates_of(acting_.model, around_, acting_.added, s, hidden, c, branch_at(acting_.model, s.motion, driven_by));
    FilterState rate;
    rate << r[0], r[1], r[2], r[3] + x[6], r[4] + x[7], r[5] + x[8], -x[6] / tau_, -x[7] / tau_, -x[8] / tau_;
    return {rate, acting_.added.hidden() ? hidden_rates(acting_.added, s.motion, hidden) : Hidden<double>{}};
  }

  static Hidden<double> moved(Hidden<double> h, const Hidden<double>& rate, double t) {
    for (std::size_t i = 0; i < h.size(); ++i) h[i] += t * rate[i];
    return h;
  }

  /// The midpoint rule; the classical Runge–Kutta step where something swings out of sight. What the rule is short of,
  /// (h/T)²/6 of an acceleration that changes in the time T, is 0.3 % for the shortest step response of a hull, and the
  /// next sample takes it in.
  void step(const Controls<double>& a, const Controls<double>& b, double h) {
    const auto middle = between(a, b, 0.5);
    const auto [k1, m1] = rates(x_, hidden_, a);
    const auto [k2, m2] = rates(x_ + 0.5 * h * k1, moved(hidden_, m1, 0.5 * h), middle);
    if (!acting_.added.hidden()) {
      x_ += h * k2;
      return;
    }
    const auto [k3, m3] = rates(x_ + 0.5 * h * k2, moved(hidden_, m2, 0.5 * h), middle);
    const auto [k4, m4] = rates(x_ + h * k3, moved(hidden_, m3, h), b);
    x_ += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    Hidden<double> mean;
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] = (m1[i] + 2.0 * m2[i] + 2.0 * m3[i] + m4[i]) / 6.0;
    hidden_ = moved(hidden_, mean, h);
  }

  static Controls<double> between(const Controls<double>& a, const Controls<double>& b, double share) {
    const auto mix = [&](double x, double y) { return x + share * (y - x); };
    return {mix(a.delta, b.delta),
            mix(a.rev, b.rev),
            {mix(a.thrust.port, b.thrust.port), mix(a.thrust.starboard, b.thrust.starboard)},
            a.by_thrust};
  }

  /// Controls at a time between samples k − 1 and k; a rudder with a motion of its own is asked for it.
  Controls<double> controls_between(std::size_t k, double from, double time, double h) const {
    if (controls_.track()) return controls_.at(time);
    return between(at_samples_[k - 1], at_samples_[k], (time - from) / h);
  }

  /// Calls f(begin, end, duration) for short steps from sample k − 1 to k, cut where the wind or a force changes.
  template <class F>
  void for_steps(std::size_t k, F&& f) {
    const double from = run_.run->time[k - 1], to = run_.run->time[k], h = to - from;
    if (!(std::hypot(x_[3], x_[4]) < 1e3 * acting_.model.particulars.U_0))
      throw Refusal(fmt::format("{}: no motion can be followed at {:.6g} s", run_.run->name, from));
    double now = from;
    while (now < to) {
      const auto& changes = acting_.changes;
      for (; next_change_ < changes.size() && changes[next_change_].time <= now; ++next_change_) {
        changes[next_change_].apply(around_, acting_.added);
        dual_added_.acting = acting_.added.acting;
      }
      const double edge = next_change_ < changes.size() ? std::min(to, changes[next_change_].time) : to;
      const int steps =
          std::max(1, static_cast<int>(std::ceil((edge - now) * std::hypot(x_[3], x_[4]) / run_.longest)));
      for (int i = 0; i < steps; ++i) {
        const double a = now + (edge - now) * i / steps, b = now + (edge - now) * (i + 1) / steps;
        f(controls_between(k, from, a, h), controls_between(k, from, b, h), b - a);
      }
      now = edge;
    }
  }

  void sail(std::size_t k) {
    for_steps(k, [&](const Controls<double>& a, const Controls<double>& b, double h) { step(a, b, h); });
  }

  /// dx/dx of the nine states, by duals.
  FilterCovariance jacobian(const Controls<double>& c) const {
    const auto s = state();
    const ShipState<D> dual{D(s.x), D(s.y), D(s.psi, 0), {D(s.motion.u, 1), D(s.motion.v, 2), D(s.motion.r, 3)}};
    Hidden<D> hidden;
    std::ranges::transform(hidden_, hidden.begin(), [](double h) { return D(h); });
    const Surroundings<D> around{.windage = cast_part<D>(around_.windage),
                                 .wind = {D(around_.wind.speed), D(around_.wind.from)},
                                 .current = {D(around_.current.speed), D(around_.current.to)},
                                 .windy = around_.windy};
    const auto controls = cast<D>(c);
    const auto r = rates_of(dual_, around, dual_added_, dual, hidden, controls,
                            branch_at(dual_, dual.motion, driven(dual_added_, dual.motion, controls)));
    FilterCovariance A = FilterCovariance::Zero();
    for (int i = 0; i < 6; ++i) A.template block<1, 4>(i, 2) = r[static_cast<std::size_t>(i)].v.transpose();
    A.template block<3, 3>(3, 6).setIdentity();
    A.template block<3, 3>(6, 6).diagonal().setConstant(-1.0 / tau_);
    return A;
  }

  FilterCovariance sail_with_covariance(std::size_t k, FilterCovariance P, const OrdinaryImperfection& size,
                                        FilterCovariance* transition) {
    for_steps(k, [&](const Controls<double>& a, const Controls<double>& b, double h) {
      const FilterCovariance A = h * jacobian(a);
      const FilterCovariance Phi = FilterCovariance::Identity() + A + 0.5 * A * A;
      step(a, b, h);
      P = Phi * P * Phi.transpose();
      if (transition) *transition = (Phi * *transition).eval();
      const double share = -std::expm1(-2.0 * h / tau_);
      P(6, 6) += share * size.u * size.u, P(7, 7) += share * size.v * size.v, P(8, 8) += share * size.r * size.r;
    });
    return P;
  }

  /// What the instruments look at, with accelerations where one of them is late.
  Instant instant(std::size_t k, bool with_accelerations) const {
    Instant now{state(), {}, shown_by(hidden_, Channel::phi)};
    if (with_accelerations) {
      const auto [rate, out_of_sight] = rates(x_, hidden_, at_samples_[k]);
      for (std::size_t i = 0; i < 6; ++i) now.rate[i] = rate[static_cast<Eigen::Index>(i)];
    } else {
      now.rate = way(x_);
    }
    return now;
  }

  /// Rates of place and heading alone.
  StateVector<double> way(const FilterState& x) const {
    const auto [s, c] = sin_cos(x[2]);
    const auto& [V_c, psi_c] = around_.current;
    return {
        x[3] * c - x[4] * s + V_c * std::cos(psi_c), x[3] * s + x[4] * c + V_c * std::sin(psi_c), x[5], 0.0, 0.0, 0.0};
  }

  /// Measured less expected; 0 where a sample is missing.
  void errors(std::size_t k, Eigen::VectorXd& e) const {
    const bool late = std::ranges::any_of(acting_.sensors, [](const Effect& s) { return channel_of(s) != nullptr; });
    const auto now = instant(k, late);
    for (std::size_t i = 0; i < run_.channels.size(); ++i) {
      const auto channel = run_.channels[i].channel;
      const double measured = (*run_.run)[channel][k];
      double& error = e[static_cast<Eigen::Index>(i)];
      error = std::isnan(measured) ? 0.0 : measured - shown(channel, now, acting_.sensors);
      if (channel == Channel::psi || channel == Channel::course_over_ground) error = wrapped(error);
    }
  }

  /// How the channels change with the state, by differences.
  Eigen::MatrixXd slopes(std::size_t k) const {
    const auto m = static_cast<Eigen::Index>(run_.channels.size());
    Eigen::MatrixXd H = Eigen::MatrixXd::Zero(m, filter_states);
    const auto at = [&](const FilterState& x) {
      return Instant{{x[0], x[1], x[2], {x[3], x[4], x[5]}}, way(x), shown_by(hidden_, Channel::phi)};
    };
    for (int j = 0; j < 6; ++j) {
      const double h = j < 2 ? 1.0 : 1e-6;
      FilterState x = x_;
      x[j] = x_[j] + h;
      const auto up = at(x);
      x[j] = x_[j] - h;
      const auto down = at(x);
      for (Eigen::Index i = 0; i < m; ++i) {
        const auto channel = run_.channels[static_cast<std::size_t>(i)].channel;
        if (!std::isnan((*run_.run)[channel][k]))
          H(i, j) = (shown(channel, up, acting_.sensors) - shown(channel, down, acting_.sensors)) / (2.0 * h);
      }
    }
    return H;
  }

  void take_in(std::size_t k, FilterCovariance& P, FilterPass& pass) {
    const auto m = static_cast<Eigen::Index>(run_.channels.size());
    Eigen::VectorXd e(m);
    errors(k, e);
    const Eigen::MatrixXd H = slopes(k), PH = P * H.transpose();
    Eigen::MatrixXd S = H * PH;
    std::vector<Eigen::Index> gone;
    for (Eigen::Index i = 0; i < m; ++i) {
      const bool is_missing = std::isnan((*run_.run)[run_.channels[static_cast<std::size_t>(i)].channel][k]);
      const double noise = noise_[static_cast<std::size_t>(i)];
      S(i, i) += is_missing ? 1.0 : noise * noise;
      if (is_missing) gone.push_back(i);
    }
    const Eigen::LLT<Eigen::MatrixXd> factor(S);
    const Eigen::MatrixXd K = factor.solve(PH.transpose()).transpose();
    Eigen::MatrixXd W = Eigen::MatrixXd::Identity(m, m);
    factor.matrixL().solveInPlace(W);
    for (const auto i : gone) W.row(i).setZero();
    const Eigen::VectorXd white = W * e;
    pass.log_likelihoods.push_back(-0.5 * white.squaredNorm() - factor.matrixLLT().diagonal().array().log().sum());
    pass.log_likelihood += pass.log_likelihoods.back();
    x_ += K * e;
    P -= K * PH.transpose();
    P = (0.5 * (P + P.transpose())).eval();
    pass.gain.push_back(K);
    pass.whiten.push_back(std::move(W));
    pass.filtered.push_back(x_);
  }

  const PreparedRun& run_;
  ActingShip<Model> acting_;
  RecordedControls controls_;
  decltype(cast<D>(std::declval<Model>())) dual_;
  ActingEffects<D> dual_added_;
  std::vector<Controls<double>> at_samples_;
  std::vector<double> noise_;  ///< of each channel
  double tau_ = 0.0;           ///< memory of the imperfection [s]
  FilterState x_;
  Hidden<double> hidden_;
  Surroundings<double> around_;
  std::size_t next_change_ = 0;
  std::uint32_t acting_at_first_ = acting_.added.acting;
};

}  // namespace swayaw
