#include "swayaw/nonlinear/sensors.hpp"

namespace swayaw {
namespace {

/// What the instruments of a stage make of a run, or put right.
void record_stage(Recording& run, std::span<const Effect> effects, InstrumentStage stage, int sign) {
  const auto record_one = [&]<class Kind>(const Kind& e) {
    if constexpr (IsInstrument<Kind>)
      if (Kind::stage == stage) record(e, run, sign);
  };
  for (const auto& effect : effects) std::visit(record_one, effect);
}

}  // namespace

Recording as_recorded(Recording run, std::span<const Effect> effects) {
  for (const auto stage : {InstrumentStage::mounting, InstrumentStage::reading, InstrumentStage::clock})
    record_stage(run, effects, stage, 1);
  return run;
}

Recording as_it_was(Recording run, std::span<const Effect> effects) {
  for (const auto stage : {InstrumentStage::clock, InstrumentStage::reading, InstrumentStage::mounting})
    record_stage(run, effects, stage, -1);
  return run;
}

}  // namespace swayaw
