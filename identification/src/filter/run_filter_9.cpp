#include "run_filter_of.hpp"

template std::unique_ptr<swayaw::identification::detail::RunFilter<9>> swayaw::identification::detail::run_filter(
    const Ship&, const Recording&, std::span<const Channel>, const ShipState<double>&, double,
    swayaw::identification::detail::SampleTimes, double, std::shared_ptr<const RunControls>,
    const swayaw::core::Recording*);
