#include "linearized_model.hpp"

template class swayaw::identification::detail::LinearizedModel<swayaw::MmgShip<double>>;
