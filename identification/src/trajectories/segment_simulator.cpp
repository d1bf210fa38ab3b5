#include "swayaw/identification/segment_simulator.hpp"

namespace swayaw::inline identification {

std::unique_ptr<SegmentSimulator> segment_simulator(const Ship& ship, const std::vector<Parameter>& parameters) {
  return visit_acting(ship, [&]<template <class> class Model>(const ActingShip<Model<double>>& acting) {
    const bool has_effects = !active_effects(ship).empty();
    return has_effects ? detail::make_segment_simulator<Model, true>(acting, ship, parameters)
                       : detail::make_segment_simulator<Model, false>(acting, ship, parameters);
  });
}

}  // namespace swayaw::identification
