#include "linearized_model.hpp"

namespace swayaw::inline identification::detail {

template std::unique_ptr<LinearizedShip> linearized_model(const ActingShip<PuShip<double>>&);

}  // namespace swayaw::identification::detail
