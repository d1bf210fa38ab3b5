#include "linearized_model.hpp"

std::unique_ptr<swayaw::identification::detail::LinearizedShip> swayaw::identification::detail::linearized_ship(
    const Ship& ship, std::span<const WindPiece> wind) {
  return visit_acting(ship, [&]<class Model>(const ActingShip<Model>& calm) -> std::unique_ptr<LinearizedShip> {
    return std::make_unique<LinearizedModel<Model>>(in_wind(calm, wind));
  });
}
