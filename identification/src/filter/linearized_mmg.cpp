#include "linearized_ship.hpp"

template class swayaw::LinearizedShip<swayaw::MmgShip<double>>;
