#include "sailor.hpp"

namespace swayaw {

std::unique_ptr<Sailor> sailor_of(const PiShip<double>& model, const Surroundings<double>& around,
                                  const NumberList& numbers) {
  return std::make_unique<ModelSailor<PiShip>>(model, around, numbers);
}

}  // namespace swayaw
