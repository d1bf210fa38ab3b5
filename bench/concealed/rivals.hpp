#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "score.hpp"

/// Five simple answers that a diagnosis has to beat.
namespace swayaw::concealed {

/// Names of effects, best first; none for "nothing is missing".
struct RivalAnswer {
  std::string_view rival;
  std::vector<std::string> effects;
};

/// `nothing`: never anything. `random`: any effect or nothing, all alike. `ols_bic`: accelerations that the ship file
/// does not give, from local cubics through the channels, regressed on what each effect would add; least BIC. `sparse`:
/// sequentially thresholded least squares of the same accelerations on monomials, each of which stands for an effect.
/// `pooled`: one regression of them on what all effects would add, over all runs, beside the coefficients of the file
/// and a free function of the motion; effects that it tells from 0.
std::vector<RivalAnswer> rivals_on(const Riddle& riddle, std::uint64_t seed);

}  // namespace swayaw::concealed
