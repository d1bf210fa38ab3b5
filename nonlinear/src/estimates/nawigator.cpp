#include "swayaw/nonlinear/estimates/nawigator.hpp"

#include <cmath>

#include "swayaw/nonlinear/published_ships.hpp"

namespace swayaw::inline nonlinear {
namespace {

std::string_view text_of(SurgeReading surge) {
  if (surge == SurgeReading::mass_alone) return ", surge by m v r";
  return surge == SurgeReading::negative_X_vr ? ", X_vr negative" : ", surge as printed";
}

}  // namespace

Ship nawigator_xxi(NawigatorHull hull, SurgeReading surge) {
  Ship ship = published_ship(hull == NawigatorHull::n7 ? "nawigator_n7" : "nawigator_ym");
  auto& model = std::get<MmgShip<double>>(ship.model);
  const double size = std::abs(model.hull.X_vr);
  model.hull.X_vr = surge == SurgeReading::negative_X_vr ? -size : size;
  model.added_mass.surge_coupling.index = surge == SurgeReading::mass_alone ? 1 : 0;
  ship.name += text_of(surge);
  return ship;
}

}  // namespace swayaw::nonlinear
