#pragma once

#include <optional>

#include "../trial/other_values.hpp"
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

/// The same by the prior's precision.
Eigen::MatrixXd widened(const Eigen::MatrixXd& prior, const Eigen::MatrixXd& covariance);

/// Whether the parameters that decide are told from those of no effect, zᵀC⁻¹z > 4 with their covariance C: a gust that
/// kicked her for an instant may gain much, and yet be of any size. The effect is the last of the fit.
bool is_told(const Ship& ship, const EffectForm& form, const MapFit& found);

/// Covariance of the parameters of an effect, other values with the ship's own, from which they count: the data tell
/// both together. Its coordinates begin at `from`.
/// @param slopes  d(parameters)/d(coordinates), the ship's own as they are
Eigen::MatrixXd covariance_with_own(const Trial& trial, const EffectForm& form, const MapFit& found, Eigen::Index from,
                                    const Eigen::MatrixXd& slopes, const OwnValues& own);

/// Whether other values that count from the ship's own are told from those of her file, too: where reference runs moved
/// coefficients and other runs move them back, it is the reference runs that are not like the ship. Of ships as on
/// board with reference runs (seeds 52 to 54) added mass (a gain of 129) and cubic terms (49 and 25) came back to the
/// file in two in which they were not hidden, cubic terms (139) in one in which they were. True of all other effects.
bool is_told_from_file(const Trial& trial, const EffectForm& form, const MapFit& found, Eigen::Index from);

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
