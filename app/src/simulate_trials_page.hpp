#pragma once

#include "simulate_page.hpp"
#include "swayaw/nonlinear/manoeuvres/pull_out.hpp"
#include "swayaw/nonlinear/manoeuvres/spiral.hpp"
#include "swayaw/nonlinear/manoeuvres/steady_run_in_wind.hpp"
#include "swayaw/nonlinear/manoeuvres/williamson_turn.hpp"

/// Pages of the manoeuvres that MSC.137(76) does not judge.
namespace swayaw::app {

Page spiral_page(const Spiral& spiral, const SpiralOrder& order, const Sailed& s);
Page reverse_spiral_page(const ReverseSpiral& spiral, const ReverseSpiralOrder& order, const Sailed& s);
Page pull_out_page(const PullOut& pull_out, const PullOutOrder& order, const Sailed& s);
Page williamson_page(const WilliamsonTurn& turn, const WilliamsonOrder& order, const Sailed& s);

/// With what other wind directions would ask for, where there is wind.
Page straight_page(const Ship& ship, const WindRun& run, const WindRunOrder& order, const Sailed& s);

}  // namespace swayaw::app
