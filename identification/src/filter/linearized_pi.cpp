#include "linearized_ship.hpp"

template class swayaw::LinearizedShip<swayaw::PiShip<double>>;
