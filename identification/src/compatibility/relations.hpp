#pragma once

#include "swayaw/identification/data_compatibility.hpp"

/// Errors of instruments by one law of kinematics each. Every relation is linear in the errors, which have wide priors;
/// what the motion of the run does not tell keeps its prior.
namespace swayaw::inline identification::detail {

/// Standard deviations of the errors before any sample is seen: of instruments that work at all.
struct InstrumentPriors {
  double rate_zero = 0.005;  ///< [rad/s], 0.3 deg/s
  double scale = 0.05;       ///< of gyro and logs
  double delay = 3.0;        ///< [s]
  double good_clock = 1e-5;  ///< drift of a clock that keeps time [s/s]
  double drift = 0.05;       ///< of one that does not, or of a file that was resampled wrongly [s/s]
  double axes = 0.1;         ///< [rad], 6 deg
  double jump = 30.0;        ///< of a clock [s]; R/V Gunnerus's lost 58 and 75 s of her positions
  double smoothing = 3.0;    ///< [s]
  double current = 0.2;      ///< over the speed of the ship
  double lever = 0.5;        ///< over the smallest radius that the ship turned
};

/// A delay or a jump of a clock below which no answer about a ship changes [s].
inline constexpr double least_delay = 0.1;

/// Standard deviation of an error that a run is not asked for, in any unit.
inline constexpr double not_asked = 1e-6;

/// dpsi/dt = r. Integrated, for what integrates keeps noise small:
///
///     psi − ∫ r dt = psi_0 − b/(1 + s) t − s/(1 + s) ∫ r dt + tau/(1 + s) r + ½ (tau² − w²)/(1 + s) dr/dt
///
/// with zero b, scale s, mean delay tau of the yaw rate behind the heading, and a window of standard deviation w: of
/// the two the kind of the filter is told.
///
/// @param run  measured samples
std::vector<InstrumentError> yaw_rate_errors(const Recording& run);

/// Whether a run turns so that it tells the scale of a gyro. One that hardly turns shows waves, which heading and gyro
/// filter in their ways, and noise of the gyro for its signal: on R/V Gunnerus, who came round by 25 deg in six
/// minutes, the yaw rate seemed 66 % too large.
bool tells_scale_of_gyro(const Recording& run);

/// ẋ, ẏ from a velocity in body axes. With I the way by the velocity, V the velocity, both in earth axes:
///
///     p − I = p_0 + k I + eps (−I_y, I_x) − tau(t) V + c t + R(psi) l + tau_psi ∫ r (−V_y, V_x) dt
///
/// with scale 1/(1 + k) of the speed, velocity axes turned by eps (both to first order here, exactly in the answer),
/// positions late by tau, current c (only of a velocity through the water), antenna at l, heading late by tau_psi. A
/// velocity that is late by tau_u makes positions and heading early by as much; which of the three it is, is told where
/// one alone explains both.
///
/// Without sway a run that turns tells nothing: drift adds or takes some per cent of the way and turns the track by
/// some degrees. On one course the ship is taken to drift in proportion to the yaw rate, v = l r; clocks and antenna
/// are not told there, which move the track sideways by as much.
///
/// @param run   measured samples
/// @param speed u_ground, u, or speed_through_water
std::vector<InstrumentError> track_errors(const Recording& run, Channel speed);

/// Speeds that the track can be compared with.
std::vector<Channel> speeds_of(const Recording& run);

/// Sway on a straight course. A ship without wind does not drift there, so that velocities which do were measured in
/// axes that are turned, or with a heading that is wrong:
///
///     v = −eps u + l r − c_x sin psi + c_y cos psi
///
/// with the current only in a velocity over ground.
///
/// @return an error of the axes of the sway; wind and a single screw cause a degree of it, too
std::optional<InstrumentError> drift_on_straight_courses(const Recording& run, Channel surge);

/// By what the ship does. A rudder held hard over turns every ship to its side; where none is held, the yaw rate
/// changes after a rudder has moved to the side to which it moved. With means over blocks of a few seconds, which leave
/// out waves,
///
///     r_{k+1} − r_k = a (delta_k − delta_{k−1}),    a < 0 for a rudder positive to port
///
/// The change of the yaw rate comes after that of the rudder: an autopilot, which moves the rudder after the yaw rate
/// has changed, tells the same sign.
///
/// @return nothing where the run does not tell
std::optional<bool> rudder_is_reversed(const Recording& run);

}  // namespace swayaw::identification::detail
