#include "linearized_ship.hpp"

template class swayaw::identification::detail::LinearizedShip<swayaw::PuShip<double>>;
