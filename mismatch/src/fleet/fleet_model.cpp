#include "fleet_model.hpp"

#include <algorithm>
#include <cmath>

#include "swayaw/core/detail/matrices.hpp"
#include "swayaw/core/parallel.hpp"
#include "swayaw/core/refusal.hpp"

namespace swayaw::inline mismatch::detail {
namespace {

/// Between which spreads are searched, in factors of 2; a spread of coefficients beyond those of the file has no sense.
constexpr double least_spread = 1.0 / 64.0, most_spread = 1.0, most_watched_spread = 4.0;

/// What days of one vessel scatter by in what is watched, before data: about a quarter of the least size that matters,
/// and as likely twice as half of that. A scatter that is as large as what matters is most often a change.
constexpr double usual_watched_spread = 0.25;

double log_prior_of_scatter(double spread) {
  const double octaves = std::log2(spread / usual_watched_spread);
  return -0.5 * octaves * octaves;
}

constexpr double worth_a_round = 0.5;  ///< of log evidence

/// L with L Lᵀ the covariance after data of x = L_0 n: L_0 M^(−1/2), by the axes of L_0ᵀ A L_0.
Eigen::MatrixXd square_root_of(const Told& told, const Eigen::MatrixXd& before) {
  const auto axes = core::detail::principal_axes(before.transpose() * told.A * before);
  const Eigen::VectorXd shrunk = (axes.size.array().max(0.0) + 1.0).rsqrt();
  return before * axes.axis * shrunk.asDiagonal();
}

}  // namespace

FleetModel::FleetModel(const ClassTrial& whole, std::vector<Day> days, std::size_t vessels)
    : whole_(&whole),
      days_(std::make_shared<const std::vector<Day>>(std::move(days))),
      shifts_(vessels),
      last_(vessels, -HUGE_VAL),
      scattered_(days_->size()),
      of_vessel_(vessels),
      of_class_(vessels) {
  spread_.watched.assign(vessels, std::vector(whole.watched.size(), usual_watched_spread));
  for (const auto& day : *days_) last_[day.vessel] = std::max(last_[day.vessel], day.date);
  renew();
}

FleetModel FleetModel::with(std::size_t vessel, const Shift& shift) const {
  FleetModel other = *this;
  other.shifts_[vessel].push_back(shift);
  other.renew(vessel);
  other.climb_watched(vessel, shift.watched);
  return other;
}

FleetModel FleetModel::without(std::size_t vessel, std::size_t shift) const {
  FleetModel other = *this;
  other.shifts_[vessel].erase(other.shifts_[vessel].begin() + static_cast<std::ptrdiff_t>(shift));
  other.renew(vessel);
  return other;
}

FleetModel FleetModel::with_likely_scatter(std::size_t vessel, std::size_t watched) const {
  FleetModel other = *this;
  other.climb_watched(vessel, watched);
  return other;
}

FleetModel FleetModel::with_little_scatter(std::size_t vessel, std::size_t watched) const {
  constexpr double little = 0.125;  // of the least size that matters
  FleetModel other = *this;
  other.spread_.watched[vessel][watched] = std::min(little, other.spread_.watched[vessel][watched]);
  other.renew(vessel);
  return other;
}

void FleetModel::move_days() {
  std::vector<NormalLaw> laws;
  for (std::size_t vessel = 0; vessel < vessels(); ++vessel) laws.push_back(law_of(vessel));
  auto all = *days_;
  in_parallel(all.size(), 0, [&](std::size_t i) {
    auto moved = all[i];
    try {
      move_day(moved, *whole_, coordinates_on(moved, laws[moved.vessel]));
    } catch (const Refusal&) {  // the ship cannot sail them like that: the day stays as it was
      return;
    }
    all[i] = std::move(moved);
  });
  days_ = std::make_shared<const std::vector<Day>>(std::move(all));
  renew();
  find_spreads();
}

void FleetModel::move_last_to(std::size_t vessel, std::size_t place) {
  auto& shifts = shifts_[vessel];
  std::rotate(shifts.begin() + static_cast<std::ptrdiff_t>(place), shifts.end() - 1, shifts.end());
  renew(vessel);
}

void FleetModel::find_spreads() {
  for (double before = -HUGE_VAL; log_evidence_ > before + worth_a_round;) {
    before = log_evidence_;
    if (vessels() > 1) climb(spread_.vessels, most_spread, [&] { renew(); });
    climb(spread_.days, most_spread, [&] { renew(); });
    for (std::size_t vessel = 0; vessel < vessels(); ++vessel)
      for (std::size_t k = 0; k < whole_->watched.size(); ++k) climb_watched(vessel, k);
  }
}

NormalLaw FleetModel::law_in_parts(std::size_t vessel) const {
  const auto d = whole_->size(), m = std::ssize(shifts_[vessel]);
  Told others = Told::nothing(d);
  for (std::size_t other = 0; other < shifts_.size(); ++other)
    if (other != vessel) others += of_class_[other];
  const Eigen::MatrixXd before = whole_->of_class.asDiagonal();
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(2 * d + m);
  mean.head(d) = posterior(others, Eigen::VectorXd::Zero(d), before).mean;
  Eigen::MatrixXd L = Eigen::MatrixXd::Zero(2 * d + m, 2 * d + m);
  L.topLeftCorner(d, d) = square_root_of(others, before);
  L.diagonal().segment(d, d) = own_deviations();
  for (Eigen::Index j = 0; j < m; ++j)
    L(2 * d + j, 2 * d + j) = deviation_of(shifts_[vessel][static_cast<std::size_t>(j)]);
  return posterior(of_vessel_[vessel].of(sum_of_parts(vessel)), mean, L);
}

Eigen::MatrixXd FleetModel::sum_of_parts(std::size_t vessel) const {
  const auto d = whole_->size(), m = std::ssize(shifts_[vessel]);
  Eigen::MatrixXd P = Eigen::MatrixXd::Zero(d + m, 2 * d + m);
  P.topLeftCorner(d, d).setIdentity();
  P.rightCols(d + m).setIdentity();
  return P;
}

NormalLaw FleetModel::law_of(std::size_t vessel) const {
  const auto parts = law_in_parts(vessel);
  const auto P = sum_of_parts(vessel);
  return {P * parts.mean, P * parts.covariance * P.transpose(), parts.log_evidence};
}

FleetModel::OwnLaw FleetModel::own_law_of(std::size_t vessel) const {
  const auto d = whole_->size();
  const auto parts = law_in_parts(vessel);
  return {parts.mean.head(d), parts.mean.segment(d, d),
          parts.covariance.diagonal().segment(d, d).cwiseMax(0.0).cwiseSqrt()};
}

NormalLaw FleetModel::law_of_class() const {
  Told all = Told::nothing(whole_->size());
  for (const auto& told : of_class_) all += told;
  const Eigen::MatrixXd before = whole_->of_class.asDiagonal();
  return posterior(all, Eigen::VectorXd::Zero(whole_->size()), before);
}

std::vector<double> FleetModel::gains(std::size_t vessel, std::size_t watched, ChangeShape shape,
                                      std::span<const double> dates, const NormalLaw& law) const {
  const auto k = whole_->watched[watched].place;
  const double variance = std::pow(whole_->watched[watched].deviation, 2);
  std::vector<double> result;
  for (const double since : dates) {
    const Shift shift{watched, shape, since};
    Eigen::VectorXd h = Eigen::VectorXd::Zero(law.mean.size());
    double zz = 0.0, bz = 0.0;
    for (std::size_t i = 0; i < days().size(); ++i) {
      if (days()[i].vessel != vessel) continue;
      const double g = shift.at(days()[i].date, last_[vessel]);
      h += g * (map_of(days()[i]).transpose() * scattered_[i].A.col(k));
      zz += g * g * scattered_[i].A(k, k), bz += g * scattered_[i].b[k];
    }
    const double S = zz - h.dot(law.covariance * h) + 1.0 / variance, r = bz - h.dot(law.mean);
    result.push_back(0.5 * r * r / S - 0.5 * std::log(S * variance));
  }
  return result;
}

Eigen::VectorXd FleetModel::own_deviations() const {
  Eigen::VectorXd own = spread_.vessels * whole_->of_class;
  for (const auto& w : whole_->watched) own[w.place] = w.deviation;
  return own;
}

Eigen::MatrixXd FleetModel::map_of(const Day& day) const {
  const auto d = whole_->size();
  const auto& shifts = shifts_[day.vessel];
  Eigen::MatrixXd G = Eigen::MatrixXd::Zero(d, d + std::ssize(shifts));
  G.leftCols(d).setIdentity();
  for (std::size_t j = 0; j < shifts.size(); ++j)
    G(whole_->watched[shifts[j].watched].place, d + static_cast<Eigen::Index>(j)) =
        shifts[j].at(day.date, last_[day.vessel]);
  return G;
}

void FleetModel::renew() {
  in_parallel(vessels(), 0, [&](std::size_t vessel) { renew_told(vessel); });
  renew_evidence();
}

void FleetModel::renew_told(std::size_t vessel) {
  const auto d = whole_->size(), m = std::ssize(shifts_[vessel]);
  Eigen::VectorXd of_days = spread_.days * whole_->of_class;
  for (std::size_t k = 0; k < whole_->watched.size(); ++k)
    of_days[whole_->watched[k].place] = spread_.watched[vessel][k] * whole_->watched[k].floor;
  const Eigen::MatrixXd scatter = of_days.asDiagonal();
  Told told = Told::nothing(d + m);
  for (std::size_t i = 0; i < days().size(); ++i) {
    if (days()[i].vessel != vessel) continue;
    scattered_[i] = blurred(days()[i].told, scatter);
    told += scattered_[i].of(map_of(days()[i]));
  }
  Eigen::VectorXd own(d + m);
  own.head(d) = own_deviations();
  for (Eigen::Index j = 0; j < m; ++j) own[d + j] = deviation_of(shifts_[vessel][static_cast<std::size_t>(j)]);
  const auto about_class = blurred(told, Eigen::MatrixXd(own.asDiagonal()));
  of_vessel_[vessel] = std::move(told);
  of_class_[vessel] = {about_class.A.topLeftCorner(d, d), about_class.b.head(d), about_class.c};
}

void FleetModel::renew_evidence() {
  log_evidence_ = law_of_class().log_evidence;
  for (const auto& spreads : spread_.watched)
    for (const double spread : spreads) log_evidence_ += log_prior_of_scatter(spread);
}

void FleetModel::climb(double& spread, double most, const std::function<void()>& renew_with) {
  for (const double factor : {2.0, 0.5})
    for (;;) {
      const double before = spread, evidence = log_evidence_;
      spread = before * factor;
      const bool possible = spread <= most && spread >= least_spread;
      if (possible) renew_with();
      if (possible && log_evidence_ > evidence) continue;
      spread = before;
      if (possible) renew_with();
      break;
    }
}

void FleetModel::climb_watched(std::size_t vessel, std::size_t k) {
  climb(spread_.watched[vessel][k], most_watched_spread, [&] { renew(vessel); });
}

}  // namespace swayaw::mismatch::detail
