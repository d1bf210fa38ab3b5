#include "event_stepper.hpp"

namespace swayaw {

template std::unique_ptr<ShipStepper> make_stepper(const ActingShip<MmgShip<double>>&, const Sample&, double);

}  // namespace swayaw
