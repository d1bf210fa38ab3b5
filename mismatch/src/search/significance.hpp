#pragma once

#include <optional>

#include "search.hpp"

/// How well the runs tell an effect that was fitted. Not installed.
namespace swayaw::inline mismatch::detail {

inline constexpr double evidence_excess = 3.0;

/// Of the coordinates of an effect, before the runs.
Eigen::VectorXd precision_of(const EffectForm& form);

/// The inverse of `widened`: of the prior, and of what the data add, counted as evidence is.
Eigen::MatrixXd widened_precision(const EffectForm& form, const Eigen::MatrixXd& covariance);

/// Covariance of the coordinates of an effect where the data count evidence_excess times less: (Λ + (C⁻¹ − Λ)/excess)⁻¹
/// with the prior's precision Λ.
Eigen::MatrixXd widened(const EffectForm& form, const Eigen::MatrixXd& covariance);

/// Whether the parameters that decide are told from those of no effect, zᵀC⁻¹z > 4 with their covariance C: a gust that
/// kicked her for an instant may gain much, and yet be of any size. The effect is the last of the fit.
bool is_told(const Ship& ship, const EffectForm& form, const MapFit& found);

/// Whether an effect in the place of an ordinary error of an instrument, a rudder or a day is no larger than such
/// errors are. Its coordinates begin at `first`.
bool is_as_ordinary(const Trial& trial, const EffectForm& form, const Point& point, Eigen::Index first);

/// Whether an effect gains what is needed beside the baseline alone, too, or much more where it was accepted.
bool is_told_by_itself(const Search& s, const Accepted& accepted, double needed);

/// When an effect that was accepted begins and ends to act, in the time of the runs.
struct ActiveTime {
  std::optional<double> onset, end;  ///< [s]; nothing where it acts from the first, to the last
};

/// By likelihood ratio: without the effect the samples before the onset, or after the end, are likelier by more than
/// `needed`. Neither lies within two ship lengths of way of the ends of the longest run, where the filter settles.
ActiveTime active_time(const Trial& trial, const Search& s, std::size_t accepted, double needed);

}  // namespace swayaw::mismatch::detail
