#pragma once

#include <algorithm>
#include <array>

#include "swayaw/core/motion.hpp"
#include "swayaw/nonlinear/effects/acting_effects.hpp"

/// The state that a stepper integrates.
namespace swayaw::inline nonlinear {

/// x, y, psi, u, v, r, and the hidden states of effects where there are some.
template <class S, std::size_t hidden_states>
using StepperState = std::array<S, 6 + hidden_states>;

template <class S, std::size_t N>
ShipState<S> visible(const std::array<S, N>& s) {
  return {s[0], s[1], s[2], {s[3], s[4], s[5]}};
}

template <class S, std::size_t N>
Hidden<S> hidden_of(const std::array<S, N>& s) {
  Hidden<S> hidden{};
  if constexpr (N > 6) std::copy(s.begin() + 6, s.end(), hidden.begin());
  return hidden;
}

/// Both in one; without hidden states where there are none.
template <std::size_t hidden_states, class S>
StepperState<S, hidden_states> joined(const StateVector<S>& motion, const Hidden<S>& hidden) {
  StepperState<S, hidden_states> joined;
  std::ranges::copy(motion, joined.begin());
  if constexpr (hidden_states > 0) std::ranges::copy(hidden, joined.begin() + 6);
  return joined;
}

}  // namespace swayaw::nonlinear
