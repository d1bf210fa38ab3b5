#pragma once

#include "swayaw/nonlinear/ship.hpp"

namespace swayaw::inline nonlinear {

/// The two columns of table 3.
enum class NawigatorHull {
  n7,                  ///< tuned on turning circles
  yoshimura_masumoto,  ///< by formula, where the tuning began
};

/// What the surge equation of the paper may mean. X_vr and the term (m + m_y) v r act alike, and one of the two is
/// doubtful: the formula for X_vr holds for drift angle times yaw rate, with v' its sign should be negative.
enum class SurgeReading {
  as_printed,     ///< X_vr > 0 and (m + m_y) v r
  mass_alone,     ///< X_vr > 0 and m v r
  negative_X_vr,  ///< X_vr < 0 and (m + m_y) v r
};

/// MV Nawigator XXI from ships/nawigator_n7.toml or ships/nawigator_ym.toml, with the surge equation read that way.
///
/// The paper's runs start at the service speed of 5.91 m/s with nawigator_rev; docs/papers/kulbiej2021.md tells which
/// of its numbers come out. Source: [Kulbiej2021]
Ship nawigator_xxi(NawigatorHull hull, SurgeReading surge = SurgeReading::as_printed);

/// Shaft speed of the paper, table 1 [1/s]; it does not propel the ship at the service speed but at 5.387 m/s.
inline constexpr double nawigator_rev = 3.7;

}  // namespace swayaw::nonlinear
