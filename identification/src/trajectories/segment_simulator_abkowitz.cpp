#include "segment_simulator_of.hpp"

namespace swayaw::inline identification::detail {

template std::unique_ptr<SegmentSimulator> make_segment_simulator<AbkowitzShip, false>(
    const ActingShip<AbkowitzShip<double>>&, const Ship&, const std::vector<Parameter>&);

}  // namespace swayaw::identification::detail
