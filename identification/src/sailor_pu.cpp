#include "sailor.hpp"

namespace swayaw {

std::unique_ptr<Sailor> sailor_of(const PuShip<double>& model, const Surroundings<double>& around,
                                  const NumberList& numbers) {
  return std::make_unique<ModelSailor<PuShip>>(model, around, numbers);
}

}  // namespace swayaw
