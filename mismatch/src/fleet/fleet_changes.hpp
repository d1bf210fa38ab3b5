#pragma once

#include <vector>

#include "fleet_model.hpp"

/// The search for what changed on vessels, and when. Not installed.
namespace swayaw::inline mismatch::detail {

/// A shift of a vessel, what it gains in log evidence over the mean of its dates, and when it began.
struct Proposal {
  std::size_t vessel;
  Shift shift;
  double gain;
  DateEstimate since;
  double over_dates;  ///< what the mean of the dates gains more than the likeliest, mostly less
};

/// A shift beside all others, and how probable it is against others in its place and against none.
struct SettledShift {
  Proposal proposal;
  double probability;
};

/// Takes shifts vessel by vessel, that first which gains most.
void add_shifts(const ClassTrial& whole, FleetModel& model, const FleetOptions& options);

/// Each shift once more beside all others: its shape and date may be others now, and it may gain too little.
std::vector<SettledShift> settled(const ClassTrial& whole, FleetModel& model, const FleetOptions& options);

}  // namespace swayaw::mismatch::detail
