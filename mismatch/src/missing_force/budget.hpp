#pragma once

#include <array>
#include <vector>

#include "../trial/trial.hpp"
#include "swayaw/mismatch/diagnose.hpp"

/// What the force that the given model lacks follows, and how much of it. Not installed.
namespace swayaw::inline mismatch::detail {

/// By what it acts on and what it remembers.
Follows follows(const Effect& effect);

/// The force that the given ship lacks in the runs, split by what it follows.
///
/// A smoother finds the missing force d of the given ship, then of ships that have more and more of what was found:
/// instruments, what is fixed to the earth, what follows the past, what differs from side to side, the form. A share is
///
///     cov(d before − d after, d of the given ship) / var(d of the given ship)
///
/// so that the shares and what nothing explains add up to 1. Standard errors are of ships drawn from the posterior.
///
/// @param noise  of the smoother, one for all ships, so that what shrinks is the force and not the allowance for it
std::vector<ForceBudget> budget_of(const Trial& trial, const Hypothesis& hypothesis, const MapFit& fit);

}  // namespace swayaw::mismatch::detail
