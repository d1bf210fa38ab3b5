#include "run_filter_of.hpp"

template class swayaw::identification::detail::RunFilter<9>;
