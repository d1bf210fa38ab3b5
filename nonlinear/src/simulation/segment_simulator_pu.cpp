#include "segment_simulator_of.hpp"

template std::unique_ptr<swayaw::SegmentSimulator> swayaw::segment_simulator(const swayaw::PuShip<double>&,
                                                                             const swayaw::Surroundings<double>&,
                                                                             const std::vector<swayaw::Parameter>&);
