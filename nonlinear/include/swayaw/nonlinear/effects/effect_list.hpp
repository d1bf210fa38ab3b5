#pragma once

#include <variant>

#include "swayaw/nonlinear/effects/added_mass.hpp"
#include "swayaw/nonlinear/effects/added_resistance.hpp"
#include "swayaw/nonlinear/effects/antenna_lever_arm.hpp"
#include "swayaw/nonlinear/effects/channel_delay.hpp"
#include "swayaw/nonlinear/effects/channel_filter.hpp"
#include "swayaw/nonlinear/effects/clock_drift.hpp"
#include "swayaw/nonlinear/effects/cross_flow_drag.hpp"
#include "swayaw/nonlinear/effects/flow_straightening.hpp"
#include "swayaw/nonlinear/effects/fluid_memory.hpp"
#include "swayaw/nonlinear/effects/gust.hpp"
#include "swayaw/nonlinear/effects/gyro_bias.hpp"
#include "swayaw/nonlinear/effects/gyro_scale.hpp"
#include "swayaw/nonlinear/effects/heading_bias.hpp"
#include "swayaw/nonlinear/effects/hull_linear_derivatives.hpp"
#include "swayaw/nonlinear/effects/hull_nonlinear_damping.hpp"
#include "swayaw/nonlinear/effects/log_scale.hpp"
#include "swayaw/nonlinear/effects/model_form.hpp"
#include "swayaw/nonlinear/effects/propeller_race.hpp"
#include "swayaw/nonlinear/effects/propeller_side_force.hpp"
#include "swayaw/nonlinear/effects/roll_coupling.hpp"
#include "swayaw/nonlinear/effects/rudder_effectiveness.hpp"
#include "swayaw/nonlinear/effects/rudder_gap.hpp"
#include "swayaw/nonlinear/effects/rudder_hull_interaction.hpp"
#include "swayaw/nonlinear/effects/rudder_offset.hpp"
#include "swayaw/nonlinear/effects/rudder_stall.hpp"
#include "swayaw/nonlinear/effects/shaft_speed_drop.hpp"
#include "swayaw/nonlinear/effects/shallow_water.hpp"
#include "swayaw/nonlinear/effects/speed_loss_in_turn.hpp"
#include "swayaw/nonlinear/effects/steady_current.hpp"
#include "swayaw/nonlinear/effects/steady_wind.hpp"
#include "swayaw/nonlinear/effects/steering_gear_backlash.hpp"
#include "swayaw/nonlinear/effects/steering_gear_lag.hpp"
#include "swayaw/nonlinear/effects/unknown_force.hpp"
#include "swayaw/nonlinear/effects/velocity_axes.hpp"
#include "swayaw/nonlinear/effects/wake_change.hpp"
#include "swayaw/nonlinear/effects/wave_drift.hpp"

namespace swayaw::inline nonlinear {

/// Every effect, in the order of the table of docs/effects.md. All else that holds one of each kind is made from this
/// list: file keys, casts, forces that act, forms of the search, words, tests.
template <class S>
using EffectIn =
    std::variant<SteadyWind<S>, Gust<S>, SteadyCurrent<S>, WaveDrift<S>, ShallowWater<S>, HullLinearDerivatives<S>,
                 HullNonlinearDamping<S>, CrossFlowDrag<S>, AddedResistance<S>, SpeedLossInTurn<S>, AddedMass<S>,
                 RudderEffectiveness<S>, RudderHullInteraction<S>, RudderStall<S>, RudderGap<S>, FlowStraightening<S>,
                 RaceOnRudder<S>, PropellerSideForce<S>, WakeChange<S>, ShaftSpeedDrop<S>, RudderOffset<S>,
                 SteeringGearLag<S>, SteeringGearBacklash<S>, RollCoupling<S>, FluidMemory<S>, HeadingBias<S>,
                 GyroBias<S>, GyroScale<S>, LogScale<S>, VelocityAxes<S>, AntennaLeverArm<S>, ChannelDelay<S>,
                 ClockDrift<S>, ChannelFilter<S>, ModelForm<S>, UnknownForce<S>>;

}  // namespace swayaw::nonlinear
