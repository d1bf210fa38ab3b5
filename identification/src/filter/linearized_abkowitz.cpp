#include "linearized_ship.hpp"

template class swayaw::LinearizedShip<swayaw::AbkowitzShip<double>>;
