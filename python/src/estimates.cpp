#include "module.hpp"
#include "record.hpp"
#include "swayaw/nonlinear/estimates/estimate_spread.hpp"
#include "swayaw/nonlinear/estimates/estimated_ship.hpp"
#include "swayaw/nonlinear/ship.hpp"

namespace swayaw::python {

template <>
struct Words<HullFormula> {
  static std::vector<std::string> list() { return {"yoshimura_masumoto", "kijima"}; }
};

void add_estimates(py::module_& m) {
  py::class_<EstimatedShip>(m, "EstimatedShip", "A ship from main dimensions, and what was assumed about her.")
      .def_readonly("assumptions", &EstimatedShip::assumptions)
      .def_readonly("warnings", &EstimatedShip::warnings,
                    "Ratios of the hull that lie outside the range of the formulas.");
  m.def(
      "estimate_ship",
      [](double length_m, double beam, double draught, double block, double speed, double trim, HullFormula formula,
         std::string name, Maybe rudder_area, Maybe propeller_diameter, Maybe resistance) {
        const HullDimensions<double> hull{.L = length_m, .B = beam, .d = draught, .C_B = block, .trim = trim};
        const EstimateOptions options{.hull = formula,
                                      .rudder_area = rudder_area,
                                      .rudder_height = {},
                                      .propeller_diameter = propeller_diameter,
                                      .wake_fraction = {},
                                      .thrust_deduction = {},
                                      .resistance = resistance};
        const auto estimate = estimated_mmg_ship(hull, speed, options);
        Ship ship{.name = std::move(name),
                  .model = estimate.ship,
                  .confidence = confidence_of(estimate_spread(hull, estimate, options)),
                  .surroundings = {}};
        return std::pair(std::move(ship), estimate);
      },
      py::arg("length"), py::arg("beam"), py::arg("draught"), py::arg("block_coefficient"), py::arg("service_speed"),
      py::kw_only(), py::arg("trim") = 0.0, py::arg("formula") = HullFormula::yoshimura_masumoto,
      py::arg("name") = "estimated ship", py::arg("rudder_area") = py::none(),
      py::arg("propeller_diameter") = py::none(), py::arg("resistance") = py::none(), Unlocked(),
      "A ship of the MMG model from main dimensions [m], block coefficient and service speed [m/s], and what was "
      "assumed. Her confidence is the spread of the formulas and their misses of measured ships. trim: draught aft "
      "less "
      "draught forward [m]; formula \"kijima\" takes trim. resistance: R_0'."
      "\n\nlength: between perpendiculars. beam, draught: amidships. block_coefficient, service_speed: as told. name: "
      "of the ship. rudder_area [m²], propeller_diameter [m]: as estimated unless given. Raises ValueError for "
      "dimensions that are not positive.");
}

}  // namespace swayaw::python
